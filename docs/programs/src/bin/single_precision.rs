//! A cart and a pole on `f32` and on `f64`: what is lost in 10 s.

use std::f64::consts::TAU;

use cart_pole_model::{CartPole, law};
use lagrangian::nalgebra::RowVector4;
use lagrangian::prelude::*;

/// The gain of the firmware.
fn gain<S: Scalar>() -> RowVector4<S> {
    RowVector4::new(-2.6758, -35.4849, -4.0647, -7.5324).map(S::from_f64)
}

/// The pole under its regulator, by steps of 1 ms: every tenth of a second.
fn regulated<S: Scalar>() -> Result<Vec<State<S, 2>>, IntegrationError> {
    let model = CartPole::<S>::new();
    let [zero, tilt] = [0.0, 0.4].map(S::from_f64);
    let samples = (1..=100).map(|k| 0.1 * f64::from(k));
    let motion = Problem::new(&model, State::new(zero, [zero, tilt], [zero; 2]))
        .feedback(|x| law(&gain(), x))
        .save(samples.collect::<Vec<_>>())
        .solve(10.0, RungeKutta::classical(1e-3))?;
    Ok(motion.into_iter().collect())
}

/// The pole swinging freely below the cart.
fn free<S: Scalar>() -> Result<Vec<State<S, 2>>, IntegrationError> {
    let model = CartPole::<S>::new();
    let [zero, tilt] = [0.0, 2.0].map(S::from_f64);
    let samples = (1..=100).map(|k| 0.1 * f64::from(k));
    let motion = Problem::new(&model, State::new(zero, [zero, tilt], [zero; 2]))
        .save(samples.collect::<Vec<_>>())
        .solve(10.0, RungeKutta::classical(1e-3))?;
    Ok(motion.into_iter().collect())
}

/// The least power of ten that is not below a positive number.
fn bound(x: f64) -> String {
    format!("below 1e{}", x.log10().ceil())
}

/// The largest difference of an angle.
fn difference(single: &[State<f32, 2>], double: &[State<f64, 2>]) -> f64 {
    let pairs = single.iter().zip(double);
    let differences = pairs.map(|(x, y)| (f64::from(x.q[1]) - y.q[1]).abs());
    differences.fold(0.0, f64::max)
}

fn main() -> Result<(), IntegrationError> {
    let error = difference(&regulated()?, &regulated()?);
    println!("angle under the regulator, 10 s   {} rad", bound(error));
    let error = difference(&free()?, &free()?);
    println!("angle of the free swing, 10 s     {} rad", bound(error));

    // Time as a sum of milliseconds.
    let sum = (0..10_000).fold(0.0_f32, |t, _| t + 1e-3);
    println!("10 s as a sum of 10 000 ms        {sum:.5} s");
    println!(
        "spacing of f32 at 1 hour          {:.5} s",
        f32::EPSILON * 2048.0
    );

    // An angle after many turns.
    #[allow(clippy::cast_possible_truncation)]
    let turned = |turns: f64| f64::from((TAU * turns + 0.1) as f32) - (TAU * turns + 0.1);
    for turns in [1e1, 1e3, 1e5] {
        println!(
            "angle after {turns:6.0} turns          {} rad",
            bound(turned(turns).abs())
        );
    }
    Ok(())
}
