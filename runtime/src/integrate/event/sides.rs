//! The signs of event functions on both sides of a state, at a distance from it.

use super::EventFunctions;
use super::values::Values;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::stepper::derivative_apart;
use crate::limits::events::SIDES;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The event functions on both sides of a state, along the tangent of the motion there.
pub(super) struct Sides<V> {
    /// The signs before and after the state, in the direction of the integration, as close to it as rounding permits; 0
    /// if they are uncertain.
    signs: [V; 2],
    /// The distance from the state at which the signs were taken.
    reach: V,
    /// The change of the functions from just before the state to just after it.
    change: V,
}

impl<V: Values> Sides<V> {
    /// Evaluates the functions on both sides of a state, at parts of a step from it; `noise` is the effect of rounding
    /// on them.
    pub(super) fn of<S, D, G>(
        source: &mut G,
        dynamics: &D,
        (t, x): (f64, &D::State),
        step: f64,
        noise: &V,
    ) -> Self
    where
        S: Scalar,
        D: Dynamics<S> + ?Sized,
        G: EventFunctions<S, D, Values = V>,
    {
        let reduced = dynamics.reduced(x, &x.zeroed());
        let rate = derivative_apart(dynamics, S::from_f64(t), &reduced);
        let mut sides = Self {
            signs: [V::ZERO; 2],
            reach: V::ZERO,
            change: V::ZERO,
        };
        for (i, part) in SIDES.into_iter().enumerate() {
            let values = [-part, part].map(|part| {
                let distance = part * step;
                let mut there = x.clone();
                there.add_scaled(S::from_f64(distance), &rate);
                source.values(dynamics, t + distance, &there)
            });
            let [before, behind] = [&values[0], &values[1]].map(V::as_slice);
            for (event, noise) in noise.as_slice().iter().enumerate() {
                let (Some(before), Some(behind)) = (before.get(event), behind.get(event)) else {
                    continue;
                };
                if i == 0 {
                    set(&mut sides.change, event, behind - before);
                }
                let is_told = sides.signs_of(event).iter().all(|sign| *sign != 0.0);
                if !is_told && before.abs().min(behind.abs()) > 2.0 * noise {
                    let [first, second] = &mut sides.signs;
                    set(first, event, before.signum());
                    set(second, event, behind.signum());
                    set(&mut sides.reach, event, (part * step).abs());
                }
            }
        }
        sides
    }

    fn signs_of(&self, event: usize) -> [f64; 2] {
        let of = |signs: &V| signs.as_slice().get(event).copied().unwrap_or(0.0);
        [of(&self.signs[0]), of(&self.signs[1])]
    }

    /// Returns the sign before the state, if it is certain, and its distance from the state.
    pub(super) fn before(&self, event: usize) -> Option<(f64, f64)> {
        let [before, _] = self.signs_of(event);
        let reach = self.reach.as_slice().get(event).copied();
        reach.filter(|_| before != 0.0).map(|reach| (before, reach))
    }

    /// Returns the sign before the state of a function that changes sign there.
    pub(super) fn before_crossing(&self, event: usize) -> Option<f64> {
        let [before, behind] = self.signs_of(event);
        (before * behind < 0.0).then_some(before)
    }

    /// Whether a function with this value at the state moves away from zero.
    pub(super) fn departs(&self, event: usize, value: f64) -> bool {
        let change = self.change.as_slice().get(event).copied();
        change.is_some_and(|change| change * value > 0.0)
    }
}

fn set<V: Values>(values: &mut V, event: usize, value: f64) {
    if let Some(place) = values.as_mut_slice().get_mut(event) {
        *place = value;
    }
}
