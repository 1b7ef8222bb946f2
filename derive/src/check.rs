//! What can be wrong with a declaration before its expressions are looked at.
//!
//! Each check says why it is there by what it reports.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Ident;
use syn::Type;

use crate::clauses::Clause;
use crate::declaration::Declaration;
use crate::diagnostics::{Diagnostics, similar};
use crate::field::Role;
use crate::field_type::{MOST_COMPONENTS, Unfit};
use crate::function;
use crate::named::Named;
use crate::names::{constant, plain};
use crate::plan::is_method;
use crate::scalar::{self, Scalar, type_parameter};
use crate::scope::RESERVED;

/// Checks names, types of fields and the set of clauses.
pub(crate) fn check(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    check_field_types(declaration, diagnostics);
    check_coordinate_types(declaration, diagnostics);
    scalar::check(declaration, diagnostics);
    check_names(declaration, diagnostics);
    function::check(declaration, diagnostics);
    check_constants(declaration, diagnostics);
    check_forces(declaration, diagnostics);
    check_outputs(declaration, diagnostics);
    if !declaration.clauses.unreadable {
        check_energies(declaration, diagnostics);
    }
}

/// The components of a vector of coordinates are numbers of the model.
fn check_coordinate_types(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    for coordinate in &declaration.clauses.coordinates {
        let element = coordinate.element();
        if let Some(element) = element.filter(|element| !is_number(declaration, element)) {
            let message =
                "the components of a coordinate are numbers: leave out their type, as in `Vector3`";
            diagnostics.error(element, message);
        }
    }
}

fn check_field_types(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    for field in declaration
        .fields
        .iter()
        .filter(|field| field.role != Role::Skipped && field.readable)
    {
        let ty = field.meant();
        let message = match field.form() {
            Ok(read) if is_number(declaration, read.element) => continue,
            Ok(_) | Err(Unfit::Unknown) => {
                "parameters are of type `f64`, `f32`, arrays of them such as `[f64; 5]`, or vectors and \
                 matrices of nalgebra such as `Vector3<f64>`: change the type, name what it is an alias of by \
                 `#[lagrangian(type = Vector3<f64>)]`, or mark the field `#[lagrangian(skip)]` if the \
                 equations do not need it"
            }
            Err(Unfit::Length) => {
                "the equations are derived for a certain number of components: write it as a number, as in \
                 `[f64; 5]`"
            }
            Err(Unfit::TooMany) => {
                let message = format!(
                    "a parameter has at most {MOST_COMPONENTS} numbers, each of which is a symbol of the equations: \
                     mark a larger table `#[lagrangian(skip)]`, and read it by a function from outside, as in \
                     `function(table(x) = self.table.at(x), derivative(x) = 0.0)`"
                );
                diagnostics.error(ty, message);
                continue;
            }
        };
        diagnostics.error(ty, message);
    }
}

/// Whether a type is one of plain numbers, or the scalar of a generic struct.
pub(crate) fn is_number(declaration: &Declaration, ty: &Type) -> bool {
    let scalar = Scalar::of(declaration);
    type_parameter(&declaration.generics, ty).is_some() || is_float(ty) || scalar.is(ty)
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
    let coordinates = clauses.coordinates.iter();
    let coordinates = coordinates.map(|coordinate| (&coordinate.name, "coordinate"));
    let definitions = first_of_families(&clauses.definitions)
        .into_iter()
        .map(|name| (name, "definition"));
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

/// The names of definitions; that of a family once, though its members may be defined one by one.
fn first_of_families(definitions: &[Named]) -> Vec<&Ident> {
    let mut families = BTreeSet::new();
    let first = |named: &&Named| named.indices.is_empty() || families.insert(plain(&named.name));
    definitions
        .iter()
        .filter(first)
        .map(|named| &named.name)
        .collect()
}

pub(crate) fn refuse_reserved(name: &Ident, diagnostics: &mut Diagnostics) {
    if RESERVED.iter().any(|reserved| name == reserved) {
        let meaning = match name.to_string().as_str() {
            "t" => "the time",
            "PI" => "the number π",
            _ => "the time derivative",
        };
        diagnostics.error(name, format!("`{name}` is {meaning}: choose another name"));
    }
}

/// The constants of its type that every model has.
pub(crate) const CONSTANTS: [&str; 3] = ["COORDINATES", "OPERATIONS", "EQUATIONS"];

/// The constants of traits that a model has; a constant of the type would hide them.
const CONSTANTS_OF_SYSTEMS: [&str; 3] = ["ANGLES", "IGNORABLE", "SINGULARITIES"];
pub(crate) const CONSTANTS_OF_INPUTS: [&str; 1] = ["INPUTS"];
const CONSTANTS_OF_FUNCTIONS: [&str; 1] = ["FUNCTIONS"];

/// The constants that a model has, with what they are constants of.
fn constants(declaration: &Declaration) -> BTreeMap<String, String> {
    let has_inputs = declaration.fields_with(Role::Input).next().is_some();
    let has_functions = !declaration.clauses.functions.is_empty();
    let every = "a constant of every model";
    let all: [(&[&str], bool, &str); 4] = [
        (&CONSTANTS, true, every),
        (&CONSTANTS_OF_SYSTEMS, true, every),
        (
            &CONSTANTS_OF_INPUTS,
            has_inputs,
            "a constant of every model with inputs",
        ),
        (
            &CONSTANTS_OF_FUNCTIONS,
            has_functions,
            "a constant of every model with functions from outside",
        ),
    ];
    let all = all.into_iter().filter(|(_, there, _)| *there);
    all.flat_map(|(names, _, holder)| {
        let names = names.iter();
        names.map(move |name| ((*name).to_owned(), holder.to_owned()))
    })
    .collect()
}

/// Each coordinate and each input becomes a constant of the type, beside those that are always there.
fn check_constants(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let mut taken = constants(declaration);
    let coordinates = declaration.clauses.coordinates.iter();
    let coordinates = coordinates.map(|coordinate| (&coordinate.name, "coordinate"));
    let inputs = declaration.fields_with(Role::Input);
    let inputs = inputs.map(|field| (&field.name, "input"));
    for (name, quantity) in coordinates.chain(inputs) {
        let constant = constant(name);
        let kind = format!("the index of `{name}`");
        // The same name twice is reported as such.
        if let Some(holder) = taken.insert(constant.clone(), kind.clone())
            && holder != kind
        {
            let message = format!(
                "this {quantity}'s index is the constant `{constant}`, which is {holder}: rename the {quantity}"
            );
            diagnostics.error(name, message);
        }
    }
}

/// Forces act on coordinates and on what is defined by them. That none of a clause acts twice on the same
/// coordinate shows when indices are known.
fn check_forces(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let clauses = &declaration.clauses;
    if clauses.names_unreadable || clauses.coordinates.is_empty() {
        return;
    }
    let coordinates = clauses.coordinates.iter();
    let coordinates = coordinates.map(|coordinate| plain(&coordinate.name));
    let definitions = clauses.definitions.iter();
    let definitions = definitions.map(|definition| plain(&definition.name));
    let coordinates: BTreeSet<String> = coordinates.collect();
    let names: BTreeSet<String> = coordinates.iter().cloned().chain(definitions).collect();
    for force in clauses.forces.iter().flatten() {
        let written = plain(&force.name);
        if !names.contains(&written) {
            let meant = similar(&written, names.iter().map(String::as_str));
            let hint = meant.map_or_else(
                || {
                    let coordinates: Vec<_> = coordinates.iter().map(String::as_str).collect();
                    format!("write one of `{}`", coordinates.join("`, `"))
                },
                |meant| format!("did you mean `{meant}`?"),
            );
            let message = format!(
                "a force acts on a coordinate or on a position that is defined, and `{written}` is neither: {hint}"
            );
            diagnostics.error(&force.name, message);
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
        } else if is_method(&output.name.to_string()) {
            let message = format!(
                "`{0}` is a method of every model: give the output another name, such as `{0}_shown`",
                output.name
            );
            diagnostics.error(&output.name, message);
        }
        if !output.indices.is_empty() || !output.iterations.is_empty() {
            let message = format!(
                "an output is one quantity, which may be a vector: write \
                 `{} = (0..5).map(|i| …).collect()`",
                output.name
            );
            diagnostics.error(&output.name, message);
        }
    }
}

/// A Lagrangian is given once, as such or by its energies.
fn check_energies(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let clauses = &declaration.clauses;
    if let [_, second, ..] = clauses.lagrangian.as_slice() {
        diagnostics.error(
            &second.keyword,
            "there is a Lagrangian already: add them up in one expression",
        );
    }
    let energy = clauses.kinetic.first().or(clauses.potential.first());
    if let (Some(lagrangian), Some(energy)) = (clauses.lagrangian.first(), energy) {
        diagnostics.error(
            &lagrangian.keyword,
            format!(
                "`lagrangian` stands in place of `kinetic` and `potential`: remove it, or `{}`",
                energy.keyword
            ),
        );
    }
}

/// What is missing. That is no news while there are other errors: a declaration that is being typed ends
/// somewhere.
pub(crate) fn check_whole(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let clauses = &declaration.clauses;
    let name = &declaration.name;
    if clauses.coordinates.is_empty() {
        let message = "no coordinates: write `#[lagrangian(coordinates(theta), kinetic = …)]`";
        diagnostics.error(name, message);
    } else if clauses.lagrangian.is_empty() && clauses.kinetic.is_empty() {
        let potential = clauses.potential.first();
        diagnostics.error(
            potential.map_or(name, |potential: &Clause| &potential.keyword),
            "no kinetic energy: write `kinetic = 0.5 * m * dot(x).powi(2)`, or a whole `lagrangian = …`",
        );
    }
}
