//! Solutions whose denominators stand within each other are printed as one quotient.

use quote::quote;

use crate::expand::expand;
use crate::tests::pages::constant;

fn has_line(page: &str, line: &str) -> bool {
    page.lines().any(|found| found == line)
}

#[test]
fn a_pendulum_on_a_cart_has_one_denominator() {
    let page = constant(
        &expand(quote! {
            #[lagrangian(
                coordinates(x, theta),
                kinetic = 0.5 * (M + m) * dot(x).powi(2) + m * l * dot(x) * dot(theta) * cos(theta)
                    + 0.5 * m * l.powi(2) * dot(theta).powi(2),
                potential = -m * g * l * cos(theta),
            )]
            struct Cart { M: f64, m: f64, l: f64, g: f64 }
        }),
        "EQUATIONS",
    );
    let lines = [
        "x\u{308} = m (l θ\u{307}² + g cos θ) sin(θ)/(M + m sin²θ)",
        "θ\u{308} = −(m (l θ\u{307}² cos θ + g) + M g) sin(θ)/(l (M + m sin²θ))",
    ];
    for line in lines {
        assert!(has_line(&page, line), "{page}");
    }
}

#[test]
fn a_mass_on_a_movable_wedge_has_one_denominator() {
    let page = constant(
        &expand(quote! {
            #[lagrangian(
                coordinates(s, y),
                kinetic = 0.5 * M * dot(y).powi(2) + 0.5 * m * (dot(y) + dot(s) * cos(alpha)).powi(2)
                    + 0.5 * m * (dot(s) * sin(alpha)).powi(2),
                potential = -m * g * s * sin(alpha),
            )]
            struct Wedge { M: f64, m: f64, alpha: f64, g: f64 }
        }),
        "EQUATIONS",
    );
    let line = "s\u{308} = g (M + m) sin(α)/(M + m sin²α)";
    assert!(has_line(&page, line), "{page}");
}
