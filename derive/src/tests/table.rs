//! Every method of the table is emitted, with equations and beside errors.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::quote;
use syn::{ImplItem, Item};

use crate::expand::expand;
use crate::plan::{EmittedMethod, Interface, MethodRow, Variant};

/// A model with all kinds of methods; its potential has an error, or has none.
fn cart(potential: &TokenStream) -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(x, theta),
            kinetic = 0.5 * (mc + m) * dot(x).powi(2) + 0.5 * m * l.powi(2) * dot(theta).powi(2)
                + m * l * cos(theta) * dot(x) * dot(theta),
            potential = #potential,
            force(x = u),
            output(acceleration = dot(dot(x))),
            event(centre = x, upright = [theta, dot(theta)]),
            hamiltonian,
            energy_balance,
            sensitivities,
            regressor,
        )]
        struct Cart { mc: f64, m: f64, l: f64, g: f64, #[lagrangian(input)] u: f64 }
    }
}

/// The traits of an expansion and their functions.
fn functions(expansion: TokenStream) -> BTreeSet<(String, String)> {
    let file: syn::File = syn::parse2(expansion).expect("the expansion is of items");
    let mut functions = BTreeSet::new();
    for item in file.items {
        let Item::Impl(item) = item else { continue };
        let Some((path, _)) = item.trait_ else {
            continue;
        };
        let name = path.segments.last().map(|last| last.ident.to_string());
        for function in item.items {
            if let (Some(name), ImplItem::Fn(function)) = (&name, function) {
                functions.insert((name.clone(), function.sig.ident.to_string()));
            }
        }
    }
    functions
}

/// The trait and the name of a function in a model with inputs, at the fields' values and with the inputs as a
/// parameter.
fn expected(variant: Variant) -> Vec<(&'static str, String)> {
    let (name, with) = (variant.name(), format!("{}_with", variant.name()));
    match variant.row.interface {
        Interface::Lagrangian if variant.row.takes_inputs => {
            vec![("Lagrangian", name), ("Inputs", with)]
        }
        Interface::Lagrangian => vec![("Lagrangian", name)],
        Interface::Energies => vec![("Energies", name)],
        Interface::Inputs => vec![("Inputs", with)],
        Interface::Outputs => vec![("Outputs", name), ("OutputsWith", with)],
        Interface::Events => vec![("Events", name), ("EventsWith", with)],
        Interface::Hamiltonian if variant.row.takes_inputs => {
            vec![("Hamiltonian", name), ("HamiltonianWith", with)]
        }
        Interface::Hamiltonian => vec![("Hamiltonian", name)],
        Interface::EnergyBalance => vec![("EnergyBalance", name), ("EnergyBalanceWith", with)],
        Interface::Sensitivities => vec![("Sensitivities", name), ("SensitivitiesWith", with)],
        Interface::Regressor if variant.row.takes_inputs => {
            vec![("Regressor", name), ("RegressorWith", with)]
        }
        Interface::Regressor => vec![("Regressor", name)],
    }
}

fn check(expansion: TokenStream, variants: impl Fn(MethodRow) -> Vec<Variant>) {
    let functions = functions(expansion);
    for method in EmittedMethod::ALL {
        for (interface, name) in variants(method.row()).into_iter().flat_map(expected) {
            let function = (interface.to_owned(), name);
            assert!(functions.contains(&function), "{function:?}");
        }
    }
    // A trait for models with inputs has no others.
    let rows = EmittedMethod::ALL.iter().map(|method| method.row());
    let expected: BTreeSet<_> = rows
        .flat_map(MethodRow::variants)
        .flat_map(expected)
        .map(|(interface, name)| (interface.to_owned(), name))
        .collect();
    for function in functions {
        assert!(
            !function.0.ends_with("With") || expected.contains(&function),
            "{function:?}"
        );
    }
}

#[test]
fn every_method_of_the_table_is_emitted() {
    let correct = expand(cart(&quote!(m * g * l * cos(theta))));
    check(correct, |row| row.variants().collect());
    let wrong = expand(cart(&quote!(m * g * h)));
    assert!(wrong.to_string().contains("compile_error"));
    check(wrong, |row| vec![row.unprepared()]);
}

#[test]
fn no_two_methods_have_one_name() {
    let rows = EmittedMethod::ALL.iter().map(|method| method.row());
    let names: Vec<String> = rows
        .flat_map(MethodRow::variants)
        .map(Variant::name)
        .collect();
    let distinct: BTreeSet<&String> = names.iter().collect();
    assert_eq!(distinct.len(), names.len());
}
