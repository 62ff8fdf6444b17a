"""The track of a tow with turns, its tail's way and the cable at some times: python3 track_figure.py RESULT_FOLDER [PNG]"""
import csv
import sys
from pathlib import Path

import numpy as np

from figure_style import COLOURS, plt


def receivers(folder):
    """Per time, x and y (m) of the receivers."""
    with open(folder / "receivers.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    shapes = {}
    for row in rows:
        shapes.setdefault(float(row["t_s"]), []).append((float(row["x_m"]), float(row["y_m"])))
    return {time: np.array(places) for time, places in shapes.items()}


def main():
    folder = Path(sys.argv[1])
    picture = Path(sys.argv[2]) if len(sys.argv) > 2 else folder / "track.png"
    shapes = receivers(folder)
    times = sorted(shapes)
    figure, axes = plt.subplots(figsize=(7.2, 6.6))
    for time in times[::4]:
        axes.plot(*shapes[time].T, color="#888888", lw=0.9)
    axes.plot([], [], color="#888888", lw=0.9, label=f"cable, every {times[4] - times[0]:.0f} s")
    axes.plot(*np.array([shapes[t][0] for t in times]).T, color=COLOURS[0], lw=2.2, label="tow point")
    axes.plot(*np.array([shapes[t][-1] for t in times]).T, color=COLOURS[1], lw=2.2, ls="--", label="last receiver")
    axes.plot(*shapes[times[-1]].T, color="black", lw=2.4, label=f"cable at the end, {times[-1]:.0f} s")
    axes.set(xlabel="x (m)", ylabel="y (m), against the current", aspect="equal")
    axes.legend(loc="lower right")
    figure.savefig(picture, dpi=150, bbox_inches="tight")
    print(f"Picture: {picture}")


if __name__ == "__main__":
    main()
