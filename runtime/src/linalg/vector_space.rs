//! The vector space of states.
//!
//! An explicit method adds multiples of derivatives to a state, and compares the components with a tolerance. It needs
//! nothing else. One implementation therefore integrates coordinates and velocities, Euler's equations with a
//! quaternion, or a plain vector.

use nalgebra::SVector;

use super::error_tolerance::ErrorTolerance;
use crate::scalar::Scalar;

/// A state that can be integrated: an element of a vector space over the scalars `S`.
///
/// ```
/// use lagrangian::VectorSpace;
/// use lagrangian::nalgebra::SVector;
///
/// let mut x = SVector::from([1.0, 2.0]);
/// x.add_scaled(0.5, &SVector::from([4.0, -4.0]));
/// assert_eq!(x, SVector::from([3.0, 0.0]));
/// ```
pub trait VectorSpace<S: Scalar>: Clone {
    /// Adds `factor · other` to this state (axpy).
    fn add_scaled(&mut self, factor: S, other: &Self);

    /// Returns the state whose components are `function` of the components of this state; `function` is called in their
    /// order.
    #[must_use]
    fn map(&self, function: impl FnMut(S) -> S) -> Self;

    /// Returns the state whose components are `function` of the components of this state and of another one.
    #[inline]
    #[must_use]
    fn zip_map(&self, other: &Self, mut function: impl FnMut(S, S) -> S) -> Self {
        let mut others = other.components();
        self.map(|component| function(component, others.next().unwrap_or(S::zero())))
    }

    /// Returns the components, in a fixed order.
    fn components(&self) -> impl Iterator<Item = S> + '_;

    /// Adds multiples of this state to sums; each term is the index of a sum and a factor.
    #[inline]
    fn add_multiples(&self, terms: &[(usize, f64)], sums: &mut [Self]) {
        for (index, factor) in terms {
            if let Some(sum) = sums.get_mut(*index) {
                sum.add_scaled(S::from_f64(*factor), self);
            }
        }
    }

    /// Folds the components into a value by `function`, starting from `start`.
    #[inline]
    fn fold<T>(&self, start: T, function: impl FnMut(T, S) -> T) -> T {
        self.components().fold(start, function)
    }

    /// Returns the allowed error of a step in each component: absolute + relative · |xᵢ| by default. A state with
    /// velocities allows absolute · rate + relative · |q̇ᵢ| for them.
    #[inline]
    #[must_use]
    fn allowed_error(&self, tolerance: &ErrorTolerance<S>) -> Self {
        self.map(|component| tolerance.of_coordinate(component.abs()))
    }

    /// Returns, for a derivative, the inverse of the time in which coordinates change by `sizes`: the largest of
    /// |q̇ᵢ|/sᵢ and √(|q̈ᵢ|/sᵢ).
    ///
    /// Returns `None` for a state without velocities, for which the unit of time counts as its natural scale.
    #[inline]
    #[must_use]
    fn rate(&self, sizes: &Self) -> Option<S> {
        let _ = sizes;
        None
    }

    /// Returns the origin of the space.
    #[inline]
    #[must_use]
    fn zeroed(&self) -> Self {
        self.map(|_| S::zero())
    }

    /// Returns the index and the value of the first component that is not finite.
    #[inline]
    #[must_use]
    fn first_non_finite(&self) -> Option<(usize, S)> {
        // In most cases there is none, which a sum without branches shows.
        let zero = self.fold(S::zero(), |sum, component| {
            component.mul_add(S::zero(), sum)
        });
        if zero.is_finite() {
            return None;
        }
        self.components()
            .enumerate()
            .find(|(_, component)| !component.is_finite())
    }
}

/// The operations of a vector space on a struct whose fields are vectors.
macro_rules! operations_by_fields {
    ($($field:ident),*) => {
        #[inline]
        fn add_scaled(&mut self, factor: S, other: &Self) {
            $(self.$field.add_scaled(factor, &other.$field);)*
        }

        #[inline]
        fn map(&self, mut function: impl FnMut(S) -> S) -> Self {
            Self { $($field: self.$field.map(&mut function)),* }
        }

        #[inline]
        fn zip_map(&self, other: &Self, mut function: impl FnMut(S, S) -> S) -> Self {
            Self {
                $($field: VectorSpace::zip_map(&self.$field, &other.$field, &mut function)),*
            }
        }
    };
}
pub(crate) use operations_by_fields;

impl<S: Scalar, const D: usize> VectorSpace<S> for SVector<S, D> {
    #[inline]
    fn add_scaled(&mut self, factor: S, other: &Self) {
        for (component, summand) in self.iter_mut().zip(other.iter()) {
            *component = summand.mul_add(factor, *component);
        }
    }

    #[inline]
    fn map(&self, function: impl FnMut(S) -> S) -> Self {
        nalgebra::Matrix::map(self, function)
    }

    #[inline]
    fn zip_map(&self, other: &Self, function: impl FnMut(S, S) -> S) -> Self {
        nalgebra::Matrix::zip_map(self, other, function)
    }

    #[inline]
    fn components(&self) -> impl Iterator<Item = S> + '_ {
        self.as_slice().iter().copied()
    }
}

/// The vector space of dimension 0.
impl<S: Scalar> VectorSpace<S> for () {
    #[inline]
    fn add_scaled(&mut self, _: S, (): &Self) {}

    #[inline]
    fn map(&self, _: impl FnMut(S) -> S) -> Self {}

    #[inline]
    fn components(&self) -> impl Iterator<Item = S> + '_ {
        core::iter::empty()
    }
}

/// The product of two spaces.
impl<S: Scalar, A: VectorSpace<S>, B: VectorSpace<S>> VectorSpace<S> for (A, B) {
    #[inline]
    fn add_scaled(&mut self, factor: S, other: &Self) {
        self.0.add_scaled(factor, &other.0);
        self.1.add_scaled(factor, &other.1);
    }

    #[inline]
    fn map(&self, mut function: impl FnMut(S) -> S) -> Self {
        (self.0.map(&mut function), self.1.map(&mut function))
    }

    #[inline]
    fn components(&self) -> impl Iterator<Item = S> + '_ {
        self.0.components().chain(self.1.components())
    }

    #[inline]
    fn allowed_error(&self, tolerance: &ErrorTolerance<S>) -> Self {
        (
            self.0.allowed_error(tolerance),
            self.1.allowed_error(tolerance),
        )
    }
}
