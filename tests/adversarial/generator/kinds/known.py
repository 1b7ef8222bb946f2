"""Declarations whose equations came out wrong once, with the states where they did."""

from kinds import kind
from tree import absolute, cos, dot, maximum, rotation, sqrt, t
import tree


@kind
def free_component(m, rng):
    """A force on a velocity of which one component is free of q̇: Q = F·∂v/∂q̇ = 3."""
    x = m.coordinate("x")
    mass, rate = m.parameter("m", draw="positive"), m.parameter("rate")
    f = m.input("f", (2,))
    m.define("v", [dot(x), rate * x])
    m.kinetic.append(0.5 * mass * tree.name("v").norm_squared())
    m.force("v", f)
    m.states.append({"q": [0.5], "v": [0.7], "m": 1.0, "rate": 2.0, "f": [3.0, 5.0]})


@kind
def body_in_a_frame(m, rng):
    """A torque on an angular velocity of which one component has no q̇."""
    theta = m.coordinate("theta")
    rate, i = m.parameter("rate"), m.parameter("i", draw="positive")
    f = m.input("f", (3,))
    m.define("r", rotation("z", rate * t) * rotation("y", theta))
    m.define("w", tree.angular_velocity(tree.name("r")))
    m.kinetic.append(0.5 * i * tree.name("w").norm_squared())
    m.force("w", f)
    m.states.append({"q": [0.7], "v": [0.3], "rate": 2.0, "i": 1.0, "f": [3.0, 5.0, 7.0]})


@kind
def jump_in_a_square(m, rng):
    x, y, z = (m.coordinate(c) for c in "xyz")
    a, b, c = (m.parameter(p, draw="positive") for p in "abc")
    factor = rng.choice((absolute(x - 2.0), maximum(x, 2.0)))
    m.kinetic.append(0.5 * a * dot(x) ** 2 + 0.5 * b * dot(y) ** 2 + 0.5 * c * (dot(z) + factor * dot(y)) ** 2)
    values = {"a": 1.3, "b": 1.7, "c": 2.1}
    m.states.append({"q": [5.7, -5.8, -6.0], "v": [1.0, 1.5, 2.0], **values})
    m.states.append({"q": [-1.0, -5.8, -6.0], "v": [1.0, 1.5, 2.0], **values})


@kind
def root_in_a_square(m, rng):
    x, y = (m.coordinate(c) for c in "xy")
    mass = m.parameter("m", draw="positive")
    vanishing = sqrt(2 * (1 + cos(y))) + 2 * cos(0.5 * y)
    m.kinetic.append(0.5 * mass * (dot(x) ** 2 + dot(y) ** 2) + 0.5 * mass * (vanishing * dot(x)) ** 2)
    m.states.append({"q": [0.3, 0.5], "v": [1.0, 2.0], "m": 1.0})


@kind
def root_in_the_potential(m, rng):
    x, y = (m.coordinate(c) for c in "xy")
    a = m.parameter("a", draw="positive")
    m.kinetic.append(0.5 * a * (dot(x) ** 2 + dot(y) ** 2))
    m.potential.append((sqrt(x**2 - 12 * x + 36) + x - 6) * dot(y))
    m.states.append({"q": [8.0, 0.4], "v": [0.5, 2.0], "a": 1.0})
    m.states.append({"q": [2.0, 0.4], "v": [0.5, 2.0], "a": 1.0})


@kind
def root_in_a_form(m, rng):
    """A factor that vanishes on one branch, in one form beside another."""
    theta, s = m.coordinate("theta"), m.coordinate("s")
    m0, m1 = m.parameter("m0", draw="positive"), m.parameter("m1", draw="positive")
    factor = sqrt(2 * (1 + cos(s))) + rng.choice((2, -2)) * cos(0.5 * s)
    m.kinetic.append(0.5 * m0 * dot(theta) ** 2 + 0.5 * m1 * dot(s) ** 2)
    m.kinetic.append(0.5 * (dot(s) + factor * dot(theta)) ** 2 + 0.5 * (dot(s) + dot(theta)) ** 2)
    m.states.append({"q": [-1.7, -2.5], "v": [-1.25, -0.17], "m0": 2.0, "m1": 2.2})
    m.states.append({"q": [-1.7, 4.5], "v": [-1.25, -0.17], "m0": 2.0, "m1": 2.2})


@kind
def root_of_a_speed(m, rng):
    """√(ẏ²) in the Lagrangian: its slope, the sign of ẏ, belongs to the momentum."""
    y = m.coordinate("y")
    c = m.parameter("c", draw="positive")
    root = sqrt(dot(y) ** 2)
    m.lagrangian = 0.5 * dot(y) ** 2 + c * (root * cos(y) if rng.random() < 0.5 else root)
    m.states.append({"q": [0.5], "v": [-1.25], "c": 2.0})
    m.states.append({"q": [0.5], "v": [1.25], "c": 2.0})


@kind
def vanishing_drift(m, rng):
    """A drift that vanishes on one branch, in a form."""
    x, y = m.coordinate("x"), m.coordinate("y")
    m0, m1 = m.parameter("m0", draw="positive"), m.parameter("m1", draw="positive")
    drift = sqrt(2 * (1 + cos(y))) + rng.choice((2, -2)) * cos(0.5 * y)
    m.kinetic.append(0.5 * m0 * dot(x) ** 2 + 0.5 * m1 * dot(y) ** 2 + 0.5 * (dot(x) + drift) ** 2)
    m.states.append({"q": [0.3, 2.5], "v": [-1.25, -0.17], "m0": 2.0, "m1": 2.2})
    m.states.append({"q": [0.3, 4.5], "v": [-1.25, -0.17], "m0": 2.0, "m1": 2.2})


@kind
def constrained_past_a_pivot(m, rng):
    """The gradient by the coordinate that is eliminated first vanishes at z = π/2, where that by the other does not."""
    z, alpha = m.coordinate("z"), m.coordinate("alpha")
    mass = m.parameter("m", draw="positive")
    m.kinetic.append(0.5 * mass * (dot(z) ** 2 + (2 + tree.sin(z)) * dot(alpha) ** 2))
    m.potential.append(mass * z * alpha)
    m.output("force", m.constraint("held", tree.sin(z) + 0.75 * alpha))
    m.taylor = True
    for z in (1.5, 1.57, 1.5707963, 1.5707963267948966):
        m.states.append({"q": [z, -1.3], "v": [0.7, -0.4], "m": 1.5})


@kind
def constrained_follower(m, rng):
    """A follower without mass, of which the gradient by the cam vanishes at θ = 0."""
    s, theta = m.coordinate("s"), m.coordinate("theta")
    j, k = m.parameter("j", draw="positive"), m.parameter("k", draw="positive")
    m.kinetic.append(0.5 * j * dot(theta) ** 2)
    m.potential.append(0.5 * k * s**2)
    m.output("force", m.constraint("cam", s - 0.3 * cos(theta)))
    m.taylor = True
    for theta in (0.1, 0.01, 1e-4, 1e-9, 0.0):
        m.states.append({"q": [0.3, theta], "v": [0.2, 5.0], "j": 1.5, "k": 40.0})


@kind
def constrained_coupled_inertia(m, rng):
    """The inertia that is left of s without θ is a small part of what it is."""
    theta, s = m.coordinate("theta"), m.coordinate("s")
    m0, m1 = m.parameter("m0", draw="positive"), m.parameter("m1", draw="positive")
    m.kinetic.append(0.5 * m0 * dot(theta) ** 2 + 0.5 * m1 * dot(s) ** 2 + 0.5 * (dot(s) + 2 * s * dot(theta)) ** 2)
    m.constraint("held", tree.exp(0.3 * theta) - cos(1.5 * s))
    m.states.append({"q": [-0.0024, -0.0253], "v": [-0.06, -0.3], "m0": 2.5e-7, "m1": 2.1e-4})


@kind
def constrained_chain_without_mass(m, rng):
    """A pivot that vanishes identically, though not in its terms."""
    y, theta, z, s, beta = (m.coordinate(c) for c in ("y", "theta", "z", "s", "beta"))
    m.kinetic.append(0.5 * m.parameter("m0", draw="positive") * dot(s) ** 2 + 0.5 * m.parameter("m1", draw="positive") * dot(beta) ** 2)
    m.potential.append(m.parameter("k") * sqrt(1 + y**2))
    m.constraint("first", 3 * y + 0.2 * tree.sin(y) - beta)
    m.constraint("second", theta - sqrt(1 + y**2))
    m.constraint("third", 2 * z + 0.2 * tree.sin(z) - (0.5 * s - y) / (2 + y**4))
    m.slip("slip", dot(s) - tree.sin(beta) * dot(beta))
    m.output("force", tree.reaction("third") + tree.reaction("slip"))
    m.states.append({"q": [0.3, 1.1, -0.4, 0.8, 1.2], "v": [0.2, 0.1, -0.7, 0.5, 0.4], "m0": 1.5, "m1": 0.7, "k": 2.0})
