"""The motion of a snakeboard whose rotor and wheels are driven by torques, with 24 digits.

Written by `python3 snakeboard.py > snakeboard.json`, with SymPy and mpmath. M and f are derived by SymPy from
L = ½ m (ẋ² + ẏ²) + ½ J θ̇² + ½ J_r (θ̇ + ψ̇)² + ½ J_w ((θ̇ + φ̇_b)² + (θ̇ + φ̇_f)²) (A. D. Lewis, J. P. Ostrowski,
R. M. Murray & J. W. Burdick, Nonholonomic mechanics and locomotion: the snakeboard example, ICRA 1994), q̈ and λ are
solved for with M q̈ − f = Aᵀ λ and A q̈ + Ȧ q̇ = 0, and the steps are taken by the extrapolated midpoint rule with 45 digits. The same
with shorter steps agrees in 24 digits.
"""

import json

import mpmath as mp
import sympy as sp

mp.mp.dps = 45
NAMES = ["x", "y", "theta", "psi", "back", "front"]
PARAMETERS = {"m": "2.5", "j": "0.06", "jr": "0.02", "jw": "0.004", "l": "0.25", "k": "0.3", "torque": "0.15", "w": "2.75"}
START = {"q": ["0", "0", "0.2", "0", "0.5", "-0.4"], "qd": ["0.6", "0", "0", "1.5", "0.3", "-0.2"]}
TIMES = ["0", "0.25", "0.5", "1", "2"]


def equations():
    """M, f, A and Ȧ q̇ as functions of t, q and q̇."""
    t = sp.Symbol("t")
    p = {name: sp.Symbol(name) for name in PARAMETERS}
    functions = [sp.Function(name)(t) for name in NAMES]
    x, y, theta, psi, back, front = functions
    rates = [f.diff(t) for f in functions]
    wheels = p["jw"] * ((theta + back).diff(t) ** 2 + (theta + front).diff(t) ** 2)
    energy = p["m"] * (x.diff(t) ** 2 + y.diff(t) ** 2) + p["j"] * theta.diff(t) ** 2 + p["jr"] * (theta + psi).diff(t) ** 2 + wheels
    lagrangian = energy / 2 - p["k"] * (back**2 + front**2) / 2
    forces = [0, 0, 0, p["torque"] * sp.cos(p["w"] * t), 0, 0]
    q, v, a = ([sp.Symbol(f"{kind}{i}") for i in range(6)] for kind in "qva")
    plain = {f.diff(t, 2): s for f, s in zip(functions, a)}
    plain |= {f: s for f, s in zip(rates, v)} | {f: s for f, s in zip(functions, q)}

    def value(expression):
        for kind in (2, 1, 0):
            chosen = {k: s for k, s in plain.items() if (k.derivative_count if k.is_Derivative else 0) == kind}
            expression = expression.subs(chosen)
        return expression

    balances = [value(lagrangian.diff(r).diff(t) - lagrangian.diff(f)) - force for f, r, force in zip(functions, rates, forces)]
    mass = sp.Matrix(balances).jacobian(a)
    forcing = -sp.Matrix(balances).subs({s: 0 for s in a})
    slips = [
        -sp.sin(theta + back) * x.diff(t) + sp.cos(theta + back) * y.diff(t) - p["l"] * sp.cos(back) * theta.diff(t),
        -sp.sin(theta + front) * x.diff(t) + sp.cos(theta + front) * y.diff(t) + p["l"] * sp.cos(front) * theta.diff(t),
    ]
    rows = sp.Matrix([value(slip) for slip in slips]).jacobian(v)
    drift = sp.Matrix([value(slip.diff(t)) for slip in slips]).subs({s: 0 for s in a})
    numbers = {p[name]: sp.Rational(*float(text).as_integer_ratio()) for name, text in PARAMETERS.items()}
    matrices = [matrix.subs(numbers) for matrix in (mass, forcing, rows, drift)]
    return sp.lambdify([t, *q, *v], matrices, "mpmath")


SYSTEM = equations()


def solved(t, state):
    """q̈ and λ."""
    mass, forcing, rows, drift = SYSTEM(t, *state)
    matrix, right = mp.zeros(8), mp.zeros(8, 1)
    for i in range(6):
        right[i] = forcing[i]
        for j in range(6):
            matrix[i, j] = mass[i, j]
        for j in range(2):
            matrix[i, 6 + j], matrix[6 + j, i] = -rows[j, i], rows[j, i]
    for j in range(2):
        right[6 + j] = -drift[j]
    solution = list(mp.lu_solve(matrix, right))
    return solution[:6], solution[6:]


def rate(t, state):
    return [*state[6:], *solved(t, state)[0]]


def step(t, state, h, order):
    """Gragg's extrapolation of the midpoint rule, without smoothing."""
    table = []
    for row in range(1, order // 2 + 1):
        count = 2 * row
        part = h / count
        before, now = state, [x + part * r for x, r in zip(state, rate(t, state))]
        for i in range(1, count):
            slope = rate(t + i * part, now)
            before, now = now, [x + 2 * part * r for x, r in zip(before, slope)]
        line = [now]
        for back in range(1, row):
            ratio = (mp.mpf(row) / (row - back)) ** 2 - 1
            line.append([x + (x - y) / ratio for x, y in zip(line[-1], table[-1][back - 1])])
        table.append(line)
    return table[-1][-1]


def motion(steps, order):
    """The states at the times."""
    numbers = {key: [mp.mpf(float(x)) for x in START[key]] for key in START}
    numbers["qd"] = consistent(numbers["q"], numbers["qd"])
    state = numbers["q"] + numbers["qd"]
    states, t = [state], mp.mpf(0)
    for end in TIMES[1:]:
        count = max(1, int(mp.ceil((mp.mpf(end) - t) * steps)))
        h = (mp.mpf(end) - t) / count
        for i in range(count):
            state = step(t + i * h, state, h, order)
        t = mp.mpf(end)
        states.append(state)
    return states


def consistent(q, v):
    """The velocities whose ẏ and θ̇ follow from the others."""
    rows = SYSTEM(mp.mpf(0), *q, *v)[2]
    free = [0, 3, 4, 5]
    right = mp.matrix([-sum(rows[j, i] * v[i] for i in free) for j in range(2)])
    found = mp.lu_solve(mp.matrix([[rows[j, 1], rows[j, 2]] for j in range(2)]), right)
    return [v[0], found[0], found[1], *v[3:]]


def main():
    states, others = motion(24, 30), motion(31, 30)
    difference = max(abs(x - y) for state, other in zip(states, others) for x, y in zip(state, other))
    assert difference < mp.mpf(10) ** -24, difference
    text = lambda values: [mp.nstr(x, 24) for x in values]
    samples = []
    for t, state in zip(TIMES, states):
        accelerations, multipliers = solved(mp.mpf(t), state)
        sample = {"t": t, "q": text(state[:6]), "qd": text(state[6:]), "qdd": text(accelerations), "lambda": text(multipliers)}
        samples.append(sample)
    print(json.dumps({"params": PARAMETERS, "coords": NAMES, "samples": samples}, indent=1))


main()
