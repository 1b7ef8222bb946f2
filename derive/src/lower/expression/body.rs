//! Bodies among the parameters: their quantities, and the energies of one that moves.
//!
//! A body with the axes r, a rotation that takes components along them to inertial ones, and with their origin at p has the
//! centre of gravity c = p + r `r_C`, the kinetic energy ½ m |ċ|² + ½ ω·\[`I_C`\] ω (4.3), and in a uniform field of gravity
//! with the acceleration g the potential energy −m g·c.

use lagrangian_symbolic::{ArrayFunction, Components, Rational, TypedOperation, Value};
use proc_macro2::Ident;
use quote::ToTokens;
use syn::{Expr, Member};

use super::Lowerer;
use super::component::base_and_indices;
use super::repetition::as_name;
use super::rotation::no_rotation;
use crate::diagnostics::hint;
use crate::lower::body::Body;
use crate::lower::hints;
use crate::lower::scope::{Binding, Origin};
use crate::syntax::body_quantity::BodyQuantity;
use crate::syntax::shape::Shape;

/// A function of a body and of where it is.
struct BodyFunction {
    name: &'static str,
    arguments: &'static [&'static str],
    /// What it takes beside a body and its rotation.
    others: &'static str,
}

static BODY_FUNCTIONS: [BodyFunction; 2] = [
    BodyFunction {
        name: "kinetic_energy",
        arguments: &["body", "r", "p"],
        others: "and the position p of their origin",
    },
    BodyFunction {
        name: "potential_energy",
        arguments: &["body", "r", "p", "gravity"],
        others: "the position p of their origin, and the acceleration of gravity",
    },
];

impl Lowerer<'_> {
    /// The body to which an expression refers; `None` if that is something else.
    #[allow(clippy::option_option)] // Whether it is a body, and whether there are no errors.
    pub(super) fn body(&mut self, written: &Expr) -> Option<Option<Body>> {
        let (base, indices) = base_and_indices(written);
        let name = as_name(base)?;
        let Binding::Bodies(family) = self.scope.resolve(name)? else {
            return None;
        };
        if indices.len() < family.rank {
            return Some(self.reject(written, hints::bodies(name, &family)));
        }
        if let Some(more) = indices.get(family.rank) {
            let message = "this is one body, which has no index: leave it out";
            return Some(self.reject(more, message));
        }
        Some(self.family_member(name, Origin::Field, &family, &indices))
    }

    /// `body.mass`, `body.center`, `body.inertia`; `None` if what stands before the dot is no body.
    #[allow(clippy::option_option)] // Whether it is a body, and whether there are no errors.
    pub(super) fn quantity_of_body(
        &mut self,
        base: &Expr,
        member: &Member,
    ) -> Option<Option<Value>> {
        let Some(body) = self.body(base)? else {
            return Some(None);
        };
        let written = member.to_token_stream().to_string();
        let mut all = BodyQuantity::ALL.into_iter();
        if let Some(quantity) = all.find(|quantity| quantity.name() == written) {
            return Some(Some(body.quantity(quantity)));
        }
        let names = BodyQuantity::ALL.map(BodyQuantity::name);
        let hint = hint(&written, &names, "one");
        Some(self.reject(member, format!("a body has no `{written}`: {hint}")))
    }

    /// `kinetic_energy(body, r, p)` and `potential_energy(body, r, p, gravity)`; `None` if `name` is neither.
    #[allow(clippy::option_option)] // Whether it is a function of bodies, and whether there are no errors.
    pub(super) fn function_of_body(
        &mut self,
        name: &Ident,
        arguments: &[&Expr],
        call: &dyn ToTokens,
    ) -> Option<Option<Value>> {
        let mut functions = BODY_FUNCTIONS.iter();
        let function = functions.find(|function| name == function.name)?;
        Some(self.energy_of_body(function, arguments, call))
    }

    fn energy_of_body(
        &mut self,
        function: &BodyFunction,
        arguments: &[&Expr],
        call: &dyn ToTokens,
    ) -> Option<Value> {
        let BodyFunction { name, others, .. } = function;
        let expected = function.arguments;
        if arguments.len() != expected.len() {
            let message = format!(
                "`{name}` takes a body, its rotation r from its own axes to inertial ones, {others}: write \
                 `{name}({})`",
                expected.join(", ")
            );
            return self.reject(call, message);
        }
        let [body, written, position, gravity @ ..] = arguments else {
            return None;
        };
        let body = self.expected_body(name, body);
        let place = |lowerer: &mut Self| {
            let rotation = "a rotation, which is a 3×3 matrix,";
            let origin = "a position, which has three components,";
            (
                lowerer.matrix_of(3, written, rotation),
                lowerer.matrix_of(1, position, origin),
            )
        };
        // What the kinetic energy is made of is differentiated.
        let (rotation, position) = if gravity.is_empty() {
            self.with_accelerations(place)
        } else {
            place(self)
        };
        let [gravity] = gravity else {
            let rotation = (rotation?, *written);
            return self.kinetic_of_body(&body?, rotation, position?, call);
        };
        let what = "the acceleration of gravity, which is a vector such as `[0.0, 0.0, -g]`,";
        let gravity = self.matrix_of(1, gravity, what);
        let rotation = rotation?;
        if let Components::Array(matrix) = self.typed.components(rotation).clone()
            && let Err(reason) = self.typed.geometry.check_rotation(&matrix)
        {
            return self.reject(written, no_rotation(reason));
        }
        self.potential_of_body(&body?, rotation, position?, gravity?)
    }

    /// The body that an argument is.
    fn expected_body(&mut self, function: &str, argument: &Expr) -> Option<Body> {
        if let Some(body) = self.body(argument) {
            return body;
        }
        // An unknown name is reported as such.
        let value = self.lower_with_accelerations(argument)?;
        let message = format!(
            "`{function}` is of a body, a field of type `RigidBody`, `PrincipalBody` or `SymmetricBody`, and this is {}",
            self.shape(value)
        );
        self.reject(argument, message)
    }

    /// The value of an argument that has three rows and so many columns.
    fn matrix_of(&mut self, columns: usize, argument: &Expr, what: &str) -> Option<Value> {
        let expected = Shape::Array { rows: 3, columns };
        let value = self.lower(argument)?;
        if columns == 1 && self.is_empty_sum(value) {
            return expected.zeros(&mut self.typed);
        }
        let shape = self.shape(value);
        if shape == expected {
            return Some(value);
        }
        let message = format!("{what} belongs here, and this is {shape}");
        self.reject(argument, message)
    }

    /// The centre of gravity c = p + r `r_C`.
    fn center_of_body(&mut self, body: &Body, rotation: Value, position: Value) -> Option<Value> {
        if body.is_centered {
            return Some(position);
        }
        let arm = self.add(TypedOperation::MatrixProduct(rotation, body.center))?;
        let terms = vec![(position, Rational::ONE), (arm, Rational::ONE)];
        self.add(TypedOperation::Sum(terms))
    }

    /// ½ m |ċ|² + ½ ω·\[`I_C`\] ω (4.3).
    fn kinetic_of_body(
        &mut self,
        body: &Body,
        (rotation, argument): (Value, &Expr),
        position: Value,
        call: &dyn ToTokens,
    ) -> Option<Value> {
        let center = self.center_of_body(body, rotation, position)?;
        let angular = self.velocity(call, argument, rotation, false)?;
        let velocity = self.rate(call, center)?;
        let mass = self.typed.expression(body.mass);
        self.turning.push((mass, self.elements(angular).to_vec()));
        let square = self.of_arrays("norm_squared", vec![velocity])?;
        let factors = vec![(body.mass, Rational::ONE), (square, Rational::ONE)];
        let translation = self.add(TypedOperation::Product(factors))?;
        let momentum = self.add(TypedOperation::MatrixProduct(body.inertia, angular))?;
        let rotation = self.of_arrays("dot", vec![angular, momentum])?;
        let halves = [translation, rotation].map(|term| (term, Rational::HALF));
        self.add(TypedOperation::Sum(halves.to_vec()))
    }

    /// −m g·c.
    fn potential_of_body(
        &mut self,
        body: &Body,
        rotation: Value,
        position: Value,
        gravity: Value,
    ) -> Option<Value> {
        let center = self.center_of_body(body, rotation, position)?;
        let along = self.of_arrays("dot", vec![gravity, center])?;
        let factors = vec![(body.mass, Rational::ONE), (along, Rational::ONE)];
        let weight = self.add(TypedOperation::Product(factors))?;
        self.add(TypedOperation::Sum(vec![(weight, Rational::MINUS_ONE)]))
    }

    fn of_arrays(&mut self, function: &str, arguments: Vec<Value>) -> Option<Value> {
        let function = ArrayFunction::named(function)?;
        self.add(TypedOperation::OfArrays(function, arguments))
    }
}
