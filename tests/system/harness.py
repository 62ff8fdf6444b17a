"""Runs the real program for tests; every file it makes lies below the build folder."""
import argparse
import csv
import json
import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import h5py
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
DECKS = ROOT / "tests/system/decks"

sys.path.insert(0, str(ROOT / "tests/support"))
import figures  # noqa: E402

parser = argparse.ArgumentParser()
parser.add_argument("--build", type=Path, default=ROOT / "build")
BUILD = parser.parse_known_args()[0].build.resolve()
SCRATCH = BUILD / "tests/run" / Path(sys.argv[0]).stem

ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_mpi_yield_when_idle": "1", "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


def command_line(ranks, *arguments):
    launcher = ["mpirun", "-q", "-np", str(ranks), "--oversubscribe", "--bind-to", "none"]
    return launcher * (ranks > 1) + [str(BUILD / "bin/hawser"), *map(str, arguments)]


def hawser(ranks, *arguments, folder=None, seconds=60):
    """The finished process: returncode, stdout, stderr. A run that hangs is a failure."""
    return subprocess.run(command_line(ranks, *arguments), cwd=folder, env=ENVIRONMENT, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=seconds)


def started(ranks, *arguments, **environment):
    """The process as it begins; mpirun when there are several ranks."""
    return subprocess.Popen(command_line(ranks, *arguments), env={**ENVIRONMENT, **environment}, text=True,
                            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def ranks_of(process):
    """The numbers of the processes that mpirun started."""
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    return [int(child) for child in children if Path(f"/proc/{child}/comm").read_text() == "hawser\n"]


def edited(name, deck="tow.xml", **changes):
    """A copy of a deck in the scratch folder with attributes changed: time_end="40" sets the `end` of
    <time>, inside="..." puts elements before </hawser> and adapt="..." the element <adapt> into <time/>."""
    text = (DECKS / deck).read_text()
    inside = changes.pop("inside", "")
    adapt = changes.pop("adapt", "")
    for key, value in changes.items():
        tag, attribute = key.split("_", 1)
        text = with_attribute(text, tag.replace("_", "-"), attribute.replace("_", "-"), value)
    if adapt:
        text = re.sub(r"<time\b([^>]*)/>", rf"<time\1><adapt {adapt}/></time>", text)
    path = SCRATCH / f"{name}.xml"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text.replace("</hawser>", inside + "</hawser>"))
    return path


def with_attribute(text, tag, attribute, value):
    start = re.search(rf"<{tag}\b[^>]*?(?=/?>)", text)
    if start is None:
        raise ValueError(f"the deck has no <{tag}>")
    element = re.sub(rf'\s{attribute}="[^"]*"', "", start.group())
    return text[:start.start()] + f'{element} {attribute}="{value}"' + text[start.end():]


def fresh(name):
    """The path of a result folder that is not there."""
    folder = SCRATCH / name
    shutil.rmtree(folder, ignore_errors=True)
    return folder


def completed(ranks, *arguments, **options):
    """Runs what must succeed."""
    done = hawser(ranks, *arguments, **options)
    if done.returncode != 0:
        raise AssertionError(f"hawser {arguments} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done


class Results:
    """What a run left in its folder."""

    def __init__(self, folder):
        self.folder = Path(folder)

    def table(self, name):
        """Columns of a CSV file by name."""
        with open(self.folder / name, newline="") as file:
            rows = list(csv.reader(file))
        values = np.array(rows[1:], dtype=float).reshape(len(rows) - 1, len(rows[0]))
        return dict(zip(rows[0], values.T))

    def history(self):
        return self.table("history.csv")

    def summary(self):
        return json.loads((self.folder / "summary.json").read_text())

    def steps(self, grid="flow"):
        return sorted(int(path.stem.rsplit("-", 1)[1]) for path in self.folder.glob(f"{grid}-*.h5"))

    def fields(self, step, grid="flow"):
        """Points, cells and fields by name; rows are ordered by numbers that no rank count changes."""
        with h5py.File(self.folder / f"{grid}-{step:06d}.h5") as file:
            return {"points": file["points"][:], "cells": file["cells"][:],
                    **{name: data[:] for name, data in file["fields"].items()}}


def run(name, deck, ranks=1, *arguments):
    """Results of a deck in a folder of their own."""
    folder = fresh(name)
    completed(ranks, "run", deck, "-o", folder, "-q", *arguments)
    return Results(folder)


def difference(a, b):
    """Largest difference, relative to the largest value."""
    return float(np.abs(a - b).max() / max(np.abs(b).max(), np.finfo(float).tiny))


COUNTS = ("steps", "steps_rejected", "newton_iterations", "linear_iterations", "mesh_quality_min", "courant_max",
          "end_error_m", "end_error_change_last_quarter_m", "tow_force_n_per_m")


class SystemTest(unittest.TestCase):
    def assertRecorded(self, name, what, value, tolerance, source, unit="1"):
        """A difference that must not be larger, for doc/verification.md."""
        test = f"system.{Path(sys.argv[0]).stem}"
        self.assertTrue(figures.record(BUILD, f"{test}.{name}", "Ranks, repetition, restart", what, value, 0, tolerance, source,
                                       f"ctest --test-dir build -R '^{test}$'", unit, is_="at-most"),
                        f"{what}: {value}, allowed {tolerance}")

    def assertFails(self, code, sentence, ranks, *arguments):
        """One line on stderr that matches the regular expression, whatever the number of ranks."""
        done = hawser(ranks, *arguments)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertRegex(done.stderr, rf"\A{sentence}\n\Z")
        return done

    def assertSame(self, whole, parts):
        """Two runs left the same, to the last bit."""
        for table in "history.csv", "cable.csv":
            self.assertEqual((parts.folder / table).read_text(), (whole.folder / table).read_text(), table)
        a, b = whole.summary(), parts.summary()
        self.assertEqual({name: b[name] for name in COUNTS}, {name: a[name] for name in COUNTS})
        for grid in "flow", "cable":
            self.assertEqual(parts.steps(grid), whole.steps(grid))
            self.assertEqual((parts.folder / f"{grid}.xdmf").read_text(), (whole.folder / f"{grid}.xdmf").read_text())
            for step in whole.steps(grid):
                there, here = whole.fields(step, grid), parts.fields(step, grid)
                for name in there:
                    np.testing.assert_array_equal(here[name], there[name], f"{grid} {name}, step {step}", strict=True)


def main():
    unittest.main(argv=sys.argv[:1] + parser.parse_known_args()[1], verbosity=2)
