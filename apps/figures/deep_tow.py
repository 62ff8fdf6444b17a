"""The deep-tow study's numbers: exact values, formulas to compare with, and what the runs say."""
import math
from typing import NamedTuple, Optional

import numpy as np

SPEED = 0.2        # m/s, of the tow in the decks
LENGTH = 420.0     # m, of the cable
DENSITY = 1000.0   # kg/m^3, of the decks
VISCOSITY = 0.3    # m^2/s, of the decks: an eddy viscosity
HELD_SPEED = 0.5   # m/s, of the water past the held line
PAPER_END_ERROR = 154.7  # m, case 2: the paper's only number


def relative_speed(current, angle, speed=SPEED):
    """Of the tow point against the water, m/s; angle in degrees."""
    a = math.radians(angle)
    return math.hypot(speed * math.sin(a), current + speed * math.cos(a))


def straight_end_error(current, angle, speed=SPEED, length=LENGTH):
    """Of a cable that is straight along the relative flow, m."""
    a = math.radians(angle)
    phi = math.atan2(speed * math.sin(a), current + speed * math.cos(a))
    return length * abs(math.sin(a - phi))


def tow_speed_for(end_error, current, angle):
    """The tow speed (m/s) for which the straight cable has that end error: it falls with the speed."""
    low, high = 1e-6, 50.0
    for _ in range(100):
        middle = 0.5 * (low + high)
        if straight_end_error(current, angle, middle) > end_error:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def plate_coefficient(reynolds):
    """Friction of both sides of a line along the flow: F / (rho W^2 L / 2)."""
    return 2 * (1.328 / math.sqrt(reynolds) + 2.668 / reynolds ** 0.875)


def plate_force(speed, viscosity=VISCOSITY):
    """N per m of depth."""
    return plate_coefficient(speed * LENGTH / viscosity) * DENSITY * speed ** 2 * LENGTH / 2


def drag_law_tension(speed, density=1025.0, diameter=0.06, tangential=0.01):
    """Tow tension of one streamer in sea water, N: T = rho Ct pi D W^2 L / 2."""
    return density * tangential * math.pi * diameter * speed ** 2 * LENGTH / 2


def straight_line_fit(x, y):
    """Slope, intercept and R^2 of a least-squares line."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    slope, intercept = np.polyfit(x, y, 1)
    rest = y - slope * x - intercept
    return slope, intercept, 1 - (rest @ rest) / ((y - y.mean()) @ (y - y.mean()))


def straightness(cable):
    """Largest distance of a node from the chord tow point - tail, m."""
    chord = (cable[-1] - cable[0]) / np.linalg.norm(cable[-1] - cable[0])
    away = cable - cable[0]
    return float(np.abs(away[:, 0] * chord[1] - away[:, 1] * chord[0]).max())


class GridLimit(NamedTuple):
    """A value at cell size 0 from three meshes. order: None where the meshes show none in common."""
    order: Optional[float]
    value: float
    uncertainty: float


def grid_limit(sizes, values):
    """From sizes in one ratio, coarse to fine: extrapolated with the order that is observed; where none is, the
    finest value. The uncertainty is of the finest value, by the rules of Eça and Hoekstra (2nd Workshop on CFD
    Uncertainty Analysis, Lisbon 2006) for a scheme of second order: 1.25 times Richardson's estimate; an order
    above 2.05 is not believed and one below 0.95 not charged more than 1.25 times the range of the values; three
    times that range where no order shows."""
    ratio = sizes[0] / sizes[1]
    first, second = values[0] - values[1], values[1] - values[2]
    spread = max(values) - min(values)
    if first * second <= 0 or abs(first) <= abs(second):
        return GridLimit(None, values[2], 3 * spread)
    order = math.log(first / second) / math.log(ratio)
    rest = second / (ratio ** order - 1)
    if order >= 2.05:
        uncertainty = max(1.25 * abs(second) / (ratio ** 2 - 1), 1.25 * spread)
    elif order < 0.95:
        uncertainty = 1.25 * min(abs(rest), spread)
    else:
        uncertainty = 1.25 * abs(rest)
    return GridLimit(order, values[2] - rest, uncertainty)


def force_bar(current):
    """How well a force is to be known, relative: 3 %, and 5 % in the thin boundary layer of a fast current (m/s)."""
    return 0.05 if current > 1 else 0.03


class Tows:
    """The towed cases by current and angle."""

    def __init__(self, sweep):
        self.cases = {(case.value("current"), case.value("tow_angle")): case for case in sweep.finished}
        self.currents = sorted({current for current, _ in self.cases})
        self.angles = sorted({angle for _, angle in self.cases})
        self.complete = (len(self.cases) == len(sweep.cases) == len(self.currents) * len(self.angles)
                         and len(self.angles) > 1)

    def get(self, current, angle):
        return self.cases.get((current, angle))

    def row(self, current, quantity):
        """A quantity over the angles."""
        return np.array([self.cases[current, angle].quantity(quantity) for angle in self.angles])
