"""The Lagrangians of the models, in whatever symbols a peer computes with."""

G = 9.81
MASS, LENGTH = 1.1, 0.7


def degrees(model):
    """The number of coordinates: `P5` has five links."""
    return 3 if model[0] == "A" else int(model[1:])


def lagrangian(model, q, v, sin, cos):
    """L = T - V, from the peer's sine and cosine."""
    if model == "A1":
        return symmetric_top(q, v, sin, cos)
    if model == "A2":
        return general_top(q, v, sin, cos)
    return pendulum(q, v, sin, cos)


def symmetric_top(q, v, sin, cos):
    theta = q[1]
    phi_dot, theta_dot, psi_dot = v
    across = 1.2 * (phi_dot**2 * sin(theta) ** 2 + theta_dot**2)
    along = 0.5 * (phi_dot * cos(theta) + psi_dot) ** 2
    return 0.5 * (across + along) - 1.3 * G * 0.4 * cos(theta)


def general_top(q, v, sin, cos):
    theta, psi = q[1], q[2]
    phi_dot, theta_dot, psi_dot = v
    s, c, sp, cp = sin(theta), cos(theta), sin(psi), cos(psi)
    w1 = phi_dot * s * sp + theta_dot * cp
    w2 = phi_dot * s * cp - theta_dot * sp
    w3 = phi_dot * c + psi_dot
    kinetic = 0.5 * (1.2 * w1**2 + 1.5 * w2**2 + 0.7 * w3**2)
    return kinetic - 1.3 * G * (0.05 * s * sp + 0.03 * s * cp + 0.4 * c)


def pendulum(q, v, sin, cos):
    result = x_dot = y_dot = y = 0
    for angle, rate in zip(q, v):
        x_dot = x_dot + LENGTH * cos(angle) * rate
        y_dot = y_dot + LENGTH * sin(angle) * rate
        y = y - LENGTH * cos(angle)
        result = result + 0.5 * MASS * (x_dot**2 + y_dot**2) - MASS * G * y
    return result
