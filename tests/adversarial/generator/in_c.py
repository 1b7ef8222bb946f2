"""Models in C, by the clause `c`: compiled by `cc`, and compared with the references at their states.

A test of the derive writes the sources. Models with bodies are left out, whose numbers the data have in another order than the struct in C,
as are motions; models with external functions have no source.
"""

import math
import os
import shutil
import subprocess

MAIN = """\
#include "model.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
static int get(double *x, int n)
{
    char word[64];
    int i;
    for (i = 0; i < n; ++i) {
        if (scanf("%63s", word) != 1) return 0;
        x[i] = strtod(word, NULL);
    }
    return 1;
}
static void put(const double *x, int rows, int first, int width, int stride)
{
    int i, j;
    for (i = 0; i < rows; ++i) {
        for (j = first; j < first + width; ++j) printf("%.17g ", x[i * stride + j]);
    }
    printf("\\n");
}
int main(void)
{
    enum { N = MODEL_COORDINATES, U = MODEL_INPUTS, C = MODEL_CONSTRAINTS };
    static double p[PARAMETERS + 1], t, q[N], v[N], u[U + 1], qdd[N], lambda[C + 1], a[4 * N * N], b[2 * N * U + 1], at[N];
    static double trial[N], inverse[N];
    if (STRUCT != PARAMETERS * sizeof(double)) return 1;
    while (get(p, PARAMETERS) && get(&t, 1) && get(q, N) && get(v, N) && get(u, U) && get(trial, N)) {
        model_accelerations(POINT, qddMULTIPLIERS);
        model_linearize(POINT, a, INPUTSat);
        model_inverse_dynamics(POINT, trial, inverse);
        put(qdd, 1, 0, N, N);
        put(lambda, 1, 0, C, C);
        put(a + 2 * N * N, N, 0, N, 2 * N);
        put(a + 2 * N * N, N, N, N, 2 * N);
        put(at, 1, 0, N, N);
        put(b + N * U, N, 0, U, U);
        put(inverse, 1, 0, N, N);
    }
    return 0;
}
"""
QUANTITIES = ("qdd", "lambda", "dqdd_dq", "dqdd_dqd", "dqdd_dt", "dqdd_du", "inverse")
STRICT = ("-std=c99", "-O1", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror", "-pedantic")


def size(field):
    return math.prod(field["shape"]) * (field["family"] or 1)


def compared(models, folder):
    """Prints what is wrong; returns how many models were compared, and how many of them are wrong."""
    folder = folder / "in_c"
    shutil.rmtree(folder, ignore_errors=True)
    models = [m for m in models if m["states"] and "qdd" in m["states"][0]["values"] and not any(f.get("body") for f in m["fields"])]
    for model in models:
        place = folder / model["id"]
        place.mkdir(parents=True)
        (place / "model.rs").write_text(model["declaration"])
    test = ["cargo", "test", "-p", "lagrangian-derive", "--lib", "c_sources::sources_of_a_folder", "--", "--ignored"]
    subprocess.run(test, env={**os.environ, "LAGRANGIAN_C_FOLDER": str(folder)}, check=True)
    count, wrong, nearest = 0, 0, dict.fromkeys(QUANTITIES, 0.0)
    for model in models:
        place = folder / model["id"]
        source = place / "model.c"
        if not source.exists() or not source.read_text().strip():
            continue
        count += 1
        problems = of_model(model, place, nearest)
        wrong += bool(problems)
        for problem in problems:
            print(f"wrong: {model['id']}: {problem}")
    print("largest errors over tolerances:", ", ".join(f"{name} {x:.2g}" for name, x in nearest.items()))
    return count, wrong


def of_model(model, place, nearest):
    """What is wrong with a model."""
    inputs = [f for f in model["fields"] if f["input"]]
    parameters = sum(size(f) for f in model["fields"] if not f["input"])
    has_struct = "} model_parameters;" in (place / "model.h").read_text()
    point = ("(const model_parameters *)p, " if has_struct else "") + "t, q, v" + (", u" if inputs else "")
    main = MAIN.replace("POINT", point).replace("PARAMETERS", str(parameters))
    main = main.replace("STRUCT", "sizeof(model_parameters)" if has_struct else "0")
    main = main.replace("qddMULTIPLIERS", "qdd, lambda" if model.get("constraints") else "qdd").replace("INPUTSat", "b, at" if inputs else "at")
    (place / "main.c").write_text(main)
    for options in ((*STRICT, "-c", "model.c"), (*STRICT, "-c", "model_casadi.c"), ("-std=c99", "main.c", "model.o", "-o", "program", "-lm")):
        built = subprocess.run(["cc", *options], cwd=place, capture_output=True, text=True)
        if built.returncode:
            return [built.stderr.strip().splitlines()[0]]
    lines = []
    for state in model["states"]:
        numbers, values, of_inputs = iter(state["params"].split()), [], []
        for field in model["fields"]:
            (of_inputs if field["input"] else values).extend(next(numbers) for _ in range(size(field)))
        lines.append(" ".join([*values, state["t"], state["q"], state["qd"], *of_inputs, state["trial"]]))
    ran = subprocess.run([place / "program"], input="\n".join(lines), capture_output=True, text=True)
    found = ran.stdout.splitlines()
    if ran.returncode or len(found) != len(QUANTITIES) * len(lines):
        return [f"the program ended with {ran.returncode} and {len(found)} lines"]
    problems = []
    for i, state in enumerate(model["states"]):
        for name, line in zip(QUANTITIES, found[len(QUANTITIES) * i :]):
            if name not in state["values"]:
                continue
            pairs = list(zip(map(float, line.split()), map(float, state["values"][name].split()), strict=True))
            error = max((abs(x - y) if x != y else 0.0 for x, y in pairs), default=0.0)
            relative = error / float(state["tolerances"][name]) if error else 0.0
            # Not a number is wrong, too.
            if not relative <= 1.0:
                problems.append(f"{name} at state {i}: {pairs}, tolerance {state['tolerances'][name]}")
            else:
                nearest[name] = max(nearest[name], relative)
    return problems
