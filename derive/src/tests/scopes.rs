//! No method nests more scopes than rustc bears.

use proc_macro2::{TokenStream, TokenTree};

use crate::expand::expand_within;
use crate::limits::{MOST_SCOPES, MethodLimits};

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
            let own = own.filter(|token| matches!(token, TokenTree::Ident(word) if word == "let"));
            own.count().max(most_scopes(group.stream()))
        }
        _ => 0,
    });
    scopes.max().unwrap_or(0)
}

fn expansion(most_scopes: usize) -> TokenStream {
    let limits = MethodLimits {
        most_scopes,
        ..MethodLimits::OF_EXPANSIONS
    };
    expand_within(CHAIN.parse().expect("the declaration is of tokens"), limits)
}

#[test]
fn no_method_nests_more_scopes_than_the_compiler_bears() {
    assert!(most_scopes(expansion(usize::MAX)) > MOST_SCOPES);
    let chain = expansion(MOST_SCOPES);
    assert!(syn::parse2::<syn::File>(chain.clone()).is_ok());
    assert!(most_scopes(chain) <= MOST_SCOPES);
}
