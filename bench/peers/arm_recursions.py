"""The recursions of textbooks for an arm of revolute joints, of scalars of any type: inverse dynamics by Newton and Euler (Luh, Walker
and Paul 1980), accelerations by composite bodies (Walker and Orin 1982) with LDLᵀ and by articulated bodies (Featherstone 1983).

A link is {"axis", "place", "first", "second"}: its joint turns about this axis of its own; its origin is at this place in the link before,
along whose joint axes places have been moved; the moments of mass are base inertial parameters, so that masses are zero. Accelerations
are those of origins, with gravity as an upward acceleration of the base. The first angle, about the vertical, does not matter. Turns of a
symmetric block take four products, by the double angle; the velocity products are taken out before bodies are articulated.
"""


def others(k):
    return (k + 1) % 3, (k + 2) % 3


def inward(turn, k, x):
    """Along the axes of the link."""
    (s, c), (a, b), y = turn, others(k), list(x)
    y[a], y[b] = c * x[a] + s * x[b], c * x[b] - s * x[a]
    return y


def outward(turn, k, x):
    """Along the axes of the link before."""
    (s, c), (a, b), y = turn, others(k), list(x)
    y[a], y[b] = c * x[a] - s * x[b], s * x[a] + c * x[b]
    return y


def cross(x, y):
    return [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]


def plus(x, y):
    return [a + b for a, b in zip(x, y)]


def dot(x, y):
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]


def tensor(link):
    """The tensor of inertia about the origin."""
    second = link["second"]
    trace = second[0][0] + second[1][1] + second[2][2]
    return [[(trace if i == j else 0) - second[i][j] for j in range(3)] for i in range(3)]


def wrenches(links, turns, v, accelerations, gravity):
    """The moment about the origin of each link and the force on it, which its motion takes."""
    w, alpha, acceleration, field = [0, 0, 0], [0, 0, 0], [0, 0, gravity], None
    found = []
    for i, link in enumerate(links):
        k = link["axis"]
        a, b = others(k)
        if i:
            acceleration = plus(acceleration, [dot(row, link["place"]) for row in field])
            w, alpha, acceleration = (inward(turns[i], k, x) for x in (w, alpha, acceleration))
        alpha[a], alpha[b] = alpha[a] + w[b] * v[i], alpha[b] - w[a] * v[i]
        if accelerations is not None:
            alpha[k] = alpha[k] + accelerations[i]
        w[k] = w[k] + v[i]
        squares = [x * x for x in w]
        field = [[None] * 3 for _ in range(3)]
        for j in range(3):
            x, y = others(j)
            product = w[x] * w[y]
            field[j][j] = -(squares[x] + squares[y])
            field[y][x], field[x][y] = product + alpha[j], product - alpha[j]
        first, second = link["first"], link["second"]
        moment = cross(first, acceleration)
        for j in range(3):
            x, y = others(j)
            moment[j] = moment[j] + (
                second[x][y] * (squares[y] - squares[x])
                + second[j][x] * field[y][j]
                - second[j][y] * field[x][j]
                + second[x][x] * field[y][x]
                - second[y][y] * field[x][y]
            )
        found.append((moment, [dot(row, first) for row in field]))
    return found


def carried(link, turn, moment, force):
    """A wrench about the origin of the link before, along its axes."""
    force = outward(turn, link["axis"], force)
    return plus(outward(turn, link["axis"], moment), cross(link["place"], force)), force


def inverse_dynamics(links, turns, v, accelerations, gravity):
    found = wrenches(links, turns, v, accelerations, gravity)
    forces, (moment, force) = [None] * len(links), found[-1]
    for i in reversed(range(len(links))):
        forces[i] = moment[links[i]["axis"]]
        if i:
            moment, force = carried(links[i], turns[i], moment, force)
            moment, force = plus(found[i - 1][0], moment), plus(found[i - 1][1], force)
    return forces


def turned_symmetric(turn, k, block):
    """R B Rᵀ."""
    s, c = turn
    a, b = others(k)
    cc, cs = c * c, c * s
    change = cc * (block[a][a] - block[b][b]) - (cs + cs) * block[a][b]
    rows = [list(row) for row in block]
    rows[a][a], rows[b][b] = block[b][b] + change, block[a][a] - change
    rows[a][b] = rows[b][a] = cs * (block[a][a] - block[b][b]) + (2 * cc - 1) * block[a][b]
    column = outward(turn, k, block[k])
    for x in (a, b):
        rows[x][k] = rows[k][x] = column[x]
    return rows


def composite_bodies(links, turns, v, gravity):
    """The moments of inertia of what each joint carries, and LDLᵀ of them from the first joint on."""
    n = len(links)
    forces = inverse_dynamics(links, turns, v, None, gravity)
    mass = [[None] * n for _ in range(n)]
    first, inertia = links[-1]["first"], tensor(links[-1])
    for i in reversed(range(n)):
        k = links[i]["axis"]
        a, b = others(k)
        moment, force = [row[k] for row in inertia], [0, 0, 0]
        force[a], force[b] = -first[b], first[a]
        mass[i][i] = moment[k]
        for j in range(i, 0, -1):
            moment, force = carried(links[j], turns[j], moment, force)
            mass[i][j - 1] = moment[links[j - 1]["axis"]]
        if i == 0:
            break
        place = links[i]["place"]
        first, inertia = outward(turns[i], k, first), turned_symmetric(turns[i], k, inertia)
        twice = dot(first, place) + dot(first, place)
        before = tensor(links[i - 1])
        inertia = [
            [
                before[x][y] + (inertia[x][y] + ((twice if x == y else 0) - first[x] * place[y] - place[x] * first[y]))
                for y in range(3)
            ]
            for x in range(3)
        ]
        first = plus(links[i - 1]["first"], first)
    return solution(mass, [-x for x in forces])


def solution(mass, right):
    """By LDLᵀ; of M, what is below the diagonal."""
    n = len(right)
    lower, reciprocals, y = [[None] * n for _ in range(n)], [], []
    for i in range(n):
        entries = []
        for j in range(i):
            entry = mass[i][j]
            for p in range(j):
                entry = entry - entries[p] * lower[j][p]
            entries.append(entry)
        pivot, rest = mass[i][i], right[i]
        for j in range(i):
            lower[i][j] = entries[j] * reciprocals[j]
            pivot = pivot - entries[j] * lower[i][j]
            rest = rest - lower[i][j] * y[j]
        reciprocals.append(1 / pivot)
        y.append(rest)
    x = [y[i] * reciprocals[i] for i in range(n)]
    for i in reversed(range(n)):
        for j in range(i):
            x[j] = x[j] - lower[i][j] * x[i]
    return x


def articulated_bodies(links, turns, v, gravity):
    n = len(links)
    found = wrenches(links, turns, v, None, gravity)
    gains, (moment, force) = [None] * n, found[-1]
    angular, mixed, linear = body(links[-1])
    for i in reversed(range(n)):
        link, k = links[i], links[i]["axis"]
        a, b = others(k)
        # The opposite of the reciprocal: CasADi turns y (1 / x) into a division each.
        opposite = -1 / angular[k][k]
        own = moment[k] * opposite
        if i == 0:
            gains[0] = (None, None, own)
            break
        of_turning = {x: angular[x][k] for x in (a, b)}
        of_force = list(mixed[k])
        ratios = [of_turning[x] * opposite if x != k else 0 for x in range(3)]
        force_ratios = [x * opposite for x in of_force]
        gains[i] = (ratios, force_ratios, own)
        rest = [[0] * 3 for _ in range(3)]
        for x in (a, b):
            for y in (a, b):
                if x <= y:
                    rest[x][y] = rest[y][x] = angular[x][y] + ratios[x] * of_turning[y]
        mixed = [plus(mixed[x], [ratios[x] * y for y in of_force]) if x != k else [0, 0, 0] for x in range(3)]
        masses = [[None] * 3 for _ in range(3)]
        for x in range(3):
            for y in range(x, 3):
                masses[x][y] = masses[y][x] = linear[x][y] + force_ratios[x] * of_force[y]
        moment = [moment[x] + of_turning[x] * own if x != k else 0 for x in range(3)]
        force = plus(force, [x * own for x in of_force])
        moment, force = carried(link, turns[i], moment, force)
        moment, force = plus(found[i - 1][0], moment), plus(found[i - 1][1], force)
        blocks = moved(link, turns[i], rest, mixed, masses)
        angular, mixed, linear = ([plus(x, y) for x, y in zip(*pair)] for pair in zip(body(links[i - 1]), blocks))
    rates = [gains[0][2]]
    alpha, acceleration = [0, 0, 0], [0, 0, 0]
    alpha[links[0]["axis"]] = rates[0]
    for i in range(1, n):
        k = links[i]["axis"]
        acceleration = plus(acceleration, cross(alpha, links[i]["place"]))
        alpha, acceleration = inward(turns[i], k, alpha), inward(turns[i], k, acceleration)
        ratios, force_ratios, own = gains[i]
        total = own + (dot(ratios, alpha) + dot(force_ratios, acceleration))
        rates.append(total - alpha[k])
        alpha[k] = total
    return rates


def body(link):
    """The inertia of angular and linear acceleration: angular, mixed, linear."""
    x, y, z = link["first"]
    return tensor(link), [[0, -z, y], [z, 0, -x], [-y, x, 0]], [[0] * 3 for _ in range(3)]


def moved(link, turn, angular, mixed, linear):
    """An articulated-body inertia about the origin of the link before, along its axes."""
    k, (s, c), place = link["axis"], turn, link["place"]
    a, b = others(k)
    angular, linear = turned_symmetric(turn, k, angular), turned_symmetric(turn, k, linear)
    cc, cs = c * c, c * s
    difference, total = mixed[a][a] - mixed[b][b], mixed[a][b] + mixed[b][a]
    change, across = cc * difference - cs * total, cs * difference + cc * total
    turned = [list(row) for row in mixed]
    turned[a][a], turned[b][b] = mixed[b][b] + change, mixed[a][a] - change
    turned[a][b], turned[b][a] = across - mixed[b][a], across - mixed[a][b]
    turned[a][k], turned[b][k] = c * mixed[a][k] - s * mixed[b][k], s * mixed[a][k] + c * mixed[b][k]
    turned[k][a], turned[k][b] = c * mixed[k][a] - s * mixed[k][b], s * mixed[k][a] + c * mixed[k][b]
    columns = [plus([row[x] for row in turned], cross(place, linear[x])) for x in range(3)]
    after = [[columns[y][x] for y in range(3)] for x in range(3)]
    sums = [[None] * 3 for _ in range(3)]
    for x in range(3):
        for y in range(x, 3):
            sums[x][y] = sums[y][x] = angular[x][y] + (cross(place, turned[y])[x] + cross(place, after[x])[y])
    return sums, after, linear
