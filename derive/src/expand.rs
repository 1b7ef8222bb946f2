//! The whole macro: parse, check, lower, derive the equations, schedule, emit.

use lagrangian_symbolic::{Equations, Kinetics, Listing, Model, Reduction};
use proc_macro2::TokenStream;
use quote::quote;
use syn::DeriveInput;

use crate::check::{check, check_whole};
use crate::defects;
use crate::derived::Derived;
use crate::diagnostics::Diagnostics;
use crate::emit::{
    Emitter, items, items_without_equations, listing, reduced_struct, reduced_without_equations,
    warning,
};
use crate::limits::MethodLimits;
use crate::lower::{Lowered, lower};
use crate::plan::ReducedMethods;
use crate::reduce::{ReducedDeclaration, Split, reduce, without_half_angles};
use crate::syntax::declaration::Declaration;
use crate::syntax::routhian::RouthianClause;
use crate::syntax::size;

/// The items for a struct with `#[lagrangian(…)]` attributes, or its errors and impls without equations.
pub(crate) fn expand(input: TokenStream) -> TokenStream {
    expand_within(input, MethodLimits::OF_EXPANSIONS)
}

/// The same within other limits on the form of methods.
pub(crate) fn expand_within(input: TokenStream, limits: MethodLimits) -> TokenStream {
    if let Err(error) = size::check(input.clone()) {
        return error.to_compile_error();
    }
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
    let items =
        model.and_then(|model| implement(&declaration, &lowered, model, limits, &mut diagnostics));
    let items = items.unwrap_or_else(|| {
        if diagnostics.is_empty() && lowered.scope.unknown().next().is_none() {
            diagnostics.error(&declaration.name, NOT_UNDERSTOOD);
        }
        items_without_equations(&declaration, &lowered)
    });
    let errors = diagnostics.to_compile_errors();
    quote!(#errors #items)
}

const NOT_UNDERSTOOD: &str = "this declaration is not understood, and there is no better word for what is wrong \
                              with it; this is a defect of `lagrangian`: please report the declaration";

/// Derives the equations of motion and writes the impls, unless there is an error.
fn implement(
    declaration: &Declaration,
    lowered: &Lowered,
    model: Model,
    limits: MethodLimits,
    diagnostics: &mut Diagnostics,
) -> Option<TokenStream> {
    let derived = Derived::of(declaration, lowered, model, limits, diagnostics)?;
    let emitter = derived.emitter(declaration, lowered, limits);
    let clause = declaration.clauses.routhian.as_ref();
    let reduced = clause.map(|clause| implement_reduced(&emitter, clause, diagnostics));
    let items = items(&emitter);
    let warning = warning(&derived.disagreements, declaration);
    let disguised = emitter.disguise_warnings();
    Some(quote!(#items #warning #disguised #reduced))
}

/// Reduces a model by its ignorable coordinates, and writes the struct of what remains and its impls; these have no equations
/// if there is an error.
fn implement_reduced(
    full: &Emitter<'_>,
    clause: &RouthianClause,
    diagnostics: &mut Diagnostics,
) -> TokenStream {
    let (declaration, lowered) = (full.declaration, full.lowered);
    let split = Split::of(full.equations, full.model.coordinates as usize);
    let reduces = !split.ignorable.is_empty() && !split.remaining.is_empty();
    let reduced = ReducedDeclaration::of(declaration, lowered, split, clause);
    reduced_items(full, clause, &reduced, diagnostics).unwrap_or_else(|| {
        reduced_without_equations(declaration, lowered, Some(&reduced).filter(|_| reduces))
    })
}

/// The struct of the reduced model and its impls, unless there is an error.
fn reduced_items(
    full: &Emitter<'_>,
    clause: &RouthianClause,
    reduced: &ReducedDeclaration,
    diagnostics: &mut Diagnostics,
) -> Option<TokenStream> {
    let (declaration, lowered) = (&reduced.declaration, &reduced.lowered);
    let reduction = reduce(
        (full.declaration, full.lowered),
        (full.model, full.equations),
        clause,
        reduced,
        diagnostics,
    )?;
    let mut of_reduced = Diagnostics::default();
    let derived = derive_reduced(
        &reduction,
        (declaration, lowered),
        full.limits,
        &mut of_reduced,
    );
    diagnostics.add_with(of_reduced, &concerns(clause));
    let (mut derived, methods) = derived?;
    if clause.half_angles
        && let Some(listing) = listing_without_half_angles(full, clause, reduced, &derived)
    {
        derived.listing = listing;
    }
    let mut emitter = derived.emitter(declaration, lowered, full.limits);
    emitter.poles.clone_from(&reduction.poles);
    emitter.prepared.add_reduced(&methods);
    let definition = reduced_struct(full.declaration, declaration);
    let items = items(&emitter);
    let there = full.routh_reduction(reduced);
    let back = emitter.routhian(reduced, &methods, full);
    let warning = warning(&derived.disagreements, declaration);
    Some(quote!(#definition #items #there #back #warning))
}

/// The equations of a reduced model as they come, which are those of books; half angles are for numbers near the poles.
fn listing_without_half_angles(
    full: &Emitter<'_>,
    clause: &RouthianClause,
    reduced: &ReducedDeclaration,
    derived: &Derived,
) -> Option<Listing> {
    let declared = (full.declaration, full.lowered);
    let mut model = without_half_angles(declared, (full.model, full.equations), clause)?;
    let equations = Equations::derive(&mut model).ok()?;
    let kinetics = Kinetics::cheapest(&mut model, &equations);
    let solved = kinetics.solved_form(&mut model, &equations);
    let operations = derived.methods.accelerations.count.total();
    let declared = (&reduced.declaration, &reduced.lowered);
    Some(listing(
        &mut model,
        &equations,
        declared,
        (&solved, operations),
    ))
}

/// What errors of a reduced model say besides.
fn concerns(clause: &RouthianClause) -> String {
    let name = &clause.name;
    format!(
        "so it is in the reduced model `{name}`, which does without the clauses that `routhian({name}, without(…))` names"
    )
}

/// Derives the equations of a reduced model, and its methods besides those of every model.
fn derive_reduced(
    reduction: &Reduction,
    (declaration, lowered): (&Declaration, &Lowered),
    limits: MethodLimits,
    diagnostics: &mut Diagnostics,
) -> Option<(Derived, ReducedMethods)> {
    let derived = Derived::of(
        declaration,
        lowered,
        reduction.model.clone(),
        limits,
        diagnostics,
    )?;
    let methods = ReducedMethods::schedule(reduction);
    let Some(taylor) = &declaration.clauses.taylor else {
        return Some((derived, methods));
    };
    match methods.with_series(reduction) {
        Ok(methods) => Some((derived, methods)),
        Err(reason) => {
            defects::report_no_series(reason, taylor, declaration, diagnostics);
            None
        }
    }
}
