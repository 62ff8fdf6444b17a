"""Two modules on two parts of the water are one flow: what they compute and write is what one module gives."""
import numpy as np

from harness import ROOT, SCRATCH, SystemTest, difference, main, run

TUTORIALS = ROOT / "inputs/tutorials"
FORCES = "walls_force_n_per_m", "support_force_n_per_m"
ONE = """<ale-fluid region="{}" density="1000" viscosity="300"><outflow on="outflow" kind="pressure"/></ale-fluid>"""


def deck(name, regions):
    """A copy of the deck in the scratch folder, with one module for the flow when `regions` are given."""
    text = (TUTORIALS / "two_waters.xml").read_text().replace("two_waters.msh", str(TUTORIALS / "two_waters.msh"))
    if regions:
        start, end = text.index("<ale-fluid"), text.rindex("</ale-fluid>") + len("</ale-fluid>")
        text = text[:start] + ONE.format(regions) + text[end:]
    path = SCRATCH / f"{name}.xml"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    return path


class TwoBodies(SystemTest):
    @classmethod
    def setUpClass(cls):
        cls.two = run("two", deck("two", None))

    def assertOneFlow(self, other, bound):
        there, here = self.two.fields(12), other.fields(12)
        np.testing.assert_array_equal(here["cells"], there["cells"])
        found = {name: difference(here[name], there[name]) for name in ("displacement", "velocity", "pressure")}
        a, b = self.two.history(), other.history()
        found.update({force: difference(b[force], a[force]) for force in FORCES})
        print(f"{other.folder.name}:", {name: f"{value:.1e}" for name, value in found.items()})
        self.assertLessEqual(max(found.values()), bound)

    def test_every_cell_is_written_once(self):
        cells = np.sort(self.two.fields(12)["cells"], axis=1)
        self.assertEqual(len(np.unique(cells, axis=0)), len(cells))

    def test_one_module_on_the_group_of_all(self):
        self.assertOneFlow(run("one", deck("one", "water")), 1e-11)

    def test_one_module_on_a_list_even_with_overlaps(self):
        self.assertOneFlow(run("list", deck("list", "near far water")), 1e-11)

    def test_more_ranks(self):
        for ranks in 2, 4:
            with self.subTest(ranks=ranks):
                self.assertOneFlow(run(f"two.np{ranks}", deck("two", None), ranks), 1e-10)


if __name__ == "__main__":
    main()
