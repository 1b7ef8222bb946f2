//! The root of an event's polynomial that is its next event.

use core::ops::ControlFlow;

use super::DeclaredEvents;
use crate::integrate::event::memory::Memory;
use crate::integrate::event::polynomial::{Polynomial, Root};
use crate::integrate::event::window::Window;
use crate::limits::events::MAX_COEFFICIENTS;

impl<const K: usize> DeclaredEvents<K> {
    /// Returns the first root of an event's polynomial at which the event occurs, and the first root of all.
    pub(super) fn first_of(
        &self,
        event: usize,
        polynomial: &Polynomial,
        memory: &Memory<[f64; K]>,
        (window, from, near): (Window<K>, f64, f64),
    ) -> [Option<Root>; 2] {
        let crossing = self.event(event).crossing();
        let deflated = from <= 0.0 && memory.at_zero.contains(event);
        let polynomial = if deflated {
            polynomial.over_argument()
        } else {
            *polynomial
        };
        let sign = if memory.resume[event] > from {
            memory.signs[event]
        } else if from > 0.0 {
            memory.ahead[event]
        } else {
            0.0
        };
        let mut next = if memory.left.contains(event) {
            // A function that is zero where a run begins has a sign as soon as it is distinguishable from zero.
            let left = polynomial.leaves(from.max(near), memory.hysteresis[event]);
            left.and_then(|(at, sign)| polynomial.next_root(at, sign))
        } else {
            polynomial.next_root(from.max(memory.resume[event]), sign)
        };
        if from <= 0.0 && !deflated && !memory.left.contains(event) {
            next = match self.at_last_end(event, &polynomial, memory, (from, near, next)) {
                ControlFlow::Continue(next) => next,
                ControlFlow::Break(root) => return [Some(root); 2],
            };
        }
        let first = next;
        for _ in 0..MAX_COEFFICIENTS {
            let Some(root) = next.map(|root| window.behind(event, root)) else {
                break;
            };
            let behind = if root.before * root.behind < 0.0 {
                root.behind
            } else {
                0.0
            };
            let is_one = window.is_known || behind != 0.0;
            if is_one && crossing.between(root.before, behind) {
                return [Some(root), first];
            }
            next = polynomial.next_root(root.until, root.behind);
        }
        [None, first]
    }

    /// Decides about an event at the beginning of a step. The last step may have ended, to rounding, just before a root
    /// that has now been passed, or at a zero, whether or not the sign changes there. Otherwise the result is the next
    /// root, but not the last one again.
    fn at_last_end(
        &self,
        event: usize,
        polynomial: &Polynomial,
        memory: &Memory<[f64; K]>,
        (from, near, next): (f64, f64, Option<Root>),
    ) -> ControlFlow<Root, Option<Root>> {
        let crossing = self.event(event).crossing();
        let before = memory.signs[event];
        let behind = polynomial.sign_behind(from, next);
        // If the function approaches zero, its zero is among the roots.
        let touches = memory.touching.contains(event)
            && before * behind > 0.0
            && before * polynomial.slope(from) >= 0.0
            && crossing.between(before, 0.0);
        let returns = next.filter(|root| {
            root.at <= near && root.behind * before > 0.0 && root.before * root.behind < 0.0
        });
        let crosses = crossing.between(before, behind) && behind != 0.0;
        match returns {
            Some(root) if !touches => {
                ControlFlow::Continue(polynomial.next_root(root.until, root.behind))
            }
            _ if touches || crosses => ControlFlow::Break(Root {
                at: 0.0,
                before,
                behind,
                until: 0.0,
            }),
            _ => ControlFlow::Continue(next),
        }
    }
}
