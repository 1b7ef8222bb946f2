//! The whole macro: parse, check, lower, derive the equations, schedule, emit.

use std::collections::BTreeMap;

use lagrangian_symbolic::{Defect, Equations, Model};
use proc_macro2::TokenStream;
use quote::quote;
use syn::DeriveInput;

use crate::body::MOST_SCOPES;
use crate::check::{check, check_whole};
use crate::clauses::Clause;
use crate::declaration::Declaration;
use crate::diagnostics::Diagnostics;
use crate::fallback;
use crate::implementation::Implementation;
use crate::lower::{Lowered, lower};
use crate::methods::Methods;
use crate::names::plain;

/// The items for a struct with `#[lagrangian(…)]` attributes, or its errors and impls in their place.
pub(crate) fn expand(input: TokenStream) -> TokenStream {
    expand_within(input, MOST_SCOPES)
}

/// The same, where a method may nest so many scopes.
pub(crate) fn expand_within(input: TokenStream, most_scopes: usize) -> TokenStream {
    let input = match syn::parse2::<DeriveInput>(input) {
        Ok(input) => input,
        Err(error) => return error.to_compile_error(),
    };
    let mut diagnostics = Diagnostics::default();
    let declaration = Declaration::parse(input, &mut diagnostics);
    check(&declaration, &mut diagnostics);
    let mut lowered = lower(&declaration, &mut diagnostics);
    if diagnostics.is_empty() && lowered.scope.unknown().next().is_none() {
        check_whole(&declaration, &mut diagnostics);
    }
    let model = lowered.model.take().filter(|_| diagnostics.is_empty());
    let items = model
        .and_then(|model| implement(&declaration, &lowered, model, most_scopes, &mut diagnostics));
    items.unwrap_or_else(|| {
        if diagnostics.is_empty() && lowered.scope.unknown().next().is_none() {
            diagnostics.error(&declaration.name, NOT_UNDERSTOOD);
        }
        let errors = diagnostics.to_compile_errors();
        let items = fallback::items(&declaration, &lowered);
        quote!(#errors #items)
    })
}

const NOT_UNDERSTOOD: &str = "this declaration is not understood, and there is no better word for what is wrong \
                              with it; this is a defect of `lagrangian`: please report the declaration";

/// Derives the equations of motion and writes the impls, unless there is an error.
fn implement(
    declaration: &Declaration,
    lowered: &Lowered,
    mut model: Model,
    most_scopes: usize,
    diagnostics: &mut Diagnostics,
) -> Option<TokenStream> {
    let equations = Equations::derive(&mut model)
        .map_err(|defect| report(&defect, declaration, lowered, diagnostics))
        .ok()?;
    let methods = Methods::schedule(&mut model, &equations);
    let undeclared = methods.undeclared(&model.graph);
    if !undeclared.is_empty() {
        report_undeclared(&undeclared, declaration, diagnostics);
        return None;
    }
    if !methods.verified() {
        let message = "the code for this model would not compute what was derived; this is a defect of \
                       `lagrangian`: please report the declaration";
        diagnostics.error(&declaration.name, message);
        return None;
    }
    if methods.unrepresentable().is_some() {
        let message = "a constant of the equations of motion is outside of the range of `f64`, though those \
                       written here are not: choose units in which numbers are nearer to 1";
        report_at(energy(declaration), message, diagnostics);
        return None;
    }
    let implementation = Implementation::new(
        declaration,
        lowered,
        &model,
        &equations,
        &methods,
        most_scopes,
    );
    Some(implementation.items())
}

/// Says which derivatives of functions from outside are missing.
fn report_undeclared(
    undeclared: &BTreeMap<(usize, usize), &'static str>,
    declaration: &Declaration,
    diagnostics: &mut Diagnostics,
) {
    for ((function, argument), needs) in undeclared {
        let function = &declaration.clauses.functions[*function];
        let (name, argument) = (&function.name, &function.arguments[*argument]);
        let message = format!(
            "{needs} ∂{name}/∂{argument}: add `derivative({argument}) = …` behind the value, or `derivative({argument}) \
             = 0.0` where that is constant piece by piece"
        );
        diagnostics.error(name, message);
    }
}

/// The clause in which the equations of motion begin.
fn energy(declaration: &Declaration) -> Option<&Clause> {
    let clauses = &declaration.clauses;
    clauses.kinetic.first().or(clauses.lagrangian.first())
}

/// Says why there are no equations of motion, where the declaration can be mended.
fn report(
    defect: &Defect,
    declaration: &Declaration,
    lowered: &Lowered,
    diagnostics: &mut Diagnostics,
) {
    let clauses = &declaration.clauses;
    let energy = energy(declaration);
    let names = |indices: &[u32]| {
        let names: Vec<String> = indices
            .iter()
            .map(|i| format!("`{}`", lowered.quantities.coordinates[*i as usize]))
            .collect();
        names.join(", ")
    };
    match defect {
        Defect::NoVelocity(coordinates) => {
            for i in coordinates {
                let coordinate = &lowered.quantities.coordinates[*i as usize];
                let declared = clauses.coordinates.iter();
                let mut declared = declared.map(|declared| &declared.name);
                diagnostics.error(
                    declared.find(|name| plain(name) == coordinate.stem),
                    format!(
                        "no energy contains `dot({coordinate})`, so its equation of motion has no acceleration: \
                         add the kinetic energy of this coordinate, or remove it"
                    ),
                );
            }
        }
        Defect::SingularMass(coordinates) => {
            let message = format!(
                "the mass matrix is singular everywhere: the velocities of {} occur only in combinations of \
                 which there are fewer; add the kinetic energy that is missing, or remove a coordinate",
                names(coordinates)
            );
            report_at(energy, &message, diagnostics);
        }
        Defect::MomentumOfInput(inputs) => {
            for i in inputs {
                let name = &lowered.quantities.inputs[*i as usize].field;
                diagnostics.error(
                    lowered.scope.first_use(name).unwrap_or(name),
                    format!(
                        "the momenta ∂L/∂q̇ contain the input `{name}`, whose rate of change is unknown: \
                         make it a coordinate or a function of `t`, or write what it does under `force`"
                    ),
                );
            }
        }
    }
}

fn report_at(energy: Option<&Clause>, message: &str, diagnostics: &mut Diagnostics) {
    if let Some(clause) = energy {
        diagnostics.error(&clause.expression, message);
    }
}
