//! No method nests more scopes than rustc bears.

use std::collections::BTreeSet;

use proc_macro2::{TokenStream, TokenTree};

use crate::expand::expand_within;
use crate::limits::{MAX_SCOPES, MethodLimits};

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
    assert!(most_scopes(expansion(usize::MAX)) > MAX_SCOPES);
    let chain = expansion(MAX_SCOPES);
    assert!(syn::parse2::<syn::File>(chain.clone()).is_ok());
    assert!(most_scopes(chain) <= MAX_SCOPES);
}

/// Of values that are called like variables with numbers.
const NUMBERED: &str = r"
    #[lagrangian(
        coordinates(theta[5], x4),
        define(
            x2 = sin(theta[0]) * sin(theta[1]) + x4.powi(2),
            x1 = x2 * cos(theta[2] - x4),
            x0 = x1 * x2 + sqrt(1.0 + x4.powi(2)),
        ),
        kinetic = (0..5).map(|i| 0.5 * m[i] * dot(theta[i]).powi(2)).sum()
            + 0.5 * dot(x4).powi(2) * (2.0 + cos(theta[0] - theta[1])) + x5 * dot(x4) * dot(theta[0]),
        potential = x0 * x0 + x1 * cos(theta[3] - theta[4]) + x2 * theta[2],
    )]
    struct Numbered { m: [f64; 5], x5: f64 }
";

/// The names that one body gives twice by `let`.
fn repeated_names(tokens: TokenStream, found: &mut Vec<String>) {
    let mut names = BTreeSet::new();
    let tokens: Vec<_> = tokens.into_iter().collect();
    for pair in tokens.windows(2) {
        if let [TokenTree::Ident(word), pattern] = pair
            && word == "let"
        {
            for name in names_in(pattern) {
                if !names.insert(name.clone()) {
                    found.push(name);
                }
            }
        }
    }
    for token in tokens {
        if let TokenTree::Group(group) = token {
            repeated_names(group.stream(), found);
        }
    }
}

/// The names of a pattern: one, or those of arrays and tuples.
fn names_in(pattern: &TokenTree) -> Vec<String> {
    match pattern {
        TokenTree::Ident(name) if name != "mut" && name != "_" => vec![name.to_string()],
        TokenTree::Group(group) => {
            let parts: Vec<_> = group.stream().into_iter().collect();
            parts.iter().flat_map(names_in).collect()
        }
        _ => Vec::new(),
    }
}

/// All names that `let` gives.
fn names(tokens: TokenStream, found: &mut BTreeSet<String>) {
    let tokens: Vec<_> = tokens.into_iter().collect();
    for pair in tokens.windows(2) {
        if let [TokenTree::Ident(word), pattern] = pair
            && word == "let"
        {
            found.extend(names_in(pattern));
        }
    }
    for token in tokens {
        if let TokenTree::Group(group) = token {
            names(group.stream(), found);
        }
    }
}

#[test]
fn no_variable_is_called_like_another() {
    let declaration: TokenStream = NUMBERED.parse().expect("the declaration is of tokens");
    let expansion = expand_within(declaration, MethodLimits::OF_EXPANSIONS);
    let mut found = Vec::new();
    repeated_names(expansion.clone(), &mut found);
    assert!(found.is_empty(), "{found:?}");
    let mut given = BTreeSet::new();
    names(expansion, &mut given);
    let expected = ["x0", "x0_", "x4", "x4_", "x5"];
    assert!(
        expected.iter().all(|name| given.contains(*name)),
        "{given:?}"
    );
}
