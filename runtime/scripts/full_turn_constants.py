"""The constants of `src/model/whole_periods.rs`: `python3 runtime/scripts/full_turn_constants.py` (needs mpmath).

Prints 2π in four parts for binary64 and for binary32. The first two have about half of the bits of the format. Then in five
parts, of which the first three have as few: the last three of these are the later parts.
"""

from mpmath import frexp, ldexp, mp, nint, pi

mp.prec = 400

for name, bits in (
    ("binary64", [24, 24, 53, 53]),
    ("binary64, later parts", [24, 24, 24, 53, 53]),
    ("binary32", [12, 12, 24, 24]),
    ("binary32, later parts", [12, 12, 12, 24, 24]),
):
    rest = 2 * pi
    print(name)
    for digits in bits:
        mantissa, exponent = frexp(rest)
        part = ldexp(nint(ldexp(mantissa, digits)), int(exponent) - digits)
        assert float(part) == part
        print(f"    {float(part)!r}")
        rest -= part
