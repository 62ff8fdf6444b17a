"""Writes the decks of this folder: exact solutions, and the forces that make them so.

python3 inputs/verification/manufacture.py           # write
python3 inputs/verification/manufacture.py --check   # exit code 1 when a deck differs from what would be written

A field is chosen, put into the equations of doc/numerics.md, and what is left over is the body force or load. The
flow is given in the moved coordinates x, y, so that it does not know of the mesh: whatever the mesh's motion does to
it is error. Mesh and cable are given in the reference coordinates X, Y.
"""
import sys
from pathlib import Path

import sympy as sp

from coupled_decks import coupled_jump, coupled_space, coupled_time
from deck_text import DECKS, SIDES, deck, errors, moving_water, orders, schemes, text, water
from forces import X, Y, cable_load, fluid_force, mesh_force, solid_force, t, vanishes, x, y

HERE = Path(__file__).resolve().parent
def taylor_green():
    nu = sp.Rational(1, 20)
    v = [sp.sin(sp.pi * x) * sp.cos(sp.pi * y) * sp.exp(-2 * nu * sp.pi**2 * t),
         -sp.cos(sp.pi * x) * sp.sin(sp.pi * y) * sp.exp(-2 * nu * sp.pi**2 * t)]
    p = (sp.cos(2 * sp.pi * x) + sp.cos(2 * sp.pi * y)) / 4 * sp.exp(-4 * nu * sp.pi**2 * t)
    assert all(vanishes(b) for b in fluid_force(v, p, nu))
    d = SLIDING
    deck("taylor_green", "Taylor-Green vortices on a moving mesh: order in space and time together", """
  Taylor and Green's decaying vortices, an exact solution of the Navier-Stokes equations without any force, on a mesh
  whose nodes move each in their own way; those of the boundary slide along it. Nothing flows through the boundary, so
  the pressure that is prescribed at one corner has no defect of mass to absorb.""", f"""
{water(8, nu)}
{moving_water(d, v, p)}
  <time scheme="generalised-alpha" rho-infinity="0.5" step="0.05" end="0.5"/>
{errors("water", velocity=v)}
{errors("water", pressure=p)}
{SPACE_ORDERS}""")


# The box keeps its shape, every node moves.
SLIDING = [sp.Rational(6, 100) * sp.sin(4 * t) * sp.sin(sp.pi * X) * sp.cos(2 * Y + 1),
           sp.Rational(6, 100) * sp.sin(5 * t) * sp.cos(3 * X) * sp.sin(sp.pi * Y)]
# The box is carried along, and every node inside moves.
BUBBLE = X * (1 - X) * Y * (1 - Y)
CARRIED = [sp.sin(3 * t) / 10 + BUBBLE * sp.sin(4 * t + 3 * Y), sp.cos(4 * t) / 10 + BUBBLE * sp.sin(5 * t - 2 * X)]
SPACE_ORDERS = orders(
    "both", 3, v_error_l2=(1.9, "2: linear velocity"),
    p_error_l2=(1.4, "1.5: linear pressure with PSPG, whose natural condition at the wall lacks the viscous term"))


def fluid_space():
    nu = sp.Rational(1, 20)
    swell = 1 + sp.sin(2 * t) / 2
    v = [swell * sp.sin(sp.pi * x)**2 * sp.sin(2 * sp.pi * y), -swell * sp.sin(2 * sp.pi * x) * sp.sin(sp.pi * y)**2]
    p = swell * sp.cos(sp.pi * x) * sp.sin(sp.pi * y)
    deck("fluid_space", "A forced flow on a moving mesh: order in space and time together", """
  A flow in a closed box, at rest on its walls, driven by a body force; all nodes move, those of the boundary along it.
""", f"""
{water(8, nu, fluid_force(v, p, nu))}
{moving_water(SLIDING, v, p)}
  <time scheme="generalised-alpha" rho-infinity="0.5" step="0.05" end="0.5"/>
{errors("water", velocity=v, pressure=p)}
{SPACE_ORDERS}""")


def fluid_time():
    fluid_in_time("fluid_time", "A flow linear in space on a moving mesh: order in time", CARRIED, """
  Velocity and pressure are linear in x and y at every instant: linear shapes hold them exactly on any mesh, so that
  all error is the time scheme's and the mesh velocity's. The box is carried along, and every node inside moves in
  its own way.
""")
    fluid_in_time("closed_time", "A flow linear in space in a closed box that deforms: order in time",
                  [CARRIED[0] + X * Y * sp.sin(2 * t) / 10, CARRIED[1]], """
  The flow of fluid_time.xml in a box that deforms, with velocities prescribed all around: at the instant at which a
  step's equations stand they must carry no net flow through the boundary as it is then, or the one node with a
  prescribed pressure has to absorb it, and the greatest error of the pressure is of first order only.
""", ["p_error_max"])


def fluid_in_time(name, title, d, header, more=()):
    s, c, k = sp.sin(3 * t) * sp.Rational(2, 5), sp.cos(2 * t) / 2, sp.Rational(3, 10) + t / 5
    v = [s * x + c * y + sp.sin(t), k * x - s * y + sp.cos(2 * t)]
    p = sp.cos(3 * t) * x + sp.sin(2 * t) * y
    quantities = ["v_error_l2", "p_error_l2", *more]
    deck(name, title + ": Newmark's method with gamma = 0.6", header, f"""
{water(4, sp.Rational(1, 20), fluid_force(v, p, sp.Rational(1, 20)))}
{moving_water(d, v, p)}
  <time scheme="newmark" step="0.05" end="1"/>
{errors("water", velocity=v, pressure=p)}
{orders("time", 6, **{q: (0.9, "1: gamma above 0.5") for q in quantities})}""")
    schemes(name, title, quantities)


def mesh_space():
    d = [sp.sin(sp.pi * X) * sp.cos(2 * Y) / 10, sp.cos(2 * X) * sp.sin(3 * Y) / 10]
    deck("mesh_space", "Motion of the mesh alone: order in space", """
  The displacement of the mesh under a body force, prescribed on the boundary.""", f"""
  <mesh><water-box min="0 0" max="1 1" cells="8 8"/></mesh>
  <modules><mesh-motion region="water" reference="total" body-force="{text(*mesh_force(d))}"/></modules>
  <conditions><prescribe field="displacement" on="{SIDES}" value="{text(*d)}"/></conditions>
  <time scheme="steady" end="1"/>
{errors("water", displacement=d)}
{orders("space", 4, d_error_l2=(1.9, "2: linear displacement"))}""")


def solid_space():
    # Strains up to .13: pressed harder St Venant and Kirchhoff's law is near its loss of ellipticity, and orders fall.
    d = [sp.sin(sp.pi * X) * sp.cos(2 * Y) / 25, sp.cos(2 * X) * sp.sin(3 * Y) / 25]
    deck("solid_space", "An elastic body under large strains: order in space", """
  The static displacement of a body of quadratic elements under a body force, prescribed on the boundary.""", f"""
  <mesh><water-box min="0 0" max="1 1" cells="4 4"/></mesh>
  <modules>
    <solid region="water" density="1" young-modulus="1" poisson-ratio="0.3"
           body-force="{text(*solid_force(d))}"/>
  </modules>
  <field name="velocity" basis="P2"/>
  <field name="displacement" basis="P2"/>
  <conditions>
    <initial field="displacement" on="water" value="{text(*d)}"/>
    <prescribe field="displacement" on="{SIDES}" value="{text(*d)}"/>
  </conditions>
  <time scheme="steady" end="1"/>
{errors("water", displacement=d)}
{orders("space", 4, d_error_l2=(2.9, "3: quadratic displacement"))}""", linear="1e-10")


def taylor_hood_space():
    nu = sp.Rational(1, 20)
    v = [sp.sin(sp.pi * x)**2 * sp.sin(2 * sp.pi * y), -sp.sin(2 * sp.pi * x) * sp.sin(sp.pi * y)**2]
    p = sp.cos(sp.pi * x) * sp.sin(sp.pi * y)
    d = [c.subs(t, sp.Rational(2, 5)) for c in SLIDING]
    deck("taylor_hood_space", "A forced flow by Taylor and Hood's elements: order in space", """
  A steady flow in a closed box, driven by a body force, on a mesh whose cells are curved by a quadratic displacement.
""", f"""
  <mesh><water-box min="0 0" max="1 1" cells="8 8"/></mesh>
  <modules>
    <ale-fluid region="water" density="1" viscosity="{float(nu)}" elements="taylor-hood"
               body-force="{text(*fluid_force(v, p, nu))}"/>
    <mesh-motion region="water" reference="total"/>
  </modules>
  <field name="displacement" basis="P2"/>
{moving_water(d, v, p)}
  <time scheme="steady" end="1"/>
{errors("water", velocity=v, pressure=p)}
{orders("space", 3, v_error_l2=(2.9, "3: quadratic velocity"), p_error_l2=(1.9, "2: linear pressure"))}""")


def cable_deck(name, title, header, place, cable, segments, time, order):
    """A cable alone on the line from (0, 0) to (1, 0), its ends led, the rest carried by loads."""
    d = [place[0] - X, place[1]]
    v = [sp.diff(c, t) for c in d]
    options = {"mass": 1, "stiffness": 10, "damping": sp.Rational(1, 2), **cable}
    bending = f' bending-stiffness="{float(options["bending"])}"' if "bending" in options else ""
    deck(name, title, header, f"""
  <mesh><line from="0 0" to="1 0" segments="{segments}"/></mesh>
  <modules>
    <cable region="cable" mass-per-length="1" axial-stiffness="10" damping="0.5"{bending}
           load="{text(*cable_load(place, X, **options))}"/>
  </modules>
  <conditions>
    <initial field="displacement" on="cable" value="{text(*d)}"/>
    <initial field="velocity" on="cable" value="{text(*v)}"/>
    <prescribe field="displacement" on="tow-point tail" value="{text(*d)}"/>
  </conditions>
{time}
{errors("cable", displacement=d, velocity=v)}
{order}""")


def cable_space():
    swing = sp.sin(2 * t) / 10
    place = [X * sp.Rational(11, 10) + swing * sp.sin(2 * sp.pi * X) / 8, swing * sp.sin(sp.pi * X)]
    time = '  <time scheme="generalised-alpha" rho-infinity="0.5" step="0.05" end="0.5"/>'
    order = orders("both", 4, d_error_l2=(1.9, "2: linear shapes"), v_error_l2=(1.9, "2: linear shapes"))
    cable_deck("cable_space", "A cable alone: order in space and time together", """
  A stretched cable swings along and across itself.""", place, {}, 8, time, order)


def cable_time():
    place = [X * (sp.Rational(11, 10) + sp.sin(3 * t) / 20) + sp.sin(2 * t) / 5,
             X * sp.cos(2 * t) / 5 + sp.sin(3 * t) / 10]
    title = "A straight cable that stretches and turns: order in time"
    cable_deck("cable_time", title + ": Newmark's method with gamma = 0.6", """
  Position and velocity are linear along the cable at every instant: all error is the time scheme's.""", place, {}, 4,
               '  <time scheme="newmark" step="0.1" end="1"/>',
               orders("time", 5, d_error_l2=(0.9, "1: gamma above 0.5"), v_error_l2=(0.9, "1: gamma above 0.5")))
    schemes("cable_time", title, ["d_error_l2", "v_error_l2"])


def main():
    for build in (taylor_green, fluid_space, fluid_time, mesh_space, cable_space, cable_time, coupled_space, solid_space,
                  taylor_hood_space, coupled_jump, coupled_time):
        build()
    wrong = [name for name, content in DECKS.items()
             if "--check" in sys.argv and (HERE / name).read_text() != content]
    if "--check" not in sys.argv:
        for name, content in DECKS.items():
            (HERE / name).write_text(content)
    if wrong:
        print("not as manufacture.py writes them:", *wrong)
    return len(wrong) > 0


if __name__ == "__main__":
    sys.exit(main())
