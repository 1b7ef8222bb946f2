"""Forces on coordinates, positions, angles, velocities and families; dissipation; inputs; external functions."""

from kinds import kind
from kinds.pieces import any_function, chance, coordinates, decorated, diagonal, pair, smooth, sum_of
import tree
from tree import cos, dot, exp, rotation, sin, t, tanh


@kind
def forces_on_positions(m, rng):
    """Q = F·∂p/∂q for positions that also move in time."""
    qs = coordinates(m, rng, 1, 3)
    m.kinetic.append(diagonal(m, rng, qs))
    atoms = [*qs, t] if chance(rng, 0.4) else qs
    p = m.define("p", [qs[0] * smooth(rng, qs, 1), *(smooth(rng, atoms) for _ in range(rng.choice((1, 2))))])
    size = len(m.definitions[-1].expression.args)
    m.kinetic.append(0.5 * m.parameter("mass", draw="positive") * dot(p).norm_squared())
    m.force("p", rng.choice((
        lambda: m.input("f", (size,)), lambda: m.parameter("f", (size,)) * sin(t), lambda: -0.3 * dot(p),
        lambda: -0.2 * dot(p).norm_squared() * dot(p) + m.input("f", (size,)), lambda: -p,
    ))())
    angle = m.define("angle", sum_of([rng.choice((1, 2, -1)) * x for x in qs]))
    if chance(rng, 0.6):
        m.force("angle", m.parameter("torque") - 0.2 * dot(angle))
    m.output("power", dot(p).norm_squared() + dot(dot(angle)))
    decorated(m, rng, qs, 0.2)


@kind
def forces_on_velocities(m, rng):
    """Q = F·∂w/∂q̇, where some components of w are free of q̇, and the frame moves."""
    qs = coordinates(m, rng, 2, 3)
    m.kinetic.append(diagonal(m, rng, qs))
    atoms = [*qs, t]
    x, y = qs[0], qs[1]
    rate = m.parameter("rate", draw="rate")
    r = m.define("r", [x, y, smooth(rng, [x, y], 1)])
    frame = m.define("frame", rotation(rng.choice("xyz"), rng.choice((rate * t, x, rate * t + y))))
    w = m.define("w", rng.choice((
        lambda: dot(r), lambda: frame.transpose() * dot(r), lambda: dot(r) + tree.node([0, 0, rate]).cross(r),
        lambda: tree.angular_velocity(frame * rotation("y", y)), lambda: tree.angular_velocity(frame * rotation("x", x), True),
        lambda: dot(frame * r), lambda: tree.node([dot(x), rate * x, smooth(rng, atoms, 1) * dot(y) + rate]),
    ))())
    m.force("w", rng.choice((
        lambda: m.input("f", (3,)), lambda: m.parameter("f", (3,)), lambda: -0.3 * w, lambda: -0.2 * w.norm() * w,
        lambda: m.parameter("f", (3,)).cross(w),
    ))())
    m.output("w", w)
    m.output("rate_of_w", dot(w))
    decorated(m, rng, qs, 0.2)


@kind
def dissipation(m, rng):
    """Rayleigh's function and its generalizations, of coordinates too."""
    qs = coordinates(m, rng, 2, 4)
    m.kinetic.append(diagonal(m, rng, qs))
    rates = [dot(x) for x in qs]
    c = m.parameter("c", draw="positive")
    r, s = rng.choice(rates), rng.choice(rates)
    x, y = pair(rng, qs)
    for _ in range(rng.randint(1, 3)):
        m.dissipation.append(rng.choice((
            lambda: 0.5 * c * (r - s) ** 2 + 0.1 * r**2, lambda: c * tree.absolute(r) ** 3 / 3, lambda: 0.5 * c * (r * cos(x) + s * sin(y)) ** 2,
            lambda: c * tree.ln(tree.cosh(r / 0.3)) * 0.3, lambda: c * tree.sqrt(r**2 + 0.01), lambda: 0.25 * c * r**4 * exp(-(x**2)),
            lambda: 0.5 * c * (1 + sin(t)) * (r + dot(sin(y))) ** 2, lambda: 0.5 * c * dot(x * y) ** 2, lambda: c * (r**2) ** tree.node(1.5),
        ))())
    decorated(m, rng, qs, 0.3)


@kind
def inputs(m, rng):
    """Inputs in forces, in potentials, in vectors; they are not differentiated in time."""
    qs = coordinates(m, rng, 2, 3)
    m.kinetic.append(diagonal(m, rng, qs))
    u, v = m.input("u"), m.input("v", (2,))
    x, y = pair(rng, qs)
    m.potential.append(u * smooth(rng, qs, 1) + 0.5 * m.parameter("k", draw="positive") * (x - v[0]) ** 2)
    m.force(qs[0].data, u**2 * sin(y) - v[1] * dot(x))
    m.define("p", [sin(x) * y, cos(x) + y])
    m.force("p", v * exp(-(u**2)))
    if chance(rng, 0.4):
        m.potential.append(u * x * sin(y + t))
    if chance(rng, 0.4):
        m.dissipation.append(0.5 * (1 + u**2) * dot(y) ** 2)
    if chance(rng, 0.3):
        m.force(qs[1].data, tree.maximum(u, v[0]) + tree.absolute(u - 0.4) * tanh(dot(y)))
    m.output("load", u * dot(dot(x)) + v.norm_squared())


@kind
def outputs(m, rng):
    """Accelerations of all kinds of quantities."""
    qs = coordinates(m, rng, 2, 3)
    m.kinetic.append(diagonal(m, rng, qs))
    x, y = pair(rng, qs)
    m.kinetic.append(0.5 * (dot(x) * smooth(rng, qs, 1) + dot(y)) ** 2)
    m.potential.append(m.parameter("g") * smooth(rng, qs))
    p = m.define("p", [smooth(rng, [*qs, t]) for _ in range(3)])
    m.output("a", dot(dot(p)))
    m.output("curvature", dot(p).cross(dot(dot(p))).norm() / (0.5 + dot(p).norm_squared()))
    m.output("rate_of_energy", dot(0.5 * dot(x) ** 2 + smooth(rng, qs, 1)))
    m.output("jump", tree.maximum(dot(dot(x)), dot(y)) + any_function(rng, dot(x), y))
    m.output("matrix", p.outer(dot(p)) if chance(rng, 0.5) else rotation("zxz", x, y, t))
    decorated(m, rng, qs, 0.4)


@kind
def outside(m, rng):
    """External functions, with their derivatives."""
    qs = coordinates(m, rng, 1, 3)
    s, u = tree.name("s"), tree.name("u")
    bump, slope = tree.call("external_bump", s), tree.call("external_plane", s, u)
    m.functions.append(tree.External("external_bump", ("s",), exp(-(s**2)), (-2 * s * bump,)))
    m.functions.append(tree.External("external_plane", ("s", "u"), sin(s) * u**2, (cos(s) * u**2, 2 * sin(s) * u)))
    m.kinetic.append(diagonal(m, rng, qs))
    x, y = pair(rng, qs)
    m.kinetic.append(0.5 * (dot(x) + tree.call("external_bump", smooth(rng, qs, 1)) * dot(y)) ** 2)
    m.potential.append(m.parameter("k") * tree.call("external_plane", smooth(rng, qs, 1), y))
    m.force(qs[0].data, tree.call("external_plane", dot(x), t) - tree.call("external_bump", dot(y)) * m.input("push"))
    m.output("value", dot(tree.call("external_plane", x, y)))
