"""Identities of trigonometry and algebra, in disguise: what cancels, and what nearly does."""

from kinds import kind
from kinds.pieces import chance, coordinates, decorated, diagonal, pair, smooth, sum_of
import tree
from tree import cos, dot, exp, ln, sin, sqrt, tan, tanh


def same(rng, x, y):
    """Two spellings of one smooth quantity that is positive or bounded."""
    return rng.choice((
        lambda: (sin(x + y), sin(x) * cos(y) + cos(x) * sin(y)), lambda: (cos(x - y), cos(x) * cos(y) + sin(x) * sin(y)),
        lambda: (cos(2 * x), 1 - 2 * sin(x) ** 2), lambda: (sin(2 * x), 2 * sin(x) * cos(x)),
        lambda: (tree.cosh(x) ** 2, 1 + tree.sinh(x) ** 2), lambda: (exp(x + y), exp(x) * exp(y)),
        lambda: ((x + y) ** 2, x**2 + 2 * x * y + y**2), lambda: ((x - y) * (x + y), x**2 - y**2),
        lambda: (tanh(x), (exp(2 * x) - 1) / (exp(2 * x) + 1)), lambda: (sin(x) ** 2, 1 - cos(x) ** 2),
        lambda: (sin(3 * x), 3 * sin(x) - 4 * sin(x) ** 3), lambda: (tree.recip(1 + x**2), cos(tree.atan(x)) ** 2),
        lambda: (ln(exp(x)), x), lambda: (sqrt(x**4 + 2 * x**2 + 1), x**2 + 1), lambda: (1 + tan(x) ** 2, cos(x) ** -2),
        lambda: (sin(x) * sin(y), 0.5 * (cos(x - y) - cos(x + y))), lambda: (exp(ln(1 + x**2)), 1 + x**2),
        lambda: ((x + 1) ** 3, x**3 + 3 * x**2 + 3 * x + 1), lambda: (tree.asinh(tree.sinh(x)), x),
    ))()


@kind
def cancels(m, rng):
    """Differences of two spellings of one thing, added where they must not matter."""
    qs = coordinates(m, rng, 2, 3)
    m.kinetic.append(diagonal(m, rng, qs))
    for _ in range(2):
        x, y = pair(rng, qs)
        p, q = same(rng, *pair(rng, qs))
        k = m.parameter(f"k{len(m.fields)}")
        rng.choice((
            lambda: m.kinetic.append(0.5 * ((1 + p) * dot(x) - q * dot(x) + smooth(rng, qs, 1) * dot(y)) ** 2),
            lambda: m.kinetic.append(k * p * dot(x) * dot(y) - k * q * dot(y) * dot(x)),
            lambda: m.potential.append(k * (p - q) * dot(x)),
            lambda: m.potential.append(k * p**2 - k * q**2 + k * p * x),
            lambda: m.kinetic.append(0.5 * ((p - q) * dot(x) + dot(y)) ** 2),
        ))()
    decorated(m, rng, qs, 0.3)


@kind
def expanded_squares(m, rng):
    """Expanded sums of squares, so that the squares have to be found again, or cannot be."""
    qs = coordinates(m, rng, 2, 3)
    terms = []
    for i, x in enumerate(qs):
        others = [(smooth(rng, qs, 1), y) for y in qs[:i] + qs[i + 1 :] if chance(rng, 0.5)]
        terms.append((m.parameter(f"i{i}", draw="positive"), [(tree.node(1), x), *others]))
    expanded = []
    for i, form in terms:
        for j, (a, x) in enumerate(form):
            expanded.append(0.5 * i * a**2 * dot(x) ** 2)
            expanded += [i * a * b * dot(x) * dot(y) for b, y in form[:j]]
    rng.shuffle(expanded)
    if chance(rng, 0.3):
        expanded.append(-0.1 * dot(qs[0]) * dot(qs[-1]))
    m.kinetic.append(sum_of(expanded))
    m.potential.append(smooth(rng, qs))
    decorated(m, rng, qs, 0.3)


@kind
def angle_sums(m, rng):
    """Planar arms with sines and cosines of sums, or of the angles, or both."""
    a, b = m.coordinate("a"), m.coordinate("b")
    l1, l2, m1, m2 = (m.parameter(p, draw="positive") for p in ("l1", "l2", "m1", "m2"))
    spelled = lambda: same_sum(rng, a, b)
    (s, c) = spelled()
    x1, y1 = l1 * sin(a), -l1 * cos(a)
    x2, y2 = m.define("x2", x1 + l2 * s), m.define("y2", y1 - l2 * c)
    m.kinetic.append(0.5 * m1 * (dot(x1) ** 2 + dot(y1) ** 2) + 0.5 * m2 * (dot(x2) ** 2 + dot(y2) ** 2))
    m.potential.append(m.parameter("g") * (m1 * y1 + m2 * y2 + spelled()[0]))
    if chance(rng, 0.5):
        third = m.coordinate("third")
        m.kinetic.append(0.5 * m2 * (dot(third) + dot(x2) * spelled()[1]) ** 2)
    decorated(m, rng, [a, b], 0.4)


def same_sum(rng, a, b):
    if chance(rng, 0.5):
        return sin(a + b), cos(a + b)
    return sin(a) * cos(b) + cos(a) * sin(b), cos(a) * cos(b) - sin(a) * sin(b)


@kind
def rescaled(m, rng):
    """Factors taken out and put back: quotients of products, powers of powers, roots of positive things."""
    qs = coordinates(m, rng, 2, 3)
    m.kinetic.append(diagonal(m, rng, qs))
    x, y = pair(rng, qs)
    d = 1.5 + smooth(rng, qs, 1) ** 2
    m.kinetic.append(0.5 * (dot(x) * d + dot(y)) ** 2 / d)
    m.kinetic.append(0.5 * (d * dot(y)) ** 2 / d**2 + 0.1 * sqrt(d) ** 4 * dot(x) ** 2)
    m.potential.append(m.parameter("k") * (d**2) ** tree.node(0.5) * smooth(rng, qs, 1) / d)
    m.potential.append(d * tree.recip(d) * x + (d ** -1) ** -1)
    decorated(m, rng, qs, 0.3)
