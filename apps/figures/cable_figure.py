"""Draws the cable in the flow at the last output: python3 cable_figure.py RESULT_FOLDER [PNG]"""
import sys
from pathlib import Path

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patheffects import withStroke

OUTLINE = [withStroke(linewidth=2, foreground="black")]  # text stays readable on any colour


def outputs(folder, name):
    files = sorted(folder.glob(f"{name}-*.h5"))
    if not files:
        sys.exit(f"{folder} has no {name}-*.h5: was the run written with fields?")
    return files


def read(file):
    with h5py.File(file) as data:
        return data["points"][:, :2], data["cells"][:], {k: v[:] for k, v in data["fields"].items()}, \
            float(data.attrs["time"])


def chain(cells):
    """The points of a line from one end to the other."""
    neighbours = {}
    for a, b in cells:
        neighbours.setdefault(a, []).append(b)
        neighbours.setdefault(b, []).append(a)
    at, before = next(p for p, around in neighbours.items() if len(around) == 1), None
    order = [at]
    while following := [p for p in neighbours[at] if p != before]:
        before, at = at, following[0]
        order.append(at)
    return np.array(order)


def label(axes, place, text, **how):
    axes.text(*place, text, color="white", path_effects=OUTLINE, **how)


def arrow(axes, start, vector, text, colour):
    """The text stands right of the arrow's middle, level with it: never on the line itself."""
    axes.annotate("", xy=start + vector, xytext=start,
                  arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 2.5, "mutation_scale": 18})
    aside = np.array([0.15 * np.linalg.norm(vector), 0])
    label(axes, start + 0.5 * vector + aside, text, ha="left", va="center")


def main():
    folder = Path(sys.argv[1])
    picture = Path(sys.argv[2]) if len(sys.argv) > 2 else folder / "cable.png"
    points, triangles, fields, time = read(outputs(folder, "flow")[-1])
    velocity = fields["velocity"][:, :2]
    speed = np.linalg.norm(velocity, axis=1)
    current = velocity.mean(axis=0)
    current /= np.linalg.norm(current) or 1.0

    cable, lines, along, _ = read(outputs(folder, "cable")[-1])
    order = chain(lines)
    if along["arc_length"].flat[order[0]] > 0:  # counted from the tow point
        order = order[::-1]
    cable, tow_point = cable[order], cable[order[0]]
    length = np.linalg.norm(np.diff(cable, axis=0), axis=1).sum()
    at_tow_point = np.argmin(np.linalg.norm(points - tow_point, axis=1))
    tow = fields["displacement"][at_tow_point, :2]
    towed = np.linalg.norm(tow)
    tow = tow / towed if towed > 0 else -current

    figure, axes = plt.subplots(figsize=(8, 8), dpi=130)
    centre, half = cable.mean(axis=0), 0.85 * length
    near = np.all(np.abs(points - centre) < 1.5 * half, axis=1)
    colours = axes.tripcolor(*points.T, triangles, speed, shading="gouraud", cmap="viridis",
                             vmin=0, vmax=speed[near].max() if near.any() else None)
    figure.colorbar(colours, label="flow speed (m/s)", shrink=0.8)
    axes.plot(*cable.T, color="white", lw=4, solid_capstyle="round")
    axes.plot(*cable.T, color="crimson", lw=2, solid_capstyle="round", label="cable")
    axes.plot(*tow_point, "o", color="crimson", markeredgecolor="white", ms=8, label="tow point")
    axis = np.array([tow_point - 1.2 * length * tow, tow_point + 0.5 * length * tow])
    axes.plot(*axis.T, "--", color="white", lw=1.2, label="tow axis")
    tail = cable[-1]
    foot = tow_point + tow * ((tail - tow_point) @ tow)
    end_error = np.linalg.norm(tail - foot)
    if end_error > 0.02 * length:
        axes.plot(*np.array([foot, tail]).T, "-", color="white", lw=1.2)
        label(axes, foot - 0.02 * length * tow, f"end error {end_error:.1f} m", ha="right", va="top")
    corner = centre + half * np.array([-0.78, 0.8])
    arrow(axes, corner, 0.2 * half * current, "current", "white")
    arrow(axes, tow_point, 0.25 * half * tow, "tow", "orange")

    axes.set(xlim=centre[0] + half * np.array([-1, 1]), ylim=centre[1] + half * np.array([-1, 1]),
             xlabel="x (m)", ylabel="y (m)", aspect="equal")
    axes.set_title(f"t = {time:.0f} s, towed {towed:.0f} m")
    legend = axes.legend(loc="lower right", facecolor="black", framealpha=0.6)
    for text in legend.get_texts():
        text.set_color("white")
    figure.savefig(picture, bbox_inches="tight")
    print(f"Picture: {picture}")


if __name__ == "__main__":
    main()
