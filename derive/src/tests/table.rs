//! Every method of the table is emitted, with equations and beside errors.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::quote;
use syn::{ImplItem, Item};

use crate::expand::expand;
use crate::plan::{EmittedMethod, Interface, MethodRow};

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
fn functions(expansion: TokenStream) -> Vec<(String, String)> {
    let file: syn::File = syn::parse2(expansion).expect("the expansion is of items");
    let mut functions = Vec::new();
    for item in file.items {
        let Item::Impl(item) = item else { continue };
        let Some((path, _)) = item.trait_ else {
            continue;
        };
        let name = path.segments.last().map(|last| last.ident.to_string());
        for function in item.items {
            if let (Some(name), ImplItem::Fn(function)) = (&name, function) {
                functions.push((name.clone(), function.sig.ident.to_string()));
            }
        }
    }
    functions
}

/// The name of the trait that declares a method.
fn trait_of(row: MethodRow) -> String {
    format!("{:?}", row.interface)
}

fn check(expansion: TokenStream, is_expected: impl Fn(MethodRow) -> bool) {
    let functions = functions(expansion);
    for row in EmittedMethod::ALL.iter().map(|method| method.row()) {
        let function = (trait_of(row), row.name.to_owned());
        let count = functions.iter().filter(|found| **found == function).count();
        assert_eq!(count, usize::from(is_expected(row)), "{function:?}");
    }
}

#[test]
fn every_method_of_the_table_is_emitted_once() {
    let correct = expand(cart(&quote!(m * g * l * cos(theta))));
    check(correct, is_of_free_models);
    let wrong = expand(cart(&quote!(m * g * h)));
    assert!(wrong.to_string().contains("compile_error"));
    check(wrong, is_of_free_models);
}

fn is_of_free_models(row: MethodRow) -> bool {
    !matches!(
        row.interface,
        Interface::Constraints | Interface::MultiplierSensitivities
    )
}

#[test]
fn methods_of_constraints_are_emitted_once() {
    let pendulum = |potential: &TokenStream| {
        quote! {
            #[lagrangian(
                coordinates(x, y),
                kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
                potential = #potential,
                constraint(rod = x.powi(2) + y.powi(2) - l.powi(2)),
                compliance(rod = 1.0 / m),
                force(x = -c * dot(x)),
                event(side = x),
                sensitivities(m, l),
            )]
            struct Pendulum { m: f64, g: f64, l: f64, c: f64 }
        }
    };
    let is_expected = |row: MethodRow| {
        matches!(
            row.interface,
            Interface::Quantities
                | Interface::Constraints
                | Interface::Impacts
                | Interface::Energies
                | Interface::Events
                | Interface::Sensitivities
                | Interface::MultiplierSensitivities
        )
    };
    check(expand(pendulum(&quote!(m * g * y))), is_expected);
    let wrong = expand(pendulum(&quote!(m * g * h)));
    assert!(wrong.to_string().contains("compile_error"));
    // What is meant beside an error is not known. The trait provides compliances.
    let may_be_meant = |row: MethodRow| {
        (is_expected(row) || row.interface == Interface::StateJacobian) && row.name != "compliances"
    };
    check(wrong, may_be_meant);
}

#[test]
fn no_two_methods_have_one_name() {
    let rows = EmittedMethod::ALL.iter().map(|method| method.row());
    let names: Vec<&str> = rows.map(|row| row.name).collect();
    let distinct: BTreeSet<&&str> = names.iter().collect();
    assert_eq!(distinct.len(), names.len());
}
