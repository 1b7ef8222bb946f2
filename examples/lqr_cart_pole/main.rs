//! A linear-quadratic regulator for a pole on a cart: linearized, designed in continuous and in discrete time, and tried on the
//! nonlinear model.
//!
//! `cargo run --release --example lqr_cart_pole [folder]` prints poles, gains and from which tilt the pole is caught, and writes
//! `lqr_cart_pole.svg`, into the current folder unless another one is named.

mod figure;
mod model;

use std::error::Error;
use std::path::PathBuf;

use lagrangian::analysis::{EquilibriumSearch, SmallOscillations, Spectrum, StateSpace};
use lagrangian::nalgebra::{Matrix1, Matrix4, RowVector4, Vector4};
use lagrangian::prelude::*;

use crate::figure::{Curve, figure};
use crate::model::{CartPole, largest_tilt};

/// The weights of (x, θ, ẋ, θ̇) and of the force in the cost, per s: 0.3 m, 1 rad, 1 m/s, 1 rad/s and 3 N count the same.
const STATE_WEIGHTS: [f64; 4] = [10.0, 1.0, 1.0, 1.0];
const FORCE_WEIGHT: f64 = 0.1;

/// Sampling periods in s.
const PERIODS: [f64; 3] = [0.02, 0.1, 0.2];

fn main() -> Result<(), Box<dyn Error>> {
    let model = CartPole {
        cart: 1.0,
        pole: 0.2,
        l: 0.5,
        g: 9.81,
        push: 0.0,
    };

    let upright = upright(&model)?;
    let plant = StateSpace::<f64, 4, 1, 4>::of(&model, &upright);
    println!("Poles of the cart:      {}", listed(plant.poles()));
    println!(
        "Controllable states:    {} of 4\n",
        plant.controllability().rank
    );
    let (gain, sampled) = design(&model, &plant)?;
    let curves = curves(&model, &gain, &sampled)?;
    let folder = std::env::args_os()
        .nth(1)
        .map_or_else(PathBuf::new, PathBuf::from);
    let path = folder.join("lqr_cart_pole.svg");
    std::fs::write(&path, figure(&curves, model.l))
        .map_err(|error| format!("{} cannot be written: {error}", path.display()))?;
    println!("Wrote {}.", path.display());
    Ok(())
}

/// The equilibrium with the pole upright, from a guess; says what it is without control.
fn upright(model: &CartPole) -> Result<State<f64, 2>, Box<dyn Error>> {
    let guess = State::new(0.0, [0.0, 0.2], [0.0, 0.0]);
    let upright = EquilibriumSearch::of(model).near(&guess)?;
    let stability = SmallOscillations::about(model, &upright.state)?.stability()?;
    println!(
        "Equilibrium at θ = {:.3} rad after {} Newton steps: {:?}.",
        upright.state.q[CartPole::THETA].abs(),
        upright.report.iterations,
        stability.verdict(),
    );
    Ok(upright.state)
}

/// A gain for the state.
type Gain = RowVector4<f64>;
/// Gains of sampled regulators, with their periods.
type Sampled = Vec<(f64, Gain)>;

/// Gains in continuous and in discrete time, and from which tilt each catches the pole.
fn design(
    model: &CartPole,
    plant: &StateSpace<f64, 4, 1, 4>,
) -> Result<(Gain, Sampled), Box<dyn Error>> {
    let state_weight = Matrix4::from_diagonal(&Vector4::from(STATE_WEIGHTS));
    let force_weight = Matrix1::new(FORCE_WEIGHT);
    let regulator = plant.regulator(&state_weight, &force_weight)?;
    println!("                                  gain (x, θ, ẋ, θ̇)      caught from");
    let gain = regulator.gain;
    let largest = largest_tilt(|tilt| model.continuous(&gain, tilt))?;
    print_row("continuous", gain.as_slice(), largest);
    let mut sampled = Vec::new();
    for period in PERIODS {
        let held = plant.discretized(period);
        let regulator = held.regulator(&(state_weight * period), &(force_weight * period))?;
        let gain = regulator.gain;
        let largest = largest_tilt(|tilt| model.sampled(&gain, tilt, period))?;
        print_row(&format!("every {period} s"), gain.as_slice(), largest);
        sampled.push((period, gain));
    }
    println!(
        "\nPoles of the loop:      {}",
        listed(Some(regulator.poles))
    );
    println!(
        "Residual of the Riccati equation: {:.1e}",
        regulator.residual
    );
    Ok((gain, sampled))
}

/// Motions from several tilts, and one with a sampled regulator.
fn curves(
    model: &CartPole,
    gain: &Gain,
    sampled: &[(f64, Gain)],
) -> Result<Vec<Curve>, Box<dyn Error>> {
    let mut curves = Vec::new();
    for degrees in [20.0_f64, 40.0, 55.0] {
        curves.push(Curve {
            label: format!("from {degrees}°"),
            motion: model.continuous(gain, degrees.to_radians())?,
        });
    }
    if let Some((period, gain)) = sampled.get(1) {
        curves.push(Curve {
            label: format!("from 40°, every {period} s"),
            motion: model.sampled(gain, 40_f64.to_radians(), *period)?,
        });
    }
    Ok(curves)
}

/// Eigenvalues in a line.
fn listed(poles: Option<Spectrum<4>>) -> String {
    let Some(poles) = poles else {
        return "not found".to_owned();
    };
    let above = poles.iter().filter(|pole| pole.im >= 0.0);
    let written = above.map(|pole| {
        if pole.im > 0.0 {
            format!("{:.3} ± {:.3} i", pole.re, pole.im)
        } else {
            format!("{:.3}", pole.re)
        }
    });
    let written: Vec<_> = written.collect();
    format!("{} 1/s", written.join(", "))
}

fn print_row(name: &str, gain: &[f64], largest: f64) {
    let gain: Vec<_> = gain.iter().map(|entry| format!("{entry:8.3}")).collect();
    println!("{name:<16}{} {:8.1}°", gain.join(" "), largest.to_degrees());
}
