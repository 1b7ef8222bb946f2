"""Which zeros of watched functions can be told from what rounding makes of the values next to them.

The rounding of a value is that of the operations alone, at inputs that are binary64 numbers (`rounding.py`). Two zeros of one function
are two if what is between them is more than that. And next to a zero the value has to be rounded by no more than errors of a unit in
its arguments would change it: x² + x near x = −1/2 is rounded to units of 1/4 while it hardly changes with x, so that nothing tells
how near a value is to zero.
"""

from itertools import pairwise

from derivatives import PRECISE
from evaluation import Evaluator, Point
from motions.numbers import real
from rounding import SCALE, UNIT, Rounded

SAMPLES = 4
DEEP = 100.0  # The least of an extremum between two zeros, relative to the rounding of the function.
SHOWN = 8.0  # The rounding of a function, relative to what units in the last places of its arguments make of it, at most.
MOVED = 2.0**-30


def are_told(model, fields, events, rng):
    """Whether no rounding hides one of these zeros, which are in the order of time."""
    roundings = [Zero(model, fields, e).rounding(rng) for e in events]
    for e, rounding in zip(events, roundings):
        if rounding > SHOWN * Zero(model, fields, e).shown():
            return False
    rows = list(zip(events, roundings))
    for which in {e.which for e in events}:
        for (a, noise), (b, other) in pairwise(row for row in rows if row[0].which == which):
            # The parabola with these zeros and rates.
            if abs(b.rate - a.rate) * abs(b.t - a.t) / 8 < DEEP * max(noise, other):
                return False
    return True


class Zero:
    """A watched function next to a zero, at binary64 numbers."""

    def __init__(self, model, fields, event):
        self.model, self.fields, self.expression = model, fields, model.events[event.which].expression
        self.inputs = [float(event.t), *(float(x) for x in event.y)]

    def value(self, inputs, number):
        n = len(inputs) // 2
        t, q, v = inputs[0], inputs[1 : n + 1], inputs[n + 1 :]
        return Evaluator(self.model, Point(t, q, v, {name: mapped(number, x) for name, x in self.fields.items()}))(self.expression)

    def exactly(self, inputs):
        return self.value([real(x) for x in inputs], real)

    def rounding(self, rng):
        """What rounding makes of the value: the greatest of a few samples."""
        exact = self.exactly(self.inputs)
        PRECISE[0], Rounded.rng = False, rng
        try:
            samples = [float(self.value([Rounded(x) for x in self.inputs], Rounded)) for _ in range(SAMPLES)]
        finally:
            PRECISE[0] = True
        return max(abs(float(real(x) - exact)) for x in samples) / SCALE

    def shown(self):
        """What errors of a unit in its arguments make of the value."""
        exact, changes = self.exactly(self.inputs), []
        for i, x in enumerate(self.inputs):
            moved = [real(y) for y in self.inputs]
            moved[i] *= 1 + real(MOVED)
            changes.append(abs(float(self.exactly(moved) - exact)) / MOVED)
        return UNIT * sum(changes)


def mapped(number, x):
    return [mapped(number, y) for y in x] if isinstance(x, list) else number(x)
