"""Constants, domains and signs: what a parameter, a range of a coordinate, or a speed decides."""

from fractions import Fraction

from kinds import kind
from kinds.identities import same
from kinds.pieces import any_function, chance, coordinates, decorated, diagonal, jump, pair, smooth, sum_of, vanishing
import tree
from tree import PI, absolute, acosh, atan, cos, dot, exp, ln, maximum, minimum, signum, sin, sqrt, t, tan


def zero_constant(rng):
    """A constant that is zero, or one that looks as if it were."""
    n = tree.node
    return rng.choice((
        lambda: sqrt(n(2)) * sqrt(n(3)) - sqrt(n(6)), lambda: sqrt(n(8)) - 2 * sqrt(n(2)), lambda: sin(PI / 6) - 0.5,
        lambda: cos(PI), lambda: atan(n(1)) - PI / 4, lambda: exp(ln(n(3))) - 3, lambda: n(2) ** Fraction(1, 2) - sqrt(n(2)),
        lambda: sqrt(3 - 2 * sqrt(n(2))) - sqrt(n(2)) + 1, lambda: sqrt(3 - 2 * sqrt(n(2))) + 1 - sqrt(n(3)), lambda: tan(PI / 4) - 1,
        lambda: sqrt(n(0.01)) - 0.1, lambda: absolute(n(-2)) - 2, lambda: n(-8) ** 3 + 512, lambda: sin(n(2)) ** 2 + cos(n(2)) ** 2 - 1,
        lambda: maximum(n(1), n(-2)) - 1, lambda: signum(n(-3)) + 1, lambda: acosh(tree.cosh(n(2))) - 2, lambda: n(3) ** -2 - n(1) / 9,
        lambda: tree.atan2(n(1), n(-1)) - 0.75 * PI, lambda: PI - 3.14159265358979, lambda: sqrt(n(2)) - 1.4142135623730951,
    ))()


@kind
def constants(m, rng):
    """Roots, π and functions of constants."""
    qs = coordinates(m, rng, 1, 3)
    m.kinetic.append(diagonal(m, rng, qs))
    x, y = pair(rng, qs)
    m.kinetic.append(0.5 * ((zero_constant(rng) + 1) * dot(x) + zero_constant(rng) * dot(y)) ** 2)
    m.potential.append(m.parameter("k") * (zero_constant(rng) + 0.5) * smooth(rng, qs))
    m.potential.append(sin(x + rng.choice((PI, PI / 2, -PI / 2, 2 * PI, PI / 3))) * cos(rng.choice((y, -y, 2 * y, 0.5 * y, PI - y))))
    m.potential.append(1e-9 * x**7 + 123456.789 * cos(y / 1000) + y**2 / 3 + (2 + sin(x)) ** -5)
    m.output("zero", zero_constant(rng) * dot(dot(x)) + zero_constant(rng))
    decorated(m, rng, qs, 0.3)


@kind
def domains(m, rng):
    """Roots, logarithms and powers of coordinates on the side where they have a value."""
    qs = coordinates(m, rng, 2, 2)
    sign = rng.choice((1, -1))
    for x in qs:
        m.q_draw[x.data] = (0.3, 3.0) if sign > 0 else (-3.0, -0.3)
    m.kinetic.append(diagonal(m, rng, qs))
    x, y = pair(rng, qs)
    a, b = (x, y) if sign > 0 else (-x, -y)
    part = lambda: rng.choice((
        lambda: sqrt(a) * sqrt(b), lambda: sqrt(x * y), lambda: sqrt(a) ** 2, lambda: sqrt(a**3), lambda: ln(x * y), lambda: ln(a) + ln(b),
        lambda: ln(x**2), lambda: exp(0.5 * ln(a)), lambda: a**Fraction(1, 3), lambda: (x * y) ** Fraction(1, 2), lambda: sqrt(x**2),
        lambda: (a**Fraction(1, 2)) ** 4, lambda: (x**2) ** Fraction(1, 4), lambda: sqrt(a / b), lambda: sqrt(a) / sqrt(b), lambda: sqrt(x / y),
        lambda: ln(a / b), lambda: ln(x / y), lambda: a**b, lambda: a ** (b + 1) / a, lambda: (x**-2) ** Fraction(1, 2), lambda: sqrt(tree.recip(a)),
        lambda: (a * 2) ** m.parameter("n", draw="positive"), lambda: sqrt(x**2 + 3 * x**2), lambda: x * absolute(x), lambda: ln(absolute(x)),
        lambda: sqrt(x**2 * b), lambda: (x**3 * y**3) ** Fraction(1, 3), lambda: tree.atan2(x, y), lambda: atan(x / y), lambda: sqrt(sqrt(x**4)),
    ))()
    m.kinetic.append(0.5 * (dot(x) + part() * dot(y)) ** 2)
    m.kinetic.append(0.5 * m.parameter("c", draw="positive") * (part() - part()) ** 2 * dot(x) ** 2)
    m.potential.append(m.parameter("k") * part() * part() + part())
    m.output("value", part() * dot(dot(y)))
    decorated(m, rng, qs, 0.3)


@kind
def signs_of_parameters(m, rng):
    """Branches that parameters, time and inputs decide."""
    qs = coordinates(m, rng, 1, 3)
    m.kinetic.append(diagonal(m, rng, qs))
    a, b = m.parameter("a"), m.parameter("b")
    x, y = pair(rng, qs)
    atoms = [a, b, a * x, b * y, a + x, t, a * t, a * b, m.input("u"), x]
    two = lambda: rng.sample(atoms[:-2], 2)
    one = lambda: rng.choice((jump, vanishing))(rng, *two())
    m.kinetic.append(0.5 * (dot(x) + one() * dot(y)) ** 2)
    m.kinetic.append(0.5 * m.parameter("c", draw="positive") * (vanishing(rng, a, b) * dot(x)) ** 2)
    m.potential.append(one() * smooth(rng, qs, 1) + vanishing(rng, a * x, b) * dot(y))
    m.force(qs[0].data, jump(rng, *rng.sample(atoms, 2)) * rng.choice((1, dot(x), sin(y))))
    m.output("value", jump(rng, *rng.sample(atoms, 2)))
    decorated(m, rng, qs, 0.2)


@kind
def speeds(m, rng):
    """Lagrangians with branches in the velocities."""
    qs = coordinates(m, rng, 2, 3)
    x, y = pair(rng, qs)
    r, s = dot(x), dot(y)
    square = sum_of([dot(z) ** 2 for z in qs])
    c = m.parameter("c")
    extra = rng.choice((
        lambda: c * r * absolute(r), lambda: c * sqrt(r**4), lambda: c * absolute(r) ** 3, lambda: c * maximum(r, s) ** 2,
        lambda: c * sqrt(r**2 + s**2 + 2 * r * s) * s, lambda: c * (absolute(r) + r) ** 2, lambda: c * sqrt(r**2) * cos(x), lambda: c * signum(r) * s**2,
        lambda: c * (r**2) ** Fraction(3, 2) * sin(y), lambda: c * absolute(r * s), lambda: c * minimum(r, s) * r, lambda: c * jump(rng, r, s) * cos(x),
        lambda: c * vanishing(rng, r, s) * r, lambda: c * sqrt(square) * sin(x), lambda: c * absolute(x) * r * s, lambda: c * vanishing(rng, x, s) * s,
    ))()
    if chance(rng, 0.5):
        m.lagrangian = 0.5 * square * (2 + sin(x)) + extra - smooth(rng, qs)
    else:
        m.kinetic += [diagonal(m, rng, qs), extra]
    m.output("value", r * jump(rng, s, r))
    decorated(m, rng, qs, 0.2)
    if m.lagrangian is not None:
        m.potential = []


@kind
def quotients(m, rng):
    """Quotients that cancel, and powers of sums."""
    qs = coordinates(m, rng, 2, 3)
    x, y = pair(rng, qs)
    a = m.parameter("a", draw="positive")
    part = lambda: rng.choice((
        lambda: (x**2 - 1) / (x - 1), lambda: x**3 / x, lambda: x**-2 * x**3, lambda: 1 / (1 / x + 1 / (y**2 + 1)), lambda: (x + y) ** 3 / (x + y) ** 2,
        lambda: (x**2 - y**2) / (x + y), lambda: sin(x) / cos(x), lambda: (1 - cos(x)) / sin(x), lambda: sin(x) / x, lambda: (exp(x) - 1) / x,
        lambda: (a * x + a * y) / a, lambda: (x / a) ** 2 * a**2, lambda: x / (x * (2 + sin(y))), lambda: (x + a) ** -2, lambda: absolute(x) / x,
        lambda: (a**2 - x**2) / (a - x), lambda: tan(x) * cos(x), lambda: x * y / absolute(x * y), lambda: (x**4 - 1) / (x**2 + 1),
    ))()
    m.kinetic.append(diagonal(m, rng, qs))
    m.kinetic.append(0.5 * a * (dot(x) + part() * dot(y)) ** 2)
    m.kinetic.append(0.5 * ((part() - part()) * dot(qs[-1])) ** 2)
    m.potential.append(part() * part() + m.parameter("k") / (1.5 + part() ** 2))
    decorated(m, rng, qs, 0.3)


@kind
def many(m, rng):
    """More coordinates than are eliminated before numbers are known."""
    n = rng.randint(5, 7)
    m.coordinate("q", n)
    qs = [tree.member("q", i) for i in range(n)]
    m.parameter("m", family=n, draw="positive")
    sign = (lambda: rng.choice((1, 1, -1))) if chance(rng, 0.4) else (lambda: 1)
    m.kinetic.append(sum_of([0.5 * sign() * tree.member("m", i) * dot(x) ** 2 for i, x in enumerate(qs)]))
    for _ in range(rng.randint(3, 7)):
        x, y = rng.sample(qs, 2)
        z = rng.choice(qs)
        factor = rng.choice((cos(z), sin(x - z), z, absolute(z), tree.tanh(y), tree.node(1)))
        m.kinetic.append(0.5 * (dot(x) + factor * dot(y)) ** 2 if chance(rng, 0.7) else 0.3 * factor * dot(x) * dot(y))
    m.potential.append(sum_of([smooth(rng, qs, 1) for _ in range(3)]))
    if chance(rng, 0.5):
        m.force("q", m.input("u"), (rng.randrange(n),))
    m.output("a", dot(dot(rng.choice(qs))))


@kind
def soup(m, rng):
    """Everything at once."""
    qs = coordinates(m, rng, 2, 3)
    a = m.parameter("a")
    atoms = [*qs, *qs, a, t]
    make = lambda pool: rng.choice((
        lambda x, y: any_function(rng, x, y), lambda x, y: jump(rng, x, y), lambda x, y: vanishing(rng, x, y),
        lambda x, y: same(rng, x, y)[0] - same(rng, x, y)[1], lambda x, y: smooth(rng, [x, y], 2),
    ))(*rng.sample(pool, 2))
    parts = [m.define(f"part{i}", make(atoms)) for i in range(3)]
    more = [*parts, *qs]
    m.kinetic.append(diagonal(m, rng, qs))
    for _ in range(2):
        x, y = pair(rng, qs)
        m.kinetic.append(0.5 * (dot(x) + rng.choice((1, make(more))) * dot(y) + rng.choice((0, 0, make(atoms)))) ** 2)
    m.potential.append(make(more) * rng.choice((1, dot(qs[0]))) + rng.choice(parts))
    rates = [dot(x) for x in qs]
    m.force(qs[-1].data, make([*more, *rates]))
    if chance(rng, 0.5):
        m.dissipation.append(0.5 * (dot(parts[0]) + make(qs) * rates[-1]) ** 2)
    m.output("value", make([*more, *rates]))
    decorated(m, rng, qs, 0.2)
