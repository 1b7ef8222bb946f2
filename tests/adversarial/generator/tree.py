"""The abstract tree of a declaration: what `spelling` prints and `evaluation` evaluates, with no knowledge of either."""

from dataclasses import dataclass, field
from fractions import Fraction


class E:
    """A node: an operation, its arguments (nodes), and what else it needs (names, indices, numbers)."""

    __slots__ = ("op", "args", "data")

    def __init__(self, op, *args, data=None):
        self.op, self.data = op, data
        self.args = tuple(node(a) for a in args)

    def __add__(self, other):
        return E("add", self, other)

    def __radd__(self, other):
        return E("add", other, self)

    def __sub__(self, other):
        return E("sub", self, other)

    def __rsub__(self, other):
        return E("sub", other, self)

    def __mul__(self, other):
        return E("mul", self, other)

    def __rmul__(self, other):
        return E("mul", other, self)

    def __truediv__(self, other):
        return E("div", self, other)

    def __rtruediv__(self, other):
        return E("div", other, self)

    def __neg__(self):
        return E("neg", self)

    def __pow__(self, n):
        """x² is a power; x ** Fraction(1, 2) is `powf`."""
        if isinstance(n, int):
            return E("powi", self, data=n)
        return E("powf", self, n)

    def __getitem__(self, index):
        """A component of a vector or matrix."""
        return E("component", self, data=index if isinstance(index, tuple) else (index,))

    def __getattr__(self, name):
        """`e.norm_squared()`, `e.cross(f)`: methods of vectors and matrices."""
        if name.startswith("_"):
            raise AttributeError(name)
        return lambda *args: E("method", self, *args, data=name)


def node(x):
    if isinstance(x, E):
        return x
    if isinstance(x, (list, tuple)):
        return E("array", *x)
    return E("number", data=Fraction(str(x)) if isinstance(x, float) else Fraction(x))


def name(text):
    """A coordinate, parameter, input or definition."""
    return E("name", data=text)


def member(family, *indices):
    """A member of a family; an index is a number or (variable, offset)."""
    return E("member", data=(family, indices))


def call(function, *args):
    return E("call", *args, data=function)


def dot(e):
    return E("dot", e)


def reaction(constraint, *indices):
    """The multiplier of a constraint, or of a member of a family of them."""
    return E("reaction", data=(constraint, indices))


def total(variable, low, high, body, inclusive=False):
    """`(low..high).map(|variable| body).sum()`; `high` may be (variable, offset)."""
    return E("sum", body, data=(variable, low, high, inclusive))


def row(variable, low, high, body):
    """`(low..high).map(|variable| body).collect()`."""
    return E("collect", body, data=(variable, low, high, False))


def family(of):
    """`vector(theta)`."""
    return E("family", data=of)


def rotation(sequence, *angles):
    return E("rotation", *angles, data=sequence)


def angular_velocity(r, inertial=False):
    return E("angular_velocity", r, data=inertial)


def angular_velocity_of(sequence, *angles, inertial=False):
    return E("angular_velocity_of", *angles, data=(sequence, inertial))


def homogeneous(r, p):
    return E("homogeneous", r, p)


def view(matrix, first, size):
    """The block of a matrix that begins with an element and has so many rows and columns."""
    return E("view", matrix, data=(*first, *size))


def column(matrix, j):
    return E("column", matrix, data=j)


def number_of_body(body, i):
    """One of the numbers of a body, in the order in which its `map` visits them. It has no spelling."""
    return E("number_of_body", body, data=i)


def quantity_of_body(body, kind, quantity):
    """`body.mass`, `body.center`, `body.inertia` of a body of this type."""
    return E("quantity_of_body", body, data=(kind, quantity))


def energy_of_body(function, body, kind, *place):
    """`kinetic_energy(body, r, p)`, `potential_energy(body, r, p, gravity)`."""
    return E("energy_of_body", body, *place, data=(function, kind))


def functions():
    """sin, cos, … as Python functions of nodes."""
    names = "sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh exp ln sqrt abs signum recip atan2 min max"
    return {f: (lambda *args, f=f: call(f, *args)) for f in names.split()}


t = E("time")
PI = E("pi")
sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh, exp, ln, sqrt, absolute, signum, recip, atan2, \
    minimum, maximum = functions().values()


@dataclass
class Named:
    """`target[indices] = expression for variable in low..high`."""

    target: str
    expression: E
    indices: tuple = ()
    ranges: tuple = ()


@dataclass
class Field:
    """A parameter or input: its shape is () for a number, (3,) for a vector, (2, 3) for a matrix; `family` is the
    length of an array of them. `draw` says from what its values are drawn, see `draws`."""

    name: str
    shape: tuple = ()
    family: int | None = None
    draw: str = "any"
    input: bool = False
    body: str | None = None  # The name of the type, if it is a body; its shape is then that of its numbers.

    def size(self):
        size = self.family or 1
        for n in self.shape:
            size *= n
        return size


@dataclass
class External:
    """An external function with its derivatives by each argument, as nodes in the arguments."""

    name: str
    arguments: tuple
    value: E
    derivatives: tuple


@dataclass
class Model:
    kind: str
    coordinates: list = field(default_factory=list)  # (name, number of members or None)
    fields: list = field(default_factory=list)
    functions: list = field(default_factory=list)
    definitions: list = field(default_factory=list)
    kinetic: list = field(default_factory=list)
    potential: list = field(default_factory=list)
    lagrangian: E | None = None
    dissipation: list = field(default_factory=list)
    forces: list = field(default_factory=list)
    outputs: list = field(default_factory=list)
    q_draw: dict = field(default_factory=dict)
    placed: list = field(default_factory=list)  # (body, its type, r, p) of the clause `body`.
    gravity: E | None = None
    # The coordinates that are ignorable, by name; then there is a reduced model, in half angles or not.
    ignorable: list = field(default_factory=list)
    half_angles: bool = False
    constraints: list = field(default_factory=list)
    nonholonomic: list = field(default_factory=list)
    events: list = field(default_factory=list)
    taylor: bool = False
    energy_balance: bool = False
    # Whether its terms may be beyond the range of binary64 where it is not.
    wide: bool = False
    # What is integrated, and how it is compared; none if the model is evaluated at states alone.
    motion: object = None
    # States to evaluate besides drawn ones: dictionaries of `q`, `v`, and parameters.
    states: list = field(default_factory=list)

    def coordinate_labels(self):
        return [(c, i) for c, size in self.coordinates for i in ([None] if size is None else range(size))]

    def ignorable_places(self):
        return [i for i, (c, _) in enumerate(self.coordinate_labels()) if c in self.ignorable]

    def coordinate(self, text, size=None):
        self.coordinates.append((text, size))
        return name(text)

    def unused(self, text):
        """The name, or one like it where it is taken."""
        taken = {f.name for f in self.fields} | {c for c, _ in self.coordinates} | {d.target for d in self.definitions}
        return text if text not in taken else next(text + c for c in "abcdefghijklmnop" if text + c not in taken)

    def parameter(self, text, shape=(), family=None, draw="any"):
        text = self.unused(text)
        self.fields.append(Field(text, shape, family, draw))
        return name(text)

    def body(self, text, kind, family=None):
        text = self.unused(text)
        numbers = {"RigidBody": 10, "PrincipalBody": 4, "SymmetricBody": 4}[kind]
        self.fields.append(Field(text, (numbers,), family, kind, body=kind))
        return name(text)

    def all_kinetic(self):
        """With what the clause `body` stands for."""
        return self.kinetic + [energy_of_body("kinetic_energy", *placed) for placed in self.placed]

    def all_potential(self):
        if self.gravity is None:
            return self.potential
        return self.potential + [energy_of_body("potential_energy", *placed, self.gravity) for placed in self.placed]

    def input(self, text, shape=()):
        text = self.unused(text)
        self.fields.append(Field(text, shape, None, "any", True))
        return name(text)

    def define(self, text, expression, indices=(), ranges=()):
        self.definitions.append(Named(text, node(expression), indices, ranges))
        return name(text)

    def force(self, text, expression, indices=(), ranges=()):
        self.forces.append(Named(text, node(expression), indices, ranges))

    def constraint(self, text, expression, indices=(), ranges=()):
        self.constraints.append(Named(text, node(expression), indices, ranges))
        return reaction(text)

    def slip(self, text, expression, indices=(), ranges=()):
        """A nonholonomic constraint."""
        self.nonholonomic.append(Named(text, node(expression), indices, ranges))
        return reaction(text)

    def is_constrained(self):
        return bool(self.constraints or self.nonholonomic)

    def event(self, text, expression):
        self.events.append(Named(text, node(expression)))

    def output(self, text, expression):
        self.outputs.append(Named(text, node(expression)))
