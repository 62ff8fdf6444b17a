"""Every deck here has a fault; what the program says about it is pinned in a file beside it.

python3 tests/bad_decks/bad_decks.py --build build --ranks 3
python3 tests/bad_decks/bad_decks.py --build build --renew      # write what it says now; see git diff

missing_attribute.expected holds the command, the exit code and the message, word for word:
    hawser check missing_attribute.xml
    exit code 3
    missing_attribute.xml:8:6: <ale-fluid> needs the attribute 'viscosity' ...
`run` stands instead of `check` where the mesh must be known for the fault to be seen.
"""
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "system"))
import harness

harness.parser.add_argument("--ranks", type=int, default=1)
harness.parser.add_argument("--renew", action="store_true")
given = harness.parser.parse_args()


def answer(verb, deck):
    """Command, exit code and message."""
    output = ["-q", "--force", "-o", harness.SCRATCH / f"np{given.ranks}"] if verb == "run" else []
    done = harness.hawser(given.ranks, verb, deck.name, *output, "--plugin-dir", "plugins", folder=HERE)
    return f"hawser {verb} {deck.name}\nexit code {done.returncode}\n{done.stderr}"


def renewed(deck):
    """By the first verb that sees a fault."""
    checked = answer("check", deck)
    return answer("run", deck) if "exit code 0" in checked else checked


class BadDecks(unittest.TestCase):
    maxDiff = None

    def test_every_fault_is_told_once_and_alike_on_any_number_of_ranks(self):
        decks = sorted(HERE.glob("*.xml"))
        self.assertGreater(len(decks), 50)
        for deck in decks:
            with self.subTest(deck=deck.name, ranks=given.ranks):
                pinned = deck.with_suffix(".expected")
                if given.renew:
                    pinned.write_text(renewed(deck))
                expected = pinned.read_text()
                verb = expected.split()[1]
                self.assertNotIn("exit code 0", expected)
                self.assertEqual(answer(verb, deck), expected)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
