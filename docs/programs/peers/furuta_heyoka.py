"""Furuta's pendulum with heyoka.py.

Run with Python 3.11, heyoka.py 7.13.2, NumPy 2.4.6 and SciPy 1.17.1: python furuta_heyoka.py > furuta_heyoka.txt
"""

import heyoka as hy
import numpy as np
from scipy.linalg import solve_continuous_are

# Coordinates, velocities, and the torque of the motor, a parameter at run time.
alpha, theta, v_alpha, v_theta = hy.make_vars("alpha", "theta", "v_alpha", "v_theta")
torque = hy.par[0]
j, m, r, l, g, d_alpha, d_theta = 3e-3, 0.2, 0.25, 0.3, 9.81, 2e-3, 5e-4

tip = [
    r * hy.cos(alpha) - l * hy.sin(theta) * hy.sin(alpha),
    r * hy.sin(alpha) + l * hy.sin(theta) * hy.cos(alpha),
    -l * hy.cos(theta),
]
velocity = [hy.diff(x, alpha) * v_alpha + hy.diff(x, theta) * v_theta for x in tip]
kinetic = 0.5 * j * v_alpha**2 + 0.5 * m * sum(x**2 for x in velocity)
# The work of a constant torque is a potential.
potential = m * g * tip[2] - torque * alpha
friction = 0.5 * (d_alpha * v_alpha**2 + d_theta * v_theta**2)
system = hy.lagrangian(kinetic - potential, [alpha, theta], [v_alpha, v_theta], friction)


# The motor turns the arm up to 1 rad, then it is switched off.
def switch_off(integrator, direction):
    switches.append(integrator.time)
    integrator.pars[0] = 0.0
    return True


switches = []
event = hy.t_event(alpha - 1.0, direction=hy.event_direction.positive, callback=switch_off)
integrator = hy.taylor_adaptive(system, [0.0] * 4, pars=[0.05], t_events=[event])
while integrator.time < 10.0:
    outcome = integrator.propagate_until(10.0)[0]
    assert outcome == hy.taylor_outcome.time_limit or int(outcome) >= 0, outcome

# Linear model about the upright rod, by derivatives of the right-hand sides.
variables = [alpha, theta, v_alpha, v_theta]
sides = [side for _, side in system]
derivatives = [hy.diff(side, x) for side in sides for x in variables] + [hy.diff(side, torque) for side in sides]
numbers = hy.cfunc(derivatives, variables)([0.0, np.pi, 0.0, 0.0], pars=[0.0])
a, b = numbers[:16].reshape(4, 4), numbers[16:].reshape(4, 1)
k = b.T @ solve_continuous_are(a, b, np.eye(4), np.eye(1))

for name, numbers in [("switch", switches), ("end", integrator.state), ("a", a), ("b", b), ("k", k)]:
    print(name, *map(repr, map(float, np.ravel(numbers))))
