"""Ways to split a motion into runs, and the events that the runs have to report in all: each once, in the order of time."""

import math
from itertools import pairwise

from derivatives import NoValue
from motions.zeros import are_told

# By separate runs, by one that is advanced, stored and resumed, stopped at each event, limited in its steps, with reactions that
# change nothing or that say they did; or by samples within one run.
WAYS = ("runs", "advanced", "resumed", "stopped", "limited", "unchanged", "changed", "samples")
APART = 1e-6  # Events of different functions, and the ends of a motion, are apart by this.
RUNGE_KUTTA_STEP = 0.01
SAMPLED_GAP = 1.0  # Zeros of one function that are closer may lie between two samples of a step of the Taylor method, which has no limit on falls.
LEAST = 1e-200  # Runs as short as a unit in the last place of less have no steps.
ULPS = (0, 0, 1, -1, 2, -2, 3, -3, 5, -5, 8, -8, 13, -40)


def drawn(at, reference, asked, rng):
    """Ways to split a motion: `asked.split` of them."""
    direction = 1 if reference.end > at.t else -1
    ends = [float(at.t), *(float(e.t) for e in reference.events), float(reference.end)]
    if len(ends) < 3 or any((b - a) * direction < APART for a, b in pairwise(ends)) and not asked.pair:
        raise NoValue("events that cannot be told apart")
    if not are_told(reference.model, reference.exact.fields, reference.events, rng):
        raise NoValue("zeros that rounding hides")
    return [one(at, reference, asked, rng, direction) for _ in range(asked.split)]


def one(at, reference, asked, rng, direction):
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
    step = 0.0
    if method == "taylor" and not declared and least_gap(reference.events, watched) < SAMPLED_GAP:
        declared = True
    if method != "taylor":
        step = least_gap(reference.events, watched)
        if step < 3 * RUNGE_KUTTA_STEP:
            method, step = "taylor", 0.0
    run = {
        "method": method,
        "way": way,
        "declared": declared,
        "step": step if method == "dop853" else RUNGE_KUTTA_STEP,
        "watched": [x for pair in watched for x in pair],
    }
    times = [t for _, t, _ in seen(reference, run)]
    return {**run, "times": ends_of_runs(at, reference, rng, direction, times)}


def seen(reference, run):
    """The events that the runs report: the index among those watched, the time, and its tolerance."""
    watched = list(zip(run["watched"][::2], run["watched"][1::2]))
    pairs = zip(reference.events, reference.event_tolerances(run["method"]))
    turn_of = lambda e: 1 if e.rises else -1
    return [(i, float(e.t), tolerance) for e, tolerance in pairs for i, (which, turn) in enumerate(watched)
            if e.which == which and turn in (0, turn_of(e))]


def expected(reference, run):
    """How many events there are, then the index and the time of each; and the tolerance."""
    events = seen(reference, run)
    return [float(len(events)), *(x for i, t, _ in events for x in (float(i), t))], max((w for *_, w in events), default=1e-9)


def least_gap(events, watched):
    gaps = [1.0]
    for which, _ in watched:
        at = [float(e.t) for e in events if e.which == which]
        gaps += [abs(b - a) for a, b in pairwise(at)]
    return min(gaps)


def ends_of_runs(at, reference, rng, direction, events):
    """Where the runs end: at events, to some units in the last place, near them, and anywhere."""
    found = {float(reference.end)}
    for _ in range(rng.randint(1, 5)):
        near = rng.choice(events) if events and rng.random() < 0.8 else float(rng.choice(reference.events).t)
        lot = rng.random()
        if lot < 0.55 and abs(near) > LEAST:
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
