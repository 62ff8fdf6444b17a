"""The tow force while quick case 2 starts: its peak has converged in the step, and it does not alternate from step to step.

The step runs from 10 s down to 2.5 s, each after a short hold. Between 5 and 2.5 s the peak may change by 3 %. A force that
alternates has second differences of changing sign twice in a row; one that swings through several steps has not.
"""
import csv
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HOLD, END = 100, 300  # s


def forces(build, step):
    folder = Path(build) / f"tests/run/deck.deep_tow.tow_transient.{step}"
    subprocess.run([str(Path(build) / "bin/hawser"), "run", str(ROOT / "inputs/deep_tow/case_02_quick.xml"), "--force",
                    "--quiet", "--output", str(folder), "--set", f"step={step}", "--set", f"hold={HOLD}",
                    "--set", f"run_time={END}"], check=False)  # its expectations are those of the settled tow
    with open(folder / "history.csv", newline="") as file:
        rows = [(float(row["t_s"]), float(row["tow_force_n_per_m"])) for row in csv.DictReader(file)]
    assert abs(rows[-1][0] - END) < 1e-6, f"{folder} ends at {rows[-1][0]} s"
    return [force for time, force in rows if time > HOLD]


def alternations(force):
    """Where the second difference changes its sign twice in a row."""
    bend = [a - 2 * b + c for a, b, c in zip(force, force[1:], force[2:])]
    return sum(a * b < 0 and b * c < 0 for a, b, c in zip(bend, bend[1:], bend[2:]))


def main():
    found = {step: forces(sys.argv[1], step) for step in (10, 5, 2.5)}
    peaks = {step: max(force) for step, force in found.items()}
    for step, force in found.items():
        print(f"step {step} s: peak {peaks[step]:.0f} N/m, {alternations(force)} alternations")
    change = abs(peaks[5] / peaks[2.5] - 1)
    print(f"the peak changes by {100 * change:.2f} % from 5 s to 2.5 s")
    return change > 0.03 or any(alternations(force) for force in found.values())


if __name__ == "__main__":
    sys.exit(main())
