"""Functions that are steep: logistic functions and their integrals, with slopes from 1 to 10⁴ and arguments to ±800."""

from kinds import kind
from kinds.pieces import chance, coordinates, diagonal, sum_of
from motions.reference import Asked
import tree
from tree import atan, cos, cosh, dot, exp, ln, sqrt, tanh

SLOPES = (1, 3, 20, 50, 100, 1000, 10000)
FARTHEST = 800.0


def softplus(a):
    return ln(1 + exp(a))


def logistic(a):
    return 1 / (1 + exp(-a))


def gentle(rng, a, width):
    """Such a function of a, which is x/width, without an overflow at arguments of ±800."""
    return rng.choice((
        lambda: softplus(a), lambda: softplus(-a), lambda: width * softplus(a), lambda: logistic(a), lambda: logistic(-a), lambda: 1 - logistic(a),
        lambda: tanh(a), lambda: ln(cosh(a)), lambda: width * ln(cosh(a)), lambda: 0.5 * (1 + tanh(a)), lambda: a * width * logistic(a), lambda: ln(exp(a) + 1),
        lambda: exp(a) / (1 + exp(a)), lambda: 1 / (exp(a) + 1), lambda: tanh(a) ** 2, lambda: sqrt(1 + a**2), lambda: atan(a), lambda: a * tanh(a),
    ))()


def built(rng, a, b):
    """Functions of steep functions."""
    return rng.choice((
        lambda: 1 / (1 + logistic(a)), lambda: tanh(2 * tanh(a)), lambda: tanh(tanh(tanh(a))), lambda: logistic(5 * logistic(a) - 2), lambda: softplus(softplus(a)),
        lambda: softplus(3 * tanh(a)), lambda: ln(cosh(2 * tanh(a))), lambda: exp(-a) / (1 + exp(-a)) ** 2, lambda: 1 / cosh(a) ** 2, lambda: exp(-(a**2)),
        lambda: logistic(a) * logistic(-a), lambda: logistic(a) * (1 - logistic(b)), lambda: ln(exp(a) + exp(b)), lambda: softplus(a) - softplus(b), lambda: tanh(a) * tanh(b),
        lambda: ln(1 + exp(a) + exp(b)), lambda: (logistic(a) - 0.5) ** 3, lambda: ln(2 + tanh(a)), lambda: sqrt(logistic(a)), lambda: 1 / (1 + 1 / (1 + exp(-a))),
        lambda: ln(cosh(a) + 1), lambda: a / (1 + exp(-b)), lambda: (exp(a) - exp(-a)) / (exp(a) + exp(-a)),
    ))()


def argument(m, rng, x, farthest):
    """slope · (x − center), by a number or a parameter, and its width; x is drawn so that it goes as far as that."""
    slope = rng.choice(SLOPES)
    center = rng.choice((0, 0, 0.25, -0.5))
    reach = min(farthest / slope, 6 * farthest)
    near = min(reach, 8 / slope)

    def draw(rng):
        width = rng.choice((near, near, reach))
        return center + rng.uniform(-width, width)

    m.q_draw[x.data] = draw
    shifted = x - center if center else x
    if chance(rng, 0.3):
        return rng.choice((lambda: shifted / tree.node(1.0 / slope) if slope in (1, 20, 50, 100, 1000, 10000) else slope * shifted, lambda: -slope * shifted))(), 1.0 / slope
    return slope * shifted, 1.0 / slope


def placed(m, rng, qs, functions, rates):
    """The functions in the energies and forces of the model."""
    m.taylor = True
    m.kinetic.append(diagonal(m, rng, qs))
    for i, f in enumerate(functions):
        x = rng.choice(qs)
        lot = rng.randrange(4)
        k = m.parameter(f"k{i}", draw="positive") if lot != 2 else None
        if lot == 0:
            m.potential.append(k * f)
        elif lot == 1:
            m.force(x.data, k * f * rng.choice((1, cos(x), dot(x))))
        elif lot == 2:
            m.kinetic.append(0.5 * (1.5 + tanh(f)) * dot(x) ** 2)
        else:
            m.potential.append(0.5 * k * f**2)
    if chance(rng, 0.4):
        slow = rng.choice((1, 20, 100, 300)) * rng.choice(rates)
        m.force(rng.choice(qs).data, -0.5 * rng.choice((lambda: tanh(slow), lambda: 2 * logistic(slow) - 1, lambda: softplus(slow) / 100))())
    m.output("value", sum_of(functions))
    m.wide = True


@kind
def steep(m, rng):
    """One or two of them, to arguments of ±800."""
    qs = coordinates(m, rng, 1, 2)
    functions = [gentle(rng, *argument(m, rng, x, FARTHEST)) for x in qs]
    placed(m, rng, qs, functions, [dot(x) for x in qs])


@kind
def steep_towers(m, rng):
    """Functions of them, of which a power or a product may overflow far off: arguments to ±150."""
    qs = coordinates(m, rng, 1, 2)
    arguments = [argument(m, rng, x, 150.0)[0] for x in qs]
    functions = [built(rng, a, rng.choice(arguments)) for a in arguments]
    placed(m, rng, qs, functions, [dot(x) for x in qs])


@kind
def steep_motions(m, rng):
    """Motions across the steep part and far from it."""
    qs = coordinates(m, rng, 1, 2)
    m.taylor = True
    m.kinetic.append(diagonal(m, rng, qs))
    fastest = 1
    for x in qs:
        # What is steeper is passed within a fraction of a step, and no method that samples sees it.
        slope = rng.choice(SLOPES[:3])
        fastest = max(fastest, slope)
        width = 1.0 / slope
        f = rng.choice((lambda: width * softplus(slope * x), lambda: width * ln(cosh(slope * x)), lambda: width * logistic(slope * x), lambda: 0.3 * width * tanh(slope * x),
                        lambda: width * softplus(-(slope * x)), lambda: width * softplus(3 * tanh(slope * x))))()
        m.potential.append(m.parameter("k", draw="positive") * f)
        if chance(rng, 0.5):
            m.potential.append(0.5 * x**2)
        reach = min(FARTHEST / slope, 2.0)
        m.q_draw[x.data] = (-reach, reach)
    if chance(rng, 0.5):
        m.force(qs[0].data, -0.3 * tanh(rng.choice((3, 20)) * dot(qs[0])))
        fastest = max(fastest, 20)
    m.motion = Asked((0.3, 1.0) if fastest >= 20 else (1.0, 4.0), states=6, step=1.0 / 32)
