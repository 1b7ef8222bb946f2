"""Builds the package on a file of models, leaves out those that the compiler refuses, and runs it."""

import json
import os
import subprocess
import time
from pathlib import Path

import document

PACKAGE = "lagrangian-adversarial"
ROOT = Path(__file__).resolve().parents[3]
OPTIMIZATION = [0]  # The level for the models: many motions take less time than a slower build costs.


class Build:
    """What came of a shard: comparisons, refusals by identifier, and seconds of compilation."""

    def __init__(self):
        self.comparisons, self.refused = [], {}
        self.seconds = 0.0


def built(models, folder, limit):
    """Builds and evaluates the models; a build that takes longer than `limit` seconds is split in two."""
    result = Build()
    models = list(models)
    while models:
        file = folder / "models.json"
        document.write(file, models, {})
        start = time.time()
        try:
            output = built_package(file, folder, limit)
        except subprocess.TimeoutExpired:
            return split(models, folder, limit, result)
        result.seconds += time.time() - start
        refused = refusals(output.stdout, {m["id"] for m in models})
        result.refused.update(refused)
        if output.returncode == 0:
            # Run by cargo, it would be built anew where its command differs.
            program = [str(folder / "target" / "debug" / PACKAGE)]
            evaluated = subprocess.run(program, capture_output=True, text=True, timeout=limit)
            if evaluated.returncode != 0:
                raise SystemExit(evaluated.stderr[-4000:])
            result.comparisons += [json.loads(line) for line in evaluated.stdout.splitlines()]
            return result
        if not refused:
            raise SystemExit(output.stderr[-4000:] + output.stdout[-2000:])
        models = [m for m in models if m["id"] not in refused]
    return result


def split(models, folder, limit, result):
    if len(models) == 1:
        result.refused[models[0]["id"]] = f"takes longer than {limit} s to compile"
        return result
    middle = len(models) // 2
    for half in (models[:middle], models[middle:]):
        part = built(half, folder, limit)
        result.comparisons += part.comparisons
        result.refused.update(part.refused)
        result.seconds += part.seconds
    return result


def built_package(file, folder, limit):
    """What cargo says of the package with the models of a file."""
    environment = {
        **os.environ,
        "ADVERSARIAL_MODELS": str(file),
        "CARGO_TARGET_DIR": str(folder / "target"),
        # The macro keeps its debug assertions; nothing else of a debug build is wanted.
        "CARGO_PROFILE_DEV_DEBUG": "0",
        "CARGO_INCREMENTAL": "0",
        **({"CARGO_PROFILE_DEV_OPT_LEVEL": str(OPTIMIZATION[0])} if OPTIMIZATION[0] else {}),
    }
    command = ["cargo", "build", "-p", PACKAGE, "--bin", PACKAGE, "--message-format=json"]
    return subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=limit)


def is_refusal(message):
    """An error, or a warning that the simplified code was wrong and is not used."""
    return message.get("level", "").startswith("error") or "defect of `lagrangian`" in message.get("rendered", "")


def refusals(messages, known):
    """The errors by model, from the file that they are in."""
    refused = {}
    for line in messages.splitlines():
        if not line.startswith("{"):
            continue
        message = json.loads(line).get("message")
        if not isinstance(message, dict) or not is_refusal(message):
            continue
        for span in message["spans"]:
            name = Path(span["file_name"]).stem
            if name in known:
                refused.setdefault(name, message["rendered"])
    return refused
