"""Elliptic integrals of arguments from 1e-300 to 1e300, to seventeen digits.

    python3 extreme_elliptic_integrals.py < extreme_elliptic_integrals.txt

needs mpmath. Writes the lines that it reads, with the integrals of their arguments computed anew with 330 digits.
"""

import sys

import mpmath as mp

mp.mp.dps = 330


def carlson(x, y, z, p):
    """R_F(x, y, z), R_C(x, p) and R_J(x, y, z, p)."""
    return mp.elliprf(x, y, z), mp.elliprc(x, p), mp.elliprj(x, y, z, p)


def third(n, m, sine, cosine):
    """The complete and the incomplete integral of the third kind, for an amplitude between 0 and π."""
    complete = mp.ellippi(n, m)
    incomplete = mp.ellippi(n, mp.atan2(sine, abs(cosine)), m)
    return complete, 2 * complete - incomplete if cosine < 0 else incomplete


COLUMNS = {"carlson": (4, carlson), "third": (4, third)}

for line in sys.stdin:
    name, *numbers = line.split()
    count, integrals = COLUMNS[name]
    arguments = numbers[:count]
    values = integrals(*(mp.mpf(float(number)) for number in arguments))
    print(name, *arguments, *(repr(float(value)).replace("e+", "e") for value in values))
