"""Systems of lines against independent solutions: straight tow, steady circle, a catenary, a turn refined.

python3 tests/survey/survey.py BUILD_FOLDER quick|long
"""
import csv
import json
import subprocess
import sys
import unittest
from math import hypot, sqrt
from pathlib import Path

import numpy as np
from scipy.optimize import brentq

SOURCE = Path(__file__).resolve().parents[2]
BUILD = Path(sys.argv[1]).resolve()
sys.path.insert(0, str(SOURCE / "tests/support"))
import tow_reference  # noqa: E402
from figures import record  # noqa: E402

GROUP = "Systems of lines"


def run(deck, name, *options, ranks=1, **parameters):
    """Exit code, summary and history (columns by name) of a deck of inputs/survey."""
    folder = BUILD / "tests/run/survey" / name
    command = ["mpirun", "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
    command += [BUILD / "bin/hawser", "run", SOURCE / f"inputs/survey/{deck}.xml", "-o", folder, "--force", "--quiet"]
    for parameter, value in parameters.items():
        command += ["--set", f"{parameter}={value}"]
    done = subprocess.run(list(map(str, command)) + list(options), stdin=subprocess.DEVNULL, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    rows = list(csv.reader((folder / "history.csv").read_text().splitlines()))
    history = dict(zip(rows[0], np.array(rows[1:], float).T))
    return json.loads((folder / "summary.json").read_text()), history


def remember(name, quantity, part="quick", **figure):
    return record(BUILD, f"survey.{name}", GROUP, quantity, command=f"ctest --test-dir build -R survey.{part}", **figure)


def catenary(half_span, half_length, weight, stiffness):
    """Tension at the support of an elastic cable between two points at one height, exact: N = EA (lambda^2 - 1)/2 is the
    second Piola tension, of which the true one is lambda N."""
    def stretch(tension):  # lambda of lambda (lambda^2 - 1)/2 = T/EA
        return brentq(lambda x: x * (x * x - 1) / 2 - tension / stiffness, 1, 2, xtol=1e-16)

    nodes, weights = np.polynomial.legendre.leggauss(60)
    s = half_length * (nodes + 1) / 2

    def span(pull):
        tension = np.hypot(pull, weight * s)
        return half_length / 2 * weights @ [stretch(t) * pull / t for t in tension] - half_span

    pull = brentq(span, weight, 1e3 * weight * half_length, xtol=1e-12)
    return hypot(pull, weight * half_length)


class Quick(unittest.TestCase):
    def test_straight_tow_from_ship_to_tail(self):
        exact = tow_reference.deep_tow()
        summary, _ = run("deep_tow", "deep_tow")
        found = {axis: summary[f"towfish_displacement_{axis}_m"] for axis in "xz"}
        found["x"] -= 2500 + 2 * tow_reference.KNOT * 200
        for axis, place in (("x", exact["towfish"][0]), ("z", exact["towfish"][2])):
            self.assertTrue(remember(f"deep_tow.{axis}", f"deep tow, towfish {axis} from the ship", unit="m",
                                     value=found[axis], reference=place, tolerance=1,
                                     source="boundary value problem, scipy"))
        self.assertTrue(remember("deep_tow.force", "deep tow, tension at the ship", unit="N",
                                 value=summary["ship_force_n"], reference=exact["force"], tolerance=1e-3 * exact["force"],
                                 source="boundary value problem, scipy, 0.1 %"))

    def test_alike_on_any_number_of_ranks(self):
        alone, _ = run("deep_tow", "ranks_1")
        for ranks in (2, 4):
            shared, _ = run("deep_tow", f"ranks_{ranks}", ranks=ranks)
            for quantity in ("towfish_displacement_x_m", "tail_displacement_z_m", "ship_force_n"):
                self.assertAlmostEqual(shared[quantity] / alone[quantity], 1, delta=1e-8)

    def test_elastic_catenary_converges_with_the_square_of_the_segments(self):
        exact = catenary(40, 50, 50, 1e6)
        errors = []
        for segments in (200, 400, 800):
            summary, _ = run("catenary", f"catenary_{segments}", segments=segments)
            errors.append(abs(summary["support_force_n"] / exact - 1))
        self.assertTrue(remember("catenary", "elastic catenary, tension, 800 segments, relative error", unit="1",
                                 value=errors[-1], reference=0, tolerance=1e-6, source="exact"))
        for coarse, fine in zip(errors, errors[1:]):
            self.assertAlmostEqual(coarse / fine, 4, delta=0.3)

    def test_catenary_that_touches_down(self):
        length, span, height, weight = 300, 260, 100, 100
        a = brentq(lambda a: length - span - np.sqrt(height**2 + 2 * a * height) + a * np.arccosh(height / a + 1), 1, 1e5)
        summary, _ = run("touch_down", "touch_down")
        self.assertTrue(remember("touch_down", "catenary that touches down, pull, 300 segments", unit="N",
                                 value=summary["anchor_force_along_n"], reference=weight * a, tolerance=2e-4 * weight * a,
                                 source="closed form, without stretch, 0.02 %"))

    def test_circle(self):
        exact = tow_reference.circle()
        summary, history = run("circle", "circle")
        x = np.array([history[f"towfish_displacement_{axis}_m"] for axis in "xy"]) + [[-1000], [-600]]
        radius = np.hypot(*x)[-1]
        self.assertLess(np.ptp(np.hypot(*x)[-30:]), 0.1)  # settled
        for quantity, value, reference in (("radius", radius, exact["radius"]),
                                           ("height", summary["towfish_displacement_z_m"], exact["height"]),
                                           ("tension", summary["ship_force_n"], exact["force"])):
            self.assertTrue(remember(f"circle.{quantity}", f"towed in a circle, {quantity}",
                                     unit="N" if quantity == "tension" else "m", value=value, reference=reference,
                                     tolerance=0.005 * abs(reference), source="boundary value problem, scipy, 0.5 %"))

    def test_depressor(self):
        summary, _ = run("depressor", "depressor")
        pressure = 0.5 * 1025 * 9
        self.assertTrue(remember("depressor", "depressor, tension", unit="N", value=summary["ship_force_n"],
                                 reference=sqrt((0.3 * pressure)**2 + (500 + 0.4 * pressure)**2), tolerance=1e-3,
                                 source="closed form"))


class Long(unittest.TestCase):
    def test_turn_converges_in_segments_and_step(self):
        _, history = run("deep_tow_turn", "turn")
        for name, options in (("segments x 2", {"cable_segments": 300, "streamer_segments": 100}),
                              ("step / 2", {"step": "5 s"})):
            _, finer = run("deep_tow_turn", "turn_" + name.split()[0], **options)
            for node in ("towfish", "tail"):
                apart = [np.interp(history["t_s"], finer["t_s"], finer[f"{node}_displacement_{axis}_m"])
                         - history[f"{node}_displacement_{axis}_m"] for axis in "xyz"]
                worst = np.sqrt((np.array(apart)**2).sum(axis=0)).max()
                self.assertTrue(remember(f"turn.{node}.{name.split()[0]}", f"turn by 90 degrees, {node}, {name}: apart",
                                         "long", unit="m", value=worst, reference=0, tolerance=1, source="convergence"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], defaultTest=sys.argv[2].capitalize(), verbosity=2)
