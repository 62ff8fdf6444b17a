"""A run continued from a checkpoint equals the uninterrupted one: to the last bit on the same ranks."""
import re
import shutil
import signal

from harness import ROOT, SCRATCH, Results, SystemTest, completed, difference, edited, fresh, hawser, main, run, started

# The run is stopped at an end of its own, a step after the checkpoint that it is continued from.
PLAIN = dict(output_checkpoint_every="3")
# 20/3 is no binary number, and the run is stopped at the checkpoint itself: its last step must be a whole one.
THIRDS = dict(output_checkpoint_every="3", time_step="6.666666666666667", time_end="66.66666666666667")
# Two iterations cut the first steps. The checkpoint, at 59.88 s, falls between a cut and the growth that a count of good steps brings.
CUT = dict(output_checkpoint_every="2", newton_max_iterations="2", newton_lagged="false", time_end="160", time_grow_after="3",
           output_fields_every="1")
# The length of the steps follows their local error.
STEERED = dict(output_checkpoint_every="4", time_scheme="generalised-alpha", time_step="5", adapt='error="2e-3"',
               output_fields_every="5")


class Restart(SystemTest):
    def pair(self, name, changes, stop, ranks, other_ranks=None):
        """An uninterrupted run, and one that was stopped and continued."""
        deck = edited(name, **changes)
        whole = run(f"{name}.whole.np{ranks}", deck, ranks)
        folder = fresh(f"{name}.parts.np{ranks}")
        completed(ranks, "run", deck, "-o", folder, "-q", "--end", stop)
        stopped_at = Results(folder).history()["t_s"][-1]
        self.assertEqual(stopped_at, float(stop))
        completed(other_ranks or ranks, "restart", folder / "checkpoint.h5", "-q", "--end", changes.get("time_end", "200"))
        return whole, Results(folder)

    def test_on_the_same_ranks(self):
        for ranks in 1, 2:
            with self.subTest(ranks=ranks):
                self.assertSame(*self.pair("plain", PLAIN, "140", ranks))
        self.assertRecorded("same_ranks", "a continued run against the uninterrupted one, on 1 and on 2 ranks: largest difference",
                            0, 0, "compared to the last bit")

    def test_stopped_at_a_step_that_is_no_binary_number(self):
        self.assertSame(*self.pair("thirds", THIRDS, "40", 1))

    def test_while_steps_are_cut(self):
        whole, parts = self.pair("cut", CUT, "69.8828125", 1)
        self.assertGreater(whole.summary()["steps_rejected"], 0)
        self.assertGreater(len(set(whole.history()["step_s"])), 1)
        self.assertSame(whole, parts)

    def test_with_generalised_alpha_and_steered_steps(self):
        whole, parts = self.pair("steered", STEERED, "100", 1)
        lengths = set(whole.history()["step_s"])
        print(f"{len(lengths)} lengths from {min(lengths):.3g} to {max(lengths):.3g} s, rejected",
              whole.summary()["steps_rejected"])
        self.assertGreater(len(lengths), 3)
        self.assertSame(whole, parts)

    def test_in_a_folder_that_was_moved(self):
        deck = edited("moved", **PLAIN)
        before, after = fresh("moved.before"), fresh("moved.after")
        completed(1, "run", deck, "-o", before, "-q", "--end", "140")
        before.rename(after)
        completed(1, "restart", after / "checkpoint.h5", "-q", "--end", "200")
        self.assertEqual(Results(after).history()["t_s"][-1], 200)

    def test_on_other_ranks(self):
        tight = dict(PLAIN, newton_tolerance="1e-11", linear_tolerance="1e-12", linear_keep_factor="false")
        whole, parts = self.pair("other", tight, "140", 2, other_ranks=3)
        there, here = whole.fields(10), parts.fields(10)
        displacement = difference(here["displacement"], there["displacement"])
        force = difference(parts.history()["tow_force_n_per_m"], whole.history()["tow_force_n_per_m"])
        print(f"2 ranks, then 3: displacement {displacement:.1e}, force {force:.1e}")
        self.assertRecorded("displacement", "displacement of a run continued on 3 ranks instead of 2, relative", displacement, 1e-8,
                            "Newton's tolerance 1e-11")
        self.assertRecorded("force", "its tow force, relative", force, 1e-8, "Newton's tolerance 1e-11")
        self.assertGreater(displacement, 0, "not a copy of the same file")


class WhatTheRunUsed(SystemTest):
    """A restart needs nothing but the checkpoint, and goes on with what the run has read, changed or not."""

    def setUp(self):
        chain, self.place = ROOT / "tests/reliability", fresh("inputs")
        (self.place / "base").mkdir(parents=True)
        for name in "chain.xml", "track.csv":
            shutil.copy(chain / name, self.place / "base" / name)
        self.deck = self.place / "deck.xml"  # the table's path is relative to the other deck
        self.deck.write_text('<hawser extends="base/chain.xml"><parameter name="pull" value="1"/></hawser>')
        self.whole, self.folder = fresh("inputs.whole"), fresh("inputs.parts")
        completed(1, "run", self.deck, "-o", self.whole, "-q")
        completed(1, "run", self.deck, "-o", self.folder, "-q", "--end", "100")
        self.checkpoint = self.folder / "checkpoint.h5"

    def goes_on(self, *arguments):
        said = completed(1, "restart", self.checkpoint, "-q", *arguments).stdout
        for name in "history.csv", "cable.xdmf":
            self.assertEqual((self.folder / name).read_text(), (self.whole / name).read_text())
        return said

    def test_files_that_were_edited_are_told(self):
        table = self.place / "base/track.csv"
        table.write_text(table.read_text().replace("400,10,40", "400,510,40"))
        self.deck.write_text("<hawser/>")
        mesh = self.folder / "mesh.msh"
        mesh.write_text(mesh.read_text().replace("-60", "-61"))
        said = self.goes_on("--end", "200")
        self.assertEqual(sorted(re.findall("(.*) has changed since the run began; the run goes on with what it read then", said)),
                         sorted(map(str, (table, self.deck, mesh))))

    def test_files_that_are_gone_are_not_missed(self):
        shutil.rmtree(self.place)
        (self.folder / "mesh.msh").unlink()
        self.assertEqual(self.goes_on("--end", "200"), "")

    def test_in_another_folder_with_nothing_but_the_checkpoint(self):
        there = fresh("inputs.moved")
        there.mkdir()
        shutil.copy(self.checkpoint, there)
        completed(2, "restart", there / "checkpoint.h5", "-q", "--end", "200")
        self.assertEqual(Results(there).history()["t_s"][-1], 200)

    def test_the_resolved_deck_is_what_was_run(self):
        resolved = (self.folder / "resolved.xml").read_text()
        self.assertIn('end="100"', resolved)
        self.goes_on("--set", "time/end=200", "--set", "output/checkpoint-every=3", "--set", "title=On and on")
        resolved = (self.folder / "resolved.xml").read_text()
        for text in 'end="200"', 'checkpoint-every="3"', 'title="On and on"':
            self.assertIn(text, resolved)

    def test_an_end_that_was_given_stays(self):
        self.assertFails(2, ".*/checkpoint.h5 is at t = 100 s, and the run ends at 100 s: nothing is left to do; --end sets "
                            "a later end", 1, "restart", self.checkpoint)

    def test_what_may_not_change_is_refused_by_name(self):
        for ranks in 1, 2:
            for change in "modules/cable/mass-per-length=7", "pull=2", "time/scheme=newmark", "mesh/line/segments=7", \
                    "conditions/prescribe[tow]/table=other.csv", "output/probe[tail]/field=velocity", "time/adapter/error=1":
                with self.subTest(ranks=ranks, change=change):
                    path = change.split("=")[0]
                    self.assertFails(3, rf"--set {re.escape(change)}: a run that goes on keeps its (parameter )?'{re.escape(path)}'; "
                                        "allowed: .*time/end.* A deck with <start from=.*", ranks,
                                     "restart", self.checkpoint, "--end", "200", "--set", change)
        self.assertFails(3, "--set solver/newton/tolerence=1: .*did you mean 'tolerance'.*", 1,
                         "restart", self.checkpoint, "--end", "200", "--set", "solver/newton/tolerence=1")

    def test_a_damaged_one_falls_back_to_the_one_before(self):
        whole = self.checkpoint.read_bytes()
        damaged = bytearray(whole)
        damaged[len(whole) // 2] ^= 4
        self.checkpoint.write_bytes(damaged)
        said = self.goes_on("--end", "200")
        self.assertRegex(said, rf"{self.checkpoint} is damaged: it is not what was written; going on from the checkpoint "
                               r"before it, .*/checkpoint.previous.h5, t = 80 s")
        completed(1, "restart", self.folder / "checkpoint.previous.h5", "-q", "--end", "220")

    def test_both_damaged_are_refused_with_both_reasons(self):
        for name in "checkpoint.h5", "checkpoint.previous.h5":
            path = self.folder / name
            path.write_bytes(path.read_bytes()[:-1])
        self.assertFails(7, ".*/checkpoint.h5 is damaged: .*; and the one before it is of no use, either: "
                            ".*/checkpoint.previous.h5 is damaged: .*", 1, "restart", self.checkpoint)


class Stopped(SystemTest):
    def test_by_the_clock(self):
        deck, folder = edited("clock", time_end="4000", output_fields_every="0"), fresh("clock")
        for ranks in 1, 2:
            self.assertFails(75, r"stopped by --stop-after at t = .* s; go on with: hawser restart .*/checkpoint.h5", ranks,
                             "run", deck, "-q", "-f", "-o", folder, "--stop-after", "0.5s")
        done = hawser(1, "run", deck, "-o", folder, "--stop-after", "5 parsecs")
        self.assertEqual(done.returncode, 2)
        self.assertIn("'5 parsecs' is no time; needed is one such as 5h50m", done.stderr)

    def test_a_run_whose_log_nobody_reads_goes_on(self):
        deck, folder = edited("unread"), fresh("unread")
        whole = run("unread.whole", deck)
        with started(1, "run", deck, "-o", folder) as process:
            process.stdout.close()
            self.assertEqual(process.wait(timeout=60), 0)
        self.assertSame(whole, Results(folder))

    def test_a_hang_up_stops_it_unless_it_was_started_to_outlive_its_terminal(self):
        deck, folder = edited("hung_up", time_end="2000", output_fields_every="0"), fresh("hung_up")
        for ignored in False, True:
            before = signal.signal(signal.SIGHUP, signal.SIG_IGN if ignored else signal.SIG_DFL)
            try:
                process = started(1, "run", deck, "-q", "-f", "-o", folder, *(["--end", "200"] if ignored else []))
            finally:
                signal.signal(signal.SIGHUP, before)
            with process:
                while not (folder / "history.csv").exists():
                    pass
                process.send_signal(signal.SIGHUP)
                _, err = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 0 if ignored else 75, err)

    def test_results_that_cannot_be_written_leave_a_checkpoint(self):
        deck, folder = edited("barred", output_checkpoint_every="0", output_fields_every="10"), fresh("barred")
        whole = run("barred.whole", deck)
        for ranks in 1, 2:
            shutil.rmtree(folder, ignore_errors=True)
            (folder / "flow-000010.h5.unfinished").mkdir(parents=True)  # nothing can be written there
            self.assertFails(7, "cannot open .*flow-000010.h5.unfinished: Is a directory; when that is mended, go on with: "
                                "hawser restart .*/checkpoint.h5", ranks, "run", deck, "-q", "-o", folder)
            (folder / "flow-000010.h5.unfinished").rmdir()
            completed(ranks, "restart", folder / "checkpoint.h5", "-q")
            self.assertEqual(Results(folder).steps(), whole.steps())
            self.assertEqual(Results(folder).summary()["steps"], whole.summary()["steps"])

    def test_so_does_a_summary(self):
        deck, folder = edited("summary"), fresh("summary")
        folder.mkdir(parents=True)
        with started(1, "run", deck, "-q", "-o", folder) as process:
            while not (folder / "history.csv").exists():
                pass
            (folder / "summary.json.unfinished").mkdir()
            _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 7)
        self.assertRegex(err, "summary.json.unfinished: Is a directory; when that is mended, go on with: hawser restart")
        (folder / "summary.json.unfinished").rmdir()
        completed(1, "restart", folder / "checkpoint.h5", "-q")
        self.assertEqual(Results(folder).history()["t_s"][-1], 200)


if __name__ == "__main__":
    main()
