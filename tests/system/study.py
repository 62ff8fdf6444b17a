"""A reduced study through the program: resumed after an interruption, with a case that fails, and reported."""
import json
import re
import signal
import time

from harness import ROOT, SCRATCH, SystemTest, completed, fresh, hawser, main, started

TOW = """<hawser extends="{base}" title="A tow for tests">
  <parameter name="hold" value="40"/>
  <parameter name="run_time" value="200"/>
  <parameter name="cable_size" value="42"/>
  <mesh> <tow-box far-size="800" growth="0.3"/> </mesh>
  <expect quantity="end_error_m" remove="true"/>
  <expect quantity="total_error_m" remove="true"/>
  <expect quantity="end_error_change_last_quarter_m" remove="true"/>
</hawser>
"""

# A cell that is longer than the cable cannot be meshed: that case fails.
STUDY = """<study title="Reduced" report="deep-tow">
  <sweep name="mesh" deck="tow.xml" meaning="Segment length.">
    <set path="run_time" value="60"/>
    <vary path="cable_size" values="{sizes}"/>
  </sweep>
  <sweep name="tow" deck="tow.xml" meaning="Current and angle.">
    <vary path="current" values="0.5 1"/>
    <vary path="tow_angle" values="0 90"/>
  </sweep>
</study>
"""

# The same tows on two coarser meshes: the report extrapolates their forces.
COARSER = """  <sweep name="coarser" deck="tow.xml">
    <vary path="current" values="0.5 1"/>
    <vary path="tow_angle" values="0 90"/>
    <vary path="mesh_scale" values="2 1.4142"/>
  </sweep>
</study>
"""


def study(name, sizes="500 42", more="</study>\n"):
    path = SCRATCH / f"{name}.xml"
    path.parent.mkdir(parents=True, exist_ok=True)
    (path.parent / "tow.xml").write_text(TOW.format(base=ROOT / "inputs/deep_tow/base.xml"))
    path.write_text(STUDY.format(sizes=sizes).replace("</study>\n", more))
    return path


def record(folder):
    return {f"{sweep['name']}/{case['name']}": case for sweep in json.loads((folder / "study.json").read_text())["sweeps"]
            for case in sweep["cases"]}


def study_after(cases, deck, folder):
    """The process of a study, one run at a time, of which that many cases have ended."""
    process = started(1, "study", deck, "-o", folder, "-j", "1")
    for line in process.stdout:
        if line.startswith(f"[{cases}/"):
            break
    return process


class Study(SystemTest):
    def test_a_failing_case_does_not_stop_the_others_and_the_report_tells_the_runs_numbers(self):
        folder = fresh("whole")
        done = hawser(1, "study", study("whole", more=COARSER), "-o", folder, seconds=240)
        self.assertEqual(done.returncode, 6, done.stderr)
        self.assertIn("13 cases finished, 0 of them before; 1 failed; 0 not run", done.stdout)
        cases = record(folder)
        self.assertEqual({name for name, case in cases.items() if case["state"] == "failed"}, {"mesh/case_01"})
        self.assertEqual(cases["mesh/case_01"]["exit_code"], 4)
        self.assertIn("exceeds the cable's length", cases["mesh/case_01"]["reason"])

        reported = hawser(1, "report", folder, seconds=240)
        self.assertEqual(reported.returncode, 0, reported.stderr)
        page = (folder / "report/index.html").read_text()
        self.assertNotRegex(page, r'src="(?!data:)|href="')  # self-contained
        rows = dict(re.findall(r'<tr[^>]*id="([^"]+)">(.*?)</tr>', page))
        self.assertIn("exceeds the cable", rows["mesh-case_01"])
        for name, case in cases.items():
            if case["state"] == "finished":
                summary = json.loads((folder / name / "summary.json").read_text())
                for quantity, form in ("end_error_m", "{:.2f}"), ("total_error_m", "{:.2f}"), ("tow_force_n_per_m", "{:.0f}"):
                    self.assertIn(f'<td class="n">{form.format(summary[quantity])}</td>', rows[name.replace("/", "-")])
        self.assertTrue((folder / "report/fig5_total_error.svg").exists())
        for fine, coarse in ("01", ("01", "02")), ("04", ("07", "08")):
            forces = [json.loads((folder / run / "summary.json").read_text())["tow_force_n_per_m"]
                      for run in (*(f"coarser/case_{c}" for c in coarse), f"tow/case_{fine}")]
            self.assertIn(f"<td>{' / '.join(f'{force:.0f}' for force in forces)}</td>", page)
        self.assertTrue((folder / "report/force_limits.svg").exists())

    def test_an_interrupted_study_goes_on_where_it_was(self):
        folder = fresh("parts")
        deck = study("parts", "42 60")
        process = study_after(2, deck, folder)
        time.sleep(0.3)
        process.send_signal(signal.SIGTERM)
        rest = process.communicate(timeout=240)[0]
        self.assertEqual(process.returncode, 75, rest)
        states = [case["state"] for case in record(folder).values()]
        self.assertEqual(states[:2], ["finished"] * 2)
        self.assertIn("waiting", states)
        kept = {path: path.stat().st_mtime_ns for path in folder.glob("*/*/summary.json")}
        done = hawser(1, "study", deck, "-o", folder, seconds=240)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn(f"6 cases finished, {len(kept)} of them before", done.stdout)
        self.assertEqual({path: path.stat().st_mtime_ns for path in kept}, kept)
        # What differs now is run again, and nothing else.
        deck.write_text(deck.read_text().replace('values="42 60"', 'values="42 70"'))
        again = hawser(1, "study", deck, "-o", folder, seconds=240)
        self.assertIn("6 cases finished, 5 of them before", again.stdout)

    def test_a_deck_that_changes_while_the_study_runs_is_noticed(self):
        folder = fresh("changed")
        deck = study("changed", "42 60")
        process = study_after(1, deck, folder)
        tow = deck.parent / "tow.xml"
        tow.write_text(tow.read_text().replace('name="hold" value="40"', 'name="hold" value="60"'))
        rest = process.communicate(timeout=240)[0]
        self.assertEqual(process.returncode, 6, rest)
        cases = list(record(folder).values())
        self.assertEqual(cases[0]["state"], "finished")
        self.assertEqual(cases[-1]["reason"], "a deck was changed while the study ran; start it again")
        done = hawser(1, "study", deck, "-o", folder, seconds=240)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_bad_sweeps_are_told_before_anything_runs(self):
        folder = fresh("bad")
        for old, new, sentence in (
                ("tow_angle", "tow_angel", r".*bad_study\.xml:6:4: sweep 'tow', case_01 .*: .*did you mean 'tow_angle'\?"),
                ('values="0 90"', 'from="3" to="3" count="2"', r".*bad_study\.xml:8:6: the range is empty: from and to are both 3"),
                ("tow.xml", "two.xml", r".*bad_study\.xml:2:4: .*: .*two\.xml: the deck cannot be read[\s\S]*"),
                ('value="60"', 'value="-60"', r".*bad_study\.xml:2:4: sweep 'mesh', case_01 .*: .*must be > 0 s.*")):
            path = study("bad_study", "42")
            path.write_text(path.read_text().replace(old, new))
            done = self.assertFails(3, sentence, 1, "study", path, "-o", folder)
            self.assertEqual(done.stdout, "")
            self.assertFalse(folder.exists())
            self.assertFails(3, sentence, 2, "check", path)

    def test_check_reads_studies(self):
        path = study("checked")
        for ranks in 1, 2:
            self.assertEqual(completed(ranks, "check", path).stdout,
                             f"{path}: no faults in the study and its 6 cases (names of regions and fields are checked when they run)\n")


if __name__ == "__main__":
    main()
