"""A model at constant momenta C of its ignorable coordinates, numerically: Routh's reduction without its formulas.

L is quadratic in the velocities u of the ignorable coordinates. They are solved for by a step of Newton's method from u = 0, which
is exact then, and what is asked for is evaluated at the full state.
"""

from mpmath import mpf

from arrays import added, flat, solve, transpose
from mechanics import Equations, outputs
from rounding import DEVIATION


class Reduction:
    """The values of the fields, the time, the coordinates with those that are ignorable, and C."""

    def __init__(self, model, at, constants):
        self.model, self.at, self.constants = model, at, constants
        self.ignorable = model.ignorable_places()
        self.remaining = [i for i in range(len(at.q)) if i not in self.ignorable]

    def equations(self, q, v):
        """The full model where these coordinates and velocities of its remaining ones are at the constants."""
        places, rates = list(self.at.q), [0 * x for x in self.at.v]
        for i, x, y in zip(self.remaining, q, v, strict=True):
            places[i], rates[i] = x, y
        still = Equations(self.model, self.at.t, places, rates, self.at.fields)
        missing = [c - still.p[i] for i, c in zip(self.ignorable, self.constants)]
        for i, u in zip(self.ignorable, solve(block(still.M, self.ignorable), missing)):
            rates[i] = u
        return Equations(self.model, self.at.t, places, rates, self.at.fields)

    def accelerations(self, q, v):
        return [self.equations(q, v).a[i] for i in self.remaining]


def block(matrix, places):
    return [[matrix[i][j] for j in places] for i in places]


def momenta(model, at):
    e = Equations(model, at.t, at.q, at.v, at.fields)
    return [e.p[i] for i in model.ignorable_places()]


def disturbed(model, at, rng):
    """The momenta of a state, each off by one unit of the terms that it is made of."""
    e = Equations(model, at.t, at.q, at.v, at.fields)
    size = lambda i: added(abs(m * x) for m, x in zip(e.M[i], at.v)) + abs(e.p[i])
    return [e.p[i] + size(i) * (2 * DEVIATION * rng.choice((-1, 1))) for i in model.ignorable_places()]


def quantities(model, at, constants, step):
    """What a reduced model has, at the remaining coordinates and velocities of a state; derivatives by differences."""
    r = Reduction(model, at, constants)
    q, v = ([x[i] for i in r.remaining] for x in (at.q, at.v))
    e = r.equations(q, v)
    u = [e.v[i] for i in r.ignorable]
    routhian = lambda e: added(c * e.v[i] for i, c in zip(r.ignorable, constants)) - e.L
    of_remaining = lambda x: [x[i] for i in r.remaining]
    found = {
        "reduced constants": constants,
        "reduced velocities": u,
        "reduced routhian": [routhian(e)],
        "reduced potential": [routhian(r.equations(q, [0 * x for x in v]))],
        "reduced h": [e.h],
        "reduced p": of_remaining(e.p),
        "reduced Q": of_remaining(e.Q),
        "reduced qdd": of_remaining(e.a),
        "full state": [*e.v],
    }
    base = of_remaining(e.a)
    for name, moved in (("reduced dqdd_dq", lambda i: (bumped(q, i, step), v)), ("reduced dqdd_dqd", lambda i: (q, bumped(v, i, step)))):
        columns = [[(x - y) / step for x, y in zip(r.accelerations(*moved(i)), base)] for i in range(len(q))]
        found[name] = flat(transpose(columns))
    for name, (x, _) in outputs(model, at.t, at.q, e.v, at.fields, e).items():
        found["reduced output " + name] = x
    return found


def bumped(x, i, step):
    return [y + step if k == i else y for k, y in enumerate(x)]


def references(model, exact, samples, step):
    """Values, and how far off they are at momenta that are off by a unit."""
    values = quantities(model, exact, momenta(model, exact), step)
    moved = [quantities(model, exact, [mpf(c) for c in constants], step) for constants in samples]
    noise = {name: max((abs(a - b) for sample in moved for a, b in zip(sample[name], value)), default=0) for name, value in values.items()}
    return values, noise
