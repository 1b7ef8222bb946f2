"""Writes `near_the_poles.json`: `python3 tests/data/near_the_poles.py > tests/data/near_the_poles.json` (mpmath 1.3).

The accelerations of two tops in z-x-z Euler angles. Nothing is derived from the energies here: Euler's equations with
the moment of the weight give the rates of the angular velocity, and the inverse of its expression in angles (4.4) and
the derivative of that expression give q̈.
"""

import itertools
import json
import random

from mpmath import cos, mp, mpf, pi, sin

mp.dps = 60  # Of which less than 20 are lost at the poles.

SYMMETRIC = {"i": 1.2, "i_s": 0.5, "m": 1.3, "g": 9.81, "l": 0.4}
GENERAL = {"i1": 1.2, "i2": 1.5, "i3": 0.7, "m": 1.3, "g": 9.81, "x": 0.05, "y": 0.03, "z": 0.4}


def general(p, q, v):
    """q̈ of a body with principal moments i1, i2, i3, its centre of mass at (x, y, z) on the axes."""
    (_, theta, psi), (dphi, dtheta, dpsi) = q, v
    st, ct, sp, cp = sin(theta), cos(theta), sin(psi), cos(psi)
    w1 = dphi * st * sp + dtheta * cp
    w2 = dphi * st * cp - dtheta * sp
    w3 = dphi * ct + dpsi
    # The vertical on the axes of the body; the moment of the weight is −m g (x, y, z) × vertical.
    e1, e2, e3 = st * sp, st * cp, ct
    weight = p["m"] * p["g"]
    n1 = -weight * (p["y"] * e3 - p["z"] * e2)
    n2 = -weight * (p["z"] * e1 - p["x"] * e3)
    n3 = -weight * (p["x"] * e2 - p["y"] * e1)
    a1 = (n1 + (p["i2"] - p["i3"]) * w2 * w3) / p["i1"]
    a2 = (n2 + (p["i3"] - p["i1"]) * w3 * w1) / p["i2"]
    a3 = (n3 + (p["i1"] - p["i2"]) * w1 * w2) / p["i3"]
    # What φ̈, θ̈ and ψ̈ leave of the rates of w1, w2, w3.
    b1 = a1 - (dphi * (dtheta * ct * sp + dpsi * st * cp) - dtheta * dpsi * sp)
    b2 = a2 - (dphi * (dtheta * ct * cp - dpsi * st * sp) - dtheta * dpsi * cp)
    b3 = a3 + dphi * dtheta * st
    ddphi = (b1 * sp + b2 * cp) / st
    return ddphi, b1 * cp - b2 * sp, b3 - ddphi * ct


def symmetric(p, q, v):
    body = {"i1": p["i"], "i2": p["i"], "i3": p["i_s"], "m": p["m"], "g": p["g"], "x": mpf(0), "y": mpf(0), "z": p["l"]}
    return general(body, q, v)


def inclinations():
    for size in ("1e-2", "1e-4", "1e-6"):
        yield size, float(size)
    for size in ("1e-2", "1e-4", "1e-6"):
        yield "π-" + size, float(pi - mpf(size))


def states(theta, draw):
    """Every sign of the velocities, slow and fast rotations, and the precession that a fast spin has."""
    for phi, psi in itertools.product((0.3, -2.0), (0.0, 0.7, 1.9, -2.6)):
        for size in (1.0, 20.0):
            yield [phi, theta, psi], [draw.uniform(-size, size) for _ in range(3)]
        spin = draw.uniform(-30, 30)
        yield [phi, theta, psi], [draw.uniform(-1, 1), draw.uniform(-1, 1) * theta, spin]
        yield [phi, theta, psi], [0.0, 0.0, spin]


def case(solve, parameters, q, v):
    exact = {name: mpf(value) for name, value in parameters.items()}
    qdd = solve(exact, [mpf(x) for x in q], [mpf(x) for x in v])
    return {"q": [repr(x) for x in q], "qd": [repr(x) for x in v], "qdd": [mp.nstr(x, 40) for x in qdd]}


def model(solve, parameters):
    draw = random.Random(1788)
    cases = {name: [case(solve, parameters, q, v) for q, v in states(theta, draw)] for name, theta in inclinations()}
    return {"parameters": {name: repr(value) for name, value in parameters.items()}, "theta": cases}


if __name__ == "__main__":
    print(json.dumps({"symmetric": model(symmetric, SYMMETRIC), "general": model(general, GENERAL)}, indent=0, ensure_ascii=False))
