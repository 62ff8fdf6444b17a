"""One look for all figures: readable in print, colours told apart by the colour-blind (Okabe and Ito), and each line
by its marker and dashes too."""
import base64

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X"]
DASHES = ["-", "--", "-.", ":", (0, (3, 1, 1, 1)), (0, (5, 2)), "-"]

plt.rcParams.update({"font.size": 11, "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.6,
                     "axes.axisbelow": True, "legend.frameon": True, "legend.framealpha": 0.9, "svg.hashsalt": "hawser",
                     "svg.fonttype": "none", "font.family": "DejaVu Sans"})


def style(i):
    return {"color": COLOURS[i % len(COLOURS)], "marker": MARKERS[i % len(MARKERS)],
            "linestyle": DASHES[i % len(DASHES)], "markersize": 6, "linewidth": 1.8}


def line_style(i):
    return {key: value for key, value in style(i).items() if not key.startswith("marker")}


class Figures:
    """Saves each figure as PNG and SVG, and keeps what a page needs to show it."""

    def __init__(self, folder):
        self.folder = folder
        self.shown = []  # (name, caption, image as text for src)
        folder.mkdir(parents=True, exist_ok=True)

    def save(self, figure, name, caption, image="svg"):
        figure.savefig(self.folder / f"{name}.png", dpi=150, bbox_inches="tight")
        figure.savefig(self.folder / f"{name}.svg", bbox_inches="tight", metadata={"Date": None})
        kind = "png" if image == "png" else "svg+xml"
        data = (self.folder / f"{name}.{image}").read_bytes()
        self.shown.append((name, caption, f"data:image/{kind};base64,{base64.b64encode(data).decode()}"))
        plt.close(figure)
