"""Prints a model in the declaration language, as one struct `Model` and its constructor."""

from tree import E

SUM, PRODUCT, UNARY, ATOM = 1, 2, 3, 4
LETTERS = "xyz"


class Printer:
    """Spells what can be spelled in several ways by the lot."""

    def __init__(self, rng):
        self.rng = rng

    def number(self, x):
        if x.denominator == 1:
            return str(x.numerator) if self.rng.random() < 0.3 else f"{x.numerator}.0"
        decimal = repr(float(x))
        if E("number", data=type(x)(decimal)).data == x and "e" not in decimal:
            return decimal
        return f"({x.numerator}.0 / {x.denominator}.0)"

    def index(self, i):
        if isinstance(i, int):
            return str(i)
        variable, offset = i
        return variable if offset == 0 else f"{variable} {'+' if offset > 0 else '-'} {abs(offset)}"

    def at(self, e, least):
        text, precedence = self.spell(e)
        return text if precedence >= least else f"({text})"

    def text(self, e):
        return self.spell(e)[0]

    def spell(self, e):
        return getattr(self, "spell_" + e.op)(e)

    def spell_number(self, e):
        if e.data < 0:
            return "-" + self.number(-e.data), UNARY
        return self.number(e.data), ATOM

    def spell_name(self, e):
        return e.data, ATOM

    def spell_time(self, _):
        return "t", ATOM

    def spell_pi(self, _):
        return "PI", ATOM

    def spell_member(self, e):
        family, indices = e.data
        return family + "".join(f"[{self.index(i)}]" for i in indices), ATOM

    def spell_add(self, e):
        return f"{self.at(e.args[0], SUM)} + {self.at(e.args[1], PRODUCT)}", SUM

    def spell_sub(self, e):
        return f"{self.at(e.args[0], SUM)} - {self.at(e.args[1], PRODUCT)}", SUM

    def spell_mul(self, e):
        return f"{self.at(e.args[0], PRODUCT)} * {self.at(e.args[1], UNARY)}", PRODUCT

    def spell_div(self, e):
        return f"{self.at(e.args[0], PRODUCT)} / {self.at(e.args[1], UNARY)}", PRODUCT

    def spell_neg(self, e):
        return f"-{self.at(e.args[0], UNARY)}", UNARY

    def receiver(self, e):
        """What a method is called on: no literal, whose point would be read with the method's."""
        text = self.at(e, ATOM)
        return f"({text})" if e.op == "number" and not text.startswith("(") else text

    def spell_powi(self, e):
        return f"{self.receiver(e.args[0])}.powi({e.data})", ATOM

    def spell_powf(self, e):
        return f"{self.receiver(e.args[0])}.powf({self.text(e.args[1])})", ATOM

    def spell_call(self, e):
        if self.rng.random() < 0.4 and not e.data.startswith("external"):
            return self.spell_method(e)
        return f"{e.data}({', '.join(self.text(a) for a in e.args)})", ATOM

    def spell_method(self, e):
        first, *rest = e.args
        return f"{self.receiver(first)}.{e.data}({', '.join(self.text(a) for a in rest)})", ATOM

    def spell_dot(self, e):
        return f"dot({self.text(e.args[0])})", ATOM

    def spell_reaction(self, e):
        name, indices = e.data
        return f"reaction({name}{''.join(f'[{self.index(i)}]' for i in indices)})", ATOM

    def spell_array(self, e):
        return f"[{', '.join(self.text(a) for a in e.args)}]", ATOM

    def spell_component(self, e):
        of = self.at(e.args[0], ATOM)
        if len(e.data) == 1 and e.args[0].op != "array":
            i = e.data[0]
            return (f"{of}.{LETTERS[i]}" if i < 3 and self.rng.random() < 0.6 else f"{of}[{i}]"), ATOM
        if len(e.data) == 1:
            return f"{of}[{e.data[0]}]", ATOM
        return f"{of}[({e.data[0]}, {e.data[1]})]", ATOM

    def spell_sum(self, e, end="sum"):
        variable, low, high, inclusive = e.data
        span = f"({self.index(low)}..{'=' if inclusive else ''}{self.index(high)})"
        return f"{span}.map(|{variable}| {self.text(e.args[0])}).{end}()", ATOM

    def spell_collect(self, e):
        return self.spell_sum(e, "collect")

    def spell_family(self, e):
        return f"vector({e.data})", ATOM

    def spell_rotation(self, e):
        return f"rotation_{e.data}({', '.join(self.text(a) for a in e.args)})", ATOM

    def spell_angular_velocity(self, e):
        return f"angular_velocity{'_inertial' if e.data else ''}({self.text(e.args[0])})", ATOM

    def spell_angular_velocity_of(self, e):
        sequence, inertial = e.data
        angles = ", ".join(self.text(a) for a in e.args)
        return f"angular_velocity_{sequence}{'_inertial' if inertial else ''}({angles})", ATOM

    def spell_homogeneous(self, e):
        r, p = (self.text(a) for a in e.args)
        return f"homogeneous({r}, {p})", ATOM

    def spell_view(self, e):
        i, j, rows, columns = e.data
        return f"{self.at(e.args[0], ATOM)}.view(({i}, {j}), ({rows}, {columns}))", ATOM

    def spell_column(self, e):
        return f"{self.at(e.args[0], ATOM)}.column({e.data})", ATOM

    def spell_quantity_of_body(self, e):
        return f"{self.text(e.args[0])}.{e.data[1]}", ATOM

    def spell_energy_of_body(self, e):
        body, *place = (self.text(a) for a in e.args)
        function, place = e.data[0], ", ".join(place)
        if self.rng.random() < 0.3:
            return f"{body}.{function}({place})", ATOM
        return f"{function}({body}, {place})", ATOM


def named(printer, row):
    indices = "".join(f"[{printer.index(i)}]" for i in row.indices)
    ranges = "".join(f" for {v} in {low}..{high}" for v, low, high in row.ranges)
    return f"{row.target}{indices} = {printer.text(row.expression)}{ranges}"


def table(printer, clause, rows):
    if not rows:
        return []
    return [f"    {clause}(", *(f"        {named(printer, row)}," for row in rows), "    ),"]


def declaration(model, rng):
    """The attribute and the struct."""
    printer = Printer(rng)
    coordinates = ", ".join(c if n is None else f"{c}[{n}]" for c, n in model.coordinates)
    lines = ["#[derive(Lagrangian, Clone, Debug)]", "#[lagrangian(", f"    coordinates({coordinates}),"]
    for f in model.functions:
        arguments = ", ".join(f.arguments)
        slopes = "".join(
            f", derivative({a}) = {printer.text(d)}" for a, d in zip(f.arguments, f.derivatives)
        )
        lines.append(f"    function({f.name}({arguments}) = crate::external::{f.name}({arguments}){slopes}),")
    lines += table(printer, "define", model.definitions)
    for clause in ("kinetic", "potential", "dissipation"):
        lines += [f"    {clause} = {printer.text(e)}," for e in getattr(model, clause)]
    if model.placed:
        place = lambda r, p: f"({printer.text(r)}, {printer.text(p)})"
        rows = [f"        {printer.text(body)} = {place(r, p)}," for body, _, r, p in model.placed]
        lines += ["    body(", *rows, "    ),"]
    if model.gravity is not None:
        lines.append(f"    gravity = {printer.text(model.gravity)},")
    if model.lagrangian is not None:
        lines.append(f"    lagrangian = {printer.text(model.lagrangian)},")
    for force in model.forces:
        lines += table(printer, "force", [force])
    lines += table(printer, "constraint", model.constraints)
    lines += table(printer, "nonholonomic", model.nonholonomic)
    lines += table(printer, "output", model.outputs)
    lines += table(printer, "event", model.events)
    lines += [f"    {clause}," for clause in ("taylor", "energy_balance") if getattr(model, clause)]
    if model.ignorable:
        lines.append(f"    routhian(Reduced{', half_angles' if model.half_angles else ''}),")
    lines += [")]", "pub struct Model {"]
    for f in model.fields:
        if f.input:
            lines.append("    #[lagrangian(input)]")
        lines.append(f"    pub {f.name}: {type_of(f)},")
    return "\n".join([*lines, "}", ""])


def type_of(f):
    inner = {0: "f64", 1: "SVector<f64, {}>", 2: "SMatrix<f64, {}, {}>"}[len(f.shape)].format(*f.shape)
    if f.shape in ((2,), (3,)):
        inner = f"Vector{f.shape[0]}<f64>"
    elif f.shape in ((2, 2), (3, 3)):
        inner = f"Matrix{f.shape[0]}<f64>"
    elif f.body is not None:
        inner = f.body
    return inner if f.family is None else f"[{inner}; {f.family}]"
