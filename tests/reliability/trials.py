"""What the trials share: a run left alone, results compared to the last bit, runs with faults."""
import os
import random
import shutil
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "system"))
import harness  # noqa: E402
from harness import BUILD, ENVIRONMENT, SCRATCH, Results, command_line, fresh  # noqa: E402,F401

DECK = HERE / "chain.xml"
INTERVAL = 4  # steps between checkpoints of DECK


class Count:
    """Trials that went as promised, of all that were made."""

    def __init__(self, what):
        self.what, self.good, self.all, self.failures = what, 0, 0, []

    def add(self, fault):
        """`fault`: None, or what went wrong."""
        self.all += 1
        if fault is None:
            self.good += 1
        else:
            self.failures.append(fault)
            print(f"  FAILED: {fault}", flush=True)

    def report(self):
        print(f"{self.what}: {self.good} of {self.all}", flush=True)
        return self.good == self.all


def environment(fault=None, where=None, after=0):
    if fault is None:
        return ENVIRONMENT
    return {**ENVIRONMENT, "LD_PRELOAD": str(BUILD / "tests/lib/hawser_faults.so"), "HAWSER_FAULT": fault,
            "HAWSER_FAULT_IN": str(where), "HAWSER_FAULT_AFTER": str(after)}


def start(*arguments, ranks=1, **options):
    options = {"env": ENVIRONMENT, "stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE,
               "text": True, **options}
    return subprocess.Popen(command_line(ranks, *arguments), **options)


def run(*arguments, ranks=1, seconds=900, **options):
    """(exit code, what it said). The limit is that of a crowded machine, on which a tenth of a second may take a minute."""
    with start(*arguments, ranks=ranks, **options) as process:
        try:
            out, err = process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return "hung", ""
        return process.returncode, (out or "") + (err or "")


def reference(name, *arguments, deck=DECK):
    """Results of a run that nothing disturbs."""
    folder = fresh(name)
    code, said = run("run", deck, "-o", folder, "-q", *arguments)
    if code != 0:
        raise AssertionError(f"the run left alone ended with {code}: {said}")
    return Results(folder)


def differ(whole, folder):
    """None when the folder holds the same results to the last bit; else what differs."""
    parts = Results(folder)
    if not (parts.folder / "summary.json").exists():
        return "no summary.json"
    for table in sorted(path.name for path in whole.folder.glob("*.csv")):
        if not (parts.folder / table).exists() or (parts.folder / table).read_text() != (whole.folder / table).read_text():
            return f"{table} differs"
    if parts.steps("cable") != whole.steps("cable"):
        return "other steps have fields"
    step = whole.steps("cable")[-1]
    there, here = whole.fields(step, "cable"), parts.fields(step, "cable")
    for name in there:
        if (here[name] != there[name]).any():
            return f"{name} differs"
    left = [path.name for path in parts.folder.iterdir() if path.name.startswith("lock") or path.name.endswith(".unfinished")]
    return f"left over: {left}" if left else None


def last_time(folder):
    """s, of the last whole row of history.csv; 0 before the first."""
    try:
        rows = (folder / "history.csv").read_text().split("\n")[1:-1]
    except FileNotFoundError:
        return 0.0
    return float(rows[-1].split(",")[0]) if rows else 0.0


def go_on(whole, folder, deck=DECK, at_most_lost=None, arguments=()):
    """Continues what is in the folder, or begins again where no checkpoint was due yet; None or the fault."""
    reached = last_time(folder)
    if (folder / "summary.json").exists():
        return differ(whole, folder)
    if (folder / "checkpoint.h5").exists() or (folder / "checkpoint.previous.h5").exists():
        begin = time_of(folder)
        code, said = run("restart", folder / "checkpoint.h5", "-q")
    else:
        begin = 0
        code, said = run("run", deck, "-o", folder, "-q", "-f", *arguments)
    if code != 0:
        return f"cannot go on: {code} {said.strip()}"
    if at_most_lost is not None and reached - begin > at_most_lost + 1e-9:
        return f"{reached - begin:g} s are lost, {at_most_lost:g} s lie between checkpoints"
    return differ(whole, folder)


def time_of(folder):
    """s, of the checkpoint that a restart of this folder begins at."""
    import h5py
    for name in "checkpoint.h5", "checkpoint.previous.h5":
        try:
            with h5py.File(folder / name) as file:
                return float(file.attrs["time"])
        except OSError:
            continue
    return 0.0


def chance(seed):
    number = seed if seed is not None else random.randrange(10**6)
    print(f"seed {number}", flush=True)
    return random.Random(number)


def copy(source, name):
    folder = fresh(name)
    shutil.copytree(source, folder)
    return folder


def wait(condition, seconds=30):
    """Whether it came true."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.0005)
    return True


def takes_signals(process, *signals):
    """Whether the process has come so far as to take them."""
    try:
        caught = int(Path(f"/proc/{process.pid}/status").read_text().split("SigCgt:")[1].split()[0], 16)
    except (FileNotFoundError, IndexError):
        return True  # it has ended
    return process.poll() is not None or all(caught >> (number - 1) & 1 for number in signals)


def kill(process, number):
    try:
        os.kill(process.pid, number)
    except ProcessLookupError:
        pass
