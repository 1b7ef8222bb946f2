"""Families: chains, strings of springs, sums over pairs, recursions."""

from kinds import kind
from kinds.pieces import chance, smooth
import tree
from tree import cos, dot, family, member, row, sin, sqrt, t, total


@kind
def chain(m, rng):
    """Point masses on rods, by recursion or by sums, with absolute or relative angles."""
    n = rng.randint(2, 4)
    m.coordinate("theta", n)
    length, mass = m.parameter("l", family=n, draw="positive"), m.parameter("m", family=n, draw="positive")
    g = m.parameter("g")
    relative = chance(rng, 0.5)
    angle = lambda i: member("theta", i)
    if relative:
        m.define("a", total("j", 0, ("i", 0), angle(("j", 0)), inclusive=True), (("i", 0),), (("i", 0, n),))
        angle = lambda i: member("a", i)
    link = lambda i: member("l", i) * tree.node([sin(angle(i)), -cos(angle(i))])
    base = tree.node([0.3 * sin(2 * t), 0.0]) if chance(rng, 0.3) else None
    if chance(rng, 0.5):
        m.define("p", link(0) if base is None else base + link(0), (0,))
        m.define("p", member("p", ("i", -1)) + link(("i", 0)), (("i", 0),), (("i", 1, n),))
    else:
        s = total("k", 0, ("i", 0), link(("k", 0)), inclusive=True)
        m.define("p", s if base is None else base + s, (("i", 0),), (("i", 0, n),))
    i = ("i", 0)
    m.kinetic.append(total("i", 0, n, 0.5 * member("m", i) * dot(member("p", i)).norm_squared()))
    m.potential.append(total("i", 0, n, member("m", i) * g * member("p", i)[1]))
    if chance(rng, 0.5):
        m.force("theta", -m.parameter("c", draw="positive") * dot(member("theta", i)), (i,), (("i", 0, n),))
    if chance(rng, 0.5):
        v = dot(member("p", i))
        m.force("p", -0.2 * v.norm() * v, (i,), (("i", 0, n),))
    if chance(rng, 0.4):
        m.force("theta", m.input("u"), (rng.randrange(n),))
    if relative and chance(rng, 0.5):
        m.force("a", m.parameter("torque") * cos(t), (n - 1,))
    m.output("tip", dot(dot(member("p", n - 1))))


@kind
def springs(m, rng):
    """Masses on a line or in the plane with springs between all pairs or neighbours."""
    n = rng.randint(2, 4)
    m.coordinate("x", n)
    mass, k = m.parameter("m", family=n, draw="positive"), m.parameter("k", draw="positive")
    i, j = ("i", 0), ("j", 0)
    m.kinetic.append(total("i", 0, n, 0.5 * member("m", i) * dot(member("x", i)) ** 2))
    d = member("x", i) - member("x", j)
    law = rng.choice((lambda: 0.5 * k * d**2, lambda: k * sqrt(1 + d**2), lambda: k * cos(d), lambda: k * tree.absolute(d) ** 3,
                      lambda: k * tree.exp(-(d**2)), lambda: 0.25 * k * (d**2) ** 2))()
    m.potential.append(total("i", 1, n, total("j", 0, ("i", 0), law)))
    if chance(rng, 0.5):
        m.kinetic.append(0.5 * k * total("i", 0, n, dot(member("x", i))) ** 2)
    if chance(rng, 0.5):
        m.dissipation.append(0.5 * k * dot(family("x")).norm_squared())
    if chance(rng, 0.5):
        m.parameter("f", family=n)
        m.force("x", member("f", i) * sin(t), (i,), (("i", 0, n),))
    m.output("spread", family("x").norm_squared())


@kind
def particles(m, rng):
    """Points in space, each a family of coordinates, attracted by a centre and by one another."""
    n = 2
    for name in ("x", "y"):
        m.coordinate(name, n)
    i = ("i", 0)
    m.define("r", [member("x", i), member("y", i), 0.3 * member("x", i) * member("y", i)], (i,), (("i", 0, n),))
    m.parameter("m", family=n, draw="positive")
    m.kinetic.append(total("i", 0, n, 0.5 * member("m", i) * dot(member("r", i)).norm_squared()))
    m.potential.append(-m.parameter("k") / (member("r", 0) - member("r", 1)).norm())
    if chance(rng, 0.5):
        m.potential.append(total("i", 0, n, member("r", i).norm()))
    if chance(rng, 0.6):
        m.force("r", m.parameter("field", (3,)).cross(dot(member("r", i))), (i,), (("i", 0, n),))
    if chance(rng, 0.6):
        m.define("center", total("i", 0, n, member("m", i) * member("r", i)) / total("i", 0, n, member("m", i)))
        m.output("center", dot(dot(tree.name("center"))))


@kind
def forms_in_families(m, rng):
    """Velocities along a chain that build on each other, collected into vectors."""
    n = rng.randint(2, 4)
    m.coordinate("s", n)
    i = ("i", 0)
    first, rest = member("s", 0), member("s", i)
    factor = rng.choice((cos(rest), sin(rest - member("s", ("i", -1))), 0.5 * rest, tree.tanh(rest), tree.absolute(rest)))
    m.define("w", dot(first) * (1 if chance(rng, 0.5) else 1 + 0.2 * sin(t)), (0,))
    m.define("w", factor * member("w", ("i", -1)) + dot(rest), (i,), (("i", 1, n),))
    m.parameter("m", family=n, draw="positive")
    m.kinetic.append(rng.choice((
        lambda: total("i", 0, n, 0.5 * member("m", i) * member("w", i) ** 2),
        lambda: 0.5 * family("m").dot(family("w").component_mul(family("w"))),
        lambda: 0.5 * row("i", 0, n, member("m", i) * member("w", i)).dot(family("w")),
    ))())
    m.potential.append(smooth(rng, [member("s", k) for k in range(n)], 2))
    if chance(rng, 0.5):
        m.force("w", m.parameter("f"), (n - 1,))
    if chance(rng, 0.5):
        m.force("s", m.input("u") * cos(rest), (i,), (("i", 1, n),))
    m.output("w", family("w"))
