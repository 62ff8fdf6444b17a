"""An edge of a condition's time window changes the steps before it, not the answer."""
import unittest

from harness import DECKS, SCRATCH, main, run

TOW = (DECKS / "tow.xml").read_text()


def with_edge(time):
    """The tow with a condition that ends at that time, and says what holds anyway until then."""
    SCRATCH.mkdir(parents=True, exist_ok=True)
    deck = SCRATCH / f"edge_{time}.xml"
    deck.write_text(TOW.replace(
        "</conditions>", f'<prescribe field="displacement" on="sides" until="{time}" value="0 0"/></conditions>'))
    return deck


class Steps(unittest.TestCase):
    def test_just_after_a_step(self):
        """Cut to a sliver, the step before the edge would spoil the rates of all that follow."""
        plain = run("plain", DECKS / "tow.xml", 1, "--end", "200").history()
        for time in "100.0000001", "100.001", "102":
            with self.subTest(time=time):
                history = run(f"edge_{time}", with_edge(time), 1, "--end", "200").history()
                self.assertAlmostEqual(history["end_error_m"][-1], plain["end_error_m"][-1], delta=1)
                self.assertGreaterEqual(history["step_s"].min(), 10)

    def test_at_a_step(self):
        """To the last bit where no Jacobian is kept: other rows are prescribed after the edge, which ends a kept one."""
        exact = "--end", "200", "--set", "solver/newton/lagged=false"
        plain = run("plain", DECKS / "tow.xml", 1, *exact).history()
        history = run("edge_100", with_edge("100"), 1, *exact).history()
        self.assertEqual(list(history["t_s"]), list(plain["t_s"]))
        self.assertEqual(list(history["end_error_m"]), list(plain["end_error_m"]))


if __name__ == "__main__":
    main()
