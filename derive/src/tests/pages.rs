//! The equations of several models as they are printed: `golden/pages/….rs` becomes `….txt` and, in LaTeX, `….tex`.
//!
//! After a change, write them anew with `GOLDEN=overwrite cargo test -p lagrangian-derive pages`, and read the
//! difference.

use std::path::Path;
use std::{env, fs};

use proc_macro2::TokenStream;
use quote::quote;

use crate::expand::expand;
use crate::tests::arms::arm;

const MODELS: [&str; 12] = [
    "symmetric_top",
    "general_top",
    "body",
    "double_pendulum",
    "cart_pole",
    "springs",
    "bodies",
    "robot_arm",
    "chain",
    "rods",
    "lattice",
    "skater",
];

/// The value of a constant of the model, which is the first one.
pub(super) fn constant(expansion: &TokenStream, name: &str) -> String {
    let mut all = constants(expansion, name).into_iter();
    all.next().expect("there is such a constant")
}

/// The value of a constant of the reduced model.
fn last_constant(expansion: &TokenStream, name: &str) -> String {
    let mut all = constants(expansion, name);
    all.pop().expect("there is such a constant")
}

fn constants(expansion: &TokenStream, name: &str) -> Vec<String> {
    let file: syn::File = syn::parse2(expansion.clone()).expect("the expansion is of items");
    let items = file.items.iter().filter_map(|item| match item {
        syn::Item::Impl(item) => Some(&item.items),
        _ => None,
    });
    let found = items.flatten().filter_map(|item| match item {
        syn::ImplItem::Const(item) if item.ident == name => Some(&item.expr),
        _ => None,
    });
    let text = |value: &syn::Expr| match value {
        syn::Expr::Lit(syn::ExprLit {
            lit: syn::Lit::Str(text),
            ..
        }) => text.value(),
        _ => panic!("no text {name}"),
    };
    found.map(text).collect()
}

/// The equations of a model with bodies.
fn page(fields: &TokenStream, bodies: &TokenStream) -> String {
    constant(
        &expand(quote! {
            #[lagrangian(coordinates(q[2]), #bodies, gravity = [0.0, 0.0, -g])]
            struct Bodies { #fields, g: f64 }
        }),
        "EQUATIONS",
    )
}

/// A root, a quotient and a component that is a product are written out where they are defined.
#[test]
fn definitions_are_not_their_own_names() {
    let equations = constant(
        &expand(quote! {
            #[lagrangian(
                coordinates(x),
                define(h = sqrt(1.0 + x.powi(2)), u = a / (1.0 + x), p = [x + a * sin(x), a * cos(x)]),
                kinetic = 0.5 * m * dot(x).powi(2),
                potential = cos(h) + sin(u) + p.y + p.x,
            )]
            struct Defined { m: f64, a: f64 }
        }),
        "EQUATIONS",
    );
    for line in ["h = √(1 + x²)", "u = a/(1 + x)", "p_y = a cos x"] {
        assert!(
            equations.lines().any(|one| one == line),
            "{line}: {equations}"
        );
    }
}

/// The kinetic energy is long when it is written out, so that definitions are listed as they were declared; Lagrange's
/// equations mention the angle, too.
#[test]
fn definitions_are_listed_once() {
    let expansion = expand(quote! {
        #[lagrangian(
            coordinates(x, y, phi, theta, psi),
            define(
                p = rotation_zxz(phi, theta, psi) * [x, y, c],
                angle = atan2(y, x),
            ),
            kinetic = 0.5 * m * (dot(p).norm_squared() + dot(x).powi(2) + dot(y).powi(2))
                + 0.5 * i * (dot(phi).powi(2) + dot(theta).powi(2) + dot(psi).powi(2)),
            potential = 0.5 * k * angle.powi(2) + m * g * p.z,
        )]
        struct Turned { m: f64, i: f64, c: f64, k: f64, g: f64 }
    });
    for (name, beginning) in [("EQUATIONS", "angle ="), ("LATEX", r"\mathrm{angle} &=")] {
        let equations = constant(&expansion, name);
        let lines = equations.lines().filter(|line| line.starts_with(beginning));
        assert_eq!(lines.count(), 1, "{equations}");
    }
}

/// ln x beside x^y has a guard at x = 0, and half angles have guards at poles: what is printed is what a book has.
#[test]
fn guards_of_removable_singularities_are_not_printed() {
    let expansion = expand(quote! {
        #[lagrangian(
            coordinates(x),
            kinetic = 0.5 * m * dot(x).powi(2),
            potential = e.powf(x) + exp(e * x),
        )]
        struct Power { m: f64, e: f64 }
    });
    for (name, exponential) in [
        ("EQUATIONS", "exp(e x)"),
        ("LATEX", "\\exp\\left(e x\\right)"),
    ] {
        let equations = constant(&expansion, name);
        assert!(!equations.contains("sgn"), "{equations}");
        assert!(equations.contains("ln e"), "{equations}");
        assert!(equations.contains(exponential), "{equations}");
        let sentence = "is a parameter; the exponential function is";
        assert!(equations.contains(sentence), "{equations}");
    }
    let top = |options: TokenStream| {
        expand(quote! {
            #[lagrangian(
                coordinates(phi, theta, psi),
                routhian(Reduced #options),
                kinetic = 0.5 * i * (dot(theta).powi(2) + (dot(phi) * sin(theta)).powi(2))
                    + 0.5 * i_s * (dot(psi) + dot(phi) * cos(theta)).powi(2),
                potential = e * g * cos(theta),
            )]
            struct Top { i: f64, i_s: f64, e: f64, g: f64 }
        })
    };
    let [direct, half_angles] = [quote!(), quote!(, half_angles)].map(|options| {
        let equations = last_constant(&top(options), "EQUATIONS");
        let lines = equations.lines();
        let lines = lines.filter(|line| !line.starts_with("They are found"));
        lines.collect::<Vec<_>>().join("\n")
    });
    assert!(
        direct.contains("(p_φ − p_ψ cos θ)²/(2 I sin²θ)"),
        "{direct}"
    );
    // A parameter e that is raised to no power.
    assert!(!direct.contains("exponential"), "{direct}");
    assert_eq!(direct, half_angles);
}

#[test]
fn the_numbers_of_bodies_have_the_names_of_books() {
    let place = quote!((rotation_y(q[0]) * rotation_x(q[1]), [0.0, 0.0, 0.0]));
    let one = quote!(body(rotor = #place));
    let found = page(&quote!(rotor: SymmetricBody), &one);
    assert!(found.contains("(m z_C² + I₁ − I₃)"), "{found}");
    // Another m.
    let found = page(&quote!(rotor: SymmetricBody, m: f64), &one);
    assert!(found.contains("m_rotor·z_C_rotor·g"), "{found}");
    let two = quote!(body(rotor = #place, rod = (rotation_y(q[0]), [q[1], 0.0, 0.0])));
    let fields = quote!(rotor: PrincipalBody, rod: RigidBody);
    let found = page(&fields, &two);
    for part in ["I_rotor₂", "I_rod₂₂", "m_rod·", "x_C_rod"] {
        assert!(found.contains(part), "{part}: {found}");
    }
    let found = page(&quote!(#fields, m_rod: f64), &two);
    assert!(
        found.contains("rod_mass·") && found.contains("rotor_inertia₁₁"),
        "{found}"
    );
    let family = quote!(body(rods[i] = (rotation_y(q[i]), [0.0, 0.0, 0.0]) for i in 0..2));
    let found = page(&quote!(rods: [RigidBody; 2]), &family);
    assert!(found.contains("I₀,₂₂") && found.contains("m₁"), "{found}");
}

#[test]
fn pages_are_those_that_were_committed() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden/pages");
    let mut models: Vec<_> = MODELS
        .into_iter()
        .map(|name| {
            let path = folder.join(name).with_extension("rs");
            let declaration = fs::read_to_string(path).expect("the declaration is there");
            (name, declaration.parse().expect("it is of tokens"))
        })
        .collect();
    models.push(("arm", arm(6)));
    for (name, declaration) in models {
        let expansion = expand(declaration);
        for (item, extension) in [("EQUATIONS", "txt"), ("LATEX", "tex")] {
            let page = constant(&expansion, item);
            // Two pages of a book; LaTeX has twice as many characters.
            let most = if item == "LATEX" { 9000 } else { 4500 };
            assert!(page.len() < most, "{name}: {} bytes", page.len());
            let path = folder.join(name).with_extension(extension);
            if env::var_os("GOLDEN").is_some_and(|value| value == "overwrite") {
                fs::write(&path, &page).expect("the page can be written");
            }
            let committed = fs::read_to_string(&path).unwrap_or_default();
            assert!(
                committed == page,
                "{name} differs, see the top of this file:\n{page}"
            );
        }
    }
}
