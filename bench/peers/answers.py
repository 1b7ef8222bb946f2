"""Answers the questions of the program, a line of JSON each (see `src/question.rs`)."""

import json
import sys

import numpy as np


def integrated(question, propagate):
    """The fewest seconds of several runs of `propagate(method, tolerance, starts, end)`, its steps and its final states."""
    method, tolerance = question["method"], question["tolerance"]
    starts, end = np.array(question["starts"]), question["end"]
    fewest, together = float("inf"), 0.0
    while together < question["at_least"] or together == 0.0:
        seconds, steps, states = propagate(method, tolerance, starts, end)
        fewest, together = min(fewest, seconds), together + seconds
    return {"seconds": fewest, "steps": int(steps), "states": [state.tolist() for state in states]}


def answer_questions(propagate):
    """Answers until there are no more questions."""
    for line in sys.stdin:
        try:
            answer = {"Ok": integrated(json.loads(line)["Integrate"], propagate)}
        except Exception as error:
            answer = {"Err": f"{type(error).__name__}: {error}"}
        print(json.dumps(answer), flush=True)
