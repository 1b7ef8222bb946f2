"""heyoka's Taylor integrators, for a contest. Usage: heyoka_taylor.py MODEL

Answers the questions of the program, a line of JSON each (see `src/question.rs`). A method is named by the equations,
`hand` or `lagrangian`, and by settings: `hand, fast math`, `hand, compact`, `hand, batches of 4`. An integrator is compiled when it is first
asked for, outside of what is timed. Times are CPU times of this thread.
"""

import sys
import time

import heyoka as hy
import numpy as np

import systems
from answers import answer_questions

model = sys.argv[1]
hy.llvm_state.set_diskcache_enabled(False)
hy.set_nthreads(1)
n = systems.degrees(model)
integrators = {}


def equations(kind):
    x = hy.make_vars(*[f"x{i:02d}" for i in range(2 * n)])
    if kind == "lagrangian":
        return hy.lagrangian(systems.lagrangian(model, x[:n], x[n:], hy.sin, hy.cos), x[:n], x[n:])
    return list(zip(x, systems.by_hand(model, x, hy.sin, hy.cos, hy.time)))


def integrator(method, tolerance, width):
    key = (method, tolerance, width)
    if key not in integrators:
        kind, *settings = method.split(", ")
        options = {"fast_math": "fast math" in settings, "compact_mode": "compact" in settings}
        if tolerance is not None:
            options["tol"] = tolerance
        if width == 1:
            integrators[key] = hy.taylor_adaptive(equations(kind), np.zeros(2 * n), **options)
        else:
            integrators[key] = hy.taylor_adaptive_batch(equations(kind), np.zeros((2 * n, width)), **options)
    return integrators[key]


def propagate(method, tolerance, starts, end):
    """CPU time, steps and final states of one run over all starts."""
    if len(starts) == 1:
        single = integrator(method, tolerance, 1)
        single.time = 0.0
        single.state[:] = starts[0]
        begin = time.thread_time()
        result = single.propagate_until(end)
        return time.thread_time() - begin, result[3], [single.state.copy()]
    width = 4 if method.endswith("batches of 4") else len(starts)
    batch = integrator(method, tolerance, width)
    seconds, steps, states = 0.0, 0, []
    for first in range(0, len(starts), width):
        batch.set_time(0.0)
        batch.state[:] = starts[first : first + width].T
        begin = time.thread_time()
        batch.propagate_until(end)
        seconds += time.thread_time() - begin
        steps = max(steps, *(result[3] for result in batch.propagate_res))
        states.extend(batch.state.T.copy())
    return seconds, steps, states


answer_questions(propagate)
