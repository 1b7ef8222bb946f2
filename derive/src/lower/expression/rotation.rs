//! Rotations by angles about body axes (intrinsic), and their angular velocities.

use lagrangian_symbolic::{Axis, NoRotation, NoValue, TypedOperation, Value};
use proc_macro2::Ident;
use quote::ToTokens;
use syn::{Expr, ExprCall};

use super::Lowerer;
use crate::limits::MAX_ROTATIONS;
use crate::syntax::shape::Shape;

/// The result of a function of angles about axes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum RotationFunction {
    Rotation,
    AngularVelocity { is_inertial: bool },
}

/// The sequences of three axes: of proper Euler angles, then of Tait–Bryan angles.
const SEQUENCES: &str = "zxz, xyx, yzy, zyz, xzx, yxy, xyz, yzx, zxy, xzy, zyx, yxz";

impl Lowerer<'_> {
    /// `rotation_zxz(a, b, c)`, `angular_velocity_zxz(a, b, c)`, `angular_velocity(r)` and their kin;
    /// `None` if `name` is none of those.
    #[allow(clippy::option_option)] // Whether it is a rotation, and whether it has no errors.
    pub(super) fn rotation(
        &mut self,
        name: &Ident,
        call: &ExprCall,
        arguments: &[&Expr],
    ) -> Option<Option<Value>> {
        let written = name.to_string();
        if let "angular_velocity" | "angular_velocity_inertial" = written.as_str() {
            let inertial = written != "angular_velocity";
            return Some(self.angular_velocity(name, call, arguments, inertial));
        }
        let (function, letters) = parts(&written)?;
        Some(self.sequence(name, call, arguments, function, letters))
    }

    fn sequence(
        &mut self,
        name: &Ident,
        call: &ExprCall,
        arguments: &[&Expr],
        function: RotationFunction,
        letters: &str,
    ) -> Option<Value> {
        let Some(axes) = axes(letters) else {
            let message = format!(
                "`{letters}` is no sequence of axes, of which neighbours differ: write one of `x`, `y`, `z`, \
                 or of {SEQUENCES}"
            );
            return self.reject(name, message);
        };
        if arguments.len() != axes.len() {
            let letters: Vec<&str> = ["a", "b", "c"][..axes.len()].to_vec();
            let message = format!(
                "`{name}` takes one angle for each axis: write `{name}({})`",
                letters.join(", ")
            );
            return self.reject(call, message);
        }
        // The angles of an angular velocity are differentiated.
        let angles = |lowerer: &mut Self| lowerer.each(arguments.iter().copied(), Self::scalar);
        let angles = match function {
            RotationFunction::Rotation => angles(self)?,
            RotationFunction::AngularVelocity { .. } => self.with_accelerations(angles)?,
        };
        let factors: Vec<_> = axes.into_iter().zip(angles).collect();
        self.count_rotation(call)?;
        let rotation = self.add(TypedOperation::Rotation(factors))?;
        match function {
            RotationFunction::Rotation => Some(rotation),
            RotationFunction::AngularVelocity { is_inertial } => {
                self.velocity(call, call, rotation, is_inertial)
            }
        }
    }

    /// The angular velocity of a rotation that is given as a matrix.
    fn angular_velocity(
        &mut self,
        name: &Ident,
        call: &ExprCall,
        arguments: &[&Expr],
        inertial: bool,
    ) -> Option<Value> {
        let [argument] = arguments else {
            let message =
                format!("`{name}` takes one argument, a rotation matrix: write `{name}(r)`");
            return self.reject(call, message);
        };
        let value = self.lower_with_accelerations(argument)?;
        let square = |size| Shape::Array {
            rows: size,
            columns: size,
        };
        let shape = self.shape(value);
        if shape == square(3) {
            return self.velocity(call, argument, value, inertial);
        }
        let hint = if shape == square(4) {
            ": of a homogeneous matrix write `a.view((0, 0), (3, 3))`"
        } else {
            ""
        };
        let message = format!("`{name}` is of a rotation, a 3×3 matrix, and this is {shape}{hint}");
        self.reject(argument, message)
    }

    /// One more rotation, unless there are too many.
    pub(crate) fn count_rotation(&mut self, tokens: impl ToTokens) -> Option<()> {
        self.rotations += 1;
        if self.rotations <= MAX_ROTATIONS {
            return Some(());
        }
        let message = format!(
            "at most {MAX_ROTATIONS} rotations are in one declaration, and here are more: a product of them is computed for \
             each; declare fewer links, or bodies of which several are one"
        );
        self.rotations = 0;
        self.reject(tokens, message)
    }

    pub(super) fn velocity(
        &mut self,
        call: &dyn ToTokens,
        argument: &dyn ToTokens,
        rotation: Value,
        is_inertial: bool,
    ) -> Option<Value> {
        self.count_rotation(call)?;
        self.check_differentiable(call, rotation)?;
        let operation = TypedOperation::AngularVelocity {
            rotation,
            is_inertial,
        };
        let velocity = match self.typed.add(operation) {
            Ok(velocity) => velocity,
            Err(NoValue::NoRotation(reason)) => {
                let message = format!(
                    "{}, so that it has no angular velocity",
                    no_rotation(reason)
                );
                return self.reject(argument, message);
            }
            Err(_) => return None,
        };
        self.check_derivative(call, velocity)?;
        Some(velocity)
    }
}

/// Why a matrix is no rotation.
pub(super) fn no_rotation(reason: NoRotation) -> &'static str {
    match reason {
        NoRotation::Reflection => "this is no rotation but reflects",
        _ => "this is no rotation: its transpose times itself is not the identity",
    }
}

/// The result of a function of angles, and the letters of its axes.
fn parts(name: &str) -> Option<(RotationFunction, &str)> {
    if let Some(letters) = name.strip_prefix("rotation_") {
        return Some((RotationFunction::Rotation, letters));
    }
    let letters = name.strip_prefix("angular_velocity_")?;
    let inertial = letters.strip_suffix("_inertial");
    let is_inertial = inertial.is_some();
    let function = RotationFunction::AngularVelocity { is_inertial };
    Some((function, inertial.unwrap_or(letters)))
}

/// The axes of a sequence of one to three letters, of which neighbours differ.
fn axes(letters: &str) -> Option<Vec<Axis>> {
    let axes: Vec<Axis> = letters
        .chars()
        .map(|letter| match letter {
            'x' => Some(Axis::X),
            'y' => Some(Axis::Y),
            'z' => Some(Axis::Z),
            _ => None,
        })
        .collect::<Option<_>>()?;
    let differ = letters.as_bytes().windows(2).all(|pair| pair[0] != pair[1]);
    (differ && (1..=3).contains(&axes.len())).then_some(axes)
}
