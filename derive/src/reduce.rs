//! Routh's reduction of a declared model: the declaration and the model of the struct that the clause `routhian` names.
//!
//! The reduced struct has the fields of the declared one, and behind them the momenta of the ignorable coordinates, which are
//! parameters like any other. Its coordinates are those that remain. From there on it goes the way of every model.

mod declaration;
mod objections;

use lagrangian_symbolic::{
    Equations, Graph, Model, PoleForm, Reduction, ReductionCheck, TypedGraph,
};
use proc_macro2::Ident;

use crate::check::check;
use crate::diagnostics::{Diagnostics, hint};
use crate::lower::quantities::Quantities;
use crate::lower::scope::Scope;
use crate::lower::{Lowered, count};
use crate::syntax::declaration::Declaration;
use crate::syntax::named::NamedExpression;
use crate::syntax::names::unraw;
use crate::syntax::routhian::RouthianClause;
use crate::syntax::shape::Shape;
use declaration::{CLAUSES, leaves_out, reduced_declaration};
use objections::message;

/// The positions of the coordinates that are ignorable, and of those that are not.
pub(crate) struct Split {
    pub(crate) ignorable: Vec<usize>,
    pub(crate) remaining: Vec<usize>,
}

impl Split {
    /// Those of a model with so many coordinates.
    pub(crate) fn of(equations: &Equations, coordinates: usize) -> Self {
        let ignorable: Vec<usize> = equations.conservation.ignorable().collect();
        let remaining = (0..coordinates).filter(|i| !ignorable.contains(i));
        Self {
            remaining: remaining.collect(),
            ignorable,
        }
    }
}

/// A reduced model as if it had been declared, without its equations.
pub(crate) struct ReducedDeclaration {
    pub(crate) declaration: Declaration,
    pub(crate) lowered: Lowered,
    pub(crate) split: Split,
}

impl ReducedDeclaration {
    /// That of a model whose coordinates are split so.
    pub(crate) fn of(
        declaration: &Declaration,
        lowered: &Lowered,
        split: Split,
        clause: &RouthianClause,
    ) -> Self {
        let reduced = reduced_declaration(declaration, lowered, &split, clause);
        let retained = |named: &[NamedExpression], shapes: &[Shape]| {
            let all = named.iter().zip(shapes);
            let all = all.filter(|(named, _)| !leaves_out(clause, &unraw(&named.name)));
            all.map(|(_, shape)| *shape).collect()
        };
        let clauses = &declaration.clauses;
        let lowered = Lowered {
            model: None,
            scope: Scope::new(&reduced, &mut TypedGraph::new(Graph::new(), 0)),
            quantities: Quantities::new(&reduced),
            outputs: retained(&clauses.outputs, &lowered.outputs),
            constraints: lowered.constraints.clone(),
            events: retained(&clauses.events, &lowered.events),
            turning: Vec::new(),
        };
        Self {
            declaration: reduced,
            lowered,
            split,
        }
    }
}

/// Reduces a model, unless there is an error.
pub(crate) fn reduce(
    (declaration, lowered): (&Declaration, &Lowered),
    (model, equations): (&Model, &Equations),
    clause: &RouthianClause,
    reduced: &ReducedDeclaration,
    diagnostics: &mut Diagnostics,
) -> Option<Reduction> {
    let parameters = count(lowered.quantities.parameters.len());
    let form = if clause.half_angles {
        PoleForm::HalfAngles
    } else {
        PoleForm::Direct
    };
    let mut reduction = match Reduction::of(model, equations, parameters, form) {
        Ok(reduction) => reduction,
        Err(reason) => {
            diagnostics.error(&clause.keyword, message(&reason, lowered, model));
            return None;
        }
    };
    if !ReductionCheck::new(model, &reduction, parameters).agrees() {
        let message = "the reduced Lagrangian is not the Routhian of the model; this is a defect of `lagrangian`: please \
                       report the declaration, and leave `routhian` out";
        diagnostics.error(&clause.keyword, message);
        return None;
    }
    let errors = diagnostics.count();
    check_names(declaration, lowered, reduced, clause, diagnostics);
    check(&reduced.declaration, diagnostics);
    if diagnostics.count() > errors {
        return None;
    }
    let retained = retained_outputs((declaration, lowered), clause, &reduction, diagnostics);
    reduction.retain_outputs(&retained);
    Some(reduction).filter(|_| diagnostics.count() == errors)
}

/// The reduced model as it comes, whatever the clause says, unless there is none.
pub(crate) fn without_half_angles(
    (declaration, lowered): (&Declaration, &Lowered),
    (model, equations): (&Model, &Equations),
    clause: &RouthianClause,
) -> Option<Model> {
    let parameters = count(lowered.quantities.parameters.len());
    let mut reduction = Reduction::of(model, equations, parameters, PoleForm::Direct).ok()?;
    let mut reported = Diagnostics::default();
    let retained = retained_outputs((declaration, lowered), clause, &reduction, &mut reported);
    reduction.retain_outputs(&retained);
    Some(reduction.model)
}

/// The constant momenta have names of their own, and what is left out is there.
fn check_names(
    declaration: &Declaration,
    lowered: &Lowered,
    reduced: &ReducedDeclaration,
    clause: &RouthianClause,
    diagnostics: &mut Diagnostics,
) {
    for i in &reduced.split.ignorable {
        let momentum = lowered.quantities.coordinates[*i].momentum();
        let mut fields = declaration.fields.iter();
        if fields.any(|field| unraw(&field.name) == momentum) {
            let message = format!(
                "the reduced model has the constant momentum `{momentum}` as a parameter, which is a field already: give \
                 the field another name"
            );
            diagnostics.error(&clause.name, message);
        }
    }
    let clauses = &declaration.clauses;
    let observed = clauses.outputs.iter().chain(&clauses.events);
    let observed = observed.map(|named| unraw(&named.name));
    let known: Vec<String> = observed.chain(CLAUSES.map(str::to_owned)).collect();
    for name in &clause.without {
        let written = unraw(name);
        if !known.contains(&written) {
            let hint = hint(&written, &known, "some");
            let message = format!(
                "`{name}` is neither an output nor an event, nor a clause that the reduced model can do without: {hint}"
            );
            diagnostics.error(name, message);
        }
    }
}

/// The positions of the components of the outputs and events that the reduced model has, with an error at each that is not
/// a function of its state.
fn retained_outputs(
    (declaration, lowered): (&Declaration, &Lowered),
    clause: &RouthianClause,
    reduction: &Reduction,
    diagnostics: &mut Diagnostics,
) -> Vec<usize> {
    let clauses = &declaration.clauses;
    let outputs = clauses.outputs.iter().zip(&lowered.outputs);
    let outputs = outputs.map(|(output, shape)| ("output", &output.name, shape));
    let events = clauses.events.iter().zip(&lowered.events);
    let events = events.map(|(event, shape)| ("event", &event.name, shape));
    let mut retained = Vec::new();
    let mut next = 0;
    for (kind, name, shape) in outputs.chain(events) {
        let components = next..next + shape.count();
        next = components.end;
        if leaves_out(clause, &unraw(name)) {
            continue;
        }
        let components_in_reduced = reduction.outputs.get(components.clone());
        let mut dependent = components_in_reduced.into_iter().flatten();
        let dependent = dependent.find_map(|output| output.err());
        match dependent.and_then(|i| lowered.quantities.coordinates.get(i)) {
            Some(on) => diagnostics.error(name, needs_reconstruction(kind, name, on, clause)),
            None => retained.extend(components),
        }
    }
    retained
}

fn needs_reconstruction(
    kind: &str,
    name: &Ident,
    on: impl core::fmt::Display,
    clause: &RouthianClause,
) -> String {
    let reduced = &clause.name;
    let otherwise = match kind {
        "event" => "watch for it in the full model",
        _ => "evaluate it by the full model at `full_state`",
    };
    format!(
        "this {kind} depends on `{on}`, which is ignorable, so that `{reduced}` does not have it: write `routhian({reduced}, \
         without({name}))`, and {otherwise}"
    )
}
