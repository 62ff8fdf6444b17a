"""Installs Hawser into a scratch prefix, follows doc/write_a_module.md, doc/running.md and doc/embedding.md word for word with it, and
tries what else is installed: the manual page and the completion.

python3 tests/plugin_out_of_tree/installed.py --build build
"""
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "system"))
from harness import BUILD, ENVIRONMENT, ROOT, SCRATCH, SystemTest, main

TUTORIAL = (ROOT / "doc/write_a_module.md").read_text()
EMBEDDING = (ROOT / "doc/embedding.md").read_text()
RUNNING = (ROOT / "doc/running.md").read_text()
PREFIX = SCRATCH / "hawser"
SPACE = SCRATCH / "my_heat"


def blocks(page):
    """The page's blocks in order: kind, text, and the name of the file that the line before gives."""
    for found in re.finditer(r"(?:^`([\w.]+)`[^\n]*:\n\n)?^```(\w+)\n(.*?)^```", page, re.S | re.M):
        yield found.group(2), found.group(3), found.group(1)


def shell(script, folder=None):
    environment = {**ENVIRONMENT, "HOME": str(SCRATCH), "OMPI_MCA_rmaps_base_oversubscribe": "1",
                   "OMPI_MCA_hwloc_base_binding_policy": "none"}
    return subprocess.run(["bash", "-ec", script], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=600)


class Tutorial(SystemTest):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        SCRATCH.mkdir(parents=True)
        script, cls.files = [], {}
        for kind, text, name in blocks(TUTORIAL):
            if kind == "sh":
                script.append(text)
            elif name:
                cls.files[name] = text
                script.append(f"cp {SCRATCH}/{name} .\n")
        for name, text in cls.files.items():
            (SCRATCH / name).write_text(text)
        # The reader stands in Hawser's folder, whose build folder may be elsewhere here.
        cls.script = "".join(script).replace("cmake --install build --prefix", f"cmake --install {BUILD} --prefix", 1)
        cls.done = shell(cls.script, ROOT)

    def test_a_new_plugin_is_built_and_passes_its_tests(self):
        script = (f"{PREFIX}/bin/hawser new plugin sea_salt && cd sea_salt && "
                  f"cmake -S . -B build -DCMAKE_PREFIX_PATH={PREFIX} && cmake --build build && "
                  "ctest --test-dir build --output-on-failure")
        shutil.rmtree(SCRATCH / "sea_salt", ignore_errors=True)
        done = shell(script, SCRATCH)
        self.assertEqual(done.returncode, 0, done.stdout[-3000:] + done.stderr[-3000:])
        self.assertIn("100% tests passed, 0 tests failed out of 3", done.stdout)
        again = shell(f"{PREFIX}/bin/hawser new plugin sea_salt", SCRATCH)
        self.assertEqual(again.returncode, 7)
        self.assertIn("is there already", again.stderr)
        self.assertEqual(shell(f"{PREFIX}/bin/hawser new plugin Salt", SCRATCH).returncode, 2)

    def test_every_step_works_as_pasted(self):
        self.assertEqual(self.done.returncode, 0, self.script + self.done.stdout[-3000:] + self.done.stderr[-3000:])
        self.assertIn("heat.xml: no faults", self.done.stdout)
        self.assertRegex(self.done.stdout, r"expected upper_temperature_k = 303 within 1e-08: holds")
        self.assertTrue((PREFIX / "lib/hawser/plugins/heat.so").exists())

    def test_the_installed_program_and_plugin_give_the_exact_answer_on_1_and_2_ranks(self):
        for ranks in 1, 2:
            done = shell(f"mpirun -np {ranks} {PREFIX}/bin/hawser run heat.xml -q -f -o np{ranks}", SPACE)
            self.assertEqual(done.returncode, 0, done.stderr)
            summary = json.loads((SPACE / f"np{ranks}/summary.json").read_text())
            self.assertEqual(summary["provenance"]["ranks"], ranks)
            self.assertAlmostEqual(summary["upper_temperature_k"], 303, delta=1e-8)  # round-off of 80 steps

    def test_the_page_shows_what_the_tests_build(self):
        self.assertEqual(set(self.files), {"heat.cpp", "heat.xml", "CMakeLists.txt"})
        for name in "heat.cpp", "heat.xml":
            self.assertEqual(self.files[name], (ROOT / "tests/plugin" / name).read_text())

    def test_a_report_of_your_own(self):
        """doc/write_a_report.md names the file and the line that builds it."""
        (line,) = (text for kind, text, _ in blocks((ROOT / "doc/write_a_report.md").read_text()) if kind == "cmake")
        place = SCRATCH / "energy"
        place.mkdir()
        shutil.copy(ROOT / "tests/plugin/energy.cpp", place)
        (place / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\nproject(energy CXX)\n"
                                              "find_package(Hawser REQUIRED)\n" + line)
        done = shell(f"cmake -B build -DCMAKE_PREFIX_PATH={PREFIX}\ncmake --build build\n{PREFIX}/bin/hawser describe energy "
                     "--plugin energy --plugin-dir build/lib/hawser/plugins", place)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("<energy>  Reports the kinetic energy of a body.", done.stdout)

    def test_nothing_of_the_tests_is_installed(self):
        self.assertEqual([path.name for path in (PREFIX / "lib/hawser/plugins").iterdir()], ["heat.so"])
        libraries = shell(f"ldd {PREFIX}/bin/hawser").stdout
        self.assertNotIn("not found", libraries)
        self.assertNotIn(str(BUILD / "lib"), libraries)

    def verbs(self):
        return re.findall(r"^  (\w+) ", shell(f"{PREFIX}/bin/hawser --help").stdout.split("Subcommands:")[1], re.M)

    def test_manual_page(self):
        page = PREFIX / "share/man/man1/hawser.1"
        self.assertEqual(shell(f"groff -man -Tutf8 -ww -z {page}").stderr, "")
        text = shell(f"groff -man -Tascii -P-cbou {page}").stdout
        self.assertGreater(len(self.verbs()), 6)
        for verb in self.verbs():
            self.assertIn(f"hawser {verb}", text)
            for option in re.findall(r"(?<= |,)--[a-z-]+", shell(f"{PREFIX}/bin/hawser {verb} --help").stdout):
                self.assertIn(option, text)

    def test_a_tow_of_your_own(self):
        """doc/running.md word for word, but for an early end: the deck's expectations are of a later time."""
        (kind, deck, name), (_, script, _) = blocks(RUNNING)
        self.assertEqual((kind, name), ("xml", "mine.xml"))
        place = SCRATCH / "own"
        place.mkdir()
        (place / name).write_text(deck)
        for folder in "inputs", "apps":
            (place / folder).symlink_to(ROOT / folder)
        script = script.replace("step=40", "step=40 --end 120 || [ $? = 8 ]").replace("python3", "/usr/bin/python3")
        done = shell(f"export PATH={PREFIX}/bin:$PATH\n{script}", place)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("mine.xml: no faults", done.stdout)
        self.assertRegex(done.stdout, r"\n  tail_velocity_x_m_per_s +-?\d")
        for picture in "history.png", "cable.png":
            self.assertEqual((place / "results/mine" / picture).read_bytes()[:4], b"\x89PNG")

    def test_a_program_of_your_own(self):
        """doc/embedding.md: the page shows the example as it lies in the tree, its script builds it against the installation."""
        shown = list(blocks(EMBEDDING))
        place = SCRATCH / "embed"
        place.mkdir()
        for kind, text, name in shown:
            if name:
                self.assertEqual(text, (ROOT / "apps/examples/embed" / name).read_text())
                (place / name).write_text(text)
        script = "".join(text for kind, text, _ in shown if kind == "sh")
        done = shell(script, place)
        self.assertEqual(done.returncode, 0, script + done.stdout[-3000:] + done.stderr[-3000:])
        self.assertRegex(done.stdout, r"(?m)^t = 1 s: \d+ iterations, the tail has gone 5\.0000 m$")
        self.assertEqual(len(re.findall(r"^t = ", done.stdout, re.M)), 4)
        nodes = dict(re.findall(r"^node \d+: X = (\S+) m, x = (\S+) m$", done.stdout, re.M))
        self.assertEqual(len(nodes), 11)
        self.assertEqual(nodes["10"], "15.0000")
        self.assertEqual({path.name for path in place.iterdir()}, {"build", "main.cpp", "CMakeLists.txt", "bar.h5"})
        self.assertNotIn(str(BUILD / "lib"), shell(f"ldd {place}/build/embed").stdout)

    def completed_words(self, *words):
        return shell(f"""set +e; PATH={PREFIX}/bin:$PATH
            . {PREFIX}/share/bash-completion/completions/hawser
            COMP_WORDS=({' '.join(f"'{word}'" for word in words)}); COMP_CWORD={len(words) - 1}
            _hawser; printf '%s\\n' "${{COMPREPLY[@]}}" """, SPACE).stdout.split()

    def test_completion(self):
        self.assertEqual(set(self.completed_words("hawser", "")), {*self.verbs(), "--help", "--version"})
        self.assertEqual(self.completed_words("hawser", "rest"), ["restart"])
        self.assertEqual(self.completed_words("hawser", "run", "--log"), ["--log-json"])
        self.assertEqual(self.completed_words("hawser", "run", "h"), ["heat.xml"])
        self.assertEqual(self.completed_words("hawser", "describe", "ca"), ["cable"])
        self.assertEqual(self.completed_words("hawser", "new", "to"), ["tow"])
        self.assertIn("build", self.completed_words("hawser", "run", "heat.xml", "-o", "b"))


if __name__ == "__main__":
    main()
