"""Makes a model that is wrong smaller, as long as it is wrong.

Each round compiles many models that are smaller by one step, and goes on with the shortest that is still wrong (after
A. Zeller and R. Hildebrandt, Simplifying and isolating failure-inducing input, IEEE Trans. Softw. Eng. 28, 2002).
"""

import copy
import random

from building import built
from derivatives import NoValue
from document import assembled
from kinds import KINDS
from motions import reference as motions
from reference import Inputs, reference
from report import Report
from spelling import declaration
from tree import E, node

CLAUSES = ("kinetic", "potential", "dissipation")
ROWS = ("definitions", "forces", "constraints", "nonholonomic", "outputs")
BATCH = 48
# What may stand in the place of such a node: any of its arguments.
REPLACEABLE = ("add", "sub", "mul", "div", "neg", "powi", "powf", "call", "dot")


def places(e, path=()):
    """The paths to all nodes, those near the root first."""
    found, queue = [], [(e, path)]
    while queue:
        at, path = queue.pop(0)
        found.append((path, at))
        queue += [(a, (*path, i)) for i, a in enumerate(at.args)]
    return found


def replaced(e, path, by):
    if not path:
        return by
    args = list(e.args)
    args[path[0]] = replaced(args[path[0]], path[1:], by)
    return E(e.op, *args, data=e.data)


def smaller(e):
    """The expressions that are smaller by one step."""
    for path, at in places(e):
        if at.op in REPLACEABLE:
            for arg in at.args:
                yield replaced(e, path, arg)
        if at.op in ("call", "name") and path:
            yield replaced(e, path, node(1))


def steps(model):
    """The models that are smaller by one step: those without a clause or a row, then those with less in one."""
    for table in (*CLAUSES, *ROWS, "placed"):
        for i in range(len(getattr(model, table))):
            made = copy.copy(model)
            setattr(made, table, [x for k, x in enumerate(getattr(model, table)) if k != i])
            yield made
    # Events keep their places, by which they are watched.
    for table in (*CLAUSES, *ROWS, "events"):
        for i, entry in enumerate(getattr(model, table)):
            for less in smaller(entry if isinstance(entry, E) else entry.expression):
                made = copy.copy(model)
                rows = list(getattr(model, table))
                rows[i] = less if isinstance(entry, E) else copy.copy(entry)
                if not isinstance(entry, E):
                    rows[i].expression = less
                setattr(made, table, rows)
                yield made


def with_reference(model, at, given, name):
    """The document of a model at a state, of which the larger model had the one that is given; none where it cannot be evaluated."""
    try:
        if model.motion:
            state, shapes = motions.again(model, at, given, random.Random(name)), {}
        else:
            state, shapes = reference(model, at, random.Random(name))
    except (NoValue, ArithmeticError, ValueError, TypeError, KeyError, IndexError, AttributeError):
        return None
    return assembled(name, model, declaration(model, random.Random(1)), [state], shapes)


def inputs_of(model, state):
    """The state of a document as what a model is evaluated at."""
    words = {key: [float(x) for x in state[key].split()] for key in ("t", "q", "qd", "params")}
    values, fields = iter(words["params"]), {}
    for f in model.fields:
        one = lambda shape: next(values) if not shape else [one(shape[1:]) for _ in range(shape[0])]
        fields[f.name] = one(f.shape) if f.family is None else [one(f.shape) for _ in range(f.family)]
    return Inputs(words["t"][0], words["q"], words["qd"], fields)


def minimized(job, generated, state, folder, limit):
    """The smallest model that was found, as a report on it alone."""
    kind, seed, number = job
    model = KINDS[kind](random.Random(f"{kind}/{seed}/{number}"))
    given = generated["states"][state]
    at = inputs_of(model, given)
    best, best_report = model, None
    while True:
        batch, candidates = [], {}
        for candidate in steps(best):
            name = f"{kind}_{seed}_{number}_{len(batch)}"
            document = with_reference(candidate, at, given, name)
            if document:
                batch.append(document)
                candidates[name] = candidate
            if len(batch) == BATCH:
                break
        report = Report()
        if batch:
            report.add(batch, built(batch, folder, limit))
        if not report.wrong:
            return best_report
        shortest = min(report.wrong, key=lambda name: len(report.wrong[name][0]["declaration"]))
        best = candidates[shortest]
        best_report = Report()
        best_report.wrong[shortest] = report.wrong[shortest]
        print(f"{len(report.wrong[shortest][0]['declaration'])} characters are wrong", flush=True)
