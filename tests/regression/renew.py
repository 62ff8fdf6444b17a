"""Renews the reference of a deck from a run, and shows what changes.

python3 tests/regression/renew.py deep_tow/case_02_quick
python3 tests/regression/renew.py deep_tow/case_02_quick --add end_error_m --relative 1e-6
"""
import argparse
import json
import sys

import regression


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("deck", help="below inputs/, without .xml")
    parser.add_argument("--ranks", type=int, default=1)
    parser.add_argument("--build", default=regression.ROOT / "build")
    parser.add_argument("--add", nargs="+", default=[], metavar="QUANTITY", help="compare these too")
    bound = parser.add_mutually_exclusive_group()
    bound.add_argument("--absolute", type=float, help="tolerance of the added, in their unit")
    bound.add_argument("--relative", type=float, help="tolerance of the added")
    given = parser.parse_args()
    if given.add and given.absolute is None and given.relative is None:
        parser.error("--add needs --absolute or --relative")

    path = regression.reference_path(given.deck)
    quantities = json.loads(path.read_text())["quantities"] if path.exists() else {}
    if not quantities and not given.add:
        parser.error(f"there is no {path} yet: say what to compare with --add")
    summary = regression.run(given.deck, given.ranks, given.build)
    regression.compare(summary, quantities)

    bound = {"absolute": given.absolute} if given.relative is None else {"relative": given.relative}
    for name in given.add:
        quantities[name] = bound.copy()
    for name, entry in quantities.items():
        value = regression.look_up(summary, name)
        if value is None:
            sys.exit(f"the summary has no number '{name}'; the reference stays as it was")
        quantities[name] = {"value": value, **{k: v for k, v in entry.items() if k != "value"}}
    path.parent.mkdir(parents=True, exist_ok=True)
    lines = [f"    {json.dumps(name)}: {json.dumps(entry)}" for name, entry in quantities.items()]
    path.write_text('{\n  "quantities": {\n' + ",\n".join(lines) + "\n  }\n}\n")
    print(f"written: {path}")


if __name__ == "__main__":
    main()
