"""References of motions: where they end, and when watched functions are zero.

The tolerance of an end is what the motion makes of inputs that are off, measured by others whose inputs are off by `OFF`,
times the unit of the method: that of binary64 for the Taylor method at its default tolerance, the tolerance for the others. It grows
with the time. Errors that are made before a jump or a corner move the time at which it is met: what they make of the end is measured by
motions that are off halfway on the last step to some of the crossings; and by one that is off where the motion is fastest, as near
a pole of its angles. The tolerance of the time of an event is measured as the first.
"""

import math
import random
from dataclasses import dataclass

from arrays import flat
from derivatives import NoValue
from motions import splits
from motions.numbers import precise, real
from motions.piecewise import Motion
from reference import TRIES, Inputs, drawn_state

OFF = 2.0**-30
SAMPLES = 3  # Motions from inputs that are off: by one alone, what becomes of errors may be small by chance.
PRECISE, LOOSE = 1e-19, 1e-16  # Tolerances of a step.
# The classical Runge-Kutta method has no tolerance: the fourth power of its step of 0.01, of motions with derivatives of some ten times their size.
UNITS = {"taylor": 2.0**-53, "dop853": 1e-11, "runge_kutta": 1e-7}
ALLOWANCE = 100.0
MODES = ("plain", "plain", "plain", "equal", "zero", "negative")
MOST_GROWTH = 1e5  # Of a relative error of the inputs.


@dataclass
class Asked:
    """What is asked of the motions of a model."""

    span: tuple  # How long they are, at least and at most.
    methods: tuple = ("taylor", "dop853")
    states: int = 3
    reduced: bool = False  # Whether the reduced model is integrated, too.
    lanes: int = 0  # How many motions are integrated in lanes.
    split: int = 0  # In how many ways a motion is split into runs.
    pair: str | None = None  # The parameter that is subtracted in the first event, set so that two of its zeros are close.
    step: float = 1.0  # The longest step of the reference, less than the time in which anything happens.
    functions: int = 0  # How many functions are watched.


def perturbed(at, rng):
    """The inputs, each off by `OFF`."""
    off = lambda x: x * (1 + OFF * rng.choice((-1, 1))) + (OFF * rng.choice((-1, 1)) if x == 0 else 0)
    moved = at.mapped(off)
    return Inputs(at.t, moved.q, moved.v, moved.fields)


class Reference:
    """The motion from `at` to `end`, or to the time at which it `slides`: its last state, its events, and what errors make of them."""

    def __init__(self, model, at, end, rng):
        self.model, self.exact, self.end = model, at.mapped(real), end
        self.watched = [e.expression for e in model.events]
        motion, near = self.run(self.exact, PRECISE), []
        for _ in range(SAMPLES):
            near.append(self.run(perturbed(self.exact, rng), LOOSE))
            if not same_way(motion, near[-1]):
                raise NoValue("not the same way")
        self.y, self.slides, self.crossings, self.events = motion.y, motion.slides, motion.crossings, motion.events
        self.duration = 1 + abs(float(end - self.exact.t))
        size = max(abs(x) for x in [*self.exact.q, *self.exact.v, *motion.y])
        growth = max(self.growth(size, motion, one) for one in near)
        # Errors that are made behind a crossing do not pass it, and those made before are made larger by it.
        marks = [self.exact.t, *motion.crossings, real(end)]
        lengths = [1 + abs(float(b - a)) for a, b in zip(marks, marks[1:])]
        self.error = growth * lengths[0]
        if motion.crossings:
            self.error += self.behind_crossings(motion, size, rng) * sum(lengths[1:])
        late = self.from_fastest(motion, rng)
        if late is not None:
            self.error = max(self.error, self.growth(size, motion, late) * self.duration)
        self.shifts = [max(self.shift(a, b) for b in others) for a, *others in zip(motion.events, *(one.events for one in near))]
        if late is not None and late.events:
            behind = [self.shift(a, b) for a, b in zip(motion.events[-len(late.events) :], late.events)]
            self.shifts[-len(behind) :] = map(max, self.shifts[-len(behind) :], behind)
        if self.slides is not None:
            # Where it begins to slide, the argument of the branch passes zero: so does the time.
            moved = max(abs(motion.slides - one.slides) for one in near) / OFF
            self.error = self.error + float(max(moved, abs(motion.slides), 1)) * self.duration

    def run(self, at, tolerance):
        asked = self.model.motion
        return Motion(self.model, at.fields, self.watched, at.t, [*at.q, *at.v], tolerance, asked.step).to(self.end)

    def growth(self, size, motion, near):
        """What becomes of an error of one unit."""
        growth = float(max(1, size, max(abs(a - b) for a, b in zip(motion.y, near.y)) / OFF))
        if not growth < MOST_GROWTH:
            raise NoValue("grows too much")
        return growth

    def behind_crossings(self, motion, size, rng):
        """What becomes of errors that are made on the way to crossings: the greatest of a few of them."""
        count, shared = len(motion.crossings), {}
        some = sorted({0, count // 2, count - 1})
        return max(self.behind(motion, i, size, rng, shared) for i in some)

    def behind(self, motion, i, size, rng, shared):
        """What becomes of errors that are made on the way to a crossing."""
        t, y = motion.halfway[i]
        moved = [x + OFF * max(abs(x), 1) * rng.choice((-1, 1)) for x in y]
        near = Motion(self.model, self.exact.fields, [], t, moved, LOOSE, self.model.motion.step, shared).to(self.end)
        if len(near.crossings) != len(motion.crossings) - i:
            raise NoValue("not the same way")
        return self.growth(size, motion, near)

    def from_fastest(self, motion, rng):
        """The motion that is off where it is fastest, as near a pole of its angles: what rounding makes there is more than errors at
        the start become."""
        speed, t, y = motion.fastest
        ends = max(abs(v) for v in [*self.exact.v, *motion.y[len(motion.y) // 2 :]])
        if motion.slides is not None or speed <= 2 * ends:
            return None
        moved = [x + OFF * max(abs(x), 1) * rng.choice((-1, 1)) for x in y]
        late = Motion(self.model, self.exact.fields, self.watched, t, moved, LOOSE, self.model.motion.step).to(self.end)
        expected = motion.events[len(motion.events) - len(late.events) :]
        if [e.which for e in expected] != [e.which for e in late.events] or any((e.t - t) * (self.end - float(t)) < 0 for e in expected):
            raise NoValue("not the same way")
        return late

    def shift(self, a, b):
        return float(max(abs(a.t - b.t) / OFF, abs(a.t), 1, 1 / abs(a.rate))) * self.duration

    def tolerance(self, method):
        return ALLOWANCE * UNITS[method] * self.error

    def event_tolerances(self, method):
        return [ALLOWANCE * UNITS[method] * shift * (1 + len(self.crossings)) for shift in self.shifts]


def same_way(motion, near):
    """Whether a motion from inputs that are off meets the same events and branches."""
    events = [e.which for e in motion.events] == [e.which for e in near.events]
    return events and len(motion.crossings) == len(near.crossings) and (motion.slides is None) == (near.slides is None)


def state(at, end, values, tolerances, **more):
    return {
        "t": at.t,
        "q": at.q,
        "qd": at.v,
        "params": [x for field in at.fields.values() for x in flat(field)],
        "trial": [],
        "end": end,
        "values": values,
        "tolerances": tolerances,
        **more,
    }


def states(model, seed):
    """States from which the motions of a model are compared, with their references."""
    rng, asked = random.Random(seed), model.motion
    found = []
    with precise():
        for _ in range(asked.states):
            for attempt in range(TRIES):
                try:
                    found += drawn(model, rng, asked, rng.choice(MODES) if attempt < TRIES / 2 else "plain")
                except (NoValue, ArithmeticError, ValueError, KeyError):
                    # mpmath has no product of zero and infinity: a `KeyError`.
                    continue
                break
    return found


def drawn(model, rng, asked, mode):
    """A motion of a random length from a random state, and what is compared of it."""
    at = drawn_state(model, rng, mode)
    end = at.t + rng.uniform(*asked.span)
    if asked.split and rng.random() < 0.2:
        end = 2 * at.t - end
    if asked.pair:
        set_pair(model, at, end, asked, rng)
    if asked.lanes:
        others = [drawn_state(model, rng, "plain") for _ in range(asked.lanes)]
        return [lanes(model, at, [(other.q, other.v, at.t + rng.uniform(*asked.span)) for other in others], rng)]
    if asked.split:
        reference = Reference(model, at, end, rng)
        return [split(at, reference, run) for run in splits.drawn(at, reference, asked, rng)]
    return [ends(model, at, end, asked, rng)]


def ends(model, at, end, asked, rng):
    """The last state by every method, and by that of the reduced model, and the events on the way."""
    reference = Reference(model, at, end, rng)
    values, tolerances = {}, {}
    if reference.slides is not None:
        # The Taylor method says so; those that sample do not see it.
        if asked.functions:
            raise NoValue("slides")
        return state(at, end, {"taylor": [reference.slides]}, {"taylor": reference.tolerance("taylor")})
    for method in asked.methods:
        for prefix in ("", "reduced ") if asked.reduced else ("",):
            name = prefix + method
            values[name], tolerances[name] = reference.y, reference.tolerance(method)
            if asked.functions:
                events = [x for e in reference.events if e.which < 2 for x in (e.which, e.t)]
                values[name + " events"] = [len(events) // 2, *events]
                tolerances[name + " events"] = max(reference.event_tolerances(method), default=ALLOWANCE * UNITS[method])
    return state(at, end, values, tolerances)


def lanes(model, at, motions, rng):
    """Motions from several starts that differ in all components, to ends that differ; the time alone of one that slides."""
    starts, ys, tolerance = [], [], 0.0
    for q, v, stop in motions:
        reference = Reference(model, Inputs(at.t, q, v, at.fields), stop, rng)
        starts += [*q, *v, stop]
        ys += reference.y if reference.slides is None else [reference.slides]
        tolerance = max(tolerance, reference.tolerance("taylor"))
    found = state(at, motions[0][-1], {"lanes": ys, "lanes alone": [0.0] * len(ys)}, {"lanes": tolerance, "lanes alone": 0.0})
    return {**found, "starts": starts}


def split(at, reference, run):
    """The events of the runs into which a motion is split."""
    values, tolerance = splits.expected(reference, run)
    return state(at, reference.end, {"events": values}, {"events": tolerance}, run=run)


def again(model, at, given, rng):
    """What is compared of another model in the place of that which the state is of."""
    asked, end = model.motion, float(given["end"])
    words = lambda text: [float(x) for x in text.split()]
    with precise():
        if "starts" in given:
            each, n = words(given["starts"]), len(at.q)
            rows = [each[i : i + 2 * n + 1] for i in range(0, len(each), 2 * n + 1)]
            return lanes(model, at, [(row[:n], row[n:-1], row[-1]) for row in rows], rng)
        if "run" in given:
            run = {key: words(x) if key in ("watched", "times") else x for key, x in given["run"].items()}
            return split(at, Reference(model, at, end, rng), {**run, "step": float(run["step"])})
        return ends(model, at, end, asked, rng)


def set_pair(model, at, end, asked, rng):
    """Sets the parameter so that the first watched function is nearly zero where it is greatest or least."""
    rate = [model.events[1].expression]
    at.fields[asked.pair] = 0.0
    exact = at.mapped(real)
    motion = Motion(model, exact.fields, [model.events[0].expression, *rate], at.t, [*exact.q, *exact.v], LOOSE)
    motion.to(end)
    turns = [e for e in motion.events if e.which == 1]
    if not turns:
        raise NoValue("no extremum")
    turn = rng.choice(turns)
    there = Motion(model, exact.fields, [model.events[0].expression], at.t, [*exact.q, *exact.v], LOOSE).to(turn.t)
    height = there.program(there.t, there.y)[2][0]
    depth = 10 ** rng.uniform(-10, -2)
    at.fields[asked.pair] = float(height - depth if turn.rises is False else height + depth)
