"""Equations of motion as straight-line programs: the evaluation of a declaration, recorded once for each choice of its branches.

Numbers that record what is done with them go through `mechanics.Equations`; what they were asked to do is a list of operations
on t, q, v and the fields, which runs many times faster than the tree. Each sign that a branch asks for is given, and its argument
recorded: as long as the arguments keep these signs, the program is the equations of motion, and it is smooth.
"""

from derivatives import recorded
from evaluation import Evaluator, Point
from foreign import Foreign
from mechanics import Equations
from motions.numbers import library, real
from tree import dot


NAMES = {"ln": "log"}


class Traced(Foreign):
    """The result of an operation, with its value where it was recorded."""

    __slots__ = ("tape", "place", "at")

    def __init__(self, tape, place, at):
        self.tape, self.place, self.at = tape, place, at

    def __add__(self, other):
        return self if is_plain(other, 0) else self.tape.add("+", self, other, self.at + bare(other))

    def __radd__(self, other):
        return self if is_plain(other, 0) else self.tape.add("+", self, other, bare(other) + self.at)

    def __sub__(self, other):
        return self if is_plain(other, 0) else self.tape.add("-", self, other, self.at - bare(other))

    def __rsub__(self, other):
        return self.tape.add("-", other, self, bare(other) - self.at)

    def __mul__(self, other):
        if is_plain(other, 0):
            return 0
        return self if is_plain(other, 1) else self.tape.add("*", self, other, self.at * bare(other))

    __rmul__ = __mul__

    def __neg__(self):
        return self.tape.add("neg", self, None, -self.at)

    def called(self, function):
        if function == "recip":
            return self.tape.add("recip", self, None, 1 / self.at)
        return self.tape.add(function, self, None, getattr(library, NAMES.get(function, function))(self.at))

    def __abs__(self):
        return abs(self.at)

    def __lt__(self, other):
        return self.at < bare(other)

    def __gt__(self, other):
        return self.at > bare(other)

    def __eq__(self, other):
        return self.at == bare(other)

    __hash__ = None


def bare(x):
    return x.at if isinstance(x, Traced) else real(x)


def is_plain(x, number):
    return not isinstance(x, Traced) and x == number


class Tape:
    """Operations in order, each once."""

    def __init__(self):
        self.rows, self.known, self.constants = [], {}, []

    def variable(self, value):
        self.rows.append(("variable", None, None))
        return Traced(self, len(self.rows) - 1, real(value))

    def argument(self, x):
        if x is None or isinstance(x, Traced):
            return x if x is None else x.place
        self.constants.append(real(x))
        return f"c{len(self.constants) - 1}"

    def add(self, operation, x, y, at):
        key = operation, key_of(x), key_of(y)
        if key not in self.known:
            self.rows.append((operation, self.argument(x), self.argument(y)))
            self.known[key] = len(self.rows) - 1
        return Traced(self, self.known[key], at)

    def compiled(self, inputs, outputs):
        """A function of the values of the first `inputs` rows that gives the list of outputs."""
        needed, waiting = set(), [x.place for x in outputs if isinstance(x, Traced)]
        while waiting:
            place = waiting.pop()
            if place not in needed:
                needed.add(place)
                waiting += [x for x in self.rows[place][1:] if isinstance(x, int)]
        word = lambda x: x if isinstance(x, str) else f"v{x}"
        lines = [f"def program({', '.join(f'v{i}' for i in range(inputs))}):"]
        for place in sorted(needed):
            operation, x, y = self.rows[place]
            if operation == "variable":
                continue
            if operation in "+-*":
                text = f"{word(x)} {operation} {word(y)}"
            elif operation == "neg":
                text = f"-{word(x)}"
            elif operation == "recip":
                text = f"1 / {word(x)}"
            else:
                text = f"library.{NAMES.get(operation, operation)}({word(x)})"
            lines.append(f"    v{place} = {text}")
        names = ", ".join(f"v{x.place}" if isinstance(x, Traced) else self.argument(x) for x in outputs)
        lines.append(f"    return [{names}]")
        scope = {"library": library, **{f"c{i}": x for i, x in enumerate(self.constants)}}
        exec("\n".join(lines), scope)  # The text is made of the operations above alone.
        return scope["program"]


def key_of(x):
    return x.place if isinstance(x, Traced) else (str(type(x)), str(x))


class Program:
    """Accelerations, arguments of branches, and watched functions with their rates, where branches have the given signs."""

    def __init__(self, accelerations, arguments, signs, watched, rates):
        self.signs, self.n = signs, len(accelerations)
        self.parts = [len(accelerations), len(arguments), len(watched), len(rates)]
        self.outputs = [*accelerations, *arguments, *watched, *rates]

    def compile(self, tape, inputs):
        self.run = tape.compiled(inputs, self.outputs)
        del self.outputs
        return self

    def __call__(self, t, y):
        """The derivative of y = (q, v), the arguments, the watched functions, their rates."""
        out = self.run(t, *y)
        a, g, w, _ = self.parts
        return [*y[self.n :], *out[:a]], out[a : a + g], out[a + g : a + g + w], out[a + g + w :]


def program(model, fields, watched, t, y, signs):
    """The program at these values of the fields, recorded at (t, y); `signs` are those of its branches in the order in which they
    are asked for, and where it has none yet those that they have there."""
    tape = Tape()
    n = len(y) // 2
    at, q, v = tape.variable(t), [tape.variable(x) for x in y[:n]], [tape.variable(x) for x in y[n:]]
    with recorded(signs) as decisions:
        a = Equations(model, at, q, v, fields).a
        of = Evaluator(model, Point(at, q, v, fields, a))
        values = [of(e) for e in watched]
        rates = [of(dot(e)) for e in watched]
    found = Program(a, decisions.arguments, tuple(decisions.signs), values, rates)
    return found.compile(tape, 1 + 2 * n)
