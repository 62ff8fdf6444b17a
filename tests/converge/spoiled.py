"""A scheme with a factor that is slightly wrong does not reach its order: each family of studies notices.

The factor is put in through the deck while exact solution and force stay: to the equations it is the same as a wrong
factor in the source.
"""
import json
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "system"))
import harness
from harness import fresh, hawser

DECKS = harness.ROOT / "inputs/verification"
SPOILED = {  # deck: what is wrong, levels, quantity that tells, and the order it can have at most
    "taylor_green": (["modules/ale-fluid/viscosity=0.055"], 3, "v_error_l2", 1.0),
    "mesh_space": (["modules/mesh-motion/poisson-ratio=0.33"], 4, "d_error_l2", 1.5),
    "cable_space": (["modules/cable/axial-stiffness=10.5"], 3, "d_error_l2", 1.5),
    "fluid_time_trapezoidal": (["time/gamma=0.55", "time/beta=0.28"], 4, "v_error_l2", 1.5),
    "cable_time_trapezoidal": (["time/gamma=0.55", "time/beta=0.28"], 4, "d_error_l2", 1.5),
    "coupled_time_trapezoidal": (["modules/ale-fluid/density=1.05"], 3, "p_error_l2", 1.0),
}


class Spoiled(unittest.TestCase):
    def test_every_family_notices(self):
        for deck, (changes, levels, quantity, most) in SPOILED.items():
            with self.subTest(deck=deck):
                folder = fresh(deck)
                sets = [word for change in changes for word in ("--set", change)]
                done = hawser(1, "converge", DECKS / f"{deck}.xml", "-o", folder, "--levels", levels, *sets,
                              seconds=600)
                self.assertEqual(done.returncode, 8, done.stdout + done.stderr)
                found = json.loads((folder / "converge.json").read_text())["quantities"][quantity]
                print(f"{deck} with {', '.join(changes)}: {quantity} has order {found['finest_pair']:.2f}")
                self.assertFalse(found["holds"])
                self.assertLess(found["finest_pair"], most)


if __name__ == "__main__":
    harness.main()
