//! Error messages that say what to write instead.

use core::fmt::Display;
use core::iter;
use lagrangian_symbolic::ArrayFunction;

use proc_macro2::Ident;
use syn::{BinOp, Expr, ExprField, ExprPath, Member};

use super::builtins::is_function;
pub(crate) use super::unknown_function::unknown_function;
use crate::limits::MAX_NAMES;
use crate::lower::scope::Family;
use crate::syntax::other_notation::{NO_CASES, NO_CONDITIONS, NO_REMAINDER};
use crate::syntax::shape::Shape;

/// For expressions that are not part of the declaration language.
pub(crate) fn unsupported_syntax(expression: &Expr) -> &'static str {
    match expression {
        Expr::If(_) | Expr::Match(_) | Expr::Try(_) => NO_CASES,
        Expr::Block(_) | Expr::Let(_) | Expr::Assign(_) | Expr::Unsafe(_) | Expr::Const(_) => {
            "there are no statements here: name intermediate quantities under `define(name = expression)`"
        }
        Expr::Closure(_) => {
            "there are no closures here but in `(0..5).map(|i| …)`: name parts of an expression under `define(name = \
             expression)`, or declare a function, `function(f(x) = …)`; an absolute value is `abs(x)`"
        }
        Expr::ForLoop(_) => {
            "there are no loops here: a sum is written `(0..5).map(|i| m[i] * x[i]).sum()`"
        }
        Expr::Struct(_) => "arguments stand in parentheses: write `sin(x)`",
        Expr::Macro(_) => {
            "macros are not expanded here: write the expression out, or let a macro write the whole struct"
        }
        Expr::Cast(_) => "all numbers here are real: leave out the conversion",
        Expr::Reference(_) => "there are no references here: leave out the `&`",
        Expr::Tuple(_) => "vectors are written in brackets: `[x, y, z]`",
        Expr::Range(_) => {
            "a range is no quantity: write `(0..5).map(|i| …).sum()`, or `.product()` or `.collect()`"
        }
        Expr::Infer(_) => "write the expression that is meant in place of `_`",
        _ => {
            "this is not part of the declaration language: write an expression of numbers, names, \
             `+ - * /`, and functions such as `sin(x)` or `x.powi(2)`"
        }
    }
}

/// For operators other than `+`, `-`, `*` and `/`.
pub(crate) fn unsupported_operator(operator: &BinOp) -> Option<&'static str> {
    match operator {
        BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Div(_) => None,
        BinOp::BitXor(_) => Some(
            "`^` is no power in Rust, where `a * b ^ 2` means `(a * b) ^ 2`: \
             write `x.powi(2)`, or `x.powf(1.5)`",
        ),
        BinOp::Rem(_) => Some(NO_REMAINDER),
        BinOp::Lt(_)
        | BinOp::Le(_)
        | BinOp::Gt(_)
        | BinOp::Ge(_)
        | BinOp::Eq(_)
        | BinOp::Ne(_)
        | BinOp::And(_)
        | BinOp::Or(_) => Some(NO_CONDITIONS),
        _ => Some("only `+`, `-`, `*` and `/` join expressions here"),
    }
}

/// For operands of incompatible shapes.
pub(crate) fn incompatible_shapes(operator: &BinOp, left: Shape, right: Shape) -> String {
    let is_vector = |shape| matches!(shape, Shape::Array { columns: 1, .. });
    let (sign, hint) = match operator {
        BinOp::Add(_) => ("+", "both sides have to have the same shape"),
        BinOp::Sub(_) => ("-", "both sides have to have the same shape"),
        BinOp::Div(_) => (
            "/",
            "a divisor is a scalar, or write `m.inverse() * v` for a matrix",
        ),
        _ if is_vector(left) && is_vector(right) => {
            ("*", "write `a.dot(b)`, `a.cross(b)` or `a.outer(b)`")
        }
        _ => (
            "*",
            "the columns of the first have to be as many as the rows of the second",
        ),
    };
    format!("`{sign}` stands between {left} and {right}: {hint}")
}

/// For what does not fit as a row of a matrix, or a component of a vector.
pub(crate) fn incompatible_rows(first: Shape, odd: Shape) -> String {
    if first == odd {
        return format!(
            "a vector is made of scalars, and a matrix of vectors as rows: this is {odd}"
        );
    }
    format!(
        "this is {odd}, and the first is {first}: a vector is made of scalars, and a matrix of vectors of one \
         length as rows"
    )
}

/// For an unresolved name where an integer is expected.
pub(crate) fn not_an_integer(name: &Ident) -> String {
    if is_constant(name) {
        return format!(
            "what the constant `{name}` is, the compiler knows later than these equations are derived: write the \
             number, or `theta.len()`"
        );
    }
    format!(
        "`{name}` stands for no integer here: write `|{name}|` or `for {name} in 0..5` to let it run through a \
         range"
    )
}

/// Whether a name is written like that of a constant.
fn is_constant(name: &Ident) -> bool {
    let written = name.to_string();
    let mut letters = written.chars();
    letters.all(|c| c.is_uppercase() || c == '_' || c.is_numeric())
}

/// For an unresolved name, beside those of quantities.
pub(crate) fn unknown_name(name: &Ident, known: &[&str]) -> String {
    if let Some(message) = constant_of_others(name) {
        return format!("unknown name `{name}`: {message}");
    }
    if is_constant(name) {
        return format!(
            "`{name}` is no field, coordinate or definition, and what a constant of Rust is, the compiler knows \
             later than these equations are derived: make it a field of the struct, or write its value"
        );
    }
    let known = match known {
        [one] => format!("there is `{one}`; "),
        [_, ..] if known.len() <= MAX_NAMES => format!("there are `{}`; ", known.join("`, `")),
        _ => String::new(),
    };
    format!("unknown name `{name}`: {known}make it a field of the struct, or define it")
}

/// What is written for a constant of other languages, unless a field could have been forgotten.
fn constant_of_others(name: &Ident) -> Option<&'static str> {
    match name.to_string().as_str() {
        "π" | "M_PI" => Some("the number π is `PI`"),
        "TAU" | "τ" => Some("write `2.0 * PI`"),
        "e" | "E" | "M_E" => Some(
            "powers of Euler's number are written `exp(x)`; another quantity is a field of the struct",
        ),
        "inf" | "INFINITY" | "NaN" | "nan" | "NAN" => Some("a quantity here is finite"),
        _ => None,
    }
}

/// A member of a family, as it is written.
pub(crate) fn member(name: &Ident, indices: &[impl Display]) -> String {
    let indices = indices
        .iter()
        .flat_map(|index| ["[".to_owned(), index.to_string(), "]".to_owned()]);
    [name.to_string()].into_iter().chain(indices).collect()
}

/// How all members of a family are written, as in `theta[i] = … for i in 0..5`.
pub(crate) fn every_member(name: &Ident, family: &Family) -> String {
    let variables: Vec<&str> = ["i", "j", "k"]
        .into_iter()
        .chain(iter::repeat("l"))
        .take(family.rank)
        .collect();
    let ranges = variables.iter().enumerate().map(|(position, variable)| {
        let indices = family
            .members
            .keys()
            .filter_map(|member| member.get(position));
        let end = indices.max().map_or(0, |last| last + 1);
        format!(" for {variable} in 0..{end}")
    });
    format!(
        "{} = …{}",
        member(name, &variables),
        ranges.collect::<String>()
    )
}

/// For a coordinate beyond the last one of its name.
pub(crate) fn out_of_range<T>(
    name: &Ident,
    indices: &[impl Display],
    family: &Family<T>,
) -> String {
    let written = member(name, indices);
    match family.members.keys().next_back() {
        Some(last) if family.rank > 1 => format!(
            "`{written}` is out of range: the last coordinate of this name is `{}`",
            member(name, last)
        ),
        _ => format!(
            "`{written}` is out of range: there are {} coordinates of this name, from `{name}[0]` on",
            family.members.len()
        ),
    }
}

/// For one or several bodies where a number belongs.
pub(crate) fn bodies<T>(name: &Ident, family: &Family<T>) -> String {
    if family.rank == 0 {
        return one_body(name, family);
    }
    let one = member(name, &vec!["i"; family.rank]);
    format!(
        "`{name}` is an array of {} bodies: write which of them, as in `{one}.mass` or `kinetic_energy({one}, r, p)`",
        family.members.len()
    )
}

/// For a body where a number belongs.
pub(crate) fn one_body<T>(name: &Ident, family: &Family<T>) -> String {
    let one = member(name, &vec!["i"; family.rank]);
    format!(
        "this is a body and no quantity: write `{one}.mass`, `{one}.center` or `{one}.inertia`, or its energies \
         `kinetic_energy({one}, r, p)` and `potential_energy({one}, r, p, gravity)`"
    )
}

/// For a force on what may be a velocity, or a position to which a velocity is added.
pub(crate) fn position_and_velocity(name: &Ident) -> String {
    format!(
        "`{name}` adds a velocity to what depends on coordinates alone, so that the work of a force on it is not \
         known: a velocity in a frame that moves is written by `dot`, as in `dot(x) - dot(rate * t) * y`; define a \
         position and a velocity apart, or write the generalized forces, `force(x = …)`"
    )
}

/// For a call of what is not a name.
pub(crate) fn not_callable(function: &Expr) -> &'static str {
    match function {
        Expr::Paren(inner) => not_callable(&inner.expr),
        Expr::Closure(_) => unsupported_syntax(function),
        Expr::Path(path) if makes_an_array(path) => {
            "write the components alone: `[x, y, z]` for a vector, `[[a, b], [c, d]]` for a matrix"
        }
        Expr::Path(_) => {
            "write the function by its name alone, such as `sin(x)`; one of Rust is declared before, as \
             `function(f(x) = path::f(x), derivative(x) = …)`"
        }
        _ => "parentheses behind an expression are a call: write `*` for a product",
    }
}

/// Whether this is a function of a type of vectors or matrices, such as `Vector3::new`.
fn makes_an_array(path: &ExprPath) -> bool {
    let mut segments = path.path.segments.iter();
    segments.any(|segment| {
        let name = segment.ident.to_string();
        ["Vector", "Matrix", "SVector", "SMatrix"]
            .iter()
            .any(|stem| name.starts_with(stem))
    })
}

pub(crate) fn unsupported_path(path: &ExprPath) -> &'static str {
    match path.path.segments.last() {
        Some(last) if last.ident == "PI" => "write `PI`",
        Some(_) if path.path.is_ident("self") => "write the names of fields, without `self`",
        _ => {
            "paths are not part of the declaration language: make this a field of the struct, or write its value"
        }
    }
}

pub(crate) fn unsupported_field(field: &ExprField) -> String {
    match (&*field.base, &field.member) {
        (Expr::Path(base), Member::Named(member)) if base.path.is_ident("self") => {
            format!("fields are written without `self`: write `{member}`")
        }
        (_, Member::Named(member)) if member == "T" => "write `.transpose()`".to_owned(),
        (_, Member::Named(member)) if is_constant_pi(member) => "write `PI`".to_owned(),
        (_, Member::Named(member)) if is_velocity(member) => {
            "the velocity is written `dot(x)`".to_owned()
        }
        (_, Member::Named(member)) if is_function(&member.to_string()) => {
            format!("`{member}` is a function: write `.{member}(…)`")
        }
        _ => "fields of fields cannot be used here, but for the components of vectors, `v.x`, `v.y` and so on as far as \
              `v.w` of four, and `mass`, `center` and `inertia` of bodies: make this a field of the struct"
            .to_owned(),
    }
}

fn is_constant_pi(member: &Ident) -> bool {
    member == "PI" || member == "pi" || member == "Pi"
}

fn is_velocity(member: &Ident) -> bool {
    ["dot", "v", "vel", "velocity", "rate"]
        .iter()
        .any(|name| member == name)
}

/// For a call of a quantity as a method.
pub(crate) fn no_method(name: &Ident, arguments: usize) -> String {
    match name.to_string().as_str() {
        "t" => "the transpose is `.transpose()`, and `t` the time".to_owned(),
        _ if arguments == 0 => {
            format!("`{name}` is no method: a component is written without parentheses, `.x`")
        }
        _ => format!("`{name}` is no method: write `{name} * (…)` for a product"),
    }
}

/// How a function is written.
pub(crate) fn example(name: &str, arguments: usize) -> String {
    match (name, arguments) {
        ("powi", _) => "x.powi(2)".to_owned(),
        ("powf", _) => "x.powf(1.5)".to_owned(),
        ("atan2", _) => "atan2(y, x)".to_owned(),
        ("row" | "column", _) => format!("m.{name}(0)"),
        ("identity", _) => "identity(3)".to_owned(),
        ("sum" | "product", _) => format!("(0..5).map(|i| m[i]).{name}()"),
        (_, 1) => format!("{name}(x)"),
        (_, 3) => format!("{name}(a, b, c)"),
        _ if ArrayFunction::named(name).is_some() => format!("a.{name}(b)"),
        _ => format!("{name}(x, y)"),
    }
}
