"""What the verbs say: to a person, to a program, on a terminal and into a pipe."""
import json
import os
import pty
import re
import subprocess

from harness import BUILD, DECKS, ENVIRONMENT, SCRATCH, Results, SystemTest, completed, edited, fresh, hawser, main

CUT = dict(newton_lagged="false", newton_max_iterations="2", time_end="60", output_checkpoint_every="2")  # some steps are rejected


def on_a_terminal(*arguments, **environment):
    """What the program writes when standard output is a terminal."""
    ours, its = pty.openpty()
    with subprocess.Popen([str(BUILD / "bin/hawser"), *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=its,
                          stderr=its, env={**ENVIRONMENT, "TERM": "xterm", "NO_COLOR": "", **environment}):
        os.close(its)
        said = b""
        try:
            while piece := os.read(ours, 65536):
                said += piece
        except OSError:
            pass  # the other side is closed
    os.close(ours)
    return said.decode()


class Help(SystemTest):
    def test_fits_on_a_screen_and_has_an_example_for_each_verb(self):
        everything = completed(1, "--help").stdout
        verbs = re.findall(r"^  (\w+) ", everything.split("Subcommands:")[1], re.M)
        self.assertLessEqual({"run", "restart", "check", "mesh", "info", "modules", "describe"}, set(verbs))
        for verb in verbs:
            said = completed(1, verb, "--help").stdout
            self.assertRegex(said, rf"\nExamples?: .*hawser {verb}\b")
            self.assertLessEqual(said.count("\n"), 32, said)
        self.assertLessEqual(everything.count("\n"), 24)

    def test_once_under_mpirun(self):
        self.assertEqual(completed(2, "--version").stdout, completed(1, "--version").stdout)
        self.assertEqual(completed(2, "modules").stdout, completed(1, "modules").stdout)


class JsonLog(SystemTest):
    def events(self, ranks, code, *arguments):
        done = hawser(ranks, *arguments, "--log-json")
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def test_tells_what_the_history_tells(self):
        for ranks in 1, 2:
            folder = fresh("json")
            events = self.events(ranks, 0, "run", edited("json", **CUT), "-o", folder)
            of = lambda kind: [event for event in events if event["event"] == kind]
            history, summary = Results(folder).history(), Results(folder).summary()
            (start,) = of("start")
            self.assertEqual((start["ranks"], start["unknowns"]), (ranks, summary["unknowns"]))
            for key, column in ("time_s", "t_s"), ("step_s", "step_s"), ("newton_iterations",) * 2, \
                    ("linear_iterations",) * 2:
                self.assertEqual([step[key] for step in of("step")], list(history[column]), key)
            self.assertGreater(summary["steps_rejected"], 0)
            self.assertEqual(len(of("rejected")), summary["steps_rejected"])
            self.assertRegex(of("rejected")[0]["reason"], "Newton: no convergence in 2 iterations")
            self.assertEqual([event["step"] for event in of("output") if event["what"] == "checkpoint"],
                             [step["step"] for step in of("step") if step["step"] % 2 == 0])
            self.assertEqual(events[-1]["event"], "end")
            self.assertEqual(events[-1]["summary"], summary)
            phases = summary["timings"]
            self.assertEqual(list(phases), ["setup_s", "residual_s", "tangent_s", "factor_s", "linear_solve_s",
                                            "newton_rest_s", "output_s"])
            self.assertGreater(min(phases.values()), 0)  # the rest is none if they overlap
            self.assertLessEqual(sum(phases.values()), summary["wall_s"])

    def test_an_error_is_the_last_event(self):
        deck = edited("json_fails", newton_max_iterations="1", newton_tolerance="1e-12", time_least_step="20")
        events = self.events(2, 6, "run", deck, "-o", fresh("json_fails"))
        self.assertEqual([event["event"] for event in events], ["note", "start", "rejected", "output", "error"])
        self.assertEqual(events[-1]["exit_code"], 6)
        self.assertRegex(events[-1]["message"], "the least step was reached")


class Terminal(SystemTest):
    def test_colours_and_a_bar_on_a_terminal_only(self):
        deck = edited("terminal", **CUT)
        run = lambda **environment: on_a_terminal("run", deck, "-f", "-o", fresh("terminal"), **environment)
        coloured, plain = run(), run(NO_COLOR="1")
        self.assertIn("\033[33mstep of ", coloured)
        self.assertIn("[##############################] 100 %", coloured)
        self.assertNotRegex(plain, r"\033\[\d+m")
        self.assertIn("100 %", plain)
        for other in run(TERM="dumb"), completed(1, "run", deck, "-f", "-o", fresh("terminal")).stdout, \
                completed(2, "run", deck, "-f", "-o", fresh("terminal")).stdout:
            self.assertIn("step    1", other)
            self.assertNotIn("\033", other)
            self.assertNotIn(" %", other)

    def test_verbose_and_quiet(self):
        deck = edited("verbose", time_end="40")
        lines = lambda flag: completed(1, "run", deck, "-o", fresh("verbose"), flag).stdout
        self.assertEqual(lines("-q"), "")
        said = lines("-v")
        iterations = Results(SCRATCH / "verbose").history()["newton_iterations"].sum()
        self.assertEqual(len(re.findall(r"\n  iteration ", said)), iterations + 2)  # and the start of each step
        self.assertIn("wrote fields of step 2, t = 40 s", said)


class BeforeARun(SystemTest):
    def test_dry_run_counts_and_writes_nothing(self):
        folder = fresh("dry")
        said = completed(2, "run", DECKS / "tow.xml", "-o", folder, "--dry-run").stdout
        self.assertFalse(folder.exists())
        summary = Results(fresh("dry"))
        completed(2, "run", DECKS / "tow.xml", "-o", folder, "-q", "--end", "20")
        summary = summary.summary()
        counts = [int(count) for count in re.findall(r"(?:displacement|velocity|pressure) (\d+)", said)]
        self.assertEqual(sum(counts), summary["unknowns"])
        self.assertIn(f" {summary['unknowns']} in all, on {summary['nodes']} nodes\n", said)
        courant = float(re.search(r"first step  20 s, Courant number up to ([\d.]+)", said).group(1))
        self.assertAlmostEqual(courant / summary["courant_max"], 1, delta=0.1)  # before and after that step
        self.assertRegex(said, r"memory +about \d+ MB on 2 rank")

    def test_mesh_alone(self):
        file = SCRATCH / "alone.msh"
        file.unlink(missing_ok=True)
        said = completed(1, "mesh", DECKS / "tow.xml", "-o", file).stdout
        results = fresh("alone")
        completed(1, "run", DECKS / "tow.xml", "-o", results, "-q", "--end", "20")
        self.assertEqual((results / "mesh.msh").read_text(), file.read_text())
        summary = Results(results).summary()
        self.assertIn(f"{summary['nodes']} nodes, ", said)
        self.assertRegex(said, r"\n  cable +10 segments\n")
        self.assertFails(7, f"{file} is there already; .*--force.*", 1, "mesh", DECKS / "tow.xml", "-o", file)
        self.assertFails(2, "where to\\? .*", 1, "mesh", DECKS / "tow.xml")

    def test_a_line_in_space(self):
        SCRATCH.mkdir(parents=True, exist_ok=True)
        deck = SCRATCH / "line.xml"
        deck.write_text("""<hawser>
  <mesh><line from="0 0 0" to="0 30 -40" segments="10"/></mesh>
  <modules><cable region="cable" mass-per-length="60" axial-stiffness="1e7" bending-stiffness="0"/></modules>
  <conditions><prescribe field="displacement" on="tow-point" value="0 0 0"/></conditions>
  <time step="0.1" end="0.3"/>
</hawser>""")
        said = completed(1, "mesh", deck, "-f", "-o", SCRATCH / "line.msh").stdout
        self.assertRegex(said, r"\A11 nodes\n  cable +10 segments\n  tow-point +1 point\n")
        said = completed(2, "run", deck, "--dry-run").stdout
        self.assertIn("displacement 33, velocity 33: 66 in all, on 11 nodes\n", said)
        self.assertIn("at least 3 steps to t = 0.3 s\n", said)
        self.assertNotIn("equilateral", said)


class Info(SystemTest):
    def test_of_a_finished_and_of_an_unfinished_run(self):
        folder = fresh("info")
        deck = edited("info", time_end="40", output_checkpoint_every="1")
        completed(2, "run", deck, "-o", folder, "-q")
        said = completed(1, "info", folder).stdout
        summary = Results(folder).summary()
        for fact in (f"{folder}: a finished run", "on 2 rank(s)", summary["provenance"]["git_revision"], str(deck),
                     "flow: 1 output(s), t = 40 to 40 s: displacement (m), pressure (Pa), velocity (m/s)",
                     "history.csv: 2 rows to t = 40 s", "checkpoint  step 2, t = 40 s"):
            self.assertIn(fact, said)
        self.assertRegex(said, r"end_error_m +" + re.escape(f"{summary['end_error_m']:.6g}"))
        (folder / "summary.json").unlink()
        self.assertIn(f"{folder}: an unfinished run", completed(2, "info", folder).stdout)
        said = completed(1, "info", folder / "checkpoint.h5").stdout
        self.assertIn("a checkpoint", said)
        self.assertIn(summary["provenance"]["git_revision"], said)

    def test_of_something_else(self):
        for ranks in 1, 2:
            self.assertFails(7, "/nowhere is not there; give a result folder or a checkpoint", ranks, "info", "/nowhere")
            self.assertFails(7, f"{DECKS} is no result folder: .*", ranks, "info", DECKS)
            self.assertFails(7, ".*/tow.xml is not a checkpoint: .*", ranks, "info", DECKS / "tow.xml")


if __name__ == "__main__":
    main()
