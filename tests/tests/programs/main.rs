//! What a user asks of an integration: sixteen programs, each as short as the interface allows. `count.py` beside this file
//! counts their lines and the names of the crate that they mention; the tests below check what they compute.

mod models;
mod names;
mod bounce;
mod cancellation;
mod checkpoint;
mod dense;
mod ensemble;
mod events;
mod game_loop;
mod linear_quadratic_regulator;
mod other_method;
mod parameter_change;
mod proportional_derivative;
mod sampled_controller;
mod samples;
mod signal;
mod top;
mod variational_equations;

use std::sync::atomic::{AtomicBool, Ordering};

use lagrangian::elliptic::Modulus;
use lagrangian::prelude::*;

use crate::models::{PENDULUM, Swing};

/// Both are numbers of the size 1 or so.
fn assert_close(found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(
        error <= tolerance,
        "{found} in place of {expected}: {error:e}"
    );
}

#[test]
fn a_top_keeps_its_energy_under_both_methods() {
    assert!(top::program().unwrap().abs() < 1e-14);
    assert!(other_method::program().unwrap().abs() < 1e-9);
}

/// A fall of 1 s, then flights of 1 s and ½ s; and a throw at 20 m/s, which is in the air for 4 s and rises by 20 m.
#[test]
fn balls_fly_along_parabolas() {
    let impacts = bounce::program().unwrap();
    assert_eq!(impacts.len(), 3);
    for (found, expected) in impacts.into_iter().zip([1.0, 2.0, 2.5]) {
        assert_close(found, expected, 1e-13);
    }
    let [apex, distance] = events::program().unwrap();
    assert_close(apex, 20.0, 1e-13);
    assert_close(distance, 4.0, 1e-13);
}

/// The nutation from one start, however it is asked for.
#[test]
fn samples_are_values_of_the_solution() {
    let samples = samples::program().unwrap();
    assert_eq!(samples.len(), 1001);
    let [between, at_a_sample] = dense::program().unwrap();
    assert_close(samples[987], at_a_sample, 1e-12);
    assert!(samples[123].min(samples[124]) < between && between < samples[123].max(samples[124]));
    assert_close(checkpoint::program().unwrap(), samples[1000], 1e-12);
    let mut drawn = Vec::new();
    game_loop::program(|theta| drawn.push(theta)).unwrap();
    assert_eq!(drawn.len(), 600);
    for second in 1..=10 {
        assert_close(drawn[60 * second - 1], samples[100 * second], 1e-12);
    }
    // Nutation: h is constant and θ̇ = 0 at the start, which is where θ is smallest.
    assert!(samples.iter().all(|theta| *theta > 0.5 - 1e-13));
}

/// A throw upwards at 20 m/s under 10 m/s²: 20 m high, 4 s long at 1 m/s.
#[test]
fn events_are_where_the_parabola_has_them() {
    let [apex, range] = events::program().unwrap();
    assert_close(apex, 20.0, 1e-13);
    assert_close(range, 4.0, 1e-13);
    // It falls 5 m in 1 s, and rises at half of 10 m/s.
    let bounces = bounce::program().unwrap();
    assert_eq!(bounces.len(), 3);
    for (bounce, t) in bounces.into_iter().zip([1.0, 2.0, 2.5]) {
        assert_close(bounce, t, 1e-13);
    }
}

#[test]
fn controllers_reach_what_they_hold() {
    // The torque balances the weight: 100 (1 − θ) = m g l sin θ.
    let held = proportional_derivative::program().unwrap();
    assert_close(100.0 * (1.0 - held), 9.81 * held.sin(), 1e-7);
    assert!(linear_quadratic_regulator::program().unwrap().abs() < 1e-4);
    // The integral of the error leaves none.
    assert_close(sampled_controller::program().unwrap(), 1.0, 1e-6);
}

#[test]
fn a_signal_is_a_law_of_the_time() {
    let torque = |state: &State<f64, 1>| 0.5 * (2.0 * state.t).sin();
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let start = State::new(0.0, [0.0], [0.0]);
    let problem = Problem::new(&PENDULUM, start).feedback(torque);
    let end = problem.solve(10.0, method).unwrap();
    assert_close(signal::program().unwrap(), end.q[0], 1e-10);
}

#[test]
fn a_motion_ends_where_it_is_cancelled() {
    let cancelled = AtomicBool::new(false);
    let mut last = 0.0;
    let end = cancellation::program(&cancelled, |done| {
        assert!(done >= last);
        last = done;
        cancelled.store(done >= 0.5, Ordering::Relaxed);
    });
    let end = end.unwrap();
    assert!((50.0..51.0).contains(&end), "{end}");
}

/// Where a swing from `angle` of length `l` is after 10 s.
fn swing(l: f64, angle: f64, velocity: f64) -> f64 {
    let model = Swing { l, g: 9.81 };
    let start = State::new(0.0, [angle], [velocity]);
    let end = Problem::new(&model, start).solve(10.0, Taylor::new());
    end.unwrap().q[0]
}

#[test]
fn variations_are_differences() {
    let exact = variational_equations::program().unwrap();
    let h = 1e-5;
    let by_angle = swing(1.0, 1.0 + h, 0.0) - swing(1.0, 1.0 - h, 0.0);
    let by_velocity = swing(1.0, 1.0, h) - swing(1.0, 1.0, -h);
    let by_length = swing(1.0 + h, 1.0, 0.0) - swing(1.0 - h, 1.0, 0.0);
    for (exact, difference) in exact.into_iter().zip([by_angle, by_velocity, by_length]) {
        assert_close(exact, difference / (2.0 * h), 1e-7);
    }
}

#[test]
fn a_change_of_length_is_one_motion_behind_another() {
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let mut state = State::new(0.0, [1.0], [0.0]);
    for (l, end) in [(1.0, 5.0), (0.5, 10.0)] {
        let model = Swing { l, g: 9.81 };
        state = Problem::new(&model, state).solve(end, method).unwrap().last;
    }
    assert_close(parameter_change::program().unwrap(), state.q[0], 1e-10);
}

/// A swing from rest at 1 rad has the period 4 K √(l/g) with k = sin ½, and passes the bottom after a quarter of it.
#[test]
fn members_pass_the_bottom_when_the_closed_form_does() {
    let modulus = Modulus::new(0.5_f64.sin().powi(2), 0.5_f64.cos().powi(2));
    let members = ensemble::program().unwrap();
    assert_eq!(members.len(), 20);
    for (i, angles) in (0..).zip(members) {
        let l = 0.5 + 0.05 * f64::from(i);
        let quarter = modulus.complete_first() * (l / 9.81).sqrt();
        for (k, angle) in (0..).zip(&angles) {
            let t = 0.1 * f64::from(k);
            let end = Problem::new(Swing { l, g: 9.81 }, State::new(0.0, [1.0], [0.0]));
            let alone = end.solve(t, Taylor::new()).unwrap();
            assert_close(*angle, alone.q[0], 1e-14);
        }
        let count = (0..1000)
            .take_while(|k| 0.1 * f64::from(*k) <= quarter)
            .count();
        assert_eq!(angles.len(), count, "l = {l}");
    }
}
