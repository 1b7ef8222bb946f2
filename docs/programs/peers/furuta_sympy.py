"""Furuta's pendulum with SymPy and SciPy.

Run with Python 3.11, SymPy 1.14.0, NumPy 2.4.6 and SciPy 1.17.1: python furuta_sympy.py > furuta_sympy.txt
"""

import numpy as np
import sympy as sm
from scipy.integrate import solve_ivp
from scipy.linalg import solve_continuous_are
from sympy.physics.mechanics import (
    LagrangesMethod, Lagrangian, Particle, Point, ReferenceFrame, RigidBody, dynamicsymbols, inertia,
)

# Symbols: coordinates, velocities, parameters and the input.
alpha, theta = q = dynamicsymbols("alpha theta")
v = [x.diff() for x in q]
torque = dynamicsymbols("torque")
j, m, r, l, g, d_alpha, d_theta = sm.symbols("j m r l g d_alpha d_theta")

# The arm turns about z, the rod about the arm.
space = ReferenceFrame("space")
turned = space.orientnew("turned", "Axis", (alpha, space.z))
swung = turned.orientnew("swung", "Axis", (theta, turned.x))
origin = Point("origin")
origin.set_vel(space, 0)
joint = origin.locatenew("joint", r * turned.x)
tip = joint.locatenew("tip", -l * swung.z)
tip.set_vel(space, tip.pos_from(origin).dt(space))

arm = RigidBody("arm", origin, turned, 0, (inertia(turned, 0, 0, j), origin))
bob = Particle("bob", tip, m)
bob.potential_energy = m * g * tip.pos_from(origin).dot(space.z)
torques = [
    (turned, (torque - d_alpha * v[0]) * space.z),
    (swung, -d_theta * v[1] * turned.x),
    (turned, d_theta * v[1] * turned.x),
]
method = LagrangesMethod(Lagrangian(space, arm, bob), q, forcelist=torques, frame=space)
method.form_lagranges_equations()

# Numerical functions of (q, v), the torque and the parameters.
values = {j: 3e-3, m: 0.2, r: 0.25, l: 0.3, g: 9.81, d_alpha: 2e-3, d_theta: 5e-4}
mass = sm.lambdify([q + v, torque], method.mass_matrix_full.subs(values))
forcing = sm.lambdify([q + v, torque], method.forcing_full.subs(values))


def rate(torque):
    return lambda t, x: np.linalg.solve(mass(x, torque), forcing(x, torque)).ravel()


# The motor turns the arm up to 1 rad, then it is switched off.
def switch(t, x):
    return x[0] - 1.0


switch.terminal, switch.direction = True, 1
settings = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-12}
driven = solve_ivp(rate(0.05), (0, 10), np.zeros(4), events=switch, **settings)
free = solve_ivp(rate(0.0), (driven.t[-1], 10), driven.y[:, -1], **settings)

# Linear model about the upright rod, and the regulator with unit weights.
rest = {v[0].diff(): 0, v[1].diff(): 0, v[0]: 0, v[1]: 0, alpha: 0, theta: sm.pi, torque: 0}
a, b, _ = method.linearize(q_ind=q, qd_ind=v, A_and_B=True, op_point=rest)
a, b = (np.array(x.subs(values), dtype=float) for x in (a, b))
k = b.T @ solve_continuous_are(a, b, np.eye(4), np.eye(1))

for name, numbers in [("switch", driven.t[-1:]), ("end", free.y[:, -1]), ("a", a), ("b", b), ("k", k)]:
    print(name, *map(repr, map(float, np.ravel(numbers))))
