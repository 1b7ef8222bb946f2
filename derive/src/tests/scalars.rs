//! The scalars on which models compute, and what that costs.

use crate::expand::expand;

const HEAVY_TOP: &str = include_str!("../../golden/heavy_top/declaration.rs");
const DRIVEN_PENDULUM: &str = include_str!("../../golden/driven_pendulum/declaration.rs");

fn expansion(declaration: &str) -> String {
    expand(declaration.parse().expect("the declaration is of tokens")).to_string()
}

/// The declaration with parameters of type `T`.
fn generic(declaration: &str, name: &str, parameter: &str) -> String {
    declaration.replace(": f64", ": T").replace(
        &format!("struct {name}"),
        &format!("struct {name}<{parameter}>"),
    )
}

/// The expansion without what converts plain numbers, and without what members in lanes have, which are of plain numbers.
fn without_conversions(expansion: &str) -> String {
    let mut impls = expansion.split("# [automatically_derived] ");
    let first = impls.next().unwrap_or_default().to_owned();
    let impls = impls.filter(|item| !item.contains("SharesLanes"));
    let expansion = impls.fold(first, |text, item| {
        text + "# [automatically_derived] " + item
    });
    let mut parts = expansion.split(":: lagrangian :: __private :: parameter (");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| text + &part.replacen(')', "", 1))
}

const MODELS: [(&str, &str); 2] = [(HEAVY_TOP, "HeavyTop"), (DRIVEN_PENDULUM, "DrivenPendulum")];

#[test]
fn parameters_of_any_scalar_cost_what_plain_numbers_cost() {
    for (declaration, name) in MODELS {
        let plain = expansion(declaration);
        let expected = without_conversions(&plain)
            .replace("__S", "T")
            .replace(":: core :: primitive :: f64", "T")
            .replace("impl < T : :: lagrangian :: Scalar >", "impl")
            .replace("impl ", "impl < T : Scalar > ")
            .replace(&format!("{name} {{"), &format!("{name} < T > {{"));
        assert_eq!(
            expansion(&generic(declaration, name, "T: Scalar")),
            expected
        );
    }
}

#[test]
fn a_named_scalar_stands_in_the_place_of_a_parameter() {
    for (declaration, name) in MODELS {
        let among = expansion(&generic(declaration, name, "T: Scalar + Other"));
        let named = declaration.replacen("#[lagrangian(", "#[lagrangian(scalar = f64, ", 1);
        let named = expansion(&named);
        for (of_parameter, of_type) in [
            (
                "< T as :: lagrangian :: Scalar >",
                "< f64 as :: lagrangian :: Scalar >",
            ),
            (": T = self .", ": f64 = self ."),
            (", T >", ", f64 >"),
        ] {
            let count = among.matches(of_parameter).count();
            assert!(count > 0, "{of_parameter}");
            assert_eq!(named.matches(of_type).count(), count, "{name}: {of_type}");
        }
        // Nothing is generic but the struct of outputs, whose field is a number on the scalar.
        let results = named.split("struct ").nth(1).unwrap_or_default();
        let generic = results.matches("__S").count();
        assert_eq!(named.matches("__S").count(), generic, "{name}: {named}");
        assert!(!named.contains("parameter ("), "{name}: {named}");
    }
}

#[test]
fn beside_other_bounds_functions_are_those_of_the_trait() {
    for (declaration, name) in MODELS {
        let alone = expansion(&generic(declaration, name, "T: Scalar"));
        let among = expansion(&generic(declaration, name, "T: Scalar + Other"));
        for function in ["sines_and_cosines", "sin_cos", "mul_add", "from_f64"] {
            assert!(
                !among.contains(&format!(". {function} (")),
                "{name}: {among}"
            );
            assert!(
                !among.contains(&format!("T :: {function} (")),
                "{name}: {among}"
            );
            let trait_function = format!("< T as :: lagrangian :: Scalar > :: {function} (");
            assert_eq!(
                among.matches(&trait_function).count(),
                alone.matches(&format!(" {function} (")).count(),
                "{name}: {function}"
            );
        }
    }
}
