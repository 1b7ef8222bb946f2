//! What can be wrong with a declaration before its expressions are looked at.
//!
//! Each check says why it is there by what it reports.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Ident;
use syn::Type;

use crate::declaration::{Clause, Declaration, Role};
use crate::diagnostics::{Diagnostics, similar};
use crate::names::{constant, plain};
use crate::scalar::{self, type_parameter};
use crate::scope::RESERVED;

/// Checks names, types of fields and the set of clauses.
pub(crate) fn check(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    check_field_types(declaration, diagnostics);
    scalar::check(declaration, diagnostics);
    check_names(declaration, diagnostics);
    check_constants(declaration, diagnostics);
    check_forces(declaration, diagnostics);
    check_outputs(declaration, diagnostics);
    if !declaration.clauses.unreadable {
        check_clauses(declaration, diagnostics);
    }
}

fn check_field_types(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    for field in declaration
        .fields
        .iter()
        .filter(|field| field.role != Role::Skipped)
    {
        let scalar = type_parameter(&declaration.generics, &field.ty).is_some();
        if !scalar && !is_float(&field.ty) {
            diagnostics.error(
                &field.ty,
                "parameters are of type `f64` or `f32`: change the type, or mark the field \
                 `#[lagrangian(skip)]` if the equations do not need it",
            );
        }
    }
}

fn is_float(ty: &Type) -> bool {
    match ty {
        Type::Path(path) => {
            let last = path.path.segments.last();
            last.is_some_and(|last| last.ident == "f64" || last.ident == "f32")
        }
        Type::Group(group) => is_float(&group.elem),
        Type::Paren(paren) => is_float(&paren.elem),
        _ => false,
    }
}

/// Names are unique, and none is reserved.
fn check_names(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let mut taken: BTreeMap<String, &str> = BTreeMap::new();
    for field in &declaration.fields {
        if field.role != Role::Skipped {
            refuse_reserved(&field.name, diagnostics);
        }
        taken.insert(plain(&field.name), "field");
    }
    let clauses = &declaration.clauses;
    let coordinates = clauses.coordinates.iter().map(|name| (name, "coordinate"));
    let definitions = clauses
        .definitions
        .iter()
        .map(|named| (&named.name, "definition"));
    for (name, kind) in coordinates.chain(definitions) {
        refuse_reserved(name, diagnostics);
        if let Some(holder) = taken.insert(plain(name), kind) {
            let message = if holder == kind {
                format!("`{name}` is declared twice: give one of them another name")
            } else {
                format!("`{name}` is a {holder} already: give this {kind} another name")
            };
            diagnostics.error(name, message);
        }
    }
}

fn refuse_reserved(name: &Ident, diagnostics: &mut Diagnostics) {
    if RESERVED.iter().any(|reserved| name == reserved) {
        let meaning = match name.to_string().as_str() {
            "t" => "the time",
            "PI" => "the number π",
            _ => "the time derivative",
        };
        diagnostics.error(name, format!("`{name}` is {meaning}: choose another name"));
    }
}

/// The constants that every model has.
pub(crate) const CONSTANTS: [&str; 3] = ["COORDINATES", "OPERATIONS", "EQUATIONS"];

/// Each coordinate becomes a constant of the type, beside those that are always there.
fn check_constants(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let mut taken: BTreeMap<String, String> = CONSTANTS
        .into_iter()
        .map(|name| (name.to_owned(), "a constant of every model".to_owned()))
        .collect();
    for name in &declaration.clauses.coordinates {
        let constant = constant(name);
        let kind = format!("the index of `{name}`");
        // The same coordinate twice is reported as such.
        if let Some(holder) = taken.insert(constant.clone(), kind.clone())
            && holder != kind
        {
            let message = format!(
                "this coordinate's index is the constant `{constant}`, which is {holder}: rename the coordinate"
            );
            diagnostics.error(name, message);
        }
    }
}

fn check_forces(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let clauses = &declaration.clauses;
    if clauses.names_unreadable || clauses.coordinates.is_empty() {
        return;
    }
    let coordinates: BTreeSet<String> = clauses.coordinates.iter().map(plain).collect();
    let mut seen = BTreeSet::new();
    for force in &clauses.forces {
        let written = plain(&force.name);
        if !coordinates.contains(&written) {
            let names: Vec<&str> = coordinates.iter().map(String::as_str).collect();
            let hint = match similar(&written, names.iter().copied()) {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => format!("write one of `{}`", names.join("`, `")),
            };
            let message = format!(
                "a generalized force acts on a coordinate, and `{written}` is none: {hint}"
            );
            diagnostics.error(&force.name, message);
        } else if !seen.insert(written) {
            diagnostics.error(
                &force.name,
                "this coordinate has a force already: add them up in one expression",
            );
        }
    }
}

fn check_outputs(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let mut seen = BTreeSet::new();
    for output in &declaration.clauses.outputs {
        if !seen.insert(plain(&output.name)) {
            let message = format!(
                "the output `{}` is declared twice: give one of them another name",
                output.name
            );
            diagnostics.error(&output.name, message);
        }
    }
}

fn check_clauses(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let clauses = &declaration.clauses;
    let name = &declaration.name;
    if clauses.coordinates.is_empty() {
        let message = "no coordinates: write `#[lagrangian(coordinates(theta), kinetic = …)]`";
        return diagnostics.error(name, message);
    }
    if let [_, second, ..] = clauses.lagrangian.as_slice() {
        diagnostics.error(
            &second.keyword,
            "there is a Lagrangian already: add them up in one expression",
        );
    }
    match (clauses.lagrangian.first(), clauses.kinetic.first(), clauses.potential.first()) {
        (Some(lagrangian), Some(energy), _) | (Some(lagrangian), None, Some(energy)) => {
            diagnostics.error(
                &lagrangian.keyword,
                format!(
                    "`lagrangian` stands in place of `kinetic` and `potential`: remove it, or `{}`",
                    energy.keyword
                ),
            );
        }
        (None, None, potential) => diagnostics.error(
            potential.map_or(name, |potential: &Clause| &potential.keyword),
            "no kinetic energy: write `kinetic = 0.5 * m * dot(x).powi(2)`, or a whole `lagrangian = …`",
        ),
        _ => {}
    }
}
