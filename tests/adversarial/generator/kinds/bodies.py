"""Rigid bodies: one in any angles, tops, trees of joints in space, gimbals, wheels."""

from kinds import kind
from kinds.pieces import chance, decorated, smooth, sum_of
import tree
from tree import angular_velocity, angular_velocity_of, cos, dot, rotation, sin, t

SEQUENCES = ("zxz", "xyx", "yzy", "zyz", "xzx", "yxy", "xyz", "yzx", "zxy", "xzy", "zyx", "yxz")
ANGLES = ("phi", "theta", "psi")


def safe(m, sequence, angles):
    """The second angle is kept from the singularity of the sequence, though not far."""
    proper = sequence[0] == sequence[2]
    m.q_draw[angles[1].data] = (0.15, 2.9) if proper else (-1.35, 1.35)


def orientation(m, rng, angles):
    """A rotation by three angles, of a sequence, or of a product of elementary ones, or in a moving frame."""
    sequence = rng.choice(SEQUENCES)
    safe(m, sequence, angles)
    if chance(rng, 0.5):
        r = rotation(sequence, *angles)
    else:
        r = rotation(sequence[0], angles[0]) * rotation(sequence[1], angles[1]) * rotation(sequence[2], angles[2])
    if chance(rng, 0.3):
        r = rotation(rng.choice("xyz"), m.parameter("turn", draw="rate") * t) * r
    return sequence, r


@kind
def body(m, rng):
    """T = ½ ω·Iω about a fixed point, torques about the axes of the body and of space."""
    angles = [m.coordinate(a) for a in ANGLES]
    sequence, expression = orientation(m, rng, angles)
    r = m.define("r", expression)
    spelling = rng.randrange(3)
    if spelling == 0 and expression.op == "rotation":
        w = m.define("w", angular_velocity_of(sequence, *angles))
    else:
        w = m.define("w", angular_velocity(r))
    i = m.parameter("inertia", (3, 3), draw="inertia")
    m.kinetic.append(kinetic_of(rng, m, i, w))
    center = m.parameter("center", (3,))
    m.potential.append(m.parameter("weight") * (r * center)[2])
    torques(m, rng, r, w)
    m.output("momentum", r * (i * w))
    if chance(rng, 0.5):
        m.output("rate", dot(w))


def kinetic_of(rng, m, i, w):
    return rng.choice((
        lambda: 0.5 * w.dot(i * w), lambda: 0.5 * (w.transpose() * i * w), lambda: 0.5 * (i * w).dot(w),
        lambda: 0.5 * m.parameter("j", draw="positive") * w.norm_squared() + 0.5 * m.parameter("j3", draw="positive") * w[2] ** 2,
        lambda: 0.5 * sum_of([m.parameter(f"j{k}", draw="positive") * w[k] ** 2 for k in range(3)]),
    ))()


def torques(m, rng, r, w):
    if chance(rng, 0.6):
        m.force("w", rng.choice((lambda: m.input("u", (3,)), lambda: -0.3 * w, lambda: m.parameter("tau", (3,)) * sin(t)))())
    if chance(rng, 0.4):
        m.define("space", angular_velocity(r, True))
        m.force("space", m.parameter("wind", (3,)))
    if chance(rng, 0.3):
        m.force("phi", m.parameter("push") * cos(tree.name("psi")))


@kind
def top(m, rng):
    """A top with everything in scalars, symmetric or nearly so, with a moving support."""
    phi, theta, psi = (m.coordinate(a) for a in ANGLES)
    m.q_draw["theta"] = (0.02, 3.1)
    i1, i2, i3 = (m.parameter(p, draw="positive") for p in ("i1", "i2", "i3"))
    i2 = rng.choice((i1, i2))
    w1 = m.define("w1", dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi))
    w2 = m.define("w2", dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi))
    w3 = m.define("w3", dot(phi) * cos(theta) + dot(psi))
    mgl = m.parameter("mgl")
    expanded = 0.5 * i1 * (dot(theta) ** 2 + dot(phi) ** 2 * sin(theta) ** 2) + 0.5 * i3 * w3**2
    m.kinetic.append(rng.choice((0.5 * (i1 * w1**2 + i2 * w2**2 + i3 * w3**2), expanded)))
    if chance(rng, 0.3):
        m.kinetic.append(0.5 * m.parameter("wheel", draw="positive") * (w3 + m.parameter("spin")) ** 2)
    m.potential.append(mgl * cos(theta) * rng.choice((tree.node(1), 1 + 0.3 * sin(2 * t))))
    decorated(m, rng, [phi, theta, psi], 0.3)


@kind
def free_body(m, rng):
    """Six degrees of freedom, the reference point off the centre of mass."""
    p = m.coordinate("p", 3)
    angles = [m.coordinate(a) for a in ANGLES]
    _, expression = orientation(m, rng, angles)
    r = m.define("r", expression)
    w = m.define("w", angular_velocity(r))
    c = m.define("c", tree.family("p") + r * m.parameter("offset", (3,), draw="unit"))
    mass, i = m.parameter("mass", draw="positive"), m.parameter("inertia", (3, 3), draw="inertia")
    m.kinetic += [0.5 * mass * dot(c).norm_squared(), 0.5 * w.dot(i * w)]
    m.potential.append(mass * m.parameter("g") * c[2])
    if chance(rng, 0.5):
        m.define("nozzle", c + r * m.parameter("arm", (3,)))
        m.force("nozzle", r * m.input("thrust", (3,)))
    torques(m, rng, r, w)
    m.output("a", dot(dot(c)))


@kind
def tree_of_joints(m, rng):
    """Two or three links on joints in space, each with a centre of mass and an inertia, in a chain or a fork."""
    n = rng.choice((2, 2, 3))
    rotations, origins = [], []
    g = m.parameter("g")
    for k in range(n):
        q = m.coordinate(f"q{k}")
        parent = k - 1 if k < 2 or chance(rng, 0.6) else 0
        joint = rotation(rng.choice("xyz"), rng.choice((q, q, -q, q + 0.3, 0.5 * q)))
        r = m.define(f"r{k}", rotations[parent] * joint if k else joint)
        arm = m.parameter(f"arm{k}", (3,))
        origin = m.define(f"o{k}", origins[parent] + rotations[parent] * arm) if k else arm
        rotations.append(r)
        origins.append(origin)
        c = m.define(f"c{k}", origin + r * m.parameter(f"center{k}", (3,), draw="unit"))
        mass = m.parameter(f"mass{k}", draw="positive")
        w = m.define(f"w{k}", angular_velocity(r, chance(rng, 0.2)))
        own = m.parameter(f"inertia{k}", (3, 3), draw="inertia")
        m.kinetic.append(0.5 * mass * dot(c).norm_squared() + 0.5 * w.dot(own * w))
        m.potential.append(mass * g * c[2])
    if chance(rng, 0.5):
        m.force(f"w{n - 1}", m.input("torque", (3,)))
    if chance(rng, 0.5):
        m.force(f"c{n - 1}", m.parameter("pull", (3,)) - 0.2 * dot(tree.name(f"c{n - 1}")))
    m.output("tip", dot(dot(tree.name(f"c{n - 1}"))))


@kind
def gimbal(m, rng):
    """Frames in frames: angular velocities add along the axes, the base turns in time."""
    a, b = m.coordinate("a"), m.coordinate("b")
    m.q_draw["b"] = (-1.3, 1.3)
    rate = m.parameter("rate", draw="rate")
    base = rotation(rng.choice("xyz"), rate * t)
    outer = m.define("outer", base * rotation("z", a))
    inner = m.define("inner", outer * rotation("x", b))
    wo, wi = m.define("wo", angular_velocity(outer)), m.define("wi", angular_velocity(inner))
    io, ii = (m.parameter(p, (3, 3), draw="inertia") for p in ("io", "ii"))
    m.kinetic += [0.5 * wo.dot(io * wo), 0.5 * wi.dot(ii * wi)]
    if chance(rng, 0.6):
        spin = m.coordinate("spin")
        axis = tree.node([0, 0, 1])
        m.kinetic.append(0.5 * m.parameter("rotor", draw="positive") * (wi + dot(spin) * axis).norm_squared())
    if chance(rng, 0.7):
        m.force("wi", m.input("u", (3,)))
    if chance(rng, 0.4):
        m.force("wo", m.parameter("f", (3,)) * sin(t))
    m.output("wi", wi)


@kind
def wheel(m, rng):
    """Rolling without slipping in the plane, on a slope that moves, with something that hangs on the hub."""
    phi, theta = m.coordinate("phi"), m.coordinate("theta")
    radius, length = m.parameter("radius", draw="positive"), m.parameter("length", draw="positive")
    m1, m2, j = (m.parameter(p, draw="positive") for p in ("m1", "m2", "j"))
    slope = rng.choice((tree.node(0.1), m.parameter("slope"), 0.2 * sin(t)))
    along = radius * phi
    hub = m.define("hub", [along * cos(slope) - radius * sin(slope), along * sin(slope) + radius * cos(slope)])
    bob = m.define("bob", hub + length * tree.node([sin(theta), -cos(theta)]))
    m.kinetic += [0.5 * m1 * dot(hub).norm_squared(), 0.5 * j * dot(phi) ** 2, 0.5 * m2 * dot(bob).norm_squared()]
    g = m.parameter("g")
    m.potential.append(g * (m1 * hub[1] + m2 * bob[1]))
    if chance(rng, 0.5):
        m.define("relative", theta - phi)
        m.force("relative", m.input("torque"))
    if chance(rng, 0.5):
        m.force("bob", -0.4 * dot(bob))
    m.output("pull", dot(dot(bob)))
