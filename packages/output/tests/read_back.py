"""Reads the files of field_writer_test.cpp and compares every number with sample.hpp's formulas."""
import sys
import xml.etree.ElementTree as xml

import h5py
import meshio
import numpy as np


def expected_fields(ids, time):
    return {
        "pressure": np.sqrt(ids) + time,
        "velocity": np.stack([1 / (1 + ids), -time * ids, 0 * ids], axis=1),
    }


def expected(name, time):
    if name == "flow":
        ids = np.arange(14.0)
        a = np.arange(6)
        cells = np.empty((12, 3), int)
        cells[0::2] = np.stack([a, a + 1, a + 8], axis=1)
        cells[1::2] = np.stack([a, a + 8, a + 7], axis=1)
    else:
        ids = np.array([100.0, 102, 104, 106])
        cells = np.array([[0, 1], [1, 2], [2, 3]])
    y = np.where(ids < 7, 0.0, 1 + 0.1 * ids)
    points = np.stack([10 * (ids % 7) + time, y, 0 * ids], axis=1)
    return points, cells, expected_fields(ids, time)


def check_series(folder, name, kind):
    """By the rules of VTKHDF 2.0; the reader of VTK does the same, which no package of Debian 12 brings."""
    corners, vtk_kind = (3, 5) if kind == "triangle" else (2, 3)
    with h5py.File(f"{folder}/{name}.vtkhdf") as file:
        root, steps = file["VTKHDF"], file["VTKHDF/Steps"]
        assert list(root.attrs["Version"]) == [2, 0] and root.attrs["Type"] in (b"UnstructuredGrid", "UnstructuredGrid")
        assert steps.attrs["NSteps"] == 3 and list(steps["Values"]) == [0, 25, 50]
        for i, time in enumerate(steps["Values"]):
            points, cells, fields = expected(name, time)
            part, count = steps["PartOffsets"][i], len(points)
            assert steps["NumberOfParts"][i] == 1
            assert root["NumberOfPoints"][part] == count and root["NumberOfCells"][part] == len(cells)
            at = steps["PointOffsets"][i]
            np.testing.assert_allclose(root["Points"][at:at + count], points, rtol=1e-15)
            first = steps["ConnectivityIdOffsets"][i]
            joined = root["Connectivity"][first:first + root["NumberOfConnectivityIds"][part]]
            np.testing.assert_array_equal(joined.reshape(-1, corners), cells)
            first = steps["CellOffsets"][i]
            assert (root["Types"][first:first + len(cells)] == vtk_kind).all()
            np.testing.assert_array_equal(root["Offsets"][first:first + len(cells) + 1], corners * np.arange(len(cells) + 1))
            at = steps["CellDataOffsets"]["tension"][i]
            assert list(root["CellData"]) == ["tension"]
            np.testing.assert_allclose(root["CellData"]["tension"][at:at + len(cells)], 10 * np.arange(len(cells)) + time)
            assert sorted(root["PointData"]) == sorted(fields)
            for key, values in fields.items():
                at = steps["PointDataOffsets"][key][i]
                np.testing.assert_allclose(root["PointData"][key][at:at + count], values, rtol=1e-15)


def check(folder, name, kind):
    for step in (0, 10, 20):
        time = 2.5 * step
        points, cells, fields = expected(name, time)
        with h5py.File(f"{folder}/{name}-{step:06d}.h5") as file:
            assert file.attrs["step"] == step and file.attrs["time"] == time
            np.testing.assert_array_equal(file["cells"][:], cells)
            np.testing.assert_allclose(file["points"][:], points, rtol=1e-15)
            assert sorted(file["fields"]) == sorted([*fields, "tension"])
            for key, values in fields.items():
                np.testing.assert_allclose(file["fields"][key][:], values, rtol=1e-15)
            of_cells = 10 * np.arange(len(cells)) + time
            np.testing.assert_allclose(file["fields/tension"][:], of_cells)
            assert file["fields/tension"].attrs["of"] in (b"cells", "cells")
            assert file["fields/velocity"].attrs["unit"] in (b"m/s", "m/s")
        mesh = meshio.read(f"{folder}/{name}-{step:06d}.xdmf")
        np.testing.assert_allclose(mesh.points, points, rtol=1e-15)
        np.testing.assert_array_equal(mesh.cells_dict[kind], cells)
        for key, values in fields.items():
            np.testing.assert_allclose(mesh.point_data[key], values, rtol=1e-15)
        np.testing.assert_allclose(mesh.cell_data["tension"][0], of_cells)
    check_series(folder, name, kind)
    times = [float(t.get("Value")) for t in xml.parse(f"{folder}/{name}.xdmf").iter("Time")]
    assert times == [0, 25, 50], times


check(sys.argv[1], "flow", "triangle")
check(sys.argv[1], "cable", "line")
