"""References of motions: where they end, and when watched functions are zero.

The tolerance of an end is what the motion makes of inputs that are off, measured by a second motion whose inputs are off by `OFF`,
times the unit of the method: that of binary64 for the Taylor method at its default tolerance, the tolerance for the others. It grows
with the time and with each jump or corner on the way. The tolerance of the time of an event is measured in the same way.
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
PRECISE, LOOSE = 1e-19, 1e-16  # Tolerances of a step.
UNITS = {"taylor": 2.0**-53, "dop853": 1e-11, "runge_kutta": 1e-8}
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
    """The motion from `at` to `end`: its last state, its events, and what errors make of them."""

    def __init__(self, model, at, end, rng):
        exact = at.mapped(real)
        watched = [e.expression for e in model.events]
        run = lambda at, tolerance: Motion(model, at.fields, watched, at.t, [*at.q, *at.v], tolerance, model.motion.step).to(end)
        motion, near = run(exact, PRECISE), run(perturbed(exact, rng), LOOSE)
        same = [e.which for e in motion.events] == [e.which for e in near.events]
        if not same or len(motion.crossings) != len(near.crossings):
            raise NoValue("not the same way")
        self.end, self.y, self.crossings, self.events = end, motion.y, motion.crossings, motion.events
        size = max(abs(x) for x in [*exact.q, *exact.v, *motion.y])
        moved = max(abs(a - b) for a, b in zip(motion.y, near.y)) / OFF
        growth = float(max(1, size, moved))
        if not growth < MOST_GROWTH:
            raise NoValue("grows too much")
        self.error = growth * (1 + abs(float(end - exact.t)))
        shift = lambda a, b: float(max(abs(a.t - b.t) / OFF, abs(a.t), 1, 1 / abs(a.rate))) * (1 + abs(float(end - exact.t)))
        self.shifts = [shift(a, b) for a, b in zip(motion.events, near.events)]

    def tolerance(self, method):
        return ALLOWANCE * UNITS[method] * self.error * (1 + len(self.crossings))

    def event_tolerances(self, method):
        return [ALLOWANCE * UNITS[method] * shift * (1 + len(self.crossings)) for shift in self.shifts]


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
        return lanes(model, at, end, asked, rng)
    reference = Reference(model, at, end, rng)
    if asked.split:
        return splits.states(at, reference, asked, rng, state)
    values, tolerances = {}, {}
    add_ends(values, tolerances, asked, reference)
    return [state(at, end, values, tolerances)]


def add_ends(values, tolerances, asked, reference):
    """The last state by every method, and by that of the reduced model, and the events on the way."""
    for method in asked.methods:
        for prefix in ("", "reduced ") if asked.reduced else ("",):
            name = prefix + method
            values[name], tolerances[name] = reference.y, reference.tolerance(method)
            if asked.functions:
                events = [x for e in reference.events if e.which < 2 for x in (e.which, e.t)]
                values[name + " events"] = [len(events) // 2, *events]
                tolerances[name + " events"] = max(reference.event_tolerances(method), default=ALLOWANCE * UNITS[method])


def lanes(model, at, end, asked, rng):
    """Motions from several starts that differ in all components, to ends that differ."""
    starts, ys, tolerance = [], [], 0.0
    for _ in range(asked.lanes):
        other = drawn_state(model, rng, "plain")
        start = Inputs(at.t, other.q, other.v, at.fields)
        stop = at.t + rng.uniform(*asked.span)
        reference = Reference(model, start, stop, rng)
        starts.append([*start.q, *start.v, stop])
        ys += reference.y
        tolerance = max(tolerance, reference.tolerance("taylor"))
    found = state(at, end, {"lanes": ys, "lanes alone": [0.0] * len(ys)}, {"lanes": tolerance, "lanes alone": 0.0})
    return [{**found, "starts": [x for start in starts for x in start]}]


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
