//! Long integrations: the effect of compensated summation.

use crate::common::{Oscillator, assert_close};
use lagrangian::prelude::*;
use nalgebra::SVector;

/// The classical step as in a textbook, without compensation.
fn plain_step(x: SVector<f64, 2>, h: f64) -> SVector<f64, 2> {
    let f = |x: SVector<f64, 2>| SVector::from([x[1], -x[0]]);
    let k1 = f(x);
    let k2 = f(x + k1 * (h / 2.0));
    let k3 = f(x + k2 * (h / 2.0));
    let k4 = f(x + k3 * h);
    x + (k1 + (k2 + k3) * 2.0 + k4) * (h / 6.0)
}

#[test]
#[ignore = "a long integration; run with `--include-ignored`"]
fn compensation_stops_the_growth_of_rounding_errors() {
    rounding_errors_do_not_grow(500_000);
}

#[test]
fn compensation_bounds_the_rounding_errors_of_fifty_thousand_steps() {
    rounding_errors_do_not_grow(50_000);
}

/// The energy of the oscillator is multiplied by 1 − h⁶/72 + … in each step, so at h = 1/512 the
/// method itself loses 4e-13 in 500 000 steps of 2⁻⁹: known to many digits, and the rest is
/// rounding error.
fn rounding_errors_do_not_grow(steps: u32) {
    let h = 1.0 / 512.0;
    let start = SVector::from([1.0, 0.0]);
    let mut plain = start;
    for _ in 0..steps {
        plain = plain_step(plain, h);
    }
    let end = f64::from(steps) * h;
    let carried = Problem::new(Oscillator, At { t: 0.0, x: start })
        .solve(end, RungeKutta::classical(h))
        .unwrap();
    // The amplification factor is |1 + z + z²/2 + z³/6 + z⁴/24|² at z = ih: 1 − h⁶/72 + h⁸/576.
    let factor = -h.powi(6) / 72.0 + h.powi(8) / 576.0;
    let exact = f64::from(steps) * factor;
    let carried = (carried.x.norm_squared() - 1.0 - exact).abs();
    let plain = (plain.norm_squared() - 1.0 - exact).abs();
    println!("rounding in the energy: {plain:e} plain, {carried:e} with carries");
    assert_close(carried, 0.0, 8.0 * f64::EPSILON);
    assert!(plain > 10.0 * carried);
}

/// The time after many steps whose size is not a binary fraction is correct.
#[test]
fn time_does_not_drift() {
    let mut stepper = RungeKutta::classical(0.1)
        .start(&Oscillator, 0.0, SVector::from([1.0, 0.0]))
        .unwrap();
    for _ in 0..99_999 {
        stepper.step(&Oscillator, 1e4).unwrap();
    }
    assert_close(stepper.time(), 9999.9, 2e-12);
}

#[test]
#[ignore = "a long integration; run with `--include-ignored`"]
fn the_adaptive_method_keeps_the_energy_over_ten_thousand_radians() {
    the_adaptive_method_keeps_the_energy(1e4);
}

#[test]
fn the_adaptive_method_keeps_the_energy_over_a_thousand_radians() {
    the_adaptive_method_keeps_the_energy(1e3);
}

fn the_adaptive_method_keeps_the_energy(radians: f64) {
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let start = At::from((0.0, SVector::from([1.0, 0.0])));
    let end = Problem::new(Oscillator, start)
        .solve(radians, method)
        .unwrap();
    println!(
        "energy drift {:e} in {:?}",
        end.x.norm_squared() - 1.0,
        end.statistics
    );
    let steps = f64::from(u32::try_from(end.statistics.steps).unwrap());
    assert_close(end.x.norm_squared(), 1.0, 2.0 * steps * 1e-13);
}
