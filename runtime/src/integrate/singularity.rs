//! Reports of singular mass matrices.

use core::fmt;

use crate::limits::REPORTED_COORDINATES;
use crate::number_format::{Readable, write_values};

/// A configuration in which the mass matrix is singular, or so ill-conditioned that the accelerations
/// have lost their accuracy.
///
/// z-x-z Euler angles are singular where sin θ = 0 (gimbal lock); there φ and ψ turn about the same axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Singularity {
    relative_pivot: f64,
    /// In 32 bits, so that errors stay short.
    coordinate: u32,
    names: &'static [&'static str],
    dependencies: &'static [usize],
    values: [f64; REPORTED_COORDINATES],
    cause: Cause,
}

/// The cause of a singularity.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Cause {
    /// The mass matrix is singular.
    MassMatrix,
    /// The state is at a pole of a reduced model in this coordinate, whose value is the first of `values`.
    Pole,
    /// The Lagrangian is not a number.
    OutsideDomain,
    /// A constraint restricts only velocities that others restrict already. The field `coordinate` holds its name.
    Constraint,
}

impl Singularity {
    /// Creates the singularity in the block of the mass matrix that belongs to `coordinate`.
    ///
    /// `names` are the names of all coordinates, `dependencies` are the indices of the coordinates on which the
    /// determinant of the block depends, and `value` returns the value of a coordinate.
    pub fn new(
        relative_pivot: f64,
        coordinate: usize,
        names: &'static [&'static str],
        dependencies: &'static [usize],
        value: impl Fn(usize) -> f64,
    ) -> Self {
        let mut values = [f64::NAN; REPORTED_COORDINATES];
        for (slot, index) in values.iter_mut().zip(dependencies) {
            *slot = value(*index);
        }
        Self {
            relative_pivot,
            coordinate: u32::try_from(coordinate).unwrap_or(u32::MAX),
            names,
            dependencies,
            values,
            cause: Cause::MassMatrix,
        }
    }

    /// Creates the singularity of a constraint that depends on others.
    pub(crate) fn of_constraint(
        relative_pivot: f64,
        constraint: usize,
        names: &'static [&'static str],
    ) -> Self {
        Self {
            cause: Cause::Constraint,
            ..Self::new(relative_pivot, constraint, names, &[], |_| f64::NAN)
        }
    }

    /// Changes the cause to a pole of a reduced model in its coordinate, which has this value.
    pub(crate) fn at_pole(mut self, value: f64) -> Self {
        self.cause = Cause::Pole;
        self.values[0] = value;
        self
    }

    /// Changes the cause to a Lagrangian that is not a number.
    pub(crate) fn outside_domain(mut self) -> Self {
        self.cause = Cause::OutsideDomain;
        self
    }

    /// Whether the error of the accelerations can be estimated.
    pub(crate) fn has_estimate(&self) -> bool {
        self.relative_pivot > 0.0 || self.cause == Cause::MassMatrix
    }

    /// Returns the number of coordinates that cause the singularity.
    fn count(&self) -> usize {
        match self.cause {
            Cause::MassMatrix => self.dependencies.len(),
            Cause::Pole => 1,
            Cause::OutsideDomain | Cause::Constraint => 0,
        }
    }

    /// Returns the relative pivot: the pivot of the factored mass matrix over its diagonal entry before elimination, sin²θ
    /// at a pole of θ, or sin² of the angle between the gradient of a constraint and the span of the other gradients.
    #[must_use]
    pub fn relative_pivot(&self) -> f64 {
        self.relative_pivot
    }

    /// Returns the name of the coordinate, or of the constraint, to which the pivot belongs.
    #[must_use]
    pub fn coordinate(&self) -> &'static str {
        usize::try_from(self.coordinate).map_or("?", |index| self.name(index))
    }

    /// Returns the names and values of the coordinates on which the singularity depends, at most six of them. There are
    /// none if parameters or the time alone make the mass matrix singular.
    pub fn coordinates(&self) -> impl Iterator<Item = (&'static str, f64)> + '_ {
        let dependency = |i: usize| match self.dependencies.get(i) {
            Some(index) if self.cause == Cause::MassMatrix => self.name(*index),
            _ => self.coordinate(),
        };
        (0..self.count()).map(dependency).zip(self.values)
    }

    fn name(&self, index: usize) -> &'static str {
        self.names.get(index).copied().unwrap_or("?")
    }
}

/// The configuration at a singularity as the end of a clause.
pub(crate) struct SingularCoordinates<'a>(pub(crate) &'a Singularity);

impl fmt::Display for SingularCoordinates<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = self.0.count();
        if count > 0 {
            f.write_str(" where ")?;
        }
        let left_out = count.saturating_sub(REPORTED_COORDINATES);
        write_values(f, "=", self.0.coordinates(), left_out)
    }
}

impl fmt::Display for Singularity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (coordinate, pivot) = (self.coordinate(), self.relative_pivot);
        match self.cause {
            Cause::Pole => {
                let value = Readable(self.values[0]);
                let (lost, near) = if pivot > 0.0 {
                    ("loses its digits at", ", near a pole")
                } else {
                    ("has no accelerations at the pole", "")
                };
                write!(
                    f,
                    "the reduced model {lost} {coordinate} = {value}{near} of its angles: write \
                     `routhian(Name, half_angles)`, which has them for the constants with which a pole is reached"
                )
            }
            Cause::OutsideDomain => f.write_str(
                "the Lagrangian is not a number: a root, a logarithm or another function in it is taken outside of its \
                 domain, as where a velocity exceeds the largest one; begin within the domain",
            ),
            Cause::Constraint => write!(
                f,
                "the constraint {coordinate} depends on others or nearly so (relative pivot {pivot:.1e}), so that the \
                 reactions are not unique: at a dead centre or a change point of the mechanism begin elsewhere, or let the \
                 method pass_singular_configurations(), and leave out a constraint that follows from others"
            ),
            Cause::MassMatrix => {
                let advice = if self.dependencies.is_empty() {
                    "it is so whatever the coordinates are: look for a parameter such as a mass or \
                     an inertia that is zero or not a number"
                } else {
                    "use coordinates that are regular there, for Euler angles another sequence, \
                     unless a mass or an inertia is zero or not a number"
                };
                write!(
                    f,
                    "the mass matrix is singular or nearly so (relative pivot {pivot:.1e} at {coordinate}){}; {advice}",
                    SingularCoordinates(self)
                )
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Singularity;

    #[test]
    fn values_beyond_the_sixth_are_counted() {
        const NAMES: &[&str] = &["a", "b", "c", "d", "e", "f", "g"];
        let report = Singularity::new(0.0, 9, NAMES, &[0, 1, 2, 3, 4, 5, 6], |i| {
            f64::from(u8::try_from(i).unwrap())
        });
        assert_eq!(report.coordinates().count(), 6);
        assert_eq!(report.coordinate(), "?");
        let text = std::format!("{report}");
        assert!(text.contains("where a = 0, b = 1"), "{text}");
        assert!(text.contains("f = 5 and 1 more"), "{text}");
    }
}
