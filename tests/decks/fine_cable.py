"""A cable that is towed off at once, with finer and finer segments and steps: refinement must not make an answer worse.

With generalised-alpha and a sharp slack law, half the length of segments and steps once pulled with 4875 N where 282 N, the
friction on the whole length, is all there is.

python3 tests/decks/fine_cable.py BUILD_FOLDER [quick | long]
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

END_ERRORS = {50: 11.7, 100: 24.1, 200: 48.8, 400: 91.7, 800: 133.0, 1600: 150.4}  # m at s
FRICTION = 0.5 * 1025 * 0.015 * 3.141592653589793 * 0.06 * (0.5**2 + 0.2**2 + 2 * 0.5 * 0.2 * 3**0.5 / 2) * 420
CASES = {"quick": ((42, 1),), "long": ((84, 1), (84, 0.5), (168, 1), (168, 0.25), (336, 1), (336, 0.125))}


def history(segments, step):
    """Rows of history.csv, as numbers."""
    folder = BUILD / f"tests/run/fine_cable/{segments}_{step}"
    done = subprocess.run([str(BUILD / "bin/hawser"), "run", str(SOURCE / "tests/decks/fine_cable.xml"), "-o", str(folder),
                           "--force", "--quiet", "--set", f"segments={segments}", "--set", f"step={step}"],
                          stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(done.stdout + done.stderr)
    with open(folder / "history.csv") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


class FineCable(unittest.TestCase):
    def judge(self, segments, step):
        rows = history(segments, step)
        name, what = f"deck.fine_cable.{segments}_{step}", f"impulsive tow, {segments} segments, steps of {step} s"
        common = {"section": "Structures", "command": "ctest --test-dir build -R '^deck.deep_tow.fine_cable'"}
        worst = max((next(row["end_error_m"] for row in rows if abs(row["t_s"] - t) < 1e-6) - end_error
                     for t, end_error in END_ERRORS.items()), key=abs)
        good = record(BUILD, f"{name}.end_error", what=f"{what}: end error against the reference at six times, worst difference",
                      unit="m", value=worst, reference=0, tolerance=0.3, source="42 segments without slack, 0.3 m", **common)
        # Before, the impulse itself pulls: a force that grows as the step shrinks.
        largest = max(row["tow_force_n"] for row in rows if row["t_s"] >= 50)
        good &= record(BUILD, f"{name}.force", what=f"{what}: largest tow force from 50 s on", unit="N", value=largest,
                       reference=FRICTION, tolerance=0.02 * FRICTION, source="friction on the whole length, 2 %", **common)
        self.assertTrue(good, f"{what}: {worst} m, {largest} N")

    def test_refinement_makes_no_answer_worse(self):
        for segments, step in CASES[PART]:
            with self.subTest(segments=segments, step=step):
                self.judge(segments, step)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
