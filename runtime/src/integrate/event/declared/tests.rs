//! Tests of the steps that are passed over.

use nalgebra::SVector;

use super::{DeclaredEvents, Detection, Event, EventDynamics};
use crate::integrate::dynamics::Dynamics;
use crate::integrate::event::OneSignedInLanes;

/// The function of event 0 is x, and the function of event 1 is |x − 2| − 1, with a corner at the zero of function 2.
struct Line;

impl Dynamics<f64> for Line {
    type State = SVector<f64, 1>;

    fn derivative(&self, _: f64, _: &Self::State) -> Self::State {
        [1.0].into()
    }
}

impl EventDynamics<f64> for Line {
    type Model = Self;
    type Values = [f64; 3];

    fn names(&self) -> &'static [&'static str] {
        &["line", "bent"]
    }

    fn branches(&self, event: usize) -> &'static [usize] {
        if event == 1 { &[2] } else { &[] }
    }

    fn event_functions(&self, _: f64, x: &Self::State) -> [f64; 3] {
        [x[0], (x[0] - 2.0).abs() - 1.0, x[0] - 2.0]
    }
}

/// Whether both events pass over a step from x = 0.5, given the signs in it; 0 for a function that may have a zero, NaN for one
/// that was not examined. Also returns the end of the search, and whether the first terms are known not to exclude events.
fn passes(signs: [f64; 3]) -> (bool, f64, bool) {
    let mut events = DeclaredEvents {
        events: [(0, Event::either()), (1, Event::either())],
        parts: None,
    };
    let mut memory = events.begin(&Line, 0.0, &[0.5].into());
    let mut one_signed = OneSignedInLanes::<1>::UNKNOWN;
    for (index, sign) in signs
        .into_iter()
        .enumerate()
        .filter(|(_, sign)| !sign.is_nan())
    {
        one_signed.insert(index, &[sign]);
    }
    let passes = events.passes_over(&mut memory, &Line, [0.0, 0.25], one_signed.of_lane(0));
    (passes, memory.until, !memory.not_excluded.is_nan())
}

#[test]
fn a_step_is_passed_over_if_all_functions_keep_their_signs() {
    assert_eq!(passes([1.0, 1.0, -1.0]), (true, 0.25, false));
    // The second function may have a zero, its corner may be in the step, or a sign has changed at the beginning.
    assert_eq!(passes([1.0, 0.0, -1.0]), (false, 0.0, true));
    assert_eq!(passes([1.0, 1.0, 0.0]), (false, 0.0, false));
    assert_eq!(passes([-1.0, 1.0, -1.0]), (false, 0.0, false));
    // Nothing is known of it.
    assert_eq!(passes([1.0, f64::NAN, -1.0]), (false, 0.0, false));
}
