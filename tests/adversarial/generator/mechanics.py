"""Lagrange's equations d/dt (∂L/∂q̇) − ∂L/∂q = Q + Gᵀ λ of a model, numerically, at one point."""

from arrays import added, depth, entrywise, flat
from constraints import Constraints, derivative, environments
from derivatives import Jet, level
from evaluation import Evaluator, Point


class Equations:
    """L, T, V, p, the energy function h, M, f, Q, q̈ and λ of a model at t, q, v under the fields' values."""

    def __init__(self, model, t, q, v, fields):
        n = len(q)
        self.n, self.v = n, v
        variable = lambda x, i: Jet(x, {i: 1}, {}, n)
        point = Point(
            variable(t, 2 * n),
            [variable(x, n + i) for i, x in enumerate(q)],
            [variable(x, i) for i, x in enumerate(v)],
            fields,
        )
        of = Evaluator(model, point)
        if model.lagrangian is None:
            self.kinetic = added(of(e) for e in model.all_kinetic())
            self.potential = added(of(e) for e in model.all_potential())
            lagrangian = self.kinetic - self.potential
        else:
            lagrangian = of(model.lagrangian)
        first = lambda i: lagrangian.first.get(i, 0)
        second = lambda i, j: lagrangian.second.get((min(i, j), max(i, j)), 0)
        self.L = lagrangian.a
        self.p = [first(i) for i in range(n)]
        self.h = added(p * x for p, x in zip(self.p, v)) - self.L
        self.M = [[second(i, j) for j in range(n)] for i in range(n)]
        self.Q = [x + y for x, y in zip(self.declared_forces(model, of), self.dissipated(model, of))]
        self.f = [
            first(n + i) - second(i, 2 * n) - added(second(i, n + j) * v[j] for j in range(n)) + self.Q[i]
            for i in range(n)
        ]
        self.explicit = first(2 * n)
        self.constraints = Constraints(model, of, v)
        self.a, self.multipliers = self.constraints.solved(self.M, self.f)

    def reactions(self):
        return self.constraints.reactions(self.multipliers)

    def energy_rate(self):
        """dh/dt = Q·q̇ − ∂L/∂t − λᵀ a, where the constraints hold."""
        power = added(x * y for x, y in zip(self.Q, self.v))
        return power - self.explicit - added(x * a for x, a in zip(self.multipliers, self.constraints.rests))

    def dissipated(self, model, of):
        total = added(of(e) for e in model.dissipation)
        return [-derivative(total, i) for i in range(self.n)]

    def declared_forces(self, model, of):
        """Q = F on a coordinate, F·∂p/∂q on a position, F·∂w/∂q̇ on a velocity: w is one if any component of it
        depends on q̇."""
        forces = [0] * self.n
        for row in model.forces:
            for env in environments(row.ranges):
                force = flat(value_of(of(row.expression, 0, env)))
                at = tuple(i if isinstance(i, int) else env[i[0]] + i[1] for i in row.indices)
                place = of.places.get((row.target, at[0] if at else None))
                if place is not None:
                    forces[place] = forces[place] + force[0]
                    continue
                moved = flat(of.definition(row.target, at, 0))
                is_velocity = any(i < self.n for x in moved if level(x) == Jet.level for i in x.first)
                offset = 0 if is_velocity else self.n
                for i in range(self.n):
                    work = added(f * derivative(x, offset + i) for f, x in zip(force, moved, strict=True))
                    forces[i] = forces[i] + work
        return forces

    def inverse_dynamics(self, a):
        return [added(m * x for m, x in zip(row, a)) - f for row, f in zip(self.M, self.f)]


def value_of(x):
    """Without derivatives by coordinates, velocities and time."""
    return entrywise(lambda y: y.a if level(y) == Jet.level else y, x)


def outputs(model, t, q, v, fields, e):
    """The outputs where these equations hold, each a list of numbers row by row, and its shape (rows, columns) if it is no scalar."""
    of = Evaluator(model, Point(t, q, v, fields, e.a, e.reactions()))
    found = {}
    for row in model.outputs:
        x = of(row.expression)
        shape = {0: [], 1: [len(x) if depth(x) else 0], 2: [len(x), len(x[0])] if depth(x) == 2 else []}[depth(x)]
        found[row.target] = (flat(x), shape)
    return found
