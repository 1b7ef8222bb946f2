"""Motions of which the equations are smooth piece by piece.

Within a piece every branch has one sign. The piece ends where the argument of a branch changes its own, which is found on the
smooth equations of this piece, and the next one begins there with the signs that the arguments have just behind it, unless the new
equations lead them back: then the motion would slide along the jump. Zeros of watched functions are found in the same way, between
the zeros of their rates of change, so that two which are next to each other are found, too.
"""

from dataclasses import dataclass

from derivatives import NoValue
from motions.extrapolation import COLUMNS, step
from motions.numbers import real
from motions.tracing import program

TOLERANCE = 1e-19  # Of one step.
NEAR = 1e-15  # Arguments that are as small as this at a crossing change their signs there, too.
GRAZING = 1e-4  # A minimum of an argument, relative to its size nearby, so small that rounding may decide.
SLOW = 1e-4  # A rate behind a jump, relative to that before it.
FEW = 5  # Columns of the extrapolation by which errors of points within a step are measured.
MARGIN = 10  # Errors of points within a step, relative to those of the points at which they are measured, at most.
MOST_STEPS = 400


class Slides(NoValue):
    """The motion stays where a force jumps: it does not go on."""


class Grazes(NoValue):
    """An argument or a watched function is nearly zero without a crossing, or crosses nearly at rest."""


@dataclass
class Crossed:
    """A zero of a watched function: when, which one, in which direction, its rate of change, and the state there."""

    t: object
    which: int
    rises: bool
    rate: object
    y: list


class Motion:
    """A motion from (t, y), with the times at which branches were `crossings`, states halfway on the last step to each, and the
    `events` of watched functions. `fastest` is the speed, the time and the state at the end of a step with the greatest velocity. Where it slides, it ends at the time `slides`. `programs` has those of other motions with the
    same values of the fields."""

    def __init__(self, model, fields, watched, t, y, tolerance=TOLERANCE, longest=1.0, programs=None):
        self.model, self.fields, self.watched = model, fields, watched
        self.t, self.y, self.tolerance = real(t), [real(x) for x in y], tolerance
        self.crossings, self.halfway, self.events, self.steps = [], [], [], 0
        self.slides = None
        self.fastest = self.speed(), self.t, self.y
        self.programs = {} if programs is None else programs
        self.program = self.recorded(())
        self.longest = real(longest)
        self.h = min(self.longest, real(1) / 8)

    def recorded(self, signs):
        if signs not in self.programs:
            made = program(self.model, self.fields, self.watched, self.t, self.y, signs)
            self.programs[signs] = self.programs[made.signs] = made
        return self.programs[signs]

    def to(self, end):
        """Goes on to the time `end`."""
        end = real(end)
        direction = 1 if end > self.t else -1
        h = abs(self.h) * direction
        self.choose(direction)
        while (end - self.t) * direction > 0 and self.slides is None:
            self.steps += 1
            if self.steps > MOST_STEPS:
                raise NoValue("too many steps")
            h = min(abs(h), self.longest, abs(end - self.t)) * direction
            nodes = [(self.t, self.program(self.t, self.y))]
            see = lambda t, y, out: nodes.append((t, out))
            y, error = step(self.program, self.t, self.y, h, see)
            if error > self.tolerance:
                h *= max(real(1) / 5, (self.tolerance / error) ** (real(1) / 18) * real(0.9))
                continue
            reached = end if abs(end - self.t) <= abs(h) * (1 + real(10) ** -15) else self.t + h
            nodes.append((reached, self.program(reached, y)))
            crossed = self.first_crossing(nodes)
            limit = reached if crossed is None else crossed
            self.find_events(nodes, limit, direction)
            self.check_grazing(nodes, limit, direction)
            if crossed is None:
                self.t, self.y = reached, y
            else:
                self.cross(crossed, direction)
            self.fastest = max(self.fastest, (self.speed(), self.t, self.y), key=lambda state: state[0])
            # The first steps after a crossing are as long as those before it.
            h *= min(real(2), (self.tolerance / max(error, self.tolerance * real(10) ** -9)) ** (real(1) / 18) * real(0.9))
            self.h = h
        self.events.sort(key=lambda e: e.t * direction)
        return self

    def speed(self):
        return max(abs(v) for v in self.y[len(self.y) // 2 :])

    def inside(self, t):
        """What the program says at a time within the step that begins here."""
        return self.program(t, self.state(t))

    def state(self, t, columns=COLUMNS):
        return self.y if t == self.t else step(self.program, self.t, self.y, t - self.t, columns=columns)[0]

    def root(self, low, high, of):
        """The zero of `of(out)` between two times at which its signs differ (Illinois: M. Dowell and P. Jarratt, A modified regula
        falsi method, BIT 11, 1971)."""
        (a, fa), (b, fb) = low, high
        for _ in range(200):
            if fb == fa or abs(b - a) <= real(10) ** -24 * (1 + abs(b)):
                return b
            c = b - fb * (b - a) / (fb - fa)
            fc = of(self.inside(c))
            if fc * fb < 0:
                a, fa = b, fb
            else:
                fa /= 2
            moved, b, fb = abs(c - b), c, fc
            if moved <= real(10) ** -23 * (1 + abs(b)):
                return b
        raise NoValue("no root")

    def first_crossing(self, nodes):
        """The first time behind the start at which the argument of a branch has another sign than in this piece."""
        found = [self.crossing(nodes, k) for k in range(len(self.program.signs))]
        return min((at for at in found if at is not None), key=lambda at: abs(at - self.t), default=None)

    def crossing(self, nodes, k):
        """That of one argument."""
        of = lambda out: out[1][k] * self.program.signs[k]
        exact = lambda node: (node[0], of(self.inside(node[0])))
        for i in range(1, len(nodes)):
            # The points within a step are midpoints that are not extrapolated: their signs are computed again.
            if of(nodes[i][1]) >= 0 or (behind := exact(nodes[i]))[1] >= 0:
                continue
            for node in reversed(nodes[:i]):
                before = exact(node)
                if before[1] > 0 or before[1] == 0 and before[0] != self.t:
                    return self.root(before, behind, of)
                behind = before
            raise Grazes("back at once")
        return None

    def cross(self, t, direction):
        """To the time of a crossing, and to the piece behind it."""
        middle = (t - self.t) / 2
        self.halfway.append((self.t + middle, step(self.program, self.t, self.y, middle)[0]))
        y, _ = step(self.program, self.t, self.y, t - self.t)
        before = self.program.signs
        self.t, self.y = t, y
        try:
            self.choose(direction)
        except Slides:
            self.slides = t
            self.crossings.append(t)
            return
        if self.program.signs == before:
            raise Grazes("no crossing")
        self.crossings.append(t)

    def choose(self, direction):
        """The piece that begins here: arguments that are zero have the signs that they have just behind."""
        old = self.program
        little = direction * abs(self.h) * real(10) ** -5
        ahead, _ = step(old, self.t, self.y, little)
        here, behind = old(self.t, self.y)[1], old(self.t + little, ahead)[1]
        near = [abs(g) < NEAR * (1 + abs(b)) for g, b in zip(here, behind)]
        signs = tuple((1 if b > 0 else -1) if zero else s for zero, b, s in zip(near, behind, old.signs))
        self.program = self.recorded(signs)
        if len(self.program.signs) != len(signs):
            raise NoValue("branches come and go")
        if any(near):
            after, _ = step(self.program, self.t, self.y, little)
            behind_it = self.program(self.t + little, after)[1]
            # What leads away, or back, so slowly that rounding may decide says nothing.
            if any(zero and abs(g) < SLOW * abs(b) for zero, g, b in zip(near, behind_it, behind)):
                raise Grazes("hardly leaves a jump")
            if any(zero and g * s <= 0 for zero, g, s in zip(near, behind_it, signs)):
                raise Slides("slides")

    def find_events(self, nodes, limit, direction):
        if not self.watched:
            return
        errors = self.errors(nodes)
        for k in range(len(self.watched)):
            points = self.watched_points(nodes, errors, k, limit, direction)
            if points[-1][0] != limit:
                out = self.inside(limit)
                points.append((limit, out[2][k], out[3][k]))
            for a, b in zip(points, points[1:]):
                for c, d in self.monotone(k, a, b):
                    # What is zero at a point was crossed before it.
                    if c[1] < 0 <= d[1] or d[1] <= 0 < c[1]:
                        self.events.append(self.crossed(k, c, d))

    def crossed(self, k, c, d):
        at = self.root(c[:2], d[:2], lambda out: out[2][k]) if d[1] != 0 else d[0]
        y = self.state(at)
        out = self.program(at, y)
        value, rate = out[2][k], out[3][k]
        if abs(value) > abs(rate) * real(10) ** -20 * (1 + abs(at)):
            raise NoValue("no root")
        return Crossed(at, k, c[1] < 0, rate, y)

    def errors(self, nodes):
        """The errors of points within a step, of the watched functions and of their rates: measured where a few columns of the
        extrapolation tell them from those of points of one. Points by an even and by an odd number of midpoints have errors of their own."""
        middle, last = len(nodes) // 2, len(nodes) - 2
        errors = [[0] * len(self.watched) for _ in (2, 3)]
        for t, rough in (nodes[middle], nodes[middle + 1], nodes[last]):
            out = self.program(t, self.state(t, columns=FEW))
            for of, part in zip(errors, (2, 3)):
                of[:] = [max(e, abs(a - b)) for e, a, b in zip(of, rough[part], out[part])]
        return errors

    def watched_points(self, nodes, errors, k, limit, direction):
        """The function and its rate within the step; exactly where either is small, and might have another sign."""
        points = []
        for t, out in nodes:
            if (limit - t) * direction < 0:
                break
            if any(abs(out[i][k]) < MARGIN * of[k] for i, of in zip((2, 3), errors)):
                out = self.inside(t)
            points.append((t, out[2][k], out[3][k]))
        return points

    def monotone(self, k, a, b):
        """The parts between two points in which a watched function rises or falls."""
        if a[2] * b[2] >= 0:
            return [(a, b)]
        t = self.root((a[0], a[2]), (b[0], b[2]), lambda out: out[3][k])
        out = self.inside(t)
        middle = t, out[2][k], out[3][k]
        if abs(middle[1]) < real(10) ** -13 * (1 + abs(a[1]) + abs(b[1])):
            raise Grazes("a watched function is tangent to zero")
        return [(a, middle), (middle, b)]

    def check_grazing(self, nodes, limit, direction):
        for k, sign in enumerate(self.program.signs):
            sizes = [abs(out[1][k]) for t, out in nodes if (limit - t) * direction > 0]
            for a, b, c in zip(sizes, sizes[1:], sizes[2:]):
                if b < a and b < c and b < GRAZING * max(a, c):
                    raise Grazes("the argument of a branch is nearly zero")


def motion(model, fields, watched, t, q, v, end, tolerance=TOLERANCE):
    """The motion from a state to a time, with all values of fields given as numbers of mpmath."""
    return Motion(model, fields, watched, t, [*q, *v], tolerance).to(end)
