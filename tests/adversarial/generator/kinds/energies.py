"""Energies written with scalars: quadratic forms, general Lagrangians, functions, time."""

from kinds import kind
from kinds.pieces import (any_function, chance, constant, coordinates, decorated, diagonal, pair, position_atoms, signed,
                          smooth, sum_of)
import tree
from tree import cos, dot, exp, ln, sin, sqrt, t


@kind
def scalars(m, rng):
    """A metric of random functions."""
    qs = coordinates(m, rng, 1, 4)
    m.kinetic.append(diagonal(m, rng, qs))
    atoms = position_atoms(m, rng, qs)
    for _ in range(rng.randint(1, 3)):
        x, y = pair(rng, qs)
        m.kinetic.append(0.5 * (dot(x) + smooth(rng, atoms) * dot(y)) ** 2)
    m.potential.append(m.parameter("g") * smooth(rng, atoms, 3))
    decorated(m, rng, qs)


@kind
def metric(m, rng):
    """Entries of M written one by one, which may be indefinite."""
    qs = coordinates(m, rng, 2, 4)
    atoms = position_atoms(m, rng, qs)
    for i, x in enumerate(qs):
        m.kinetic.append(signed(rng, 0.5 * m.parameter(f"m{i}") * (1.5 + smooth(rng, atoms, 1) ** 2)) * dot(x) ** 2)
        for y in qs[:i]:
            if chance(rng, 0.6):
                m.kinetic.append(smooth(rng, atoms, 1) * dot(x) * dot(y))
    decorated(m, rng, qs, 0.5)


@kind
def indefinite(m, rng):
    """Squares of both signs, null directions, products without squares."""
    qs = coordinates(m, rng, 2, 4)
    atoms = position_atoms(m, rng, qs, 0.1)
    a = m.parameter("a")
    shape = rng.randrange(3)
    if shape == 0:
        terms = [(-1) ** i * 0.5 * m.parameter(f"m{i}", draw="positive") * dot(x) ** 2 for i, x in enumerate(qs)]
        m.kinetic.append(sum_of([tree.node(e) for e in terms]))
        m.kinetic.append(0.5 * a * (dot(qs[0]) - smooth(rng, atoms, 1) * dot(qs[1])) ** 2)
    elif shape == 1:
        for x, y in zip(qs, qs[1:] + qs[:1]):
            m.kinetic.append((a + 0.3 * sin(smooth(rng, atoms, 1))) * dot(x) * dot(y))
        m.kinetic.append(0.5 * dot(qs[-1]) ** 2)
    else:
        for i, x in enumerate(qs):
            w = dot(x) + sum_of([tree.node(0)] + [smooth(rng, atoms, 1) * dot(y) for y in qs[:i]])
            m.kinetic.append(signed(rng, 0.5 * m.parameter(f"w{i}", draw="positive") * w**2))
    decorated(m, rng, qs)


@kind
def squares(m, rng):
    """½ Σ W (E q̇)²: as many forms as coordinates, or more, or fewer with a rest; with drift."""
    qs = coordinates(m, rng, 2, 4)
    atoms = position_atoms(m, rng, qs)
    forms = []
    for i in range(len(qs) + rng.choice((0, 0, 0, 1, 2))):
        own = qs[i % len(qs)]
        others = [smooth(rng, atoms, 1) * dot(y) for y in qs if chance(rng, 0.4)]
        drift = [smooth(rng, atoms, 1)] if chance(rng, 0.25) else []
        forms.append(m.define(f"w{i}", sum_of([dot(own), *others, *drift])))
    ws = [m.parameter(f"i{i}", draw="positive") for i in range(len(forms))]
    m.kinetic.append(0.5 * sum_of([i * w**2 for i, w in zip(ws, forms)]))
    if chance(rng, 0.4):
        m.kinetic.append(0.2 * forms[0] * forms[1])
    decorated(m, rng, qs)


@kind
def general(m, rng):
    """A Lagrangian that is no quadratic form of the velocities."""
    qs = coordinates(m, rng, 1, 3)
    atoms = position_atoms(m, rng, qs)
    rates = [dot(x) for x in qs]
    square = sum_of([r**2 for r in rates])
    c, k = m.parameter("mass", draw="positive"), m.parameter("a")
    base = rng.choice((
        lambda: -c * 9 * sqrt(1 - square / 36), lambda: c * tree.cosh(0.4 * rates[0]) + 0.5 * square,
        lambda: 0.5 * c * square + 0.1 * square**2, lambda: c * exp(0.2 * rates[0]) + 0.5 * square,
        lambda: c * sqrt(1 + square) * (2 + sin(qs[0])), lambda: 0.5 * c * square * exp(k * t * 0.3),
        lambda: 0.5 * c * square + 0.1 * (1 + square) ** 2 * cos(qs[0]) ** 2, lambda: 0.5 * square - c * ln(4 + cos(rates[0])),
    ))()
    m.lagrangian = base + smooth(rng, atoms) * rates[-1] - smooth(rng, atoms)
    decorated(m, rng, qs, 0.3)
    m.potential = []


@kind
def elementary(m, rng):
    """Every elementary function."""
    qs = coordinates(m, rng, 1, 3)
    m.kinetic.append(diagonal(m, rng, qs))
    x, y = pair(rng, qs)
    m.kinetic.append(0.5 * any_function(rng, x, y) ** 2 * dot(x) ** 2)
    m.potential.append(m.parameter("a") * any_function(rng, *pair(rng, qs)) + any_function(rng, *pair(rng, qs)))
    m.output("value", any_function(rng, *pair(rng, qs)) * any_function(rng, dot(x), y))
    decorated(m, rng, qs)


@kind
def rheonomic(m, rng):
    """Positions that move in time."""
    qs = coordinates(m, rng, 1, 3)
    rate = m.parameter("rate", draw="rate")
    mass = m.parameter("m", draw="positive")
    x = qs[0]
    angle = rng.choice((rate * t, rate * t**2, x + rate * t, rate * sin(t), sin(x) * t))
    p = [x * cos(angle), x * sin(angle), smooth(rng, [x, t], 1)]
    p = m.define("p", p)
    m.kinetic.append(0.5 * mass * dot(p).norm_squared())
    m.kinetic.append(diagonal(m, rng, qs) * rng.choice((tree.node(1), 2 + sin(t), exp(0.2 * t))))
    for y in qs[1:]:
        m.kinetic.append(0.5 * (dot(y) + dot(0.1 * y + smooth(rng, [*qs, t]))) ** 2)
    m.potential.append(m.parameter("g") * smooth(rng, [*qs, t]))
    m.output("p", p)
    m.output("a", dot(dot(p)))
    decorated(m, rng, qs)


@kind
def magnetic(m, rng):
    """Potentials that contain velocities, total derivatives among them."""
    qs = coordinates(m, rng, 2, 4)
    m.kinetic.append(diagonal(m, rng, qs))
    atoms = [*qs, t]
    for x in qs:
        m.potential.append(m.parameter("e") * smooth(rng, atoms) * dot(x) if x is qs[0] else smooth(rng, atoms) * dot(x))
    if chance(rng, 0.5):
        m.potential.append(dot(0.1 * qs[0] + smooth(rng, atoms)))
    if chance(rng, 0.5):
        m.potential.append(0.1 * dot(qs[0]) ** 2 * cos(qs[1]))
    decorated(m, rng, qs)


@kind
def ignorable(m, rng):
    """Coordinates of which only the velocity occurs, or only the difference."""
    qs = coordinates(m, rng, 2, 4)
    a, b = qs[0], qs[1]
    m.kinetic.append(diagonal(m, rng, qs))
    rest = qs[2:] or [b]
    m.kinetic.append(0.5 * (dot(a) + smooth(rng, rest) * dot(b)) ** 2)
    if chance(rng, 0.5):
        m.potential.append(m.parameter("k") * smooth(rng, [a - b], 1))
    m.potential.append(smooth(rng, rest))
    if chance(rng, 0.3):
        m.force(a.data, m.parameter("f") * sin(a))
    if chance(rng, 0.3):
        m.potential.append(0 * a + (a - a) + (sin(b) ** 2 + cos(b) ** 2))


@kind
def repeated(m, rng):
    """Long: the same parts many times, some spelled another way."""
    qs = coordinates(m, rng, 2, 3)
    atoms = position_atoms(m, rng, qs)
    part = m.define("part", smooth(rng, atoms, 3))
    other = m.define("other", part**2 + smooth(rng, [part, *qs], 2))
    m.kinetic.append(diagonal(m, rng, qs))
    for _ in range(rng.randint(4, 9)):
        x, y = pair(rng, qs)
        factor = smooth(rng, [part, other, *qs], 2)
        m.kinetic.append(0.5 * (factor * dot(x) + constant(rng) * dot(y)) ** 2 * rng.choice((1, 0.5)))
        m.potential.append(smooth(rng, [part, other, *qs, t], 3) * rng.choice((part, other, factor)))
    decorated(m, rng, qs)


@kind
def short(m, rng):
    """As little as possible."""
    x = m.coordinate(rng.choice(("x", "q", "a")))
    factor = rng.choice((tree.node(1), tree.node(0.5), x**2, exp(x), t, (1 + x**2), -tree.node(1), x, x**-2, sqrt(x**2)))
    m.kinetic.append(factor * dot(x) ** 2)
    if chance(rng, 0.6):
        m.potential.append(rng.choice((x, x**2, cos(x), tree.absolute(x), t * x, 1 / x, dot(x), x * dot(x), ln(x**2))))
