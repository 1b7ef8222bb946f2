"""Bricard's mechanism with six revolute joints: places, angles, accelerations and multipliers, with 24 digits.

Written by `python3 bricard.py > bricard.json`, with mpmath. Rods are the edges of a cube from (0, 0, 0) over (1, 0, 0), (1, -1, 0),
(1, -1, 1) and (0, -1, 1) to (0, 0, 1), turned about Y, Z, X, Y, Z and X by the angles a, b, a, b, a and b. The motion is the one of
`iftomm_a04_bricard` in `references_public.json`, so that the places of all rods and their accelerations are known. By the laws of
Newton and Euler the joints exert m (c'' - g) on each rod, and the moment dL/dt - (c - p) x m g with the moment of momentum L about a
place p that moves, L' = d/dt (I w) + (c - p) x m c''. The multipliers of

    pin_i: the end of a rod - the beginning of the next, and two products of an axis of a rod with axes of the one before

are those of least square sum that exert these forces, by the singular value decomposition with 200 bits: there are 30, and 29 are
independent.
"""

import json
import pathlib

import mpmath as mp

mp.mp.prec = 200
DIGITS = 24
EDGES = [(1, 0, 0), (0, -1, 0), (0, 0, 1), (-1, 0, 0), (0, 1, 0)]
X, Y, Z = 0, 1, 2
# The axis of the joint in front of a rod, and the two axes of the rod before to which it is orthogonal.
JOINTS = [(Y, X, Z), (Z, X, Y), (X, Y, Z), (Y, Z, X), (Z, X, Y), (X, Y, Z)]


def turn(axis, angle):
    c, s = mp.cos(angle), mp.sin(angle)
    j, k = (axis + 1) % 3, (axis + 2) % 3
    matrix = mp.eye(3)
    matrix[j, j], matrix[j, k], matrix[k, j], matrix[k, k] = c, -s, s, c
    return matrix


def vector(components):
    return mp.matrix([mp.mpf(x) for x in components])


def cross(x, y):
    return vector([x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]])


def dot(x, y):
    return sum(x[i] * y[i] for i in range(3))


def rods(a, b):
    """The places and the rotations of the rods."""
    place, rotation, found = vector([0, 0, 0]), mp.eye(3), []
    for (axis, _, _), edge, angle in zip(JOINTS, EDGES, [a, b, a, b, a]):
        rotation = rotation * turn(axis, angle)
        found.append((place, rotation))
        place = place + rotation * vector(edge)
    return found


def angles(rod, r):
    """The angles of a rotation about the axes that the declaration has for this rod."""
    if rod in (0, 2):  # y z x
        return mp.atan2(-r[2, 0], r[0, 0]), mp.asin(r[1, 0]), mp.atan2(-r[1, 2], r[1, 1])
    if rod == 1:  # y x z
        return mp.atan2(r[0, 2], r[2, 2]), mp.asin(-r[1, 2]), mp.atan2(r[1, 0], r[1, 1])
    if rod == 3:  # z x y
        return mp.atan2(-r[0, 1], r[1, 1]), mp.asin(r[2, 1]), mp.atan2(-r[2, 0], r[2, 2])
    return mp.atan2(r[1, 0], r[0, 0]), mp.asin(-r[2, 0]), mp.atan2(r[2, 1], r[2, 2])  # z y x


def coordinates(a, b):
    """All places, then the first, second and third angles of all rods."""
    found = rods(a, b)
    turned = [angles(i, r) for i, (_, r) in enumerate(found)]
    return [x for place, _ in found for x in place] + [t[k] for k in range(3) for t in turned]


def needed(parameters, path):
    """The forces and moments about their beginnings that the joints exert on the rods, along a motion at t = 0."""
    m, across, along, g = (parameters[name] for name in ["m", "it", "ia", "g"])
    gravity = vector([0, -g, 0])
    forces = []
    for i, edge in enumerate(map(vector, EDGES)):
        inertia = across * mp.eye(3) + (along - across) * edge * edge.T

        def center(t):
            place, rotation = rods(*path(t))[i]
            return place + rotation * edge / 2

        def momentum(t):
            rotation = rods(*path(t))[i][1]
            rate = differences(lambda s: rods(*path(s))[i][1], t)
            spin = rate * rotation.T
            spin = vector([spin[2, 1], spin[0, 2], spin[1, 0]])
            return rotation * inertia * rotation.T * spin

        acceleration = differences(lambda t: differences(center, t), mp.mpf(0))
        place, rotation = rods(*path(mp.mpf(0)))[i]
        force = m * (acceleration - gravity)
        moment = differences(momentum, mp.mpf(0)) + cross(rotation * edge / 2, force)
        forces += list(force) + list(moment)
    return vector(forces)


def differences(function, t):
    """The derivative, by central differences of fourth order."""
    h = mp.mpf(2) ** -32
    one = [function(t + k * h) for k in (-2, -1, 1, 2)]
    return (one[0] - 8 * one[1] + 8 * one[2] - one[3]) / (12 * h)


def gradients(a, b):
    """For each component of a constraint, its derivatives by displacements and turns of the rods."""
    found = rods(a, b)
    rows = []

    def row(parts):
        line = [mp.mpf(0)] * 30
        for rod, displacement, rotation in parts:
            for k in range(3):
                line[6 * rod + k] += displacement[k]
                line[6 * rod + 3 + k] += rotation[k]
        rows.append(line)

    nothing = vector([0, 0, 0])
    for i in range(6):
        for k in range(3):
            axis = mp.eye(3)[:, k]
            parts = []
            if i < 5:
                parts.append((i, axis, nothing))
            if i > 0:
                sign = 1 if i == 5 else -1
                arm = found[i - 1][1] * vector(EDGES[i - 1])
                parts.append((i - 1, sign * axis, sign * cross(arm, axis)))
            row(parts)
    for i, (axis, *others) in enumerate(JOINTS):
        behind = found[i][1] if i < 5 else None
        before = found[i - 1][1] if i > 0 else mp.eye(3)
        for other in others:
            if i == 5:
                # The last rod against the axes of the room.
                u, v = found[4][1][:, axis], mp.eye(3)[:, other]
                row([(4, nothing, cross(u, v))])
                continue
            u, v = before[:, other], behind[:, axis]
            parts = [(i, nothing, cross(v, u))]
            if i > 0:
                parts.append((i - 1, nothing, cross(u, v)))
            row(parts)
    return mp.matrix(rows)


def least(matrix, right):
    """The solution of least square sum, and the rank."""
    u, s, v = mp.svd_r(matrix)
    rank = sum(1 for x in s if x > mp.mpf(10) ** -20)
    solution = vector([0] * 30)
    for k in range(rank):
        weight = sum(u[i, k] * right[i] for i in range(30)) / s[k]
        solution += weight * v[k, :].T
    return solution, rank


def text(values):
    return [mp.nstr(mp.chop(x, mp.mpf(10) ** -30), DIGITS, strip_zeros=False, min_fixed=0, max_fixed=0) for x in values]


def main():
    data = json.loads((pathlib.Path(__file__).parent / "references_public.json").read_text())
    system = next(one for one in data["references"] if one["id"] == "iftomm_a04_bricard")
    # The reference is one of the parameters as they are rounded to `f64`.
    parameters = {name: mp.mpf(float(value)) for name, value in system["params"].items()}
    samples = []
    for sample in system["samples"]:
        q, v, w = ([mp.mpf(x) for x in sample[name]] for name in ["q", "qd", "qdd"])

        def path(t):
            return [q[k] + v[k] * t + w[k] * t * t / 2 for k in range(2)]

        def all_of(t):
            return mp.matrix(coordinates(*path(t)))

        forces = needed(parameters, path)
        multipliers, rank = least(gradients(*q).T, forces)
        residual = mp.norm(gradients(*q).T * multipliers - forces, mp.inf)
        assert rank == 29 and residual < mp.mpf(10) ** -20, (rank, residual)
        samples.append({
            "t": sample["t"],
            "q": text(all_of(mp.mpf(0))),
            "qd": text(differences(all_of, mp.mpf(0))),
            "qdd": text(differences(lambda t: differences(all_of, t), mp.mpf(0))),
            "lambda": text(multipliers),
        })
    print(json.dumps({"params": system["params"], "samples": samples}, indent=1))


main()
