"""Turek and Hron's flag that swings under its weight (CSM3): mean, amplitude and frequency of its end.

python3 tests/system/turek_hron.py --build BUILD_FOLDER
"""
import numpy as np

from harness import BUILD, ROOT, Results, SystemTest, completed, figures, fresh, main

COMMAND = "ctest --test-dir build -R '^system.turek_hron$'"
SOURCE = "S. Turek, J. Hron, Lect. Notes Comput. Sci. Eng. 53 (2006) 371-385"


def last_period(time, values):
    """Mean and amplitude, (max +- min)/2, over the last period, and the frequency over all of them."""
    middle = (values.max() + values.min()) / 2
    up = np.flatnonzero((values[:-1] < middle) & (values[1:] >= middle))
    crossings = time[up] + (middle - values[up]) / (values[up + 1] - values[up]) * (time[up + 1] - time[up])
    frequency = (len(crossings) - 1) / (crossings[-1] - crossings[0])
    last = values[time > time[-1] - 1 / frequency]
    return (last.max() + last.min()) / 2, (last.max() - last.min()) / 2, frequency


class Flag(SystemTest):
    def test_swings_as_published(self):
        folder = fresh("csm3")
        completed(1, "run", ROOT / "inputs/turek_hron/csm3.xml", "-o", folder, "-q", seconds=1000)
        history = Results(folder).history()
        for name, column, mean, amplitude in (("x", "tip_displacement_x_m", -14.305e-3, 14.305e-3),
                                              ("y", "tip_displacement_y_m", -63.607e-3, 65.160e-3)):
            got = last_period(np.array(history["t_s"]), np.array(history[column]))
            for what, value, reference, tolerance, unit in (("mean", got[0], mean, 0.02 * abs(mean), "m"),
                                                            ("amplitude", got[1], amplitude, 0.02 * amplitude, "m"),
                                                            ("frequency", got[2], 1.0995, 0.01 * 1.0995, "Hz")):
                with self.subTest(component=name, what=what):
                    self.assertTrue(figures.record(BUILD, f"system.turek_hron.csm3.{name}.{what}", "Structures",
                                                   f"CSM3, displacement {name} of A: {what}", value, reference, tolerance, SOURCE,
                                                   COMMAND, unit), value)


if __name__ == "__main__":
    main()
