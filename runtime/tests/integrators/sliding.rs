//! Motions that cannot leave a discontinuity surface: dry friction that reverses until it holds, and passages that accumulate.

use core::f64::consts::PI;

use crate::common::in_lanes;
use lagrangian::prelude::*;

/// A spring and dry friction that is too weak to hold the mass at its turning points: half periods of cosines about ±μ/k.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.5 * x.powi(2),
    force(x = -mu * signum(dot(x))),
)]
struct Friction {
    mu: f64,
}

#[test]
fn friction_reverses_until_it_holds() {
    // The amplitude loses 2μ each half period.
    let (mu, amplitude) = (0.1, 10.05);
    let model = Friction { mu };
    let start = State::new(0.0, [amplitude], [0.0]);
    let solve = |end| Problem::new(&model, start).solve(end, Taylor::new());
    for half in [1_u32, 7, 30] {
        let end = PI * f64::from(half) + 1.0;
        let found = solve(end).unwrap();
        let sign = if half % 2 == 0 { 1.0 } else { -1.0 };
        let left = amplitude - 2.0 * mu * f64::from(half);
        let expected = sign * (mu + (left - mu) * 1.0_f64.cos());
        assert!(
            (found.q[0] - expected).abs() < 1e-12,
            "{half}: {:e}",
            found.q[0] - expected
        );
    }
    // After 50 half periods it is at 0.05, where friction holds it.
    let error = solve(200.0).unwrap_err().error();
    let IntegrationError::SlidingMode { time, function } = error else {
        panic!("{error}");
    };
    assert!((time - 50.0 * PI).abs() < 1e-10, "{time}");
    assert_eq!(function, "x\u{307}");
    let message = error.to_string();
    assert!(
        message.contains("sliding mode") && message.contains("tanh"),
        "{message}"
    );
}

/// The motion up to where it stays is known, and an event there stops it before the error.
#[test]
fn sticking_is_an_error_with_the_motion_before_it() {
    let model = Friction { mu: 1.0 };
    let start = State::new(0.0, [2.5], [0.0]);
    let times = [1.0, 2.0, 3.0, 4.0];
    let partial = Problem::new(&model, start)
        .save(times)
        .solve(4.0, Taylor::new())
        .unwrap_err();
    assert!(matches!(
        partial.error(),
        IntegrationError::SlidingMode { .. }
    ));
    assert_eq!(partial.solution().samples().len(), 3);
    let last = partial.solution().last;
    assert!(
        (last.t - PI).abs() < 1e-13 && (last.q[0] + 0.5).abs() < 1e-13,
        "{last:?}"
    );
    let stopped = Problem::new(&model, State::new(0.1, [2.0], [-1.0]))
        .when(|x| x.v[0])
        .rising()
        .stop()
        .solve(10.0, Taylor::new())
        .unwrap();
    assert_eq!(stopped.reason, StopReason::Condition);
    // At rest from the start, with and without a force that friction holds.
    let from_rest =
        |x: f64| Problem::new(&model, State::new(0.0, [x], [0.0])).solve(1.0, Taylor::new());
    let error = from_rest(0.5).unwrap_err().error();
    assert!(
        matches!(error, IntegrationError::SlidingMode { .. }),
        "{error}"
    );
    let rest = from_rest(0.0).unwrap();
    assert_eq!(rest.q[0].to_bits(), 0.0_f64.to_bits());
    let end = from_rest(3.0).unwrap();
    assert!((end.q[0] - (1.0 + 2.0 * 1.0_f64.cos())).abs() < 1e-14);
}

/// Lanes whose motions stick, each at its time.
#[test]
fn sticking_lanes() {
    let held = (0..5).map(|i| (State::new(0.0, [0.4 + 0.4 * f64::from(i)], [0.0]), 20.0));
    let friction = Friction { mu: 0.7 };
    let ends = in_lanes::<4, _, _>(Taylor::new(), &friction.dynamics(), held.clone());
    for (end, (start, t)) in ends.into_iter().zip(held) {
        let alone = Problem::new(&friction, start).solve(t, Taylor::new());
        let alone = alone.map(|end| end.last).map_err(|partial| partial.error());
        assert_eq!(end.map(|end| end.last), alone);
    }
}

/// Passages that follow each other in ever shorter times (the twisting algorithm, A. Levant 1993) end as sliding modes do.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = -2.0 * signum(x) - 0.5 * signum(dot(x))))]
struct Twisting;

#[test]
fn passages_that_accumulate_are_an_error() {
    let start = State::new(0.0, [1.0], [0.0]);
    let error = Problem::new(&Twisting, start)
        .solve(100.0, Taylor::new())
        .unwrap_err()
        .error();
    let IntegrationError::SlidingMode { time, .. } = error else {
        panic!("{error}");
    };
    // From rest at 1 with 2 − ½ to 0, then with 2 + ½ to rest at −0.6: times shrink by √0.6.
    let first = (2.0 / 1.5_f64).sqrt() + (2.0 * 0.6 / 2.5_f64).sqrt();
    let expected = first / (1.0 - 0.6_f64.sqrt());
    assert!((time - expected).abs() < 1e-9, "{time} {expected}");
}
