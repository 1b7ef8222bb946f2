"""Events of motions that are split into runs, near the events and at them."""

from kinds import kind
from kinds.pieces import chance
from motions.reference import Asked
import tree
from tree import cos, dot, exp, sin, t

MOTIONS = 8  # Of each model, which takes longer to compile than to integrate.
WAYS_EACH = 20  # To split each motion.


def watch(m, rng, functions):
    for i, g in enumerate(functions):
        m.event(f"event{i}", g)
    m.taylor = True
    m.motion = Asked((3.0, 8.0), ("taylor", "taylor", "dop853", "dop853", "runge_kutta"), states=MOTIONS, split=WAYS_EACH, functions=len(functions))


def functions(m, rng, qs, count=4):
    x, y = qs[0], qs[-1]
    c, w = m.parameter("level", draw="unit"), m.parameter("rate", draw="positive")
    all_of = [
        lambda: x - c, lambda: dot(x), lambda: x + y, lambda: dot(y) - c, lambda: x**2 + y**2 - 0.6, lambda: sin(w * t), lambda: t - 1.5, lambda: x * dot(y) - 0.1,
        lambda: sin(2 * x), lambda: cos(3 * t) - c, lambda: 2 * x - sin(t), lambda: exp(x) - 1.2, lambda: (t - 1) * (t - 2.5), lambda: dot(x) ** 2 - 0.3,
        lambda: x - 0.5, lambda: t**3 - 5, lambda: tree.atan(x - c), lambda: dot(x) + x,
    ]
    return [g() for g in rng.sample(all_of, count)]


@kind
def watched_oscillators(m, rng):
    """Springs, damped, driven, coupled or not."""
    qs = [m.coordinate(c) for c in ("x", "y", "z")[: rng.randint(1, 3)]]
    for i, x in enumerate(qs):
        m.kinetic.append(0.5 * m.parameter(f"m{i}", draw="positive") * dot(x) ** 2)
        m.potential.append(0.5 * m.parameter(f"k{i}", draw="positive") * x**2)
    if chance(rng, 0.5):
        m.potential.append(0.5 * m.parameter("coupling", draw="positive") * (qs[0] - qs[-1]) ** 2)
    if chance(rng, 0.4):
        m.dissipation.append(0.1 * m.parameter("friction", draw="positive") * dot(qs[0]) ** 2)
    if chance(rng, 0.4):
        m.force(qs[-1].data, m.parameter("drive") * cos(1.7 * t))
    watch(m, rng, functions(m, rng, qs))


@kind
def watched_falls(m, rng):
    """Motions that are polynomials: the Taylor method takes them in a step, and their events are at simple numbers."""
    x, y = m.coordinate("x"), m.coordinate("y")
    g = m.parameter("g", draw="positive")
    m.kinetic.append(0.5 * (dot(x) ** 2 + dot(y) ** 2))
    m.potential.append(g * y + (m.parameter("wind", draw="unit") * x if chance(rng, 0.5) else 0 * x))
    watch(m, rng, [y, dot(y), *functions(m, rng, [x, y], 3)])
    if chance(rng, 0.5):
        # At t = 1 it is at the floor: from y = 5 at rest under g = 10.
        m.q_draw["y"] = (5.0, 5.0)


@kind
def watched_pendulums(m, rng):
    """Pendulums, single and double."""
    double = chance(rng, 0.5)
    qs = [m.coordinate(c) for c in (("theta", "phi") if double else ("theta",))]
    theta, phi = qs[0], qs[-1]
    g = m.parameter("g", draw="positive")
    m.kinetic.append(0.5 * dot(theta) ** 2)
    m.potential.append(-g * cos(theta))
    if double:
        mass = m.parameter("m", draw="positive")
        m.kinetic.append(0.5 * mass * (dot(theta) ** 2 + dot(phi) ** 2 + 2 * cos(theta - phi) * dot(theta) * dot(phi)))
        m.potential.append(-mass * g * (cos(theta) + cos(phi)))
    watch(m, rng, [sin(theta), *functions(m, rng, qs, 3)])
    m.motion.span = (2.0, 6.0)


@kind
def watched_pairs(m, rng):
    """Two zeros of an event that are close to each other: the Taylor method finds both, wherever the runs end."""
    qs = [m.coordinate(c) for c in ("x", "y")[: rng.randint(1, 2)]]
    x, y = qs[0], qs[-1]
    for i, q in enumerate(qs):
        m.kinetic.append(0.5 * m.parameter(f"m{i}", draw="positive") * dot(q) ** 2)
        k = m.parameter(f"k{i}", draw="positive")
        m.potential.append(rng.choice((lambda: 0.5 * k * q**2, lambda: k * (1 - cos(q)), lambda: k * q, lambda: 0.5 * k * q**2 + 0.1 * q**4))())
    height = m.parameter("height")
    value, rate = rng.choice(((x, dot(x)), (x * y, dot(x * y)), (sin(2 * t) + x, 2 * cos(2 * t) + dot(x)), (x**2 + y, 2 * x * dot(x) + dot(y))))
    m.taylor = True
    m.event("near", value - height)
    m.event("turning", rate)
    m.motion = Asked((2.0, 6.0), ("taylor",), states=MOTIONS, split=WAYS_EACH, functions=2, pair="height")
