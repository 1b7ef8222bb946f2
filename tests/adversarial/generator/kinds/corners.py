"""Forces with corners, whose motions are integrated one by one and in lanes."""

from kinds import kind
from kinds.discontinuous import base
from kinds.pieces import chance
from motions.reference import Asked
from tree import absolute, cos, dot, maximum, minimum, signum, sin, sqrt, t


def in_lanes(m, rng):
    m.motion = Asked((1.0, 4.0), ("taylor",), states=4, lanes=rng.choice((3, 5, 7)))


@kind
def contacts_in_lanes(m, rng):
    """Springs that act on one side, gaps, and stops."""
    qs = base(m, rng, 2, 2)
    x, y = qs
    k, c = m.parameter("stiffness", draw="positive"), m.parameter("gap", draw="unit")
    for _ in range(rng.randint(1, 2)):
        depth = rng.choice((lambda: x - y, lambda: x - c, lambda: -y, lambda: x + y - 0.5, lambda: sin(x), lambda: x**2 + y**2 - 1, lambda: y - sin(t)))()
        m.potential.append(rng.choice((
            lambda: 5 * k * maximum(depth, 0.0) ** 2, lambda: k * maximum(0.0, depth) ** 3, lambda: 2 * k * minimum(depth, 0.0) ** 2, lambda: k * absolute(depth) * depth**2,
            lambda: 2 * k * maximum(absolute(depth) - 0.2, 0.0) ** 2,
        ))())
    in_lanes(m, rng)


@kind
def kinks_in_lanes(m, rng):
    """|u|, min and max of coordinates, velocities and time in forces and potentials."""
    qs = base(m, rng, 1, 2)
    x, y = qs[0], qs[-1]
    a = m.parameter("a", draw="unit")
    m.potential.append(rng.choice((lambda: a * absolute(x), lambda: a * absolute(x - y + 0.2), lambda: a * maximum(x, 0.3 * y), lambda: 0.5 * a * absolute(sin(x)) + 0.2 * x**2,
                                   lambda: a * sqrt(x**2) * y))())
    m.force(y.data, rng.choice((lambda: -0.4 * dot(y) * absolute(dot(y)), lambda: a * minimum(dot(x), 0.5), lambda: maximum(a, sin(2 * t)), lambda: -a * absolute(cos(3 * t)),
                                lambda: minimum(maximum(-x, -0.5), 0.5)))())
    in_lanes(m, rng)


@kind
def jumps_in_lanes(m, rng):
    """Signs of the time and of the state."""
    qs = base(m, rng, 1, 2)
    x = qs[0]
    a = m.parameter("a", draw="unit")
    m.force(x.data, rng.choice((lambda: a * signum(sin(2 * t)), lambda: -0.3 * a * signum(x), lambda: -0.2 * signum(dot(x)), lambda: a * signum(x - 0.2) * cos(t)))())
    if chance(rng, 0.5):
        m.potential.append(a * absolute(qs[-1]))
    in_lanes(m, rng)
