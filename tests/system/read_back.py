"""What h5py and meshio read is what was computed, checked against values known from elsewhere."""
import unittest

import meshio
import numpy as np

from harness import edited, main, run

AXIS = np.array([np.sin(np.radians(30)), np.cos(np.radians(30)), 0])  # of the tow, as in the deck
STIFFNESS = 1e7  # N, axial


def rounded(points):
    """Places as a set, to a micrometre; there is no -0."""
    return set(map(tuple, np.round(points[:, :2], 6) + 0.0))


class ReadBack(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.results = run("read_back", edited("read_back", output_fields_every="1", time_end="100"), 2)
        cls.mesh = meshio.read(cls.results.folder / "mesh.msh")

    def cable_csv(self, time):
        table = self.results.table("cable.csv")
        return {name: values[table["t_s"] == time] for name, values in table.items()}

    def meshed_arc_length(self):
        """Of the nodes of the mesher's cable, which hangs straight down from (0, 0)."""
        tag = self.mesh.field_data["cable"][0]
        tags = self.mesh.cell_data_dict["gmsh:physical"]["line"]
        nodes = np.unique(self.mesh.cells_dict["line"][tags == tag])
        return np.sort(-self.mesh.points[nodes, 1])

    def test_points_are_the_meshers_points_plus_the_displacement(self):
        for step in self.results.steps():
            flow = self.results.fields(step)
            start = flow["points"] - flow["displacement"]
            self.assertEqual(rounded(start), rounded(self.mesh.points))
        self.assertGreater(np.abs(flow["displacement"]).max(), 1)

    def test_triangles_are_the_meshers_triangles(self):
        flow = self.results.fields(1)
        start = flow["points"] - flow["displacement"]
        triangles = self.mesh.cells_dict["triangle"]
        self.assertEqual(len(flow["cells"]), len(triangles))
        self.assertEqual(rounded(start[flow["cells"]].mean(axis=1)), rounded(self.mesh.points[triangles].mean(axis=1)))

    def test_prescribed_values_are_there(self):
        for step in self.results.steps():
            flow = self.results.fields(step)
            inflow = np.isclose(flow["points"][:, 1], 900)
            self.assertGreater(inflow.sum(), 5)
            np.testing.assert_allclose(flow["velocity"][inflow], np.tile([0, -0.5, 0], (inflow.sum(), 1)), atol=1e-14)
            walls = np.isclose(np.abs(flow["points"][:, 0]), 1200) | inflow
            np.testing.assert_array_equal(flow["displacement"][walls], 0)

    def test_the_pressure_jumps_across_the_cable(self):
        flow = self.results.fields(5)
        place = np.round(flow["points"][:, :2], 9)
        _, first, count = np.unique(place, axis=0, return_index=True, return_counts=True)
        self.assertEqual((count == 2).sum(), 9)  # all of the cable's 11 nodes but its ends
        for point in place[first[count == 2]]:
            low, high = flow["pressure"].ravel()[(place == point).all(axis=1)]
            self.assertNotEqual(low, high)

    def test_the_cable_is_the_same_everywhere(self):
        for step, time in (3, 60), (5, 100):
            cable, table = self.results.fields(step, "cable"), self.cable_csv(time)
            np.testing.assert_allclose(cable["points"][:, 0], table["x_m"], rtol=1e-11, atol=1e-9)
            np.testing.assert_allclose(cable["points"][:, 1], table["y_m"], rtol=1e-11, atol=1e-9)
            np.testing.assert_allclose(cable["arc_length"].ravel(), self.meshed_arc_length(), rtol=1e-13)
            flow = self.results.fields(step)
            for point in cable["points"]:
                self.assertLess(np.abs(flow["points"] - point).max(axis=1).min(), 1e-12)

    def test_reports_follow_from_the_cables_points(self):
        history = self.results.history()
        for step in self.results.steps("cable"):
            points = self.results.fields(step, "cable")["points"]
            arm = points - points[0]
            errors = np.abs(arm[:, 0] * AXIS[1] - arm[:, 1] * AXIS[0])
            segments = np.linalg.norm(np.diff(points, axis=0), axis=1)
            arc = (segments * (errors[1:] + errors[:-1]) / 2).sum() / segments.sum()
            for name, value in (("end_error_m", errors[-1]), ("total_error_m", errors.mean()),
                                ("total_error_arc_m", arc), ("cable_length_m", segments.sum())):
                self.assertAlmostEqual(history[name][step - 1] / value, 1, delta=1e-10, msg=name)
        self.assertAlmostEqual(self.results.summary()["end_error_m"] / history["end_error_m"][-1], 1, delta=1e-11)

    def test_the_tow_point_is_where_it_was_towed(self):
        way = 0.2 * (100 - 20 - 60 / 2)  # m: the ramp, from 20 s on and 60 s long, costs half of its time
        np.testing.assert_allclose(self.results.fields(5, "cable")["points"][0], way * AXIS, rtol=1e-12)

    def test_the_tension_follows_from_the_stretch(self):
        points = self.results.fields(5, "cable")["points"]
        stretch = np.linalg.norm(np.diff(points, axis=0), axis=1) / 42
        segments = STIFFNESS * stretch * (stretch**2 - 1) / 2  # Green-Lagrange; taut
        self.assertGreater(segments.min(), 0)
        nodes = np.concatenate([segments[:1], (segments[1:] + segments[:-1]) / 2, segments[-1:]])
        np.testing.assert_allclose(self.results.fields(5, "cable")["tension"].ravel(), nodes, rtol=1e-6)

    def test_meshio_opens_the_index_of_one_step(self):
        for grid, kind in ("flow", "triangle"), ("cable", "line"):
            there = self.results.fields(5, grid)
            here = meshio.read(self.results.folder / f"{grid}-000005.xdmf")
            np.testing.assert_array_equal(here.points, there["points"])
            np.testing.assert_array_equal(here.cells_dict[kind], there["cells"])
            self.assertEqual(set(here.point_data), set(there) - {"points", "cells"})
            for name, values in here.point_data.items():
                np.testing.assert_array_equal(values.ravel(), there[name].ravel())


if __name__ == "__main__":
    main()
