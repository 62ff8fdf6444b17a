"""Runs a deck and compares its summary.json with the deck's reference (see cmake/hawser_regression.cmake).

python3 tests/regression/regression.py deep_tow/case_02_quick --ranks 2
"""
import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def reference_path(deck):
    return ROOT / "tests/regression/references" / f"{deck}.json"


def run(deck, ranks, build):
    """Returns the summary of a run, or ends this program as `hawser` ended."""
    folder = Path(build) / "tests/run" / f"{deck.replace('/', '.')}.np{ranks}"
    environment = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                   "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    command = ["mpirun", "-np", str(ranks), "--oversubscribe", "--bind-to", "none",
               str(Path(build).resolve() / "bin/hawser"), "run", str(ROOT / "inputs" / f"{deck}.xml"),
               "--output", str(folder), "--force"]
    code = subprocess.run(command, env={**os.environ, **environment}, stdin=subprocess.DEVNULL).returncode
    if code != 0:
        sys.exit(f"{' '.join(command)}\nended with exit code {code}")
    return json.loads((folder / "summary.json").read_text())


def look_up(summary, quantity):
    """The number called "timings.wall_s" or "end_error_m"; None when there is none."""
    value = summary
    for key in quantity.split("."):
        value = value.get(key) if isinstance(value, dict) else None
    return float(value) if isinstance(value, (int, float)) else None


def tolerance(entry):
    """In the quantity's own unit."""
    if ("absolute" in entry) == ("relative" in entry):
        sys.exit(f"a reference needs either 'absolute' or 'relative': {entry}")
    return entry["absolute"] if "absolute" in entry else abs(entry["value"]) * entry["relative"]


def compare(summary, quantities):
    """Prints one line per quantity; returns the names of those that fail."""
    row = "{:34} {:>16} {:>16} {:>10} {:>10}  {}"
    print(row.format("quantity", "reference", "got", "difference", "tolerance", ""))
    failed = []
    for name, entry in quantities.items():
        got, allowed = look_up(summary, name), tolerance(entry)
        good = got is not None and abs(got - entry["value"]) <= allowed
        print(row.format(name, f"{entry['value']:.9g}", "missing" if got is None else f"{got:.9g}",
                         "" if got is None else f"{got - entry['value']:.2e}", f"{allowed:.2e}",
                         "" if good else "FAILS"))
        if not good:
            failed.append(name)
    return failed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("deck", help="below inputs/, without .xml")
    parser.add_argument("--ranks", type=int, default=1)
    parser.add_argument("--build", default=ROOT / "build")
    given = parser.parse_args()
    path = reference_path(given.deck)
    if not path.exists():
        sys.exit(f"there is no reference {path}: make one with tests/regression/renew.py")
    quantities = json.loads(path.read_text())["quantities"]
    if not quantities:
        sys.exit(f"{path} compares nothing")
    if failed := compare(run(given.deck, given.ranks, given.build), quantities):
        sys.exit(f"{given.deck} on {given.ranks} ranks differs in: {', '.join(failed)}")


if __name__ == "__main__":
    main()
