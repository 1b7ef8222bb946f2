"""Vectors and matrices of numbers, as lists and lists of lists, by their textbook definitions."""

from derivatives import NoValue, apply, reciprocal, value


def is_matrix(x):
    return isinstance(x, list) and isinstance(x[0], list)


def depth(x):
    return (1 + depth(x[0])) if isinstance(x, list) else 0


def entrywise(f, *arrays):
    if isinstance(arrays[0], list):
        return [entrywise(f, *parts) for parts in zip(*arrays, strict=True)]
    return f(*arrays)


def flat(x):
    return [y for part in x for y in flat(part)] if isinstance(x, list) else [x]


def added(terms):
    total = 0
    for x in terms:
        total = total + x
    return total


def transpose(m):
    return [list(row) for row in zip(*m)] if is_matrix(m) else [m]


def multiply(x, y):
    if not isinstance(x, list):
        return entrywise(lambda b: x * b, y)
    if not isinstance(y, list):
        return entrywise(lambda a: a * y, x)
    if is_matrix(y):
        columns = transpose(y)
        product = [[inner(row, column) for column in columns] for row in x]
        return product
    product = [inner(row, y) for row in x]
    # A row times a column is a scalar.
    return product[0] if len(x) == 1 else product


def inner(x, y):
    return added(a * b for a, b in zip(flat(x), flat(y), strict=True))


def cross(x, y):
    return [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]


def cross_matrix(x):
    return [[0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0]]


def minor(m, i, j):
    return [row[:j] + row[j + 1 :] for k, row in enumerate(m) if k != i]


def determinant(m):
    """By the first row (Laplace)."""
    if len(m) == 1:
        return m[0][0]
    return added((-1) ** j * m[0][j] * determinant(minor(m, 0, j)) for j in range(len(m)))


def inverse(m):
    """By the adjugate."""
    over = reciprocal(determinant(m))
    if len(m) == 1:
        return [[over]]
    size = range(len(m))
    return [[(-1) ** (i + j) * determinant(minor(m, j, i)) * over for j in size] for i in size]


def norm(x):
    return apply("sqrt", inner(x, x))


def elementary(axis, angle):
    """The rotation about a coordinate axis."""
    c, s = apply("cos", angle), apply("sin", angle)
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    m = [[1 if a == b else 0 for b in range(3)] for a in range(3)]
    m[i][i], m[i][j], m[j][i], m[j][j] = c, -s, s, c
    return m


def rotation(sequence, angles):
    m = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    for axis, angle in zip(sequence, angles, strict=True):
        m = multiply(m, elementary(axis, angle))
    return m


def vee(m):
    """The vector of the antisymmetric part."""
    return [(m[2][1] - m[1][2]) / 2, (m[0][2] - m[2][0]) / 2, (m[1][0] - m[0][1]) / 2]


def method(name, x, arguments):
    y = arguments[0] if arguments else None
    return {
        "dot": lambda: inner(x, y),
        "cross": lambda: cross(x, y),
        "outer": lambda: [[a * b for b in y] for a in x],
        "component_mul": lambda: entrywise(lambda a, b: a * b, x, y),
        "norm": lambda: norm(x),
        "norm_squared": lambda: inner(x, x),
        "normalize": lambda: entrywise(lambda a: a / norm(x), x),
        "sum": lambda: added(flat(x)),
        "xyz": lambda: x[:3],
        "push": lambda: [*x, y],
        "product": lambda: product(flat(x)),
        "cross_matrix": lambda: cross_matrix(x),
        "transpose": lambda: transpose(x),
        "trace": lambda: added(x[i][i] for i in range(len(x))),
        "diagonal": lambda: [x[i][i] for i in range(len(x))],
        "determinant": lambda: determinant(x),
        "inverse": lambda: inverse(x),
    }[name]()


def product(factors):
    total = 1
    for x in factors:
        total = total * x
    return total


def solve(m, right):
    """m x = right by elimination with exchange of rows."""
    n = len(m)
    rows = [list(row) + [b] for row, b in zip(m, right)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(value(rows[i][k])))
        if value(rows[pivot][k]) == 0:
            raise NoValue("M is singular")
        rows[k], rows[pivot] = rows[pivot], rows[k]
        over = reciprocal(rows[k][k])
        for i in range(k + 1, n):
            factor = rows[i][k] * over
            rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    x = [0] * n
    for k in reversed(range(n)):
        x[k] = (rows[k][n] - added(rows[k][j] * x[j] for j in range(k + 1, n))) * reciprocal(rows[k][k])
    return x
