"""CasADi for an arm in space: the recursions of textbooks or a declared Lagrangian as SX graphs, generated C.

Usage: casadi_arm.py ALGORITHM ARM.json OUTPUT.c. In CasADi's favour: base inertial parameters are constants, sines and cosines are
computed before the recursions and not amid them, its tests for null pointers are left out, and its square is made static, since gcc
does not inline an exported function of a shared object.
"""

import json
import re
import sys
import time

import casadi as ca

import arm_recursions as recursions

algorithm, arm, output = sys.argv[1:]
with open(arm) as file:
    arm = json.load(file)
links, gravity = arm["links"], arm["gravity"]
n = len(links)
is_inverse = algorithm in ("inverse_dynamics", "lagrangian_inverse")
is_declared = algorithm.startswith("lagrangian")


def lagrangian(q, v):
    """T − V: positions by the product of rotations, their velocities by differentiation, angular velocities by recursion."""
    rotation, place, w, total = ca.SX.eye(3), ca.SX(3, 1), ca.SX(3, 1), 0
    for i, body in enumerate(arm["bodies"]):
        k = links[i]["axis"]
        a, b = recursions.others(k)
        turn = ca.SX(3, 3)
        c, s = ca.cos(q[i]), ca.sin(q[i])
        turn[a, a], turn[b, b], turn[a, b], turn[b, a], turn[k, k] = c, c, -s, s, 1
        if i:
            place = place + rotation @ ca.DM(arm["bodies"][i - 1]["link"])
        rotation, w = rotation @ turn, turn.T @ w
        w[k] += v[i]
        center = place + rotation @ ca.DM(body["center"])
        velocity = ca.jtimes(center, q, v)
        inertia = ca.DM(body["inertia"])
        total += 0.5 * body["mass"] * ca.dot(velocity, velocity) + 0.5 * ca.dot(w, inertia @ w) - body["mass"] * gravity * center[2]
    return total


def by_lagrange(q, v, accelerations):
    energy = lagrangian(q, v)
    momenta = ca.gradient(energy, v)
    if is_inverse:
        return ca.jtimes(momenta, ca.vertcat(q, v), ca.vertcat(v, accelerations)) - ca.gradient(energy, q)
    mass = ca.jacobian(momenta, v)
    diagonal, upper, permutation = ca.ldl(mass)
    return ca.ldl_solve(ca.gradient(energy, q) - ca.jtimes(momenta, q, v), diagonal, upper, permutation)


start = time.perf_counter()
x = ca.SX.sym("x", (3 if is_inverse else 2) * n)
functions = ca.SX.sym("functions", 0 if is_declared else 2 * n)
if is_declared:
    values = by_lagrange(x[:n], x[n : 2 * n], x[2 * n :])
else:
    turns = [(0, 1)] + [(functions[i], functions[n + i]) for i in range(1, n)]
    v = [x[n + i] for i in range(n)]
    accelerations = ([[x[2 * n + i] for i in range(n)]] if is_inverse else [])
    values = ca.vertcat(*getattr(recursions, algorithm)(links, turns, v, *accelerations, gravity))
function = ca.Function("recursion", [x, functions], [ca.cse(ca.densify(values))])
arithmetic = {ca.OP_ADD, ca.OP_SUB, ca.OP_TWICE, ca.OP_MUL, ca.OP_SQ, ca.OP_DIV, ca.OP_INV}
operations = sum(function.instruction_id(i) in arithmetic for i in range(function.n_instructions()))
# It writes to the folder it is called in only.
generator = ca.CodeGenerator("recursion")
generator.add(function)
source = generator.dump()
source = source.replace("\ncasadi_real casadi_sq(", "\nstatic inline casadi_real casadi_sq(")
source = re.sub(r"arg\[(\d)\]\? (arg\[\d\]\[\d+\]) : 0", r"\2", source)
source = re.sub(r"if \(res\[0\]!=0\) ", "", source)
sines = "" if is_declared else "  for (int i = 1; i < %d; i++) { f[i] = sin(x[i]); f[%d + i] = cos(x[i]); }\n" % (n, n)
sizes = function.sz_arg(), function.sz_res(), function.sz_iw() + 1, function.sz_w() + 1
source += """
void accelerations(const double* x, double* y) {
  double f[%d];
%s  const double* arg[%d] = {x, f};
  double* res[%d] = {y};
  casadi_int iw[%d];
  double w[%d];
  recursion(arg, res, iw, w, 0);
}
""" % (2 * n, sines, *sizes)
with open(output, "w") as file:
    file.write(source)
print(json.dumps({"derive_seconds": time.perf_counter() - start, "operations": operations}))
