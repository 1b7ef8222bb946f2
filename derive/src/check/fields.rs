//! Checks of the types of fields and of coordinates.

use crate::diagnostics::Diagnostics;
use crate::limits::MAX_COMPONENTS;
use crate::syntax::declaration::Declaration;
use crate::syntax::field::Role;
use crate::syntax::field_type::Content;
use crate::syntax::field_type::UnsupportedType;
use crate::syntax::scalar::{has_numbers, is_number};

/// The components of a vector of coordinates are numbers of the model.
pub(super) fn check_coordinate_types(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    for coordinate in &declaration.clauses.coordinates {
        let element = coordinate.element();
        if let Some(element) = element.filter(|element| !is_number(declaration, element)) {
            let message =
                "the components of a coordinate are numbers: leave out their type, as in `Vector3`";
            diagnostics.error(element, message);
        }
    }
}

pub(super) fn check_field_types(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    for field in declaration
        .fields
        .iter()
        .filter(|field| field.role != Role::Skipped && field.readable)
    {
        let ty = field.declared_type();
        let message = match field.field_type() {
            Ok(read) if has_numbers(declaration, &read) => {
                if let (Role::Input, Content::Body(_)) = (field.role, read.content()) {
                    diagnostics.error(ty, NO_INPUT);
                }
                continue;
            }
            Ok(_) | Err(UnsupportedType::Unknown) => {
                "parameters are of type `f64`, `f32`, arrays of them such as `[f64; 5]`, vectors and \
                 matrices of nalgebra such as `Vector3<f64>`, or bodies such as `RigidBody`: change the type, name what it is an alias of by \
                 `#[lagrangian(type = Vector3<f64>)]`, or mark the field `#[lagrangian(skip)]` if the \
                 equations do not need it"
            }
            Err(UnsupportedType::Length) => {
                "the equations are derived for a certain number of components: write it as a number, as in \
                 `[f64; 5]`"
            }
            Err(UnsupportedType::TooMany) => {
                let message = format!(
                    "a parameter has at most {MAX_COMPONENTS} numbers, each of which is a symbol of the equations: \
                     mark a larger table `#[lagrangian(skip)]`, and read it by an external function, as in \
                     `function(table(x) = self.table.at(x), derivative(x) = 0.0)`"
                );
                diagnostics.error(ty, message);
                continue;
            }
        };
        diagnostics.error(ty, message);
    }
}

const NO_INPUT: &str = "an input is a number, a vector or a matrix, and a body is none: let it be a parameter, or its numbers \
                        inputs of their own";
