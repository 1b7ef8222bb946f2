"""CasADi: SX graphs, `ldl` of the mass matrix, generated C. Usage: casadi_peer.py MODEL OUTPUT.c"""

import json
import sys
import time

import casadi as ca

from energies import degrees, lagrangian

model, output = sys.argv[1:]
n = degrees(model)
start = time.perf_counter()
x = ca.SX.sym("x", 2 * n)
q, v = x[:n], x[n:]
energy = lagrangian(model, [q[i] for i in range(n)], [v[i] for i in range(n)], ca.sin, ca.cos)
momenta = ca.gradient(energy, v)
mass_matrix = ca.jacobian(momenta, v)
forcing = ca.gradient(energy, q) - ca.jtimes(momenta, q, v)
diagonal, upper, permutation = ca.ldl(mass_matrix)
solution = ca.ldl_solve(forcing, diagonal, upper, permutation)
function = ca.Function("solve_lagrange", [x], [ca.densify(solution)])
# It writes to the folder it is called in only.
generator = ca.CodeGenerator("solve_lagrange")
generator.add(function)
source = generator.dump()
sizes = function.sz_arg(), function.sz_res(), function.sz_iw() + 1, function.sz_w() + 1
source += """
void accelerations(const double* x, double* a) {
  const double* arg[%d] = {x};
  double* res[%d] = {a};
  static casadi_int iw[%d];
  static double w[%d];
  solve_lagrange(arg, res, iw, w, 0);
}
""" % sizes
with open(output, "w") as file:
    file.write(source)
seconds = time.perf_counter() - start
print(json.dumps({"derive_seconds": seconds, "operations": function.n_instructions()}))
