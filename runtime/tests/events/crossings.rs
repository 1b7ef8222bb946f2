//! Location of zero crossings, and restarts from there.

use core::f64::consts::PI;

use crate::common::{Oscillator, assert_close, equation};
use crate::directions::{Direction, EVERY, directed};
use lagrangian::EquationsOfMotion;
use lagrangian::prelude::*;

/// A ball above the ground.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(height),
    kinetic = 0.5 * m * dot(height).powi(2),
    potential = m * g * height,
)]
struct Ball {
    m: f64,
    g: f64,
}

const BALL: Ball = Ball { m: 0.2, g: 9.81 };

/// The times of bounces at which the velocity is reversed and multiplied by `restitution`.
fn bounces<I>(method: I, direction: Direction, restitution: f64, count: usize) -> Vec<f64>
where
    I: Copy + for<'a> Integrator<f64, EquationsOfMotion<&'a Ball, f64, 1>>,
{
    let mut state = State::new(0.0, [10.0], [0.0]);
    let mut times = Vec::new();
    while times.len() < count {
        let ground = Problem::new(&BALL, state)
            .max_steps(100_000)
            .when(|x| x.q[0]);
        let ground = directed!(direction, ground).stop();
        let motion = ground.solve(1e3, method).unwrap();
        assert_eq!(motion.reason, StopReason::Condition, "after {times:?}");
        assert!(motion.met.contains(0) && !motion.met.contains(1));
        state = motion.last;
        assert!(state.v[0] < 0.0, "{state:?} after {} bounces", times.len());
        times.push(state.t);
        state.v[0] *= -restitution;
    }
    times
}

/// With v₀ = √(2 g h) the n-th flight lasts 2 v₀ eⁿ / g.
#[test]
fn a_ball_bounces_as_often_as_it_should() {
    for direction in [Direction::Falling, Direction::Either] {
        for restitution in [1.0, 0.9] {
            let adaptive = bounces(Dop853::new(), direction, restitution, 120);
            let fixed = bounces(RungeKutta::classical(0.05), direction, restitution, 120);
            let series = bounces(Taylor::new(), direction, restitution, 120);
            let first = (2.0 * 10.0 / BALL.g).sqrt();
            let (mut expected, mut flight) = (first, 2.0 * first);
            for i in 0..adaptive.len() {
                // Every bounce adds a rounding error of time and velocity.
                let tolerance = 1e-14 * expected * f64::from(u8::try_from(i + 2).unwrap());
                for times in [&adaptive, &fixed, &series] {
                    assert_close(times[i], expected, tolerance);
                }
                flight *= restitution;
                expected += flight;
            }
        }
    }
}

/// A height above a floor that is not at 0 is rounded to 0 for a while after a bounce.
#[test]
fn a_ball_bounces_on_a_floor_at_any_height() {
    let restitution = 0.5;
    for floor in [0.1, 1.0, 100.1, -1e4] {
        let mut state = State::new(0.0, [floor + 1.0], [0.0]);
        let mut flight = 2.0 * (2.0 / BALL.g).sqrt();
        let mut expected = 0.5 * flight;
        for bounce in 0..16 {
            let above = Problem::new(&BALL, state).when(|x| x.q[0] - floor);
            let motion = above.falling().stop().solve(1e3, Dop853::new()).unwrap();
            assert_eq!(motion.reason, StopReason::Condition, "{floor}, {bounce}");
            state = motion.last;
            // The floor is located to the rounding error of heights: an error in time of that over the velocity.
            let velocity = 0.5 * BALL.g * flight;
            let rounding = 8.0 * f64::EPSILON * (floor.abs() + 1.0) / velocity;
            let tolerance = 2.0 * rounding + 1e-13;
            assert_close(state.t, expected, tolerance);
            expected = state.t;
            state.v[0] *= -restitution;
            flight *= restitution;
            expected += flight;
        }
    }
}

/// The zeros of cos t in order, none of them twice.
#[test]
fn a_restart_without_change_detects_each_zero_once() {
    for (direction, first, period) in [
        (Direction::Either, 0.5 * PI, PI),
        (Direction::Falling, 0.5 * PI, 2.0 * PI),
        (Direction::Rising, 1.5 * PI, 2.0 * PI),
    ] {
        let mut sample = At::from((0.0, SVector::from([1.0, 0.0])));
        for i in 0..40 {
            let zero = directed!(direction, Problem::new(Oscillator, sample).when(|x| x[0]));
            sample = zero.stop().solve(1e3, Dop853::new()).unwrap().last;
            assert_close(sample.t, first + f64::from(i) * period, 1e-8);
        }
    }
}

/// sin t from t = 0, rising and falling, forward and backward in time.
#[test]
fn a_zero_at_the_initial_time_is_no_crossing() {
    for (velocity, end) in [(1.0, 20.0), (-1.0, 20.0), (1.0, -20.0), (-1.0, -20.0)] {
        for direction in EVERY {
            let start = At::from((0.0, SVector::from([0.0, velocity])));
            let zero = directed!(direction, Problem::new(Oscillator, start).when(|x| x[0]));
            let motion = zero.stop().solve(end, Dop853::new()).unwrap();
            // Positive first where velocity and direction of time have the same sign.
            let next = match (direction, velocity * end > 0.0) {
                (Direction::Rising, true) | (Direction::Falling, false) => 2.0 * PI,
                _ => PI,
            };
            assert_close(motion.t, next.copysign(end), 1e-8);
        }
    }
}

/// The zero of a function of time, with steps of ¼; `None` if it is not detected before t = 4.
fn zero(direction: Direction, begin: f64, function: fn(f64) -> f64) -> Option<f64> {
    let advancing = equation::<1, _>(|_, _| SVector::from([1.0]));
    let start = At::from((begin, SVector::from([begin])));
    let zero = directed!(
        direction,
        Problem::new(advancing, start).when(|x| function(x.t))
    );
    let motion = zero.stop().solve(4.0, RungeKutta::classical(0.25)).unwrap();
    (motion.reason == StopReason::Condition).then_some(motion.t)
}

#[test]
fn a_zero_next_to_nan_is_detected() {
    // NaN at the end of the step before the zero.
    let gap = |t: f64| {
        if (0.45..0.6).contains(&t) {
            f64::NAN
        } else {
            0.7 - t
        }
    };
    let found = zero(Direction::Falling, 0.0, gap).unwrap();
    assert_close(found, 0.7, 1e-15);
    // NaN at the zero: the sign differs from t = 0.8 on.
    let hidden = |t: f64| {
        if (0.45..0.8).contains(&t) {
            f64::NAN
        } else {
            0.7 - t
        }
    };
    let found = zero(Direction::Either, 0.0, hidden).unwrap();
    assert_close(found, 0.8, 1e-15);
    // NaN from the start on.
    let late = |t: f64| if t < 0.9 { f64::NAN } else { t - 1.2 };
    let found = zero(Direction::Rising, 0.0, late).unwrap();
    assert_close(found, 1.2, 1e-15);
    // With the same sign on both sides of a gap there is no zero, nor is there one where all values are NaN.
    assert_eq!(
        zero(Direction::Either, 0.0, |t| (0.5 - t).abs().ln().sqrt()
            + 1.0),
        None
    );
    assert_eq!(zero(Direction::Either, 0.0, |_| f64::NAN), None);
}

#[test]
fn a_zero_without_change_of_sign_is_not_detected() {
    for direction in EVERY {
        assert_eq!(zero(direction, 0.0, |t| (t - 0.6) * (t - 0.6)), None);
        // From the zero itself.
        assert_eq!(zero(direction, 1.0, |t| (t - 1.0) * (t - 1.0)), None);
        assert_eq!(zero(direction, 1.0, |t| -(t - 1.0) * (t - 1.0)), None);
    }
    // A step that ends on it reaches zero.
    let touched = zero(Direction::Falling, 0.0, |t| (t - 0.5) * (t - 0.5));
    assert_close(touched.unwrap(), 0.5, 1e-8);
    assert_eq!(
        zero(Direction::Rising, 0.0, |t| (t - 0.5) * (t - 0.5)),
        None
    );
    // Two zeros within a step are detected with shorter steps.
    let start = At::from((-1.0, SVector::from([1.0_f64.cos(), 1.0_f64.sin()])));
    let close = Problem::new(Oscillator, start).when(|x| x[0] - 0.999);
    let method = Dop853::new().max_step(0.02);
    let motion = close.rising().stop().solve(1.0, method).unwrap();
    assert_close(motion.t, -0.999_f64.acos(), 1e-8);
}

#[test]
fn a_function_that_stays_at_zero_is_detected_once() {
    let rest = |t: f64| (1.1 - t).max(0.0);
    for direction in [Direction::Falling, Direction::Either] {
        let found = zero(direction, 0.0, rest).unwrap();
        assert_close(found, 1.1, 1e-15);
        assert_eq!(
            zero(direction, found, rest),
            None,
            "at rest nothing is crossed"
        );
    }
    assert_eq!(zero(Direction::Rising, 0.0, rest), None);
    // It leaves zero to either side after a while, and crosses it again.
    let lifted = |t: f64| {
        if t < 1.6 {
            0.0
        } else {
            (2.0 * (t - 1.6)).sin()
        }
    };
    let lowered = |t: f64| {
        if t < 1.6 {
            0.0
        } else {
            -(2.0 * (t - 1.6)).sin()
        }
    };
    let again = 1.6 + 0.5 * PI;
    for (function, opposite) in [
        (lifted as fn(f64) -> f64, Direction::Falling),
        (lowered, Direction::Rising),
    ] {
        for direction in [Direction::Either, opposite] {
            let found = zero(direction, 1.1, function).unwrap();
            assert_close(found, again, 1e-14);
        }
    }
    // A function that stays at zero between two signs is detected.
    let through = |t: f64| (0.9 - t).max(0.0) + (1.9 - t).min(0.0);
    let found = zero(Direction::Either, 0.0, through).unwrap();
    assert_close(found, 0.9, 1e-15);
    assert_eq!(zero(Direction::Rising, 0.0, through), None);
}

/// Between walls at 0 and 1, without forces: the walls are hit in turn.
#[test]
fn the_event_function_that_crosses_is_reported() {
    let free = equation::<2, _>(|_, x| SVector::from([x[1], 0.0]));
    let mut sample = At::from((0.0, SVector::from([0.25, 1.0])));
    for bounce in 0..50_u8 {
        let walls = Problem::new(&free, sample).when(|x| [x[0], 1.0 - x[0]]);
        let motion = walls.falling().stop().solve(1e3, Dop853::new()).unwrap();
        let met = [0, 1].map(|i| motion.met.contains(i));
        assert_eq!(met, [bounce % 2 == 1, bounce % 2 == 0]);
        sample = motion.last;
        assert_close(sample.t, 0.75 + f64::from(bounce), 1e-12);
        sample.x[1] = -sample.x[1];
    }
}

/// Two stones that reach the ground at one time, and two that do so one after the other.
#[test]
fn simultaneous_events_are_reported_together() {
    for (apart, together) in [(0.0, true), (1e-15, true), (1e-6, false)] {
        let free = equation::<2, _>(|_, _| SVector::from([-1.0, -1.0]));
        let fall = |start: At<f64, SVector<f64, 2>>| {
            let ground = Problem::new(&free, start).when(|x| [x[0], x[1]]);
            ground.falling().stop().solve(10.0, Dop853::new()).unwrap()
        };
        let motion = fall(At::from((0.0, SVector::from([2.0, 2.0 + apart]))));
        assert!(motion.met.any() && motion.met.contains(0));
        assert_eq!(motion.met.contains(1), together);
        if !together {
            let motion = fall(motion.last);
            assert!(motion.met.contains(1) && !motion.met.contains(0));
            assert_close(motion.t, 2.0 + apart, 1e-12);
        }
    }
}

/// A falling start above zero by less than the resolution of time is a crossing if that direction is requested.
#[test]
fn a_crossing_right_after_the_start_is_detected() {
    let falling = equation::<1, _>(|_, _| SVector::from([-1.0]));
    for (begin, expected) in [
        (1e-16, StopReason::Condition),
        (-1e-16, StopReason::Completed),
    ] {
        let start = At::from((1.0, SVector::from([begin])));
        let zero = Problem::new(&falling, start).when(|x| x[0]);
        let motion = zero.falling().stop().solve(2.0, Dop853::new());
        assert_eq!(motion.unwrap().reason, expected);
    }
}
