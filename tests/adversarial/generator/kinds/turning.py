"""Motions of models with ignorable coordinates, beside those of their reduced models."""

from kinds import kind
from kinds.ignorable import ignorable_angles, ignorable_forms, ignorable_general
from kinds.pieces import chance
from motions.reference import Asked
import tree
from tree import absolute, cos, dot, sin, t


def moving(m, rng, longest):
    """A motion with events, of what remains and of the velocities of what is ignorable."""
    m.taylor = True
    xs = [tree.name(c) for c, _ in m.coordinates if c not in m.ignorable]
    turning = [tree.name(c) for c in m.ignorable]
    x = rng.choice(xs)
    m.event("passing", rng.choice((lambda: x - 0.7, lambda: dot(x), lambda: sin(2 * x) + 0.1, lambda: x * dot(x) - 0.2))())
    m.event("fast", rng.choice((lambda: dot(rng.choice(turning)) - 0.4, lambda: cos(3 * t) + 0.2, lambda: dot(rng.choice(turning)) * x - 0.1))())
    m.motion = Asked((1.0, longest), states=6, reduced=True, functions=2)


@kind
def turning_forms(m, rng):
    ignorable_forms(m, rng)
    moving(m, rng, 6.0)


@kind
def turning_angles(m, rng):
    ignorable_angles(m, rng)
    moving(m, rng, 4.0)


@kind
def turning_general(m, rng):
    ignorable_general(m, rng)
    moving(m, rng, 5.0)


@kind
def turning_with_corners(m, rng):
    """What remains meets corners of its potential."""
    ignorable_forms(m, rng)
    xs = [tree.name(c) for c, _ in m.coordinates if c not in m.ignorable]
    x = rng.choice(xs)
    m.potential.append(rng.choice((lambda: 0.5 * absolute(x), lambda: 3 * tree.maximum(x - 0.4, 0.0) ** 2, lambda: 0.3 * absolute(x - 0.2) * x))())
    if chance(rng, 0.3):
        m.force(x.data, -0.1 * tree.signum(dot(x)) * dot(x) ** 2)
    moving(m, rng, 4.0)
