//! The whole macro: parse, check, lower, derive the equations, schedule, emit.

use std::collections::BTreeSet;

use lagrangian_symbolic::{Equations, Kinetics, Listing, Method, Model, Reduction, Validator};
use proc_macro2::TokenStream;
use quote::quote;
use syn::DeriveInput;

use crate::check::{check, check_whole};
use crate::defects;
use crate::diagnostics::Diagnostics;
use crate::emit::{
    Emitter, items, items_without_equations, listing, reduced_struct, reduced_without_equations,
    warning,
};
use crate::limits::MethodLimits;
use crate::lower::{Lowered, lower};
use crate::plan::{
    EventSeries, Methods, ReducedMethods, Requested, TaylorMethod, ValueSeries, branches_of_events,
};
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
    Some(quote!(#items #warning #reduced))
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

/// What is derived from a model.
struct Derived {
    model: Model,
    equations: Equations,
    methods: Methods,
    taylor: Option<TaylorMethod>,
    event_series: Option<EventSeries>,
    branch_series: Option<ValueSeries>,
    listing: Listing,
    /// The methods that had to be derived again.
    disagreements: BTreeSet<Method>,
}

impl Derived {
    fn of(
        declaration: &Declaration,
        lowered: &Lowered,
        mut model: Model,
        limits: MethodLimits,
        diagnostics: &mut Diagnostics,
    ) -> Option<Self> {
        let has_series = declaration.clauses.taylor.is_some();
        let branches = has_series.then(|| branches_of_events(&mut model, &lowered.outputs));
        let branches = branches.unwrap_or_default();
        let validator = Validator::new(&model);
        let mut equations = match Equations::derive(&mut model) {
            Ok(equations) => equations,
            Err(defect) => {
                defects::report(&defect, declaration, lowered, &model, diagnostics);
                return None;
            }
        };
        let requested =
            match Requested::derive(declaration, &lowered.quantities, &mut model, limits) {
                Ok(requested) => requested,
                Err(reason) => {
                    defects::report_no_regressor(
                        &reason,
                        declaration,
                        lowered,
                        &model,
                        diagnostics,
                    );
                    return None;
                }
            };
        let shapes = &lowered.outputs;
        let mut methods = Methods::schedule(&mut model, &equations, shapes, &requested);
        let disagreements =
            methods.validate(&validator, &mut model, &mut equations, (shapes, &requested));
        let undeclared = methods.undeclared(&model.graph);
        if !undeclared.is_empty() {
            defects::report_undeclared(&undeclared, declaration, diagnostics);
            return None;
        }
        if methods.unrepresentable().is_some() {
            let message = "a constant of the equations of motion is outside of the range of `f64`, though those \
                           written here are not: choose units in which numbers are nearer to 1";
            defects::report_at_energy(declaration, message, diagnostics);
            return None;
        }
        let (mut taylor, mut event_series, mut branch_series) = (None, None, None);
        if let Some(clause) = &declaration.clauses.taylor {
            let series = methods.taylor_method(&mut model, &equations);
            let all = series.and_then(|series| {
                let of_events = methods.event_series(&model.graph, branches)?;
                let of_branches = ValueSeries::of_branches(&mut model, &equations)?;
                Ok((Some(series), of_events, of_branches))
            });
            match all {
                Ok(all) => (taylor, event_series, branch_series) = all,
                Err(reason) => {
                    defects::report_no_series(reason, clause, declaration, diagnostics);
                    return None;
                }
            }
        }
        let solved = methods.solved_form(&mut model, &equations);
        let operations = methods.accelerations.count.total();
        let solved = (&solved, operations);
        let listing = listing(&mut model, &equations, (declaration, lowered), solved);
        Some(Self {
            model,
            equations,
            methods,
            taylor,
            event_series,
            branch_series,
            listing,
            disagreements,
        })
    }

    fn emitter<'a>(
        &'a self,
        declaration: &'a Declaration,
        lowered: &'a Lowered,
        limits: MethodLimits,
    ) -> Emitter<'a> {
        Emitter::new(
            declaration,
            lowered,
            &self.model,
            (&self.equations, &self.listing),
            &self.methods,
            (
                self.taylor.as_ref(),
                self.event_series.as_ref(),
                self.branch_series.as_ref(),
            ),
            limits,
        )
    }
}
