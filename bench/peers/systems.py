"""The systems that are integrated: first-order equations by hand with constants folded, and Lagrangians.

The equations by hand are the best ones known for each: Euler's equations mapped back to the angles for the tops, the
tensions of the rods for chains (O(n), in the sines and cosines of the angles between neighbours), the closed form
in absolute angles for the arm, and each distance once for the three bodies.
"""

from energies import G, LENGTH, MASS
import energies

ARM = {
    "j1": 0.5, "m2": 3.0, "m3": 2.0, "l2": 0.5, "a2": 0.25, "a3": 0.2, "i2": 0.06, "i3": 0.03, "g": G,
    "b1": 0.1, "b2": 0.1, "b3": 0.05, "k1": 2.0, "k2": 10.0, "k3": 3.0, "w": 2.0,
}


def degrees(name):
    """The number of coordinates."""
    return {"arm": 3, "figure-eight": 6}.get(name) or energies.degrees(name)


def by_hand(name, x, sin, cos, t):
    """The derivatives of coordinates and velocities."""
    n = degrees(name)
    q, v = list(x[:n]), list(x[n:])
    equations = {"A1": symmetric_top, "A2": general_top, "P2": double_pendulum, "arm": arm, "figure-eight": three_bodies}
    return v + equations.get(name, chain)(q, v, sin, cos, t)


def lagrangian(name, q, v, sin, cos):
    """L, or nothing where the peer's own derivation cannot do it: forces that depend on time."""
    if name == "arm":
        return None
    if name == "figure-eight":
        kinetic = sum(0.5 * rate**2 for rate in v)
        pairs = ((0, 2), (0, 4), (2, 4))
        return kinetic + sum(((q[i] - q[j]) ** 2 + (q[i + 1] - q[j + 1]) ** 2) ** -0.5 for i, j in pairs)
    return energies.lagrangian(name, q, v, sin, cos)


def symmetric_top(q, v, sin, cos, _):
    across, along, mgl = 1.2, 0.5, 1.3 * G * 0.4
    phi, theta, psi = v
    s, c = sin(q[1]), cos(q[1])
    w3 = phi * c + psi
    phi_rate = (along * w3 - 2.0 * across * (phi * c)) * theta / (across * s)
    theta_rate = s * (across * (phi * (phi * c)) - along * (w3 * phi) + mgl) * (1.0 / across)
    return [phi_rate, theta_rate, phi * (theta * s) - phi_rate * c]


def general_top(q, v, sin, cos, _):
    i1, i2, i3 = 1.2, 1.5, 0.7
    mx, my, mz = (1.3 * G * center for center in (0.05, 0.03, 0.4))
    phi, theta, psi = v
    s, c, sp, cp = sin(q[1]), cos(q[1]), sin(q[2]), cos(q[2])
    k1, k2, along = s * sp, s * cp, phi * c
    w1, w2, w3 = phi * k1 + theta * cp, phi * k2 - theta * sp, along + psi
    r1 = ((i2 - i3) * (w2 * w3) - (my * c - mz * k2)) * (1.0 / i1)
    r2 = ((i3 - i1) * (w3 * w1) - (mz * k1 - mx * c)) * (1.0 / i2)
    r3 = ((i1 - i2) * (w1 * w2) - (mx * k2 - my * k1)) * (1.0 / i3)
    e1, e2 = r1 - psi * w2, r2 + psi * w1
    phi_rate = (e1 * sp + e2 * cp - theta * along) / s
    return [phi_rate, e1 * cp - e2 * sp, r3 - phi_rate * c + phi * (theta * s)]


def double_pendulum(q, v, sin, cos, _):
    s, c = sin(q[0] - q[1]), cos(q[0] - q[1])
    f1 = -(s * (v[1] * v[1])) - 2.0 * (G / LENGTH) * sin(q[0])
    f2 = s * (v[0] * v[0]) - (G / LENGTH) * sin(q[1])
    d = 1.0 / (2.0 - c * c)
    return [(f1 - c * f2) * d, (2.0 * f2 - c * f1) * d]


def chain(q, v, sin, cos, _):
    """The tensions, for a unit of mass and length, solve a tridiagonal system: 1, 2, 2, … and beside it -c."""
    n = len(q)
    s = [sin(q[i + 1] - q[i]) for i in range(n - 1)]
    c = [cos(q[i + 1] - q[i]) for i in range(n - 1)]
    b = [v[i] * v[i] for i in range(n)]
    b[0] = b[0] + (G / LENGTH) * cos(q[0])
    # Factors p of the elimination from the top, then back.
    p, tension = [-c[0]], [b[0]]
    for i in range(1, n):
        r = 1.0 / (2.0 + c[i - 1] * p[i - 1])
        tension.append((b[i] + c[i - 1] * tension[i - 1]) * r)
        if i + 1 < n:
            p.append(-c[i] * r)
    for i in reversed(range(n - 1)):
        tension[i] = tension[i] - p[i] * tension[i + 1]
    rates = []
    for i in range(n):
        above = tension[i - 1] * s[i - 1] if i > 0 else (G / LENGTH) * sin(q[0])
        rates.append(tension[i + 1] * s[i] - above if i + 1 < n else -above)
    return rates


def arm(q, v, sin, cos, t):
    """In the absolute angles of the two links, where the coupling is K cos(β - α)."""
    p = ARM
    alpha, beta = q[1], q[1] + q[2]
    a, b = v[1], v[1] + v[2]
    d = p["a2"] ** 2 * p["m2"] + p["i2"]
    first, second = d + p["l2"] ** 2 * p["m3"], p["a3"] ** 2 * p["m3"] + p["i3"]
    coupling = p["a3"] * p["l2"] * p["m3"]
    sa, ca, sb, cb = sin(alpha), cos(alpha), sin(beta), cos(beta)
    s, c = sin(q[2]), cos(q[2])
    reach = p["a3"] * cb + p["l2"] * ca
    # The moment of inertia about the vertical, and its derivatives.
    j = p["i3"] * cb**2 + p["j1"] + p["m3"] * reach**2 + d * ca**2
    j_a = -2.0 * sa * (p["m3"] * p["l2"] * reach + d * ca)
    j_b = -2.0 * sb * (p["i3"] * cb + p["m3"] * p["a3"] * reach)
    q1 = p["k1"] * sin(p["w"] * t) - p["b1"] * v[0]
    q2 = p["k2"] * cos(p["w"] * t) - p["b2"] * v[1]
    q3 = p["k3"] - p["b3"] * v[2]
    half = 0.5 * v[0] ** 2
    fa = q2 - q3 + coupling * s * b**2 + half * j_a - p["g"] * (p["a2"] * p["m2"] + p["m3"] * p["l2"]) * ca
    fb = q3 - coupling * s * a**2 + half * j_b - p["g"] * p["m3"] * p["a3"] * cb
    k = coupling * c
    r = 1.0 / (first * second - k * k)
    a_rate, b_rate = (second * fa - k * fb) * r, (first * fb - k * fa) * r
    return [(q1 - (j_a * a + j_b * b) * v[0]) / j, a_rate, b_rate - a_rate]


def three_bodies(q, _, sin, cos, t):
    rates = [0.0] * 6
    for i, j in ((0, 2), (0, 4), (2, 4)):
        dx, dy = q[j] - q[i], q[j + 1] - q[i + 1]
        cubed = (dx * dx + dy * dy) ** -1.5
        fx, fy = dx * cubed, dy * cubed
        rates[i], rates[i + 1] = rates[i] + fx, rates[i + 1] + fy
        rates[j], rates[j + 1] = rates[j] - fx, rates[j + 1] - fy
    return rates
