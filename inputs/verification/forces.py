"""What the equations of doc/numerics.md leave over of a chosen field: the force or load that makes it exact."""
import sympy as sp

x, y, X, Y, t = sp.symbols("x y X Y t", real=True)


def grad(f):
    return [sp.diff(f, x), sp.diff(f, y)]


def vanishes(f):
    """At a few places and times; to simplify a long expression takes for ever."""
    return all(abs(sp.N(sp.sympify(f).subs({x: 0.3 + k, y: 0.7 - k, t: 0.4 + 2 * k}))) < 1e-12
               for k in (0, 0.11, 0.37))


class Within(sp.Function):
    """1 - (x/tip)^2 between -tip and tip, zero beyond; a power of n has n - 1 continuous derivatives."""
    def fdiff(self, argindex=1):
        return -2 * self.args[0] / self.args[1]**2


def fluid_force(v, p, nu, rho=1, plain=lambda f: f):
    """What the momentum equation leaves over, per mass; v must be free of divergence. `plain` makes numbers of symbols."""
    assert vanishes(plain(sp.diff(v[0], x) + sp.diff(v[1], y)))
    return [sp.diff(v[i], t) + v[0] * sp.diff(v[i], x) + v[1] * sp.diff(v[i], y)
            - nu * (sp.diff(v[i], x, 2) + sp.diff(v[i], y, 2)) + grad(p)[i] / rho for i in (0, 1)]


def mesh_force(d, poisson=sp.Rational(3, 10)):
    """-div sigma over Young's modulus, about the reference."""
    H = sp.Matrix(2, 2, lambda i, j: sp.diff(d[i], (X, Y)[j]))
    strain = (H + H.T) / 2
    stress = (poisson / ((1 + poisson) * (1 - 2 * poisson)) * strain.trace() * sp.eye(2) + strain / (1 + poisson))
    return [-sum(sp.diff(stress[i, j], (X, Y)[j]) for j in (0, 1)) for i in (0, 1)]


def solid_force(d, young=1, poisson=sp.Rational(3, 10), rho=1):
    """-Div (F S) per mass of a body at rest that obeys St Venant and Kirchhoff's law, in plane strain."""
    H = sp.Matrix(2, 2, lambda i, j: sp.diff(d[i], (X, Y)[j]))
    strain = (H + H.T + H.T * H) / 2
    stress = young / (1 + poisson) * (poisson / (1 - 2 * poisson) * strain.trace() * sp.eye(2) + strain)
    piola = (sp.eye(2) + H) * stress
    return [-sum(sp.diff(piola[i, j], (X, Y)[j]) for j in (0, 1)) / rho for i in (0, 1)]


def cable_load(place, S, mass, stiffness, bending=0, damping=0):
    """m d'' + k d' - (N x')' + (EI (I - tt) t''/|x'|)' of a cable that lies on the line S."""
    slope = [sp.diff(c, S) for c in place]
    length = sp.sqrt(sum(c**2 for c in slope))
    tension = stiffness * (sum(c**2 for c in slope) - 1) / 2
    tangent = [c / length for c in slope]
    turn = [sp.diff(c, S, 2) for c in tangent]
    along = sum(a * b for a, b in zip(tangent, turn))
    return [mass * sp.diff(c, t, 2) + damping * sp.diff(c, t)
            - sp.diff(tension * slope[i] - bending * (turn[i] - along * tangent[i]) / length, S)
            for i, c in enumerate(place)]
