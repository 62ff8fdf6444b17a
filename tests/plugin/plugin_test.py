"""Runs heat.xml with the plug-in on 1 and 2 ranks, and shows how unfit plug-ins are refused.

python3 tests/plugin/plugin_test.py BUILD_FOLDER PLUGIN_FOLDER
"""
import csv
import json
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
BUILD, PLUGINS = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
SCRATCH = BUILD / "tests/run/plugin"


def hawser(ranks, *arguments, folder=PLUGINS, cwd=None):
    command = ["mpirun", "-np", str(ranks), "--oversubscribe", "--bind-to", "none",
               str(BUILD / "bin/hawser"), *map(str, arguments)]
    if folder is not None:
        command += ["--plugin-dir", str(folder)]
    return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, cwd=cwd,
                          env={**os.environ, "HAWSER_PLUGIN_SECONDS": "2"}, timeout=120)


def plugins_of(name, **files):
    """A folder of plug-ins: copies of those there are, or texts."""
    folder = SCRATCH / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    folder.chmod(0o755)
    for plugin, content in files.items():
        if content is None:
            shutil.copy(PLUGINS / f"{plugin}.so", folder)
        else:
            (folder / f"{plugin}.so").write_text(content)
    return folder


def run_heat(ranks):
    folder = SCRATCH / f"heat.np{ranks}"
    done = hawser(ranks, "run", HERE / "heat.xml", "-o", folder, "--force", "--quiet")
    return done, json.loads((folder / "summary.json").read_text())


def deck_with(plugin):
    """heat.xml, asking for another plug-in."""
    SCRATCH.mkdir(parents=True, exist_ok=True)
    deck = SCRATCH / "unfit.xml"
    deck.write_text((HERE / "heat.xml").read_text().replace('<plugin name="heat"/>',
                                                            f'<plugin name="{plugin}"/>'))
    return deck


class Heat(unittest.TestCase):
    def test_is_exact_on_any_number_of_ranks(self):
        summaries = []
        for ranks in 1, 2:
            done, summary = run_heat(ranks)
            self.assertEqual(done.returncode, 0, f"{done.stdout}{done.stderr}{summary}")
            self.assertEqual(summary["expectations_failed"], 0)
            summaries.append(summary)
        one, two = summaries
        self.assertEqual(one["newton_iterations"], two["newton_iterations"])
        for quantity in "upper_temperature_k", "lower_temperature_k", "flow_velocity_x_m_per_s":
            self.assertAlmostEqual(one[quantity] / two[quantity], 1, delta=1e-10, msg=quantity)
            print(quantity, one[quantity], two[quantity])


class Quadratic(unittest.TestCase):
    def test_nodes_on_edges_move_with_the_displacement_of_either_basis(self):
        for basis in "P1", "P2":
            folder = SCRATCH / f"quadratic.{basis}"
            done = hawser(2, "run", HERE / "quadratic.xml", "-o", folder, "-f", "-q",
                          "--set", f"field[displacement]/basis={basis}")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertLess(json.loads((folder / "summary.json").read_text())["t_error_max"], 1e-12)


class Energy(unittest.TestCase):
    def test_a_report_gives_columns_and_quantities(self):
        tables = []
        for ranks in 1, 2:
            folder = SCRATCH / f"energy.np{ranks}"
            done = hawser(ranks, "run", HERE / "energy.xml", "-o", folder, "--force", "--quiet")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            with (folder / "history.csv").open() as file:
                tables.append(list(csv.DictReader(file)))
        for row in tables[0] + tables[1]:
            exact = 0.005 * (1 - 0.1 * float(row["t_s"]))
            self.assertAlmostEqual(float(row["water_kinetic_energy_j_per_m"]), exact, delta=1e-10)
            self.assertAlmostEqual(float(row["brine_kinetic_energy_j_per_m"]), 2 * exact, delta=1e-10)

    def test_its_names_are_checked(self):
        deck = SCRATCH / "energy_faults.xml"
        SCRATCH.mkdir(parents=True, exist_ok=True)
        text = (HERE / "energy.xml").read_text().replace('"heat.xml"', f'"{HERE}/heat.xml"')
        for right, wrong, sentence in (
                ('name="water"', 'nme="water"', "did you mean 'name'?"),
                ('name="water" region="water"', 'name="water" region="watr"', "did you mean 'water'?"),
                ("<energy name=\"water\"", "<enrgy name=\"water\"", "did you mean 'energy'?")):
            deck.write_text(text.replace(right, wrong, 1))
            done = hawser(2, "run", deck, "--dry-run")
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn(sentence, done.stderr)

    def test_is_described(self):
        self.assertIn("density", hawser(1, "describe", "energy", "--plugin", "energy").stdout)
        self.assertEqual(hawser(1, "describe", "energy").returncode, 2)


class Decay(unittest.TestCase):
    def test_module_and_report_come_from_one_plugin(self):
        for ranks in 1, 2, 3:
            folder = SCRATCH / f"decay.np{ranks}"
            done = hawser(ranks, "run", HERE / "decay.xml", "-o", folder, "-f", "-q")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("nothing prescribes 'tracer' on 'left'", done.stdout + done.stderr +
                      (folder / "summary.json").read_text())
        self.assertIn("Center=\"Cell\"", (folder / "flow.xdmf").read_text())


class UnfitPlugin(unittest.TestCase):
    def refused(self, plugin, sentence, ranks=2, **options):
        deck = deck_with(plugin)
        line = 1 + deck.read_text().split("<plugin")[0].count("\n")
        done = hawser(ranks, "check", deck, **options)
        self.assertEqual(done.returncode, 5, done.stderr)
        complaint = done.stderr.splitlines()[0]
        self.assertRegex(complaint, f"unfit.xml:{line}:[0-9]+: plug-in '{plugin}'")
        self.assertIn(sentence, complaint)

    def test_that_is_not_there(self):
        self.refused("heet", f"not found: there is no {PLUGINS}/heet.so")

    def test_of_another_build(self):
        self.refused("foreign", "was built for hawser-abi-0/gcc-4.0.0, this program is hawser-abi-")

    def test_without_the_symbols(self):
        self.refused("mute", "it is not a Hawser plug-in")

    def test_of_another_build_that_lacks_symbols_here(self):
        self.refused("foreign_unlinked", "was built for hawser-abi-0/gcc-4.0.0, this program is hawser-abi-")

    def test_that_lacks_a_library(self):
        self.refused("unlinked", "cannot be loaded: ")
        self.refused("unlinked", "of_a_library_that_is_not_linked", ranks=1)

    def test_whose_start_throws(self):
        self.refused("thrower", "failed while it registered its parts: no licence server")
        self.refused("number_thrower", "failed while it registered its parts: it threw something")

    def test_that_never_comes_back(self):
        for plugin in "endless", "endless_library":
            self.refused(plugin, "fails while it is loaded: it does not come back within 2 s")

    def test_whose_start_ends_the_program(self):
        self.refused("crasher", "fails while it is loaded: it ends the program with signal SIGSEGV")
        self.refused("quitter", "fails while it is loaded: it ends the program with exit code 0")

    def test_is_refused_by_verbs_that_only_describe_it(self):
        done = hawser(1, "modules", "--plugin", "endless")
        self.assertEqual((done.returncode, done.stderr.splitlines()[0]), (
            5, "plug-in 'endless' fails while it is loaded: it does not come back within 2 s"))

    def test_that_is_no_library(self):
        self.refused("diary", "cannot be loaded: ", folder=plugins_of("no_library", diary="Dear diary"))

    def test_outside_of_the_folder(self):
        self.refused("../heat", "give the bare name")
        self.refused("/etc/heat", "give the bare name")

    def test_in_the_working_folder(self):
        """Only the installation's folder or --plugin-dir count."""
        self.refused("heat", f"not found: there is no {BUILD}/lib/hawser/plugins/heat.so", folder=None, cwd=PLUGINS)

    def test_that_everybody_may_write(self):
        folder = plugins_of("writable", heat=None)
        self.assertEqual(hawser(1, "check", HERE / "heat.xml", folder=folder).returncode, 0)
        (folder / "heat.so").chmod(0o757)
        self.refused("heat", f"everybody may write {folder}/heat.so", folder=folder)
        (folder / "heat.so").chmod(0o755)
        folder.chmod(0o757)
        self.refused("heat", f"everybody may write {folder};", folder=folder)

    def test_twice(self):
        folder = plugins_of("twice", heat=None)
        shutil.copy(folder / "heat.so", folder / "heat_again.so")
        deck = SCRATCH / "twice.xml"
        deck.write_text((HERE / "heat.xml").read_text().replace('<plugin name="heat"/>',
                                                                '<plugin name="heat"/><plugin name="heat_again"/>'))
        done = hawser(2, "check", deck, folder=folder)
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("two modules want the tag <heat>", done.stderr.splitlines()[0])


class Harmful(unittest.TestCase):
    """Whatever a module of a plug-in does, the run ends with one sentence that names the plug-in."""

    def ends(self, harm, code, sentence):
        SCRATCH.mkdir(parents=True, exist_ok=True)
        deck = SCRATCH / f"harm_{harm}.xml"
        text = (HERE / "heat.xml").read_text().replace('<plugin name="heat"/>', '<plugin name="harmful"/>')
        deck.write_text(text.replace('<heat region="water" capacity="1" conductivity="1"/>',
                                     f'<harmful region="water" harm="{harm}"/>'))
        for ranks in 1, 2:
            with self.subTest(harm=harm, ranks=ranks):
                done = hawser(ranks, "run", deck, "-o", SCRATCH / f"harm_{harm}", "-f", "-q")
                self.assertEqual(done.returncode, code, done.stderr)
                self.assertEqual(done.stderr.count("plug-in 'harmful'"), 1, done.stderr)
                self.assertIn(sentence, done.stderr)

    def test_constructors(self):
        self.ends("hang", 5, "plug-in 'harmful': module <harmful> cannot be made: it does not come back within 2 s")
        self.ends("crash", 5, "module <harmful> cannot be made: it ends the program with signal SIGSEGV")
        self.ends("exit", 5, "module <harmful> cannot be made: it ends the program with exit code 0")
        self.ends("throw", 5, "module <harmful> cannot be made: no memory for the tables")
        self.ends("throw-a-number", 5, "module <harmful> cannot be made: it threw something")

    def test_equations(self):
        self.ends("wrong-field", 3, "module 'harm' of plug-in 'harmful' reads the field 'velocty', which no module solves "
                                    "for; there are")
        self.ends("nan", 6, "gives a residual that is not a number (module 'harm' of plug-in 'harmful')")
        self.ends("throw-later", 5, "module 'harm' of plug-in 'harmful' fails in its equations: out of luck")


class Verbs(unittest.TestCase):
    def test_know_plugins(self):
        self.assertNotRegex(hawser(1, "modules").stdout, r"(?m)^heat ")
        self.assertRegex(hawser(2, "modules", "--plugin", "heat").stdout, "heat +Heat carried by the flow and conducted")
        self.assertIn("conductivity", hawser(1, "describe", "heat", "--plugin", "heat").stdout)
        self.assertEqual(hawser(1, "modules", "--plugin", "heet").returncode, 5)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
