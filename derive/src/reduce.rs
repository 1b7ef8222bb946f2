//! Routh's reduction of a declared model: the declaration and the model of the struct that the clause `routhian` names.
//!
//! The reduced struct has the fields of the declared one, and behind them the momenta of the ignorable coordinates, which are
//! parameters like any other. Its coordinates are those that remain. From there on it goes the way of every model.

use std::collections::BTreeSet;

use lagrangian_symbolic::{
    Equations, Graph, Model, NoReduction, Obstacle, PoleForm, Reduction, ReductionCheck, Spoiler,
};
use proc_macro2::Ident;
use syn::{Type, parse_quote};

use crate::check::check;
use crate::diagnostics::Diagnostics;
use crate::lower::quantities::Quantities;
use crate::lower::scope::Scope;
use crate::lower::{Lowered, count};
use crate::syntax::clauses::Clauses;
use crate::syntax::coordinate::{Coordinate, indices};
use crate::syntax::declaration::Declaration;
use crate::syntax::field::{Field, Role};
use crate::syntax::label::Label;
use crate::syntax::names::{hygienic_span, to_source, unraw};
use crate::syntax::routhian::RouthianClause;
use crate::syntax::scalar::Scalar;

/// The reduced model, as if it had been declared.
pub(crate) struct Reduced {
    pub(crate) declaration: Declaration,
    pub(crate) lowered: Lowered,
    pub(crate) reduction: Reduction,
}

/// Reduces a model, unless there is an error.
pub(crate) fn reduce(
    declaration: &Declaration,
    lowered: &Lowered,
    model: &Model,
    equations: &Equations,
    clause: &RouthianClause,
    diagnostics: &mut Diagnostics,
) -> Option<Reduced> {
    let parameters = count(lowered.quantities.parameters.len());
    let form = if clause.half_angles {
        PoleForm::HalfAngles
    } else {
        PoleForm::Direct
    };
    let reduction = match Reduction::of(model, equations, parameters, form) {
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
    for i in &reduction.ignorable {
        let momentum = lowered.quantities.coordinates[*i].momentum();
        if declaration
            .fields
            .iter()
            .any(|field| unraw(&field.name) == momentum)
        {
            let message = format!(
                "the reduced model has the constant momentum `{momentum}` as a parameter, which is a field already: give \
                 the field another name"
            );
            diagnostics.error(&clause.name, message);
            return None;
        }
    }
    let reduced = reduced_declaration(declaration, lowered, &reduction, clause);
    check(&reduced, diagnostics);
    if !diagnostics.is_empty() {
        return None;
    }
    let lowered = Lowered {
        model: None,
        scope: Scope::new(&reduced, &mut Graph::new()),
        quantities: Quantities::new(&reduced),
        outputs: Vec::new(),
        events: Vec::new(),
        turning: Vec::new(),
    };
    Some(Reduced {
        declaration: reduced,
        lowered,
        reduction,
    })
}

/// The declaration of the reduced struct.
fn reduced_declaration(
    declaration: &Declaration,
    lowered: &Lowered,
    reduction: &Reduction,
    clause: &RouthianClause,
) -> Declaration {
    let scalar = Scalar::of(declaration).of_parameters();
    let labels = &lowered.quantities.coordinates;
    let ty: Type = parse_quote!(#scalar);
    let constants = reduction.ignorable.iter().map(|i| Field {
        name: named(&labels[*i].momentum(), clause),
        ty: ty.clone(),
        declared_type: None,
        role: Role::Parameter,
        readable: true,
        visibility: declaration.visibility.clone(),
    });
    let fields = declaration.fields.iter().cloned().chain(constants);
    let clauses = &declaration.clauses;
    Declaration {
        name: clause.name.clone(),
        visibility: declaration.visibility.clone(),
        generics: declaration.generics.clone(),
        fields: fields.collect(),
        names_fields: true,
        clauses: Clauses {
            coordinates: remaining_coordinates(declaration, labels, reduction, clause),
            functions: clauses.functions.clone(),
            taylor: clauses.taylor.clone(),
            scalar: clauses.scalar.clone(),
            ..Clauses::default()
        },
        root: declaration.root.clone(),
    }
}

/// The declared coordinates of which all scalars remain, and the scalars that remain of the others.
fn remaining_coordinates(
    declaration: &Declaration,
    labels: &[Label],
    reduction: &Reduction,
    clause: &RouthianClause,
) -> Vec<Coordinate> {
    let remains: BTreeSet<usize> = reduction.remaining.iter().copied().collect();
    let mut coordinates = Vec::new();
    for (coordinate, range) in indices(&declaration.clauses.coordinates) {
        if range.clone().all(|i| remains.contains(&i)) {
            coordinates.push(coordinate.clone());
            continue;
        }
        let scalars = range.filter(|i| remains.contains(i));
        coordinates
            .extend(scalars.map(|i| Coordinate::scalar(named(&labels[i].variable(), clause))));
    }
    coordinates
}

/// An identifier where the clause stands.
fn named(name: &str, clause: &RouthianClause) -> Ident {
    let mut name: Ident = syn::parse_str(&to_source(name)).unwrap_or_else(|_| clause.name.clone());
    name.set_span(hygienic_span(&clause.name));
    name
}

/// Why there is no reduced model.
fn message(reason: &NoReduction, lowered: &Lowered, model: &Model) -> String {
    let name = |i: &usize| format!("`{}`", lowered.quantities.coordinates[*i]);
    match reason {
        NoReduction::NoneIgnorable(spoilers) => {
            let all = spoilers
                .iter()
                .map(|spoiler| spoiled(spoiler, &name(&spoiler.coordinate)));
            let all: Vec<String> = all.collect();
            format!(
                "no coordinate is ignorable, so there is nothing to reduce: {}; leave `routhian` out, or write the model in \
                 coordinates of which one neither matters to the Lagrangian nor is acted on by a force",
                all.join("; ")
            )
        }
        NoReduction::NoneRemains => {
            let all: Vec<String> = (0..model.coordinates as usize).map(|i| name(&i)).collect();
            format!(
                "all coordinates are ignorable, {}, so that none remains: all momenta are constant, and \
                 `constants_of_motion` has them; leave `routhian` out",
                all.join(", ")
            )
        }
        NoReduction::ForceDependsOn(acted, on) => format!(
            "the generalized force on {} depends on {}, which would be ignorable otherwise: the other coordinates do not \
             move independently of it; leave `routhian` out, or write the force in other coordinates",
            name(acted),
            name(on)
        ),
        NoReduction::NotQuadratic(coordinate) => format!(
            "{} is ignorable, but the Lagrangian is not quadratic in its velocity, so that the velocity cannot be \
             eliminated: leave `routhian` out",
            name(coordinate)
        ),
    }
}

/// What spoils a coordinate.
fn spoiled(spoiler: &Spoiler, name: &str) -> String {
    let reasons = spoiler.obstacles.iter().map(|obstacle| match obstacle {
        Obstacle::Kinetic => "the kinetic energy depends on it",
        Obstacle::Potential => "the potential energy depends on it",
        Obstacle::Lagrangian => "the Lagrangian depends on it",
        Obstacle::Force => "a force acts on it",
        Obstacle::Input => "an input acts on it",
        Obstacle::Dissipation => "dissipation acts on it",
    });
    let reasons: Vec<&str> = reasons.collect();
    format!("{name} is not, since {}", reasons.join(" and "))
}
