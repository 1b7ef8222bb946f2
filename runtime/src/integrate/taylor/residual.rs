//! The residual of a Taylor polynomial in the differential equations.

use crate::integrate::dynamics::Dynamics;
use crate::integrate::projected::allow_rounding;
use crate::limits::taylor::{CHANGES, CROSSING_ROUNDING, MOVED_EPSILONS, RESIDUAL_PER_ORDER};
use crate::linalg::{ErrorTolerance, VectorSpace};
use crate::scalar::{Lanes, Scalar};

/// A time within a step, with the reduced state of the polynomial and its derivative there.
pub(super) struct Point<S, X> {
    pub(super) t: S,
    pub(super) state: X,
    pub(super) slope: X,
}

/// The limits of the residual in a step.
pub(super) struct Allowance<S> {
    /// The length of the step.
    pub(super) h: S,
    /// The order of the polynomial.
    pub(super) order: f64,
    pub(super) tolerance: ErrorTolerance<S>,
    /// The number of rounding errors of the state and of its change that are allowed.
    pub(super) roundings: S,
}

impl<const L: usize> Allowance<Lanes<L>> {
    /// Returns the limits of a lane, in every lane.
    pub(super) fn of_lane(&self, lane: usize) -> Self {
        let every = |of: Lanes<L>| Lanes([of.lane(lane); L]);
        Self {
            h: every(self.h),
            order: self.order,
            tolerance: ErrorTolerance {
                rate: every(self.tolerance.rate),
                ..self.tolerance
            },
            roundings: every(self.roundings),
        }
    }
}

impl<S: Scalar> Allowance<S> {
    /// Returns the limits after a sign change of a switching function. They are tighter: an unnecessary end of a step
    /// costs little there, but a jump that is missed adds an error at each crossing.
    pub(super) fn behind_crossings(self) -> Self {
        Self {
            roundings: S::from_f64(CROSSING_ROUNDING),
            ..self
        }
    }

    /// Returns as error a component in which the derivative of the motion differs from the derivative of the
    /// polynomial. The motion is then not the one that the series at the beginning of the step describes.
    #[inline]
    pub(super) fn check<D: Dynamics<S> + ?Sized>(
        &self,
        dynamics: &D,
        point: &Point<S, D::State>,
        derivative: &D::State,
    ) -> Result<(), usize> {
        let [residual, mut allowed] = self.residual(dynamics, point, derivative);
        if first_beyond(&residual, &allowed).is_none() {
            return Ok(());
        }
        self.allow_condition(dynamics, point, derivative, &mut allowed);
        first_beyond(&residual, &allowed).map_or(Ok(()), Err)
    }

    /// Returns the differences between the derivatives of the polynomial and of the motion, multiplied by the step, and
    /// the differences that rounding and the tolerance explain.
    #[inline]
    pub(super) fn residual<D: Dynamics<S> + ?Sized>(
        &self,
        dynamics: &D,
        point: &Point<S, D::State>,
        derivative: &D::State,
    ) -> [D::State; 2] {
        let rounding = self.roundings * S::from_f64(S::machine_epsilon());
        let several = RESIDUAL_PER_ORDER * self.order;
        let tolerance = ErrorTolerance {
            relative: self.tolerance.relative * several + rounding.smallest(),
            absolute: self.tolerance.absolute * several,
            ..self.tolerance
        };
        let mut allowed = dynamics.allowed_error(&point.state, &tolerance);
        allowed.add_scaled(rounding, &point.state.map(Scalar::abs));
        allowed.add_scaled(rounding * self.h, &derivative.map(Scalar::abs));
        let residual = point.slope.zip_map(derivative, |polynomial, motion| {
            ((polynomial - motion) * self.h).abs()
        });
        [residual, allowed]
    }

    /// Adds the differences explained by the condition of the derivative, which are its changes when the time and the
    /// state are moved by some rounding errors.
    #[cold]
    pub(super) fn allow_condition<D: Dynamics<S> + ?Sized>(
        &self,
        dynamics: &D,
        point: &Point<S, D::State>,
        derivative: &D::State,
        allowed: &mut D::State,
    ) {
        let mut sizes = point.state.map(Scalar::abs);
        sizes.add_scaled(self.h, &derivative.map(Scalar::abs));
        allow_rounding(dynamics, (point.t, &point.state), &sizes, allowed);
        for alternation in [1.0, -1.0] {
            let (t, moved) = moved(point.t, &point.state, alternation);
            let mut change = dynamics.derivative(t, &moved);
            change.add_scaled(-S::one(), derivative);
            allowed.add_scaled(self.h * S::from_f64(CHANGES), &change.map(Scalar::abs));
        }
    }
}

/// Moves a time and a state by some rounding errors; components alternately up and down, or always up, depending on
/// `alternation`.
pub(super) fn moved<S: Scalar, X: VectorSpace<S>>(t: S, state: &X, alternation: f64) -> (S, X) {
    let epsilon = MOVED_EPSILONS * S::machine_epsilon();
    let mut sign = 1.0;
    let moved = state.map(|x| {
        sign *= alternation;
        x + x.abs() * S::from_f64(sign * epsilon)
    });
    (t + t * S::from_f64(epsilon), moved)
}

/// Returns the first component that exceeds its allowed value or is not finite.
fn first_beyond<S: Scalar, X: VectorSpace<S>>(residual: &X, allowed: &X) -> Option<usize> {
    let excess = residual.zip_map(allowed, |residual, allowed| {
        let over = residual - allowed;
        // Twice the excess, or 0, or NaN, which the sum preserves.
        over + over.abs()
    });
    let is_beyond = |excess: S| excess.largest() > 0.0 || excess.largest().is_nan();
    if !is_beyond(excess.fold(S::zero(), |sum, excess| sum + excess)) {
        return None;
    }
    excess.components().position(is_beyond)
}
