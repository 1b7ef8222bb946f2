"""heyoka: `lagrangian()` and `cfunc`, eight states at a time. Usage: heyoka_peer.py MODEL STATES.json ROUNDS

It has no C to be called from outside, so it measures itself: many copies of the states in one call, so
that the way through Python counts little. Its code is for the processor it runs on.
"""

import json
import sys
import time

import heyoka as hy
import numpy as np

from energies import degrees, lagrangian

model, states, rounds = sys.argv[1], sys.argv[2], int(sys.argv[3])
COPIES = 16
hy.llvm_state.set_diskcache_enabled(False)
hy.set_nthreads(1)
n = degrees(model)
start = time.perf_counter()
x = hy.make_vars(*[f"x{i:02d}" for i in range(2 * n)])
energy = lagrangian(model, x[:n], x[n:], hy.sin, hy.cos)
accelerations = [right for _, right in hy.lagrangian(energy, x[:n], x[n:])][n:]
derived = time.perf_counter()
# The compact form is slower up to ten links by a tenth or more; at fifteen and twenty it is a little
# ahead, by less than runs scatter.
evaluate = hy.cfunc(accelerations, x, compact_mode=n > 10)
compiled = time.perf_counter()
with open(states) as file:
    once = np.array(json.load(file)).T
inputs = np.ascontiguousarray(np.tile(once, COPIES))
outputs = np.zeros((n, inputs.shape[1]))
best = float("inf")
for _ in range(rounds):
    begin = time.perf_counter()
    for _ in range(10):
        evaluate(inputs, outputs=outputs)
    best = min(best, (time.perf_counter() - begin) / (10 * inputs.shape[1]))
print(json.dumps({
    "derive_seconds": derived - start,
    "compile_seconds": compiled - derived,
    "throughput": best * 1e9,
    "accelerations": outputs[:, : once.shape[1]].T.tolist(),
}))
