"""Formulas and extrapolation of the report on the deep-tow study, against values worked out elsewhere."""
import sys
import unittest
from pathlib import Path
from typing import NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "apps/figures"))
import deep_tow as dt  # noqa: E402
import deep_tow_forces  # noqa: E402
import study_report  # noqa: E402
from study_results import Case as Run  # noqa: E402


class Sweep(NamedTuple):
    cases: list
    finished: list


class Case(NamedTuple):
    current: str
    tow_angle: str

    def value(self, path):
        return float(getattr(self, path))


class Formulas(unittest.TestCase):
    def test_a_straight_cable_lies_along_the_relative_flow(self):
        self.assertAlmostEqual(dt.straight_end_error(0.5, 30), 154.28, delta=0.005)
        self.assertAlmostEqual(dt.straight_end_error(2, 90), 417.92, delta=0.005)
        self.assertAlmostEqual(dt.straight_end_error(1, 0), 0, delta=1e-9)

    def test_the_papers_one_number_means_a_tow_speed(self):
        self.assertAlmostEqual(dt.tow_speed_for(154.7, 0.5, 30), 0.198, delta=0.0005)

    def test_plate_friction(self):
        for reynolds, coefficient in (980, 0.0977), (294, 0.192), (5880, 0.0373):
            self.assertAlmostEqual(dt.plate_coefficient(reynolds), coefficient, delta=0.0005)

    def test_drag_law_in_newtons(self):
        tensions = [round(dt.drag_law_tension(dt.relative_speed(u, a))) for u in (0.5, 1, 2) for a in (0, 30, 60, 90)]
        self.assertEqual(tensions, [199, 188, 158, 118, 584, 563, 503, 422, 1964, 1920, 1801, 1639])


class Claims(unittest.TestCase):
    def test_they_need_every_case(self):
        cases = [Case("0.5", "0"), Case("0.5", "90"), Case("2", "0"), Case("2", "90")]
        self.assertTrue(dt.Tows(Sweep(cases, cases)).complete)
        self.assertFalse(dt.Tows(Sweep(cases, cases[:3])).complete)
        self.assertFalse(dt.Tows(Sweep(cases, cases[:2])).complete)  # one current, whole in itself


class Limits(unittest.TestCase):
    @staticmethod
    def of_order(order):
        return dt.grid_limit([1, 0.5, 0.25], [10 + 3 * h ** order for h in (1, 0.5, 0.25)])

    def test_values_of_one_order_give_it_and_their_limit(self):
        for order in 0.3, 0.7, 1.0, 1.5, 2.0, 4.0:
            self.assertAlmostEqual(self.of_order(order).order, order, delta=1e-9)
            self.assertAlmostEqual(self.of_order(order).value, 10, delta=1e-9)

    def test_the_uncertainty_of_a_sensible_order_is_richardsons_with_a_quarter_more(self):
        for order in 1.0, 1.5, 2.0:
            self.assertAlmostEqual(self.of_order(order).uncertainty, 1.25 * 3 * 0.25 ** order, delta=1e-9)

    def test_an_order_too_good_to_be_true_is_charged_the_range_of_the_values(self):
        self.assertAlmostEqual(self.of_order(4).uncertainty, 1.25 * 3 * (1 - 0.25 ** 4), delta=1e-9)

    def test_a_low_order_is_charged_no_more_than_the_range_of_the_values(self):
        self.assertAlmostEqual(self.of_order(0.3).uncertainty, 1.25 * 3 * (1 - 0.25 ** 0.3), delta=1e-9)

    def test_values_that_do_not_converge_in_order_keep_the_finest_and_three_times_their_range(self):
        for values in [10, 11, 10.5], [10, 11, 13], [10, 11, 12], [10, 10, 11]:
            limit = dt.grid_limit([1, 0.5, 0.25], values)
            self.assertIsNone(limit.order)
            self.assertEqual(limit.value, values[-1])
            self.assertEqual(limit.uncertainty, 3 * (max(values) - min(values)))


def run(force, **values):
    return Run("", "", "", Path(), values, "finished", 0, "", 0, 0, {"tow_force_n_per_m": force})


class Refined(NamedTuple):
    varied: list
    finished: list


class StepAndBox(unittest.TestCase):
    TOW = {"current": "0.5 m/s", "tow_angle": "30 deg"}

    def test_each_is_compared_with_the_same_tow_on_the_same_mesh(self):
        fine = run(90, mesh_scale="0.5", **self.TOW)
        coarser = Sweep([], [run(100, mesh_scale="1", **self.TOW), run(95, mesh_scale="0.7071", **self.TOW)])
        changed = {"step": Sweep([], [run(7, current="1 m/s", tow_angle="30 deg"), run(102, **self.TOW)]),
                   "box": Sweep([], [])}
        found = deep_tow_forces.effects(fine, coarser, changed)
        self.assertAlmostEqual(found["step"], 0.02)
        self.assertIsNone(found["box"])
        limit = deep_tow_forces.with_effects(dt.GridLimit(None, 90, 3), found)
        self.assertAlmostEqual(limit.uncertainty, 3 + 2.5 * 0.02 * 90)

    def test_the_three_finest_runs_of_a_refined_value_have_a_limit(self):
        runs = [run(10 + 0.1 * step, step=f"{step} s") for step in (40, 2.5, 20, 5, 10)]
        self.assertIn("<td>1.00</td><td>10 ± 0</td>", study_report.limits(Refined(["step"], runs)))

    def test_other_values_have_none(self):
        runs = [run(1, **{"viscosity": f"{v} Pa s", "step": s}) for v, s in ((100, "4 s"), (200, "2 s"), (400, "h/2"))]
        self.assertEqual(study_report.limits(Refined(["viscosity"], runs)), "")
        self.assertEqual(study_report.limits(Refined(["step"], runs)), "")
        self.assertEqual(study_report.limits(Refined(["step", "viscosity"], runs)), "")


if __name__ == "__main__":
    unittest.main()
