//! The methods of an integration's loop read parameters in the prepared array alone.

use proc_macro2::{TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::{FnArg, ImplItem, Item, Pat};

use crate::expand::expand;

/// A model with all methods of loops, on scalars, vectors and families of parameters.
fn carousel() -> TokenStream {
    quote! {
        #[lagrangian(
            taylor,
            coordinates(phi, theta[2]),
            function(felt(z) = self.table.at(z), derivative(z) = table_slope * z),
            kinetic = 0.5 * inertia * dot(phi).powi(2)
                + (0..2).map(|i| 0.5 * m[i] * (dot(theta[i]) + cos(theta[i]) * dot(phi)).powi(2)).sum(),
            potential = (0..2).map(|i| m[i] * pull.x * cos(theta[i])).sum() - pull.y * theta[1] + felt(theta[0])
                + k * abs(theta[1] - rest),
            force(theta[1] = u - c * abs(dot(theta[1]))),
            event(far = theta[1] - reach, late = theta[0] - k * rest),
            hamiltonian,
            routhian(Seat),
        )]
        struct Carousel {
            inertia: f64, m: [f64; 2], pull: Vector3<f64>, k: f64, rest: f64, c: f64, reach: f64,
            table_slope: f64,
            #[lagrangian(skip)] table: Table,
            #[lagrangian(input)] u: f64,
        }
    }
}

/// The methods of an expansion that take the prepared array, with the fields that they read.
fn loops(expansion: TokenStream) -> Vec<(String, Vec<String>)> {
    let file: syn::File = syn::parse2(expansion).expect("the expansion is of items");
    let mut found = Vec::new();
    for item in file.items {
        let Item::Impl(item) = item else { continue };
        for function in item.items {
            let ImplItem::Fn(function) = function else {
                continue;
            };
            let takes_prepared = function.sig.inputs.iter().any(|argument| {
                let FnArg::Typed(argument) = argument else {
                    return false;
                };
                matches!(&*argument.pat, Pat::Ident(name) if name.ident == "prepared" || name.ident == "_prepared")
            });
            if takes_prepared {
                let mut fields = Vec::new();
                add_fields(function.block.to_token_stream(), &mut fields);
                found.push((function.sig.ident.to_string(), fields));
            }
        }
    }
    found
}

/// Adds the fields of `self` that tokens read: names behind `self.` that are not called.
fn add_fields(tokens: TokenStream, fields: &mut Vec<String>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (i, token) in tokens.iter().enumerate() {
        if let TokenTree::Group(group) = token {
            add_fields(group.stream(), fields);
        }
        let text = |offset: usize| tokens.get(i + offset).map(ToString::to_string);
        if text(0).as_deref() == Some("self") && text(1).as_deref() == Some(".") {
            let called = text(3).is_some_and(|next| next == ":" || next.starts_with('('));
            fields.extend(text(2).filter(|_| !called));
        }
    }
}

#[test]
fn methods_of_loops_read_no_field() {
    let expansion = expand(carousel());
    let text = expansion.to_string();
    let error = text
        .find("compile_error")
        .map(|start| text.get(start..start + 300));
    assert_eq!(error, None);
    let found = loops(expansion);
    let expected = [
        "lagrangian",
        "momenta",
        "mass_matrix",
        "forcing",
        "accelerations",
        "inverse_dynamics",
        "relative_pivots",
        "taylor_series",
        "branch_series",
        "event_functions",
        "momentum_rates",
        "solved_velocities",
        "eliminated_velocities",
        "ignorable_velocity_series",
    ];
    for name in expected {
        assert!(found.iter().any(|(method, _)| method == name), "{name}");
    }
    for (method, fields) in found {
        assert!(fields.is_empty(), "{method} reads {fields:?}");
    }
}
