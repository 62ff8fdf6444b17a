"""Cables beside each other: every line is written, with a <tow> or without, and each <tow> has names of its own."""
import unittest

import h5py
import numpy as np

from harness import ROOT, SCRATCH, Results, completed, fresh, hawser, main

SEGMENTS, LENGTH = 42, 420.0
EXACTLY = ["--set", "solver/newton/tolerance=1e-11", "--set", "solver/linear/tolerance=1e-10",
           "--set", "step=10"]  # none is rejected: the steps are the same


def write_mesh(path):
    """Three cables of 42 segments along -y; the first two are towed, and the third ends in a fork."""
    nodes = [(x, -LENGTH * i / SEGMENTS) for x in (0, 1000, 2000) for i in range(SEGMENTS + 1)]
    chains = [[(SEGMENTS + 1) * c + i for i in range(SEGMENTS + 1)] for c in range(3)]
    lines = {name: list(zip(chain, chain[1:])) for name, chain in zip(("port", "starboard", "forked"), chains)}
    lines["forked"].append((chains[2][20], len(nodes)))
    nodes.append((2010.0, nodes[chains[2][20]][1]))
    points = {"port-point": chains[0][0], "starboard-point": chains[1][0], "forked-point": chains[2][0]}
    cells = [(1, group, pair) for group, name in enumerate(lines, 1) for pair in lines[name]]
    cells += [(15, group, (vertex,)) for group, vertex in enumerate(points.values(), 4)]
    names = [f'1 {i} "{name}"' for i, name in enumerate(lines, 1)] + [f'0 {i} "{name}"' for i, name in enumerate(points, 4)]
    text = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names)), *names, "$EndPhysicalNames",
            "$Nodes", str(len(nodes)), *(f"{i} {x} {y} 0" for i, (x, y) in enumerate(nodes, 1)), "$EndNodes",
            "$Elements", str(len(cells)),
            *(f"{i} {kind} 2 {group} {group} " + " ".join(str(v + 1) for v in vertices)
              for i, (kind, group, vertices) in enumerate(cells, 1)), "$EndElements"]
    path.write_text("\n".join(text) + "\n")


def deck():
    """drag_law.xml with three cables instead of one."""
    SCRATCH.mkdir(parents=True, exist_ok=True)
    write_mesh(SCRATCH / "three.msh")
    text = (ROOT / "inputs/deep_tow/drag_law.xml").read_text()
    mesh, cable, conditions = (text[text.index(f"<{tag}"):text.index(f"</{tag}>")] + f"</{tag}>"
                               for tag in ("mesh", "cable", "conditions"))
    tow = text[text.index("<tow "):text.index("<expect")]
    hold, pull = conditions.split("<prescribe")[1:]
    pull = pull.replace("</conditions>", "")
    text = text.replace(mesh, '<mesh><file name="three.msh"/></mesh>')
    text = text.replace(cable, "".join(cable.replace('"cable"', f'"{name}"') for name in ("port", "starboard", "forked")))
    text = text.replace(conditions, "<conditions>" + "".join(
        "<prescribe" + (hold.replace('"hold" field', f'"hold-{name}" field').replace('on="cable"', f'on="{name}"')) +
        "<prescribe" + pull.replace('"tow" field', f'"tow-{name}" field').replace("tow-point", f"{name}-point")
        for name in ("port", "starboard", "forked")) + "</conditions>")
    text = text.replace(tow, "".join(
        tow.replace("<tow ", f"<tow {start}").replace('"cable"', f'"{name}"').replace('"tow-point"', f'"{name}-point"')
        for start, name in (("", "port"), ('name="second" ', "starboard"))))
    text = text.replace('value="5400 s"', 'value="1500 s"')
    text = text[:text.index("<expect")] + '<force name="drag" on="port" module="cable"/><output fields-every="25"/></hawser>'
    path = SCRATCH / "three.xml"
    path.write_text(text)
    return path


class Lines(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        path, cls.runs = deck(), []
        for ranks in 1, 2:
            folder = fresh(f"three.np{ranks}")
            cls.said = completed(ranks, "run", path, "-o", folder, "-v", *EXACTLY).stdout
            cls.runs.append(Results(folder))
        cls.results = cls.runs[0]
        folder = fresh("one")
        # It ends too early for what the deck expects.
        hawser(1, "run", ROOT / "inputs/deep_tow/drag_law.xml", "-o", folder, "-q", "--set", "run_time=1500", *EXACTLY)
        cls.one = Results(folder)

    def test_each_tow_reports_what_it_would_alone(self):
        alone, both = self.one.summary(), self.results.summary()
        for quantity in "end_error_m", "total_error_arc_m", "tow_force_n", "cable_length_m", "end_error_exact_m":
            self.assertAlmostEqual(both[quantity] / alone[quantity], 1, delta=1e-6, msg=quantity)
            self.assertAlmostEqual(both["second_" + quantity] / alone[quantity], 1, delta=1e-6, msg=quantity)
        np.testing.assert_allclose(self.results.table("second_cable.csv")["positioning_error_m"],
                                   self.results.table("cable.csv")["positioning_error_m"], atol=1e-5)

    def test_every_line_is_written_with_its_tension(self):
        alone = self.one.fields(self.one.steps("cable")[-1], "cable")
        step = self.results.steps("port")[-1]
        for grid, errors in ("port", "positioning_error"), ("starboard", "second_positioning_error"):
            fields = self.results.fields(step, grid)
            self.assertEqual(set(fields), {"points", "cells", "arc_length", errors, "velocity", "tension"})
            np.testing.assert_allclose(fields["tension"], alone["tension"], rtol=1e-4, atol=1e-3)
        forked = self.results.fields(step, "forked")
        self.assertEqual(set(forked), {"points", "cells", "velocity", "tension"})
        self.assertEqual((len(forked["points"]), len(forked["cells"])), (SEGMENTS + 2, SEGMENTS + 1))
        with h5py.File(self.results.folder / f"forked-{step:06d}.h5") as file:
            self.assertEqual(file["fields/tension"].attrs["unit"], b"N")

    def test_any_number_of_ranks_writes_the_same(self):
        one, two = self.runs
        for grid in "port", "starboard", "forked":
            self.assertEqual(one.steps(grid), two.steps(grid))
            a, b = (run.fields(one.steps(grid)[-1], grid) for run in self.runs)
            np.testing.assert_array_equal(a["cells"], b["cells"])
            for name in a:
                np.testing.assert_allclose(a[name], b[name], rtol=1e-6, atol=1e-5, err_msg=f"{grid} {name}")

    def test_a_restart_goes_on_with_every_report(self):
        whole, parts = fresh("whole"), fresh("parts")
        deck, options = SCRATCH / "three.xml", ["-q", "--set", "output/checkpoint-every=75", *EXACTLY]
        completed(1, "run", deck, "-o", whole, *options)
        completed(1, "run", deck, "-o", parts, *options, "--end", "750")
        completed(1, "restart", parts / "checkpoint.h5", "-q", "--end", "1500")  # the first part's --end is kept
        for table in "history.csv", "cable.csv", "second_cable.csv":
            self.assertEqual((parts / table).read_text(), (whole / table).read_text(), table)
        one, two = (Results(folder).summary() for folder in (whole, parts))
        for quantity in "end_error_change_last_quarter_m", "second_end_error_change_last_quarter_m", "steps":
            self.assertEqual(one[quantity], two[quantity])

    def test_the_log_says_what_was_written(self):
        self.assertEqual(self.said.count("wrote fields"), len(self.results.steps("port")))
        self.assertEqual(self.said.count("exact straight cable"), 2)
        shown = hawser(1, "info", self.results.folder).stdout
        for name in "cable.csv", "second_cable.csv", "forked: ":
            self.assertIn(name, shown)


if __name__ == "__main__":
    main()
