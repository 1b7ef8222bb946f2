//! A Stewart platform along a circle: the forces of its six drives.
//!
//! `cargo run --release --example stewart_platform` assembles the thirteen bodies along the way of the platform, compares the force
//! that the legs exert on it with Newton's second law, the power of the drives with the change of the energy, and writes
//! `stewart_platform.svg`: the legs from above, and the forces of the drives over a turn.

use std::error::Error;
use std::f64::consts::PI;

use lagrangian::prelude::*;
use lagrangian_examples::{Panel, Svg, extent};
use lagrangian_models::StewartPlatform;

const MASS: f64 = 40.0;
const G: f64 = 9.81;
const RADIUS: f64 = 0.25;
const OMEGA: f64 = 2.0 * PI;
/// The states of a turn.
const STATES: u32 = 180;

/// A platform of 40 kg, whose joints are in pairs below the corners of a triangle, and in pairs at the corners of another.
fn platform() -> Result<StewartPlatform, Box<dyn Error>> {
    Ok(StewartPlatform {
        platform: SymmetricBody::new(MASS, 0.05, 2.0, 4.0)?,
        cylinder: [SymmetricBody::new(3.0, 0.3, 0.35, 0.01)?; 6],
        rod: [SymmetricBody::new(1.5, -0.3, 0.18, 0.002)?; 6],
        base: StewartPlatform::hexagon(1.0, 0.2),
        top: StewartPlatform::hexagon(0.6, PI / 3.0 - 0.2),
        height: 1.0,
        radius: RADIUS,
        omega: OMEGA,
        g: G,
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = platform()?;
    let mut states = Vec::new();
    for i in 0..=STATES {
        let t = 2.0 * PI / OMEGA * f64::from(i) / f64::from(STATES);
        states.push(model.assemble(model.guess(t)).solve()?.state);
    }
    report(&model, &states)?;
    std::fs::write("stewart_platform.svg", figure(&model, &states))?;
    println!("Wrote stewart_platform.svg.");
    Ok(())
}

/// Prints the forces of the drives, and what checks them.
fn report(model: &StewartPlatform, states: &[State<f64, 24>]) -> Result<(), Box<dyn Error>> {
    println!("  t [s]    force of each drive [N]");
    let (mut of_forces, mut of_power) = (0.0_f64, 0.0_f64);
    for (i, state) in states.iter().enumerate() {
        let outputs = model.outputs(state);
        if i % 15 == 0 {
            let forces = outputs.force.map(|force| format!("{force:9.2}"));
            println!(
                "{:7.3} {}",
                state.t,
                forces.iter().cloned().collect::<String>()
            );
        }
        let (sine, cosine) = (OMEGA * state.t).sin_cos();
        let acceleration = -RADIUS * OMEGA.powi(2) * Vector3::new(cosine, sine, 0.0);
        let expected = MASS * (acceleration + Vector3::new(0.0, 0.0, G));
        of_forces = of_forces.max((outputs.carried - expected).norm() / expected.norm());

        let powers = (0..6).map(|k| outputs.force[k] * state.v[StewartPlatform::S[k]]);
        let energy = |t: f64| -> Result<f64, Box<dyn Error>> {
            Ok(model.energy(&model.assemble(model.guess(t)).solve()?.state))
        };
        let rate = (energy(state.t + 1e-4)? - energy(state.t - 1e-4)?) / 2e-4;
        of_power = of_power.max((powers.sum::<f64>() - rate).abs());
    }
    println!("\nThe legs exert the force m (a − g) on the platform to {of_forces:.0e} of it.");
    println!("The power of the drives is the rate of the energy to {of_power:.0e} W.");
    assert!(of_forces < 1e-12 && of_power < 1e-3);
    Ok(())
}

/// The legs from above, and the forces of the drives.
fn figure(model: &StewartPlatform, states: &[State<f64, 24>]) -> String {
    let subtitle = format!(
        "A turn in {:.1} s on a circle of {RADIUS} m.",
        2.0 * PI / OMEGA
    );
    let mut svg = Svg::titled(1100.0, 520.0, "Stewart platform", &subtitle);
    let plan = Panel::new(
        [84.0, 422.0, 112.0, 450.0],
        ([-1.2, 1.2], [-1.2, 1.2]),
        [6.0, 6.0],
    );
    plan.draw(&mut svg, "Legs from above", "x / m", "y / m");
    let centers = states.iter().map(|state| [state.q[0], state.q[1]]);
    plan.curve(&mut svg, "second", centers);
    for (base, top) in model.base.iter().zip(&model.top) {
        let end = [states[0].q[0] + top.x, states[0].q[1] + top.y];
        plan.curve(&mut svg, "frame", [[base.x, base.y], end].into_iter());
        svg.circle("start", plan.at(base.x, base.y), 4.0);
    }
    let forces: Vec<_> = states
        .iter()
        .map(|state| model.outputs(state).force)
        .collect();
    let [low, high] = extent(forces.iter().flat_map(|forces| forces.iter().copied()));
    let margin = 0.06 * (high - low);
    let range = ([0.0, 2.0 * PI / OMEGA], [low - margin, high + margin]);
    let panel = Panel::new([560.0, 1046.0, 112.0, 450.0], range, [6.0, 6.0]);
    panel.draw(
        &mut svg,
        "Forces of the six drives",
        "time / s",
        "force / N",
    );
    panel.level(&mut svg, "zero", 0.0);
    for k in 0..6 {
        let class = if k % 2 == 0 { "curve" } else { "second" };
        let points = states.iter().zip(&forces);
        panel.curve(
            &mut svg,
            class,
            points.map(|(state, forces)| [state.t, forces[k]]),
        );
    }
    svg.finish()
}
