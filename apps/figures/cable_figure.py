"""Draws the cable in the flow at the last output: python3 cable_figure.py RESULT_FOLDER [PNG]"""
import json
import sys
from pathlib import Path

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np


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


def arrow(axes, start, vector, text, colour):
    axes.annotate("", xy=start + vector, xytext=start,
                  arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 2, "mutation_scale": 18})
    axes.text(*(start + 1.12 * vector), text, color=colour, ha="center", va="center")


def main():
    folder = Path(sys.argv[1])
    picture = Path(sys.argv[2]) if len(sys.argv) > 2 else folder / "cable.png"
    points, triangles, fields, time = read(outputs(folder, "flow")[-1])
    velocity = fields["velocity"][:, :2]
    speed = np.linalg.norm(velocity, axis=1)
    current = velocity.mean(axis=0)
    current /= np.linalg.norm(current) or 1.0

    first, lines, _, _ = read(outputs(folder, "cable")[0])
    cable, _, _, _ = read(outputs(folder, "cable")[-1])
    order = chain(lines)
    if first[order[0]] @ current > first[order[-1]] @ current:  # the tow point is the upstream end
        order = order[::-1]
    cable, tow_point = cable[order], cable[order[0]]
    length = np.linalg.norm(np.diff(cable, axis=0), axis=1).sum()
    tow = tow_point - first[order[0]]
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
    corner = centre + half * np.array([-0.78, 0.8])
    arrow(axes, corner, 0.2 * half * current, "current", "white")
    arrow(axes, tow_point, 0.25 * half * tow, "tow", "orange")

    axes.set(xlim=centre[0] + half * np.array([-1, 1]), ylim=centre[1] + half * np.array([-1, 1]),
             xlabel="x (m)", ylabel="y (m)", aspect="equal")
    title = f"t = {time:.0f} s, towed {towed:.0f} m"
    summary = folder / "summary.json"
    if summary.exists():
        error = json.loads(summary.read_text()).get("end_error_m")
        title += f", end {error:.1f} m off the tow axis" if error is not None else ""
    axes.set_title(title)
    legend = axes.legend(loc="lower right", facecolor="black", framealpha=0.4)
    for text in legend.get_texts():
        text.set_color("white")
    figure.savefig(picture, bbox_inches="tight")
    print(f"Picture: {picture}")


if __name__ == "__main__":
    main()
