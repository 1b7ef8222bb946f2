//! The statements of a method, while they are written.
//!
//! In a short method each variable is a `let`. Each `let` opens a scope in the one before, and rustc descends
//! scope by scope where it writes what debuggers read: deep down its stack overflows. So the variables of a
//! long method are declared many at once, by one pattern, and then assigned.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::scalar::Scalar;

/// How many scopes may be nested with a `let` for each variable. rustc 1.95 without optimization overflows at
/// 2500; the derivatives of an arm of six joints in space have as many variables.
pub(crate) const MOST_SCOPES: usize = 1000;

/// How many variables are declared at once in a long method.
const DECLARED_AT_ONCE: usize = 200;

/// The statements of one method.
pub(super) struct Block {
    is_long: bool,
    written: TokenStream,
    /// In a long method: what is still to be declared, and the statements that assign it.
    declared: Vec<Ident>,
    assignments: TokenStream,
}

impl Block {
    pub(super) fn new(is_long: bool) -> Self {
        Self {
            is_long,
            written: TokenStream::new(),
            declared: Vec::new(),
            assignments: TokenStream::new(),
        }
    }

    /// Gives a variable the value that is read from elsewhere.
    pub(super) fn read(&mut self, name: &Ident, value: &TokenStream, scalar: &Scalar<'_>) {
        if self.is_long {
            self.assign(core::slice::from_ref(name), &quote!(#name), value, scalar);
        } else {
            self.written.extend(quote!(let #name: #scalar = #value;));
        }
    }

    /// Gives the variables `names` of a pattern their values.
    pub(super) fn define(
        &mut self,
        names: &[Ident],
        pattern: &TokenStream,
        value: &TokenStream,
        scalar: &Scalar<'_>,
    ) {
        if self.is_long {
            self.assign(names, pattern, value, scalar);
        } else {
            self.written.extend(quote!(let #pattern = #value;));
        }
    }

    fn assign(
        &mut self,
        names: &[Ident],
        pattern: &TokenStream,
        value: &TokenStream,
        scalar: &Scalar<'_>,
    ) {
        if self.declared.len() >= DECLARED_AT_ONCE {
            self.declare(scalar);
        }
        self.declared.extend_from_slice(names);
        self.assignments.extend(quote!(#pattern = #value;));
    }

    /// Writes the declarations and assignments that are due.
    fn declare(&mut self, scalar: &Scalar<'_>) {
        let declared = core::mem::take(&mut self.declared);
        if !declared.is_empty() {
            let count = declared.len();
            self.written
                .extend(quote!(let [#(#declared),*]: [#scalar; #count];));
            self.written.extend(core::mem::take(&mut self.assignments));
        }
    }

    /// The statements since the last time.
    pub(super) fn take(&mut self, scalar: &Scalar<'_>) -> TokenStream {
        self.declare(scalar);
        core::mem::take(&mut self.written)
    }
}

#[cfg(test)]
mod tests {
    use proc_macro2::{TokenStream, TokenTree};

    use super::MOST_SCOPES;
    use crate::expand::expand_within;

    /// Of these links' derivatives there are just more variables than scopes may be nested.
    const CHAIN: &str = r"
        #[lagrangian(
            coordinates(theta[20]),
            define(
                p[0] = l[0] * [sin(theta[0]), -cos(theta[0])],
                p[i] = p[i - 1] + l[i] * [sin(theta[i]), -cos(theta[i])] for i in 1..20,
            ),
            kinetic = (0..20).map(|i| 0.5 * m[i] * dot(p[i]).norm_squared()).sum(),
            potential = (0..20).map(|i| m[i] * g * p[i].y).sum(),
        )]
        struct Chain { m: [f64; 20], l: [f64; 20], g: f64 }
    ";

    /// The words `let` in the longest body of a method.
    fn most_scopes(tokens: TokenStream) -> usize {
        let scopes = tokens.into_iter().map(|token| match token {
            TokenTree::Group(group) => {
                let own = group.stream().into_iter();
                let own =
                    own.filter(|token| matches!(token, TokenTree::Ident(word) if word == "let"));
                own.count().max(most_scopes(group.stream()))
            }
            _ => 0,
        });
        scopes.max().unwrap_or(0)
    }

    fn expansion(most_scopes: usize) -> TokenStream {
        expand_within(
            CHAIN.parse().expect("the declaration is of tokens"),
            most_scopes,
        )
    }

    #[test]
    fn no_method_nests_more_scopes_than_the_compiler_bears() {
        assert!(most_scopes(expansion(usize::MAX)) > MOST_SCOPES);
        let chain = expansion(MOST_SCOPES);
        assert!(syn::parse2::<syn::File>(chain.clone()).is_ok());
        assert!(most_scopes(chain) <= MOST_SCOPES);
    }
}
