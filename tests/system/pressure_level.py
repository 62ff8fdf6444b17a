"""The pressure's constant decides nothing: neither how often Newton's method iterates nor what it finds."""
import numpy as np

from harness import ROOT, SystemTest, difference, main, run

DECK = ROOT / "inputs/verification/pressure_level.xml"


class PressureLevel(SystemTest):
    def test_outside_pressure(self):
        low = run("at_0", DECK, 1, "--set", "outside=0 Pa")
        high = run("at_1e7", DECK)
        for column in "newton_iterations", "step_s":
            np.testing.assert_array_equal(high.history()[column], low.history()[column], column)
        for column in "tow_force_n_per_m", "end_error_m":
            self.assertRecorded(column, f"{column} under 10 MPa against 0", difference(high.history()[column], low.history()[column]),
                                1e-8, "exact: only differences of pressure count")
        step = low.steps()[-1]
        a, b = low.fields(step), high.fields(step)
        b["pressure"] = b["pressure"] - 1e7
        for field in "velocity", "displacement", "pressure":
            self.assertRecorded(field, f"{field} under 10 MPa against 0, p0 taken off", difference(b[field], a[field]), 1e-8,
                                "exact: only differences of pressure count")


if __name__ == "__main__":
    main()
