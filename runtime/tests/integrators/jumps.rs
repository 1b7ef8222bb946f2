//! Forces with jumps under the Taylor series method: steps end at discontinuity surfaces and go on behind them.

use core::f64::consts::PI;

use lagrangian::prelude::*;
use lagrangian::signals::Polynomial;
use lagrangian::{DoubleDouble, Scalar};

/// A square wave, ẍ = a sgn sin ωt.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = a * signum(sin(omega * t))))]
struct SquareWave {
    a: f64,
    omega: f64,
}

/// x and ẋ of a square wave from rest: half periods of parabolas.
fn wave(a: f64, omega: f64, t: f64) -> [f64; 2] {
    let half = PI / omega;
    let whole = (t / half).floor();
    let rest = t - whole * half;
    let is_odd = whole.rem_euclid(2.0) > 0.5;
    // ẋ is a triangle between 0 and a·half; over each half period x grows by a·half²/2.
    let x = whole * 0.5 * a * half * half;
    if is_odd {
        let v = a * half;
        [x + v * rest - 0.5 * a * rest * rest, v - a * rest]
    } else {
        [x + 0.5 * a * rest * rest, a * rest]
    }
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn square_waves_are_parabolas() {
    follow_square_waves(1);
}

#[test]
fn some_square_waves_are_parabolas() {
    follow_square_waves(3);
}

/// Compares motions with closed forms, at one frequency of so many.
fn follow_square_waves(stride: usize) {
    for i in (0..6).step_by(stride) {
        let omega = 0.5 + 2.733 * f64::from(i);
        let model = SquareWave { a: 1.5, omega };
        for end in [20.0, 7.3, 2.0 * PI / omega, -11.0] {
            let start = State::new(0.0, [0.0], [0.0]);
            let found = Problem::new(&model, start)
                .solve(end, Taylor::new())
                .unwrap();
            // Backwards, x(−t) = −x(t), since the force is odd in time.
            let [x, v] = wave(1.5, omega, end.abs());
            let [x, v] = if end < 0.0 { [-x, v] } else { [x, v] };
            // The phase ωt is rounded at each jump, and what the velocity loses there, the position loses for a long time.
            assert!(
                (found.q[0] - x).abs() < 1e-12,
                "{omega} {end}: {:e}",
                found.q[0] - x
            );
            assert!(
                (found.v[0] - v).abs() < 1e-13,
                "{omega} {end}: {:e}",
                found.v[0] - v
            );
        }
    }
}

#[test]
#[ignore = "a long integration; run with `--include-ignored`"]
fn many_jumps_take_few_steps() {
    jumps_take_few_steps(2000);
}

#[test]
fn two_hundred_jumps_take_few_steps() {
    jumps_take_few_steps(200);
}

/// So many jumps, with hardly more steps.
fn jumps_take_few_steps(jumps: u32) {
    let model = SquareWave { a: 1.0, omega: 1.0 };
    let start = State::new(0.0, [0.0], [0.0]);
    let end = PI * f64::from(jumps);
    let motion = Problem::new(&model, start)
        .solve(end, Taylor::new())
        .unwrap();
    let [x, v] = wave(1.0, 1.0, end);
    assert!((motion.v[0] - v).abs() < 1e-12, "{:e}", motion.v[0] - v);
    assert!(
        (motion.q[0] / x - 1.0).abs() < 1e-14,
        "{:e}",
        motion.q[0] / x - 1.0
    );
    let statistics = motion.statistics;
    let jumps = u64::from(jumps);
    assert!(4 * statistics.steps < 5 * jumps, "{statistics:?}");
    assert!(statistics.evaluations < 30 * jumps, "{statistics:?}");
}

/// A relay without hysteresis, ẍ = −sgn(x − x₀).
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = -signum(x - x0)))]
struct Relay {
    x0: f64,
}

/// From x₀ + 1 at rest: parabolas of duration √2 each, with the period 4√2.
fn relay(x0: f64, t: f64) -> [f64; 2] {
    let quarter = 2.0_f64.sqrt();
    let period = 4.0 * quarter;
    let t = t - (t / period).floor() * period;
    let t = if t > 3.0 * quarter { t - period } else { t };
    if t.abs() <= quarter {
        [x0 + 1.0 - 0.5 * t * t, -t]
    } else {
        let t = t - 2.0 * quarter;
        [x0 - 1.0 + 0.5 * t * t, t]
    }
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn relays_switch_thousands_of_times() {
    switch(40);
}

#[test]
fn relays_switch_hundreds_of_times() {
    switch(5);
}

/// Compares so many samples of the motions of relays with closed forms.
fn switch(samples: u32) {
    for x0 in [0.0_f64, 0.3, -70.0] {
        let model = Relay { x0 };
        let start = State::new(0.0, [x0 + 1.0], [0.0]);
        let times: Vec<f64> = (1..=samples).map(|i| 151.7 * f64::from(i)).collect();
        let end = times[times.len() - 1];
        let motion = Problem::new(&model, start)
            .save(times)
            .solve(end, Taylor::new());
        for sample in motion.unwrap() {
            let [x, v] = relay(x0, sample.t);
            // Rounding errors of the energy are a random walk, and the phase sums them.
            let jumps = sample.t / 8.0_f64.sqrt();
            let tolerance = 16.0 * f64::EPSILON * (1.0 + x0.abs()) * jumps.powf(1.5);
            assert!(
                (sample.q[0] - x).abs() < tolerance,
                "{x0} {}: {:e}",
                sample.t,
                sample.q[0] - x
            );
            assert!((sample.v[0] - v).abs() < tolerance, "{x0} {}", sample.t);
        }
    }
}

/// A force that is switched on.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), potential = 0.5 * x.powi(2), force(x = 0.5 + 0.5 * signum(t - t0)))]
struct Step {
    t0: f64,
}

/// At the beginning, the end, at samples, between, and at late times.
#[test]
fn steps_in_time_wherever_they_are() {
    for t0 in [0.0, 1.0, 0.3, 1e-9, 1e-300, 2.0 - 1e-15, 2.0, 0.7] {
        for late in [0.0, 1e3, -1e6] {
            let model = Step { t0: t0 + late };
            let t0 = model.t0 - late;
            let start = State::new(late, [1.0], [0.0]);
            let times = [late + 0.3, late + 1.0, late + 1.5, late + 2.0, late + 2.0];
            let motion = Problem::new(&model, start)
                .save(times)
                .solve(times[4], Taylor::new())
                .unwrap();
            let later = Problem::new(&model, motion.samples()[3]).solve(late + 3.0, Taylor::new());
            let all = motion.into_iter().chain([later.unwrap().last]);
            for sample in all {
                let t = sample.t - late;
                let since = (t - t0).max(0.0);
                let expected = t.cos() + 1.0 - since.cos();
                let tolerance = 1e-14 + 8.0 * f64::EPSILON * late.abs();
                assert!(
                    (sample.q[0] - expected).abs() < tolerance,
                    "{t0} {late} {t}: {:e}",
                    sample.q[0] - expected
                );
            }
        }
    }
}

/// A mass that is driven by a signal through a relay, and one that is held.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = signum(u - x)))]
struct Follower {
    #[lagrangian(input)]
    u: f64,
}

#[test]
fn relays_of_driven_motions() {
    let model = Follower { u: 0.0 };
    // u = t/4: in the frame of the signal a relay.
    let signal = Polynomial([0.0, 0.25]);
    let start = State::new(0.0, [1.0], [0.25]);
    for t in [3.0, 40.0, 500.0] {
        let end = Problem::new(&model, start)
            .driven_by([signal])
            .solve(t, Taylor::new())
            .unwrap();
        let expected = relay(0.0, t)[0] + 0.25 * t;
        assert!(
            (end.q[0] - expected).abs() < 1e-11,
            "{t}: {:e}",
            end.q[0] - expected
        );
    }
    let held = model.with_inputs([0.5]);
    let start = State::new(0.0, [1.5], [0.0]);
    let end = Problem::new(&held, start)
        .solve(40.0, Taylor::new())
        .unwrap();
    assert!((end.q[0] - relay(0.5, 40.0)[0]).abs() < 1e-12);
}

/// A relay without constants.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = -signum(x)))]
struct UnitRelay;

fn on<S: Scalar, const HALF: usize>(method: Taylor<HALF>, t: f64) -> S {
    let start = State::new(S::zero(), [S::one()], [S::zero()]);
    Problem::new(&UnitRelay, start).solve(t, method).unwrap().q[0]
}

#[test]
fn other_scalars_and_orders() {
    let expected = relay(0.0, 20.0)[0];
    assert!((f64::from(on::<f32, 6>(Taylor::order_12(), 20.0)) - expected).abs() < 2e-4);
    assert!((on::<f64, 8>(Taylor::order_16(), 20.0) - expected).abs() < 1e-13);
    // To 28 digits: after 3 half periods at −1 + (t − 6√2)²/2.
    let two = DoubleDouble::from(2.0);
    let half = two * two.sqrt();
    let rest = DoubleDouble::from(20.0) - half * DoubleDouble::from(7.0);
    let exact = rest * rest / two - DoubleDouble::from(1.0);
    let found = on::<DoubleDouble, 20>(Taylor::order_40(), 20.0);
    assert!(
        (found - exact).to_f64().abs() < 1e-28,
        "{:e}",
        (found - exact).to_f64()
    );
}
