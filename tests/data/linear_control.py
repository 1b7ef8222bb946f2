"""Reference values of linear control by SciPy and python-control.

    pip install numpy scipy control
    python linear_control.py > linear_control.json
"""
import json
import control
import numpy as np
import scipy.linalg as la

rng = np.random.default_rng(20)


def case(a, b, q, r, period):
    a, b, q, r = (np.asarray(x, float) for x in (a, b, q, r))
    n, m = b.shape
    k, p, _ = control.lqr(a, b, q, r)
    plant = control.ss(a, b, np.eye(n), np.zeros((n, m)))
    held = control.sample_system(plant, period, method="zoh")
    kd, pd, _ = control.dlqr(held.A, held.B, q * period, r * period)
    key = lambda x: (abs(x), x.real, -x.imag)
    pairs = lambda x: [[v.real, v.imag] for v in sorted(x, key=key)]
    return {
        "a": a.tolist(), "b": b.tolist(), "q": q.tolist(), "r": r.tolist(), "period": period,
        "gain": k.tolist(), "cost": p.tolist(),
        "poles": pairs(la.eigvals(a - b @ k)), "open_poles": pairs(la.eigvals(a)),
        "held_a": held.A.tolist(), "held_b": held.B.tolist(),
        "held_gain": kd.tolist(), "held_cost": pd.tolist(),
        "rank": int(np.linalg.matrix_rank(control.ctrb(a, b))),
    }


def random():
    a = rng.normal(size=(4, 4))
    b = rng.normal(size=(4, 2))
    s = rng.normal(size=(4, 4))
    return case(a, b, s @ s.T, np.diag([0.5, 2.0]), 0.05)


m, pole, l, g = 1.0, 0.2, 0.5, 9.81
cart = [[0, 0, 1, 0], [0, 0, 0, 1], [0, -pole * g / m, 0, 0], [0, (m + pole) * g / (m * l), 0, 0]]
push = [[0, 0], [0, 0], [1 / m, 0], [-1 / (m * l), 1e-3]]
cases = [case(cart, push, np.diag([10, 1, 1, 1]), np.diag([0.1, 1]), 0.02)]
cases += [random() for _ in range(6)]
# Stiff: eigenvalues from 1e-3 to 1e3.
basis = la.orth(rng.normal(size=(4, 4)))
stiff = basis @ np.diag([1e-3, -1.0, 30.0, -1e3]) @ basis.T
cases.append(case(stiff, rng.normal(size=(4, 2)), np.eye(4), np.eye(2), 1e-3))
print("[\n" + ",\n".join(json.dumps(case) for case in cases) + "\n]")
