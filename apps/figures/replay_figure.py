"""A replay's map, errors by shot and histogram of errors: python3 replay_figure.py REPLAY_FOLDER"""
import csv
import sys
from pathlib import Path

import numpy as np

from figure_style import COLOURS, plt

KINDS = (("", "measured", "black", "-"), ("model_", "model", COLOURS[0], "-"), ("path_", "path in the water", COLOURS[1], "--"))


def numbers(path):
    """Per column, its numbers; empty cells are not numbers."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: np.array([float(row[name] or "nan") for row in rows]) for name in rows[0]}


def draw_map(folder, residuals):
    shots = list(dict.fromkeys(residuals["shot"]))
    chosen = shots[:: max(1, (len(shots) - 1) // 6)]
    figure, axes = plt.subplots(figsize=(8, 6))
    for shot in chosen:
        of_shot = residuals["shot"] == shot
        for prefix, _, colour, style in KINDS:
            axes.plot(residuals[f"{prefix}x_m"][of_shot] / 1000, residuals[f"{prefix}y_m"][of_shot] / 1000, style, color=colour, lw=1.2)
    for _, name, colour, style in KINDS:
        axes.plot([], [], style, color=colour, label=name)
    axes.set(xlabel="east (km)", ylabel="north (km)", aspect="equal")
    axes.legend()
    figure.savefig(folder / "map.png", dpi=150, bbox_inches="tight")


def draw_errors(folder, shots, residuals):
    figure, (by_shot, histogram) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    minutes = shots["time_s"] / 60
    for prefix, (columns, name, colour, _) in (("", KINDS[1]), ("path_", KINDS[2])):
        by_shot.plot(minutes, shots[f"{prefix}rms_m"], color=colour, label=f"{name}, rms")
        by_shot.plot(minutes, shots[f"{prefix}tail_error_m"], ":", color=colour, label=f"{name}, tail")
        off = np.hypot(residuals[f"{columns}x_m"] - residuals["x_m"], residuals[f"{columns}y_m"] - residuals["y_m"])
        off = off[np.isfinite(off)]
        histogram.hist(off, bins=np.geomspace(0.1, max(1, off.max()), 60), histtype="step", color=colour, label=f"{name}, rms {np.sqrt(np.mean(off ** 2)):.0f} m")
    by_shot.set(xlabel="time from the first shot (min)", ylabel="off by (m)", ylim=(0, None))
    histogram.set(xlabel="off by (m)", ylabel="places", xscale="log")
    for axes in (by_shot, histogram):
        axes.legend(fontsize=8, ncol=2, loc="lower center", bbox_to_anchor=(0.5, 1))  # no curve beneath it
    figure.savefig(folder / "errors.png", dpi=150, bbox_inches="tight")


def main():
    folder = Path(sys.argv[1])
    residuals = numbers(folder / "residuals.csv")
    draw_map(folder, residuals)
    draw_errors(folder, numbers(folder / "shots.csv"), residuals)
    print(f"Figures: {folder / 'map.png'}, {folder / 'errors.png'}")


if __name__ == "__main__":
    main()
