"""Furuta's pendulum with CasADi.

Run with Python 3.11, CasADi 3.8.2, NumPy 2.4.6 and SciPy 1.17.1: python furuta_casadi.py > furuta_casadi.txt
"""

import casadi as ca
import numpy as np
from scipy.linalg import solve_continuous_are

q, v, torque = ca.SX.sym("q", 2), ca.SX.sym("v", 2), ca.SX.sym("torque")
alpha, theta = ca.vertsplit(q)
j, m, r, l, g, d_alpha, d_theta = 3e-3, 0.2, 0.25, 0.3, 9.81, 2e-3, 5e-4

# Lagrange's equations, M dv/dt = f, by automatic differentiation.
tip = ca.vertcat(
    r * ca.cos(alpha) - l * ca.sin(theta) * ca.sin(alpha),
    r * ca.sin(alpha) + l * ca.sin(theta) * ca.cos(alpha),
    -l * ca.cos(theta),
)
velocity = ca.jtimes(tip, q, v)
lagrangian = 0.5 * j * v[0] ** 2 + 0.5 * m * ca.sumsqr(velocity) - m * g * tip[2]
forces = ca.vertcat(torque - d_alpha * v[0], -d_theta * v[1])
momenta = ca.gradient(lagrangian, v)
mass = ca.jacobian(momenta, v)
forcing = ca.gradient(lagrangian, q) - ca.jtimes(momenta, q, v) + forces
x = ca.vertcat(q, v)
rate = ca.vertcat(v, ca.solve(mass, forcing))

# The motor turns the arm up to 1 rad, then it is switched off: the torque is a state that the event sets to 0, and the time
# since then another. An event occurs where its function becomes negative.
since = ca.SX.sym("since")
state = ca.vertcat(x, torque, since)
dae = {"x": state, "ode": ca.vertcat(rate, 0, ca.if_else(torque > 0, 0, 1)), "zero": 1.0 - alpha}
index = ca.SX.sym("index")
transition = ca.Function(
    "transition",
    {"index": index, "x": state, "post_x": ca.vertcat(x, 0, since)},
    ca.event_in(), ca.event_out(),
)
settings = {"transition": transition, "abstol": 1e-12, "reltol": 1e-12, "max_num_steps": 1_000_000}
motion = ca.integrator("motion", "erk", dae, 0.0, 10.0, settings)
end = motion(x0=[0, 0, 0, 0, 0.05, 0])["xf"].full().ravel()

# Linear model about the upright rod.
linear = ca.Function("linear", [x, torque], [ca.jacobian(rate, x), ca.jacobian(rate, torque)])
a, b = (part.full() for part in linear([0, ca.pi, 0, 0], 0))
k = b.T @ solve_continuous_are(a, b, np.eye(4), np.eye(1))

for name, numbers in [("switch", 10.0 - end[5:]), ("end", end[:4]), ("a", a), ("b", b), ("k", k)]:
    print(name, *map(repr, map(float, np.ravel(numbers))))
