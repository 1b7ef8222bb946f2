//! The projection of a state onto the manifold on which the equations hold.

use crate::linalg::lane_select::from_index;
use crate::scalar::Scalar;

/// A state on the manifold on which the equations of a system hold, as found by [`Dynamics::project`](crate::Dynamics::project).
///
/// The projection succeeds in all lanes unless a constraint that is [`checked`](Self::checked) is violated in one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection<S, X> {
    pub(super) state: X,
    /// Numbers whose rounding errors the projection distributes over the components; where none are given, the components
    /// themselves.
    pub(super) sizes: Option<X>,
    /// 1 in lanes in which a constraint is violated, 0 in the others.
    pub(super) failed: S,
    /// The residual of the first constraint that is violated.
    pub(super) residual: S,
    /// The index of this constraint.
    pub(super) constraint: S,
    /// 1 in lanes in which the equations of motion are solved with pivoting, 0 in the others.
    pub(super) pivoted: S,
}

impl<S: Scalar, X> Projection<S, X> {
    /// Creates a projection that has succeeded.
    #[inline]
    #[must_use]
    pub fn new(state: X) -> Self {
        let [failed, residual, constraint, pivoted] = [S::zero(); 4];
        Self {
            state,
            sizes: None,
            failed,
            residual,
            constraint,
            pivoted,
        }
    }

    /// Fails in lanes in which the remaining residual of a constraint exceeds the allowed one, or is NaN. The first
    /// violated constraint is reported by its [name](crate::Dynamics::constraint_name).
    #[inline]
    #[must_use]
    pub fn checked(mut self, constraint: usize, residual: S, allowed: S) -> Self {
        let exceeds = (residual.abs() - allowed).signum();
        // The sign of NaN is NaN, which `max` ignores.
        let is_within = (-exceeds + S::ratio(1.0, 2.0)).max(S::zero()).signum();
        let fails = (S::one() - is_within) * (S::one() - self.failed);
        if fails.largest() > 0.0 {
            self.residual += residual.masked(fails);
            self.constraint += from_index::<S>(constraint).masked(fails);
            self.failed += fails;
        }
        self
    }

    /// Sets the sizes of the components to which their rounding errors are proportional, where constraints mix components of
    /// different sizes.
    #[inline]
    #[must_use]
    pub(crate) fn with_sizes(mut self, sizes: X) -> Self {
        self.sizes = Some(sizes);
        self
    }

    /// Sets the mask of the lanes in which the equations of motion are solved with pivoting.
    #[inline]
    #[must_use]
    pub(crate) fn with_pivoting(mut self, pivoted: S) -> Self {
        self.pivoted = pivoted;
        self
    }

    /// Returns the projection with another state in place of its own.
    #[inline]
    pub(crate) fn map<Y>(self, state: impl Fn(X) -> Y) -> Projection<S, Y> {
        let Self {
            state: before,
            sizes,
            failed,
            residual,
            constraint,
            pivoted,
        } = self;
        Projection {
            state: state(before),
            sizes: sizes.map(state),
            failed,
            residual,
            constraint,
            pivoted,
        }
    }

    /// Returns the state on the manifold.
    #[inline]
    pub fn state(&self) -> &X {
        &self.state
    }

    /// Converts the projection into the state on the manifold.
    #[inline]
    #[must_use]
    pub fn into_state(self) -> X {
        self.state
    }

    /// Whether a constraint is violated in any lane.
    #[inline]
    #[must_use]
    pub fn has_failed(&self) -> bool {
        self.failed.largest() > 0.0
    }
}
