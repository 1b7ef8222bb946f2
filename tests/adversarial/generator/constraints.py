"""Constraints numerically: w = G q̇ + a = 0, and for the accelerations G q̈ + γ = 0, so that with M q̈ = f + Gᵀ λ

    M q̈ − Gᵀ λ = f,    −G q̈ = γ.

A holonomic constraint g = 0 stands here for w = ġ, the slope of g along the motion; γ = (∂w/∂q) q̇ + ∂w/∂t of either kind comes of the
derivatives of w.
"""

from mpmath import mp, mpf

from arrays import added, entrywise, flat, solve, transpose
from derivatives import Jet, NoValue, level
from evaluation import Evaluator, Point
from tree import dot

ITERATIONS = 30  # Of Newton's method, to a consistent state.
CONVERGED = 1e-25
SWEEPS = 30  # Of equilibration: entries of rows and columns differ by less than a percent then.


def environments(ranges):
    if not ranges:
        return [{}]
    variable, low, high = ranges[0]
    return [{variable: i, **rest} for i in range(low, high) for rest in environments(ranges[1:])]


class Constraints:
    """g, w, G, a and γ by components, those of holonomic constraints first. `of` evaluates on jets by q̇, q and t."""

    def __init__(self, model, of, v):
        self.n, self.v = len(v), v
        self.shapes, self.positions, self.velocities = {}, [], []
        for row in model.constraints:
            for at, env in members(row):
                value = of(row.expression, 0, env)
                self.positions += [bare(x) for x in flat(value)]
                self.add(row.target, at, of.of_dot(dot(row.expression), 0, env))
        for row in model.nonholonomic:
            for at, env in members(row):
                self.add(row.target, at, of(row.expression, 0, env))
        self.positions += [0 * x for x in v[:1]] * (len(self.velocities) - len(self.positions))
        columns = range(self.n)
        self.jacobian = [[derivative(w, i) for i in columns] for w in self.velocities]
        self.rates = [added(derivative(w, self.n + i) * v[i] for i in columns) + derivative(w, 2 * self.n) for w in self.velocities]
        self.rests = [bare(w) - added(g * x for g, x in zip(row, v)) for w, row in zip(self.velocities, self.jacobian)]

    def add(self, name, at, value):
        first = len(self.velocities)
        places = iter(range(first, first + len(flat(value))))
        self.shapes[name, at] = entrywise(lambda _: next(places), value)
        self.velocities += flat(value)

    def __len__(self):
        return len(self.velocities)

    def solved(self, mass, forcing):
        """q̈ and λ."""
        right = [*forcing, *self.rates]
        x = solve(self.matrix(mass), right)
        return x[: self.n], x[self.n :]

    def matrix(self, mass):
        upper = [[*row, *(-g[i] for g in self.jacobian)] for i, row in enumerate(mass)]
        return upper + [[*(-x for x in row), *[0] * len(self)] for row in self.jacobian]

    def reactions(self, multipliers):
        """λ by the names and indices of constraints, each in the shape of its constraint."""
        return {key: entrywise(lambda i: multipliers[i], places) for key, places in self.shapes.items()}


def members(row):
    """The indices of the members of a row, with the values of its variables."""
    for env in environments(row.ranges):
        yield tuple(i if isinstance(i, int) else env[i[0]] + i[1] for i in row.indices), env


def derivative(x, i):
    return x.first.get(i, 0) if level(x) == Jet.level else 0


def bare(x):
    return x.a if level(x) == Jet.level else x


def at_state(model, t, q, v, fields):
    """The constraints alone at a state."""
    n = len(q)
    variable = lambda x, i: Jet(x, {i: 1}, {}, 0)
    places = [variable(x, n + i) for i, x in enumerate(q)]
    rates = [variable(x, i) for i, x in enumerate(v)]
    return Constraints(model, Evaluator(model, Point(variable(t, 2 * n), places, rates, fields)), v)


def least(rows, residuals):
    """The smallest change x with rows x = −residuals."""
    square = [[added(a * b for a, b in zip(x, y)) for y in rows] for x in rows]
    factors = solve(square, residuals)
    return [-added(row[i] * y for row, y in zip(rows, factors)) for i in range(len(rows[0]))]


def consistent(model, at):
    """Coordinates and velocities on the constraints near those of a state with numbers of many digits, by Newton's method."""
    q, v = list(at.q), list(at.v)
    holonomic = lambda found: len(found) - nonholonomic_count(model, found)
    for _ in range(ITERATIONS):
        found = at_state(model, at.t, q, v, at.fields)
        count = holonomic(found)
        if count == 0 or max(abs(g) for g in found.positions[:count]) < CONVERGED:
            break
        q = [x + d for x, d in zip(q, least(found.jacobian[:count], found.positions[:count]))]
        if max(abs(x) for x in q) > 10:
            raise NoValue("too far away")
    else:
        raise NoValue("no consistent state")
    change = least(found.jacobian, [bare(w) for w in found.velocities])
    v = [x + d for x, d in zip(v, change)]
    if max(abs(x) for x in v) > 20:
        raise NoValue("too fast")
    return q, v


def nonholonomic_count(model, found):
    names = {row.target for row in model.nonholonomic}
    return added(len(flat(places)) for (name, _), places in found.shapes.items() if name in names)


def equilibrated(matrix):
    """D such that all rows and columns of D A D have greatest entries near 1 (D. Ruiz, A scaling algorithm to equilibrate both rows and
    columns norms in matrices, RAL-TR-2001-034), and the condition number of D A D by its singular values."""
    size = range(len(matrix))
    scaled, scales = [[mpf(x) for x in row] for row in matrix], [mpf(1) for _ in size]
    for _ in range(SWEEPS):
        over = [1 / mp.sqrt(max(abs(x) for x in row)) for row in scaled]
        scaled = [[scaled[i][j] * over[i] * over[j] for j in size] for i in size]
        scales = [x * y for x, y in zip(scales, over)]
    values = mp.svd_r(mp.matrix(scaled), compute_uv=False)
    return [float(x) for x in scales], float(max(values) / min(values))
