"""What `hawser study` left in a folder: study.json and the runs' results."""
import csv
import json
import math
from dataclasses import dataclass, field
from pathlib import Path

import h5py
import numpy as np



def number(text):
    """The number that a value begins with, such as 0.5 of "0.5 m/s"; None where it is none."""
    try:
        return float(str(text).split()[0])
    except (ValueError, IndexError):
        return None


@dataclass
class Grid:
    """One output of a run: points (m), cells, fields, time (s)."""
    points: np.ndarray
    cells: np.ndarray
    fields: dict
    time: float


@dataclass
class Case:
    name: str
    title: str
    sweep: str
    folder: Path
    values: dict
    state: str
    exit_code: int
    reason: str
    wall: float
    cpu: float
    summary: dict = field(default_factory=dict)

    @property
    def finished(self):
        return self.state == "finished"

    def value(self, path):
        return number(self.values.get(path, ""))

    def quantity(self, name):
        """A figure of summary.json; NaN where the run has none."""
        found = self.summary.get(name, math.nan)
        return found if isinstance(found, (int, float)) else math.nan

    def table(self, name):
        """Columns of a CSV file by name."""
        with open(self.folder / name, newline="") as file:
            rows = list(csv.reader(file))
        values = np.array(rows[1:], dtype=float).reshape(len(rows) - 1, len(rows[0]))
        return dict(zip(rows[0], values.T))

    def cable(self):
        """x and y (m) of the cable's nodes at the end, from the tow point on."""
        table = self.table("cable.csv")
        last = table["t_s"] == table["t_s"][-1]
        return np.column_stack([table["x_m"][last], table["y_m"][last]])

    def grid(self, name, which=-1):
        file = sorted(self.folder.glob(f"{name}-*.h5"))[which]
        with h5py.File(file) as data:
            return Grid(data["points"][:, :2], data["cells"][:], {k: v[:] for k, v in data["fields"].items()},
                        float(data.attrs["time"]))


@dataclass
class Sweep:
    name: str
    deck: str
    meaning: str
    varied: list
    cases: list

    @property
    def finished(self):
        return [case for case in self.cases if case.finished]


class Study:
    def __init__(self, folder):
        self.folder = Path(folder)
        data = json.loads((self.folder / "study.json").read_text())
        self.title, self.report, self.file = data["title"], data["report"], data["study"]
        self.sweeps = []
        for sweep in data["sweeps"]:
            cases = [self._case(sweep["name"], entry) for entry in sweep["cases"]]
            self.sweeps.append(Sweep(sweep["name"], sweep["deck"], sweep["meaning"], sweep["varied"], cases))

    def _case(self, sweep, entry):
        case = Case(entry["name"], entry["title"], sweep, self.folder / entry["folder"], entry["values"],
                    entry["state"], entry["exit_code"], entry["reason"], entry["wall_s"], entry["cpu_s"])
        if case.finished:
            case.summary = json.loads((case.folder / "summary.json").read_text())
        return case

    def sweep(self, name):
        """None where the study has none of that name."""
        return next((sweep for sweep in self.sweeps if sweep.name == name), None)

    @property
    def cases(self):
        return [case for sweep in self.sweeps for case in sweep.cases]
