"""Numbers that carry derivatives, by forward differentiation over any field of numbers.

`Dual` is a + b ε with ε² = 0, over whatever a and b are; nested duals give higher derivatives. `Jet` has the gradient
and those second derivatives of which one is by a velocity, which is what Lagrange's equations consist of. A constant
stands bare. Every number has a level; of two numbers, the one of the lower level is a constant to the other.

The derivative of each elementary function stands once, in `SLOPES`; everything else follows from it.
(A. Griewank and A. Walther, Evaluating Derivatives, 2008, chapters 3 and 13.)
"""

import math
from contextlib import contextmanager
from fractions import Fraction

from mpmath import mp, mpf

from foreign import Foreign
from rounding import Rounded


class NoValue(ValueError):
    """An expression has no value here, or is too near to a kink."""


KINK = 1e-3  # What is compared differs by more than this relative to both, and by more than `FLOOR`.
FLOOR = 1e-5


def level(x):
    return getattr(x, "level", -1)


def value(x):
    """The number without its derivatives."""
    while level(x) >= 0:
        x = x.a
    return x


class Number:
    """Operators from `plus`, `times` and `scaled`."""

    __slots__ = ()

    def __add__(self, other):
        if level(other) > self.level:
            return other.shifted(self)
        return self.plus(other) if level(other) == self.level else self.shifted(other)

    def __mul__(self, other):
        if level(other) > self.level:
            return other.scaled(self)
        return self.times(other) if level(other) == self.level else self.scaled(other)

    __radd__ = __add__
    __rmul__ = __mul__

    def __neg__(self):
        return self.scaled(-1)

    def __sub__(self, other):
        return self + (-other)

    def __rsub__(self, other):
        return (-self) + other

    def __truediv__(self, other):
        return self * reciprocal(other)

    def __rtruediv__(self, other):
        return reciprocal(self) * other


class Dual(Number):
    __slots__ = ("a", "b", "level")

    def __init__(self, a, b, level):
        self.a, self.b, self.level = a, b, level

    def plus(self, other):
        return Dual(self.a + other.a, self.b + other.b, self.level)

    def shifted(self, c):
        return Dual(self.a + c, self.b, self.level)

    def times(self, other):
        return Dual(self.a * other.a, self.a * other.b + self.b * other.a, self.level)

    def scaled(self, c):
        return Dual(self.a * c, self.b * c, self.level)

    def mapped(self, function):
        return Dual(apply(function, self.a), SLOPES[function](self.a) * self.b, self.level)


class Jet(Number):
    """`a`, first derivatives by variable, and second ones by pairs (i, j), i ≤ j, with i < `velocities`."""

    __slots__ = ("a", "first", "second", "velocities")
    level = 1

    def __init__(self, a, first, second, velocities):
        self.a, self.first, self.second, self.velocities = a, first, second, velocities

    def plus(self, other):
        return Jet(self.a + other.a, merged(self.first, other.first), merged(self.second, other.second), self.velocities)

    def shifted(self, c):
        return Jet(self.a + CONSTANT[0](c), self.first, self.second, self.velocities)

    def scaled(self, c):
        c = CONSTANT[0](c)
        first = {i: x * c for i, x in self.first.items()}
        return Jet(self.a * c, first, {ij: x * c for ij, x in self.second.items()}, self.velocities)

    def times(self, other):
        left, right = self.scaled(other.a), other.scaled(self.a)
        second = merged(left.second, right.second)
        self.gather(second, other.first, 1)
        return Jet(left.a, merged(left.first, right.first), second, self.velocities)

    def gather(self, second, others, factor):
        """Adds the products of first derivatives, symmetrized, to the second ones."""
        for i, x in self.first.items():
            for j, y in others.items():
                pair = (i, j) if i <= j else (j, i)
                if pair[0] < self.velocities:
                    term = x * y * factor
                    term = term + term if i == j else term
                    second[pair] = second[pair] + term if pair in second else term

    def mapped(self, function):
        probe = SLOPES[function](Dual(self.a, 1, 0.5))
        slope, curvature = (probe.a, probe.b) if level(probe) == 0.5 else (probe, 0)
        jet = self.scaled(slope)
        second = dict(jet.second)
        if isinstance(curvature, Number) or curvature != 0:
            # Each pair occurs twice, a square is doubled: one half makes up for both.
            self.gather(second, self.first, curvature * half(self.a))
        return Jet(apply(function, self.a), jet.first, second, self.velocities)


def half(like):
    """½ in the same arithmetic."""
    return mpf(0.5) if isinstance(value(like), mpf) else 0.5


def merged(left, right):
    if not right:
        return dict(left)
    if not left:
        return dict(right)
    total = dict(left)
    for key, x in right.items():
        total[key] = total[key] + x if key in total else x
    return total


def reciprocal(x):
    if isinstance(x, Number):
        return x.mapped("recip")
    if x == 0:
        raise NoValue("division by zero")
    if isinstance(x, Foreign):
        return x.called("recip")
    return 1 / x if isinstance(x, (mpf, Fraction, Rounded)) else 1 / float(x)


def apart(x, y):
    """Whether x and y can be told apart where a function has a kink at x = y."""
    if abs(x - y) <= max(FLOOR, KINK * max(abs(x), abs(y)) if y != 0 else 0):
        raise NoValue("a kink is near")


class Decisions:
    """Signs that branches have, whatever their arguments are, and the arguments."""

    def __init__(self, signs):
        self.signs, self.arguments = list(signs), []

    def sign(self, x):
        if len(self.arguments) == len(self.signs):
            self.signs.append(1 if x > 0 else -1)
        self.arguments.append(x)
        return self.signs[len(self.arguments) - 1]


DECISIONS = [None]
GREATEST = [1e150]  # What an elementary function may be: beyond, its square has no number in binary64.


@contextmanager
def recorded(signs):
    """While branches have the given signs, and beyond these those of their arguments."""
    DECISIONS[0] = Decisions(signs)
    try:
        yield DECISIONS[0]
    finally:
        DECISIONS[0] = None


def side(x):
    """The sign of x, where a function has a kink or a jump at zero."""
    if DECISIONS[0] is not None:
        return DECISIONS[0].sign(value(x))
    apart(value(x), 0)
    return 1 if value(x) > 0 else -1


def bare(function, x):
    """An elementary function of a number without derivatives."""
    if isinstance(x, Foreign):
        return x.called(function)
    library = mp if isinstance(x, mpf) else math
    if function in ("asin", "acos", "atanh") and abs(x) >= 0.998 or function == "acosh" and x <= 1.002:
        raise NoValue(function)
    if function in ("sqrt", "ln") and x <= 0:
        raise NoValue(function)
    if function == "sqrt":
        apart(library.sqrt(x), 0)
    if function == "recip":
        return reciprocal(x)
    result = getattr(library, {"ln": "log"}.get(function, function))(x)
    if abs(result) > GREATEST[0]:
        raise NoValue("overflow")
    return Rounded.off(result) if isinstance(x, Rounded) else result


def apply(function, x):
    """An elementary function of one argument."""
    if function in ("abs", "signum"):
        sign = side(x)
        if function == "signum":
            return sign
        return x if sign > 0 else -x
    if isinstance(x, Number):
        return x.mapped(function)
    return bare(function, promoted(x))


def promoted(x):
    """Integers and fractions are exact wherever they meet; functions of them are binary64 unless mpmath is at work."""
    return x if isinstance(x, (mpf, float, Foreign)) else (mpf(x) if PRECISE[0] else float(x))


CONSTANT = [lambda x: x]  # What a constant is beside numbers of the library of motions.
PRECISE = [True]


def select(function, x, y):
    """`min` and `max`."""
    if DECISIONS[0] is None:
        apart(value(x), value(y))
        less = value(x) < value(y)
    else:
        less = side(x - y) < 0
    return x if less == (function == "min") else y


def angle(y, x):
    """`atan2(y, x)`: its slope is that of atan(y/x), or of −atan(x/y)."""
    if value(x) < 0:
        apart(value(y), 0)
    turn = mp.pi * 1 if PRECISE[0] else math.pi
    if abs(value(x)) > abs(value(y)):
        around = 0 if value(x) > 0 else (turn if value(y) > 0 else -turn)
        return apply("atan", y / x) + around
    return apply("atan", x / y) * -1 + (turn / 2 if value(y) > 0 else -turn / 2)


def power(x, n):
    """x to the integer n."""
    if n < 0:
        return reciprocal(power(x, -n))
    result = 1
    for _ in range(n):
        result = result * x
    return result


SLOPES = {
    "sin": lambda x: apply("cos", x),
    "cos": lambda x: apply("sin", x) * -1,
    "tan": lambda x: 1 + power(apply("tan", x), 2),
    "asin": lambda x: reciprocal(apply("sqrt", 1 - x * x)),
    "acos": lambda x: -1 * reciprocal(apply("sqrt", 1 - x * x)),
    "atan": lambda x: reciprocal(1 + x * x),
    "sinh": lambda x: apply("cosh", x),
    "cosh": lambda x: apply("sinh", x),
    "tanh": lambda x: reciprocal(power(apply("cosh", x), 2)),
    "asinh": lambda x: reciprocal(apply("sqrt", 1 + x * x)),
    "acosh": lambda x: reciprocal(apply("sqrt", x * x - 1)),
    "atanh": lambda x: reciprocal(1 - x * x),
    "exp": lambda x: apply("exp", x),
    "ln": lambda x: reciprocal(x),
    "sqrt": lambda x: reciprocal(2 * apply("sqrt", x)),
    "recip": lambda x: -1 * power(reciprocal(x), 2),
}
