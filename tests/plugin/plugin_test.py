"""Runs heat.xml with the plug-in on 1 and 2 ranks, and shows how unfit plug-ins are refused.

python3 tests/plugin/plugin_test.py BUILD_FOLDER PLUGIN_FOLDER
"""
import json
import subprocess
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
BUILD, PLUGINS = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
SCRATCH = BUILD / "tests/run/plugin"


def hawser(ranks, *arguments):
    command = ["mpirun", "-np", str(ranks), "--oversubscribe", "--bind-to", "none",
               str(BUILD / "bin/hawser"), *map(str, arguments), "--plugin-dir", str(PLUGINS)]
    return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)


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


class UnfitPlugin(unittest.TestCase):
    def refused(self, plugin, sentence):
        deck = deck_with(plugin)
        line = 1 + deck.read_text().split("<plugin")[0].count("\n")
        done = hawser(2, "check", deck)
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

    def test_outside_of_the_folder(self):
        self.refused("../heat", "give the bare name")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
