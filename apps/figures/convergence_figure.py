"""Draws errors against refinement, log-log: python3 convergence_figure.py FOLDER_OF_HAWSER_CONVERGE [STEM]

Writes STEM.png and STEM.svg (FOLDER/converge.* without STEM). Small enough to stand beside a table.
"""
import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

plt.rcParams.update({"svg.hashsalt": "hawser", "svg.fonttype": "none", "font.size": 8})  # the same file each time
COLOURS = ["tab:blue", "tab:red", "tab:green", "tab:purple"]


def draw(result, stem, picture=True):
    """One line per judged quantity (all of them where none is), with a dashed slope of the order asked for; without picture the SVG alone."""
    quantities = result["quantities"]
    chosen = {name: q for name, q in quantities.items() if "at_least" in q} or quantities
    figure, axes = plt.subplots(figsize=(3.4, 2.6))
    for colour, (name, quantity) in zip(COLOURS, chosen.items()):
        errors = quantity["errors"]
        sizes = [2.0**-level for level in range(len(errors))]
        label = f"{name.removesuffix('_error_l2')}: {quantity['finest_pair']:.2f}"
        axes.loglog(sizes, errors, "o-", color=colour, ms=4, lw=1.2, label=label)
        if "at_least" in quantity:
            slope = quantity["at_least"]
            axes.loglog(sizes, [1.25 * errors[-1] * (size / sizes[-1])**slope for size in sizes], "--", color=colour,
                        lw=0.8)
    cells = {"space": "cell size", "time": "time step", "both": "cell size and time step"}[result["refine"]]
    axes.set_xlabel(f"{cells}, relative")
    axes.set_ylabel("error")
    axes.set_xticks(sizes)
    axes.set_xticklabels([f"1/{2**level}" if level else "1" for level in range(len(sizes))])
    axes.minorticks_off()
    axes.grid(alpha=0.3)
    axes.legend(title="order, finest pair (dashed: asked for)", frameon=False, title_fontsize=8)
    figure.tight_layout(pad=0.4)
    if picture:
        figure.savefig(f"{stem}.png", dpi=160)
    figure.savefig(f"{stem}.svg", metadata={"Date": None})
    plt.close(figure)


def main():
    folder = Path(sys.argv[1])
    stem = Path(sys.argv[2]) if len(sys.argv) > 2 else folder / "converge"
    draw(json.loads((folder / "converge.json").read_text()), stem)
    print(f"Picture: {stem}.png")


if __name__ == "__main__":
    main()
