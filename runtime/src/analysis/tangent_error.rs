//! The errors of linear models of constrained mechanisms.

use core::fmt;

use crate::error_messages::error_messages;
use crate::number_format::Readable;

/// What a choice of independent variables is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum IndependentVariables {
    /// Coordinates.
    Coordinates,
    /// Velocities.
    Velocities,
}

/// The reason why a constrained model has no linear model at a state.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum TangentError {
    /// No coordinate has the index.
    NoSuchCoordinate {
        /// The index that was chosen.
        index: usize,
    },
    /// The state does not meet a constraint.
    Inconsistent {
        /// The name of the constraint that is violated most.
        constraint: &'static str,
        /// Its residual, or the residual of its velocity if the coordinates meet it.
        residual: f64,
    },
    /// At a singular configuration, fewer constraints are independent than nearby, and there are no tangents.
    Singular {
        /// The name of a constraint that depends on others here.
        constraint: &'static str,
        /// The number of constraints that are independent at the state.
        rank: usize,
        /// The number of constraints that are independent nearby.
        nearby: usize,
    },
    /// Too few or too many variables were chosen.
    Count {
        /// What was chosen.
        variables: IndependentVariables,
        /// How many were chosen, with the coordinates that are left out.
        chosen: usize,
        /// How many are independent at the state.
        independent: usize,
    },
    /// The chosen variables do not determine the others.
    NotIndependent {
        /// What was chosen.
        variables: IndependentVariables,
        /// The coordinate that they do not determine.
        free: &'static str,
        /// One of the chosen coordinates, which follows from the others.
        bound: &'static str,
        /// The largest pivot that is left in the elimination, relative to gradients of length 1 in the metric of M.
        pivot: f64,
    },
    /// The linear model has another dimension.
    Dimension {
        /// The `D` that was asked for.
        given: usize,
        /// The number of independent coordinates that are not left out, and of independent velocities.
        variables: [usize; 2],
    },
    /// Small oscillations need an independent velocity for each independent coordinate that is not left out.
    NoVelocity {
        /// The coordinate.
        name: &'static str,
    },
    /// A coordinate that is left out acts on the others.
    Acts {
        /// The coordinate that is left out.
        coordinate: &'static str,
        /// The coordinate on whose velocity or acceleration it acts.
        on: &'static str,
        /// The derivative.
        slope: f64,
    },
    /// A coordinate that is not left out has a velocity: the motion is not steady.
    Moving {
        /// The coordinate.
        name: &'static str,
        /// Its velocity.
        velocity: f64,
    },
    /// An independent velocity changes: the state is neither an equilibrium nor a steady motion.
    Accelerated {
        /// The coordinate.
        name: &'static str,
        /// Its acceleration.
        acceleration: f64,
    },
    /// A derivative is infinite or not a number.
    NotFinite {
        /// The coordinate whose velocity or acceleration has it.
        name: &'static str,
    },
}

impl fmt::Display for IndependentVariables {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Coordinates => "coordinates",
            Self::Velocities => "velocities",
        })
    }
}

error_messages! { TangentError:
    Self::NoSuchCoordinate { index } =>
        "no coordinate has the index {index}: use the constants of the model, such as `Model::THETA`";
    Self::Inconsistent { constraint, residual } =>
        "the state does not meet the constraint `{constraint}`, whose residual is {}; `assemble` finds a state that does",
        Readable(residual);
    Self::Singular { constraint, rank, nearby } =>
        "the configuration is singular: `{constraint}` depends on other constraints, of which {rank} are independent here and \
         {nearby} nearby; linearize at another state";
    Self::Count { variables, chosen, independent } =>
        "{chosen} {variables} are chosen, and {independent} are independent at this state; `degrees_of_freedom` proposes some";
    Self::NotIndependent { variables, free, bound, pivot } =>
        "the chosen {variables} are not independent at this state: `{bound}` follows from the others, and none of them \
         determines `{free}` (pivot {}); choose `{free}` in place of `{bound}`",
        Readable(pivot);
    Self::Dimension { given, variables: [coordinates, velocities] } =>
        "the linear model has {coordinates} coordinates and {velocities} velocities: `D` is {}, not {given}",
        coordinates + velocities;
    Self::NoVelocity { name } =>
        "`{name}` is an independent coordinate, and its velocity is not independent: leave it out by `without`, or take \
         `StateSpace::reduced`";
    Self::Acts { coordinate, on, slope } =>
        "`{coordinate}` cannot be left out: it acts on `{on}`, with the derivative {}; keep it, or choose independent \
         velocities that are the same in all directions",
        Readable(slope);
    Self::Moving { name, velocity } =>
        "the motion is not steady: `{name}` has the velocity {}; leave it out by `without` if the motion does not \
         depend on it, or linearize about the motion by `along_motion`",
        Readable(velocity);
    Self::Accelerated { name, acceleration } =>
        "the state is neither an equilibrium nor a steady motion: `{name}` has the acceleration {}; linearize about \
         the motion by `along_motion`",
        Readable(acceleration);
    Self::NotFinite { name } =>
        "the derivatives of the velocity or the acceleration of `{name}` are not finite";
}
