"""Bodies that are fields: of all types, one or several, on a fixed point, free, or in a chain."""

from kinds import kind
from kinds.bodies import ANGLES, orientation
from kinds.pieces import chance, decorated
import tree
from tree import angular_velocity, dot, energy_of_body, quantity_of_body, rotation, sin, t

TYPES = ("RigidBody", "PrincipalBody", "SymmetricBody")


def place(m, rng, body, of, r, p, gravity):
    """A body by the clause, or by its energies as functions."""
    if m.gravity is None or chance(rng, 0.6):
        m.gravity = gravity
        m.placed.append((body, of, r, p))
        return
    m.kinetic.append(energy_of_body("kinetic_energy", body, of, r, p))
    m.potential.append(energy_of_body("potential_energy", body, of, r, p, gravity))


def field_of_gravity(m, rng):
    if chance(rng, 0.5):
        return m.parameter("g", (3,))
    return tree.node([0, 0.3 * sin(t), -m.parameter("weight")])


@kind
def body_in_space(m, rng):
    """A body of any type, about a fixed point or free, in angles of any sequence."""
    of = rng.choice(TYPES)
    p = tree.node([0, 0, 0])
    if chance(rng, 0.5):
        m.coordinate("p", 3)
        p = tree.family("p")
    angles = [m.coordinate(a) for a in ANGLES]
    _, expression = orientation(m, rng, angles)
    r = m.define("r", expression)
    body = m.body("solid", of)
    place(m, rng, body, of, r, p, field_of_gravity(m, rng))
    # That of a symmetric body has no product with an axis in every state.
    m.kinetic.append(0.1 * sum((dot(a) ** 2 for a in angles), tree.node(0)))
    mass, center, inertia = (quantity_of_body(body, of, which) for which in ("mass", "center", "inertia"))
    w = m.define("w", angular_velocity(r))
    m.output("momentum", r * (inertia * w) + mass * (r * center))
    decorated(m, rng, angles, 0.3)


@kind
def bodies_on_joints(m, rng):
    """A chain of bodies, those in an array of one type, on joints that turn or slide, and one at the end."""
    n = rng.choice((2, 2, 3))
    of = rng.choice(TYPES)
    m.body("links", of, n)
    gravity = field_of_gravity(m, rng)
    r, origin = tree.node([[1, 0, 0], [0, 1, 0], [0, 0, 1]]), tree.node([0, 0, 0])
    qs = []
    for k in range(n):
        q = m.coordinate(f"q{k}")
        qs.append(q)
        slides = k > 0 and chance(rng, 0.3)
        arm = m.parameter(f"arm{k}", (3,))
        turn = tree.node([[1, 0, 0], [0, 1, 0], [0, 0, 1]]) if slides else rotation(rng.choice("xyz"), q)
        origin = m.define(f"o{k}", origin + r * (tree.node([0, 0, q]) if slides else arm)) if k else origin
        r = m.define(f"r{k}", r * turn) if k else m.define("r0", rotation(rng.choice("xyz"), q))
        place(m, rng, tree.member("links", k), of, r, origin, gravity)
    last = rng.choice(TYPES)
    place(m, rng, m.body("hand", last), last, r, origin + r * m.parameter("grip", (3,)), gravity)
    m.kinetic.append(0.1 * sum((dot(q) ** 2 for q in qs), tree.node(0)))
    m.output("masses", [quantity_of_body(tree.member("links", k), of, "mass") for k in range(n)])
    decorated(m, rng, qs, 0.3)
