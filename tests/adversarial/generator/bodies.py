"""Bodies among the fields: what their quantities and energies stand for.

The kinetic energy is the sum over particles at r ρ + p, without angular velocity or centre of gravity:
½ m |ṗ|² + ṗ · ṙ Σ m ρ + ½ tr(ṙ J ṙᵀ), with the second moments J = Σ m ρ ρᵀ = ½ tr(I) 1 − I about the origin.
"""

import tree
from tree import dot, number_of_body


def quantity(body, kind, which):
    """The mass, the centre of gravity, or the inertia tensor about that, of the numbers of a body of some type."""
    of = lambda i: number_of_body(body, i)
    zero = tree.node(0)
    if which == "mass":
        return of(0)
    if which == "center":
        return {
            "RigidBody": lambda: tree.node([of(1), of(2), of(3)]),
            "PrincipalBody": lambda: tree.node([0, 0, 0]),
            "SymmetricBody": lambda: tree.node([0, 0, of(1)]),
        }[kind]()
    xx, yy, zz, xy, xz, yz = {
        # The products of inertia are integrals, and the entries of the tensor their negatives.
        "RigidBody": lambda: (of(4), of(5), of(6), -of(7), -of(8), -of(9)),
        "PrincipalBody": lambda: (of(1), of(2), of(3), zero, zero, zero),
        "SymmetricBody": lambda: (of(2), of(2), of(3), zero, zero, zero),
    }[kind]()
    return tree.node([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def energy(function, kind, body, r, p, gravity=None):
    """Its kinetic energy, or its potential energy under gravity."""
    mass, center, inertia = (quantity(body, kind, which) for which in ("mass", "center", "inertia"))
    if function == "potential_energy":
        return -mass * gravity.dot(p + r * center)
    one = tree.node([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    second = 0.5 * inertia.trace() * one - inertia + mass * center.outer(center)
    turning = dot(r)
    return (
        0.5 * mass * dot(p).norm_squared()
        + mass * dot(p).dot(turning * center)
        + 0.5 * (turning * second * turning.transpose()).trace()
    )
