"""Turek and Hron's periodic cases: each deck expects what was published of its statistics.

python3 tests/system/turek_hron.py --build BUILD_FOLDER --case csm3
"""
from harness import BUILD, ROOT, Results, SystemTest, figures, fresh, hawser, main, parser

SECTIONS = {"csm3": "Structures", "cfd3": "Flows", "fsi2": "Flows", "fsi3": "Flows"}
SOURCE = "S. Turek, J. Hron, Lect. Notes Comput. Sci. Eng. 53 (2006) 371-385; FSI2, FSI3: the same authors in 73 (2010)"

parser.add_argument("--case", choices=SECTIONS, required=True)
CASE = parser.parse_known_args()[0].case


class Flag(SystemTest):
    def test_oscillates_as_published(self):
        folder = fresh(CASE)
        hawser(1, "run", ROOT / f"inputs/turek_hron/{CASE}.xml", "-o", folder, "-q", seconds=7000)
        for quantity, judged in Results(folder).summary()["expectations"].items():
            what, unit = split(quantity)
            with self.subTest(quantity=quantity):
                self.assertTrue(figures.record(BUILD, f"system.turek_hron.{CASE}.{quantity}", SECTIONS[CASE],
                                               f"{CASE.upper()}, {what}", judged["got"], judged["expected"], judged["within"],
                                               SOURCE, f"ctest --test-dir build -R '^system.turek_hron.{CASE}$'", unit),
                                judged["got"])


def split(quantity):
    """uy_amplitude_m: "uy amplitude" in m."""
    for ending, unit in (("_n_per_m", "N/m"), ("_hz", "Hz"), ("_m", "m")):
        if quantity.endswith(ending):
            return quantity.removesuffix(ending).replace("_", " "), unit
    return quantity.replace("_", " "), "1"


if __name__ == "__main__":
    main()
