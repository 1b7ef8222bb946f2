"""Writes `sine_cosine.txt`: `python3 tests/data/sine_cosine.py > tests/data/sine_cosine.txt` (mpmath 1.3)."""

import math
import random
import struct

from mpmath import cos, mp, mpf, pi, sin

mp.prec = 1400  # The largest arguments have 1024 bits before the point; 60 digits remain.

# The largest argument that is reduced without the library, and its number of quarter turns.
LARGEST = 100_000.0
TURNS = 63_662


def bits(x):
    return struct.pack(">d", x).hex()


def double_double(value):
    high = float(value)
    return bits(high), bits(float(value - mpf(high)))


def neighbours(x, steps):
    low = high = x
    found = [x]
    for _ in range(steps):
        low, high = math.nextafter(low, -math.inf), math.nextafter(high, math.inf)
        found += [low, high]
    return found


def near_multiples(draw):
    """The numbers next to nπ/2: those of all n up to TURNS that are nearest, and some others."""
    mp.prec = 200
    half = pi / 2
    distance = {n: abs(mpf(float(n * half)) / (n * half) - 1) for n in range(1, TURNS + 1)}
    absolute = {n: distance[n] * n for n in distance}
    mp.prec = 1400
    chosen = sorted(distance, key=distance.get)[:60] + sorted(absolute, key=absolute.get)[:120]
    chosen += list(range(1, 17)) + [draw.randint(1, TURNS) for _ in range(40)]
    return [x for n in sorted(set(chosen)) for x in neighbours(float(n * pi / 2), 1)]


def between_multiples(draw):
    """About (n + ½)π/2, where rounding to a whole number is closest to a tie."""
    chosen = list(range(0, 9)) + [draw.randint(0, TURNS - 1) for _ in range(60)]
    return [x for n in chosen for x in neighbours(float((2 * n + 1) * pi / 4), 1)]


def arguments():
    draw = random.Random(1833)
    tiny = [0.0, 5e-324, 1.5e-323, 1e-310, 2.0**-1022, 2.0**-1021, 1e-300, 2.0**-27, 2.0**-26]
    spread = [10 ** draw.uniform(-308, 0) for _ in range(60)] + [10 ** draw.uniform(-8, 0) for _ in range(60)]
    inside = [draw.uniform(0, top) for top in (0.8, 0.8, 7.0, 100.0, 3e3, LARGEST) for _ in range(90)]
    limit = neighbours(LARGEST, 5) + [LARGEST - draw.uniform(0, 3) for _ in range(30)]
    beyond = [float(draw.randint(TURNS, 2**22) * pi / 2) for _ in range(60)]
    beyond += [LARGEST * 10 ** draw.uniform(0, 300) for _ in range(60)]
    beyond += [2.0**k for k in (17, 20, 32, 52, 60, 120, 1023)]
    for x in near_multiples(draw) + between_multiples(draw) + tiny + spread + inside + limit + beyond:
        yield x if draw.random() < 0.5 else -x


if __name__ == "__main__":
    print("# x, then sin x and cos x as sums of two: the bits of binary64 numbers, hexadecimal.")
    for x in [0.0, -0.0, *arguments()]:
        print(bits(x), *double_double(sin(mpf(x))), *double_double(cos(mpf(x))))
