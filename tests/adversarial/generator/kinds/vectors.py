"""The algebra of vectors and matrices."""

from kinds import kind
from kinds.pieces import chance, coordinates, decorated, diagonal, pair, smooth, sum_of
import tree
from tree import cos, dot, rotation, sin, t


def vector(rng, atoms, n=3):
    return tree.node([smooth(rng, atoms, 1) for _ in range(n)])


def scalar_of(rng, a, b, k):
    """A scalar made of two vectors of three components and a 3×3 matrix."""
    return rng.choice((
        lambda: a.dot(k * b), lambda: a.cross(b).norm_squared(), lambda: (k * a).sum(), lambda: a.outer(b).trace(),
        lambda: (k + 4 * tree.node([[1, 0, 0], [0, 1, 0], [0, 0, 1]])).determinant(), lambda: a.component_mul(b).sum(),
        lambda: (a + [3, 0, 0]).norm(), lambda: a.cross_matrix().transpose().trace() + b[1], lambda: (a.transpose() * k * b),
        lambda: a.cross(b).dot(k * (a + b)), lambda: k.diagonal().dot(a), lambda: (a + [0, 4, 0]).normalize()[0] * b[2],
        lambda: (a.outer(a) + [[2, 0, 0], [0, 2, 0], [0, 0, 2]]).inverse().trace(), lambda: a.component_mul(b).product(),
        lambda: (k.transpose() * k)[0, 1] * b[0], lambda: (k * k.transpose()).trace() * a[2],
    ))()


@kind
def vector_algebra(m, rng):
    """Potentials of vectors and matrices of all methods."""
    qs = coordinates(m, rng, 2, 3)
    m.kinetic.append(diagonal(m, rng, qs))
    k = m.parameter("k", (3, 3))
    a, b = m.define("a", vector(rng, qs)), m.define("b", vector(rng, [*qs, t]) + m.parameter("shift", (3,)))
    m.potential += [scalar_of(rng, a, b, k), m.parameter("c") * scalar_of(rng, b, a, k)]
    m.kinetic.append(0.1 * dot(a).norm_squared())
    if chance(rng, 0.4):
        m.force(qs[0].data, scalar_of(rng, a, dot(b), k))
    m.output("value", scalar_of(rng, dot(a), dot(dot(b)), k))
    m.output("product", k * a.cross(b))
    decorated(m, rng, qs, 0.2)


@kind
def quadratic_form(m, rng):
    """T = ½ q̇·M q̇ with vectors and matrices: metrics, products of triangular ones, W between forms."""
    n = rng.choice((2, 3))
    m.coordinate("q", n)
    v = dot(tree.family("q"))
    qs = [tree.member("q", i) for i in range(n)]
    i = m.parameter("i", (n, n), draw="inertia")
    e = m.define("e", [[1 if a == b else (smooth(rng, qs, 1) if a > b or chance(rng, 0.2) else 0) for b in range(n)] for a in range(n)])
    w = m.define("w", e * v)
    m.kinetic.append(rng.choice((
        lambda: 0.5 * w.dot(i * w), lambda: 0.5 * v.dot(e.transpose() * i * e * v), lambda: 0.5 * w.norm_squared(),
        lambda: 0.5 * v.dot(i * v) + 0.25 * (e * w).norm_squared(), lambda: 0.5 * (e * w).dot(i * (e * w)),
        lambda: 0.5 * v.transpose() * (i + e.transpose() * e) * v,
    ))())
    m.potential.append(smooth(rng, [*qs, t]))
    if chance(rng, 0.5):
        m.force("w", m.input("f", (n,)))
    if chance(rng, 0.4):
        m.dissipation.append(0.5 * w.norm_squared())
    m.output("w", w)


@kind
def turned(m, rng):
    """Points and vectors that several rotations turn, in products with each other."""
    a, b = m.coordinate("a"), m.coordinate("b")
    qs = [a, b]
    if chance(rng, 0.5):
        qs.append(m.coordinate("s"))
    axis = lambda: rng.choice("xyz")
    r = m.define("r", rotation(axis(), a) * rotation(axis(), b))
    if chance(rng, 0.4):
        r = m.define("mounted", r * tree.node([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]))
    arm, other = m.parameter("arm", (3,)), m.parameter("other", (3,))
    stretch = qs[-1] if len(qs) == 3 else 1 + 0.1 * sin(t)
    p = m.define("p", rotation(axis(), a) * arm + r * (stretch * other))
    mass = m.parameter("m", draw="positive")
    m.kinetic += [0.5 * mass * dot(p).norm_squared(), diagonal(m, rng, qs)]
    m.potential.append(p.dot(m.parameter("field", (3,))) + rng.choice((
        lambda: (r * arm).cross(p).norm_squared(), lambda: (r * arm).dot(r * other), lambda: p.norm_squared(),
        lambda: (r.transpose() * p)[0], lambda: r.trace(), lambda: r.determinant() * a, lambda: (r * arm).norm() * b,
    ))())
    if chance(rng, 0.5):
        m.force("p", rng.choice((r * m.input("f", (3,)), -0.2 * dot(p))) if chance(rng, 0.5) else -0.3 * dot(p))
    m.output("v", r.transpose() * dot(p))
    decorated(m, rng, [a, b], 0.2)
