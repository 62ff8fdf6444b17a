"""The elastic leaflet in a channel: evenly refined cells come to the reference, and its mass changes nothing in Newton's work.

python3 tests/system/leaflet.py --build BUILD_FOLDER
"""
import math

from harness import BUILD, ROOT, Results, SystemTest, completed, figures, fresh, main

COMMAND = "ctest --test-dir build -R '^system.leaflet$'"
SOURCE = "a monolithic code with a Kirchhoff-Love beam, good to .2 %"
DECK = ROOT / "inputs/thin_structures/leaflet.xml"
REFERENCE = (0.374828, -0.209453)  # m, at t = 1 s


def first_second(name, size, tip, mass=0.05):
    """The tip's displacement after the first second, m, and the Newton iterations of all steps."""
    folder = fresh(name)
    completed(1, "run", DECK, "-o", folder, "-q", "--end", "1", "--set", f"parameter[size]/value={size}", "--set",
              f"parameter[tip]/value={tip}", "--set", f"parameter[mass]/value={mass}", seconds=1000)
    history = Results(folder).history()
    return ((history["tip_displacement_x_m"][-1], history["tip_displacement_y_m"][-1]), sum(history["newton_iterations"]))


class Leaflet(SystemTest):
    def test_even_cells_come_to_the_reference(self):
        size = math.hypot(*REFERENCE)
        errors = [math.dist(first_second(f"leaflet_{cells}", cells, cells)[0], REFERENCE) / size for cells in (0.05, 0.025, 0.0125)]
        self.assertGreater(errors[0], errors[1])
        self.assertGreater(errors[1], errors[2])
        self.assertTrue(figures.record(BUILD, "system.leaflet.even", "Structures", "Leaflet on even cells of 12.5 mm, t = 1: tip off by",
                                       errors[2], 0, 0.003, SOURCE, COMMAND), errors)

    def test_any_mass_takes_the_same_work(self):
        counts = [first_second(f"leaflet_mass_{mass}", 0.025, 0.005, mass)[1] for mass in (0.5, 0.05, 0.005, 0)]
        for count in counts:
            self.assertLessEqual(abs(count - counts[1]), 0.1 * counts[1], counts)


if __name__ == "__main__":
    main()
