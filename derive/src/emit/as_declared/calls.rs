//! Functions, sums over an index, and the energies of bodies in print.

use lagrangian_symbolic::{ArrayFunction, ArrayNotation, Printed, Rational};
use proc_macro2::{Ident, Span};
use syn::{Expr, ExprMethodCall, Lit, Pat, UnOp, parse_quote};

use crate::emit::as_declared::formula::{FormulaPrinter, values};
use crate::syntax::body_type::BodyType;
use crate::syntax::field_type::Content;
use crate::syntax::label::Index;
use crate::syntax::names::unraw;

impl FormulaPrinter<'_> {
    /// `(first..end).map(|i| …).sum()`; the outer `None` where it is something else.
    #[allow(clippy::option_option)] // Whether it is a sum, and whether it can be printed.
    pub(super) fn sum_over_range(&mut self, call: &ExprMethodCall) -> Option<Option<Printed>> {
        let Expr::MethodCall(map) = &*call.receiver else {
            return None;
        };
        if call.method != "sum" || map.method != "map" {
            return None;
        }
        Some(self.sum_of_map(map))
    }

    fn sum_of_map(&mut self, map: &ExprMethodCall) -> Option<Printed> {
        let Some(Expr::Closure(closure)) = map.args.first() else {
            return None;
        };
        let Some(Pat::Ident(variable)) = closure.inputs.first() else {
            return None;
        };
        if !self.is_free(&variable.ident) {
            return None;
        }
        let range = values(&variable.ident, &map.receiver)?;
        Some(self.print(&closure.body)?.summed(range))
    }

    /// A function of arguments, of which a method's first one is what it is called on.
    pub(super) fn call(
        &mut self,
        name: &Ident,
        arguments: &[&Expr],
        method: bool,
    ) -> Option<Printed> {
        let name = unraw(name);
        match (&*name, arguments) {
            ("dot", [x]) => self.time_derivative(x),
            ("kinetic_energy", [body, r, p]) => self.kinetic_energy(body, r, p),
            ("potential_energy", [body, r, p, g]) => self.potential_energy(body, r, p, g),
            ("powi" | "powf", [base, exponent]) => self.power(base, exponent),
            ("dot", _) if !method => None,
            ("recip", [x]) => Some(self.print(x)?.followed_by(["⁻¹", "^{-1}"])),
            ("sqrt", [x]) => Some(self.print(x)?.root()),
            _ => {
                if let Some(function) = ArrayFunction::named(&name) {
                    return self.function_of_arrays(function.notation, arguments);
                }
                if let ([x], Some(function)) = (arguments, Printed::function(&name)) {
                    return Some(function(self.print(x)?));
                }
                self.operator(&name, arguments)
            }
        }
    }

    /// A function of vectors and matrices.
    fn function_of_arrays(
        &mut self,
        notation: ArrayNotation,
        arguments: &[&Expr],
    ) -> Option<Printed> {
        let arguments = arguments.iter().map(|argument| self.print(argument));
        let arguments: Vec<_> = arguments.collect::<Option<_>>()?;
        match (notation, <[_; 2]>::try_from(arguments)) {
            (ArrayNotation::InnerProduct, Ok([x, y])) => Some(x.inner_product(y)),
            (ArrayNotation::Between(sign), Ok([x, y])) => Some(x.vector_product(y, sign)),
            (ArrayNotation::Diagonal, Ok([x, y])) => {
                Some(Printed::call(["diag", "\\operatorname{diag}"], vec![x]).times(y))
            }
            (ArrayNotation::Enclosed { brackets, exponent }, Err(list)) => {
                let enclosed = Printed::within(brackets, list);
                Some(match exponent {
                    ["", ""] => enclosed,
                    exponent => enclosed.followed_by(exponent),
                })
            }
            (ArrayNotation::Raised(exponent), Err(mut one)) => {
                Some(one.pop()?.followed_by(exponent))
            }
            (ArrayNotation::Direction, Err(mut one)) => {
                let x = one.pop()?;
                Some(x.clone().over(Printed::bars(x)))
            }
            _ => None,
        }
    }

    /// A function by its name: `R_zxz(φ, θ, ψ)`, `ω(r)`, or an external one.
    fn operator(&mut self, name: &str, arguments: &[&Expr]) -> Option<Printed> {
        let mut functions = self.declaration.clauses.functions.iter();
        let is_external = functions.any(|function| unraw(&function.name) == name);
        let [unicode, latex] = match name.split_once('_') {
            _ if is_external => {
                let words = name.replace('_', "\\_");
                [name.to_owned(), format!("\\operatorname{{{words}}}")]
            }
            _ if name == "angular_velocity" => ["ω".into(), "\\omega".into()],
            _ if name == "atan2" => [name.into(), "\\operatorname{atan2}".into()],
            _ if ["min", "max"].contains(&name) => [name.into(), format!("\\{name}")],
            Some(("rotation", axes)) => [format!("R_{axes}"), format!("R_{{{axes}}}")],
            _ => return None,
        };
        let arguments = arguments.iter().map(|argument| self.print(argument));
        Some(Printed::call(
            [&unicode, &latex],
            arguments.collect::<Option<_>>()?,
        ))
    }

    fn time_derivative(&mut self, x: &Expr) -> Option<Printed> {
        match x {
            Expr::Paren(inner) => self.time_derivative(&inner.expr),
            Expr::Path(_) | Expr::Index(_) => self.quantity(x, 1),
            Expr::Call(call) if matches!(&*call.func, Expr::Path(path) if path.path.is_ident("dot")) => {
                self.quantity(call.args.first()?, 2)
            }
            _ => Some(rate(self.print(x)?)),
        }
    }

    fn power(&mut self, base: &Expr, exponent: &Expr) -> Option<Printed> {
        Some(self.print(base)?.power(self.print(exponent)?))
    }

    /// ½ m |ċ|² + ½ ω·\[I\] ω, where c = p + r `r_C` (4.3).
    fn kinetic_energy(&mut self, body: &Expr, r: &Expr, p: &Expr) -> Option<Printed> {
        let half = Printed::number(&Rational::HALF);
        let velocity = match self.center(body, r, p)? {
            (center, _) if center.is_zero() => Printed::zero(),
            (center, true) => rate(center),
            (_, false) => self.time_derivative(p)?,
        };
        let translation = if velocity.is_zero() {
            velocity
        } else {
            let mass = self.number_of_body(body, "m")?;
            let square = Printed::bars(velocity).followed_by(["²", "^{2}"]);
            half.clone().times(mass).times(square)
        };
        let inertia = self.number_of_body(body, "I")?;
        let inertia = Printed::within([["[", "]"], ["\\left[", "\\right]"]], vec![inertia]);
        let angular = Printed::call(["ω", "\\omega"], vec![self.print(r)?]);
        // The brackets of the tensor are enough.
        let momentum = Printed::within([["", ""]; 2], vec![inertia.times(angular.clone())]);
        let product = angular.inner_product(momentum);
        Some(Printed::sum([translation, half.times(product)]))
    }

    /// −m g·c.
    fn potential_energy(&mut self, body: &Expr, r: &Expr, p: &Expr, g: &Expr) -> Option<Printed> {
        let (center, is_elsewhere) = self.center(body, r, p)?;
        if center.is_zero() {
            return Some(center);
        }
        let mass = self.number_of_body(body, "m")?;
        if let Some((axis, size, negative)) = along_axis(g) {
            let height = match p {
                Expr::Path(_) | Expr::Index(_) if !is_elsewhere => {
                    let axis = Ident::new(axis, Span::call_site());
                    self.print(&parse_quote!(#p.#axis))?
                }
                _ => center.component(axis),
            };
            let weight = mass.times(self.print(size)?).times(height);
            return Some(if negative { weight } else { weight.negated() });
        }
        let gravity = self.print(g)?;
        Some(mass.times(gravity.inner_product(center)).negated())
    }

    /// The centre of gravity, and whether it is another point than the origin of the axes.
    fn center(&mut self, body: &Expr, r: &Expr, p: &Expr) -> Option<(Printed, bool)> {
        let mut origin = self.print(p)?;
        if origin == Printed::list([0; 3].map(|_| Printed::zero()).into()) {
            origin = Printed::zero();
        }
        if self.body_type(body)? == BodyType::Principal {
            return Some((origin, false));
        }
        let arm = self.number_of_body(body, "r_C")?;
        let arm = self.print(r)?.times(arm);
        Some((Printed::sum([origin, arm]), true))
    }

    /// A number of a body: m, I, or the vector `r_C`.
    fn number_of_body(&mut self, body: &Expr, letter: &str) -> Option<Printed> {
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

/// d/dt of something that is no name.
fn rate(x: Printed) -> Printed {
    x.after(["d/dt ", "\\frac{d}{dt} "])
}
