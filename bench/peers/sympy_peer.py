"""SymPy: LagrangesMethod, the mass matrix solved in symbols, cse, C. Usage: sympy_peer.py MODEL OUTPUT.c"""

import json
import sys
import time

import sympy as sp
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

from energies import degrees, lagrangian

model, output = sys.argv[1:]
n = degrees(model)
start = time.perf_counter()
q = dynamicsymbols(f"q0:{n}")
v = [coordinate.diff() for coordinate in q]
method = LagrangesMethod(lagrangian(model, q, v, sp.sin, sp.cos), q)
method.form_lagranges_equations()
x = sp.symbols(f"x0:{2 * n}")
# The velocities first: they contain the coordinates.
plain = lambda matrix: matrix.subs(dict(zip(v, x[n:]))).subs(dict(zip(q, x[:n])))
solution = plain(method.mass_matrix).LUsolve(plain(method.forcing))
shared, results = sp.cse(list(solution), symbols=sp.numbered_symbols("c"))
lines = ["#include <math.h>", "void accelerations(const double *x, double *a) {"]
lines += [f"const double x{i} = x[{i}];" for i in range(2 * n)]
lines += [f"const double {name} = {sp.ccode(value)};" for name, value in shared]
lines += [f"a[{i}] = {sp.ccode(value)};" for i, value in enumerate(results)]
with open(output, "w") as file:
    file.write("\n".join(lines + ["}"]))
seconds = time.perf_counter() - start
operations = sum(sp.count_ops(value) for value in [value for _, value in shared] + results)
print(json.dumps({"derive_seconds": seconds, "operations": int(operations)}))
