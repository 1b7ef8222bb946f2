"""CasADi for the Stewart platform of the ready models: accelerations and multipliers as an SX graph, generated C.

Usage: casadi_stewart.py OUTPUT.c. The program OUTPUT.c reads 24 coordinates, 24 velocities and the time from the file that is its first
argument, evaluates as often as its second argument says, and prints the 48 values and the seconds. M is factored by CasADi's sparse
`ldl`, and G M⁻¹ Gᵀ after it, as for a Lagrangian of a textbook. In CasADi's favour: parameters are constants, common subexpressions are
eliminated, nothing tests pivots or refines, tests for null pointers are left out, and its square is made static.
"""

import json
import math
import re
import sys
import time

import casadi as ca

HEIGHT, RADIUS, OMEGA, GRAVITY = 1.0, 0.2, 1.5, 9.81


def hexagon(radius, angle):
    points = []
    for k in range(6):
        direction = 2 * math.pi / 3 * ((k + 1) // 2 % 3) + (angle if k % 2 == 0 else -angle)
        points.append(ca.DM([radius * math.cos(direction), radius * math.sin(direction), 0]))
    return points


def turn(axis, angle):
    c, s = ca.cos(angle), ca.sin(angle)
    j, k = (axis + 1) % 3, (axis + 2) % 3
    matrix = ca.SX.eye(3)
    matrix[j, j], matrix[j, k], matrix[k, j], matrix[k, k] = c, -s, s, c
    return matrix


def energy(q, v, mass, height, across, axial, w, origin, rotation):
    """T − V of a symmetric body with the angular velocity w in its axes."""
    center = origin + rotation @ ca.vertcat(0, 0, height)
    velocity = ca.jtimes(center, q, v)
    turning = across * (w[0] ** 2 + w[1] ** 2) + axial * w[2] ** 2
    return 0.5 * mass * ca.dot(velocity, velocity) + 0.5 * turning - mass * GRAVITY * center[2]


def equations(q, v, t):
    """q̈ and λ."""
    base, top = hexagon(1.0, 0.2), hexagon(0.6, 0.8471975511965977)
    p, (yaw, pitch, roll), (vy, vp, vr) = q[0:3], ca.vertsplit(q[3:6]), ca.vertsplit(v[3:6])
    rotation = turn(2, yaw) @ turn(1, pitch) @ turn(0, roll)
    w = ca.vertcat(
        vr - vy * ca.sin(pitch),
        vp * ca.cos(roll) + vy * ca.cos(pitch) * ca.sin(roll),
        -vp * ca.sin(roll) + vy * ca.cos(pitch) * ca.cos(roll),
    )
    lagrangian = energy(q, v, 40.0, 0.0, 2.0, 4.0, w, p, rotation)
    goal = ca.vertcat(RADIUS * ca.cos(OMEGA * t), RADIUS * ca.sin(OMEGA * t), HEIGHT)
    joints, drives = [], []
    for k in range(6):
        a, b, s, va, vb = q[6 + k], q[12 + k], q[18 + k], v[6 + k], v[12 + k]
        leg = turn(1, a) @ turn(0, b)
        w = ca.vertcat(vb, va * ca.cos(b), -va * ca.sin(b))
        end = base[k] + s * leg[:, 2]
        lagrangian += energy(q, v, 3.0, 0.3, 0.35, 0.01, w, base[k], leg)
        lagrangian += energy(q, v, 1.5, -0.3, 0.18, 0.002, w, end, leg)
        joints.append(end - p - rotation @ top[k])
        drives.append(s - ca.norm_2(goal + top[k] - base[k]))
    constraints = ca.vertcat(*joints, *drives)
    momenta = ca.gradient(lagrangian, v)
    mass = ca.jacobian(momenta, v)
    forcing = ca.gradient(lagrangian, q) - ca.jtimes(momenta, q, v)
    jacobian = ca.jacobian(constraints, q)
    rates = jacobian @ v + ca.jacobian(constraints, t)
    gamma = ca.jtimes(rates, q, v) + ca.jacobian(rates, t)
    factors = ca.ldl(mass)
    columns, free = ca.ldl_solve(ca.SX(jacobian.T), *factors), ca.ldl_solve(forcing, *factors)
    multipliers = ca.ldl_solve(-(jacobian @ free + gamma), *ca.ldl(jacobian @ columns))
    return ca.vertcat(free + columns @ multipliers, multipliers)


MAIN = """
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
int main(int count, char **arguments) {
    double x[49], y[48];
    static double w[%d];
    static long long iw[%d];
    const double *arg[%d];
    double *res[%d];
    struct timespec begin, end;
    FILE *file = fopen(arguments[1], "r");
    for (int i = 0; i < 49; i++) if (fscanf(file, "%%lf", &x[i]) != 1) return 1;
    long evaluations = atol(arguments[2]);
    clock_gettime(CLOCK_MONOTONIC, &begin);
    for (long i = 0; i < evaluations; i++) {
        __asm__ volatile("" :: "r"(x), "r"(y) : "memory");
        arg[0] = x;
        res[0] = y;
        stewart(arg, res, iw, w, 0);
    }
    clock_gettime(CLOCK_MONOTONIC, &end);
    for (int i = 0; i < 48; i++) printf("%%.17e\\n", y[i]);
    printf("%%.9e\\n", (end.tv_sec - begin.tv_sec) + 1e-9 * (end.tv_nsec - begin.tv_nsec));
}
"""

start = time.perf_counter()
x = ca.SX.sym("x", 49)
values = ca.cse(ca.densify(equations(x[0:24], x[24:48], x[48])))
function = ca.Function("stewart", [x], [values])
generator = ca.CodeGenerator("stewart")
generator.add(function)
source = generator.dump()
source = source.replace("\ncasadi_real casadi_sq(", "\nstatic inline casadi_real casadi_sq(")
source = re.sub(r"arg\[(\d)\]\? (arg\[\d\]\[\d+\]) : 0", r"\2", source)
source = re.sub(r"if \(res\[0\]!=0\) ", "", source)
sizes = (function.sz_w() + 1, function.sz_iw() + 1, function.sz_arg(), function.sz_res())
with open(sys.argv[1], "w") as file:
    file.write(source + MAIN % sizes)
print(json.dumps({"derive_seconds": time.perf_counter() - start}))
