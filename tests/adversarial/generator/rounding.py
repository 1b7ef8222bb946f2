"""Numbers whose operations are rounded at random: the result of each is (a ∘ b)(1 + δ), with δ drawn between ±`DEVIATION`.

That is the standard model of floating-point arithmetic, with δ as large as in a format of fewer digits, so that binary64
resolves it (virtual precision: D. S. Parker, Monte Carlo arithmetic, UCLA CSD-970002, 1997). What is lost is in proportion.
Rounded to the nearest number of the format itself, two products that cancel are often equal to the last digit: no loss is
seen, whatever the inputs are moved by, where the same products in another order differ by a unit in their last place.
"""

import random

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
