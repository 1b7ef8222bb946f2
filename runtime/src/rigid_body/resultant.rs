//! Resultant force (1.2) and resultant moment (3.3).

use core::ops::Add;

use nalgebra::Vector3;

use crate::scalar::Scalar;

/// The resultant of forces and moments on a rigid body: one force, and one moment about a point.
///
/// ```
/// use lagrangian::rigid_body::Resultant;
/// use lagrangian::nalgebra::Vector3;
///
/// // A couple: equal and opposite forces, 0.2 apart.
/// let [push, pull] = [Vector3::new(5.0, 0.0, 0.0), Vector3::new(-5.0, 0.0, 0.0)];
/// let [above, below] = [Vector3::new(0.0, 0.1, 0.0), Vector3::new(0.0, -0.1, 0.0)];
/// let couple = Resultant::of_forces(Vector3::zeros(), [(push, above), (pull, below)]);
/// assert_eq!(couple.force, Vector3::zeros());
/// assert_eq!(couple.moment, Vector3::new(0.0, 0.0, -1.0));
/// // Its moment is equal about all points.
/// assert_eq!(couple.about(Vector3::new(3.0, -1.0, 2.0)).moment, couple.moment);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resultant<S: Scalar = f64> {
    /// The point about which the moment is taken.
    pub point: Vector3<S>,
    /// The resultant force `F_R` = Σ Fᵢ (1.2).
    pub force: Vector3<S>,
    /// The resultant moment about the point, Σ (rᵢ − r) × Fᵢ + Σ Mᵢ (3.3).
    pub moment: Vector3<S>,
}

impl<S: Scalar> Resultant<S> {
    /// Returns the resultant without a force or a moment.
    #[must_use]
    pub fn none(point: Vector3<S>) -> Self {
        let zero = Vector3::zeros();
        Self {
            point,
            force: zero,
            moment: zero,
        }
    }

    /// Returns the resultant of a force that acts at a point.
    #[must_use]
    pub fn of_force(point: Vector3<S>, force: Vector3<S>, acts_at: &Vector3<S>) -> Self {
        let moment = (acts_at - point).cross(&force);
        Self {
            point,
            force,
            moment,
        }
    }

    /// Returns the resultant about a point of forces, each with the point at which it acts. Forces that particles of
    /// the body exert on each other cancel.
    pub fn of_forces(
        point: Vector3<S>,
        forces: impl IntoIterator<Item = (Vector3<S>, Vector3<S>)>,
    ) -> Self {
        let forces = forces.into_iter();
        forces.fold(Self::none(point), |sum, (force, acts_at)| {
            sum + Self::of_force(point, force, &acts_at)
        })
    }

    /// Adds a moment, such as the moment of a motor.
    #[must_use]
    pub fn with_moment(mut self, moment: Vector3<S>) -> Self {
        self.moment += moment;
        self
    }

    /// Returns this resultant with the moment about another point.
    #[must_use]
    pub fn about(&self, point: Vector3<S>) -> Self {
        Self {
            point,
            force: self.force,
            moment: self.moment + (self.point - point).cross(&self.force),
        }
    }
}

impl<S: Scalar> Add for Resultant<S> {
    type Output = Self;

    /// Adds two resultants, about the point of the first.
    fn add(self, other: Self) -> Self {
        let other = other.about(self.point);
        Self {
            point: self.point,
            force: self.force + other.force,
            moment: self.moment + other.moment,
        }
    }
}
