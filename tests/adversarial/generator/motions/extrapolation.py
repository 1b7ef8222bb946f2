"""One step of a differential equation y' = f(t, y) with smooth f, to many digits.

The midpoint rule with n = 2, 4, 6, … parts, whose error is a series in n⁻², extrapolated to n = ∞ (W. B. Gragg, On extrapolation
algorithms for ordinary initial value problems, SIAM J. Numer. Anal. 2, 1965; E. Hairer, S. P. Nørsett and G. Wanner, Solving
Ordinary Differential Equations I, 2nd edition 1993, section II.9).
"""

from motions.numbers import real

COLUMNS = 9


def midpoint(f, t, y, h, parts, see=None):
    """y at t + h by that many parts; `see(t, y, f(t, y))` has every point between."""
    part = h / parts
    before, slope = y, f(t, y)
    here = [a + part * b for a, b in zip(y, slope[0])]
    for k in range(1, parts):
        at = t + k * part
        slope = f(at, here)
        if see:
            see(at, here, slope)
        double = 2 * part
        before, here = here, [a + double * b for a, b in zip(before, slope[0])]
    return here


def step(f, t, y, h, see=None, columns=COLUMNS):
    """y at t + h, and the difference of the last two extrapolations relative to 1 + |y|."""
    table = []
    for k in range(1, columns + 1):
        row = [midpoint(f, t, y, h, 2 * k, see if k == columns else None)]
        for j, before in enumerate(table):
            factor = real(k * k) / ((k - j - 1) ** 2) - 1
            row.append([a + (a - b) / factor for a, b in zip(row[j], before)])
        table = row
    error = max(abs(a - b) / (1 + abs(a)) for a, b in zip(table[-1], table[-2]))
    return table[-1], error
