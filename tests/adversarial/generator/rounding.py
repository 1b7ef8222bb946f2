"""Numbers whose operations are rounded at random: the result of each is (a ∘ b)(1 + δ), with δ drawn between ±`DEVIATION`.

That is the standard model of floating-point arithmetic, with δ as large as in a format of fewer digits, so that binary64
resolves it (virtual precision: D. S. Parker, Monte Carlo arithmetic, UCLA CSD-970002, 1997). What is lost is in proportion.
Rounded to the nearest number of the format itself, two products that cancel are often equal to the last digit: no loss is
seen, whatever the inputs are moved by, where the same products in another order differ by a unit in their last place.
"""

import random
from fractions import Fraction

from mpmath import mp, mpf

from foreign import Foreign

UNIT = 2.0**-53
SCALE = 32.0
DEVIATION = SCALE * UNIT


class Rounded(float):
    """Such a number. −x, sums with 0 and products with ±1 are exact."""

    __slots__ = ()
    rng = random.Random(0)

    @staticmethod
    def off(x):
        return Rounded(x * (1 + DEVIATION * Rounded.rng.uniform(-1, 1)))

    def __neg__(self):
        return Rounded(float.__neg__(self))


def define(name, is_exact):
    exactly = getattr(float, name)

    def operation(self, other):
        result = exactly(self, other)
        if result is NotImplemented:
            return result
        return Rounded(result) if is_exact(other) else Rounded.off(result)

    setattr(Rounded, name, operation)


for name in ("__add__", "__radd__", "__sub__", "__rsub__"):
    define(name, lambda other: other == 0)
for name in ("__mul__", "__rmul__", "__truediv__"):
    define(name, lambda other: abs(other) == 1)
define("__rtruediv__", lambda _: False)


class Wide(Foreign):
    """Such a number without a greatest or least exponent, for terms that are beyond the range of binary64 where a sum is not."""

    __slots__ = ("x",)

    def __init__(self, x):
        self.x = mpf(x)

    @staticmethod
    def off(x):
        return Wide(x * (1 + mpf(DEVIATION * Rounded.rng.uniform(-1, 1))))

    def __add__(self, other):
        if not isinstance(other, (Wide, *PLAIN)):
            return NotImplemented
        return self if is_plain(other, 0) else Wide.off(self.x + bare(other))

    def __mul__(self, other):
        if not isinstance(other, (Wide, *PLAIN)):
            return NotImplemented
        return Wide(self.x * bare(other)) if is_plain(other, 1) or is_plain(other, -1) else Wide.off(self.x * bare(other))

    __radd__ = __add__
    __rmul__ = __mul__

    def __sub__(self, other):
        return self + (-other)

    def __rsub__(self, other):
        return (-self) + other

    def __neg__(self):
        return Wide(-self.x)

    def called(self, function):
        if function == "recip":
            return Wide.off(1 / self.x)
        return Wide.off(getattr(mp, {"ln": "log"}.get(function, function))(self.x))

    def __abs__(self):
        return abs(self.x)

    def __float__(self):
        return float(self.x)

    def __lt__(self, other):
        return self.x < bare(other)

    def __gt__(self, other):
        return self.x > bare(other)

    def __le__(self, other):
        return self.x <= bare(other)

    def __ge__(self, other):
        return self.x >= bare(other)

    def __eq__(self, other):
        return self.x == bare(other)

    __hash__ = None


PLAIN = (int, float, mpf, Fraction)


def bare(x):
    return x.x if isinstance(x, Wide) else x


def is_plain(x, number):
    return not isinstance(x, Wide) and x == number
