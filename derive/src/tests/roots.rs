//! Every emitted path begins with the crate that the declaration names.

use proc_macro2::TokenStream;

use crate::expand::expand;

const MODEL: &str = r"
    coordinates(theta, x),
    kinetic = 0.5 * m * (dot(x).powi(2) + 2.0 * dot(x) * dot(theta) * cos(theta) + 3.0 * dot(theta).powi(2)),
    potential = m * theta.powi(4),
    dissipation = 0.5 * m * dot(x).powi(2),
    force(x = u * t),
    output(height = dot(dot(theta))),
    function(bend(x) = x.sin(), derivative(x) = m * cos(x) + bend(x)),
    dissipation = bend(dot(x)),
";

const LAGRANGIAN: &str = "lagrangian = dot(x) * dot(theta) + m * t * dot(x), coordinates(x, theta)";

const UNKNOWN: &str = "coordinates(x), kinetic = dot(x).powi(2), potential = height, output(x = x), function(f(x) = x)";

fn expansion(clauses: &str) -> String {
    let declaration =
        format!("#[lagrangian({clauses})] struct Model {{ m: f64, #[lagrangian(input)] u: f64 }}");
    let tokens: TokenStream = declaration.parse().expect("the declaration is of tokens");
    expand(tokens).to_string()
}

#[test]
fn every_emitted_path_begins_with_the_root() {
    for model in [MODEL, LAGRANGIAN, UNKNOWN] {
        let usual = expansion(model);
        assert!(usual.contains(":: lagrangian :: Lagrangian <"), "{usual}");
        for root in ["\"crate::facade::mechanics\"", "crate::facade::mechanics"] {
            let moved = expansion(&format!("crate = {root}, {model}"));
            assert!(!moved.contains(":: lagrangian ::"), "{moved}");
            let back = moved.replace("crate :: facade :: mechanics", ":: lagrangian");
            assert_eq!(back, usual);
        }
    }
}
