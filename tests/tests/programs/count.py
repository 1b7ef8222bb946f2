#!/usr/bin/env python3
"""Counts the lines of each program, and the names of `lagrangian` that it mentions.

    python3 tests/tests/programs/count.py

A program is the body of its function, formatted by rustfmt; declarations of models and imports do not count. A name is a
type, trait, function, method or variant that is public in `runtime/src`; constants that a declaration emits are names of
the user's. Names of the standard library and of nalgebra are left out.
"""

import pathlib
import re

HERE = pathlib.Path(__file__).resolve().parent
SOURCES = next(folder for folder in HERE.parents if (folder / "runtime").is_dir()) / "runtime" / "src"

# Methods of the standard library and of nalgebra whose names `lagrangian` has, too.
OTHERS = set(
    "abs as_ref break clamp clone collect count expect fold from from_re get identity into into_iter iter len map max min new "
    "next norm sin cos sqrt sum to_string unwrap zip load store f64 i32 Vector4 Matrix4 Matrix1 Break Continue Ok report from_str Ball Top".split()
)


def public_names():
    """All names of items of the crate, methods of traits and variants included."""
    names = set()
    item = re.compile(r"\b(?:pub (?:const )?(?:fn|struct|enum|trait|type)|fn|struct|enum|trait) ([A-Za-z_]\w*)")
    variant = re.compile(r"^    ([A-Z]\w*)(?:\(|,| \{)", re.M)
    for path in SOURCES.rglob("*.rs"):
        text = path.read_text(encoding="utf-8").split("#[cfg(test)]")[0]
        names.update(item.findall(text))
        names.update(variant.findall(text))
    return names


def body(text):
    """The lines of the function `program`, without its braces."""
    lines = text.split("\n")
    first = next(i for i, line in enumerate(lines) if "fn program" in line)
    opening = next(i for i in range(first, len(lines)) if lines[i].endswith("{"))
    closing = next(i for i in range(opening, len(lines)) if lines[i] == "}")
    return [line for line in lines[opening + 1 : closing] if line.strip()]


def mentioned(lines, names):
    """Types, calls and paths that are names of the crate, a constructor by the name of its type."""
    text = re.sub(r'"[^"]*"', '""', "\n".join(lines))
    words = set(re.findall(r"\b[A-Z]\w*[a-z]\w*\b", text))
    words.update(re.findall(r"(?:\.|::|\b)([a-z_]\w*)(?:::<[^>]*>)?\(", text))
    return sorted((words & names) - OTHERS)


def count(folder, names):
    """Prints the programs of a folder."""
    total, all_names = 0, set()
    files = sorted(path for path in folder.glob("*.rs") if path.stem not in ("main", "models", "names"))
    for path in files:
        lines = body(path.read_text(encoding="utf-8"))
        found = mentioned(lines, names)
        total += len(lines)
        all_names.update(found)
        print(f"{path.stem:28} {len(lines):3} lines {len(found):3} names: {', '.join(found)}")
    print(f"{len(files)} programs, {total} lines, {len(all_names)} names: {', '.join(sorted(all_names))}")


def main():
    count(HERE, public_names())


if __name__ == "__main__":
    main()
