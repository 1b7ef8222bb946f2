"""Models with ignorable coordinates, which have reduced models, too."""

from kinds import kind
from kinds.pieces import chance, smooth, sum_of
import tree
from tree import angular_velocity_of, cos, dot, rotation, sin, t

IGNORABLE = ("phi", "psi", "chi")
REMAINING = ("x", "theta", "z")


def split_coordinates(m, rng, ignorable, remaining):
    """Both kinds of coordinates, in any order."""
    names = rng.sample([*ignorable, *remaining], len(ignorable) + len(remaining))
    found = {name: m.coordinate(name) for name in names}
    m.ignorable = list(ignorable)
    m.half_angles = chance(rng, 0.4)
    return [found[name] for name in ignorable], [found[name] for name in remaining]


def confined(m, rng, xs, rates):
    """Potentials of every remaining coordinate, so that none is ignorable, and terms linear in velocities."""
    atoms = [*xs] + ([t] if chance(rng, 0.3) else [])
    for i, x in enumerate(xs):
        k = m.parameter(f"k{i}", draw="positive")
        m.potential.append(rng.choice((lambda: k * cos(x), lambda: 0.5 * k * x**2, lambda: k * sin(x) ** 2))())
    if chance(rng, 0.4):
        m.potential.append(m.parameter("c") * smooth(rng, atoms))
    if chance(rng, 0.5):
        for rate in rates:
            m.potential.append(smooth(rng, atoms) * rate)


def acted_on(m, rng, xs, turning):
    """Forces on what remains, which may depend on the velocities of what is ignorable; dissipation; outputs."""
    atoms = [*xs, t, *(dot(x) for x in xs), *(dot(y) for y in turning)]
    if chance(rng, 0.5):
        m.force(rng.choice(xs).data, m.input("u") * smooth(rng, atoms, 1))
    if chance(rng, 0.4):
        m.dissipation.append(0.5 * m.parameter("friction", draw="positive") * dot(rng.choice(xs)) ** 2)
    if chance(rng, 0.6):
        m.output("turning", dot(rng.choice(turning)) * smooth(rng, [*xs], 1))
    if chance(rng, 0.6):
        m.output("accelerating", tree.node([dot(dot(rng.choice(turning))), dot(dot(rng.choice(xs))) + rng.choice(atoms)]))


@kind
def ignorable_forms(m, rng):
    """T as squares of linear forms of all velocities, whose coefficients depend on what remains."""
    turning, xs = split_coordinates(m, rng, IGNORABLE[: rng.randint(1, 3)], REMAINING[: rng.randint(1, 3)])
    rates = [dot(y) for y in turning]
    atoms = [*xs] + ([t] if chance(rng, 0.2) else [])
    for i, y in enumerate(turning):
        inertia = rng.choice((lambda: 1 + smooth(rng, atoms) ** 2, lambda: 1 + 0.5 * sin(xs[0]), lambda: tree.node(1)))()
        m.kinetic.append(0.5 * m.parameter(f"i{i}", draw="positive") * inertia * dot(y) ** 2)
    for i, x in enumerate(xs):
        form = dot(x)
        for rate in rates:
            if chance(rng, 0.5):
                form = form + rng.choice((lambda: m.parameter("a"), lambda: smooth(rng, atoms), lambda: cos(x)))() * rate
        if chance(rng, 0.2):
            form = form + sin(t)
        m.kinetic.append(0.5 * m.parameter(f"m{i}", draw="positive") * form**2)
    confined(m, rng, xs, [*rates, dot(xs[0])])
    acted_on(m, rng, xs, turning)


@kind
def ignorable_angles(m, rng):
    """A symmetric body in Euler angles, on a fixed point or on one that moves, perhaps with a rotor along its axis."""
    angles = ("phi", "theta", "psi")
    moves, rotor = chance(rng, 0.5), chance(rng, 0.3)
    ignorable = ("phi", "psi", "chi") if rotor else ("phi", "psi")
    turning, xs = split_coordinates(m, rng, ignorable, ("theta", "z") if moves else ("theta",))
    theta = xs[0]
    m.q_draw["theta"] = (0.4, 2.7)
    w = m.define("w", angular_velocity_of("zxz", *(tree.name(a) for a in angles)))
    i, i_s, l = m.parameter("i", draw="positive"), m.parameter("i_s", draw="positive"), m.parameter("l", draw="unit")
    m.kinetic.append(0.5 * w.dot(tree.node([i * w[0], i * w[1], i_s * w[2]])) if chance(rng, 0.5) else
                     sum_of([0.5 * i * w[0] ** 2, 0.5 * i * w[1] ** 2, 0.5 * i_s * w[2] ** 2]))
    if rotor:
        m.kinetic.append(0.5 * m.parameter("j", draw="positive") * (w[2] + dot(turning[2])) ** 2)
    mass = m.parameter("m", draw="positive")
    center = m.define("center", rotation("zxz", *(tree.name(a) for a in angles)) * tree.node([0, 0, l]))
    if moves:
        center = m.define("place", center + tree.node([0, 0, xs[1]]))
        m.potential.append(0.5 * m.parameter("k", draw="positive") * xs[1] ** 2)
    m.kinetic.append(0.5 * mass * dot(center).norm_squared())
    m.potential.append(mass * m.parameter("g", draw="positive") * center[2] + m.parameter("field", draw="positive") * sin(theta) ** 2)
    if chance(rng, 0.4):
        m.potential.append(m.parameter("charge") * cos(theta) * dot(turning[0]))
    acted_on(m, rng, xs, turning)


@kind
def ignorable_general(m, rng):
    """A general Lagrangian, of the fourth degree in what remains and of the second in what is ignorable."""
    turning, xs = split_coordinates(m, rng, IGNORABLE[: rng.randint(1, 2)], REMAINING[: rng.randint(1, 2)])
    rates, slow = [dot(y) for y in turning], [dot(x) for x in xs]
    terms = []
    for i, (x, rate) in enumerate(zip(xs, slow)):
        terms += [0.5 * m.parameter(f"m{i}", draw="positive") * rate**2, 0.05 * rate**4, -m.parameter(f"k{i}", draw="positive") * cos(x)]
    for i, rate in enumerate(rates):
        terms.append(0.5 * m.parameter(f"i{i}", draw="positive") * (1 + smooth(rng, [*xs]) ** 2 + 0.2 * rng.choice(slow) ** 2) * rate**2)
        terms.append(smooth(rng, [*xs, *slow], 1) * rate)
    if len(rates) > 1:
        # As a square: the inertia of what is ignorable stays definite, and is eliminated without interchanges.
        terms.append(0.05 * (rates[0] + sin(xs[0]) * rates[1]) ** 2)
    m.lagrangian = sum_of(terms)
    acted_on(m, rng, xs, turning)
