"""A towed array whose head sways: every node's amplitude and phase against the linear transfer function
0F1(b; k (L - s)) / 0F1(b; k L) of packages/modules/cable/theory.md."""
import argparse
import cmath
import csv
import math
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DECK = ROOT / "inputs/survey/array_sway.xml"
SPEED, LENGTH, DIAMETER, DENSITY, CT, DAMPING, AMPLITUDE, PERIOD = 2, 420, 0.06, 1025, 0.004, 3, 0.5, 200


def hypergeometric_0f1(b, z):
    """Its series; |z| is small here."""
    term = total = 1
    for n in range(200):
        term *= z / ((b + n) * (n + 1))
        total += term
    return total


def transfer(s):
    omega = 2 * math.pi / PERIOD
    fall = DAMPING * SPEED + 0.5 * DENSITY * CT * math.pi * DIAMETER * SPEED ** 2  # of the tension, N/m
    mass = 2 * DENSITY * math.pi * DIAMETER ** 2 / 4  # with the added mass
    b, k = DAMPING * SPEED / fall, (1j * DAMPING * omega - mass * omega ** 2) / fall
    return hypergeometric_0f1(b, k * (LENGTH - s)) / hypergeometric_0f1(b, k * LENGTH)


def fitted(times, values):
    """Complex amplitude of Im(a exp(i omega t)) over whole periods."""
    omega = 2 * math.pi / PERIOD
    return 2j * sum(y * cmath.exp(-1j * omega * t) for t, y in zip(times, values)) / len(times)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=Path, default=ROOT / "build")
    build = parser.parse_args().build.resolve()
    folder = build / "tests/run/array_sway"
    subprocess.run([build / "bin/hawser", "run", DECK, "-o", folder, "-f", "-q"], check=True)
    with open(folder / "receivers.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    nodes = {}
    for row in rows:
        if 6 * PERIOD < float(row["t_s"]) <= 8 * PERIOD + 1e-6:  # two periods, long after the start
            nodes.setdefault(float(row["arc_length_m"]), []).append((float(row["t_s"]), float(row["y_m"])))
    worst = 0
    for s, series in nodes.items():
        found, exact = fitted(*zip(*series)) / AMPLITUDE, transfer(s)
        worst = max(worst, abs(found / exact - 1))
        if s % 60 == 0:
            print(f"s = {s:5.1f} m: amplitude {abs(found):.4f}, theory {abs(exact):.4f}; phase {math.degrees(cmath.phase(found)):8.2f}, theory {math.degrees(cmath.phase(exact)):8.2f} deg")
    print(f"largest relative difference, of amplitude and phase together: {worst:.4f}, allowed .01")
    sys.exit(worst > 0.01)


if __name__ == "__main__":
    main()
