#!/usr/bin/env python3
"""The end of the motion of a pendulum on a light cart, by the solvers of SciPy at their default tolerances, as JSON.

    python3 light_cart_pole.py CART POLE LENGTH GRAVITY ANGLE END
"""

import json
import sys

import numpy
from scipy.integrate import solve_ivp

METHODS = ["RK45", "RK23", "DOP853", "Radau", "BDF", "LSODA"]


def main():
    cart, pole, length, gravity, angle, end = map(float, sys.argv[1:])

    def derivative(_, state):
        _, theta, v, omega = state
        sine, cosine = numpy.sin(theta), numpy.cos(theta)
        mass = [[cart + pole, pole * length * cosine], [pole * length * cosine, pole * length**2]]
        force = [pole * length * sine * omega**2, -pole * gravity * length * sine]
        return [v, omega, *numpy.linalg.solve(mass, force)]

    ends = []
    for method in METHODS:
        solution = solve_ivp(derivative, [0.0, end], [0.0, angle, 0.0, 0.0], method=method)
        ends.append({"method": method, "steps": len(solution.t) - 1, "end": list(solution.y[:2, -1])})
    print(json.dumps(ends))


if __name__ == "__main__":
    main()
