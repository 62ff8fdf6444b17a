"""The twelve cases of the deep-tow study with drag coefficients, in the plane and in space.

Each run judges itself by the deck's <expect>: the tow force within 0.5 % of rho Ct pi D W^2 L/2, the end error within
0.2 m of the straight, stretched cable's. Here the forces are compared with the published figures too, and a run with
EA = 1e9 N keeps its steps of 20 s.

python3 tests/decks/drag_law.py BUILD_FOLDER
"""
import json
import subprocess
import sys
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
BUILD = Path(sys.argv[1]).resolve()
sys.path.insert(0, str(SOURCE / "tests/support"))
from figures import record  # noqa: E402

DECKS = SOURCE / "inputs/deep_tow"
CASES = [(current, angle) for current in (0.5, 1, 2) for angle in (0, 30, 60, 90)]
FORCES = [199, 188, 158, 118, 584, 563, 503, 422, 1964, 1920, 1801, 1639]  # N


def run(deck, **parameters):
    folder = BUILD / "tests/run/drag_law" / deck
    command = [BUILD / "bin/hawser", "run", DECKS / f"{deck}.xml", "-o", folder, "--force", "--quiet"]
    for name, value in parameters.items():
        command += ["--set", f"{name}={value}"]
    done = subprocess.run(list(map(str, command)), stdin=subprocess.DEVNULL, capture_output=True, text=True)
    return done, json.loads((folder / "summary.json").read_text())


def remember(deck, case, what, **figure):
    where = "in space" if deck.endswith("space") else "in the plane"
    return record(BUILD, f"deck.deep_tow.{deck}.case_{case:02}.{what.split()[-1]}", "Deep tow by drag coefficients",
                  f"case {case} {where}, {what}",
                  command="ctest --test-dir build -R '^deck.deep_tow.drag_law'", **figure)


class DragLaw(unittest.TestCase):
    def judge(self, deck):
        for case, ((current, angle), force) in enumerate(zip(CASES, FORCES), start=1):
            with self.subTest(deck=deck, case=case):
                done, summary = run(deck, current=current, tow_angle=f"{angle} deg")
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertTrue(remember(deck, case, "tow force", unit="N", value=summary["tow_force_n"],
                                         reference=force, tolerance=0.005 * force,
                                         source="rho Ct pi D W^2 L/2, 0.5 %"))
                self.assertTrue(remember(deck, case, "end error", unit="m", value=summary["end_error_m"],
                                         reference=summary["end_error_exact_m"], tolerance=0.2,
                                         source="L sin(theta - phi) with the stretched length"))

    def test_in_the_plane(self):
        self.judge("drag_law")

    def test_in_space(self):
        self.judge("drag_law_space")

    def test_axial_stiffness_does_not_limit_the_step(self):
        done, summary = run("drag_law", stiffness="1e9 N")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual((summary["steps"], summary["steps_rejected"]), (270, 0))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
