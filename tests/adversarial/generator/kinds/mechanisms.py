"""Mechanisms of links: joints that turn, slide or do both, gears, branches, free bases, motors behind gears."""

from kinds import kind
from kinds.bodies import orientation
from kinds.pieces import chance
import tree
from tree import angular_velocity, column, cos, dot, homogeneous, rotation, sin, t, view

ANGLES = ("phi", "theta", "psi")
SPELLINGS = ("positions", "positions", "homogeneous", "along the axes of links", "along inertial axes")
DIRECTIONS = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}


class Link:
    """The axes of a link, its origin, whether a coordinate turns it, and what else the spelling has of it: a homogeneous matrix,
    or its angular velocity and the velocity of its origin."""

    def __init__(self, axes, origin, turns=True, matrix=None, w=None, v=None):
        self.axes = axes
        self.origin = origin
        self.turns = turns
        self.matrix = matrix
        self.w = w
        self.v = v


def velocities_of_base(m, spelling, link):
    """The base as the spelling has it."""
    if spelling == "homogeneous":
        link.matrix = m.define("f", homogeneous(link.axes, link.origin))
    elif spelling != "positions":
        is_inertial = spelling == "along inertial axes"
        link.w = m.define("omega", angular_velocity(link.axes, is_inertial))
        link.v = m.define("v", dot(link.origin) if is_inertial else link.axes.transpose() * dot(link.origin))
    return link


def base(m, rng, spelling):
    """Where the tree begins: a free body, a moving support, or the inertial frame, which has no name."""
    choice = rng.randrange(4)
    if choice == 0:
        m.coordinate("p", 3)
        angles = [m.coordinate(a) for a in ANGLES]
        _, expression = orientation(m, rng, angles)
        link = velocities_of_base(m, spelling, Link(m.define("r", expression), tree.family("p")))
        body(m, rng, "b", link, spelling)
        return link
    if choice == 1:
        rate = m.parameter("rate", draw="rate")
        turned = m.define("r", rotation(rng.choice("xyz"), 0.3 * sin(rate * t)))
        place = m.define("support", [0.2 * cos(rate * t), 0, m.parameter("height")])
        return velocities_of_base(m, spelling, Link(turned, place, False))
    return Link(None, None, False)


def place(m, rng, name):
    """Where a joint is: along an axis, anywhere, at the origin."""
    length = m.parameter(f"l{name}")
    return rng.choice((
        lambda: tree.node([length, 0, 0]), lambda: tree.node([0, 0, -length]), lambda: tree.node([0.3, length, 0]),
        lambda: m.parameter(f"a{name}", (3,)),
    ))()


def body(m, rng, name, link, spelling):
    """A rigid body that is fixed to a link, and sometimes a particle besides: masses and where they are."""
    mass = m.parameter(f"m{name}", draw="positive")
    center = m.parameter(f"c{name}", (3,), draw="unit")
    arm = link.axes * center
    if link.matrix is not None:
        point = (link.matrix * rng.choice((center.push(1), tree.node([center[0], center[1], center[2], 1])))).xyz()
    else:
        point = arm if link.origin is None else link.origin + arm
    point = m.define(f"x{name}", point)
    own = m.parameter(f"i{name}", (3, 3), draw="inertia")
    if spelling == "along inertial axes":
        w, velocity = link.w, link.v + link.w.cross(arm)
        own = link.axes * own * link.axes.transpose()
    elif spelling == "along the axes of links":
        w, velocity = link.w, link.v + link.w.cross(center)
    else:
        w, velocity = angular_velocity(link.axes, chance(rng, 0.15)), dot(point)
    w = m.define(f"w{name}", w)
    spelt = rng.choice((lambda: 0.5 * w.dot(own * w), lambda: 0.5 * (own * w).dot(w), lambda: 0.5 * (w.transpose() * own * w)))
    m.kinetic.append(0.5 * mass * velocity.norm_squared() + spelt())
    if chance(rng, 0.3):
        load = m.parameter(f"load{name}", draw="positive")
        at = m.define(f"y{name}", point + link.axes * tree.node([0, 0.4, 0]))
        m.kinetic.append(0.5 * load * dot(at).norm_squared())
        mass_and_place = [(mass, point), (load, at)]
    else:
        mass_and_place = [(mass, point)]
    return mass_and_place


def joined(m, rng, before, name, q, others, spelling):
    """The link behind a joint: it turns, slides, moves as a screw, or turns with another joint, too."""
    axis = rng.choice("xyz")
    angle = rng.choice((q, q, q, -q, q + 0.4, 0.5 * q))
    if others and chance(rng, 0.2):
        angle = q + m.parameter(f"n{name}") * rng.choice(others)
    own = place(m, rng, name)
    movement = rng.randrange(6)
    turn = rotation(axis, angle)
    rate = dot(angle) * tree.node(list(DIRECTIONS[axis]))
    if movement == 0:
        rate = tree.node([0, 0, 0])
        own = own + q * tree.node(list(DIRECTIONS[axis]))
        turn = rotation(rng.choice("xyz"), 0.7)
    elif movement == 1:
        own = own + m.parameter(f"h{name}") * q * tree.node(list(DIRECTIONS[axis]))
    elif movement == 2:
        turn = rotation(rng.choice("xyz"), m.parameter(f"t{name}")) * turn
    turns = before.turns or movement != 0
    slides = movement in (0, 1)
    if spelling == "homogeneous":
        matrix = homogeneous(turn, own)
        matrix = m.define(f"f{name}", matrix if before.axes is None else before.matrix * matrix)
        axes = m.define(f"r{name}", view(matrix, (0, 0), (3, 3)))
        return Link(axes, m.define(f"o{name}", column(matrix, 3).xyz()), turns, matrix)
    if before.axes is None:
        link = Link(m.define(f"r{name}", turn), m.define(f"o{name}", own), turns)
    else:
        axes = m.define(f"r{name}", before.axes * turn)
        link = Link(axes, m.define(f"o{name}", before.origin + before.axes * own), turns)
    if spelling != "positions":
        velocities(m, rng, before, link, name, (turn, rate, own, slides), spelling)
    return link


def velocities(m, rng, before, link, name, joint, spelling):
    """The velocities of a link by those of the link before."""
    turn, rate, own, slides = joint
    is_inertial = spelling == "along inertial axes"
    own = m.define(f"d{name}", own)
    slide = dot(own) if slides else tree.node([0, 0, 0])
    if before.axes is None:
        w, v = None, slide
    elif is_inertial:
        w, v = before.w, before.v + before.w.cross(before.axes * own) + before.axes * slide
    else:
        w, v = before.w, before.v + rng.choice((before.w.cross(own), -own.cross(before.w))) + slide
    if not is_inertial:
        back = m.define(f"b{name}", turn.transpose())
        w = None if w is None else back * w
        v = back * v
    elif rate.args:
        rate = link.axes * rate
    link.w = m.define(f"omega{name}", rate if w is None else w + rate)
    link.v = m.define(f"v{name}", v)


@kind
def mechanism(m, rng):
    """Up to four links in a chain or a tree."""
    spelling = rng.choice(SPELLINGS)
    links = [base(m, rng, spelling)]
    # A free body is one of the links.
    n = rng.choice((1, 1, 2)) if m.kinetic else rng.choice((2, 3, 3, 4))
    g = m.parameter("g")
    joints = []
    for k in range(n):
        q = m.coordinate(f"q{k}")
        before = links[-1] if k == 0 or chance(rng, 0.7) else rng.choice(links)
        link = joined(m, rng, before, str(k), q, joints, spelling)
        for mass, point in body(m, rng, str(k), link, spelling):
            if chance(rng, 0.9):
                m.potential.append(mass * g * point[2])
        if chance(rng, 0.35):
            ratio = rng.choice((dot(q), m.parameter(f"gear{k}") * dot(q)))
            if joints and chance(rng, 0.4):
                ratio = ratio - 2 * dot(rng.choice(joints))
            m.kinetic.append(0.5 * m.parameter(f"j{k}", draw="positive") * ratio**2)
        links.append(link)
        joints.append(q)
    finish(m, rng, links[-1], joints)


def finish(m, rng, link, joints):
    """Springs, forces, torques, outputs."""
    n = len(joints)
    last, first = tree.name(f"x{n - 1}"), tree.name("x0")
    if chance(rng, 0.4):
        m.potential.append(0.5 * m.parameter("k", draw="positive") * (last - first).norm_squared())
    if chance(rng, 0.3):
        m.potential.append(0.5 * m.parameter("kq", draw="positive") * rng.choice(joints) ** 2)
    if link.turns and chance(rng, 0.4):
        m.force(f"w{n - 1}", m.input("torque", (3,)))
    if chance(rng, 0.4):
        m.force(f"x{n - 1}", m.parameter("pull", (3,)) - 0.2 * dot(last))
    if chance(rng, 0.3):
        m.kinetic.append(m.parameter("drift") * joints[0] * dot(joints[-1]))
    m.output("tip", dot(dot(last)))
