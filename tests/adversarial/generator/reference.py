"""Reference values of a model at some states, and tolerances for them.

Values are computed in 240 bits; derivatives of q̈ by differences with steps of 2⁻¹⁰⁰, whose errors are of that size.

The tolerance of a quantity is what evaluating the same tree in binary64 loses where every input is off by one unit in
the last place and every operation is rounded at random (`rounding.py`): the greatest of `SAMPLES` evaluations (CESTAC:
J. Vignes, A stochastic arithmetic for reliable scientific computation, Math. Comput. Simul. 35, 1993), but at least one
unit of the greatest entry, or of 1, since terms of that size are what a zero is made of; for q̈ and its derivatives such
terms stand in f. For q̈ it is also Skeel's bound |M⁻¹| (|M| |q̈| + |f|) (R. D. Skeel, Scaling for numerical stability in
Gaussian elimination, J. ACM 26, 1979). `ALLOWANCE` is for algorithms that take another way through the same numbers,
and for samples that are all small by chance.
"""

import copy
import math
import random

from mpmath import mp, mpf

import arrays
from arrays import added, flat, solve
import reduction
from derivatives import GREATEST, PRECISE, Dual, NoValue, level
from constraints import consistent, equilibrated
from mechanics import Equations, outputs
from rounding import DEVIATION, SCALE, UNIT, Rounded, Wide

BITS = 240
STEP = 2.0**-100
SAMPLES = 4
ALLOWANCE = 32
RECONSTRUCTION = 1e-8  # Relative errors of two integrations, each of which has 1e-11.
USELESS = 1e-5  # A tolerance so great, relative to the quantity, tests nothing.

mp.prec = BITS


class Inputs:
    """A state with the values of all fields: what everything is a function of."""

    def __init__(self, t, q, v, fields):
        self.t, self.q, self.v, self.fields = t, q, v, fields

    def mapped(self, change):
        fields = {name: deep(change, x) for name, x in self.fields.items()}
        return Inputs(change(self.t), [change(x) for x in self.q], [change(x) for x in self.v], fields)

    def with_change(self, kind, i, change):
        """One of the inputs changed: `kind` is "q", "v", "t", or the `Field`, of which component i."""
        q, v, fields = list(self.q), list(self.v), dict(self.fields)
        if kind == "t":
            return Inputs(change(self.t), q, v, fields)
        if kind in ("q", "v"):
            column = {"q": q, "v": v}[kind]
            column[i] = change(column[i])
            return Inputs(self.t, q, v, fields)
        fields[kind.name] = at_component(fields[kind.name], i, change)
        return Inputs(self.t, q, v, fields)


def deep(change, x):
    return [deep(change, y) for y in x] if isinstance(x, list) else change(x)


def at_component(x, i, change):
    if not isinstance(x, list):
        return change(x)
    return [change(y) if k == i else y for k, y in enumerate(x)]


def directions(model, n):
    """The columns of the linearization: by q, by v, by t, by inputs in the order of their fields."""
    if not model.is_constrained():
        yield from (("dqdd_dq", "q", i) for i in range(n))
        yield from (("dqdd_dqd", "v", i) for i in range(n))
        yield "dqdd_dt", "t", 0
    for f in model.fields:
        if f.input:
            yield from (("dqdd_du", f, i) for i in range(f.size()))


def equations(model, at):
    return Equations(model, at.t, at.q, at.v, at.fields)


def quantities(model, at, trial, slope, linearize=True):
    """All quantities by name, each a list of numbers row by row, and the shapes of outputs."""
    e = equations(model, at)
    found = {
        "L": [e.L],
        "h": [e.h],
        "p": e.p,
        "M": flat(e.M),
        "f": e.f,
        "Q": e.Q,
        "qdd": e.a,
        "inverse": e.inverse_dynamics(trial),
    }
    if model.lagrangian is None:
        found.update(T=[bare(e.kinetic)], V=[bare(e.potential)])
    columns = {}
    for name, kind, i in directions(model, len(at.q)) if linearize else ():
        columns.setdefault(name, []).append(slope(model, at, kind, i, e.a))
    found.update((name, flat(arrays.transpose(c))) for name, c in columns.items())
    shapes = {}
    if model.is_constrained():
        c = e.constraints
        found.update({"lambda": e.multipliers, "g": c.positions, "w": [bare(w) for w in c.velocities], "G": flat(c.jacobian), "gamma": c.rates})
    if model.energy_balance:
        found["energy_rate"] = [e.energy_rate()]
    for name, (x, shape) in outputs(model, at.t, at.q, at.v, at.fields, e).items():
        found["output " + name] = x
        shapes[name] = shape
    return found, shapes, e


def bare(x):
    return x.a if level(x) >= 0 else x


def by_differences(model, at, kind, i, base):
    step = mpf(STEP)
    moved = equations(model, at.with_change(kind, i, lambda x: x + step)).a
    return [(x - y) / step for x, y in zip(moved, base)]


def by_duals(model, at, kind, i, _):
    """The same without differences: once more differentiated forward."""
    moved = equations(model, at.with_change(kind, i, lambda x: Dual(x, 1, 0))).a
    return [x.b if level(x) == 0 else 0 for x in moved]


def rounded_at_random(model, at, trial, rng):
    """The quantities, with `SCALE` times the errors of binary64 in inputs and operations."""
    number = Wide if model.wide else Rounded
    off = lambda x: number(x * (1 + rng.choice((-1, 1)) * 2 * DEVIATION))
    PRECISE[0], Rounded.rng = False, rng
    try:
        found, _, _ = quantities(model, at.mapped(off), [float(x) for x in trial], by_duals)
    finally:
        PRECISE[0] = True
    return {name: [float(x) for x in value] for name, value in found.items()}


def of_solution(e):
    """Skeel's bound |A⁻¹| (|A| |x| + |b|) of A x = b, its greatest entry for q̈ and for λ, and those of |A⁻¹| times terms of the size
    of 1. A is M, or the matrix of q̈ and λ."""
    matrix, x, right = e.constraints.matrix(e.M), [*e.a, *e.multipliers], [*e.f, *e.constraints.rates]
    n = len(x)
    columns = [solve(matrix, [mpf(i == j) for i in range(n)]) for j in range(n)]
    load = [added(abs(m * y) for m, y in zip(row, x)) + abs(b) for row, b in zip(matrix, right)]
    entries = lambda load: [added(abs(columns[j][i]) * load[j] for j in range(n)) for i in range(n)]
    parts = slice(len(e.a)), slice(len(e.a), n)
    greatest = lambda load: [float(max(entries(load)[part], default=0)) for part in parts]
    return greatest(load), greatest([1] * n)


def reference(model, at, rng):
    """Values and tolerances at a state with binary64 inputs; `NoValue` where it is of no use."""
    GREATEST[0] = mpf(10) ** 9000 if model.wide else 1e150
    exact = at.mapped(mpf)
    trial = [round(rng.uniform(-3, 3), 3) for _ in at.q]
    values, shapes, e = quantities(model, exact, [mpf(x) for x in trial], by_differences)
    samples = [rounded_at_random(model, at, trial, rng) for _ in range(SAMPLES)]
    bound, inverse = of_solution(e)
    tolerances = {}
    for name, value in values.items():
        if not all(math.isfinite(float(x)) and abs(x) < 1e100 for x in value):
            raise NoValue("no number")
        size = max((abs(float(x)) for x in value), default=0.0)
        noise = max(max_difference(sample[name], value) for sample in samples) / SCALE
        if name in ("qdd", "lambda"):
            noise = max(noise, UNIT * bound[name == "lambda"])
        if "qdd" in name or name == "lambda":
            noise = max(noise, UNIT * inverse[name == "lambda"])
        if not noise <= USELESS * max(size, 1.0):
            raise NoValue("too badly conditioned")
        tolerances[name] = ALLOWANCE * max(noise, UNIT * max(size, 1.0))
    conditioning = {}
    if model.is_constrained():
        scales, condition = equilibrated(e.constraints.matrix(e.M))
        conditioning = {"scales": scales, "condition": condition}
        allow_for_condition(e, scales, condition, tolerances)
        allow_for_solution(model, exact, e, values, tolerances, rng)
    if model.ignorable:
        add_reduced(model, exact, values, tolerances, rng)
    return {
        "t": at.t,
        "q": at.q,
        "qd": at.v,
        "params": [x for f in model.fields for x in flat(at.fields[f.name])],
        "trial": trial,
        **conditioning,
        "values": {name: [float(x) for x in value] for name, value in values.items()},
        "tolerances": tolerances,
    }, shapes


def allow_for_condition(e, scales, condition, tolerances):
    """q̈ and λ may be off by 10⁻¹⁵ times the number n of unknowns and the condition number of D A D, relative to the greatest of D⁻¹ x."""
    x, n = [*e.a, *e.multipliers], len(e.a)
    bound = 1e-15 * len(x) * condition * max(float(abs(y)) / d for y, d in zip(x, scales))
    for name, part in (("qdd", slice(n)), ("lambda", slice(n, None))):
        tolerances[name] = max(tolerances[name], bound * max(scales[part]))
        if not tolerances[name] <= ALLOWANCE * USELESS * max(1.0, *(abs(float(y)) for y in x[part])):
            raise NoValue("too badly conditioned")


def allow_for_solution(model, at, e, values, tolerances, rng):
    """Outputs, and the rate of the energy, may be off by what q̈ and λ make of them that are off by their tolerances: where λ is zero
    by the structure of the equations, elimination with pivoting finds it without an error, which others do not."""
    off = lambda x, name: x + rng.choice((-1, 1)) * mpf(tolerances[name])
    for _ in range(SAMPLES):
        moved = copy.copy(e)
        moved.a = [off(x, "qdd") for x in e.a]
        moved.multipliers = [off(x, "lambda") for x in e.multipliers]
        found = {"output " + name: x for name, (x, _) in outputs(model, at.t, at.q, at.v, at.fields, moved).items()}
        if model.energy_balance:
            found["energy_rate"] = [moved.energy_rate()]
        for name, x in found.items():
            tolerances[name] = max(tolerances[name], *(float(abs(a - b)) for a, b in zip(x, values[name])))


def add_reduced(model, exact, values, tolerances, rng):
    """The same of the reduced model. What its accelerations are made of is as large as in the full model, and its terms divide by
    the inertia of the ignorable coordinates once more: tolerances are those of the full model, and what momenta that are off by a
    unit make of it."""
    samples = [reduction.disturbed(model, exact, rng) for _ in range(SAMPLES)]
    found, noise = reduction.references(model, exact, samples, mpf(STEP))
    beside = {"constants": "p", "velocities": "p", "routhian": "L", "potential": "L"}
    worst = max(tolerances[name] for name in ("L", "h", "p", "f"))
    for name, value in found.items():
        size = max((abs(float(x)) for x in value), default=0.0)
        moved = float(noise[name]) / SCALE
        full = name.removeprefix("reduced ")
        own = tolerances.get(beside.get(full, full), 0.0)
        if full in beside or "qdd" in full:
            own = max(own, worst)
        tolerance = max(own, ALLOWANCE * max(moved, UNIT * max(size, 1.0)))
        if not (math.isfinite(size) and tolerance <= USELESS * max(size, 1.0)):
            raise NoValue("too badly conditioned")
        values[name], tolerances[name] = value, tolerance
    values["reconstruction"], tolerances["reconstruction"] = [0.0 for _ in exact.q], RECONSTRUCTION



def max_difference(found, value):
    worst = 0.0
    for a, b in zip(found, value, strict=True):
        difference = abs(float(mpf(a) - b)) if math.isfinite(a) else math.inf
        worst = max(worst, difference)
    return worst


# How values of fields are drawn.


def drawn_field(f, rng, mode):
    one = lambda: drawn_value(f, rng, mode)
    return one() if f.family is None else [one() for _ in range(f.family)]


def drawn_value(f, rng, mode):
    if f.draw == "inertia":
        return inertia(rng, mode, f.shape[0])
    if f.body is not None:
        return drawn_body(f.body, rng, mode)
    number = lambda: drawn_number(f.draw, rng, mode)
    if f.shape == ():
        return number()
    if len(f.shape) == 1:
        return [number() for _ in range(f.shape[0])]
    return [[number() for _ in range(f.shape[1])] for _ in range(f.shape[0])]


def drawn_body(kind, rng, mode):
    """The numbers of a body, in the order in which its `map` visits them; whether a real body can have them does not matter."""
    number = lambda draw: drawn_number(draw, rng, mode)
    moments = lambda n: [number("positive") + (0 if mode == "negative" else 1) for _ in range(n)]
    if kind == "PrincipalBody":
        return [number("positive"), *moments(3)]
    if kind == "SymmetricBody":
        return [number("positive"), number("unit"), *moments(2)]
    products = [0.3 * number("unit") for _ in range(3)]
    return [number("positive"), *(number("unit") for _ in range(3)), *moments(3), *products]


def drawn_number(draw, rng, mode):
    low, high = {"any": (-2.5, 2.5), "positive": (0.4, 2.8), "rate": (-1.5, 1.5), "unit": (-0.9, 0.9)}[draw]
    x = round(rng.uniform(low, high), rng.choice((1, 2, 17))) or 0.5
    if mode == "zero" and draw != "positive" and rng.random() < 0.5:
        return 0.0
    if mode == "equal":
        return {"any": 1.5, "positive": 1.5, "rate": 0.5, "unit": 0.5}[draw]
    if mode == "negative":
        return -abs(x)
    if mode == "scaled" and rng.random() < 0.5:
        return x * 10.0 ** rng.choice((-7, -4, 4, 7))
    return x


def inertia(rng, mode, n):
    """A positive definite matrix, often not symmetric: only the symmetric part counts."""
    if mode == "equal":
        return [[1.5 if i == j else 0.0 for j in range(n)] for i in range(n)]
    m = [[round(rng.uniform(-0.3, 0.3), 2) for _ in range(n)] for _ in range(n)]
    for i in range(n):
        m[i][i] = round(rng.uniform(1.0, 3.0), 2)
        for j in range(i):
            if mode != "plain":
                m[i][j] = m[j][i]
    sign = -1 if mode == "negative" else 1
    return [[sign * x for x in row] for row in m]


# How values of fields are drawn beside the first state of a model, in which all are plain.
MODES = ["plain", "plain", "equal", "zero", "negative", "scaled"]
TRIES = 40


def drawn_state(model, rng, mode, projects=True):
    fields = {f.name: drawn_field(f, rng, mode) for f in model.fields}
    q = [drawn_coordinate(model.q_draw.get(label[0], (-3.0, 3.0)), rng) for label in model.coordinate_labels()]
    v = [rng.uniform(-2.0, 2.0) for _ in q]
    if rng.random() < 0.1:
        v = [0.0 for _ in q]
    at = Inputs(rng.uniform(-2.0, 2.0), q, v, fields)
    is_consistent = model.is_constrained() and rng.random() < 0.5
    return on_the_constraints(model, at) if is_consistent and projects else at


def on_the_constraints(model, at):
    """A state on the constraints near one, as near as binary64 numbers are."""
    q, v = consistent(model, at.mapped(mpf))
    return Inputs(at.t, [float(x) for x in q], [float(x) for x in v], at.fields)


def drawn_coordinate(draw, rng):
    """Between two numbers, or what a function of the random source gives."""
    return draw(rng) if callable(draw) else rng.uniform(*draw)


def given_state(model, given, rng):
    """A state that the model itself lists."""
    at = drawn_state(model, rng, "plain", projects=False)
    at.fields.update({name: x for name, x in given.items() if name not in ("t", "q", "v")})
    return Inputs(given.get("t", at.t), given["q"], given["v"], at.fields)


def references(model, count, seed):
    """Up to `count` states with their references, besides those that the model lists."""
    rng = random.Random(seed)
    states, shapes = [], {}
    for given in model.states:
        state, shapes = reference(model, given_state(model, given, rng), rng)
        states.append(state)
    modes = ["plain"] + [rng.choice(MODES) for _ in range(count - 1)]
    for mode in modes:
        for attempt in range(TRIES):
            try:
                at = drawn_state(model, rng, mode if attempt < TRIES / 2 else "plain")
                state, shapes = reference(model, at, rng)
            except (NoValue, OverflowError, ZeroDivisionError, ValueError):
                continue
            states.append(state)
            break
    return states, shapes
