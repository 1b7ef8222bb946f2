"""Linear-quadratic regulators beside SciPy's.

    python3 -m venv target/adversarial/python
    target/adversarial/python/bin/pip install mpmath scipy
    target/adversarial/python/bin/python tests/adversarial/generator/regulators.py --seed 1 --count 48 --file tests/adversarial/models/regulators.json

Needs Python 3.11 with mpmath 1.3 and SciPy 1.11 or newer. Each problem is a plant (A, B), weights (Q, R), and whether time is
discrete. SciPy solves the Riccati equation; Newton's method in 240 bits goes on from there (D. L. Kleinman, On an iterative technique
for Riccati equation computations, IEEE Trans. Automat. Contr. 13, 1968; G. A. Hewer, An iterative technique for the computation of the
steady state gains for the discrete optimal regulator, IEEE Trans. Automat. Contr. 16, 1971). Problems that SciPy does not solve, or
solves for another matrix, are left out. The tolerance of a gain is what errors of a unit in the last place of A, B, Q and R make of
it, but at least SciPy's own error.
"""

import argparse
import json
import random
import sys
import warnings
from pathlib import Path

import numpy
import scipy.linalg
from mpmath import mp, mpf, matrix, norm

BITS = 240
UNIT = 2.0**-53
OFF = mpf(2) ** -70  # How much A, B, Q and R are moved to see what errors of theirs do.
ALLOWANCE = 64
NEWTON_STEPS = 40
USELESS = 1e-4  # A relative tolerance so great tests nothing.
SHAPES = ((2, 1), (2, 1), (2, 2), (2, 2), (4, 1), (4, 2), (4, 2), (6, 2))
PLANTS = ("plain", "mechanical", "fast", "slow", "stiff", "uncoupled", "unstable", "oscillators")
WEIGHTS = ("plain", "no_cost", "singular", "one_state", "diagonal", "scaled")
INPUTS = ("plain", "spread", "wide", "cheap", "expensive")


class Unsolved(ValueError):
    """SciPy has no solution, or one that is of no use."""


def random_matrix(rng, rows, columns):
    return numpy.array([[rng.uniform(-1, 1) for _ in range(columns)] for _ in range(rows)])


def plant(rng, kind, d, u):
    """A and B."""
    a, b = random_matrix(rng, d, d), random_matrix(rng, d, u)
    if kind in ("mechanical", "stiff", "oscillators"):
        n = d // 2
        spread = {"mechanical": 1, "stiff": 10 ** rng.uniform(4, 12), "oscillators": 100}[kind]
        k = random_matrix(rng, n, n)
        k = k @ k.T + numpy.diag([spread if i == 0 else 1.0 for i in range(n)])
        c = 0.0 if kind == "oscillators" or rng.random() < 0.5 else 0.1
        a = numpy.block([[numpy.zeros((n, n)), numpy.eye(n)], [-k, -c * numpy.eye(n)]])
        b = numpy.vstack([numpy.zeros((n, u)), random_matrix(rng, n, u)])
    elif kind == "fast":
        a = a * 10 ** rng.uniform(2, 9)
    elif kind == "slow":
        a = a * 10 ** rng.uniform(-6, -2)
    elif kind == "uncoupled":
        a = numpy.diag([rng.uniform(-2, 1) * 10 ** rng.uniform(-2, 3) for _ in range(d)])
    elif kind == "unstable":
        a = a + rng.uniform(0.5, 3) * numpy.eye(d)
    return a, b


def state_weight(rng, kind, d):
    q = random_matrix(rng, d, d)
    if kind == "no_cost":
        return numpy.zeros((d, d))
    if kind == "singular":
        q = q[:, : d // 2]
    if kind == "one_state":
        return numpy.diag([1.0 if i == d - 1 else 0.0 for i in range(d)])
    if kind == "diagonal":
        return numpy.diag([10 ** rng.uniform(-3, 3) for _ in range(d)])
    q = q @ q.T
    return q * 10 ** rng.uniform(-6, 6) if kind == "scaled" else q


def input_weight(rng, kind, u):
    if kind in ("spread", "wide"):
        spread = 10 ** (rng.uniform(2, 4) if kind == "spread" else rng.uniform(4, 6))
        return numpy.diag([1 / spread if i % 2 == 0 else spread for i in range(u)]) if u > 1 else numpy.array([[spread]])
    r = random_matrix(rng, u, u)
    r = r @ r.T + numpy.eye(u)
    return r * {"plain": 1.0, "cheap": 1e-5, "expensive": 1e5}[kind]


def sampled(a, b, rng):
    """The plant with inputs that are held over a period, of which no mode makes more than a turn."""
    d, u = b.shape
    period = rng.choice((0.01, 0.1, 0.5)) / max(1.0, max(abs(numpy.linalg.eigvals(a))))
    joined = scipy.linalg.expm(numpy.block([[a, b], [numpy.zeros((u, d + u))]]) * period)
    return joined[:d, :d], joined[:d, d:]


def exact(x):
    return matrix([[mpf(float(y)) for y in row] for row in x])


def lyapunov(a, c, discrete):
    """X of aᵀ X + X a + c = 0, or of X = aᵀ X a + c, by the linear equations of its entries."""
    n = a.rows
    system, right = mp.zeros(n * n), mp.zeros(n * n, 1)
    for i in range(n):
        for j in range(n):
            row = i * n + j
            right[row] = -c[i, j]
            for k in range(n):
                if discrete:
                    for m in range(n):
                        system[row, k * n + m] += a[k, i] * a[m, j]
                else:
                    system[row, k * n + j] += a[k, i]
                    system[row, i * n + k] += a[k, j]
            if discrete:
                system[row, row] -= 1
    x = mp.lu_solve(system, right)
    return matrix([[x[i * n + j] for j in range(n)] for i in range(n)])


def gain_of(p, a, b, r, discrete):
    return mp.inverse(r + b.T * p * b) * (b.T * p * a) if discrete else mp.inverse(r) * (b.T * p)


def refined(p, a, b, q, r, discrete):
    """The solution near p, by Newton's method, and its gain."""
    gain = gain_of(p, a, b, r, discrete)
    for _ in range(NEWTON_STEPS):
        closed = a - b * gain
        new = lyapunov(closed, q + gain.T * r * gain, discrete)
        new = (new + new.T) / 2
        moved, size = norm(new - p, mp.inf), norm(new, mp.inf)
        p, gain = new, gain_of(new, a, b, r, discrete)
        if moved <= mpf(2) ** -110 * size:
            return p, gain
    raise Unsolved("no convergence")


def is_stable(a, discrete):
    poles = mp.eig(a, left=False, right=False)
    worst = max(abs(x) if discrete else mp.re(x) for x in poles)
    return worst < (1 - mpf(10) ** -9 if discrete else 0)


def problem(rng, number):
    """One problem with its reference."""
    d, u = rng.choice(SHAPES)
    names = [rng.choice(names) for names in (PLANTS, WEIGHTS, INPUTS)]
    discrete = rng.random() < 0.5
    a, b = plant(rng, names[0], d, u)
    q, r = state_weight(rng, names[1], d), input_weight(rng, names[2], u)
    if discrete:
        a, b = sampled(a, b, rng)
    solve = scipy.linalg.solve_discrete_are if discrete else scipy.linalg.solve_continuous_are
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            found = solve(a, b, q, r)
    except (numpy.linalg.LinAlgError, ValueError, RuntimeWarning, scipy.linalg.LinAlgWarning) as error:
        raise Unsolved(str(error)) from error
    parts = [exact(x) for x in (a, b, q, r)]
    p, gain = refined(exact(found), *parts, discrete)
    if not is_stable(parts[0] - parts[1] * gain, discrete):
        raise Unsolved("not the stabilizing solution")
    tolerances = []
    moved = refined(p, *(off(x, rng, symmetric=i > 1) for i, x in enumerate(parts)), discrete)
    start = exact(found), gain_of(exact(found), parts[0], parts[1], parts[3], discrete)
    for value, other, scipy_value in zip((p, gain), moved, start):
        size = greatest(value)
        conditioned = greatest(value - other) / OFF * UNIT
        scipy_error = greatest(value - scipy_value)
        tolerance = ALLOWANCE * max(conditioned, size * UNIT) + 2 * scipy_error
        if tolerance > USELESS * size and size > 0:
            raise Unsolved("too badly conditioned")
        tolerances.append(float(tolerance) if size > 0 else ALLOWANCE * UNIT)
    return {
        "id": f"regulator_{number}",
        "kind": ("discrete " if discrete else "continuous ") + " ".join(names),
        "discrete": discrete,
        "states": d,
        "inputs": u,
        **{name: words(x) for name, x in zip("abqr", parts)},
        "cost": words(p),
        "gain": words(gain),
        "tolerances": {"cost": repr(tolerances[0]), "gain": repr(tolerances[1])},
    }


def off(x, rng, symmetric):
    """Each entry off by `OFF`; the opposite ones of a weight alike."""
    moved = x.copy()
    for i in range(x.rows):
        for j in range(x.cols):
            if not symmetric or i <= j:
                moved[i, j] = x[i, j] * (1 + OFF * rng.choice((-1, 1)))
                if symmetric:
                    moved[j, i] = moved[i, j]
    return moved


def greatest(x):
    return max(abs(y) for y in x)


def words(x):
    return " ".join(repr(float(x[i, j])) for i in range(x.rows) for j in range(x.cols))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=48)
    parser.add_argument("--file", type=Path, required=True)
    given = parser.parse_args()
    mp.prec = BITS
    problems, left_out, number = [], {}, 0
    while len(problems) < given.count:
        rng = random.Random(f"regulators/{given.seed}/{number}")
        try:
            problems.append(problem(rng, f"{given.seed}_{number}"))
        except (Unsolved, ZeroDivisionError) as error:
            left_out[str(error)[:60]] = left_out.get(str(error)[:60], 0) + 1
        number += 1
    command = f"regulators.py --seed {given.seed} --count {given.count}"
    document = {"provenance": {"command": command, "scipy": scipy.__version__, "left out": left_out}, "regulators": problems}
    given.file.write_text(json.dumps(document, indent=0) + "\n")
    print(f"{len(problems)} problems; left out: {left_out}", file=sys.stderr)


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    main()
