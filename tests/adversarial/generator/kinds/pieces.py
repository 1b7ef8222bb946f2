"""What the kinds are made of: random expressions, masses, kinetic energies, and additions to any model."""

from fractions import Fraction

import tree
from tree import PI, absolute, cos, dot, exp, sin, t, tanh

SPLIT = (0.5, 1.5, 2, 3, 0.25, 1.25, 0.1)


def chance(rng, p):
    return rng.random() < p


def constant(rng):
    return tree.node(rng.choice(SPLIT))


def signed(rng, e):
    return -e if chance(rng, 0.3) else e


def smooth(rng, atoms, depth=2):
    """A random smooth expression of the atoms with values everywhere."""
    if depth == 0 or chance(rng, 0.15):
        atom = rng.choice(atoms)
        return atom if chance(rng, 0.6) else constant(rng) * atom
    x = smooth(rng, atoms, depth - 1)
    y = smooth(rng, atoms, depth - 1)
    return rng.choice((
        lambda: x + y, lambda: x - y, lambda: x * y, lambda: sin(x), lambda: cos(x), lambda: x**2, lambda: tanh(x),
        lambda: sin(x) * cos(y), lambda: x / (2 + y**2), lambda: exp(-(x**2)), lambda: tree.sqrt(1 + x**2),
        lambda: tree.atan(x), lambda: tree.ln(1.5 + x**2), lambda: -x, lambda: (x + constant(rng)) ** rng.choice((2, 3)),
        lambda: tree.asinh(x), lambda: tree.recip(1.5 + x**2), lambda: x,
    ))()


def any_function(rng, x, y):
    """A smooth elementary function, its argument brought to where it has a value."""
    return rng.choice((
        lambda: tree.asin(0.9 * sin(x)), lambda: tree.acos(0.8 * cos(x)), lambda: tree.atan2(x, 1.5 + y**2),
        lambda: tree.atan2(2 + sin(x), y), lambda: tree.acosh(1.5 + x**2), lambda: tree.atanh(0.7 * tanh(x)),
        lambda: tree.sinh(0.5 * x), lambda: tree.cosh(0.5 * x), lambda: tree.tan(0.4 * sin(x)), lambda: tanh(x + y),
        lambda: (1 + x**2) ** Fraction(3, 2), lambda: (2 + sin(x)) ** (0.5 * y), lambda: tree.ln(2 + cos(x)),
        lambda: exp(0.3 * x) * sin(y), lambda: tree.sqrt(2 + sin(x)) * y, lambda: tree.asinh(x * y),
        lambda: tree.recip(2 + cos(y)), lambda: (1.5 + x**2) ** -2, lambda: tree.atan(x - y),
    ))()


def jump(rng, x, y):
    """An expression with a branch: absolute values, roots of squares, extrema, in plain sight or not."""
    c = constant(rng)
    c2 = (c.data) ** 2
    square = x**2 - 2 * c.data * x + c2  # (x − c)², expanded
    return rng.choice((
        lambda: absolute(x - c), lambda: tree.maximum(x, c), lambda: tree.minimum(x, y), lambda: tree.sqrt(square),
        lambda: tree.sqrt(x**2), lambda: (x**2) ** Fraction(1, 2), lambda: (x**2) ** Fraction(3, 2),
        lambda: tree.sqrt(x**2 + 2 * x * y + y**2), lambda: tree.sqrt(2 * (1 + cos(x))), lambda: tree.sqrt(1 - cos(2 * x)),
        lambda: tree.sqrt(1 - sin(x) ** 2), lambda: absolute(x) * absolute(y), lambda: tree.signum(x - c) * (x - c),
        lambda: tree.sqrt((x - y) ** 2) + tree.maximum(x, y), lambda: absolute(absolute(x) - c),
        lambda: tree.asin(sin(x)), lambda: tree.acos(cos(x)), lambda: tree.atan(tree.tan(x)), lambda: tree.sqrt(x**4),
        lambda: tree.atan2(sin(x), cos(x)), lambda: tree.ln(x**2), lambda: (square**3) ** Fraction(1, 6),
        lambda: tree.maximum(tree.minimum(x, c), -c), lambda: tree.sqrt(exp(2 * x)), lambda: tree.recip(absolute(x)),
        lambda: tree.sqrt(x**2 * y**2), lambda: tree.sqrt(x**2) * tree.sqrt(y**2), lambda: tree.acosh(tree.cosh(x)),
        lambda: tree.sqrt(tree.cosh(x) ** 2 - 1), lambda: tree.signum(x) * y, lambda: (x**2) ** Fraction(-1, 2),
        lambda: tree.sqrt(x**2 + y**2 - 2 * x * y), lambda: absolute(x * y) / absolute(y),
        lambda: tree.sqrt(sin(x) ** 2 + sin(y) ** 2 + 2 * sin(x) * sin(y)),
    ))()


def vanishing(rng, x, y):
    """Zero on some branch, not on others; where it is not, twice something."""
    c = constant(rng)
    square = x**2 - 2 * c.data * x + c.data**2
    return rng.choice((
        lambda: tree.sqrt(square) + x - c, lambda: tree.sqrt(square) - x + c, lambda: absolute(x) - x,
        lambda: absolute(x - c) + x - c, lambda: tree.sqrt(2 * (1 + cos(y))) + 2 * cos(0.5 * y),
        lambda: tree.sqrt(2 * (1 + cos(y))) - 2 * cos(0.5 * y), lambda: tree.sqrt(2 - 2 * cos(y)) - 2 * sin(0.5 * y),
        lambda: tree.maximum(x, c) - x, lambda: tree.minimum(x, y) - y, lambda: tree.sqrt(1 - sin(x) ** 2) - cos(x),
        lambda: tree.asin(sin(x)) - x, lambda: tree.acos(cos(x)) - x, lambda: tree.atan(tree.tan(x)) - x,
        lambda: tree.atan2(sin(x), cos(x)) - x, lambda: tree.sqrt(x**2 * y**2) - x * y, lambda: tree.signum(x) - 1,
        lambda: tree.sqrt((x - y) ** 2) - x + y, lambda: (x**2) ** Fraction(3, 2) - x**3,
        lambda: tree.sqrt(x**4 + 2 * x**2 * y + y**2) - x**2 - y, lambda: absolute(sin(x)) - sin(x),
        lambda: tree.sqrt(tree.cosh(x) ** 2 - 1) - tree.sinh(x), lambda: tree.ln(x**2) - 2 * tree.ln(absolute(x)) + absolute(y) - y,
        lambda: tree.acosh(tree.cosh(x)) - x, lambda: tree.sqrt((1 - cos(x)) / (1 + cos(x))) - tree.tan(0.5 * x),
        lambda: tree.maximum(x, y) + tree.minimum(x, y) - x - y + absolute(x) - x,
        lambda: tree.sqrt(x**2 + y**2 + 1 + 2 * x * y + 2 * x + 2 * y) - x - y - 1,
        lambda: tree.atan(x) + tree.atan(tree.recip(x)) - 0.5 * PI,
    ))()


def coordinates(m, rng, low=1, high=3):
    letters = rng.sample(("x", "y", "z", "s", "alpha", "beta", "theta"), rng.randint(low, high))
    return [m.coordinate(c) for c in letters]


def masses(m, n):
    return [m.parameter(f"m{i}", draw="positive") for i in range(n)]


def diagonal(m, rng, qs):
    """A term with its square for each coordinate: T is positive definite with it."""
    ms = masses(m, len(qs))
    return sum_of([0.5 * a * dot(x) ** 2 for a, x in zip(ms, qs)])


def sum_of(terms):
    total = terms[0]
    for e in terms[1:]:
        total = total + e
    return total


def pair(rng, qs):
    """Two of them, mostly different ones."""
    return tuple(rng.sample(qs, 2)) if len(qs) > 1 and chance(rng, 0.85) else (rng.choice(qs),) * 2


def position_atoms(m, rng, qs, time=0.3):
    atoms = list(qs)
    if chance(rng, 0.6):
        atoms.append(m.parameter("k"))
    if chance(rng, time):
        atoms.append(t)
    return atoms


def decorated(m, rng, qs, p=0.4):
    """Adds potentials, dissipation, forces, inputs, outputs by the lot."""
    atoms = list(qs) + [t]
    rates = [dot(x) for x in qs]
    if chance(rng, p):
        m.potential.append(m.parameter("c") * smooth(rng, atoms))
    if chance(rng, p / 2) and m.lagrangian is None:
        m.potential.append(smooth(rng, list(qs)) * rng.choice(rates))
    if chance(rng, p):
        m.dissipation.append(0.5 * m.parameter("friction", draw="positive") * sum_of([r**2 for r in rates]))
    if chance(rng, p):
        u = m.input("u")
        named = [x.data for x in qs if x.op == "name"]
        push = u * smooth(rng, atoms + rates, 1)
        if named:
            m.force(rng.choice(named), push)
        else:
            m.force(qs[0].data[0], push, indices=(0,))
    if chance(rng, p):
        m.output("acceleration", dot(dot(rng.choice(qs))) * smooth(rng, atoms + rates, 1))
    return m
