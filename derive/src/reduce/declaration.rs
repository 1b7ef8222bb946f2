//! The declaration of a reduced model, as if it had been written: the fields of the full one and the constant momenta, the
//! coordinates that remain, and the clauses that the reduced model has, too.

use std::collections::BTreeSet;

use proc_macro2::Ident;
use syn::{Type, parse_quote};

use super::Split;
use crate::lower::Lowered;
use crate::syntax::clauses::Clauses;
use crate::syntax::coordinate::{Coordinate, indices};
use crate::syntax::declaration::Declaration;
use crate::syntax::field::{Field, Role};
use crate::syntax::label::Label;
use crate::syntax::named::NamedExpression;
use crate::syntax::names::{hygienic_span, to_source, unraw};
use crate::syntax::parameter_list::ParameterList;
use crate::syntax::routhian::RouthianClause;
use crate::syntax::scalar::Scalar;

/// The declaration of the reduced struct. Names that are fields already are not fields once more.
pub(super) fn reduced_declaration(
    declaration: &Declaration,
    lowered: &Lowered,
    split: &Split,
    clause: &RouthianClause,
) -> Declaration {
    let scalar = Scalar::of(declaration).of_parameters();
    let labels = &lowered.quantities.coordinates;
    let ty: Type = parse_quote!(#scalar);
    let constants = split.ignorable.iter().map(|i| Field {
        name: named(&labels[*i].momentum(), clause),
        ty: ty.clone(),
        declared_type: None,
        role: Role::Parameter,
        readable: true,
        visibility: declaration.visibility.clone(),
        documentation: format!("The momentum of {}.", labels[*i]),
    });
    let constants = constants.filter(|constant| {
        let mut fields = declaration.fields.iter();
        fields.all(|field| unraw(&field.name) != unraw(&constant.name))
    });
    let constants: Vec<Field> = constants.collect();
    let clauses = &declaration.clauses;
    let wanted = |name: &str| !is_left_out(name, clause, clauses);
    Declaration {
        name: clause.name.clone(),
        documentation: declaration.documentation.clone(),
        visibility: declaration.visibility.clone(),
        generics: declaration.generics.clone(),
        fields: declaration
            .fields
            .iter()
            .chain(&constants)
            .cloned()
            .collect(),
        names_fields: true,
        allowed: declaration.allowed.clone(),
        clauses: Clauses {
            coordinates: remaining_coordinates(declaration, labels, split, clause),
            functions: clauses.functions.clone(),
            constraints: clauses.constraints.clone(),
            nonholonomic: clauses.nonholonomic.clone(),
            compliances: clauses.compliances.clone(),
            outputs: retained(&clauses.outputs, clause),
            events: retained(&clauses.events, clause),
            taylor: clauses.taylor.clone().filter(|_| wanted("taylor")),
            hamiltonian: clauses
                .hamiltonian
                .clone()
                .filter(|_| wanted("hamiltonian")),
            energy_balance: clauses
                .energy_balance
                .clone()
                .filter(|_| wanted("energy_balance")),
            sensitivities: with_constants(clauses.sensitivities.as_ref(), &constants)
                .filter(|_| wanted("sensitivities")),
            regressor: clauses.regressor.clone().filter(|_| wanted("regressor")),
            c: clauses.c.clone().filter(|_| wanted("c")),
            scalar: clauses.scalar.clone(),
            ..Clauses::default()
        },
        root: declaration.root.clone(),
    }
}

/// The clauses that a reduced model can do without.
pub(super) const CLAUSES: [&str; 6] = [
    "taylor",
    "hamiltonian",
    "energy_balance",
    "sensitivities",
    "regressor",
    "c",
];

/// Whether the reduced model shall not have a clause: an output or an event of that name comes first.
fn is_left_out(name: &str, clause: &RouthianClause, clauses: &Clauses) -> bool {
    let mut observed = clauses.outputs.iter().chain(&clauses.events);
    observed.all(|named| unraw(&named.name) != name) && leaves_out(clause, name)
}

/// Whether a name stands in `without(…)`.
pub(super) fn leaves_out(clause: &RouthianClause, name: &str) -> bool {
    let mut names = clause.without.iter();
    names.any(|other| unraw(other) == name)
}

fn retained(named: &[NamedExpression], clause: &RouthianClause) -> Vec<NamedExpression> {
    let named = named.iter();
    let retained = named.filter(|named| !leaves_out(clause, &unraw(&named.name)));
    retained.cloned().collect()
}

/// A list that names some parameters, with the constant momenta behind them.
fn with_constants(list: Option<&ParameterList>, constants: &[Field]) -> Option<ParameterList> {
    let mut list = list?.clone();
    if let Some(fields) = &mut list.fields {
        fields.extend(constants.iter().map(|constant| constant.name.clone()));
    }
    Some(list)
}

/// The declared coordinates of which all scalars remain, and the scalars that remain of the others.
fn remaining_coordinates(
    declaration: &Declaration,
    labels: &[Label],
    split: &Split,
    clause: &RouthianClause,
) -> Vec<Coordinate> {
    let remains: BTreeSet<usize> = split.remaining.iter().copied().collect();
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
