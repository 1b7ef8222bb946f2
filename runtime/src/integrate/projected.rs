//! The ends of steps, projected onto the manifold on which the equations hold.
//!
//! E. Hairer, C. Lubich & G. Wanner, *Geometric Numerical Integration*, 2nd edition (2006), IV.4 (the standard
//! projection method): a step is taken and accepted without regard to the manifold, and its end is then projected. The
//! method keeps its order, since the projection moves the end by no more than the error of the step.

use super::compensated::Compensated;
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::projection::Projection;
use super::stepper::{Statistics, checked_state};
use crate::limits::passing::NEARLY_SINGULAR;
use crate::limits::projection::{CHANGES, MAX_CORRECTION, MOVED_EPSILONS};
use crate::linalg::lane_select::{is_zero, one_if_zero};
use crate::linalg::{ErrorTolerance, VectorSpace};
use crate::scalar::Scalar;

/// Components are moved alternately up and down, and all in one direction.
const ALTERNATIONS: [f64; 2] = [1.0, -1.0];

/// Returns a state whose components are moved.
fn moved<S: Scalar, X: VectorSpace<S>>(state: &X, by: &X, alternation: f64) -> X {
    let mut sign = 1.0;
    state.zip_map(by, |x, by| {
        sign *= alternation;
        x + by * S::from_f64(sign)
    })
}

/// The end of a step that is projected, or the initial state of a motion.
pub(crate) struct Projected<'a, S: Scalar, D: Dynamics<S> + ?Sized> {
    pub(crate) dynamics: &'a D,
    /// The time in each lane.
    pub(crate) t: S,
    /// The state from which the step was taken.
    pub(crate) before: &'a D::State,
    /// The length of the step in each lane; 0 at the start of a motion.
    pub(crate) length: S,
    /// The lane of a motion with its own steps; `None` for all lanes together.
    pub(crate) lane: Option<usize>,
}

/// Returns the part of the sizes of components that rounding errors explain.
fn rounding_part<S: Scalar>() -> S {
    S::from_f64(CHANGES * MOVED_EPSILONS * S::machine_epsilon())
}

/// Returns the corrections that rounding errors explain, where a projection knows them.
fn rounding<S: Scalar, X: VectorSpace<S>>(projection: &Projection<S, X>) -> Option<X> {
    let sizes = projection.sizes.as_ref();
    sizes.map(|sizes| sizes.map(|size| size * rounding_part()))
}

/// Adds to allowed errors the rounding errors that constraints carry from components of these sizes to others. Without
/// them, no step would be short enough for a component that the constraints keep at zero.
#[inline]
pub(crate) fn allow_rounding<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    (t, x): (S, &D::State),
    sizes: &D::State,
    allowed: &mut D::State,
) {
    if let Some(sizes) = dynamics.rounding_sizes(t, x, sizes) {
        allowed.add_scaled(rounding_part(), &sizes);
    }
}

/// Raises the allowed errors of a step to a rounding error of the sizes that the components of a state have together, so that
/// a component which constraints keep at zero does not limit the step.
pub(crate) fn allow_least<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    (t, x): (S, &D::State),
    sizes: &D::State,
    allowed: &mut D::State,
) {
    if let Some(sizes) = dynamics.rounding_sizes(t, x, sizes) {
        let epsilon = S::from_f64(S::machine_epsilon());
        *allowed = allowed.zip_map(&sizes, |allowed, size| allowed.max(size * epsilon));
    }
}

/// Returns the end of a step on the manifold, and the correction. The correction is added to the compensated sum, so
/// that its rounding errors do not accumulate.
pub(crate) fn corrected<S: Scalar, X: VectorSpace<S>>(
    state: &Compensated<X>,
    projection: &Projection<S, X>,
) -> (Compensated<X>, X) {
    let mut correction = projection.state.clone();
    correction.add_scaled(-S::one(), state.value());
    (state.plus(correction.clone()), correction)
}

/// Returns the reduced state at which the derivative of a polynomial is compared with the equations of motion: on the manifold
/// if a projection onto it is given, since near a singular configuration of constraints accelerations change fast beside it.
#[inline]
pub(crate) fn reduced_on_manifold<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    state: &Compensated<D::State>,
    projection: Option<&Projection<S, D::State>>,
) -> D::State {
    match projection {
        None => state.reduced(dynamics),
        Some(projection) => corrected(state, projection).0.reduced(dynamics),
    }
}

impl<'a, S: Scalar, D: Dynamics<S> + ?Sized> Projected<'a, S, D> {
    /// A state that no step led to.
    fn at(dynamics: &'a D, t: S, x: &'a D::State) -> Self {
        Self {
            dynamics,
            t,
            before: x,
            length: S::zero(),
            lane: None,
        }
    }

    /// Returns the end of a step, projected onto the manifold of the dynamics if they have one. The allowed error is a
    /// function of the end before and after its projection.
    ///
    /// # Errors
    ///
    /// As of [`check`](Self::check).
    #[inline]
    pub(crate) fn end(
        &self,
        state: Compensated<D::State>,
        allowed: impl FnOnce(&D::State, &D::State) -> D::State,
        is_limited: bool,
        statistics: &mut Statistics,
    ) -> Result<Compensated<D::State>, IntegrationError> {
        let Some(projection) = self.dynamics.project(self.t, state.value()) else {
            return Ok(state);
        };
        let (end, correction) = corrected(&state, &projection);
        let allowed = allowed(state.value(), end.value());
        let found = (&projection, end.value());
        let distance = self.check(found, &correction, &allowed, is_limited)?;
        statistics.note_projection(distance, projection.pivoted.largest());
        Ok(end)
    }

    /// Returns the largest component of the correction over its allowed error; at most the limit where rounding explains
    /// more. Components without an allowed error do not count.
    ///
    /// # Errors
    ///
    /// If the projection has failed, is not finite, or has moved the state by more than the tolerance and rounding
    /// explain; fixed steps have no tolerance.
    pub(crate) fn check(
        &self,
        (projection, end): (&Projection<S, D::State>, &D::State),
        correction: &D::State,
        allowed: &D::State,
        is_limited: bool,
    ) -> Result<f64, IntegrationError> {
        let checked = self.distance((projection, end), correction, allowed, is_limited);
        checked.map_err(|error| self.cause(end, error))
    }

    /// Returns the error, or the singular configuration near which the step ends or begins, since that is its cause then.
    #[cold]
    fn cause(&self, end: &D::State, error: IntegrationError) -> IntegrationError {
        // The start of a motion is reported by the constraint that it violates.
        if self.largest(self.length) <= 0.0 {
            return error;
        }
        for x in [end, self.before] {
            let sine = self.dynamics.constraint_sine(self.t, x);
            if sine.is_some_and(|sine| self.largest(sine) < NEARLY_SINGULAR)
                && let Some(found) = self.dynamics.singularity(self.t, x, NEARLY_SINGULAR)
            {
                return IntegrationError::singular::<S>(self.time(), found);
            }
        }
        error
    }

    /// [`check`](Self::check), with the error that is found first.
    fn distance(
        &self,
        (projection, end): (&Projection<S, D::State>, &D::State),
        correction: &D::State,
        allowed: &D::State,
        is_limited: bool,
    ) -> Result<f64, IntegrationError> {
        if self.largest(projection.failed) > 0.0 {
            return Err(self.failure(projection));
        }
        self.check_finite(end)?;
        let rounding = rounding(projection);
        let unexplained = rounding.map(|rounding| {
            correction.zip_map(&rounding, |x, rounding| (x.abs() - rounding).max(S::zero()))
        });
        let beyond = unexplained.as_ref().unwrap_or(correction);
        let ratios = beyond.zip_map(allowed, |x, allowed| {
            let counts = S::one() - is_zero(allowed);
            (x.abs() / one_if_zero(allowed)).masked(counts)
        });
        let ratio = self.largest(ratios.fold(S::zero(), Scalar::max));
        if is_limited && ratio > MAX_CORRECTION {
            self.check_distance(end, beyond, allowed)?;
            return Ok(MAX_CORRECTION);
        }
        Ok(ratio)
    }

    fn check_finite(&self, end: &D::State) -> Result<(), IntegrationError> {
        let Some(lane) = self.lane else {
            return checked_state(self.dynamics, self.time(), end);
        };
        let components = end.components().map(|component| component.in_lane(lane));
        let mut components = components.enumerate();
        match components.find(|(_, component)| !component.is_finite()) {
            None => Ok(()),
            Some((index, value)) => Err(IntegrationError::NonFiniteState {
                time: self.time(),
                component: self.dynamics.component_name(index),
                value,
            }),
        }
    }

    #[cold]
    fn failure(&self, projection: &Projection<S, D::State>) -> IntegrationError {
        let (mut constraint, index) = (0, self.largest(projection.constraint));
        while f64::from(constraint) < index {
            constraint += 1;
        }
        let constraint = usize::try_from(constraint).unwrap_or(usize::MAX);
        IntegrationError::ProjectionFailed {
            time: self.time(),
            constraint: self.dynamics.constraint_name(constraint),
            residual: self.largest(projection.residual),
        }
    }

    /// Returns an error unless the tolerance and rounding explain the correction. The effect of rounding is found by
    /// moving the components of a state on the manifold by some rounding errors, of themselves and of their change in
    /// the step, and projecting it again; and by integrating the changes of their derivatives twice over the step, for
    /// velocities and for coordinates.
    #[cold]
    fn check_distance(
        &self,
        end: &D::State,
        correction: &D::State,
        allowed: &D::State,
    ) -> Result<(), IntegrationError> {
        let mut limit = allowed.map(|allowed| allowed * S::from_f64(MAX_CORRECTION));
        let part = S::from_f64(MOVED_EPSILONS * S::machine_epsilon());
        let by = end.zip_map(self.before, |x, before| {
            (x.abs() + (x - before).abs()) * part
        });
        for alternation in ALTERNATIONS {
            let moved = moved(end, &by, alternation);
            if let Some(projection) = self.dynamics.project(self.t, &moved) {
                let mut change = projection.state;
                change.add_scaled(-S::one(), &moved);
                limit.add_scaled(S::from_f64(CHANGES), &change.map(Scalar::abs));
            }
        }
        if self.largest(self.length) > 0.0 {
            let once = self.change_within(end, &by);
            let twice = self.change_within(end, &once);
            limit.add_scaled(S::from_f64(CHANGES), &once);
            limit.add_scaled(S::from_f64(CHANGES), &twice);
        }
        let pairs = correction.components().zip(limit.components());
        let mut pairs = pairs.zip(allowed.components()).enumerate();
        let found = pairs.find(|(_, ((correction, limit), allowed))| {
            let excess = self.largest(correction.abs() - *limit);
            self.largest(*allowed) > 0.0 && (excess > 0.0 || excess.is_nan())
        });
        let Some((index, ((correction, limit), _))) = found else {
            return Ok(());
        };
        Err(IntegrationError::OffManifold {
            time: self.time(),
            component: self.dynamics.component_name(index),
            correction: self.largest(correction.abs()),
            limit: self.largest(limit),
        })
    }

    /// Returns how much a motion changes over the step if its components are moved.
    fn change_within(&self, end: &D::State, by: &D::State) -> D::State {
        let derivative = self.dynamics.derivative(self.t, end);
        let mut changes = by.map(|_| S::zero());
        for alternation in ALTERNATIONS {
            let moved = moved(end, by, alternation);
            let mut slope = self.dynamics.derivative(self.t, &moved);
            slope.add_scaled(-S::one(), &derivative);
            changes.add_scaled(self.length, &slope.map(Scalar::abs));
        }
        let shared = self.dynamics.rounding_sizes(self.t, end, &changes);
        shared.unwrap_or(changes)
    }

    /// Returns the error for a start, which names the constraint that is violated where the dynamics know it.
    #[cold]
    pub(crate) fn named(&self, x: &D::State, error: IntegrationError) -> IntegrationError {
        let is_off = matches!(
            error,
            IntegrationError::OffManifold { .. } | IntegrationError::ProjectionFailed { .. }
        );
        let violated = self.dynamics.violated_constraint(self.t, x);
        match violated.filter(|_| is_off) {
            Some((constraint, residual)) => IntegrationError::Inconsistent {
                time: self.time(),
                constraint: self.dynamics.constraint_name(constraint),
                residual: self.largest(residual),
            },
            None => error,
        }
    }

    /// Returns the relevant number in a scalar: the value in the lane, or the largest in all lanes.
    fn largest(&self, x: S) -> f64 {
        self.lane
            .map_or_else(|| x.largest(), |lane| x.in_lane(lane))
    }

    fn time(&self) -> f64 {
        self.largest(self.t)
    }
}

/// Returns an error unless an initial state is on the manifold, within the tolerance and rounding. The state is not
/// changed.
#[inline]
pub(crate) fn check_start<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    t: f64,
    x: &D::State,
    tolerance: &ErrorTolerance<S>,
) -> Result<(), IntegrationError> {
    let t = S::from_f64(t);
    let Some(projection) = dynamics.project(t, x) else {
        return Ok(());
    };
    let start = Projected::at(dynamics, t, x);
    let (end, correction) = corrected(&Compensated::new(x.clone()), &projection);
    let allowed = dynamics.allowed_error(x, tolerance);
    let found = (&projection, end.value());
    let checked = start.check(found, &correction, &allowed, true);
    checked.map_or_else(|error| Err(start.named(x, error)), |_| Ok(()))
}

/// Returns the state on the manifold nearest to a state within a step; `None` if there is no manifold.
///
/// # Errors
///
/// If the projection fails.
#[inline]
pub(crate) fn nearest<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    time: f64,
    x: &D::State,
) -> Result<Option<D::State>, IntegrationError> {
    let t = S::from_f64(time);
    let Some(projection) = dynamics.project(t, x) else {
        return Ok(None);
    };
    let here = Projected::at(dynamics, t, x);
    if projection.has_failed() {
        return Err(here.failure(&projection));
    }
    here.check_finite(projection.state())?;
    Ok(Some(projection.into_state()))
}
