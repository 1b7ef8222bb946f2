//! Expressions of a declaration in print.

use std::collections::{BTreeMap, BTreeSet};

use lagrangian_symbolic::{Index as Below, Printed, Range, Rational};
use proc_macro2::Ident;
use syn::{BinOp, Expr, ExprLit, Lit, Member, RangeLimits, Stmt, UnOp};

use crate::emit::printed_names::BodyNames;
use crate::limits::DEEPEST_PRINTED;
use crate::syntax::declaration::Declaration;
use crate::syntax::field::Role;
use crate::syntax::label::Index;
use crate::syntax::names::unraw;

/// Prints the expressions of a declaration.
pub(super) struct FormulaPrinter<'a> {
    pub(super) declaration: &'a Declaration,
    pub(super) bodies: BodyNames,
    /// The names of the definitions, and which of them were mentioned since they were last taken.
    definitions: BTreeSet<String>,
    mentioned: BTreeSet<String>,
    parameters: BTreeSet<String>,
    /// Vectors, each with how many indices stand before the letter of a component.
    vectors: BTreeMap<String, usize>,
    /// How many expressions the one that is printed is within.
    depth: usize,
}

impl<'a> FormulaPrinter<'a> {
    pub(super) fn new(
        declaration: &'a Declaration,
        bodies: BodyNames,
        vectors: BTreeMap<String, usize>,
    ) -> Self {
        let definitions = declaration.clauses.definitions.iter();
        let parameters = declaration.fields_with(Role::Parameter);
        Self {
            definitions: definitions.map(|named| unraw(&named.name)).collect(),
            mentioned: BTreeSet::new(),
            parameters: parameters.map(|field| unraw(&field.name)).collect(),
            declaration,
            bodies,
            vectors,
            depth: 0,
        }
    }

    /// Whether an index has a letter that is the name of nothing else.
    pub(super) fn is_free(&self, variable: &Ident) -> bool {
        let fields = self.declaration.fields.iter();
        let coordinates = self.declaration.clauses.coordinates.iter();
        let names = fields.map(|field| &field.name);
        let mut names = names.chain(coordinates.map(|coordinate| &coordinate.name));
        let variable = unraw(variable);
        names.all(|name| unraw(name) != variable) && !self.definitions.contains(&variable)
    }

    /// The definitions that were mentioned since the last time.
    pub(super) fn take_mentioned(&mut self) -> BTreeSet<String> {
        core::mem::take(&mut self.mentioned)
    }

    /// An expression; none where a part of it has no customary notation, or lies too deep.
    pub(super) fn print(&mut self, expression: &Expr) -> Option<Printed> {
        if self.depth >= DEEPEST_PRINTED {
            return None;
        }
        self.depth += 1;
        let printed = self.print_next(expression);
        self.depth -= 1;
        printed
    }

    fn print_next(&mut self, expression: &Expr) -> Option<Printed> {
        match expression {
            Expr::Paren(inner) => self.print(&inner.expr),
            Expr::Group(inner) => self.print(&inner.expr),
            Expr::Block(block) => match block.block.stmts.as_slice() {
                [Stmt::Expr(only, None)] => self.print(only),
                _ => None,
            },
            Expr::Lit(literal) => number(literal),
            Expr::Path(_) | Expr::Index(_) | Expr::Field(_) => self.quantity(expression, 0),
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
                Some(self.print(&unary.expr)?.negated())
            }
            Expr::Binary(binary) => {
                let [left, right] = [&binary.left, &binary.right].map(|side| self.print(side));
                let (left, right) = (left?, right?);
                match binary.op {
                    BinOp::Add(_) => Some(left.plus(right, false)),
                    BinOp::Sub(_) => Some(left.plus(right, true)),
                    BinOp::Mul(_) => Some(left.times(right)),
                    BinOp::Div(_) => Some(left.over(right)),
                    _ => None,
                }
            }
            Expr::Array(array) => {
                let rows = array.elems.iter().map(|row| match row {
                    Expr::Array(_) => None,
                    component => self.print(component),
                });
                let rows: Vec<_> = rows.collect::<Option<_>>()?;
                Some(Printed::list(rows))
            }
            Expr::Call(call) => {
                let Expr::Path(path) = &*call.func else {
                    return None;
                };
                let arguments: Vec<_> = call.args.iter().collect();
                self.call(path.path.get_ident()?, &arguments, false)
            }
            Expr::MethodCall(call) => {
                if let Some(sum) = self.sum_over_range(call) {
                    return sum;
                }
                let arguments: Vec<_> = [&*call.receiver].into_iter().chain(&call.args).collect();
                self.call(&call.method, &arguments, true)
            }
            _ => None,
        }
    }

    /// A name with its indices and with dots above it.
    pub(super) fn quantity(&mut self, expression: &Expr, dots: usize) -> Option<Printed> {
        let mut behind = Vec::new();
        let mut indices = Vec::new();
        let mut base = expression;
        loop {
            base = match base {
                Expr::Paren(inner) => &inner.expr,
                Expr::Index(inner) => {
                    indices.insert(0, (*inner.index).clone());
                    &inner.expr
                }
                Expr::Field(field) if indices.is_empty() && behind.is_empty() => {
                    let Member::Named(axis) = &field.member else {
                        return None;
                    };
                    if !Index::AXES.contains(&&*axis.to_string()) {
                        return None;
                    }
                    behind.push(axis.to_string());
                    &field.base
                }
                Expr::Path(path) => {
                    return self.member(path.path.get_ident()?, &indices, &behind, dots);
                }
                _ if dots == 0 && indices.is_empty() => {
                    return Some(self.print(base)?.component(behind.first()?));
                }
                _ => return None,
            };
        }
    }

    /// The member of a family, or one of its components.
    pub(super) fn member(
        &mut self,
        name: &Ident,
        indices: &[Expr],
        behind: &[String],
        dots: usize,
    ) -> Option<Printed> {
        let name = unraw(name);
        if self.definitions.contains(&name) {
            self.mentioned.insert(name.clone());
        }
        if name == "PI" {
            return Some(Printed::text(["π", "\\pi"]));
        }
        let indices: Option<Vec<_>> = indices.iter().map(below).collect();
        let mut indices = indices?.concat();
        let mut behind = behind.to_vec();
        match self.vectors.get(&name) {
            // A component by its number, which is printed by its letter.
            Some(outer) if indices.len() == outer + 1 => {
                let Some(Below::Number(axis)) = indices.pop() else {
                    return None;
                };
                let axis = Index::AXES.get(usize::try_from(axis).ok()?)?;
                behind.push((*axis).to_owned());
            }
            // The other way round.
            None if !behind.is_empty() => {
                let axis = behind.pop()?;
                let mut axes = Index::AXES.iter();
                let axis = axes.position(|known| *known == axis)?;
                indices.push(Below::Number(i64::try_from(axis).ok()?));
            }
            _ => {}
        }
        indices.extend(behind.into_iter().map(Below::Word));
        let is_parameter = self.parameters.contains(&name);
        Some(Printed::name(&name, is_parameter, indices, dots))
    }
}

/// The integers of a range as the values of an index.
pub(super) fn values(variable: &Ident, range: &Expr) -> Option<Range> {
    let range = match range {
        Expr::Paren(inner) => return values(variable, &inner.expr),
        Expr::Group(inner) => return values(variable, &inner.expr),
        Expr::Range(range) => range,
        _ => return None,
    };
    let last = index(range.end.as_ref()?)?;
    Some(Range {
        variable: unraw(variable),
        first: index(range.start.as_ref()?)?,
        last: match range.limits {
            RangeLimits::Closed(_) => last,
            RangeLimits::HalfOpen(_) => last.plus(-1),
        },
    })
}

/// An index, or the two of a pair.
fn below(expression: &Expr) -> Option<Vec<Below>> {
    match expression {
        Expr::Tuple(pair) => pair.elems.iter().map(index).collect(),
        _ => Some(vec![index(expression)?]),
    }
}

/// An index that is a sum of a variable and integers.
fn index(expression: &Expr) -> Option<Below> {
    match expression {
        Expr::Paren(inner) => index(&inner.expr),
        Expr::Group(inner) => index(&inner.expr),
        Expr::Lit(ExprLit {
            lit: Lit::Int(integer),
            ..
        }) => Some(Below::Number(integer.base10_parse().ok()?)),
        Expr::Path(path) => Some(Below::Variable(unraw(path.path.get_ident()?), 0)),
        Expr::Binary(binary) => match (binary.op, index(&binary.left)?, index(&binary.right)?) {
            (BinOp::Add(_), left, Below::Number(number)) => Some(left.plus(number)),
            (BinOp::Sub(_), left, Below::Number(number)) => Some(left.plus(-number)),
            (BinOp::Add(_), Below::Number(number), right) => Some(right.plus(number)),
            _ => None,
        },
        _ => None,
    }
}

fn number(literal: &ExprLit) -> Option<Printed> {
    let digits = match &literal.lit {
        Lit::Int(integer) => integer.base10_digits(),
        Lit::Float(float) => float.base10_digits(),
        _ => return None,
    };
    Some(Printed::number(&Rational::from_decimal(digits)?))
}

#[cfg(test)]
mod tests {
    use proc_macro2::TokenStream;
    use quote::quote;
    use syn::parse_quote;

    use super::*;
    use crate::diagnostics::Diagnostics;

    /// The texts of an expression, where `link` is a body and `r[i]` is defined.
    fn printed(expression: &Expr) -> Option<[String; 2]> {
        let mut diagnostics = Diagnostics::default();
        let declaration = Declaration::parse(
            parse_quote! {
                #[lagrangian(coordinates(theta[3], x), define(r[i] = x for i in 0..3))]
                struct Model { m: [f64; 3], i1: f64, mass: f64, l: f64, g: f64, link: RigidBody }
            },
            &mut diagnostics,
        );
        let vectors = [("r".to_owned(), 1)].into();
        let mut printer = FormulaPrinter::new(&declaration, BodyNames::Alone, vectors);
        Some(printer.print(expression)?.both())
    }

    fn assert_printed(cases: &[(TokenStream, &str)]) {
        for (tokens, expected) in cases {
            let expression: Expr = syn::parse2(tokens.clone()).expect("an expression");
            let texts = printed(&expression).expect(expected);
            assert_eq!(texts[0], *expected);
            let [open, closed] = ['{', '}'].map(|c| texts[1].matches(c).count());
            assert_eq!(open, closed, "{}", texts[1]);
        }
    }

    #[test]
    fn expressions_are_printed_as_in_a_book() {
        let cases = [
            (
                quote!(0.5 * m[i] * dot(r[i]).norm_squared()),
                "½ mᵢ |r\u{307}ᵢ|²",
            ),
            (quote!(i1 * dot(theta[k - 1]).powi(2)), "I₁ θ̇ₖ₋₁²"),
            (
                quote!((0..=i).map(|k| l * sin(theta[k])).sum()),
                "Σₖ₌₀ⁱ l sin θₖ",
            ),
            (
                quote!((1..n).map(|k| x + l).sum() * g),
                "(Σₖ₌₁ⁿ⁻¹ (x + l)) g",
            ),
            (quote!(-mass * g * (x - l)), "−mass·g (x − l)"),
            (quote!(x - (l - g)), "x − (l − g)"),
            (quote!(x - -l), "x − (−l)"),
            (quote!(x + -l), "x − l"),
            (quote!(x / (l * g)), "x/(l g)"),
            (quote!(x / l / g), "x/l/g"),
            (quote!(2.0 * 3.0 * x), "2·3 x"),
            (quote!(-(x + l) * g), "−(x + l) g"),
            (quote!((-x + l) * g), "(−x + l) g"),
            (quote!((-x + l) / g), "(−x + l)/g"),
            (quote!(-x / l), "−x/l"),
            (quote!(x / l * g), "(x/l) g"),
            (quote!(x * (l / g)), "x l/g"),
            (quote!(sin(x) / l), "sin(x)/l"),
            (quote!(sin(x).powi(2)), "sin²x"),
            (quote!(1.4 * x), "7 x/5"),
            (quote!((-x).powi(2)), "(−x)²"),
            (quote!(sin(x + l)), "sin(x + l)"),
            (quote!((x + l).cos() * g), "cos(x + l) g"),
            (quote!((x * l).sqrt()), "√(x l)"),
            (quote!(dot(dot(x))), "x\u{308}"),
            (quote!(dot(x * l)), "d/dt (x l)"),
            (quote!([x, -l].dot([l, g])), "(x, −l)·(l, g)"),
            (quote!(rotation_zxz(x, l, g)), "R_zxz(x, l, g)"),
            (
                quote!(potential_energy(
                    link,
                    rotation_x(x),
                    [0.0, 0.0, l],
                    [0.0, 0.0, -g]
                )),
                "m g ((0, 0, l) + R_x(x) r_C)_z",
            ),
        ];
        assert_printed(&cases);
        let latex = printed(&parse_quote!(x / (l * g) * sqrt(m[k]))).map(|texts| texts[1].clone());
        assert_eq!(latex.as_deref(), Some("\\frac{x}{l g} \\sqrt{m_{k}}"));
    }

    #[test]
    fn components_have_letters_and_functions_the_names_of_books() {
        let cases = [
            (quote!(r[2].y), "r₂_y"),
            (quote!(r[2][1]), "r₂_y"),
            (quote!(m.y), "m₁"),
            (quote!(m[(0, 1)]), "m₀₁"),
            (quote!((x * r[0]).dot(r[1])), "(x r₀)·r₁"),
            (quote!(-m * r[0].dot(r[1])), "−m (r₀·r₁)"),
            (quote!(r[0].dot(r[1]) * x), "(r₀·r₁) x"),
            (quote!(-r[0].dot(r[1])), "−r₀·r₁"),
            (quote!(-r[0].dot(r[1]) * x), "−(r₀·r₁) x"),
            (quote!(x - r[0].dot(r[1])), "x − r₀·r₁"),
            (quote!(x - -r[0].dot(r[1])), "x − (−r₀·r₁)"),
            (quote!(x + -r[0].dot(r[1])), "x − r₀·r₁"),
            (quote!(0.5 * r[0].dot(r[1])), "½ r₀·r₁"),
            (quote!(r[0].dot(r[1]).powi(2)), "(r₀·r₁)²"),
            (quote!(asin(x)), "arcsin x"),
            (quote!(signum(x + l)), "sgn(x + l)"),
            (quote!(exp(x)), "exp(x)"),
            (quote!(component_mul(m, r[0])), "diag(m) r₀"),
        ];
        assert_printed(&cases);
    }

    #[test]
    fn what_has_no_notation_is_not_printed() {
        for expression in [
            parse_quote!((0..3).map(|k| theta[k]).collect()),
            parse_quote!(theta[2 * k]),
            parse_quote!([[x, l], [g, x]]),
            parse_quote!(outer(x, l)),
            parse_quote!((0..3).map(|l| theta[l]).sum()),
        ] {
            assert_eq!(printed(&expression), None);
        }
    }
}
