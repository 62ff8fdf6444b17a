"""What the program says about decks is complete, fresh, and fits the decks that come with it.

python3 tests/deck_language/self_description.py --build build
"""
import re
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "system"))
import harness

PLUGINS = ["--plugin-dir", harness.BUILD / "tests/plugins"]
WITH_PLUGINS = ["--plugin", "heat", "--plugin", "energy", "--plugin", "decay", *PLUGINS]


def printed(*arguments):
    done = harness.hawser(1, *arguments)
    assert done.returncode == 0, done.stderr
    return done.stdout


def scratch(name, text):
    harness.SCRATCH.mkdir(parents=True, exist_ok=True)
    path = harness.SCRATCH / name
    path.write_text(text)
    return path


def shipped():
    """Every deck of the tree but those that are faulty on purpose."""
    decks = [path for folder in ("inputs", "packages", "tests") for path in (harness.ROOT / folder).rglob("*.xml")
             if "bad_decks" not in path.parts]
    assert len(decks) > 12
    return sorted(path for path in decks if re.search(r"<hawser\b", path.read_text()))


class Schema(unittest.TestCase):
    def setUp(self):
        self.xsd = scratch("deck.xsd", printed("schema", *WITH_PLUGINS))

    def validate(self, *decks):
        return subprocess.run(["xmllint", "--noout", "--schema", self.xsd, *decks], capture_output=True, text=True)

    def test_every_shipped_deck_is_valid(self):
        done = self.validate(*shipped())
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_wrong_names_nesting_and_words_are_not(self):
        deck = (harness.ROOT / "tests/system/decks/tow.xml").read_text()
        for right, wrong in (("far-size=", "far-sise="), ("<newton ", "<newtn "), ('kind="pressure"', 'kind="presure"'),
                             ('keep-factor="true"', 'keep-factor="yes"'), ('density="1000"', 'density=""'),
                             ('density="1000"', 'density="{1,2}"'), ("</solver>", "<tow/></solver>")):
            self.assertIn(right, deck)
            done = self.validate(scratch("wrong.xml", deck.replace(right, wrong)))
            self.assertEqual(done.returncode, 3, f"{wrong}: {done.stderr}")

    def test_plugins_named_on_the_command_line_are_in_it(self):
        for tag in "heat", "energy":
            self.assertIn(f'name="{tag}"', self.xsd.read_text())
        self.assertNotIn('name="heat"', printed("schema"))

    def test_every_attribute_is_documented(self):
        text = self.xsd.read_text()
        attributes = len(re.findall(r'<xs:attribute name="(?!remove")', text))
        self.assertGreater(attributes, 80)
        self.assertEqual(len(re.findall(r'<xs:attribute name="(?!remove").*?>\s*<xs:annotation>', text)), attributes)


class Reference(unittest.TestCase):
    def test_the_page_is_fresh(self):
        page = harness.ROOT / "doc/deck_reference.md"
        self.assertEqual(page.read_text(), printed("describe", "--markdown"),
                         "stale: build/bin/hawser describe --markdown > doc/deck_reference.md")

    def test_a_description_by_path_by_name_and_by_module(self):
        self.assertTrue(printed("describe", "time/step").startswith("time/step, attribute of <time>\n  step  number in s"))
        self.assertTrue(printed("describe", "newton").startswith("<newton>  Newton's method.\n  path: solver/newton\n"))
        self.assertTrue(printed("describe", "cable").startswith("<cable>"))
        self.assertIn("modules/ale-fluid/density, attribute", printed("describe", "modules/ale-fluid/density"))
        self.assertIn("  mesh/tow-box/min\n  mesh/water-box/min\n", printed("describe", "min"))
        self.assertTrue(printed("describe", "heat", *WITH_PLUGINS).startswith("<heat>"))
        self.assertIn("modules: ale-fluid, body, buoyancy, cable, eddy-viscosity, heat-transport, mesh-motion, porous-zone, property, "
                      "scalar-transport, sea-bed, solid", printed("describe"))

    def test_an_unknown_name(self):
        done = harness.hawser(1, "describe", "cabel")
        self.assertEqual((done.returncode, done.stderr), (2, "a deck has nothing called 'cabel'; hawser describe lists all "
                                                            "there is; did you mean 'cable'?\n"))


class Templates(unittest.TestCase):
    def test_each_is_listed_free_of_faults_and_runs(self):
        names = re.findall(r"^  (\S+)  \S", printed("new"), re.M)
        self.assertEqual(names, ["flow", "tow"])
        for name in names:
            deck = scratch(f"{name}.xml", printed("new", name))
            done = harness.hawser(1, "check", deck)
            self.assertEqual((done.returncode, done.stderr), (0, ""), name)
            end = [] if name == "flow" else ["--end", "40"]
            done = harness.hawser(1, "run", deck, "-q", "-f", "-o", harness.SCRATCH / name, *end)
            self.assertIn(done.returncode, (0, 8) if end else (0,), done.stderr)

    def test_an_unknown_name(self):
        done = harness.hawser(1, "new", "tov")
        self.assertEqual((done.returncode, done.stderr),
                         (2, "there is no template 'tov'; there are flow, tow; did you mean 'tow'?\n"))


class Check(unittest.TestCase):
    def test_takes_no_mesh_and_no_more_than_a_second(self):
        for deck in shipped():
            least = 10
            for _ in range(5):  # the machine may be busy with other tests
                start = time.monotonic()
                done = harness.hawser(1, "check", deck, *PLUGINS)
                least = min(least, time.monotonic() - start)
                self.assertEqual(done.returncode, 0, done.stderr)
                if least < 1:
                    break
            print(f"check {deck.relative_to(harness.ROOT)}: {least:.2f} s")
            self.assertLess(least, 1, deck)

    def test_says_the_same_on_one_rank_and_on_three(self):
        for number, deck in enumerate(shipped()):
            for changes in ([], ["--set", "time/stp=1", "--set", "time/end=-1 m"])[:1 + (number < 2)]:
                one, three = (harness.hawser(ranks, "check", deck, *PLUGINS, *changes) for ranks in (1, 3))
                self.assertEqual((one.returncode, one.stdout, one.stderr),
                                 (three.returncode, three.stdout, three.stderr), deck)
                self.assertEqual(one.returncode, 3 if changes else 0, deck)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
