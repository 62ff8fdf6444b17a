"""How often the program keeps its word. Each figure prints "N of N" and fails when one trial does.

python3 tests/reliability/reliability.py kills --whole --build build     # 300 kills, as under the label slow
python3 tests/reliability/reliability.py kills --short --build build     # a few of them, as in the suite
python3 tests/reliability/reliability.py all --whole --build build --seed 7
"""
import sys

import trials  # noqa: F401  parses --build
from harness import parser

import files
import processes
import states

# figure: (its function, trials of the whole form, of the short one)
FIGURES = {
    "kills": (processes.kills, 300, 9),
    "signals": (processes.signals, 50, 1),
    "locks": (processes.locks, 100, 3),
    "disks": (files.disks, 50, 10),
    "flips": (files.flips, 1000, 20),
    "mutants": (files.mutants, 300, 6),
    "newton": (states.newton, 50, 2),
    "inversions": (states.inversions, 100, 3),
    "ranks": (states.ranks, 6, 2),
    "growth": (states.growth, 10000, 2000),
}

parser.add_argument("figure", choices=[*FIGURES, "all"])
form = parser.add_mutually_exclusive_group()
form.add_argument("--whole", action="store_true")
form.add_argument("--short", action="store_true")
parser.add_argument("--count", type=int, help="of trials, instead of the form's")
parser.add_argument("--seed", type=int)


def main():
    given = parser.parse_args()
    good = True
    for name in FIGURES if given.figure == "all" else [given.figure]:
        work, whole, short = FIGURES[name]
        good = work(given.count or (whole if given.whole else short), given.seed) and good
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
