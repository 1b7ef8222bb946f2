"""The constants of `src/scalar/double_double/constants.rs`, and the table that its tests read.

    python3 double_double_constants.py           prints the constants
    python3 double_double_constants.py table     prints src/scalar/double_double/functions.txt

Needs mpmath, which computes with 120 digits here.
"""

import sys

from mpmath import mp, mpf, nstr

mp.dps = 120


def parts(x, n):
    """The n numbers of binary64 whose sum is nearest to x, the greatest first."""
    found = []
    for _ in range(n):
        found.append(float(x))
        x -= mpf(found[-1])
    return found


def constants():
    print("π/2", parts(mp.pi / 2, 3))
    print("ln 2", parts(mp.log(2), 3))
    print("π", parts(mp.pi, 2))
    for n in range(34):
        print(n, parts(1 / mp.factorial(n), 2))


# Arguments are dyadic, so that decimals have them exactly.
SMALL = ["1e-300"]
NEAR = [x / 1024 for x in (1, 100, 400, 511, 700, 805, 1000, 1023)]
FAR = [x / 64 for x in (65, 100, 201, 333, 500)]
LARGE = [100.5, 1000.25, 31415.75, 1e6 + 0.125]
FUNCTIONS = {
    "sin": NEAR + FAR + LARGE + [3.141592653589793, 710.0],
    "cos": NEAR + FAR + LARGE + [1.5707963267948966, 355.0],
    "tan": NEAR + FAR + LARGE,
    "asin": NEAR,
    "acos": NEAR,
    "atan": NEAR + FAR + LARGE,
    "sinh": NEAR + FAR + [100.5, 690.0],
    "cosh": NEAR + FAR + [100.5, 690.0],
    "tanh": NEAR + FAR + [39.5],
    "asinh": NEAR + FAR + LARGE,
    "acosh": [1 + x for x in NEAR] + FAR + LARGE + [1 + 2.0**-40],
    "atanh": NEAR,
    "exp": NEAR + FAR + [100.5, 690.0, -100.5, -600.25, 0.0],
    "ln": NEAR + FAR + LARGE + [1 + 2.0**-40, 1 - 2.0**-40, 1e300],
    "sqrt": NEAR + FAR + LARGE + [1e300, 1e-290],
}
ODD = ["sin", "tan", "asin", "atan", "sinh", "tanh", "asinh", "atanh"]


def table():
    print("# function, argument (a number of binary64), value: mpmath, by double_double_constants.py")
    for name, arguments in FUNCTIONS.items():
        function = getattr(mp, name)
        for x in arguments + ([-x for x in arguments[:3]] if name in ODD else []):
            print(name, repr(float(x)), nstr(function(mpf(x)), 50, strip_zeros=False))


table() if sys.argv[1:] == ["table"] else constants()
