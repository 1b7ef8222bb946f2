"""The file of models that the package compiles: generated models with their states and references, as JSON."""

import json
import random
from multiprocessing import Pool

from kinds import KINDS
from motions import reference as motions
from reference import references
from spelling import declaration

STATES = 2


def generated(job):
    """One model with its references: `job` is a kind, a seed and a number; the three decide everything."""
    kind, seed, number = job
    rng = random.Random(f"{kind}/{seed}/{number}")
    model = KINDS[kind](rng)
    text = declaration(model, rng)
    if model.motion:
        states, shapes = motions.states(model, f"{kind}/{seed}/{number}/motions"), {}
    else:
        states, shapes = references(model, STATES, f"{kind}/{seed}/{number}/states")
    return assembled(f"{kind}_{seed}_{number}", model, text, states, shapes)


def assembled(name, model, text, states, shapes):
    """A model as it stands in the file."""
    return {
        "id": name,
        "kind": model.kind,
        "n": len(model.coordinate_labels()),
        "energies": model.lagrangian is None,
        **({"constraints": len(states[0]["values"]["lambda"])} if states and model.is_constrained() else {}),
        **({"energy_balance": True} if model.energy_balance else {}),
        **({"ignorable": model.ignorable_places()} if model.ignorable else {}),
        "fields": [field(f) for f in model.fields],
        "outputs": shapes,
        **(motion(model) if model.motion else {}),
        "declaration": text,
        "states": [spelled(state) for state in states],
    }


def motion(model):
    """What is integrated, in place of what is evaluated at states."""
    asked = model.motion
    what = "splits" if asked.split else "lanes" if asked.lanes else "ends"
    return {"motion": {"compared": what, "reduced": asked.reduced}}


def field(f):
    """A field; its type is named where that is a body."""
    row = {"name": f.name, "shape": f.shape, "family": f.family, "input": f.input}
    return row if f.body is None else {**row, "body": f.body}


def spelled(state):
    """Numbers as words in a string: binary64 numbers that are read back as they are."""
    words = lambda x: " ".join(repr(float(y)) for y in (x if isinstance(x, list) else [x]))
    tables = {key: {name: words(x) for name, x in state[key].items()} for key in ("values", "tolerances")}
    lists = ("t", "q", "qd", "params", "trial", "end", "starts", "scales", "condition")
    row = {**{key: words(state[key]) for key in lists if key in state}, **tables}
    if "run" in state:
        row["run"] = {key: x if isinstance(x, (str, bool)) else words(x) for key, x in state["run"].items()}
    return row


def all_generated(seed, count, kinds, jobs):
    """`count` models of the kinds in turn, generated while those before are compiled."""
    kinds = kinds or list(KINDS)
    work = [(kinds[i % len(kinds)], seed, i // len(kinds)) for i in range(count)]
    with Pool(jobs) as pool:
        yield from pool.imap(generated, work)


def write(path, models, provenance):
    path.parent.mkdir(parents=True, exist_ok=True)
    document = {"provenance": provenance, "models": models}
    path.write_text(json.dumps(document, indent=0) + "\n")


def read(path):
    return json.loads(path.read_text())["models"]
