//! Equations of families of coordinates as one equation in print: only where it is identically all of them.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::expand::expand;
use crate::tests::pages::constant;

/// Links of which each hangs on the one before, with their masses at their ends or spread over them.
fn chain(links: usize, rods: bool, mass_of_first: f64) -> String {
    let n = Literal::usize_unsuffixed(links);
    let (half, inertia): (TokenStream, TokenStream) = if rods {
        (
            quote!(0.5),
            quote!(m * l.powi(2) / 24 * dot(theta[i]).powi(2)),
        )
    } else {
        (quote!(1.0), quote!(0.0))
    };
    constant(
        &expand(quote! {
            #[lagrangian(
                coordinates(theta[#n]),
                define(p[i] = (0..i).map(|k| l * [sin(theta[k]), -cos(theta[k])]).sum()
                    + #half * l * [sin(theta[i]), -cos(theta[i])] for i in 0..#n),
                kinetic = 0.5 * (#mass_of_first - 1.0) * m * dot(p[0]).norm_squared(),
                kinetic = (0..#n).map(|i| 0.5 * m * dot(p[i]).norm_squared() + #inertia).sum(),
                potential = (0..#n).map(|i| m * g * p[i].y).sum(),
            )]
            struct Chain { m: f64, l: f64, g: f64 }
        }),
        "EQUATIONS",
    )
}

fn has_line(page: &str, line: &str) -> bool {
    page.lines().any(|found| found == line)
}

#[test]
fn equal_links_have_a_factor_that_is_linear_in_the_index() {
    for (links, range) in [(3, "0, 1, 2"), (4, "0, …, 3"), (6, "0, …, 5")] {
        let page = chain(links, false, 1.0);
        let last = ['²', '³', '⁴', '⁵'][links - 3];
        let line = format!(
            "Σⱼ₌₀{last} m l² ({links} − max(i,j)) (θ\u{308}ⱼ cos(θᵢ − θⱼ) + θ\u{307}ⱼ² sin(θᵢ − θⱼ)) \
             + m l g ({links} − i) sin θᵢ = 0  (i = {range})"
        );
        assert!(has_line(&page, &line), "{page}");
    }
}

#[test]
fn what_the_diagonal_has_besides_stands_beside_the_sum() {
    // Of rods, Mᵢⱼ = m l² (n − ½ − max(i, j)) cos(θᵢ − θⱼ), and Mᵢᵢ = m l² (n − ⅔ − i).
    let page = chain(5, true, 1.0);
    let momenta = "p_θᵢ = Σⱼ₌₀⁴ ½ m l² (9 − 2 max(i,j)) θ\u{307}ⱼ cos(θᵢ − θⱼ) − ⅙ m l² θ\u{307}ᵢ  (i = 0, …, 4)";
    assert!(has_line(&page, momenta), "{page}");
}

/// A difference of one part in 10¹² is one.
#[test]
fn nearly_equal_links_are_not_folded() {
    for links in [3, 6] {
        let page = chain(links, false, 1.0 + 1e-12);
        assert!(!page.contains("max(i,j)"), "{page}");
    }
}

/// Numbers of a family with two indices are not those of one.
#[test]
fn members_with_two_indices_are_not_taken_for_others() {
    let page = constant(
        &expand(quote! {
            #[lagrangian(
                coordinates(theta[6]),
                define(p[i] = (0..=i).map(|k| k_0[2][1] * [sin(theta[k]), -cos(theta[k])]).sum() for i in 0..6),
                kinetic = (0..6).map(|i| 0.5 * m * dot(p[i]).norm_squared()).sum(),
            )]
            struct Chain { m: f64, k_0: [[f64; 4]; 3] }
        }),
        "EQUATIONS",
    );
    assert!(
        !page.contains("k_0ᵢ") && !page.contains("k₀,ᵢ") && !page.contains("max(i,j)"),
        "{page}"
    );
}

/// A cart has an equation of its own, and its links one.
#[test]
fn a_family_is_folded_beside_other_coordinates() {
    let page = constant(
        &expand(quote! {
            #[lagrangian(
                coordinates(x, theta[6]),
                define(p[i] = [x, 0.0]
                    + (0..=i).map(|k| l * [sin(theta[k]), -cos(theta[k])]).sum() for i in 0..6),
                kinetic = 0.5 * cart * dot(x).powi(2)
                    + (0..6).map(|i| 0.5 * m * dot(p[i]).norm_squared()).sum(),
                potential = (0..6).map(|i| m * g * p[i].y).sum(),
                force(x = push),
            )]
            struct Cart { cart: f64, m: f64, l: f64, g: f64, push: f64 }
        }),
        "EQUATIONS",
    );
    let line = "Σⱼ₌₀⁵ m l² (6 − max(i,j)) (θ\u{308}ⱼ cos(θᵢ − θⱼ) + θ\u{307}ⱼ² sin(θᵢ − θⱼ)) \
                + m l (6 − i) (x\u{308} cos θᵢ + g sin θᵢ) = 0  (i = 0, …, 5)";
    assert!(has_line(&page, line), "{page}");
    assert!(!page.contains("too long"), "{page}");
}

/// A stiffness k and lengths that are called j are no indices.
#[test]
fn indices_have_letters_of_their_own() {
    let page = constant(
        &expand(quote! {
            #[lagrangian(
                coordinates(theta[6]),
                define(p[a] = (0..=a).map(|b| j[b] * [sin(theta[b]), -cos(theta[b])]).sum() for a in 0..6),
                kinetic = (0..6).map(|a| 0.5 * m[a] * dot(p[a]).norm_squared()).sum(),
                potential = (0..6).map(|a| 0.5 * k * theta[a].powi(2)).sum(),
            )]
            struct Chain { m: [f64; 6], j: [f64; 6], k: f64 }
        }),
        "EQUATIONS",
    );
    assert!(
        has_line(&page, "V = ½ k (Σₙ₌₀⁵ θₙ²)") || page.contains("Σₙ₌₀⁵"),
        "{page}"
    );
    assert!(!page.contains("Σⱼ") && !page.contains("k="), "{page}");
}
