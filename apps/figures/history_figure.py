"""Draws quantities over time: python3 history_figure.py RESULT_FOLDER QUANTITY... [--output PNG]

A quantity is a column of history.csv, such as end_error_m; without one the columns are listed. Several folders, as
results/a results/b, are drawn into one picture.
"""
import argparse
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def read(folder):
    """Columns of history.csv by name."""
    with open(folder / "history.csv", newline="") as file:
        rows = list(csv.reader(file))
    return {name: [float(row[i]) for row in rows[1:]] for i, name in enumerate(rows[0])}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", nargs="+", help="result folders, then quantities")
    parser.add_argument("--output", type=Path, help="the picture; history.png in the first folder if left out")
    given = parser.parse_args()
    folders = [Path(word) for word in given.what if (Path(word) / "history.csv").exists()]
    quantities = [word for word in given.what if not (Path(word) / "history.csv").exists()]
    if not folders:
        sys.exit(f"no result folder with a history.csv among: {' '.join(given.what)}")
    histories = {folder: read(folder) for folder in folders}
    known = [name for name in histories[folders[0]] if name != "t_s"]
    unknown = [name for name in quantities if any(name not in history for history in histories.values())]
    if unknown or not quantities:
        sys.exit(f"{'no such quantity: ' + unknown[0] + '; ' if unknown else ''}there are {', '.join(known)}")

    figure, axes = plt.subplots(len(quantities), 1, sharex=True, squeeze=False,
                                figsize=(7, 1 + 2.5 * len(quantities)), layout="constrained")
    for row, quantity in zip(axes[:, 0], quantities):
        for folder, history in histories.items():
            row.plot(history["t_s"], history[quantity], label=str(folder))
        row.set_ylabel(quantity)
        row.grid(alpha=0.3)
    axes[-1, 0].set_xlabel("t (s)")
    if len(folders) > 1:
        axes[0, 0].legend()
    picture = given.output or folders[0] / "history.png"
    figure.savefig(picture, dpi=120)
    print(f"Picture: {picture}")


if __name__ == "__main__":
    main()
