//! The signs of event functions on both sides of a state, apart from it.

use super::EventFunctions;
use super::values::Values;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::stepper::derivative_apart;
use crate::limits::events::SIDES;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// What event functions are on both sides of a state, along the straight line that touches the motion there.
pub(super) struct Sides<V> {
    /// Their signs before it and behind it, in the course of the integration, as near to it as rounding tells them; 0 where it does not.
    signs: [V; 2],
    /// How far from it that is.
    reach: V,
    /// By how much they grow from before it to behind it, next to it.
    change: V,
}

impl<V: Values> Sides<V> {
    /// The sides of a state, at parts of a step from it; `noise` is what rounding makes of the functions.
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

    /// The sign before the state, if rounding tells it, and how far from it.
    pub(super) fn before(&self, event: usize) -> Option<(f64, f64)> {
        let [before, _] = self.signs_of(event);
        let reach = self.reach.as_slice().get(event).copied();
        reach.filter(|_| before != 0.0).map(|reach| (before, reach))
    }

    /// The sign before the state of a function that changes it there.
    pub(super) fn before_crossing(&self, event: usize) -> Option<f64> {
        let [before, behind] = self.signs_of(event);
        (before * behind < 0.0).then_some(before)
    }

    /// Whether a function that has this value at the state moves away from zero.
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
