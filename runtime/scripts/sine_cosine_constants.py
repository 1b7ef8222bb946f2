"""The constants of `src/scalar/sine_cosine.rs`: `python3 runtime/scripts/sine_cosine_constants.py` (needs mpmath).

Prints π/2 in three parts and the minimax polynomials in z = r², |r| ≤ π/4, of

    sin r = r + r z S(z),    cos r = 1 − z/2 + z² C(z).

Remez's exchange in 200 bits makes the greatest relative error of sin r or cos r as small as it can be.
Coefficients are rounded to binary64 from the lowest on, and after each the rest is fitted anew.
"""

from mpmath import cos, floor, log, lu_solve, matrix, mp, mpf, nint, pi, sin, sqrt

mp.prec = 200
# Rounding x · 2/π to a whole number leaves up to this.
LARGEST = (pi / 4 + mpf(2) ** -30) ** 2
COEFFICIENTS = 7


def sine(z):
    """What S is near, and the weight of an error of S in sin r."""
    r = sqrt(z)
    return (sin(r) / r - 1) / z, z * r / sin(r)


def cosine(z):
    """What C is near, and the weight of an error of C in cos r."""
    r = sqrt(z)
    return (cos(r) - 1 + z / 2) / z**2, z**2 / cos(r)


def polynomial(coefficients, z):
    value = mpf(0)
    for c in reversed(coefficients):
        value = value * z + c
    return value


def extrema(error, count):
    """Where |error| is greatest between its changes of sign: `count` points."""
    step = LARGEST / 1000
    grid = [step * (i + 1) for i in range(1000)]
    values = [error(z) for z in grid]
    found, best = [], 0
    for i in range(1, len(grid)):
        if values[i] * values[best] < 0:
            found.append(best)
            best = i
        elif abs(values[i]) > abs(values[best]):
            best = i
    found.append(best)
    while len(found) > count:  # What is left of a coefficient's rounding shows at an end.
        del found[0 if abs(values[found[0]]) < abs(values[found[-1]]) else -1]
    return [vertex(grid, values, i, step) for i in found]


def vertex(grid, values, i, step):
    """The extremum near a point of the grid, of the parabola through it and its neighbours."""
    if not 0 < i < len(grid) - 1:
        return grid[i]
    left, middle, right = values[i - 1 : i + 2]
    return grid[i] + step / 2 * (left - right) / (left - 2 * middle + right)


def remez(target, fixed, free):
    """The coefficients after `fixed` that make the greatest weighted error least, and that error."""
    nodes = [LARGEST * (1 - cos(pi * (2 * i + 1) / (2 * free + 2))) / 2 for i in range(free + 1)]
    for _ in range(6):
        left, right = matrix(free + 1), matrix(free + 1, 1)
        for i, z in enumerate(nodes):
            value, weight = target(z)
            for j in range(free):
                left[i, j] = weight * z ** (len(fixed) + j)
            left[i, free] = (-1) ** i
            right[i] = weight * (value - polynomial(fixed, z))
        solution = list(lu_solve(left, right))
        coefficients = fixed + solution[:free]

        def error(z):
            value, weight = target(z)
            return weight * (value - polynomial(coefficients, z))

        nodes = extrema(error, free + 1)
    return coefficients, abs(solution[free])


def rounded(target):
    fixed, worst = [], None
    for free in range(COEFFICIENTS, 0, -1):
        coefficients, worst = remez(target, fixed, free)
        fixed.append(mpf(float(coefficients[len(fixed)])))
    return fixed, worst


def parts():
    """π/2 = first + second + third: 37 bits each in the first two, so that products with n < 2¹⁶ are exact."""
    first = floor(pi / 2 * 2**36) / mpf(2) ** 36
    second = nint((pi / 2 - first) * mpf(2) ** 73) / mpf(2) ** 73
    return [first, second, mpf(float(pi / 2 - first - second))]


if __name__ == "__main__":
    print("π/2:", *(repr(float(part)) for part in parts()))
    for name, target in [("sine", sine), ("cosine", cosine)]:
        coefficients, worst = rounded(target)
        print(f"{name}, error 2^{float(log(worst, 2)):.1f}:")
        for c in coefficients:
            print(f"    {float(c)!r},")
