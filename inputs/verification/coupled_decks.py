"""Decks in which flow, cable and mesh share nodes: exact solutions and the forces that make them so."""
import sympy as sp

from deck_text import SIDES, deck, errors, orders, schemes, text
from forces import Within, X, Y, cable_load, fluid_force, mesh_force, t, x, y


def tow(name, title, header, d, v, p, place, S, ends, more, time, order):
    """Fluid, cable and mesh with shared nodes, in the box from -1 to 1."""
    nu = sp.Rational(1, 20)
    deck(name, title, header, f"""
  <mesh slits="cable">
    <tow-box min="-1 -1" max="1 1" tow-point="{ends[0]}" tail="{ends[1]}" cable-size="0.25" far-size="0.25"/>
  </mesh>
  <modules>
    <ale-fluid region="water" density="1" viscosity="{float(nu)}"
               body-force="{more["force"]}"/>
    <cable region="cable" mass-per-length="1" axial-stiffness="10" damping="0.5"
           load="{more["load"]}"/>
    <mesh-motion region="water" reference="total" stiffening-power="0"{more["mesh"]}/>
  </modules>
  <conditions>
    <initial field="displacement" on="water" value="{text(*d)}"/>
    <initial field="displacement" on="cable" value="{text(place[0] - S[0], place[1] - S[1])}"/>
    <initial field="velocity" on="water" value="{text(*v)}"/>
    <prescribe field="displacement" on="{SIDES}" value="{text(*d)}"/>
    <prescribe field="displacement" on="tow-point tail" value="{text(place[0] - S[0], place[1] - S[1])}"/>
    <prescribe field="velocity" on="{SIDES}" value="{text(*v)}"/>
    <prescribe field="pressure" on="corner" value="{more["corner"]}"/>
  </conditions>
{time}
{errors("water", velocity=v)}
  <error name="p" field="pressure" on="water" exact="{p}" up-to-constant="true"/>
  <error name="cable" field="displacement" on="cable" exact="{text(place[0] - S[0], place[1] - S[1])}"/>
{more.get("errors", "")}
{order}""")


def coupled_space():
    nu, stretch = sp.Rational(1, 20), sp.Rational(21, 20)
    heave = sp.sin(2 * t) / 5
    across = heave * sp.cos(sp.pi * X / 2)           # of the cable, and of the flow's particles
    v = [sp.Integer(0), sp.diff(across, t).subs(X, x / stretch)]
    bubble = Y * (1 - X**2) * (1 - Y**2)
    d = [(stretch - 1) * X + sp.sin(3 * t) * bubble / 2, across * (1 - Y**2)]
    smooth = sp.cos(x) * sp.sin(y) * sp.cos(t)
    # The pressure's jump across the cable, smooth along it and zero at its ends.
    tip = stretch / 2
    jump = 8 * (tip**2 - x**2)**2 * (1 + t)
    slope = sp.diff(jump, x) / 2
    inside = f"{float(tip)} > abs(x)"  # "<" must not stand in an attribute
    side = "(Y > 0 ? 1 : -1)"
    force = fluid_force(v, smooth, nu)
    place = [stretch * X, across]
    load = cable_load(place, X, 1, 10, damping=sp.Rational(1, 2))
    normal = [-sp.diff(place[1], X), sp.diff(place[0], X)]
    load = [f + jump.subs(x, stretch * X) * n for f, n in zip(load, normal)]
    tow("coupled_space", "Flow, cable and mesh with shared nodes: order in space and time together", """
  A stretched cable is carried by a shear flow, v = d' on it, with the pressure jumping across it; the mesh moves in
  its own way under a force of its own. What the fluid does to the cable, and the cable's own balance, is made up for by
  the cable's load. The sides of the box stand in the flow's direction, so the flow that enters leaves again, also as
  interpolated.""", d, v, f"{text(smooth)} + ({inside} ? {text(jump / 2)} : 0)*{side}", place, [X, 0],
        ("-0.5 0", "0.5 0"),
        {"force": f"{text(force[0])} + ({inside} ? {text(slope)} : 0)*{side}; {text(force[1])}",
         "load": text(*load), "mesh": f'\n                 body-force="{text(*mesh_force(d))}"',
         "corner": text(smooth), "errors": errors("water", displacement=d)},
        '  <time scheme="generalised-alpha" rho-infinity="0.5" step="0.05" end="0.25"/>',
        orders("both", 3, v_error_l2=(1.9, "2: linear velocity"), d_error_l2=(1.9, "2: linear displacement"),
               cable_error_l2=(1.9, "2: linear displacement"),
               p_error_l2=(1.4, "1.5: linear pressure with PSPG")))


def coupled_jump():
    nu, stretch, side = sp.Rational(1, 20), sp.Rational(21, 20), sp.Symbol("(Y > 0 ? 1 : -1)")
    # At rest on the walls and along y = 0; of the second part dv/dn changes its sign across the cable, as in boundary layers.
    within = Within(x, stretch / 2)
    stream = ((1 + sp.sin(2 * t) / 2) * (stretch**2 - x**2)**2 * (1 - y**2)**2 * y**2
              * (1 + x / 2 + side * within**5))
    v = [sp.diff(stream, y), -sp.diff(stream, x)]
    p = sp.cos(x) * sp.sin(y) * sp.cos(t) + side * within**3 * (1 + t) / 2
    bubble = Y * (1 - X**2) * (1 - Y**2)
    d = [(stretch - 1) * X + sp.sin(3 * t) * bubble / 2, sp.sin(4 * t) * bubble / 3]
    place = [stretch * X, sp.Integer(0)]

    def plain(f):
        return f.subs(side, 1).replace(Within, lambda a, tip: 1 - (a / tip)**2)

    def across(f):
        """The jump at the cable, whose reference length is stretched."""
        f = f.subs(y, 0)
        return stretch * (f.subs(side, 1) - f.subs(side, -1)).subs(x, stretch * X)
    load = cable_load(place, X, 1, 10, damping=sp.Rational(1, 2))
    tow("coupled_jump", "Flow, cable and mesh, the shear jumping across the cable: order in space and time together", """
  Convection does not vanish, and both pressure and shear jump across a cable that holds its place against the tractions of
  two sides; both jumps end smoothly at its tips. The mesh moves in its own way. The walls are at rest.""", d, v, text(p), place,
        [X, 0], ("-0.5 0", "0.5 0"),
        {"force": text(*fluid_force(v, p, nu, plain=plain)),
         "load": text(load[0] - across(nu * sp.diff(v[0], y)), load[1] + across(p)),
         "mesh": f'\n                 body-force="{text(*mesh_force(d))}"', "corner": text(p),
         "errors": errors("water", displacement=d)},
        '  <time scheme="generalised-alpha" rho-infinity="0.5" step="0.05" end="0.25"/>',
        orders("both", 4, v_error_l2=(1.9, "2: linear velocity"), d_error_l2=(1.9, "2: linear displacement"),
               cable_error_l2=(1.9, "2: linear displacement"), p_error_l2=(1.4, "1.5: linear pressure with PSPG")))


def coupled_time():
    stretch = sp.Rational(21, 20)
    lean, drift, rise = sp.sin(3 * t) / 5, sp.sin(2 * t) / 5, sp.cos(3 * t) / 10
    place = [lean * Y + drift, stretch * Y + rise]     # of the cable, X = 0
    v = [sp.diff(lean, t) * (y - rise) / stretch + sp.diff(drift, t), sp.diff(rise, t)]
    p = sp.cos(3 * t) * x + sp.sin(2 * t) * y
    # At rest in the mesh's elasticity from the start: a mesh that had to find its place would jump in the first step.
    d = [lean * Y + drift + X * (1 - X**2) * (1 - Y**2) * sp.sin(4 * t) / 5, (stretch - 1) * Y + rise]
    title = "Flow, cable and mesh with shared nodes, linear in space: order in time"
    tow("coupled_time", title + ": Newmark's method with gamma = 0.6", """
  The flow shears and carries a straight, stretched cable; velocity, pressure and the cable's position are linear in
  space at every instant: all error is the time scheme's. The mesh moves in its own way under a force.""", d, v, text(p),
        place, [0, Y], ("0 0.5", "0 -0.5"),
        {"force": text(*fluid_force(v, p, sp.Rational(1, 20))),
         "load": text(*cable_load(place, Y, 1, 10, damping=sp.Rational(1, 2))),
         "mesh": f'\n                 body-force="{text(*mesh_force(d))}"', "corner": text(p)},
        '  <time scheme="newmark" step="0.05" end="1"/>',
        orders("time", 4, **{q: (0.9, "1: gamma above 0.5") for q in ("v_error_l2", "p_error_l2", "cable_error_l2")}))
    schemes("coupled_time", title, ["v_error_l2", "p_error_l2", "cable_error_l2"])
