"""Generates models, and compares what the derive makes of them with an evaluation of its own.

    python3 tests/adversarial/generator run --seed 1 --count 200
    python3 tests/adversarial/generator run --file tests/adversarial/models/passing.json
    python3 tests/adversarial/generator select --seed 1 --each 3
    python3 tests/adversarial/generator minimize --id soup_4_8 --state 0
    python3 tests/adversarial/generator c --seed 1 --count 200
    python3 tests/adversarial/generator show --seed 1 --kinds jumps --count 3

Needs Python 3.11 and mpmath 1.3. `README.md` beside this folder says what is compared, and how.
"""

import argparse
import itertools
import shutil
import sys
from collections import Counter
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

import document
import in_c
from building import OPTIMIZATION, built
from kinds import KINDS
from minimization import minimized
from reference import MODES
from report import Report

MODELS = Path(__file__).resolve().parents[1] / "models"


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=("run", "select", "show", "minimize", "c"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=120, help="how many models")
    parser.add_argument("--kinds", type=lambda text: text.split(","), help="which, apart by commas; all if absent")
    parser.add_argument("--shard", type=int, default=120, help="how many models are compiled at a time")
    parser.add_argument("--each", type=int, default=3, help="how many models of each kind are selected")
    parser.add_argument("--states", type=int, help="how many states of a model are selected at most")
    parser.add_argument("--modes", type=lambda text: text.split(","), help="how values of fields are drawn, apart by commas; all if absent")
    parser.add_argument("--name", default="passing", help="the file of the models that are selected")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--optimize", type=int, default=0, help="the level of optimization of models, 1 for many motions")
    parser.add_argument("--limit", type=int, default=900, help="seconds for the compilation of a shard")
    parser.add_argument("--folder", type=Path, default=Path("target/adversarial"), help="where to build, and for findings")
    parser.add_argument("--id", help="the model to minimize")
    parser.add_argument("--state", type=int, default=0, help="the state at which it is wrong")
    parser.add_argument("--file", type=Path, help="models to run instead of generated ones")
    given = parser.parse_args()
    unknown = [kind for kind in given.kinds or [] if kind not in KINDS]
    if unknown:
        parser.error(f"no kinds are named {', '.join(unknown)}: there are {', '.join(KINDS)}")
    given.folder = given.folder.resolve()
    OPTIMIZATION[0] = given.optimize
    MODES[:] = given.modes or MODES
    return given


def evaluated(models, given):
    """A report on the models, and those that have a state of any use."""
    findings = given.folder / "findings" / (given.file.stem if given.file else f"seed_{given.seed}")
    shutil.rmtree(findings, ignore_errors=True)
    report, usable = Report(), []
    models = iter(models)
    while shard := list(itertools.islice(models, given.shard)):
        with_states = [m for m in shard if m["states"]]
        report.unusable += len(shard) - len(with_states)
        usable += with_states
        report.add(with_states, built(with_states, given.folder, given.limit))
        report.findings(findings)
        (findings / "table.txt").write_text(f"{report}\n")
        print(f"{len(usable)} models: {len(report.wrong)} wrong, {len(report.refused)} refused", flush=True)
    return report, usable


def run(given):
    if given.file:
        models = document.read(given.file)
    else:
        models = document.all_generated(given.seed, given.count, given.kinds, given.jobs)
    report, _ = evaluated(models, given)
    print(report)
    for name in report.wrong:
        quantities = sorted({c["quantity"] for c in report.wrong[name][1]})
        print(f"wrong: {name}: {', '.join(quantities)}")
    for name, (_, message) in report.refused.items():
        print(f"refused: {name}: {message.strip().splitlines()[0]}")
    return 1 if report.wrong or report.refused else 0


def in_c_source(given):
    """Compares models in C."""
    models = document.read(given.file) if given.file else document.all_generated(given.seed, given.count, given.kinds, given.jobs)
    count, wrong = in_c.compared(models, given.folder)
    print(f"{count} models in C, {wrong} wrong")
    return 1 if wrong else 0


def select(given):
    """Writes `passing.json` and `failing.json`, or files of the names given, from as many models of each kind as are asked for."""
    count = given.each * len(given.kinds or KINDS)
    report, models = evaluated(document.all_generated(given.seed, count, given.kinds, given.jobs), given)
    fails = lambda model: model["id"] in report.wrong or model["id"] in report.refused
    command = f"python3 tests/adversarial/generator select --seed {given.seed} --each {given.each}"
    command += f" --name {given.name} --kinds {','.join(given.kinds)}" if given.kinds else ""
    command += f" --states {given.states}" if given.states else ""
    command += f" --modes {','.join(given.modes)}" if given.modes else ""
    sample = Sample(given.states)
    for name, contents in ((given.name, "models that agree"), ("failing", "models that are wrong or refused")):
        chosen = [sample.fewer(model) for model in models if fails(model) == (name == "failing")]
        path = MODELS / f"{name}.json"
        if chosen:
            document.write(path, chosen, {"command": command, "contents": contents})
        else:
            path.unlink(missing_ok=True)
        print(f"{len(chosen)} {contents}")
    print(report)
    return 0


# The methods that motions are split under, and whether they watch for declared events: one of them in each model of a sample, since each has
# to be compiled for each model.
SPLIT = (("taylor", False), ("dop853", True), ("runge_kutta", False), ("taylor", True))


class Sample:
    """Models with at most so many states, and with one method each where there are several."""

    def __init__(self, most):
        self.most, self.turns = most, Counter()

    def fewer(self, model):
        if self.most is None:
            return model
        states = model["states"]
        if "motion" in model:
            compared = "reduced" if model["motion"]["reduced"] else model["motion"]["compared"]
            turn = self.turns[compared]
            self.turns[compared] += 1
            if compared == "splits":
                states = split_in_one_way(states, turn)
            elif compared == "reduced":
                states = [by_one_method(state, ("taylor", "dop853")[turn % 2]) for state in states]
        return {**model, "states": states[: self.most]}


def split_in_one_way(states, turn):
    """The states under the next method that some are under."""
    for k in range(len(SPLIT)):
        method, declared = SPLIT[(turn + k) % len(SPLIT)]
        found = [s for s in states if s["run"]["method"] == method and s["run"]["declared"] == declared]
        if found:
            return found
    return states


def by_one_method(state, method):
    of = lambda table: {name: x for name, x in table.items() if method in name}
    return {**state, "values": of(state["values"]), "tolerances": of(state["tolerances"])}


def minimize(given):
    """Prints a small model that is wrong where a given one is."""
    kind, seed, number = given.id.rsplit("_", 2)
    # The states follow from the name, too.
    job = kind, int(seed), int(number)
    report = minimized(job, document.generated(job), given.state, given.folder, given.limit)
    if report is None:
        print("no smaller model is wrong")
        return 1
    report.findings(given.folder / "findings" / "minimized")
    return 0


def show(given):
    for model in document.all_generated(given.seed, given.count, given.kinds, given.jobs):
        print(f"// {model['id']}, {len(model['states'])} states\n{model['declaration']}")
    return 0


if __name__ == "__main__":
    given = arguments()
    sys.exit({"run": run, "select": select, "show": show, "minimize": minimize, "c": in_c_source}[given.command](given))
