"""<expect> in a deck judges the run: exit code 8 unless every one holds."""
import unittest

from harness import Results, edited, fresh, hawser, main

HOLDS = '<expect quantity="cable_length_m" value="420" within="5" why="it hardly stretches"/>'
FAILS = '<expect quantity="end_time_s" value="21" within="0.5" why="a mistake"/>'
NEVER = '<expect quantity="lift_n" value="0" within="1e9" why="no such quantity"/>'


class Expectations(unittest.TestCase):
    def judged(self, name, expectations, code, ranks):
        deck, folder = edited(name, time_end="20", inside=expectations), fresh(name)
        done = hawser(ranks, "run", deck, "-q", "-o", folder)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return (done.stdout + done.stderr).splitlines(), Results(folder).summary()

    def test_that_holds(self):
        for ranks in 1, 2:
            said, summary = self.judged("holds", HOLDS, 0, ranks)
            self.assertEqual(said, [])
            self.assertEqual(summary["expectations_failed"], 0)
            self.assertTrue(summary["expectations"]["cable_length_m"]["holds"])

    def test_that_fails(self):
        for ranks in 1, 2:
            said, summary = self.judged("fails", HOLDS + FAILS, 8, ranks)
            self.assertEqual(len(said), 1)
            self.assertRegex(said[0], r"fails.xml:\d+:\d+: expected end_time_s = 21 \+- 0.5 \(a mistake\); got 20: FAILS")
            self.assertEqual(summary["expectations_failed"], 1)
            self.assertFalse(summary["expectations"]["end_time_s"]["holds"])

    def test_of_a_quantity_that_nothing_reports_is_refused_before_the_run(self):
        for ranks in 1, 2:
            deck, folder = edited("never", time_end="20", inside=NEVER), fresh("never")
            done = hawser(ranks, "run", deck, "-q", "-o", folder)
            self.assertEqual(done.returncode, 3, done.stdout + done.stderr)
            self.assertRegex(done.stderr, r"never.xml:\d+:\d+: nothing here reports a quantity 'lift_n'; there are end_time_s, ")
            self.assertFalse((folder / "summary.json").exists())

    def test_a_shortened_run_is_not_judged(self):
        deck, folder = edited("shortened", time_end="40", inside=FAILS), fresh("shortened")
        done = hawser(1, "run", deck, "-o", folder, "--end", "20")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("the deck's expectations are for its own end, t = 40 s; this run ends before and is not judged", done.stdout)
        self.assertNotIn("expectations_failed", Results(folder).summary())
        self.assertEqual(hawser(1, "run", deck, "-q", "-f", "-o", folder, "--end", "40").returncode, 8)

    def test_one_can_be_dropped_from_the_command_line(self):
        deck, folder = edited("dropped", time_end="20", inside=FAILS), fresh("dropped")
        done = hawser(1, "run", deck, "-q", "-o", folder, "--set", "expect[end_time_s]=")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_what_fails_is_told_where_errors_are(self):
        deck = edited("stream", time_end="20", inside=FAILS)
        done = hawser(1, "run", deck, "-q", "-o", fresh("stream"))
        self.assertEqual(done.stdout, "")
        self.assertIn("got 20: FAILS", done.stderr)


if __name__ == "__main__":
    main()
