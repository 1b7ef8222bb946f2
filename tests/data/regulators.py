"""Reference values of linear-quadratic regulators of badly scaled problems, of which SciPy solves all but few.

    pip install numpy scipy mpmath
    python regulators.py > regulators.json

Gains are those of the stable invariant subspace of the Hamiltonian or symplectic matrix, with 80 digits; SciPy's have an error
of up to 1e-3, which is in `scipy_error`: null where it fails.
"""
import json
import sys
import warnings

import numpy as np
import scipy.linalg as la
from mpmath import eig, inverse, matrix, mp, norm

mp.dps = 80

warnings.simplefilter("ignore")
rng = np.random.default_rng(int(sys.argv[1]) if len(sys.argv) > 1 else 28)
PER_KIND = int(sys.argv[2]) if len(sys.argv) > 2 else 1


def system(kind, discrete):
    a, b, s = rng.normal(size=(4, 4)), rng.normal(size=(4, 2)), rng.normal(size=(4, 4))
    q, r = s @ s.T, np.eye(2)
    name, size = kind
    if name == "no cost":
        q = np.zeros((4, 4))
        # Unstable and stable modes, and all stable ones.
        a = a - size * np.eye(4) if not discrete else a * (0.2 if size else 1.0)
    elif name == "little cost":
        q = q * size
    elif name == "weights of inputs":
        r = np.diag([1 / size, size])
    elif name == "rates":
        a = a * size
    elif name == "weights of states":
        q = np.diag([size, 1.0, 1 / size, 0.0])
    elif name == "stiff":
        # Two masses, a stiff spring and a soft one, with little damping.
        d = 1e-3 * np.sqrt(size)
        a = np.array([[0, 0, 1, 0], [0, 0, 0, 1], [-size - 1, 1, -d, 0], [1, -1, 0, 0.1]])
        b = np.array([[0, 0], [0, 0], [1.0, 0], [0, 1.0]])
        q = np.eye(4)
        if discrete:
            h = 0.1 / np.sqrt(size) if size < 1e6 else 1e-3
            whole = la.expm(np.block([[a, b], [np.zeros((2, 6))]]) * h)
            a, b = whole[:4, :4], whole[:4, 4:]
    elif name == "unit of a state":
        unit = np.diag([size, 1.0, 1 / size, 1.0])
        a, b, q = unit @ a @ la.inv(unit), unit @ b, la.inv(unit) @ q @ la.inv(unit)
    return a, b, q, r


KINDS = (
    [("no cost", x) for x in (0.0, 8.0)]
    + [("little cost", x) for x in (1e-6, 1e-12)]
    + [("weights of inputs", x) for x in (1e4, 1e6, 1e8)]
    + [("rates", x) for x in (1e3, 1e6, 1e-6)]
    + [("weights of states", x) for x in (1e3, 1e6)]
    + [("stiff", x) for x in (1e4, 1e10, 1e12)]
    + [("unit of a state", x) for x in (1e3, 1e5)]
)


def exact_gain(a, b, q, r, discrete):
    a, b, q, r = (matrix(x.tolist()) for x in (a, b, q, r))
    n = a.rows
    g = b * inverse(r) * b.T
    if discrete:
        z = inverse(a).T
        blocks = [[a + g * z * q, -g * z], [-z * q, z]]
    else:
        blocks = [[a, -g], [-q, -a.T]]
    whole = matrix(2 * n)
    for i in range(2 * n):
        for j in range(2 * n):
            whole[i, j] = blocks[i // n][j // n][i % n, j % n]
    values, vectors = eig(whole)
    stable = [k for k in range(2 * n) if (abs(values[k]) < 1 if discrete else values[k].real < 0)]
    assert len(stable) == n
    upper, lower = matrix(n), matrix(n)
    for column, k in enumerate(stable):
        for i in range(n):
            upper[i, column], lower[i, column] = vectors[i, k], vectors[n + i, k]
    p = (lower * inverse(upper)).apply(lambda x: x.real)
    return inverse(r + b.T * p * b) * (b.T * p * a) if discrete else inverse(r) * b.T * p


def case(kind, discrete):
    a, b, q, r = system(kind, discrete)
    try:
        solve = la.solve_discrete_are if discrete else la.solve_continuous_are
        p = solve(a, b, q, r)
        k = la.solve(r + b.T @ p @ b, b.T @ p @ a) if discrete else la.solve(r, b.T @ p)
        poles = la.eigvals(a - b @ k)
        if (np.abs(poles) >= 1).any() if discrete else (poles.real >= 0).any():
            raise la.LinAlgError("not stable")
        exact = exact_gain(a, b, q, r, discrete)
        error = float(norm(matrix(k.tolist()) - exact) / max(norm(exact), mp.mpf(1e-30)))
    except (la.LinAlgError, ValueError):
        exact, error = exact_gain(a, b, q, r, discrete), None
    return {
        "kind": kind[0], "size": kind[1], "discrete": discrete,
        "a": a.tolist(), "b": b.tolist(), "q": q.tolist(), "r": r.tolist(),
        "gain": [[float(exact[i, j]) for j in range(4)] for i in range(2)], "scipy_error": error,
    }


cases = [case(kind, discrete) for kind in KINDS for discrete in (False, True) for _ in range(PER_KIND)]
print("[\n" + ",\n".join(json.dumps(case) for case in cases) + "\n]")
