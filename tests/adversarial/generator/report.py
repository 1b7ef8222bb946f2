"""Tables and files of what came out."""

import math
from collections import defaultdict


def motions(model):
    """How many motions of a model are integrated: those of its states that differ in more than in how they are split."""
    if "motion" not in model:
        return 0
    each = [max(1, len(state.get("starts", "").split()) // (2 * model["n"] + 1)) for state in model["states"]]
    if model["motion"]["compared"] == "splits":
        return len({tuple(state[key] for key in ("t", "q", "qd", "params", "end")) for state in model["states"]})
    return sum(each)


class Report:
    def __init__(self):
        self.rows = defaultdict(lambda: {"models": 0, "motions": 0, "states": 0, "compared": 0, "refused": 0, "wrong": set(), "worst": 0.0, "at": ""})
        self.wrong, self.refused = {}, {}
        self.seconds = 0.0
        self.unusable = 0

    def add(self, models, build):
        kinds = {m["id"]: m for m in models}
        self.seconds += build.seconds
        for m in models:
            self.rows[m["kind"]]["models"] += 1
            self.rows[m["kind"]]["states"] += len(m["states"])
            self.rows[m["kind"]]["motions"] += motions(m)
        for name, message in build.refused.items():
            self.rows[kinds[name]["kind"]]["refused"] += 1
            self.refused[name] = kinds[name], message
        for c in build.comparisons:
            self.add_comparison(kinds[c["model"]], c)

    def add_comparison(self, model, c):
        row = self.rows[model["kind"]]
        if c["refused"]:
            if model["id"] not in self.refused:
                row["refused"] += 1
                self.refused[model["id"]] = model, f"{c['quantity']} at state {c['state']} {model['states'][c['state']]}:\n{c['refused']}"
            return
        error, tolerance = float(c["error"]), float(c["tolerance"])
        row["compared"] += 1
        ratio = error / tolerance if tolerance > 0 else (0.0 if error == 0 else math.inf)
        if not ratio <= 1:
            row["wrong"].add(model["id"])
            self.wrong.setdefault(model["id"], (model, []))[1].append(c)
        elif ratio >= row["worst"]:
            row["worst"], row["at"] = ratio, f"{c['quantity']} of {c['model']}"

    def __str__(self):
        lines = [f"{'kind':24}{'models':>7}{'motions':>8}{'states':>7}{'compared':>10}{'refused':>9}{'wrong':>7}   greatest error of those right / tolerance"]
        for kind, row in sorted(self.rows.items()):
            counts = f"{row['models']:7}{row['motions']:8}{row['states']:7}{row['compared']:10}{row['refused']:9}{len(row['wrong']):7}"
            lines.append(f"{kind:24}{counts}   {row['worst']:.2g}  {row['at']}")
        total = sum(row["models"] for row in self.rows.values())
        moving = sum(row["motions"] for row in self.rows.values())
        states = sum(row["states"] for row in self.rows.values())
        compared = sum(row["compared"] for row in self.rows.values())
        lines.append(f"{'all':24}{total:7}{moving:8}{states:7}{compared:10}{len(self.refused):9}{len(self.wrong):7}")
        lines.append(f"{self.unusable} models without a usable state; {self.seconds:.0f} s of compilation")
        return "\n".join(lines)

    def findings(self, folder):
        """A file for each model that is wrong or refused."""
        folder.mkdir(parents=True, exist_ok=True)
        for name, (model, message) in self.refused.items():
            (folder / f"refused_{name}.txt").write_text(f"{model['declaration']}\n{message}\n")
        for name, (model, comparisons) in self.wrong.items():
            lines = [model["declaration"]]
            for c in comparisons:
                state = model["states"][c["state"]]
                given = {key: state[key] for key in ("t", "q", "qd", "params", "end", "starts", "run") if key in state}
                lines.append(f"{c['quantity']} at state {c['state']} {given}:\n    found    {c['found']}\n    expected "
                             f"{c['expected']}\n    error {c['error']}, tolerance {c['tolerance']}")
            (folder / f"wrong_{name}.txt").write_text("\n".join(lines) + "\n")
