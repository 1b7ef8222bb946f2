"""Forces that jump in time and state, integrated across the jumps."""

from kinds import kind
from kinds.pieces import chance, coordinates, smooth, sum_of
from motions.reference import Asked
import tree
from tree import absolute, cos, dot, maximum, minimum, signum, sin, t


def base(m, rng, low=1, high=2):
    """Masses on springs, perhaps coupled, perhaps pendulums, with or without damping."""
    m.taylor = True
    qs = coordinates(m, rng, low, high)
    for i, x in enumerate(qs):
        mass = m.parameter(f"m{i}", draw="positive")
        m.kinetic.append(0.5 * mass * dot(x) ** 2)
        k = m.parameter(f"k{i}", draw="positive")
        m.potential.append(rng.choice((lambda: 0.5 * k * x**2, lambda: k * (1 - cos(x)), lambda: k * x, lambda: 0.5 * k * x**2 + 0.1 * x**4))())
        if chance(rng, 0.3):
            m.dissipation.append(0.5 * m.parameter(f"c{i}", draw="positive") * dot(x) ** 2)
    if len(qs) > 1 and chance(rng, 0.5):
        m.potential.append(0.5 * m.parameter("k", draw="positive") * (qs[0] - qs[1]) ** 2)
    m.motion = Asked((1.5, 5.0), states=6)
    return qs


def push(m, rng, qs, force):
    m.force(rng.choice(qs).data, force)


def clock(m, rng):
    """A function of time that changes its sign."""
    w = m.parameter("w", draw="positive")
    return rng.choice((
        lambda: sin(w * t), lambda: cos(w * t), lambda: sin(w * t + 0.3) + 0.4, lambda: sin(w * t) * sin(2.3 * t),
        lambda: t - m.parameter("t0"), lambda: (t - m.parameter("t1")) * (t - 0.3), lambda: sin(2 * t**2), lambda: sin(w * t) - 0.5 * cos(3 * t),
    ))()


@kind
def square_waves(m, rng):
    """Square waves, pulses and steps in time."""
    qs = base(m, rng)
    a = m.parameter("a")
    for _ in range(rng.randint(1, 2)):
        g = clock(m, rng)
        push(m, rng, qs, rng.choice((
            lambda: a * signum(g), lambda: a * 0.5 * (1 + signum(g)), lambda: a * signum(g) * smooth(rng, [*qs, t], 1),
            lambda: maximum(signum(g), 0) * a, lambda: a * signum(g) * signum(clock(m, rng)), lambda: minimum(a, 2.0) * signum(g) * dot(qs[0]) * 0.3,
        ))())


@kind
def relays(m, rng):
    """Forces that jump where a function of the state changes its sign, and lead across it."""
    qs = base(m, rng)
    x, y = rng.choice(qs), qs[-1]
    a, c = m.parameter("a", draw="unit"), m.parameter("c", draw="unit")
    line = rng.choice((
        lambda: x - c, lambda: x + y, lambda: sin(2 * x), lambda: x - 0.3 * dot(x), lambda: x + 0.2 * dot(y) - c, lambda: x**2 - 0.5, lambda: x * y - c,
        lambda: x - sin(t), lambda: dot(x) * x - c, lambda: cos(x + y) - 0.4,
    ))()
    m.force(x.data, rng.choice((
        lambda: -a * signum(line), lambda: a * signum(line) * cos(x), lambda: -a * (1 + signum(line)) * x, lambda: a * signum(line) * signum(dot(y)),
        lambda: a * maximum(signum(line), 0.0) - a * dot(x), lambda: -a * signum(line) * absolute(x),
    ))())


@kind
def dry_friction(m, rng):
    """Friction against a velocity that crosses zero, or that of a belt, without sticking."""
    qs = base(m, rng)
    x = rng.choice(qs)
    mu, belt = m.parameter("mu", draw="positive"), m.parameter("belt", draw="unit")
    slip = rng.choice((lambda: dot(x), lambda: dot(x) - belt, lambda: dot(qs[0]) - dot(qs[-1]) if len(qs) > 1 else dot(x), lambda: dot(x) - 0.5 * sin(2 * t)))()
    m.force(x.data, rng.choice((
        lambda: -0.3 * mu * signum(slip), lambda: -0.2 * mu * signum(slip) * (1 + 0.5 * cos(x)), lambda: -0.1 * mu * signum(slip) - 0.2 * slip,
        lambda: -0.2 * signum(slip) * slip**2 - 0.1 * mu * signum(slip), lambda: -0.3 * mu * signum(slip) / (1 + absolute(slip)),
    ))())
    if chance(rng, 0.4):
        push(m, rng, qs, m.parameter("drive") * sin(3 * t))


@kind
def signs_of_several(m, rng):
    """Signs of several functions, in products, sums and minima, beside corners."""
    qs = base(m, rng, 2, 2)
    x, y = qs
    a = m.parameter("a", draw="unit")
    s = lambda: signum(rng.choice((x, y, x - y, x + 0.5 * y, sin(3 * t), dot(x), x - 0.3, dot(y) - dot(x), t - m.parameter("t0"), sin(x))))
    for _ in range(2):
        push(m, rng, qs, 0.5 * rng.choice((
            lambda: a * s() * s(), lambda: a * (s() + s()), lambda: a * minimum(s(), s()), lambda: a * maximum(x, y) * s(), lambda: a * absolute(x) * s(),
            lambda: a * s() * s() * s(), lambda: a * (1 + s()) * (1 - s()), lambda: a * s() * maximum(0.0, y) + 0.2 * s(),
        ))())
