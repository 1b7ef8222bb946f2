//! Lagrange's equations of members that act on each other in pairs as one equation, only where it is identically all of them.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::expand::expand;
use crate::tests::pages::constant;

/// Bodies with a potential of each pair, and a potential besides.
fn pairs(
    bodies: usize,
    position: &TokenStream,
    pair: &TokenStream,
    besides: &TokenStream,
) -> String {
    let n = Literal::usize_unsuffixed(bodies);
    constant(
        &expand(quote! {
            #[lagrangian(
                coordinates(#position),
                kinetic = (0..#n).map(|i| 0.5 * m[i] * dot(r[i]).norm_squared()).sum(),
                potential = (0..#n).map(|i| (0..i).map(|j| #pair).sum()).sum(),
                potential = #besides,
            )]
            struct Bodies { m: [f64; #n], e: [f64; #n], g: f64, k: f64, h: f64 }
        }),
        "EQUATIONS",
    )
}

fn in_space(bodies: usize, pair: &TokenStream) -> String {
    let n = Literal::usize_unsuffixed(bodies);
    pairs(bodies, &quote!(r[#n]: Vector3), pair, &quote!(0.0 * h))
}

/// Masses on a line.
fn on_a_line(
    bodies: usize,
    pair: &TokenStream,
    besides: &TokenStream,
    forces: &TokenStream,
) -> String {
    let n = Literal::usize_unsuffixed(bodies);
    constant(
        &expand(quote! {
            #[lagrangian(
                coordinates(x[#n]),
                kinetic = (0..#n).map(|i| 0.5 * m[i] * dot(x[i]).powi(2)).sum(),
                potential = (0..#n).map(|i| (0..i).map(|j| #pair).sum()).sum(),
                potential = #besides,
                #forces
            )]
            struct Masses { m: [f64; #n], e: [f64; #n], g: f64, k: f64, h: f64, push: f64 }
        }),
        "EQUATIONS",
    )
}

fn has_line(page: &str, line: &str) -> bool {
    page.lines().any(|found| found == line)
}

#[test]
fn bodies_that_attract_each_other_have_one_equation_for_each_direction() {
    let gravitation = quote!(-g * m[i] * m[j] / (r[i] - r[j]).norm());
    for (bodies, range) in [(3, "0, 1, 2"), (5, "0, …, 4"), (8, "0, …, 7")] {
        let page = in_space(bodies, &gravitation);
        assert!(!page.contains("too long"), "{page}");
        for axis in ["x", "y", "z"] {
            let found = page
                .lines()
                .filter(|line| line.contains(&format!("r\u{308}ᵢ_{axis}")));
            assert_eq!(found.count(), 1, "{page}");
        }
        if bodies < 8 {
            let line = format!(
                "mᵢ r\u{308}ᵢ_x − mᵢ g (Σ_(j≠i) mⱼ (rⱼ_x − rᵢ_x)/((rⱼ_x − rᵢ_x)² + (rⱼ_y − rᵢ_y)² + (rⱼ_z − rᵢ_z)²)^(3/2)) \
                 = 0  (i = {range})"
            );
            assert!(has_line(&page, &line), "{page}");
        }
    }
    let page = in_space(2, &gravitation);
    assert!(!page.contains('≠'), "{page}");
}

#[test]
fn charges_and_springs_of_all_pairs_have_sums() {
    let pairs = [
        quote!(k * e[i] * e[j] / (r[i] - r[j]).norm() - g * m[i] * m[j] / (r[i] - r[j]).norm()),
        quote!(0.5 * k * ((r[i] - r[j]).norm() - h).powi(2)),
        quote!(0.5 * k * (r[i] - r[j]).norm_squared()),
    ];
    for bodies in [3, 4, 5] {
        for pair in &pairs {
            let page = in_space(bodies, pair);
            let lines = page.lines().filter(|line| line.contains("Σ_(j≠i)"));
            assert_eq!(lines.count(), 3, "{page}");
        }
    }
}

#[test]
fn masses_on_a_line_have_one_equation() {
    let none = quote!();
    let page = on_a_line(
        6,
        &quote!(0.5 * k * (x[i] - x[j]).powi(2)),
        &quote!(0.0 * h),
        &none,
    );
    let line = "mᵢ x\u{308}ᵢ − k (Σ_(j≠i) xⱼ − 5 xᵢ) = 0  (i = 0, …, 5)";
    assert!(has_line(&page, line), "{page}");
    let coulomb = quote!(e[i] * e[j] / (x[i] - x[j]).powi(2));
    let page = on_a_line(5, &coulomb, &quote!(0.0 * h), &none);
    let line = "mᵢ x\u{308}ᵢ + 2 eᵢ (Σ_(j≠i) eⱼ/(xⱼ − xᵢ)³) = 0  (i = 0, …, 4)";
    assert!(has_line(&page, line), "{page}");
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn members_that_differ_are_not_folded() {
    none_is_folded(1);
}

#[test]
fn some_members_that_differ_are_not_folded() {
    none_is_folded(3);
}

/// Of members of which one is held besides, has another mass or is pushed, none has the equation of another: one member of
/// so many.
fn none_is_folded(stride: usize) {
    let none = quote!();
    let free = quote!(0.0 * h);
    let coulomb = quote!(e[i] * e[j] / (x[i] - x[j]).powi(2));
    for odd in (0..5).step_by(stride) {
        let odd = Literal::usize_unsuffixed(odd);
        let page = on_a_line(5, &coulomb, &quote!(0.5 * h * x[#odd].powi(2)), &none);
        assert!(!page.contains('≠'), "{page}");
        let page = on_a_line(5, &coulomb, &free, &quote!(force(x[#odd] = push),));
        assert!(!page.contains('≠'), "{page}");
        let page = on_a_line(5, &coulomb, &quote!(1e-12 * h * x[#odd].powi(2)), &none);
        assert!(!page.contains('≠'), "{page}");
        // The member that all equations have in common is not the one whose equation it is.
        let page = on_a_line(5, &quote!(e[#odd] * (x[i] - x[j]).powi(4)), &free, &none);
        assert!(!page.contains('≠'), "{page}");
    }
    let unequal = quote!(k * (x[i] - x[j]).powi(3));
    let page = on_a_line(5, &unequal, &free, &none);
    assert!(!page.contains('≠'), "{page}");
}
