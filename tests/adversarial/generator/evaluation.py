"""Evaluates the tree of a declaration on numbers with derivatives.

The total time derivative `dot(e)` is the slope of e along t + τ, q + v τ, v + a τ: a dual number in τ.
"""

import math

from mpmath import mp, mpf

import arrays
import bodies
from derivatives import DECISIONS, PRECISE, Dual, angle, apply, level, power, reciprocal, select
from arrays import entrywise
from tree import angular_velocity, rotation

TIME = 2  # The level of duals in τ; those of second derivatives in time are one above.


class Point:
    """Where expressions are evaluated: t, q, v by place, fields by name, and accelerations and reactions of constraints where they are
    known."""

    def __init__(self, t, q, v, fields, accelerations=None, reactions=None):
        self.t, self.q, self.v, self.fields, self.accelerations = t, q, v, fields, accelerations
        self.reactions = reactions

    def moving(self, order, what, i):
        """t, or a coordinate, as it moves: `order` time derivatives deep."""
        if what == "t":
            rates = [self.t, 1, 0]
        else:
            rates = [self.q[i], self.v[i], None if self.accelerations is None else self.accelerations[i]]
        if order == 0:
            return rates[0]
        if order == 1:
            return Dual(rates[0], rates[1], TIME)
        inner = Dual(rates[0], rates[1], TIME), Dual(rates[1], rates[2], TIME)
        return Dual(*inner, TIME + 1)


class Evaluator:
    def __init__(self, model, point):
        self.model, self.point = model, point
        self.memory = {}
        self.made = {}
        self.places = {}
        for place, (stem, i) in enumerate(model.coordinate_labels()):
            self.places[stem, i] = place
        self.fields = {f.name: f for f in model.fields}

    def __call__(self, e, order=0, env=None):
        env = env or {}
        key = id(e), order, tuple(sorted(env.items()))
        if key not in self.memory:
            # The node is kept, so that no other has its id.
            self.memory[key] = e, getattr(self, "of_" + e.op)(e, order, env)
        return self.memory[key][1]

    def args(self, e, order, env):
        return [self(a, order, env) for a in e.args]

    def of_number(self, e, *_):
        x = e.data
        if x.denominator == 1:
            return int(x)
        return mpf(x.numerator) / x.denominator if PRECISE[0] else x.numerator / x.denominator

    def of_pi(self, *_):
        return +mp.pi if PRECISE[0] else math.pi

    def of_time(self, _, order, env):
        return self.point.moving(order, "t", 0)

    def of_name(self, e, order, env):
        if e.data in env:
            return env[e.data]
        if (e.data, None) in self.places:
            return self.point.moving(order, "q", self.places[e.data, None])
        if e.data in self.fields:
            return self.point.fields[e.data]
        return self.definition(e.data, (), order)

    def of_member(self, e, order, env):
        stem, indices = e.data
        at = tuple(resolve(i, env) for i in indices)
        if len(at) == 1 and (stem, at[0]) in self.places:
            return self.point.moving(order, "q", self.places[stem, at[0]])
        if stem in self.fields:
            return self.point.fields[stem][at[0]]
        return self.definition(stem, at, order)

    def definition(self, stem, at, order):
        for row in self.model.definitions:
            if row.target == stem and len(row.indices) == len(at):
                env = bound(row, at)
                if env is not None:
                    return self(row.expression, order, env)
        raise KeyError(stem)

    def of_family(self, e, order, env):
        size = dict(self.model.coordinates).get(e.data)
        if size is None and e.data in self.fields:
            return self.point.fields[e.data]
        if size is None:
            size = 1 + max(i for row in self.model.definitions if row.target == e.data for i in members(row))
            return [self.definition(e.data, (i,), order) for i in range(size)]
        return [self.point.moving(order, "q", self.places[e.data, i]) for i in range(size)]

    def of_add(self, e, order, env):
        return entrywise(lambda x, y: x + y, *self.args(e, order, env))

    def of_sub(self, e, order, env):
        return entrywise(lambda x, y: x - y, *self.args(e, order, env))

    def of_neg(self, e, order, env):
        return entrywise(lambda x: -x, self(e.args[0], order, env))

    def of_mul(self, e, order, env):
        return arrays.multiply(*self.args(e, order, env))

    def of_div(self, e, order, env):
        x, y = self.args(e, order, env)
        over = exact(y)
        return entrywise(lambda a: a * over, x)

    def of_powi(self, e, order, env):
        x = self(e.args[0], order, env)
        return exact(power(x, -e.data)) if e.data < 0 else power(x, e.data)

    def of_powf(self, e, order, env):
        x, y = self.args(e, order, env)
        return apply("exp", y * apply("ln", x))

    def of_call(self, e, order, env):
        args = self.args(e, order, env)
        for function in self.model.functions:
            if function.name == e.data:
                return self(function.value, order, {"external": e.data, **dict(zip(function.arguments, args))})
        if e.data == "atan2":
            return angle(*args)
        if e.data in ("min", "max"):
            return select(e.data, *args)
        if e.data == "sqrt" and DECISIONS[0] is not None and e.args[0].op == "powi" and e.args[0].data == 2:
            # √(x²) has a corner where x changes its sign, which its own argument does not show.
            return apply("abs", self(e.args[0].args[0], order, env))
        if e.data == "recip":
            return exact(args[0])
        return apply(e.data, args[0])

    def of_number_of_body(self, e, order, env):
        return self(e.args[0], order, env)[e.data]

    def of_quantity_of_body(self, e, order, env):
        return self.of_made(e, order, env, lambda: bodies.quantity(e.args[0], *e.data))

    def of_energy_of_body(self, e, order, env):
        return self.of_made(e, order, env, lambda: bodies.energy(*e.data, *e.args))

    def of_made(self, e, order, env, make):
        """The value of what an expression stands for."""
        if id(e) not in self.made:
            self.made[id(e)] = make()
        return self(self.made[id(e)], order, env)

    def of_dot(self, e, order, env):
        moving = self(e.args[0], order + 1, env)
        return entrywise(lambda x: x.b if level(x) == TIME + order else 0, moving)

    def of_reaction(self, e, order, env):
        name, indices = e.data
        return self.point.reactions[name, tuple(resolve(i, env) for i in indices)]

    def of_array(self, e, order, env):
        return self.args(e, order, env)

    def of_component(self, e, order, env):
        x = self(e.args[0], order, env)
        for i in e.data:
            x = x[i]
        return x

    def of_homogeneous(self, e, order, env):
        r, p = self.args(e, order, env)
        return [[*row, x] for row, x in zip(r, p, strict=True)] + [[0, 0, 0, 1]]

    def of_view(self, e, order, env):
        i, j, rows, columns = e.data
        return [row[j : j + columns] for row in self(e.args[0], order, env)[i : i + rows]]

    def of_column(self, e, order, env):
        return [row[e.data] for row in self(e.args[0], order, env)]

    def of_method(self, e, order, env):
        x, *rest = self.args(e, order, env)
        return arrays.method(e.data, x, rest)

    def terms(self, e, order, env):
        variable, low, high, inclusive = e.data
        end = resolve(high, env) + (1 if inclusive else 0)
        return [self(e.args[0], order, {**env, variable: i}) for i in range(resolve(low, env), end)]

    def of_sum(self, e, order, env):
        terms = self.terms(e, order, env)
        result = terms[0]
        for x in terms[1:]:
            result = entrywise(lambda a, b: a + b, result, x)
        return result

    def of_collect(self, e, order, env):
        return self.terms(e, order, env)

    def of_rotation(self, e, order, env):
        return arrays.rotation(e.data, self.args(e, order, env))

    def of_angular_velocity(self, e, order, env):
        r = self(e.args[0], order, env)
        rate = self.of_dot(e, order, env)
        if e.data:
            return arrays.vee(arrays.multiply(rate, arrays.transpose(r)))
        return arrays.vee(arrays.multiply(arrays.transpose(r), rate))

    def of_angular_velocity_of(self, e, order, env):
        sequence, inertial = e.data
        return self.of_made(e, order, env, lambda: angular_velocity(rotation(sequence, *e.args), inertial))


def exact(x):
    """1/x, where x may be an integer."""
    if isinstance(x, int):
        x = mpf(x) if PRECISE[0] else float(x)
    return reciprocal(x)


def resolve(i, env):
    return i if isinstance(i, int) else env[i[0]] + i[1]


def bound(row, at):
    """The values of a definition's index variables for a member; none if the row does not define it."""
    env = {}
    for i, k in zip(row.indices, at):
        if isinstance(i, int):
            if i != k:
                return None
        else:
            env[i[0]] = k - i[1]
    fits = all(low <= env[variable] < high for variable, low, high in row.ranges)
    return env if fits else None


def members(row):
    i = row.indices[0]
    return [i] if isinstance(i, int) else [k + i[1] for k in range(row.ranges[0][1], row.ranges[0][2])]
