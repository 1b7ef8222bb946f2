//! A declaration is typed from its beginning to its end, and editors expand it after each word: there
//! are impls at any time, and one error at most.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::quote;

use crate::expand::expand;

fn declaration() -> TokenStream {
    quote! {
        scalar = f64,
        coordinates(theta[3], x, s[2]: SVector<f64, 2>, q[2][3]),
        function(slope(v) = self.table.iter().map(|x| x * v).sum::<f64>()),
        function(
            stribeck(v, load) = friction::stribeck(v) * load,
            derivative(v) = slope(v) * load + 0.1 * c * abs(v),
            derivative(load) = stribeck(v, 1.0),
        ),
        define(
            r = rotation_zxz(theta[0], theta[1], theta[2]),
            w = angular_velocity(r),
            e = dot(x).powi(2) + dot(s[0]).norm_squared() + dot(s[1].x).powi(2) + dot(s[1][1]).powi(2)
                + dot(vector(q)).norm_squared(),
            p[0] = [x, 0.0],
            p[i] = p[i - 1] + l[i] * [sin(theta[i]), -cos(theta[i])] for i in 1..3,
        ),
        kinetic = 0.5 * (e + w.dot(inertia * w)),
        kinetic = 0.5 * (0..3).map(|i| m[i] * dot(p[i]).norm_squared()).sum(),
        potential = g * (0..3).map(|i| m[i] * p[i].y).sum(),
        dissipation = 0.5 * c * dot(x).powi(2),
        force(s[1] = [g, 0.0], q[0][1] = push, s[0].y = c),
        force(x = push - stribeck(dot(x), m[0] * g), theta[i] = -c * dot(theta[i]) for i in 0..3),
        output(tip = p[2], turned = (r * [0.0, 0.0, l[2]]).z, sensed = dot(dot(x))),
    }
}

/// The first `count` tokens, in groups and outside; groups are closed, as editors do.
fn beginning(tokens: TokenStream, count: &mut usize) -> TokenStream {
    let mut result = Vec::new();
    for token in tokens {
        if *count == 0 {
            break;
        }
        *count -= 1;
        match token {
            TokenTree::Group(group) => {
                let stream = beginning(group.stream(), count);
                let mut typed = Group::new(group.delimiter(), stream);
                typed.set_span(group.span());
                result.push(typed.into());
            }
            token => result.push(token),
        }
    }
    result.into_iter().collect()
}

/// How many tokens there are, in groups and outside.
fn size(tokens: TokenStream) -> usize {
    let inner = |token| match token {
        TokenTree::Group(group) => 1 + size(group.stream()),
        _ => 1,
    };
    tokens.into_iter().map(inner).sum()
}

fn expansion(clauses: &TokenStream) -> String {
    let items = expand(quote! {
        #[lagrangian(#clauses)]
        struct Model {
            inertia: Matrix3<f64>, m: [f64; 3], l: [f64; 3], g: f64, c: f64,
            #[lagrangian(input)] push: f64,
            #[lagrangian(skip)] table: Vec<f64>,
        }
    });
    let written = items.to_string();
    assert!(
        syn::parse2::<syn::File>(items).is_ok(),
        "no items: {written}"
    );
    written
}

fn errors(expansion: &str) -> usize {
    expansion.matches("compile_error").count()
}

fn has_impl(expansion: &str) -> bool {
    expansion.contains(":: lagrangian :: Lagrangian <")
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn every_beginning_has_an_impl_and_at_most_one_error() {
    type_beginnings(1);
}

#[test]
fn some_beginnings_have_an_impl_and_at_most_one_error() {
    type_beginnings(7);
}

/// Types the declaration up to every token of so many.
fn type_beginnings(stride: usize) {
    let whole = declaration();
    let length = size(whole.clone());
    let mut finished = 0;
    for count in (0..=length).step_by(stride) {
        let typed = beginning(whole.clone(), &mut { count });
        let expansion = expansion(&typed);
        let errors = errors(&expansion);
        assert!(has_impl(&expansion), "no impl at {typed}");
        assert!(errors <= 1, "{errors} errors at {typed}:\n{expansion}");
        finished += usize::from(errors == 0);
    }
    // Some beginnings are declarations, and most are not.
    assert!(
        (1 + 4 / stride..length / (2 * stride)).contains(&finished),
        "{finished} of {length}"
    );
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn a_token_left_out_leaves_an_impl() {
    leave_out(0, 1);
}

#[test]
fn some_tokens_left_out_leave_an_impl() {
    leave_out(3, 17);
}

/// Leaves out one token of so many, from one on.
fn leave_out(first: usize, stride: usize) {
    let whole = declaration();
    for missing in (first..size(whole.clone())).step_by(stride) {
        let typed = without(whole.clone(), &mut { missing });
        assert!(has_impl(&expansion(&typed)), "no impl at {typed}");
    }
}

/// The tokens but for the one at `position`.
fn without(tokens: TokenStream, position: &mut usize) -> TokenStream {
    let mut result = Vec::new();
    for token in tokens {
        let here = *position == 0;
        *position = position.wrapping_sub(1);
        match token {
            TokenTree::Group(group) => {
                let delimiter = if here {
                    Delimiter::None
                } else {
                    group.delimiter()
                };
                let stream = without(group.stream(), position);
                result.push(Group::new(delimiter, stream).into());
            }
            _ if here => {}
            token => result.push(token),
        }
    }
    result.into_iter().collect()
}
