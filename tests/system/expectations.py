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
        return done.stdout.splitlines(), Results(folder).summary()

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
            self.assertRegex(done.stderr, r"never.xml:\d+:\d+: nothing here reports a quantity 'lift_n'; there are step, ")
            self.assertFalse((folder / "summary.json").exists())


if __name__ == "__main__":
    main()
