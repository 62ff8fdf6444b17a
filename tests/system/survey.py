"""What a survey planner asks for: receivers, currents from a table, way-points, a frame that follows the tug."""

import numpy as np

from harness import SystemTest, completed, difference, edited, fresh, main, run

SAILS = dict(time_end="400")
RECEIVERS = '<receivers spacing="42" times="0 50 400" every="10"/>'


def deck(name, receivers=RECEIVERS, replace=(), **changes):
    """tow.xml with receivers, and further texts replaced."""
    path = edited(name, **{**SAILS, **changes})
    text = path.read_text().replace('current="0.5"/>', f'current="0.5">{receivers}</tow>')
    for old, new in replace:
        assert old in text, old
        text = text.replace(old, new)
    path.write_text(text)
    return path


TRACK = """</modules>
  <track name="line" speed="0.2" start="20" ramp="60">
    <way-point at="0 0"/> <way-point at="50 86.60254037844386"/>
  </track>"""
ON_TRACK = [("</modules>", TRACK),
            ("""value="0.2*sin(30*pi/180)*ramp_distance(t, 20, 60); 0.2*cos(30*pi/180)*ramp_distance(t, 20, 60)"/>""",
             'track="line"/>'),
            ('angle="30" speed="0.2"', 'track="line"')]
MOVING = ON_TRACK + [('<prescribe field="displacement" on="inflow outflow sides" value="0 0"/>',
                      '<prescribe field="displacement" on="inflow outflow sides" track="line"/>'),
                     ('<prescribe field="velocity" on="sides" component="x" value="0"/>',
                      '<prescribe field="velocity" on="sides" value="0 -0.5"/>')]


class Survey(SystemTest):
    @classmethod
    def setUpClass(cls):
        cls.plain = run("plain", deck("plain"))

    def assertSameTow(self, other, tolerance):
        ours, theirs = self.plain.history(), other.history()
        np.testing.assert_array_equal(theirs["t_s"], ours["t_s"])
        for column in "end_error_m", "total_error_arc_m", "tow_force_n_per_m":
            self.assertLess(difference(theirs[column], ours[column]), tolerance, column)

    def test_receivers_are_where_the_cable_is(self):
        table, cable = self.plain.table("receivers.csv"), self.plain.table("cable.csv")
        self.assertEqual(sorted(set(table["t_s"])), [0, 50, 200, 400])
        at_end = {name: column[table["t_s"] == 400] for name, column in table.items()}
        nodes = {name: column[cable["t_s"] == 400] for name, column in cable.items()}
        np.testing.assert_allclose(at_end["arc_length_m"], np.arange(0, 421, 42))
        for name in "x_m", "y_m":  # one receiver on each node
            np.testing.assert_allclose(at_end[name], nodes[name], rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose(np.abs(at_end["offset_m"]), nodes["positioning_error_m"], rtol=1e-9, atol=1e-9)
        # The current pushes the cable to starboard of a tow that bears 30 degrees to starboard off it.
        self.assertTrue((at_end["offset_m"][1:] > 0).all())
        reach = np.hypot(at_end["x_m"] - at_end["x_m"][0], at_end["y_m"] - at_end["y_m"][0])
        np.testing.assert_allclose(reach[1:] * np.sin(np.radians(at_end["feather_angle_deg"][1:])),
                                   at_end["offset_m"][1:], rtol=1e-9)

    def test_receivers_between_steps_are_interpolated_and_do_not_change_the_run(self):
        rare = run("rare", deck("rare", '<receivers spacing="42" times="40 60"/>'))
        table, often = rare.table("receivers.csv"), self.plain.table("receivers.csv")
        mean = 0.5 * (table["x_m"][table["t_s"] == 40] + table["x_m"][table["t_s"] == 60])
        np.testing.assert_allclose(often["x_m"][often["t_s"] == 50], mean, atol=1e-9)
        self.assertEqual((rare.folder / "history.csv").read_text(), (self.plain.folder / "history.csv").read_text())

    def test_receivers_after_a_restart(self):
        path = deck("restarted", output_checkpoint_every="2")
        folder = fresh("restarted.parts")
        whole = run("restarted.whole", path)
        completed(1, "run", path, "-o", folder, "-q", "--end", "40")
        completed(1, "restart", folder / "checkpoint.h5", "-q", "--end", "400")
        self.assertEqual((folder / "receivers.csv").read_text(), (whole.folder / "receivers.csv").read_text())

    def test_a_straight_track_is_the_formula(self):
        other = run("track", deck("track", replace=ON_TRACK))
        self.assertSameTow(other, 1e-6)
        self.assertAlmostEqual(other.summary()["end_error_exact_m"], self.plain.summary()["end_error_exact_m"], delta=1e-6)

    def test_a_table_of_the_constant_current_is_the_number(self):
        rows = [f"{t},{x},0,-0.5\n" for t in (0, 400) for x in (-1e4, 1e4)]
        path = deck("table", replace=[('value="0 -0.5"', 'table="current.csv"')])
        (path.parent / "current.csv").write_text("t_s,x_m,velocity_x_m_per_s,velocity_y_m_per_s\n" + "".join(rows))
        for ranks in 1, 2:
            self.assertSameTow(run(f"table.np{ranks}", path, ranks), 1e-5)

    def test_a_current_that_varies_reaches_the_water(self):
        path = deck("tide", replace=[('<prescribe field="velocity" on="inflow" value="0 -0.5"/>',
                                      '<prescribe field="velocity" on="inflow" table="tide.csv"/>')])
        (path.parent / "tide.csv").write_text("t_s,u_m_per_s,v_m_per_s\n0,0,-0.5\n200,0.1,-0.6\n400,0.2,-0.7\n")
        fields = run("tide", path).fields(20)
        top = np.isclose(fields["points"][:, 1], 900)
        np.testing.assert_allclose(fields["velocity"][top, 1], -0.7, atol=1e-12)
        inside = top & (np.abs(fields["points"][:, 0]) < 1199)
        np.testing.assert_allclose(fields["velocity"][inside, 0], 0.2, atol=1e-12)

    def test_a_moving_frame_is_the_fixed_one(self):
        other = run("moving", deck("moving", replace=MOVING))
        # The walls of a small box are felt, and they now stand still relative to the cable.
        self.assertSameTow(other, 5e-3)
        start, end = other.fields(2), other.fields(20)
        shift = end["points"] - start["points"]
        np.testing.assert_allclose(shift[np.isclose(start["points"][:, 1], start["points"][:, 1].max())].std(axis=0), 0,
                                   atol=1e-9)
        self.assertGreater(np.linalg.norm(shift[0]), 50)
        self.assertAlmostEqual(other.summary()["mesh_quality_min"], self.plain.summary()["mesh_quality_min"], delta=0.1)

    def test_what_a_table_may_not_be(self):
        path = deck("short", replace=[('<prescribe field="velocity" on="inflow" value="0 -0.5"/>',
                                       '<prescribe field="velocity" on="inflow" table="short.csv"/>')])
        table = path.parent / "short.csv"
        table.write_text("t_s,u_m_per_s,v_m_per_s\n0,0,-0.5\n100,0,-0.5\n")
        self.assertFails(3, r".*short\.xml:\d+:\d+: the table reaches from t = 0 s to t = 100 s, and the run needs it from "
                            r"t = 0 s to t = 400 s; .*", 2, "run", path, "-q", "-o", fresh("short"))
        table.write_text("t_s,v_m_per_s\n0,-0.5\n400,-0.5\n")
        self.assertFails(3, r".*short\.csv:1:5: a column is missing: velocity_x_m_per_s",
                         2, "run", path, "-q", "-o", fresh("short"))
        table.unlink()
        self.assertFails(3, r".*short\.xml:\d+:\d+: cannot read the table .*short\.csv", 2, "run", path, "-q",
                         "-o", fresh("short"))


if __name__ == "__main__":
    main()
