"""Roots, absolute values, extrema and inverse functions: what holds on one branch only."""

from kinds import kind
from kinds.pieces import chance, coordinates, decorated, diagonal, jump, pair, smooth, sum_of, vanishing
import tree
from tree import dot


@kind
def jumps(m, rng):
    """A metric and a potential with branches."""
    qs = coordinates(m, rng, 1, 3)
    m.kinetic.append(diagonal(m, rng, qs))
    for _ in range(rng.randint(1, 2)):
        x, y = pair(rng, qs)
        m.kinetic.append(0.5 * (dot(x) + jump(rng, *pair(rng, qs)) * dot(y)) ** 2)
    m.potential.append(m.parameter("k") * jump(rng, *pair(rng, qs)) * smooth(rng, qs, 1))
    decorated(m, rng, qs, 0.3)


@kind
def branch_of_a_form(m, rng):
    """Forms that build on each other through factors with a branch."""
    qs = coordinates(m, rng, 2, 3)
    forms = []
    for i, x in enumerate(qs):
        others = [jump(rng, *pair(rng, qs)) * dot(y) for y in qs[:i] if chance(rng, 0.8)]
        forms.append(sum_of([dot(x), *others]))
    m.kinetic += [0.5 * m.parameter(f"i{i}", draw="positive") * w**2 for i, w in enumerate(forms)]
    decorated(m, rng, qs, 0.3)


@kind
def vanishing_on_a_branch(m, rng):
    """Factors that vanish identically on one branch, in T, V and forces."""
    qs = coordinates(m, rng, 2, 3)
    m.kinetic.append(diagonal(m, rng, qs))
    place = rng.randrange(5)
    zero = lambda: vanishing(rng, *pair(rng, qs))
    x, y = pair(rng, qs)
    if place in (0, 4):
        m.kinetic.append(0.5 * m.parameter("c", draw="positive") * (zero() * dot(x)) ** 2)
    if place in (1, 4):
        m.potential.append(zero() * dot(y))
    if place in (2, 4):
        m.potential.append(m.parameter("k") * zero() * smooth(rng, qs, 1))
    if place == 3:
        m.kinetic.append(0.5 * m.parameter("c", draw="positive") * (dot(x) + zero() * dot(y)) ** 2)
        m.force(qs[0].data, zero() * dot(qs[0]))
    if chance(rng, 0.4):
        m.output("zero", zero())
    decorated(m, rng, qs, 0.25)


@kind
def nested(m, rng):
    """Branches within branches, and under functions."""
    qs = coordinates(m, rng, 1, 3)
    m.kinetic.append(diagonal(m, rng, qs))
    inner = m.define("inner", jump(rng, *pair(rng, qs)))
    outer = m.define("outer", jump(rng, inner + 0.7, rng.choice(qs)))
    m.potential.append(m.parameter("k") * outer * smooth(rng, [*qs, inner], 1))
    if chance(rng, 0.5):
        m.kinetic.append(0.5 * (dot(qs[-1]) + inner * dot(qs[0])) ** 2)
    if chance(rng, 0.4):
        m.kinetic.append(0.5 * dot(outer) ** 2)
    decorated(m, rng, qs, 0.3)


@kind
def clipped_velocity(m, rng):
    """Friction that jumps, and energies with |q̇|."""
    qs = coordinates(m, rng, 1, 3)
    m.kinetic.append(diagonal(m, rng, qs))
    rates = [dot(x) for x in qs]
    r, s = rng.choice(rates), rng.choice(rates)
    mu = m.parameter("mu", draw="positive")
    push = rng.choice((
        lambda: -mu * tree.signum(r), lambda: -mu * r * tree.absolute(r), lambda: mu * tree.maximum(r, s),
        lambda: -mu * tree.sqrt(r**2) * r, lambda: -mu * tree.minimum(tree.maximum(r, -0.5), 0.5),
        lambda: mu * tree.sqrt((r + s) ** 2), lambda: mu * jump(rng, r, qs[0]), lambda: -mu * tree.tanh(r / 0.05),
    ))()
    m.force(qs[0].data, push)
    if chance(rng, 0.5):
        m.dissipation.append(mu * (r**2) ** tree.node(1.5) / 3)
    if chance(rng, 0.3):
        m.kinetic.append(0.1 * tree.absolute(r) ** 3)
    m.output("push", push)
    decorated(m, rng, qs, 0.3)
