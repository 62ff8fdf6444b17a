"""Formulas and extrapolation of the report on the deep-tow study, against values worked out elsewhere."""
import sys
import unittest
from pathlib import Path
from typing import NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "apps/figures"))
import deep_tow as dt  # noqa: E402


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


if __name__ == "__main__":
    unittest.main()
