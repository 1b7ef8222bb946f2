//! Functions, sums over an index, and the energies of bodies in print.

use lagrangian_symbolic::{ArrayFunction, ArrayNotation, print_sum_sign};
use proc_macro2::{Ident, Span};
use syn::{Expr, ExprMethodCall, Lit, Pat, UnOp, parse_quote};

use crate::emit::as_declared::formula::{FormulaPrinter, bounds};
use crate::emit::as_declared::notation::{Notation, Precedence, ends_with_word, join};
use crate::syntax::body_type::BodyType;
use crate::syntax::field_type::Content;
use crate::syntax::label::Index;
use crate::syntax::names::unraw;

impl FormulaPrinter<'_> {
    /// `(first..end).map(|i| …).sum()`; the outer `None` where it is something else.
    #[allow(clippy::option_option)] // Whether it is a sum, and whether it can be printed.
    pub(super) fn sum_over_range(&mut self, call: &ExprMethodCall) -> Option<Option<Notation>> {
        let Expr::MethodCall(map) = &*call.receiver else {
            return None;
        };
        if call.method != "sum" || map.method != "map" {
            return None;
        }
        Some(self.sum_of_map(map))
    }

    fn sum_of_map(&mut self, map: &ExprMethodCall) -> Option<Notation> {
        let (first, last) = bounds(&map.receiver)?;
        let Some(Expr::Closure(closure)) = map.args.first() else {
            return None;
        };
        let Some(Pat::Ident(variable)) = closure.inputs.first() else {
            return None;
        };
        if !self.is_free(&variable.ident) {
            return None;
        }
        let term = self.print(&closure.body)?;
        let sign = print_sum_sign(&unraw(&variable.ident), &first, &last);
        let term = if term.texts[0].starts_with('−') {
            term.within(["(", ")"], ["\\left(", "\\right)"])
        } else {
            term.at_least(Precedence::Product)
        };
        Some(Notation::new(
            join(&[&sign, &term.texts], ""),
            Precedence::Product,
        ))
    }

    /// A function of arguments, of which a method's first one is what it is called on.
    pub(super) fn call(
        &mut self,
        name: &Ident,
        arguments: &[&Expr],
        method: bool,
    ) -> Option<Notation> {
        let name = unraw(name);
        match (&*name, arguments) {
            ("dot", [x]) => self.time_derivative(x),
            ("kinetic_energy", [body, r, p]) => self.kinetic_energy(body, r, p),
            ("potential_energy", [body, r, p, g]) => self.potential_energy(body, r, p, g),
            ("powi" | "powf", [base, exponent]) => self.power(base, exponent),
            ("dot", _) if !method => None,
            ("abs", [x]) => Some(bars(self.print(x)?)),
            ("recip", [x]) => self.with_exponent(x, "⁻¹", "^{-1}"),
            ("sqrt", [x]) => {
                let inner = self.print(x)?;
                let latex = format!("\\sqrt{{{}}}", inner.texts[1]);
                let unicode = format!("√{}", inner.at_least(Precedence::Atom).texts[0]);
                Some(Notation::new([unicode, latex], Precedence::Function))
            }
            ("exp" | "signum", [x]) => {
                let [unicode, latex] = in_books(&name)?;
                let argument = self.print(x)?.within(["(", ")"], ["\\left(", "\\right)"]);
                let [argument, in_latex] = argument.texts;
                Some(Notation::atom(
                    format!("{unicode}{argument}"),
                    format!("{latex}{in_latex}"),
                ))
            }
            (function, [x]) if in_books(function).is_some() => {
                let [unicode, latex] = in_books(function)?;
                self.function(x, unicode, latex)
            }
            _ => match ArrayFunction::named(&name) {
                Some(function) => self.function_of_arrays(function.notation, arguments),
                None => self.operator(&name, arguments),
            },
        }
    }

    /// A function of vectors and matrices.
    fn function_of_arrays(
        &mut self,
        notation: ArrayNotation,
        arguments: &[&Expr],
    ) -> Option<Notation> {
        match (notation, arguments) {
            (ArrayNotation::InnerProduct, [x, y]) => {
                let product = self.between(x, y, "·", " \\cdot ")?;
                Some(Notation::new(product.texts, Precedence::InnerProduct))
            }
            (ArrayNotation::Between([unicode, latex]), [x, y]) => {
                self.between(x, y, unicode, latex)
            }
            (ArrayNotation::Enclosed { brackets, exponent }, _) => {
                let arguments = arguments.iter().map(|argument| self.print(argument));
                let arguments: Vec<_> = arguments.collect::<Option<_>>()?;
                let texts: Vec<_> = arguments.iter().map(|argument| &argument.texts).collect();
                let list = Notation::new(join(&texts, ", "), Precedence::Sum);
                let [unicode, latex] = exponent;
                let enclosed = list.within(brackets[0], brackets[1]);
                Some(enclosed.followed_by(unicode, latex))
            }
            (ArrayNotation::Raised([unicode, latex]), [x]) => self.with_exponent(x, unicode, latex),
            (ArrayNotation::Direction, [x]) => {
                let x = self.print(x)?;
                Some(x.clone().over(bars(x)))
            }
            (ArrayNotation::Diagonal, [x, y]) => {
                let diagonal = self.print(x)?.within(["diag(", ")"], DIAGONAL);
                Some(diagonal.times(self.print(y)?))
            }
            _ => None,
        }
    }

    /// A function of a number, with brackets where they are needed.
    fn function(&mut self, x: &Expr, unicode: &str, latex: &str) -> Option<Notation> {
        let argument = self.print(x)?;
        let bare = argument.precedence == Precedence::Atom
            && !argument.texts[0].starts_with(['(', '|'])
            && !ends_with_word(&argument.texts[0]);
        let separator = if bare { " " } else { "" };
        let argument = if bare {
            argument
        } else {
            argument.within(["(", ")"], ["\\left(", "\\right)"])
        };
        let [argument, in_latex] = argument.texts;
        let both = [
            format!("{unicode}{separator}{argument}"),
            format!("{latex}{separator}{in_latex}"),
        ];
        Some(Notation::new(both, Precedence::Function))
    }

    /// A function by its name: `R_zxz(φ, θ, ψ)`, `ω(r)`, or an external one.
    fn operator(&mut self, name: &str, arguments: &[&Expr]) -> Option<Notation> {
        let mut functions = self.declaration.clauses.functions.iter();
        let is_external = functions.any(|function| unraw(&function.name) == name);
        let is_known = is_external
            || ["angular_velocity", "atan2", "min", "max"].contains(&name)
            || name.starts_with("rotation_");
        if !is_known {
            return None;
        }
        let arguments: Vec<_> = arguments
            .iter()
            .map(|argument| self.print(argument))
            .collect::<Option<_>>()?;
        let texts: Vec<_> = arguments.iter().map(|argument| &argument.texts).collect();
        let [unicode, latex] = join(&texts, ", ");
        let operator = match name.split_once('_') {
            _ if name == "angular_velocity" => ["ω".into(), "\\omega".into()],
            _ if ["min", "max"].contains(&name) => [name.into(), format!("\\{name}")],
            Some(("rotation", axes)) if !is_external => {
                [format!("R_{axes}"), format!("R_{{{axes}}}")]
            }
            _ => {
                let words = name.replace('_', "\\_");
                [name.to_owned(), format!("\\operatorname{{{words}}}")]
            }
        };
        Some(Notation::atom(
            format!("{}({unicode})", operator[0]),
            format!("{}\\left({latex}\\right)", operator[1]),
        ))
    }

    fn time_derivative(&mut self, x: &Expr) -> Option<Notation> {
        match x {
            Expr::Paren(inner) => self.time_derivative(&inner.expr),
            Expr::Path(_) | Expr::Index(_) => self.quantity(x, 1),
            Expr::Call(call) if matches!(&*call.func, Expr::Path(path) if path.path.is_ident("dot")) => {
                self.quantity(call.args.first()?, 2)
            }
            _ => Some(rate(self.print(x)?)),
        }
    }

    fn power(&mut self, base: &Expr, exponent: &Expr) -> Option<Notation> {
        let integer = match exponent {
            Expr::Lit(literal) => match &literal.lit {
                Lit::Int(integer) => integer.base10_parse::<u32>().ok(),
                _ => None,
            },
            _ => None,
        };
        if let Some(digits) = integer {
            let raised: String = digits
                .to_string()
                .chars()
                .filter_map(|c| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(c.to_digit(10)? as usize))
                .collect();
            return self.with_exponent(base, &raised, &format!("^{{{digits}}}"));
        }
        let exponent = self.print(exponent)?;
        let latex = format!("^{{{}}}", exponent.texts[1]);
        let unicode = format!("^{}", exponent.at_least(Precedence::Atom).texts[0]);
        self.with_exponent(base, &unicode, &latex)
    }

    fn with_exponent(&mut self, base: &Expr, unicode: &str, latex: &str) -> Option<Notation> {
        let base = self.print(base)?.at_least(Precedence::Atom);
        Some(base.followed_by(unicode, latex))
    }

    fn between(&mut self, x: &Expr, y: &Expr, unicode: &str, latex: &str) -> Option<Notation> {
        let [x, y] = [x, y].map(|side| self.print(side));
        let (x, y) = (
            x?.at_least(Precedence::Function),
            y?.at_least(Precedence::Function),
        );
        let [x, y] = [x.texts, y.texts];
        let both = [
            format!("{}{unicode}{}", x[0], y[0]),
            format!("{}{latex}{}", x[1], y[1]),
        ];
        Some(Notation::new(both, Precedence::Product))
    }

    /// ½ m |ċ|² + ½ ω·\[I\] ω, where c = p + r `r_C` (4.3).
    fn kinetic_energy(&mut self, body: &Expr, r: &Expr, p: &Expr) -> Option<Notation> {
        let half = Notation::atom("½", "\\frac{1}{2}");
        let velocity = match self.center(body, r, p)? {
            (center, _) if center.is_zero() => Notation::zero(),
            (center, true) => rate(center),
            (_, false) => self.time_derivative(p)?,
        };
        let translation = if velocity.is_zero() {
            velocity
        } else {
            let mass = self.number_of_body(body, "m")?;
            let square = bars(velocity).followed_by("²", "^{2}");
            half.clone().times(mass).times(square)
        };
        let inertia = self.number_of_body(body, "I")?;
        let inertia = inertia.within(["[", "]"], ["\\left[", "\\right]"]);
        let [unicode, latex] = self.print(r)?.texts;
        let angular = Notation::atom(
            format!("ω({unicode})"),
            format!("\\omega\\left({latex}\\right)"),
        );
        let momentum = inertia.times(angular.clone());
        let product = inner_product(&angular, &momentum);
        Some(Notation::sum(vec![translation, half.times(product)]))
    }

    /// −m g·c.
    fn potential_energy(&mut self, body: &Expr, r: &Expr, p: &Expr, g: &Expr) -> Option<Notation> {
        let (center, is_elsewhere) = self.center(body, r, p)?;
        if center.is_zero() {
            return Some(center);
        }
        let mass = self.number_of_body(body, "m")?;
        let center = center.at_least(Precedence::Atom);
        if let Some((axis, size, negative)) = along_axis(g) {
            let height = match p {
                Expr::Path(_) | Expr::Index(_) if !is_elsewhere => {
                    let axis = Ident::new(axis, Span::call_site());
                    self.print(&parse_quote!(#p.#axis))?
                }
                _ => center.followed_by(&format!("_{axis}"), &format!("_{axis}")),
            };
            let weight = mass.times(self.print(size)?).times(height);
            return Some(if negative { weight } else { weight.negated() });
        }
        let gravity = self.print(g)?.at_least(Precedence::Atom);
        Some(mass.times(inner_product(&gravity, &center)).negated())
    }

    /// The centre of gravity, and whether it is another point than the origin of the axes.
    fn center(&mut self, body: &Expr, r: &Expr, p: &Expr) -> Option<(Notation, bool)> {
        let mut origin = self.print(p)?;
        if origin.texts[0] == "(0, 0, 0)" {
            origin = Notation::zero();
        }
        if self.body_type(body)? == BodyType::Principal {
            return Some((origin, false));
        }
        let arm = self.number_of_body(body, "r_C")?;
        let arm = self.print(r)?.times(arm);
        Some((Notation::sum(vec![origin, arm]), true))
    }

    /// A number of a body: m, I, or the vector `r_C`.
    fn number_of_body(&mut self, body: &Expr, letter: &str) -> Option<Notation> {
        let (name, indices) = base(body)?;
        let stem = self.bodies.with_name(letter, &unraw(name));
        let stem = Ident::new(&stem, name.span());
        self.member(&stem, &indices, &[], 0)
    }

    fn body_type(&self, body: &Expr) -> Option<BodyType> {
        let (name, _) = base(body)?;
        let mut fields = self.declaration.fields.iter();
        let field = fields.find(|field| field.name == *name)?;
        match field.field_type().ok()?.content() {
            Content::Body(ty) => Some(ty),
            Content::Numbers(_) => None,
        }
    }
}

/// Around what is a diagonal matrix.
const DIAGONAL: [&str; 2] = ["\\operatorname{diag}\\left(", "\\right)"];

/// The name of a function in books, in Unicode and in LaTeX.
fn in_books(name: &str) -> Option<[&'static str; 2]> {
    Some(match name {
        "sin" => ["sin", "\\sin"],
        "cos" => ["cos", "\\cos"],
        "tan" => ["tan", "\\tan"],
        "asin" => ["arcsin", "\\arcsin"],
        "acos" => ["arccos", "\\arccos"],
        "atan" => ["arctan", "\\arctan"],
        "sinh" => ["sinh", "\\sinh"],
        "cosh" => ["cosh", "\\cosh"],
        "tanh" => ["tanh", "\\tanh"],
        "asinh" => ["arsinh", "\\operatorname{arsinh}"],
        "acosh" => ["arcosh", "\\operatorname{arcosh}"],
        "atanh" => ["artanh", "\\operatorname{artanh}"],
        "exp" => ["exp", "\\exp"],
        "ln" => ["ln", "\\ln"],
        "signum" => ["sgn", "\\operatorname{sgn}"],
        _ => return None,
    })
}

fn inner_product(x: &Notation, y: &Notation) -> Notation {
    let both = [
        format!("{}·{}", x.texts[0], y.texts[0]),
        format!("{} \\cdot {}", x.texts[1], y.texts[1]),
    ];
    Notation::new(both, Precedence::InnerProduct)
}

/// The axis along which a vector of components points, its only component other than zero without its sign, and whether it has
/// a minus sign.
fn along_axis(vector: &Expr) -> Option<(&'static str, &Expr, bool)> {
    let Expr::Array(array) = vector else {
        return None;
    };
    let is_zero =
        |component: &Expr| matches!(component, Expr::Lit(literal) if is_zero(&literal.lit));
    let mut others = array
        .elems
        .iter()
        .enumerate()
        .filter(|(_, component)| !is_zero(component));
    let (Some((i, component)), None) = (others.next(), others.next()) else {
        return None;
    };
    let axis = *Index::AXES.get(i)?;
    match component {
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => Some((axis, &unary.expr, true)),
        other => Some((axis, other, false)),
    }
}

fn is_zero(literal: &Lit) -> bool {
    match literal {
        Lit::Int(integer) => integer.base10_digits() == "0",
        Lit::Float(float) => float.base10_parse::<f64>().is_ok_and(|value| value == 0.0),
        _ => false,
    }
}

/// The name of a body, and its indices.
fn base(body: &Expr) -> Option<(&Ident, Vec<Expr>)> {
    match body {
        Expr::Path(path) => Some((path.path.get_ident()?, Vec::new())),
        Expr::Paren(inner) => base(&inner.expr),
        Expr::Index(inner) => {
            let (name, mut indices) = base(&inner.expr)?;
            indices.push((*inner.index).clone());
            Some((name, indices))
        }
        _ => None,
    }
}

fn bars(x: Notation) -> Notation {
    x.within(["|", "|"], ["\\left|", "\\right|"])
}

/// d/dt of something that is no name.
fn rate(x: Notation) -> Notation {
    let [unicode, latex] = x.at_least(Precedence::Atom).texts;
    let latex = format!("\\frac{{d}}{{dt}} {latex}");
    Notation::new([format!("d/dt {unicode}"), latex], Precedence::Function)
}
