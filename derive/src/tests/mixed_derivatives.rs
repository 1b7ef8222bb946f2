//! Second derivatives of external functions of several arguments are validated, too.

use lagrangian_symbolic as symbolic;
use lagrangian_symbolic::Program;
use proc_macro2::TokenStream;
use quote::quote;

use crate::plan::Methods;
use crate::tests::derived::{Derived, derive};
use crate::tests::validation::altered;

/// A particle on a surface, of which the functions in `clauses` are known.
fn surface(clauses: &TokenStream) -> TokenStream {
    quote! {
        #[lagrangian(
            scalar = f64,
            coordinates(x, y),
            #clauses
            kinetic = 0.5 * (m + h(x, y)) * dot(x).powi(2) + 0.5 * m * dot(y).powi(2),
            potential = m * g * h(x, y),
        )]
        struct Particle { m: f64, g: f64 }
    }
}

/// Declared derivatives whose mixed ones are equal by what is declared, or must be.
fn declarations() -> Vec<(&'static str, TokenStream)> {
    vec![
        (
            "two names",
            quote! {
                function(h(x, y) = h(x, y), derivative(x) = hx(x, y), derivative(y) = hy(x, y)),
                function(hx(x, y) = hx(x, y), derivative(x) = hxx(x, y), derivative(y) = hxy(x, y)),
                function(hy(x, y) = hy(x, y), derivative(x) = hyx(x, y), derivative(y) = hyy(x, y)),
                function(hxx(x, y) = hxx(x, y)),
                function(hxy(x, y) = hxy(x, y)),
                function(hyx(x, y) = hyx(x, y)),
                function(hyy(x, y) = hyy(x, y)),
            },
        ),
        (
            "one name",
            quote! {
                function(h(x, y) = h(x, y), derivative(x) = hx(x, y), derivative(y) = hy(x, y)),
                function(hx(x, y) = hx(x, y), derivative(x) = hxx(x, y), derivative(y) = hxy(x, y)),
                function(hy(x, y) = hy(x, y), derivative(x) = hxy(x, y), derivative(y) = hyy(x, y)),
                function(hxx(x, y) = hxx(x, y)),
                function(hxy(x, y) = hxy(x, y)),
                function(hyy(x, y) = hyy(x, y)),
            },
        ),
        (
            "formulas",
            quote! {
                kinetic = 0.5 * m * dot(h(x, y)).powi(2),
                function(
                    h(x, y) = h(x, y),
                    derivative(x) = 2 * x * sin(y),
                    derivative(y) = x.powi(2) * cos(y),
                ),
            },
        ),
        (
            "a formula and a function",
            quote! {
                kinetic = 0.5 * m * dot(h(x, y)).powi(2),
                function(
                    h(x, y) = h(x, y),
                    derivative(x) = 2 * x * f(y),
                    derivative(y) = x.powi(2) * fy(y),
                ),
                function(f(y) = f(y), derivative(y) = fy(y)),
                function(fy(y) = fy(y), derivative(y) = -f(y)),
            },
        ),
        (
            "multiples",
            quote! {
                function(h(x, y) = h(x, y), derivative(x) = 3 * hx(x, y), derivative(y) = 3 * hy(x, y)),
                function(hx(x, y) = hx(x, y), derivative(x) = hxx(x, y), derivative(y) = x * hxy(x, y)),
                function(hy(x, y) = hy(x, y), derivative(x) = x * hyx(x, y), derivative(y) = hyy(x, y)),
                function(hxx(x, y) = hxx(x, y)),
                function(hxy(x, y) = hxy(x, y)),
                function(hyx(x, y) = hyx(x, y)),
                function(hyy(x, y) = hyy(x, y)),
            },
        ),
    ]
}

type Slot = fn(&mut Methods) -> &mut Program;

/// Programs that take second derivatives.
const SLOTS: [(symbolic::Method, Slot); 3] = [
    (symbolic::Method::Forcing, |methods| {
        &mut methods.forcing.program
    }),
    (symbolic::Method::InverseDynamics, |methods| {
        &mut methods.inverse_dynamics.program
    }),
    (symbolic::Method::Linearization, |methods| {
        &mut methods.linearize.as_mut().unwrap().program
    }),
];

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn wrong_second_derivatives_are_noticed() {
    notice_wrong_second_derivatives(1);
}

#[test]
fn some_wrong_second_derivatives_are_noticed() {
    notice_wrong_second_derivatives(3);
}

/// In one instruction of so many.
fn notice_wrong_second_derivatives(stride: usize) {
    for (what, clauses) in declarations() {
        let Derived {
            validator,
            mut methods,
            ..
        } = derive(surface(&clauses));
        let found = methods.disagreements(&validator);
        assert!(found.is_empty(), "{what}: {found:?}");
        for (method, slot) in SLOTS {
            let program = slot(&mut methods).clone();
            let mut noticed = 0;
            let mut count = 0;
            for position in (0..program.instructions().count()).step_by(stride) {
                let Some(altered) = altered(&program, position) else {
                    continue;
                };
                *slot(&mut methods) = altered;
                let found = methods.disagreements(&validator);
                noticed += usize::from(found.contains(&method));
                count += 1;
            }
            // Pivots are of no use but for their signs.
            assert!(
                noticed > 0 && 10 * noticed >= 9 * count,
                "{what}: {method:?}: {noticed} of {count}"
            );
            *slot(&mut methods) = program;
        }
    }
}

/// Declared derivatives that contradict each other are nobody's defect but the declaration's.
#[test]
fn contradictory_derivatives_are_no_defect_of_programs() {
    let clauses = quote! {
        function(h(x, y) = h(x, y), derivative(x) = 2 * x * sin(y), derivative(y) = 3 * x.powi(2) * cos(y)),
    };
    let Derived {
        validator, methods, ..
    } = derive(surface(&clauses));
    let found = methods.disagreements(&validator);
    assert!(found.is_empty(), "{found:?}");
}
