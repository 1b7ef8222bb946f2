//! The clause `body`, with the energies for which it stands.
//!
//! `body(upper = (r, p))` stands for `kinetic = kinetic_energy(upper, r, p)`, and with the clause `gravity = g` for `potential =
//! potential_energy(upper, r, p, g)`, too. Of several bodies these are sums.

use proc_macro2::Ident;
use syn::parse::ParseStream;
use syn::spanned::Spanned as _;
use syn::{Expr, parse_quote, parse_quote_spanned};

use crate::syntax::named::{NamedExpression, named_expressions};

/// `upper = (r, p)` or `links[i] = (r[i], p[i]) for i in 0..6`: a body, its rotation, and the position of its origin.
pub(crate) struct PlacedBody {
    /// The word `body`.
    pub(crate) keyword: Ident,
    placed: NamedExpression,
}

impl PlacedBody {
    /// `(upper = (r, p), …)` behind the keyword.
    pub(crate) fn read(
        keyword: &Ident,
        input: ParseStream<'_>,
        bodies: &mut Vec<Self>,
    ) -> syn::Result<()> {
        let mut all = Vec::new();
        let read = named_expressions(keyword, input, &mut all);
        for placed in all {
            if !matches!(&placed.expression, Expr::Tuple(pair) if pair.elems.len() == 2) {
                let name = &placed.name;
                let message = format!(
                    "write `{name} = (r, p)`: the rotation from the axes of the body to inertial ones, and the position \
                     of their origin"
                );
                return Err(syn::Error::new_spanned(&placed.expression, message));
            }
            let keyword = keyword.clone();
            bodies.push(Self { keyword, placed });
        }
        read
    }

    /// The kinetic energy for which the clause stands.
    pub(crate) fn kinetic(&self) -> Expr {
        self.energy("kinetic_energy", None)
    }

    /// The potential energy for which the clause stands, with the acceleration of gravity.
    pub(crate) fn potential(&self, gravity: &Expr) -> Expr {
        self.energy("potential_energy", Some(gravity))
    }

    /// The sum over all values of the indices of a function of the body, of where it is, and of another argument.
    fn energy(&self, function: &str, last: Option<&Expr>) -> Expr {
        let NamedExpression {
            name,
            indices,
            expression,
            iterations,
        } = &self.placed;
        let function = Ident::new(function, name.span());
        let place = match expression {
            Expr::Tuple(pair) => pair.elems.iter().collect(),
            other => vec![other],
        };
        let place = place.into_iter().chain(last);
        let mut energy: Expr = parse_quote_spanned! {
            expression.span()=> #function(#name #([#indices])*, #(#place),*)
        };
        for iteration in iterations.iter().rev() {
            let (index, range) = (&iteration.index, &iteration.range);
            energy = parse_quote!((#range).map(|#index| #energy).sum());
        }
        energy
    }
}
