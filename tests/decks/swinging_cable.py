"""A cable that is let go at one end: its energy without damping, and its motion and forces with it.

The midpoint rule must keep the total energy (kinetic, strain and that of the weight) for steps of any length; the reference of
the motion is an independent lumped-mass code (inputs/structures/swinging_cable.xml).

python3 tests/decks/swinging_cable.py BUILD_FOLDER [quick | long]
"""
import csv
import subprocess
import sys
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
BUILD = Path(sys.argv[1]).resolve()
PART = sys.argv[2] if len(sys.argv) > 2 else "quick"
sys.path.insert(0, str(SOURCE / "tests/support"))
from figures import record  # noqa: E402


def run(name, **parameters):
    """Columns of history.csv by name."""
    folder = BUILD / "tests/run/swinging_cable" / name
    command = [BUILD / "bin/hawser", "run", SOURCE / "inputs/structures/swinging_cable.xml", "-o", folder, "--force",
               "--quiet"]
    for key, value in parameters.items():
        command += ["--set", f"{key}={value}"]
    done = subprocess.run(list(map(str, command)), stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(done.stdout + done.stderr)
    with open(folder / "history.csv") as file:
        rows = list(csv.DictReader(file))
    return {key: [float(row[key]) for row in rows] for key in rows[0]}


def total_energy(history):
    return [kinetic + strain - weight for kinetic, strain, weight in
            zip(history["kinetic_energy_j"], history["axial_strain_energy_j"], history["work_of_weight_j"])]


def at(history, column, time):
    """Nearest row."""
    times = history["t_s"]
    return history[column][min(range(len(times)), key=lambda i: abs(times[i] - time))]


def peak(history, begin, end):
    """Largest force on the support in a window: value and time."""
    pairs = list(zip(history["support_force_n"], history["t_balance_s"]))
    return max(pair for pair in pairs if begin <= pair[1] <= end)


class SwingingCable(unittest.TestCase):
    def note(self, key, what, **figure):
        ok = record(BUILD, f"deck.structures.swinging_cable.{key}", "Structures", f"swinging cable, {what}",
                    command="ctest --test-dir build -R '^deck.structures.swinging_cable'", **figure)
        self.assertTrue(ok, f"{what}: {figure}")

    def keeps(self, step, end):
        history = run(f"keeps_{step}", step=step, run_time=end)
        energy = total_energy(history)
        scale = max(history["kinetic_energy_j"])
        worst = max(abs(value - energy[0]) for value in energy) / scale
        self.note(f"keeps.{step}", f"total energy without damping to {end} s with steps of {step} s, largest change "
                  "relative to the largest kinetic energy", unit="1", value=worst, reference=0, tolerance=1e-6,
                  source="nothing takes from it or adds to it")

    def loses(self, step, end):
        history = run(f"loses_{step}", step=step, run_time=end, **{"time/theta": 0.55})
        energy = total_energy(history)
        rise = max(energy) - energy[0]
        self.note(f"loses.{step}", f"total energy with theta = 0.55 to {end} s with steps of {step} s, largest rise "
                  "above the start relative to the largest kinetic energy", unit="1",
                  value=max(0, rise / max(history["kinetic_energy_j"])), reference=0, tolerance=1e-9,
                  source="the scheme dissipates")

    @unittest.skipUnless(PART == "quick", "long")
    def test_energy(self):
        self.keeps(0.01, 5)
        self.keeps(0.002, 2)
        self.loses(0.01, 5)

    def moves(self, suffix="", **parameters):
        """Judges tip and peaks with internal damping."""
        history = run(f"motion{suffix}", internal_damping="20 N s", run_time=1.2, **parameters)
        how = "".join(f", {key} {value}" for key, value in parameters.items())
        for axis, reference in (("x", 1.533 - 2.022), ("y", -1.004)):
            self.note(f"tip_{axis}{suffix}", f"tip after 0.4 s, displacement along {axis}{how}", unit="m",
                      value=at(history, f"tip_displacement_{axis}_m", 0.4), reference=reference, tolerance=0.01,
                      source="an independent lumped-mass code, 1 cm")
        for key, begin, end, force, instant in (("first", 0.5, 0.7, 33.5, 0.584), ("second", 0.8, 1.0, 27.1, 0.908)):
            value, time = peak(history, begin, end)
            self.note(f"{key}_peak{suffix}", f"{key} peak of the force on the support{how}", unit="N", value=value,
                      reference=force, tolerance=0.03 * force, source="an independent lumped-mass code, 3 %")
            self.note(f"{key}_peak_time{suffix}", f"{key} peak of the force on the support, instant{how}", unit="s", value=time,
                      reference=instant, tolerance=0.005, source="an independent lumped-mass code, 5 ms")

    @unittest.skipUnless(PART == "quick", "long")
    def test_motion(self):
        self.moves()

    @unittest.skipUnless(PART == "long", "quick")
    def test_energy_long(self):
        for step in (0.01, 0.002, 0.0005):
            self.keeps(step, 20)
        self.loses(0.002, 20)

    @unittest.skipUnless(PART == "long", "quick")
    def test_segments(self):
        for segments in (20, 80, 160):
            with self.subTest(segments=segments):
                self.moves(f".segments_{segments}", segments=segments)

    @unittest.skipUnless(PART == "long", "quick")
    def test_short_steps(self):
        self.moves(".step_0.0005", step=0.0005)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
