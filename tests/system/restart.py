"""A run continued from a checkpoint equals the uninterrupted one: to the last bit on the same ranks."""
from harness import Results, SystemTest, completed, difference, edited, fresh, main, run

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


if __name__ == "__main__":
    main()
