"""Constraints: relations at random, of positions and velocities, linkages, bars, bodies on joints, massless coordinates, drives."""

from kinds import kind
from kinds.energies import general as general_lagrangian, indefinite
from kinds.pieces import chance, constant, coordinates, decorated, diagonal, pair, position_atoms, smooth, sum_of
import tree
from tree import cos, dot, exp, member, name, rotation, sin, t, total


def observed(m, rng, qs, scalars=(), vectors=()):
    """Outputs with multipliers, and clauses by the lot."""
    x, y = pair(rng, qs)
    for k, c in enumerate(scalars):
        if chance(rng, 0.4):
            m.output(f"reaction{k}", rng.choice((
                lambda: c, lambda: c * dot(x), lambda: c * sin(y) - dot(dot(x)), lambda: c**2 / (1 + c**2), lambda: tree.maximum(c, dot(y)),
            ))())
    for k, c in enumerate(vectors):
        if chance(rng, 0.6):
            m.output(f"force{k}", rng.choice((
                lambda: c, lambda: c.norm_squared(), lambda: 2 * c - dot(x) * c, lambda: c.norm() * dot(dot(y)), lambda: c[1] * x,
            ))())
    if scalars and chance(rng, 0.2):
        m.event("lift", rng.choice(scalars) - 0.5 * x)
    m.taylor = chance(rng, 0.5)
    m.energy_balance = chance(rng, 0.5)


def relation(m, rng, own, others, i):
    """A relation of coordinates that contains one of them in any case."""
    atoms = [*others, *([m.parameter(f"b{i}")] if chance(rng, 0.5) else []), *([t] if chance(rng, 0.3) else [])]
    other = rng.choice(others)
    length = m.parameter(f"r{i}", draw="positive")
    return rng.choice((
        lambda: constant(rng) * own - smooth(rng, atoms), lambda: own**2 + other**2 - length**2, lambda: smooth(rng, atoms) + length * own,
        lambda: sin(own) - 0.5 * smooth(rng, atoms, 1), lambda: own * (2 + cos(other)) - length * smooth(rng, atoms, 1),
        lambda: (own - other) ** 2 + smooth(rng, atoms, 1) - length, lambda: own * other - length, lambda: exp(0.3 * own) - smooth(rng, atoms),
        lambda: tree.sqrt(1 + own**2 + other**2) - length - 1, lambda: own**3 - smooth(rng, atoms, 1) ** 2 - length * t,
        lambda: tree.atan2(sin(own), 2 + cos(other)) - 0.2 * length * other,
    ))()


@kind
def constrained_positions(m, rng):
    """Holonomic relations at random, scalars or the components of a vector."""
    qs = coordinates(m, rng, 2, 5)
    m.kinetic.append(diagonal(m, rng, qs))
    atoms = position_atoms(m, rng, qs)
    if chance(rng, 0.6):
        x, y = pair(rng, qs)
        m.kinetic.append(0.5 * (dot(x) + smooth(rng, atoms, 1) * dot(y)) ** 2)
    count = rng.randint(1, min(4, len(qs) - 1))
    free = lambda i: [y for k, y in enumerate(qs) if k > i or k < i and chance(rng, 0.3)]
    relations = [relation(m, rng, qs[i], free(i), i) for i in range(count)]
    scalars, vectors = [], []
    if count > 1 and chance(rng, 0.4):
        vectors.append(m.constraint("held", relations))
    else:
        scalars = [m.constraint(f"held{i}", e) for i, e in enumerate(relations)]
    decorated(m, rng, qs, 0.3)
    observed(m, rng, qs, scalars, vectors)


@kind
def constrained_velocities(m, rng):
    """Relations that are linear in the velocities or affine, beside holonomic ones."""
    qs = coordinates(m, rng, 2, 5)
    m.kinetic.append(diagonal(m, rng, qs))
    atoms = position_atoms(m, rng, qs)
    if chance(rng, 0.5):
        x, y = pair(rng, qs)
        m.kinetic.append(0.5 * (dot(x) * smooth(rng, atoms, 1) + dot(y)) ** 2)
    count = rng.randint(1, min(3, len(qs) - 1))
    slips = [slip(m, rng, qs, i, atoms) for i in range(count)]
    scalars, vectors = [], []
    if count > 1 and chance(rng, 0.4):
        vectors.append(m.slip("slip", slips))
    else:
        scalars = [m.slip(f"slip{i}", e) for i, e in enumerate(slips)]
    if len(qs) > count + 1 and chance(rng, 0.4):
        scalars.append(m.constraint("held", relation(m, rng, qs[count], qs[count + 1 :], count)))
    decorated(m, rng, qs, 0.3)
    observed(m, rng, qs, scalars, vectors)


def slip(m, rng, qs, i, atoms):
    """A relation of velocities that contains the one of a coordinate in any case."""
    others = [y for k, y in enumerate(qs) if k > i or k < i and chance(rng, 0.2)]
    lead = rng.choice((
        lambda: dot(qs[i]), lambda: (2 + sin(rng.choice(others))) * dot(qs[i]), lambda: m.parameter(f"lead{i}", draw="positive") * dot(qs[i]),
        lambda: dot(qs[i] + 0.3 * smooth(rng, others, 1)), lambda: -dot(qs[i]) * (1.5 + smooth(rng, others, 1) ** 2),
    ))()
    e = lead
    for y in others[: rng.randint(1, 2)]:
        e = e - rng.choice((lambda: smooth(rng, [*atoms, *others], 1) * dot(y), lambda: m.parameter(f"c{i}") * dot(y), lambda: sin(y) * dot(y)))()
    if chance(rng, 0.3):
        e = e + smooth(rng, atoms, 1)
    if chance(rng, 0.3):
        e = e - m.parameter(f"drift{i}") * rng.choice((tree.node(1), sin(t), t))
    return e


@kind
def constrained_loops(m, rng):
    """A planar chain of links that ends at a point, which may slide or move, with a motor or without."""
    n = rng.randint(2, 4)
    links = [m.coordinate(f"a{k}") for k in range(n)]
    is_relative = chance(rng, 0.4)
    angles = [sum_of(links[: k + 1]) if is_relative else a for k, a in enumerate(links)]
    tip, g = tree.node([0, 0]), m.parameter("g")
    for k, a in enumerate(angles):
        length = m.parameter(f"l{k}", draw="positive")
        axis = tree.node([cos(a), sin(a)])
        center = m.define(f"c{k}", tip + rng.choice((0.5 * length, m.parameter(f"s{k}"))) * axis)
        tip = m.define(f"p{k}", tip + length * axis)
        mass = m.parameter(f"m{k}", draw="positive")
        m.kinetic.append(0.5 * mass * dot(center).norm_squared())
        if k == 0 or chance(rng, 0.8):
            m.kinetic.append(0.5 * m.parameter(f"j{k}", draw="positive") * dot(a) ** 2)
        m.potential.append(mass * g * center[1])
    end, sliding = end_of_chain(m, rng)
    vectors = [m.constraint("closure", rng.choice((tip - end, end - tip, 2 * (tip - end))))]
    scalars = []
    if n + len(sliding) > 2 and chance(rng, 0.4):
        scalars.append(m.constraint("motor", links[0] - rng.choice((m.parameter("speed", draw="rate") * t, sin(t), m.parameter("held")))))
    decorated(m, rng, [*links, *sliding], 0.2)
    observed(m, rng, [*links, *sliding], scalars, vectors)


def end_of_chain(m, rng):
    """Where a chain ends, and the coordinates that the place has."""
    choice = rng.randrange(3)
    if choice == 0:
        return m.parameter("end", (2,)), []
    if choice == 1:
        rate = m.parameter("rate", draw="rate")
        return tree.node([1.5 + 0.2 * cos(rate * t), m.parameter("height") * sin(rate * t)]), []
    s = m.coordinate("s")
    m.kinetic.append(0.5 * m.parameter("slider", draw="positive") * dot(s) ** 2)
    return s * m.parameter("rail", (2,)) if chance(rng, 0.4) else tree.node([s, m.parameter("offset")]), [s]


@kind
def constrained_points(m, rng):
    """Points in a plane that bars of a family connect, on a support, with an end that is held or not."""
    n = rng.randint(2, 5)
    m.coordinate("x", n), m.coordinate("y", n)
    m.parameter("m", family=n, draw="positive"), m.parameter("l", family=n, draw="positive")
    i, at = ("i", 0), lambda offset: ("i", offset)
    point = lambda k: tree.node([member("x", k), member("y", k)])
    speed = dot(member("x", i)) ** 2 + dot(member("y", i)) ** 2
    m.kinetic.append(total("i", 0, n, 0.5 * member("m", i) * speed))
    m.potential.append(m.parameter("g") * total("i", 0, n, member("m", i) * member("y", i)))
    square = lambda e, l: rng.choice((lambda: e.norm_squared() - l**2, lambda: e.dot(e) - l**2, lambda: 0.5 * (e[0] ** 2 + e[1] ** 2 - l**2)))()
    form = rng.choice((square, square, lambda e, l: e.norm() - l))
    support = rng.choice((tree.node([0, 0]), tree.node([0.3 * sin(t), 0]), m.parameter("support", (2,))))
    first = form(point(0) - support, member("l", 0))
    if chance(rng, 0.5):
        m.define("p", point(i), (i,), (("i", 0, n),))
        between = member("p", i) - member("p", at(-1))
    else:
        between = point(i) - point(at(-1))
    m.constraint("bar", first, (0,))
    m.constraint("bar", form(between, member("l", i)), (i,), (("i", 1, n),))
    scalars, vectors = [tree.reaction("bar", 0), tree.reaction("bar", n - 1)], []
    if chance(rng, 0.3):
        vectors.append(m.constraint("end", point(n - 1) - m.parameter("place", (2,))))
    elif chance(rng, 0.3):
        scalars.append(m.constraint("rail", member("y", n - 1) - 0.3 * sin(member("x", n - 1)) - m.parameter("height")))
    qs = [member(c, k) for c in "xy" for k in range(n)]
    if chance(rng, 0.3):
        m.dissipation.append(total("i", 0, n, 0.5 * m.parameter("drag", draw="positive") * speed))
    if chance(rng, 0.3):
        m.force("x", m.input("u") * cos(member("y", 0)), indices=(n - 1,))
    if chance(rng, 0.3):
        m.output("sum", total("i", 0, n, tree.reaction("bar", i) * member("l", i)))
    observed(m, rng, qs, scalars, vectors)


@kind
def constrained_without_mass(m, rng):
    """Coordinates without inertia, whose motion constraints determine."""
    if chance(rng, 0.3):
        return massless_rod(m, rng)
    qs = coordinates(m, rng, 2, 5)
    count = rng.randint(1, len(qs) - 1)
    massless, heavy = qs[:count], qs[count:]
    m.kinetic.append(diagonal(m, rng, heavy))
    atoms = position_atoms(m, rng, heavy)
    scalars = []
    for i, s in enumerate(massless):
        known = [*heavy, *massless[:i]]
        scalars.append(m.constraint(f"held{i}", rng.choice((
            lambda: s - smooth(rng, known), lambda: constant(rng) * s + 0.2 * sin(s) - smooth(rng, known) - 0.3 * t,
            lambda: s * (1.5 + cos(rng.choice(known))) - m.parameter(f"b{i}") * smooth(rng, atoms, 1),
        ))()))
    if len(heavy) > 1 and chance(rng, 0.4):
        scalars.append(m.constraint("more", relation(m, rng, heavy[0], heavy[1:], 9)))
    elif len(heavy) > 1 and chance(rng, 0.4):
        scalars.append(m.slip("slip", slip(m, rng, heavy, 0, atoms)))
    m.potential.append(m.parameter("k") * smooth(rng, qs))
    decorated(m, rng, qs, 0.3)
    observed(m, rng, qs, scalars)
    return m


def massless_rod(m, rng):
    """A mass at the end of a rod without mass, in the plane."""
    m.coordinate("p", 2)
    theta = m.coordinate("theta")
    mass, length, g = m.parameter("m", draw="positive"), m.parameter("l", draw="positive"), m.parameter("g")
    p = tree.family("p")
    m.kinetic.append(0.5 * mass * dot(p).norm_squared())
    m.potential.append(mass * g * member("p", 1))
    support = rng.choice((tree.node([0, 0]), tree.node([m.parameter("a") * sin(t), 0])))
    rod = m.constraint("rod", p - support - length * tree.node([sin(theta), -cos(theta)]))
    if chance(rng, 0.4):
        m.force("theta", m.input("torque") - 0.2 * dot(theta))
    observed(m, rng, [theta, member("p", 0)], (), [rod])


@kind
def constrained_general(m, rng):
    """Constraints with Lagrangians that are no positive definite quadratic forms of the velocities."""
    (general_lagrangian if chance(rng, 0.5) else indefinite)(m, rng)
    qs = [name(c) for c, _ in m.coordinates]
    if len(qs) == 1:
        qs.append(m.coordinate("w"))
        if m.lagrangian is None:
            m.kinetic.append(0.5 * dot(qs[1]) ** 2)
        else:
            m.lagrangian = m.lagrangian + 0.5 * dot(qs[1]) ** 2
    scalars = []
    for i in range(rng.randint(1, len(qs) - 1)):
        if chance(rng, 0.7):
            scalars.append(m.constraint(f"held{i}", relation(m, rng, qs[i], qs[i + 1 :], i)))
        else:
            scalars.append(m.slip(f"slip{i}", slip(m, rng, qs, i, qs)))
    observed(m, rng, qs, scalars)


@kind
def constrained_drives(m, rng):
    """Motions that are prescribed in time, which do work."""
    phi, r = m.coordinate("phi"), m.coordinate("r")
    qs = [phi, r]
    if chance(rng, 0.6):
        qs.append(m.coordinate("z"))
    rate = m.parameter("rate", draw="rate")
    mass = m.parameter("m", draw="positive")
    p = m.define("p", [r * cos(phi), r * sin(phi), *([qs[2]] if len(qs) > 2 else [])])
    m.kinetic += [0.5 * mass * dot(p).norm_squared(), 0.5 * m.parameter("j", draw="positive") * dot(phi) ** 2]
    m.potential.append(m.parameter("g") * smooth(rng, qs))
    drive = rng.choice((rate * t, rate * t**2, sin(rate * t), rate * t + 0.3 * sin(t), exp(0.2 * t)))
    scalars = [m.constraint("drive", rng.choice((phi - drive, drive - phi, 2 * phi - drive + 0.2 * sin(phi))))]
    if len(qs) > 2:
        scalars.append(m.constraint("surface", rng.choice((
            qs[2] - m.parameter("k") * r**2, r**2 + qs[2] ** 2 - m.parameter("l", draw="positive") ** 2, qs[2] - sin(r) * t, qs[2] * cos(rate) - r * sin(rate),
        ))))
    elif chance(rng, 0.3):
        scalars.append(m.slip("feed", dot(r) - 0.1 * rate * r - rng.choice((cos(t), tree.node(0.2)))))
    decorated(m, rng, qs, 0.3)
    observed(m, rng, qs, scalars)
    m.energy_balance = True


@kind
def constrained_rolling(m, rng):
    """A body that rolls on a plane, which may turn, or skates along an edge."""
    if chance(rng, 0.35):
        return skate(m, rng)
    m.coordinate("p", 3)
    angles = [m.coordinate(a) for a in ("phi", "theta", "psi")]
    m.q_draw["theta"] = (0.3, 2.7)
    r = m.define("r", rotation("zxz", *angles))
    w = m.define("w", tree.angular_velocity(r, True))
    mass, radius = m.parameter("m", draw="positive"), m.parameter("radius", draw="positive")
    inertia = m.parameter("inertia", (3, 3), draw="inertia")
    body = m.define("omega", tree.angular_velocity(r))
    p = tree.family("p")
    m.kinetic += [0.5 * mass * dot(p).norm_squared(), 0.5 * body.dot(inertia * body)]
    slope = m.parameter("slope", (3,))
    m.potential.append(-mass * slope.dot(p))
    if chance(rng, 0.5):
        center = tree.node([0, 0, -radius])  # A ball.
    else:
        axis = m.define("axis", r * tree.node([0, 0, 1]))
        center = m.define("arm", axis.cross(axis.cross(tree.node([0, 0, 1]))).normalize() * radius)
    contact = dot(p) + w.cross(center)
    if chance(rng, 0.4):
        contact = contact - rng.choice((m.parameter("table"), 0.5 * sin(t))) * tree.node([-member("p", 1), member("p", 0), 0])
    contact = m.define("contact", contact)
    vectors = []
    if chance(rng, 0.5):
        vectors.append(m.slip("rolling", contact))
        scalars = []
    else:
        vectors.append(m.slip("rolling", tree.node([contact[0], contact[1]])))
        scalars = [m.constraint("ground", member("p", 2) + center[2])]
    observed(m, rng, [*angles, member("p", 0)], scalars, vectors)
    return m


def skate(m, rng):
    """An edge, or two wheels, in the plane, off the centre of mass."""
    x, y, phi = (m.coordinate(c) for c in ("x", "y", "phi"))
    qs = [x, y, phi]
    off = m.parameter("off")
    center = m.define("center", [x + off * cos(phi), y + off * sin(phi)])
    m.kinetic += [0.5 * m.parameter("m", draw="positive") * dot(center).norm_squared(), 0.5 * m.parameter("j", draw="positive") * dot(phi) ** 2]
    m.potential.append(m.parameter("slope") * center[0])
    edge = dot(x) * sin(phi) - dot(y) * cos(phi)
    scalars = [m.slip("edge", rng.choice((edge, -edge, edge - m.parameter("wind") * cos(t), dot(tree.node([x, y])).dot(tree.node([sin(phi), -cos(phi)])))))]
    if chance(rng, 0.5):
        psi = m.coordinate("psi")
        qs.append(psi)
        m.kinetic.append(0.5 * m.parameter("wheel", draw="positive") * dot(psi) ** 2)
        scalars.append(m.slip("roll", dot(x) * cos(phi) + dot(y) * sin(phi) - m.parameter("radius", draw="positive") * dot(psi)))
    decorated(m, rng, qs, 0.3)
    observed(m, rng, qs, scalars)
    return m


@kind
def constrained_bodies(m, rng):
    """One or two free rigid bodies on a ball joint, with each other and with the base, or on a hinge."""
    n = rng.choice((1, 1, 2))
    before, qs, vectors, scalars = rng.choice((tree.node([0, 0, 0]), m.parameter("base", (3,)))), [], [], []
    g = m.parameter("g")
    for k in range(n):
        m.coordinate(f"p{k}", 3)
        angles = [m.coordinate(f"{a}{k}") for a in ("phi", "theta", "psi")]
        sequence = rng.choice(("zxz", "xyz", "zyx", "zyz"))
        m.q_draw[angles[1].data] = (0.3, 2.7) if sequence[0] == sequence[2] else (-1.2, 1.2)
        r = m.define(f"r{k}", rotation(sequence, *angles))
        w = m.define(f"w{k}", tree.angular_velocity(r))
        p = tree.family(f"p{k}")
        mass, inertia = m.parameter(f"m{k}", draw="positive"), m.parameter(f"i{k}", (3, 3), draw="inertia")
        m.kinetic += [0.5 * mass * dot(p).norm_squared(), 0.5 * w.dot(inertia * w)]
        m.potential.append(mass * g * member(f"p{k}", 2))
        joint = m.define(f"b{k}", p + r * m.parameter(f"c{k}", (3,)))
        vectors.append(m.constraint(f"joint{k}", joint - before))
        before = m.define(f"e{k}", p + r * m.parameter(f"d{k}", (3,)))
        qs += angles
    if chance(rng, 0.4):
        axis = name("r0") * tree.node([0, 0, 1])
        m.define("axis", axis)
        scalars.append(m.constraint("hinge", name("axis")[0] - 0.2 * rng.choice((tree.node(1), sin(t)))))
    if chance(rng, 0.4):
        m.force("w0", m.input("torque", (3,)))
    observed(m, rng, qs, scalars, vectors)


@kind
def constrained_quaternions(m, rng):
    """A body in the four components of a quaternion, whose length a constraint holds: M is singular along it."""
    q = [m.coordinate(c) for c in ("a", "b", "c", "d")]
    for x in q:
        m.q_draw[x.data] = (-1.2, 1.2)
    w, v = q[0], q[1:]
    rates = [dot(x) for x in q]
    omega = m.define("omega", [
        2 * (w * rates[k + 1] - v[k] * rates[0] + v[(k + 2) % 3] * rates[(k + 1) % 3 + 1] - v[(k + 1) % 3] * rates[(k + 2) % 3 + 1]) for k in range(3)
    ])
    inertia = m.parameter("inertia", (3, 3), draw="inertia")
    m.kinetic.append(0.5 * omega.dot(inertia * omega))
    a, b, c, d = q
    last = m.define("last", [2 * (b * d - a * c), 2 * (c * d + a * b), 1 - 2 * (b**2 + c**2)])
    m.potential.append(m.parameter("weight") * last.dot(m.parameter("center", (3,))))
    square = a**2 + b**2 + c**2 + d**2
    scalars = [m.constraint("unit", rng.choice((square - 1, tree.sqrt(square) - 1, 0.5 * (1 - square))))]
    if chance(rng, 0.4):
        m.coordinate("p", 3)
        p = tree.family("p")
        m.kinetic.append(0.5 * m.parameter("m", draw="positive") * dot(p).norm_squared())
        m.potential.append(m.parameter("g") * member("p", 2))
        scalars.append(m.constraint("plane", member("p", 2) - m.parameter("radius", draw="positive") * last[2]))
    if chance(rng, 0.4):
        m.force("omega", rng.choice((lambda: m.input("torque", (3,)), lambda: -0.3 * omega))())
    if chance(rng, 0.3):
        scalars.append(m.slip("pivot", omega[2] - m.parameter("spin") * rng.choice((tree.node(1), sin(t)))))
    observed(m, rng, q, scalars)
