"""Steady tows as boundary value problems, by scipy: no code and no discretisation of Hawser's.

The lines do not stretch. From the tail upward, with the arc length s, the place r and the force F with which the upper
part pulls the lower one: dr/ds = F/|F|, dF/ds = m a - w - q, where w is the weight in water, q the drag law and a the
acceleration. At a body F grows by (mass + added mass) a - weight - drag. The motion is a translation with a speed, or a
turn with a rate about the z axis, in which v = rate z x r and a = -rate^2 (x, y, 0) in steady state. What is unknown,
the depth of the tail and in a turn its radius, follows from where the ship is (scipy.optimize.root).

    PYTHONPATH=tests/survey /usr/bin/python3 -c "import tow_reference as t; print(t.deep_tow())"
"""
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import root

DENSITY = 1025.0  # kg/m^3
KNOT = 1852 / 3600  # m/s


@dataclass
class Line:
    length: float  # m
    diameter: float  # m
    weight: float  # in water, N/m
    mass: float  # kg/m
    normal: float = 1.5
    tangential: float = 0.01
    added_mass: float = 1.0


@dataclass
class Body:
    weight: float = 0.0  # in water, N
    mass: float = 0.0  # kg
    added_mass: float = 0.0  # kg
    drag_area: float = 0.0  # Cd A, m^2
    lift_area: float = 0.0  # Cl A, m^2, downward


@dataclass
class Motion:
    velocity: float = 0.0  # m/s, along x
    rate: float = 0.0  # rad/s, about z; instead of the velocity

    def of(self, r):
        if self.rate:
            return self.rate * np.array([-r[1], r[0], 0]), -self.rate**2 * np.array([r[0], r[1], 0])
        return np.array([self.velocity, 0, 0]), np.zeros(3)


def climb(parts, motion, current, tail):
    """From the tail at r through the parts, in order from there: places between them, force at the top."""
    r, force, places = np.array(tail, float), np.zeros(3), []
    for part in parts:
        places.append(r)
        if isinstance(part, Body):
            v, a = motion.of(r)
            u = current(r) - v
            down = np.array([0, 0, -1.0])
            water = 0.5 * DENSITY * (part.drag_area * np.linalg.norm(u) * u
                                     + part.lift_area * (u @ u * down - u @ down * u))
            force = force + (part.mass + part.added_mass) * a - part.weight * down - water
            continue

        def slope(_, y, line=part):
            place, pull = y[:3], y[3:]
            t = pull / np.linalg.norm(pull)
            v, a = motion.of(place)
            u = current(place) - v
            along = u @ t
            across = u - along * t
            load = 0.5 * DENSITY * line.diameter * (line.normal * np.linalg.norm(across) * across
                                                    + line.tangential * np.pi * abs(along) * along * t)
            load = load - line.added_mass * DENSITY * np.pi * line.diameter**2 / 4 * (a - a @ t * t)
            return np.concatenate([t, line.mass * a + [0, 0, line.weight] - load])

        end = solve_ivp(slope, (0, part.length), np.concatenate([r, force]), rtol=1e-10, atol=1e-9).y[:, -1]
        r, force = end[:3], end[3:]
    return places + [r], force


def straight(parts, speed, current, depth):
    """Places relative to the ship, from the tail, and the force at the ship. `depth`: a guess of the tail's."""
    motion = Motion(velocity=speed)
    found = root(lambda z: climb(parts, motion, current, [0, 0, z[0]])[0][-1][2:], [-depth], tol=1e-10)
    assert found.success, found.message
    places, force = climb(parts, motion, current, [0, 0, found.x[0]])
    return [p - places[-1] for p in places], force


def turning(parts, speed, radius, tail):
    """The same in still water, relative to the centre of the ship's circle; `tail`: a guess of its radius and height."""
    motion = Motion(rate=speed / radius)

    def miss(unknown):
        ship = climb(parts, motion, lambda r: np.zeros(3), [unknown[0], 0, unknown[1]])[0][-1]
        return [np.hypot(ship[0], ship[1]) - radius, ship[2]]

    found = root(miss, tail, tol=1e-10)
    assert found.success, found.message
    return climb(parts, motion, lambda r: np.zeros(3), [found.x[0], 0, found.x[1]])


def deep_tow(drogue=50.0):
    """inputs/survey/deep_tow.xml; the drogue's drag is given, as its area follows from it."""
    speed = 2 * KNOT

    def current(r):
        return np.array([-max(0.1, 1 + 0.9 * r[2] / 1500), 0, 0])

    parts = [Body(), Line(420, 0.04, 0, DENSITY * np.pi * 0.04**2 / 4), Body(weight=2000),
             Line(2500, 0.0173, 8.89, 1.15)]
    for _ in range(3):
        places, force = straight(parts, speed, current, 1240)if parts[0].drag_area else (None, None)
        height = places[0][2] if places else -1240.0
        parts[0].drag_area = 2 * drogue / (DENSITY * (speed - current([0, 0, height])[0])**2)
    places, force = straight(parts, speed, current, 1240)
    return {"tail": places[1], "towfish": places[2], "force": float(np.linalg.norm(force))}


def circle(radius=600.0):
    """inputs/survey/circle.xml: the ship at the radius; from wide circles to narrow ones."""
    parts = [Body(weight=2000, mass=400, added_mass=200, drag_area=0.2), Line(1000, 0.0173, 8.89, 1.15)]
    speed, guess = 2 * KNOT, [10000 * 1.0, -800.0]
    for wide in radius * np.geomspace(10000 / radius, 1, 15):
        guess[0] *= wide / guess[0] if wide == 10000 else 1
        places, force = turning(parts, speed, wide, guess)
        guess = [np.hypot(*places[0][:2]) * 0.74**(wide > radius), places[0][2]]
    return {"radius": float(np.hypot(*places[0][:2])), "height": float(places[0][2]),
            "force": float(np.linalg.norm(force))}
