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
from sympy.printing.str import StrPrinter

HERE = Path(__file__).resolve().parent
x, y, X, Y, t = sp.symbols("x y X Y t", real=True)
SOLVER = """  <solver><linear method="mumps" tolerance="1e-12"/><newton tolerance="1e-11"/></solver>"""
SIDES = "left right bottom top"


class Printer(StrPrinter):
    def _print_Pow(self, expression, rational=False):
        return super()._print_Pow(expression, rational).replace("**", "^")


def text(*components):
    """As a deck writes it; a component may be a text already."""
    return "; ".join(c if isinstance(c, str) else Printer().doprint(c) for c in components)


def grad(f):
    return [sp.diff(f, x), sp.diff(f, y)]


def vanishes(f):
    """At a few places and times; to simplify a long expression takes for ever."""
    return all(abs(sp.N(sp.sympify(f).subs({x: 0.3 + k, y: 0.7 - k, t: 0.4 + 2 * k}))) < 1e-12
               for k in (0, 0.11, 0.37))


def fluid_force(v, p, nu, rho=1):
    """What the momentum equation leaves over, per mass; v must be free of divergence."""
    assert vanishes(sp.diff(v[0], x) + sp.diff(v[1], y))
    return [sp.diff(v[i], t) + v[0] * sp.diff(v[i], x) + v[1] * sp.diff(v[i], y)
            - nu * (sp.diff(v[i], x, 2) + sp.diff(v[i], y, 2)) + grad(p)[i] / rho for i in (0, 1)]


def mesh_force(d, poisson=sp.Rational(3, 10)):
    """-div sigma over Young's modulus, about the reference."""
    H = sp.Matrix(2, 2, lambda i, j: sp.diff(d[i], (X, Y)[j]))
    strain = (H + H.T) / 2
    stress = (poisson / ((1 + poisson) * (1 - 2 * poisson)) * strain.trace() * sp.eye(2) + strain / (1 + poisson))
    return [-sum(sp.diff(stress[i, j], (X, Y)[j]) for j in (0, 1)) for i in (0, 1)]


DECKS = {}


def deck(name, title, header, body):
    DECKS[f"{name}.xml"] = f"""<?xml version="1.0"?>
<!-- Written by manufacture.py.
{header.strip(chr(10))}

    build/bin/hawser converge inputs/verification/{name}.xml -o results/{name}
-->
<hawser title="{title}">
{body.strip(chr(10))}
{SOLVER}
</hawser>
"""


def variant(name, base, title, header, body):
    DECKS[f"{name}.xml"] = f"""<?xml version="1.0"?>
<!-- Written by manufacture.py.
{header.strip(chr(10))}

    build/bin/hawser converge inputs/verification/{name}.xml -o results/{name}
-->
<hawser extends="{base}.xml" title="{title}">
{body.strip(chr(10))}
</hawser>
"""


def schemes(base, title, quantities):
    """The base deck, which has Newmark's damped method, with others."""
    for name, attributes, order, why in (
            ("trapezoidal", 'gamma="0.5" beta="0.25" start="initial-rates"', 2, "Newmark's method with gamma = 0.5"),
            ("generalised_alpha", 'scheme="generalised-alpha" rho-infinity="0.5"', 2, "generalised-alpha")):
        orders = "\n".join(f'    <order quantity="{q}" at-least="{order - 0.1:g}" why="{order}: {why}"/>'
                           for q in quantities)
        variant(f"{base}_{name}", base, f"{title}: {why}", f"{base}.xml with another time scheme.", f"""
  <time {attributes}/>
  <converge>
{orders}
  </converge>""")


def orders(refine, levels, **least):
    lines = "\n".join(f'    <order quantity="{q}" at-least="{number}" why="{why}"/>'
                      for q, (number, why) in least.items())
    return f'  <converge refine="{refine}" levels="{levels}">\n{lines}\n  </converge>'


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
  <mesh><water-box min="0 0" max="1 1" cells="8 8"/></mesh>
  <modules>
    <ale-fluid region="water" density="1" viscosity="{float(nu)}"/>
    <mesh-motion region="water"/>
  </modules>
{moving_water(d, v, p)}
  <time scheme="generalised-alpha" rho-infinity="0.5" step="0.05" end="0.5"/>
{errors("water", velocity=v)}
{errors("water", pressure=p)}
{SPACE_ORDERS}""")


def moving_water(d, v, p):
    """All nodes' displacements, and the flow on the boundary."""
    return f"""  <conditions>
    <initial field="displacement" on="water" value="{text(*d)}"/>
    <initial field="velocity" on="water" value="{text(*v)}"/>
    <initial field="pressure" on="water" value="{text(p)}"/>
    <prescribe field="displacement" on="water" value="{text(*d)}"/>
    <prescribe field="velocity" on="{SIDES}" value="{text(*v)}"/>
    <prescribe field="pressure" on="corner" value="{text(p)}"/>
  </conditions>"""


def errors(region, **fields):
    lines = []
    for field, exact in fields.items():
        exact = exact if isinstance(exact, (list, tuple)) else [exact]
        free = ' up-to-constant="true"' if field == "pressure" else ""
        lines.append(f'  <error name="{field[0]}" field="{field}" on="{region}" exact="{text(*exact)}"{free}/>')
    return "\n".join(lines)


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
  <mesh><water-box min="0 0" max="1 1" cells="8 8"/></mesh>
  <modules>
    <ale-fluid region="water" density="1" viscosity="{float(nu)}"
               body-force="{text(*fluid_force(v, p, nu))}"/>
    <mesh-motion region="water"/>
  </modules>
{moving_water(SLIDING, v, p)}
  <time scheme="generalised-alpha" rho-infinity="0.5" step="0.05" end="0.5"/>
{errors("water", velocity=v, pressure=p)}
{SPACE_ORDERS}""")


def fluid_time():
    s, c, k = sp.sin(3 * t) * sp.Rational(2, 5), sp.cos(2 * t) / 2, sp.Rational(3, 10) + t / 5
    v = [s * x + c * y + sp.sin(t), k * x - s * y + sp.cos(2 * t)]
    p = sp.cos(3 * t) * x + sp.sin(2 * t) * y
    title = "A flow linear in space on a moving mesh: order in time"
    deck("fluid_time", title + ": Newmark's method with gamma = 0.6", """
  Velocity and pressure are linear in x and y at every instant: linear shapes hold them exactly on any mesh, so that
  all error is the time scheme's and the mesh velocity's. The box is carried along, and every node inside moves in
  its own way. (On a boundary that changes its shape the velocities that generalised-alpha averages over a step would
  carry a net flow of second order through it, which the one node with a prescribed pressure had to absorb.)
""", f"""
  <mesh><water-box min="0 0" max="1 1" cells="4 4"/></mesh>
  <modules>
    <ale-fluid region="water" density="1" viscosity="0.05"
               body-force="{text(*fluid_force(v, p, sp.Rational(1, 20)))}"/>
    <mesh-motion region="water"/>
  </modules>
{moving_water(CARRIED, v, p)}
  <time step="0.1" end="1"/>
{errors("water", velocity=v, pressure=p)}
{orders("time", 4, v_error_l2=(0.9, "1: gamma above 0.5"), p_error_l2=(0.9, "1: gamma above 0.5"))}""")
    schemes("fluid_time", title, ["v_error_l2", "p_error_l2"])


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


def main():
    for build in (taylor_green, fluid_space, fluid_time, mesh_space):
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
