"""Accelerations of ready models in Python, compared with those of Rust to the last bit.

The states are the lines that `cargo run -p lagrangian-models --example accelerations -- 1000` writes; the file with them is the value of
the environment variable ACCELERATIONS.
"""

import os
from collections import defaultdict

import numpy as np
import pytest
import ready

BY_MODEL = defaultdict(list)
with open(os.environ["ACCELERATIONS"], encoding="utf-8") as table:
    for line in table:
        name, *lists = line.rstrip("\n").split("\t")
        if hasattr(ready, name):
            BY_MODEL[name].append([np.array(numbers.split(), dtype=float) for numbers in lists])


def body(numbers):
    """The tuple for the thirteen numbers of a rigid body, or the four of another one."""
    if len(numbers) == 13:
        return numbers[0], numbers[1:4], numbers[4:].reshape(3, 3)
    return tuple(numbers)


def parameters(model, numbers):
    """The parameters by name. The help says which are bodies, and which are not single numbers."""
    rest, found = numbers, {}
    for name in model.PARAMETERS:
        line = next(line for line in model.__doc__.splitlines() if line.startswith(f"{name} : "))
        if "inertia tensor" in line:
            part, rest = rest[:13], rest[13:]
            found[name] = body(part)
        elif "moment" in line:
            part, rest = rest[:4], rest[4:]
            found[name] = (part[0], part[1:]) if "principal" in line else body(part)
        elif ", shape (" in line:
            shape = tuple(int(length) for length in line.split("(")[1].rstrip(",)").split(","))
            count = int(np.prod(shape))
            found[name], rest = rest[:count].reshape(shape), rest[count:]
        else:
            assert line.endswith(" : float"), line
            found[name], rest = rest[0], rest[1:]
    assert len(rest) == 0
    return found


def test_there_are_a_thousand_states_of_ten_models():
    assert len(BY_MODEL) >= 10
    assert all(len(states) == 1000 for states in BY_MODEL.values())


@pytest.mark.parametrize("name", sorted(BY_MODEL))
def test_accelerations_have_the_bits_of_rust(name):
    model = getattr(ready, name)
    for numbers, t, q, v, expected in BY_MODEL[name]:
        found = model(**parameters(model, numbers)).accelerations(q, v, t[0])
        np.testing.assert_array_equal(found, expected)
