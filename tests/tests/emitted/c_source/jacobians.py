"""Compares the Jacobians of an external function of CasADi with its differences.

Arguments: the compiled library, the name of the model, and the numbers t, x, u and p, each list with commas, as `1,2`, or empty.
Prints for each argument the largest difference, over the largest element or one.
"""

import sys

import casadi
import numpy

library, name, *lists = sys.argv[1:]
arguments = [numpy.array([float(x) for x in text.split(",") if x]) for text in lists]
# Without `enable_fd`: all derivatives are those of the library.
dynamics = casadi.external(f"{name}_dynamics", library)
symbols = [casadi.MX.sym(f"s{i}", len(x)) for i, x in enumerate(arguments)]
value = dynamics(*symbols)
for label, symbol, i in zip("txup", symbols, range(4)):
    if len(arguments[i]) == 0:
        continue
    jacobian = casadi.Function("j", symbols, [casadi.jacobian(value, symbol)])
    found = numpy.array(jacobian(*arguments))
    expected = numpy.zeros_like(found)
    for j, x in enumerate(arguments[i]):
        # Differences of fourth order.
        step = 1e-3 * max(abs(x), 1e-3 if label == "p" else 1e-1)
        for weight, place in ((8, 1), (-8, -1), (-1, 2), (1, -2)):
            moved = [y.copy() for y in arguments]
            moved[i][j] += place * step
            expected[:, j] += weight * numpy.array(dynamics(*moved))[:, 0] / (12 * step)
    print(label, abs(found - expected).max() / max(abs(expected).max(), 1.0))
# Forward and reverse derivatives, and an integrator of stiff systems, are made of the Jacobian.
direction = casadi.DM.ones(len(arguments[1]))
products = [casadi.jtimes(value, symbols[1], direction, reverse) for reverse in (False, True)]
forward, reverse = casadi.Function("products", symbols, products)(*arguments)
by_state = casadi.Function("j", symbols, [casadi.jacobian(value, symbols[1])])(*arguments)
assert casadi.norm_inf(forward - by_state @ direction) <= 1e-12 * casadi.norm_inf(forward)
assert casadi.norm_inf(reverse - by_state.T @ direction) <= 1e-12 * casadi.norm_inf(reverse)
system = {"x": symbols[1], "p": casadi.vertcat(symbols[2], symbols[3]), "t": symbols[0], "ode": value}
integrator = casadi.integrator("end", "cvodes", system, 0.0, 1e-3)
end = integrator(x0=arguments[1], p=numpy.concatenate(arguments[2:]))["xf"]
assert not numpy.isnan(numpy.array(end)).any()
# Its linear model is the Jacobian.
linear = casadi.external(f"{name}_linear_model", library)
a, b = linear(*arguments)
assert casadi.norm_inf(a - by_state) == 0.0
