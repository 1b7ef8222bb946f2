"""heyoka's Taylor integrators over an ensemble of motions, for a contest. Usage: heyoka_ensemble.py MODEL

Answers the questions of the program, a line of JSON each (see `src/question.rs`). A method is named by how the members are integrated,
`batches of 4`, `alone`, `ensemble`, `ensemble of batches of 4`, and by settings, such as `batches of 4, fast math`; `recommended` stands
for heyoka's own size of a batch. The first two are loops over one integrator, of which the calls of `propagate_until` are timed and the
setting of states is not; the others are calls of heyoka's `ensemble_propagate_until`, for some hundreds of members each, since all of
their integrators are kept. Equations are those by hand. An integrator is compiled when it is first asked for, outside of what is
timed. Times are CPU times of this process: heyoka's ensembles run in threads of their own, one at a time.
"""

import sys
import time

import heyoka as hy
import numpy as np

import systems
from answers import answer_questions

# So many members of one of heyoka's ensembles.
KEPT = 480

model = sys.argv[1]
hy.llvm_state.set_diskcache_enabled(False)
hy.set_nthreads(1)
n = systems.degrees(model)
last = (None, None)


def integrator(width, settings, tolerance):
    """The last one is kept."""
    global last
    key = (width, settings, tolerance)
    if last[0] != key:
        x = hy.make_vars(*[f"x{i:02d}" for i in range(2 * n)])
        equations = list(zip(x, systems.by_hand(model, x, hy.sin, hy.cos, hy.time)))
        options = {"fast_math": "fast math" in settings, "force_avx512": "vectors of 512 bits" in settings}
        if tolerance is not None:
            options["tol"] = tolerance
        if width == 1:
            last = (key, hy.taylor_adaptive(equations, np.zeros(2 * n), **options))
        else:
            last = (key, hy.taylor_adaptive_batch(equations, np.zeros((2 * n, width)), **options))
    return last[1]


def put(single, state):
    single.time = 0.0
    single.state[:] = state
    return single


def put_batch(batch, states):
    batch.set_time(0.0)
    batch.state[:] = states
    return batch


def one_after_the_other(integrator, rows, end, put):
    """Seconds, steps and final states, from rows of one member or of one batch each."""
    clock = time.process_time
    seconds, steps, states = 0.0, 0, []
    for row in rows:
        put(integrator, row)
        begin = clock()
        result = integrator.propagate_until(end)
        seconds += clock() - begin
        if put is put_batch:
            steps += sum(lane[3] for lane in integrator.propagate_res)
        else:
            steps += result[3]
        states.append(integrator.state.copy())
    return seconds, steps, states


def ensembles(integrator, rows, end, put):
    is_batch = put is put_batch
    propagate = hy.ensemble_propagate_until_batch if is_batch else hy.ensemble_propagate_until
    seconds, steps, states = 0.0, 0, []
    count = KEPT // rows.shape[-1] if is_batch else KEPT
    for first in range(0, len(rows), count):
        part = rows[first : first + count]
        begin = time.process_time()
        found = propagate(integrator, end, len(part), lambda copy, i: put(copy, part[i]))
        seconds += time.process_time() - begin
        for result in found:
            ended = result[0]
            steps += sum(lane[3] for lane in ended.propagate_res) if is_batch else result[4]
            states.append(ended.state.copy())
    return seconds, steps, states


def propagate(method, tolerance, starts, end):
    """CPU time, steps and final states of one run over all starts."""
    kind, *settings = method.split(", ")
    width = 1
    if "batches of " in kind:
        size = kind.split("batches of ")[1]
        width = hy.recommended_simd_size() if size == "recommended" else int(size)
    run = ensembles if kind.startswith("ensemble") else one_after_the_other
    used = integrator(width, tuple(settings), tolerance)
    if width == 1:
        return run(used, starts, end, put)
    # What is missing in the last batch is its last member.
    missing = -len(starts) % width
    padded = np.concatenate([starts, np.repeat(starts[-1:], missing, axis=0)])
    rows = np.ascontiguousarray(padded.reshape(-1, width, 2 * n).transpose(0, 2, 1))
    seconds, steps, states = run(used, rows, end, put_batch)
    return seconds, steps, list(np.concatenate([batch.T for batch in states])[: len(starts)])


answer_questions(propagate)
