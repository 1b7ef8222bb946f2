//! How long an expansion takes, at the optimization level that users get.
//!
//! `cargo test -p lagrangian-derive timing -- --nocapture` prints the times, and with `--include-ignored`
//! also those of long chains. The benchmark reads them, by its names: A1 and A2 are the symmetric and the
//! general top, P5 is a pendulum of five links, S6 an arm in space of six joints. Nothing here asserts a time.
//!
//! The instructions of one expansion are counted by `valgrind --tool=cachegrind` on the test program, with `MODEL=P20` in the
//! environment and the arguments `--exact tests::timing::the_named_model_expands --ignored --test-threads=1`.

use std::env;
use std::time::Instant;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::expand::expand;
use crate::tests::arms::arm;

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
fn pendulum(links: u32) -> TokenStream {
    let angles: Vec<_> = (0..links).map(|i| format_ident!("q{i}")).collect();
    let mut definitions = TokenStream::new();
    let mut kinetic = quote!(0.0);
    let mut potential = quote!(0.0);
    for (i, angle) in (0_u32..).zip(&angles) {
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

/// A quadratic form with all its coefficients: every coordinate meets every other one.
fn dense(coordinates: u32) -> TokenStream {
    let names: Vec<_> = (0..coordinates).map(|i| format_ident!("q{i}")).collect();
    let rows: Vec<_> = (0..coordinates).map(|i| format_ident!("row{i}")).collect();
    let definitions = names.iter().enumerate().map(|(i, name)| {
        let (row, columns) = (&rows[i], &names[..i]);
        quote!(#row = 0.5 * b * dot(#name).powi(2) #(+ a * cos(#name - #columns) * dot(#name) * dot(#columns))*)
    });
    quote! {
        #[lagrangian(
            coordinates(#(#names),*),
            define(#(#definitions),*),
            kinetic = 0.0 #(+ #rows)*,
            potential = -g * (0.0 #(+ cos(#names))*),
        )]
        struct Dense { a: f64, b: f64, g: f64 }
    }
}

/// Expands a model and prints how long that took, which is returned in milliseconds.
fn measure(name: &str, model: TokenStream) -> f64 {
    let start = Instant::now();
    let expansion = expand(model);
    let time = start.elapsed().as_secs_f64() * 1e3;
    let expansion = expansion.to_string();
    println!("{name}: {time:.1} ms, {} characters", expansion.len());
    assert!(!expansion.contains("compile_error"), "{expansion}");
    time
}

/// Expands models of a kind and prints by which power of the number of coordinates the time grows.
fn measure_growth(name: &str, model: fn(u32) -> TokenStream, sizes: &[u32]) {
    let mut previous: Option<(u32, f64)> = None;
    for size in sizes {
        let time = measure(&format!("{name}{size}"), model(*size));
        if let Some((fewer, before)) = previous {
            let ratio = f64::from(*size) / f64::from(fewer);
            println!(
                "    grows with the power {:.1}",
                (time / before).ln() / ratio.ln()
            );
        }
        previous = Some((*size, time));
    }
}

#[test]
fn models_expand() {
    measure("A1", symmetric_top());
    measure("A2", general_top());
    measure_growth("P", pendulum, &[1, 2, 3, 5, 8, 10, 15, 20]);
}

/// In turn, since what else runs on the machine changes; the benchmark takes the least of each.
#[test]
fn models_expand_with_taylor_series() {
    let models = [
        ("A1", symmetric_top()),
        ("A2", general_top()),
        ("P2", pendulum(2)),
    ];
    for _ in 0..5 {
        for (name, model) in &models {
            measure(name, model.clone());
            measure(
                &format!("{name} with taylor"),
                quote!(#[lagrangian(taylor)] #model),
            );
        }
    }
}

#[test]
#[ignore = "takes a minute; run with `--include-ignored`"]
fn long_chains_expand() {
    measure_growth("P", pendulum, &[10, 20, 40, 60]);
}

#[test]
#[ignore = "takes a minute; run with `--include-ignored`"]
fn dense_quadratic_forms_expand() {
    measure_growth("D", dense, &[5, 10, 20, 40, 60]);
}

#[test]
#[ignore = "takes a minute; run with `--include-ignored`"]
fn arms_in_space_expand() {
    let arm = |links| arm(links as usize);
    measure_growth("S", arm, &[3, 6, 10, 15, 20, 30]);
}

#[test]
#[ignore = "counted in instructions, one model at a time"]
fn the_named_model_expands() {
    let name = env::var("MODEL").unwrap_or_else(|_| String::from("P5"));
    let (kind, size) = name.split_at(1);
    let size: u32 = size.parse().expect("a letter and a size, such as P20");
    let model = match kind {
        "P" => pendulum(size),
        "D" => dense(size),
        _ => arm(size as usize),
    };
    measure(&name, model);
}
