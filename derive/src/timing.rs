//! How long an expansion takes, at the optimization level that users get.
//!
//! `cargo test -p lagrangian-derive timing -- --nocapture` prints the times; the benchmark reads
//! them, by its names: A1 and A2 are the symmetric and the general top, P5 is a pendulum of five links.
//! Nothing here asserts a time.

use std::time::Instant;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::expand::expand;

fn symmetric_top() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(phi, theta, psi),
            kinetic = 0.5 * (i * (dot(phi).powi(2) * sin(theta).powi(2) + dot(theta).powi(2))
                + i_s * (dot(phi) * cos(theta) + dot(psi)).powi(2)),
            potential = m * g * l * cos(theta),
        )]
        struct SymmetricTop { i: f64, i_s: f64, m: f64, g: f64, l: f64 }
    }
}

fn general_top() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(phi, theta, psi),
            define(
                w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
                w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
                w3 = dot(phi) * cos(theta) + dot(psi),
            ),
            kinetic = 0.5 * (i1 * w1.powi(2) + i2 * w2.powi(2) + i3 * w3.powi(2)),
            potential = m * g
                * (x * sin(theta) * sin(psi) + y * sin(theta) * cos(psi) + z * cos(theta)),
        )]
        struct GeneralTop { i1: f64, i2: f64, i3: f64, m: f64, g: f64, x: f64, y: f64, z: f64 }
    }
}

/// A chain of point masses on massless rods, at absolute angles.
fn pendulum(links: usize) -> TokenStream {
    let angles: Vec<_> = (0..links).map(|i| format_ident!("q{i}")).collect();
    let mut definitions = TokenStream::new();
    let mut kinetic = quote!(0.0);
    let mut potential = quote!(0.0);
    for (i, angle) in angles.iter().enumerate() {
        let [x, y] = ["x", "y"].map(|axis| format_ident!("{axis}{i}"));
        let [above_x, above_y] = match i.checked_sub(1) {
            Some(above) => ["x", "y"].map(|axis| {
                let name = format_ident!("{axis}{above}");
                quote!(#name)
            }),
            None => [quote!(0.0), quote!(0.0)],
        };
        definitions
            .extend(quote!(#x = #above_x + l * sin(#angle), #y = #above_y - l * cos(#angle),));
        kinetic.extend(quote!(+ 0.5 * m * (dot(#x).powi(2) + dot(#y).powi(2))));
        potential.extend(quote!(+ m * g * #y));
    }
    quote! {
        #[lagrangian(
            coordinates(#(#angles),*),
            define(#definitions),
            kinetic = #kinetic,
            potential = #potential,
        )]
        struct Pendulum { m: f64, g: f64, l: f64 }
    }
}

#[test]
fn models_expand() {
    let tops = [("A1".into(), symmetric_top()), ("A2".into(), general_top())];
    let links = [1, 2, 3, 5, 8, 10, 15, 20];
    let pendulums = links.map(|links| (format!("P{links}"), pendulum(links)));
    for (name, model) in tops.into_iter().chain(pendulums) {
        let start = Instant::now();
        let expansion = expand(model).to_string();
        println!(
            "{name}: {:.1} ms, {} characters",
            start.elapsed().as_secs_f64() * 1e3,
            expansion.len()
        );
        assert!(!expansion.contains("compile_error"), "{expansion}");
    }
}
