"""Ways to split a motion into runs, and the events that the runs have to report in all: each once, in the order of time."""

import math
from itertools import pairwise

from derivatives import NoValue

# By separate runs, by one that is advanced, stored and resumed, stopped at each event, limited in its steps, with reactions that
# change nothing or that say they did; or by samples within one run.
WAYS = ("runs", "advanced", "resumed", "stopped", "limited", "unchanged", "changed", "samples")
APART = 1e-6  # Events of different functions, and the ends of a motion, are apart by this.
RUNGE_KUTTA_STEP = 0.01
ULPS = (0, 0, 1, -1, 2, -2, 3, -3, 5, -5, 8, -8, 13, -40)


def states(at, reference, asked, rng, state):
    """A state for each way of splitting: `asked.split` of them."""
    direction = 1 if reference.end > at.t else -1
    ends = [float(at.t), *(float(e.t) for e in reference.events), float(reference.end)]
    if len(ends) < 3 or any((b - a) * direction < APART for a, b in pairwise(ends)) and not asked.pair:
        raise NoValue("events that cannot be told apart")
    return [one(at, reference, asked, rng, state, direction) for _ in range(asked.split)]


def one(at, reference, asked, rng, state, direction):
    methods = ("taylor",) if asked.pair else asked.methods
    method, way = rng.choice(methods), rng.choice(WAYS)
    functions = sorted({e.which for e in reference.events})
    # Of two functions, or of one in both directions, by declared events or by a closure; close pairs have no signs to be sampled.
    declared = bool(asked.pair) or rng.random() < 0.6
    first = rng.choice(functions) if not asked.pair else 0
    second = rng.choice([k for k in range(asked.functions) if k != first or rng.random() < 0.3])
    turns = [rng.choice((1, -1, 0)) for _ in range(2)]
    if second == first:
        turns = rng.choice(([1, -1], [-1, 1]))
    watched = list(zip((first, second), turns))
    expected = []
    for e, tolerance in zip(reference.events, reference.event_tolerances(method)):
        for i, (which, turn) in enumerate(watched):
            if e.which == which and turn in (0, 1 if e.rises else -1):
                expected.append((i, float(e.t), tolerance))
    if method != "taylor":
        step = least_gap(reference.events, watched)
        if step < 3 * RUNGE_KUTTA_STEP:
            method, step = "taylor", 0.0
    else:
        step = 0.0
    tolerance = max((w for *_, w in expected), default=1e-9)
    values = [float(len(expected)), *(x for i, t, _ in expected for x in (float(i), t))]
    return state(at, reference.end, {"events": values}, {"events": tolerance}, run={
        "method": method,
        "way": way,
        "declared": declared,
        "step": step if method == "dop853" else RUNGE_KUTTA_STEP,
        "watched": [x for pair in watched for x in pair],
        "times": times(at, reference, rng, direction, expected),
    })


def least_gap(events, watched):
    gaps = [1.0]
    for which, _ in watched:
        at = [float(e.t) for e in events if e.which == which]
        gaps += [abs(b - a) for a, b in pairwise(at)]
    return min(gaps)


def times(at, reference, rng, direction, expected):
    """Where the runs end: at events, to some units in the last place, near them, and anywhere."""
    found = {float(reference.end)}
    for _ in range(rng.randint(1, 5)):
        near = rng.choice(expected)[1] if expected and rng.random() < 0.8 else float(rng.choice(reference.events).t)
        lot = rng.random()
        if lot < 0.55:
            t = moved(near, rng.choice(ULPS))
        elif lot < 0.8:
            t = near + rng.choice((-1, 1)) * 10 ** rng.uniform(-15, -2)
        else:
            t = rng.uniform(float(at.t), float(reference.end))
        if (t - at.t) * direction > 0 and (float(reference.end) - t) * direction > 0:
            found.add(t)
    return sorted(found, reverse=direction < 0)


def moved(x, ulps):
    for _ in range(abs(ulps)):
        x = math.nextafter(x, math.copysign(math.inf, ulps))
    return x
