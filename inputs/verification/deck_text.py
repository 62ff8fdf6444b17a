"""Decks as text: the parts that the decks of this folder share."""
from sympy.printing.str import StrPrinter

SIDES = "left right bottom top"


class Printer(StrPrinter):
    def _print_Pow(self, expression, rational=False):
        return super()._print_Pow(expression, rational).replace("**", "^")

    def _print_Within(self, expression):
        place, tip = map(self.doprint, expression.args)
        return f"max(0, 1 - (({place})/({tip}))^2)"


def text(*components):
    """As a deck writes it; a component may be a text already."""
    return "; ".join(c if isinstance(c, str) else Printer().doprint(c) for c in components)


DECKS = {}


def deck(name, title, header, body, base=None, linear="1e-12"):
    """A deck of its own, or what differs from a base."""
    extends = f'extends="{base}.xml" ' if base else ""
    solver = "" if base else f"""  <solver><linear method="mumps" tolerance="{linear}"/><newton tolerance="1e-11"/></solver>
"""
    DECKS[f"{name}.xml"] = f"""<?xml version="1.0"?>
<!-- Written by manufacture.py.
{header.strip(chr(10))}

    build/bin/hawser converge inputs/verification/{name}.xml -o results/{name}
-->
<hawser {extends}title="{title}">
{body.strip(chr(10))}
{solver}</hawser>
"""


def schemes(base, title, quantities):
    """The base deck, which has Newmark's damped method, with others."""
    for name, attributes, order, why in (
            ("bdf2", 'scheme="bdf2"', 2, "BDF2"),
            ("trapezoidal", 'gamma="0.5" beta="0.25" start="initial-rates"', 2, "Newmark's method with gamma = 0.5"),
            ("generalised_alpha", 'scheme="generalised-alpha" rho-infinity="0.5"', 2, "generalised-alpha")):
        orders = "\n".join(f'    <order quantity="{q}" at-least="{order - 0.1:g}" why="{order}: {why}"/>'
                           for q in quantities)
        deck(f"{base}_{name}", f"{title}: {why}", f"{base}.xml with another time scheme.", f"""
  <time {attributes}/>
  <converge>
{orders}
  </converge>""", base)


def orders(refine, levels, **least):
    lines = "\n".join(f'    <order quantity="{q}" at-least="{number}" why="{why}"/>'
                      for q, (number, why) in least.items())
    return f'  <converge refine="{refine}" levels="{levels}">\n{lines}\n  </converge>'


def water(cells, nu, force=None):
    """A box of water whose mesh moves."""
    body = "" if force is None else f'\n               body-force="{text(*force)}"'
    return f"""  <mesh><water-box min="0 0" max="1 1" cells="{cells} {cells}"/></mesh>
  <modules>
    <ale-fluid region="water" density="1" viscosity="{float(nu)}"{body}/>
    <mesh-motion region="water"/>
  </modules>"""


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
