"""`hawser converge`: which errors it measures, what it writes, and when it says that an order is not reached."""
import csv
import json
import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "system"))
import harness
from harness import completed, fresh, hawser

# A cubic as prescribed displacement: its error is that of linear interpolation, of second order.
DECK = """<hawser title="interpolation">
  <mesh><water-box min="0 0" max="2 1" cells="2 1"/></mesh>
  <modules><mesh-motion region="water" reference="total"/></modules>
  <conditions><prescribe field="displacement" on="water" value="{exact}"/></conditions>
  {time}
  <solver><linear method="mumps"/></solver>
  <error name="d" field="displacement" on="water" exact="{exact}"/>
  <error name="bottom" field="displacement" on="bottom" exact="0; 0"/>
  {inside}
</hawser>
"""


def deck(name, exact="0.1*X^3; 0", time='<time scheme="steady" end="1"/>', inside=""):
    path = harness.SCRATCH / f"{name}.xml"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(DECK.format(exact=exact, time=time, inside=inside))
    return path


class Converge(harness.SystemTest):
    def test_orders_and_files(self):
        folder = fresh("orders")
        order = '<converge levels="5"><order quantity="d_error_l2" at-least="1.9" why="linear"/></converge>'
        said = completed(1, "converge", deck("orders", inside=order), "-o", folder).stdout
        result = json.loads((folder / "converge.json").read_text())
        d = result["quantities"]["d_error_l2"]
        self.assertTrue(d["holds"])
        self.assertAlmostEqual(d["finest_pair"], 2, delta=0.05)
        self.assertAlmostEqual(d["fitted"], 2, delta=0.2)
        self.assertLess(d["fitted_standard_error"], 0.1)
        self.assertIn("holds", said)
        with open(folder / "converge.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([int(row["nodes"]) for row in rows], [(2 * n + 1) * (n + 1) for n in (1, 2, 4, 8, 16)])
        self.assertEqual([float(row["d_error_l2"]) for row in rows], d["errors"])
        self.assertIn('refinements="2"', (folder / "level-2/resolved.xml").read_text())

    def test_unstructured_meshes_and_parameters(self):
        path = deck("sizes", inside='<parameter name="half" value="50 cm"/><converge levels="2"/>')
        path.write_text(path.read_text().replace('cells="2 1"', 'size="half"'))
        nodes = {}
        for change in ("half=25 cm", "mesh/water-box/size=500 mm", "half=0.5"):
            folder = fresh("sizes")
            completed(1, "converge", path, "-o", folder, "--set", change)
            with open(folder / "converge.csv", newline="") as file:
                nodes[change] = [int(row["nodes"]) for row in csv.DictReader(file)]
        self.assertEqual(nodes["half=0.5"], nodes["mesh/water-box/size=500 mm"])
        for coarse, fine in nodes.values():
            self.assertLess(3 * coarse, fine + 20)

    def test_a_geometry_is_refined_by_cutting_its_cells(self):
        path = deck("geometry", inside='<converge levels="3"><order quantity="d_error_l2" at-least="1.9" why="linear"/></converge>')
        path.write_text(path.read_text().replace('<water-box min="0 0" max="2 1" cells="2 1"/>', '<geo file="box.geo"/>'))
        (path.parent / "box.geo").write_text("""Point(1) = {0, 0, 0, 0.5}; Point(2) = {2, 0, 0, 0.5}; Point(3) = {2, 1, 0, 0.5}; Point(4) = {0, 1, 0, 0.5};
            Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1}; Curve Loop(1) = {1, 2, 3, 4};
            Plane Surface(1) = {1}; Physical Surface("water") = {1}; Physical Curve("bottom") = {1};
            Physical Curve("rest") = {2, 3, 4};
""")
        folder = fresh("geometry")
        completed(1, "converge", path, "-o", folder)
        with open(folder / "converge.csv", newline="") as file:
            nodes = [int(row["nodes"]) for row in csv.DictReader(file)]
        for coarse, fine in zip(nodes, nodes[1:]):
            self.assertLess(3 * coarse, fine + 20)

    def test_norms_are_those_of_the_moved_region(self):
        # d = (X, 0) stretches the box to 4 x 1 and its bottom to a length of 4; off by (0.5, 0) from 0.5 X.
        result = harness.run("norms", deck("norms", exact="X; 0", inside="""
          <error name="moved" field="displacement" on="water" exact="x/2 - 0.5; 0"/>
          <error name="level" field="displacement" on="water" exact="x/2 - 0.5; 0" up-to-constant="true"/>
          <error name="line" field="displacement" on="bottom" exact="X - 3; 4"/>""")).summary()
        self.assertAlmostEqual(result["moved_error_l2"], 0.5 * math.sqrt(4), delta=1e-13)
        self.assertAlmostEqual(result["moved_error_max"], 0.5, delta=1e-13)
        self.assertAlmostEqual(result["level_error_l2"], 0, delta=1e-13)
        self.assertAlmostEqual(result["line_error_l2"], 5 * math.sqrt(4), delta=1e-12)
        self.assertAlmostEqual(result["line_error_max"], 4, delta=1e-13)
        # The integral of d_x^2 over the stretched bottom: x = 2 X, d = x/2.
        self.assertAlmostEqual(result["bottom_error_l2"], math.sqrt(4**3 / 12), delta=1e-13)

    def test_the_same_on_any_number_of_ranks(self):
        path = deck("ranks", inside='<converge levels="3"/>')
        errors = []
        for ranks in (1, 3):
            folder = fresh(f"ranks-{ranks}")
            completed(ranks, "converge", path, "-o", folder)
            errors.append(json.loads((folder / "converge.json").read_text())["quantities"]["d_error_l2"]["errors"])
        for one, three in zip(*errors):
            self.assertAlmostEqual(three / one, 1, delta=1e-13)

    def test_an_order_that_is_not_reached_is_exit_code_8(self):
        path = deck("unreached", inside="""<expect quantity="steps" value="7" within="0" why="not so"/>
          <converge levels="3"><order quantity="d_error_l2" at-least="2.5" why="wishes"/></converge>""")
        done = hawser(2, "converge", path, "-o", fresh("unreached"))
        self.assertEqual(done.returncode, 8, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"d_error_l2 .* 2\.5 FAILS")
        # Refined otherwise, the deck's orders do not hold for it.
        path = deck("otherwise", time='<time step="0.1" end="0.4"/>', inside="""<converge levels="3">
          <order quantity="d_error_l2" at-least="1.9" why="linear"/></converge>""")
        completed(1, "converge", path, "-o", fresh("otherwise"), "--refine", "time", "--levels", 2)

    def test_what_cannot_be_refined(self):
        steady = deck("steady", inside='<converge refine="time"/>')
        self.assertFails(3, r".*steady\.xml:\d+:\d+: a steady solve has no step to refine", 2,
                         "converge", steady, "-o", fresh("steady"))
        nothing = harness.SCRATCH / "nothing.xml"
        nothing.write_text(deck("with").read_text().replace("<error", "<!--").replace('0"/>\n', '0"/-->\n'))
        self.assertFails(3, r".*nothing\.xml:1:2: no error is there that could converge; .*", 1,
                         "converge", nothing, "-o", fresh("nothing"))
        unknown = deck("unknown", inside="""<converge levels="2">
          <order quantity="e_error" at-least="2" why="-"/></converge>""")
        self.assertFails(3, r".*unknown\.xml:\d+:\d+: the run reports no quantity 'e_error'", 2,
                         "converge", unknown, "-o", fresh("unknown"))


if __name__ == "__main__":
    harness.main()
