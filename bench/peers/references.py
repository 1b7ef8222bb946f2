"""The final states at t = 1000, by heyoka in quadruple precision. Usage: references.py NAME...

It writes them into trajectories.json, rounded to doubles. Twenty links take an hour. `-- --taylor` compares all with
our Taylor method in double-double, which shares nothing with this but the starts.
"""

import json
import pathlib
import re
import sys

import heyoka as hy

from systems import by_hand, degrees

FILE = pathlib.Path(__file__).with_name("trajectories.json")


def write(trajectories):
    """Each list of numbers in one line."""
    text = json.dumps(trajectories, indent=1)
    text = re.sub(r"\[[^\[\]]*\]", lambda numbers: " ".join(numbers[0].split()), text)
    FILE.write_text(text + "\n")


hy.llvm_state.set_diskcache_enabled(False)
for name in sys.argv[1:]:
    trajectories = json.loads(FILE.read_text())
    trajectory = trajectories["trajectories"][name]
    n = degrees(name)
    x = hy.make_vars(*[f"x{i:02d}" for i in range(2 * n)])
    equations = list(zip(x, by_hand(name, x, hy.sin, hy.cos, hy.time)))
    start = [hy.real128(value) for value in trajectory["start"]]
    integrator = hy.taylor_adaptive_f128(equations, start, tol=hy.real128(1e-28), compact_mode=n > 3)
    integrator.propagate_until(hy.real128(1000.0))
    trajectory["end"] = [float(value) for value in integrator.state]
    write(trajectories)
