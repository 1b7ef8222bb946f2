"""Values and first two derivatives of the elementary functions, to seventeen digits.

    python3 elementary_functions.py > elementary_functions.txt

needs mpmath. Each line has the name, the argument as the bits of a binary64 number that binary32 has too where
the line begins with `32`, and f(x), f'(x) and f''(x) by closed forms that are evaluated with four hundred
digits, of arguments as small as 1e-310 and as large as 1e308: other forms than those of the library.
"""

import struct

import mpmath as mp

mp.mp.dps = 400


def secant(x):
    return 1 / mp.cos(x)


def hyperbolic_secant(x):
    return 2 / (mp.exp(x) + mp.exp(-x))


FUNCTIONS = {
    "sin": (mp.sin, mp.cos, lambda x: -mp.sin(x)),
    "cos": (mp.cos, lambda x: -mp.sin(x), lambda x: -mp.cos(x)),
    "tan": (mp.tan, lambda x: secant(x) ** 2, lambda x: 2 * mp.sin(x) * secant(x) ** 3),
    "asin": (mp.asin, lambda x: 1 / mp.sqrt(1 - x * x), lambda x: x / mp.sqrt(1 - x * x) ** 3),
    "acos": (mp.acos, lambda x: -1 / mp.sqrt(1 - x * x), lambda x: -x / mp.sqrt(1 - x * x) ** 3),
    "atan": (mp.atan, lambda x: 1 / (1 + x * x), lambda x: -2 * x / (1 + x * x) ** 2),
    "sinh": (mp.sinh, mp.cosh, mp.sinh),
    "cosh": (mp.cosh, mp.sinh, mp.cosh),
    "tanh": (
        mp.tanh,
        lambda x: hyperbolic_secant(x) ** 2,
        lambda x: -2 * mp.tanh(x) * hyperbolic_secant(x) ** 2,
    ),
    "asinh": (mp.asinh, lambda x: 1 / mp.sqrt(1 + x * x), lambda x: -x / mp.sqrt(1 + x * x) ** 3),
    "acosh": (mp.acosh, lambda x: 1 / mp.sqrt(x * x - 1), lambda x: -x / mp.sqrt(x * x - 1) ** 3),
    "atanh": (mp.atanh, lambda x: 1 / (1 - x * x), lambda x: 2 * x / (1 - x * x) ** 2),
    "exp": (mp.exp, mp.exp, mp.exp),
    "ln": (mp.log, lambda x: 1 / x, lambda x: -1 / x**2),
    "abs": (abs, mp.sign, lambda x: mp.mpf(0)),
    "signum": (mp.sign, lambda x: mp.mpf(0), lambda x: mp.mpf(0)),
    "sqrt": (mp.sqrt, lambda x: 1 / (2 * mp.sqrt(x)), lambda x: -1 / (4 * mp.sqrt(x) ** 3)),
}

UNIT = ["asin", "acos", "atanh"]
POSITIVE = ["ln", "sqrt"]

SMALL = [1e-310, 2.3e-308, 1e-200, 1e-155, 1e-100, 1e-40, 1e-20, 1e-8, 1e-3, 0.3]
LARGE = [0.75, 1.25, 2.0, 7.5, 19.0, 43.0, 60.0, 88.0, 89.5, 95.0, 240.0, 354.0, 360.0, 709.0, 711.0, 1100.0, 1e4]
LARGE += [1e10, 1e19, 1e25, 1e38, 1e77, 1e100, 1e154, 1e155, 1e200, 1e300, 1.7e308]
SINGLE = [1e-42, 1.5e-38, 1e-30, 1e-12, 1e-5, 0.3]
NEAR_ONE = [0.999, 1 - 2.0**-24, 1 - 2.0**-53]
ABOVE_ONE = [1 + 2.0**-52, 1 + 2.0**-23, 1.001]


def arguments(name, single):
    small = SINGLE if single else SMALL
    large = [x for x in LARGE if not single or x <= 1e38] + ([3.3e38] if single else [])
    if name in UNIT:
        points = small + [x for x in NEAR_ONE if not single or rounded(x) < 1]
    elif name == "acosh":
        points = [x for x in ABOVE_ONE if not single or rounded(x) > 1] + [x for x in large if x > 1]
    else:
        points = small + large
    if name not in POSITIVE + ["acosh"]:
        points = [-x for x in points] + points + ([] if name in ["abs", "signum"] else [0.0])
    return [rounded(x) for x in points] if single else points


def rounded(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def written(value, largest):
    if abs(value) > largest:
        return "inf" if value > 0 else "-inf"
    if abs(value) < mp.mpf(2) ** -1080:
        return "0"
    return mp.nstr(value, 17, min_fixed=0, max_fixed=0)


def main():
    for single in [False, True]:
        largest = mp.mpf(2) ** 128 if single else mp.mpf(2) ** 1024
        for name, columns in FUNCTIONS.items():
            for x in arguments(name, single):
                bits = struct.unpack("Q", struct.pack("d", x))[0]
                values = [written(mp.mpf(column(mp.mpf(x))), largest) for column in columns]
                print("32" if single else "64", name, f"{bits:016x}", *values)


main()
