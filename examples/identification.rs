//! An arm of two links whose masses, inertias and frictions are found from a motion and from torques that are measured with
//! noise: the base parameters with their standard deviations, and a figure of the torques.
//!
//! `cargo run --release --example identification` writes `identification.svg`.

use std::{error::Error, fs};

use lagrangian::identification::{Identification, Identified};
use lagrangian::prelude::*;
use lagrangian_examples::{Panel, Svg, extent};

/// Two links in a vertical plane, each with its mass, the distance of its centre of mass from its joint, and its moment of
/// inertia about that centre; viscous friction in the joints.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    coordinates(q1, q2),
    define(
        elbow = l * [cos(q1), sin(q1)],
        p1 = c1 * [cos(q1), sin(q1)],
        p2 = elbow + c2 * [cos(q1 + q2), sin(q1 + q2)],
    ),
    kinetic = 0.5 * (m1 * dot(p1).norm_squared() + i1 * dot(q1).powi(2)),
    kinetic = 0.5 * (m2 * dot(p2).norm_squared() + i2 * dot(q1 + q2).powi(2)),
    potential = g * (m1 * p1.y + m2 * p2.y),
    dissipation = 0.5 * (d1 * dot(q1).powi(2) + d2 * dot(q2).powi(2)),
    force(q1 = torque[0], q2 = torque[1]),
    regressor(i1, m1, c1, i2, m2, c2, d1, d2),
)]
struct Arm {
    i1: f64,
    m1: f64,
    c1: f64,
    d1: f64,
    i2: f64,
    m2: f64,
    c2: f64,
    d2: f64,
    /// The length of the first link, which is known.
    l: f64,
    g: f64,
    #[lagrangian(input)]
    torque: Vector2<f64>,
}

/// The standard deviation of a measured torque in N m.
const NOISE: f64 = 0.3;

/// Numbers from the normal distribution of deviation 1 (Box and Muller 1958), by Marsaglia's xorshift.
struct Normal(u64);

impl Normal {
    #[allow(clippy::cast_precision_loss)] // 53 bits are kept.
    fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        ((self.0 >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    }

    fn number(&mut self) -> f64 {
        let radius = (-2.0 * self.uniform().ln()).sqrt();
        radius * (std::f64::consts::TAU * self.uniform()).cos()
    }
}

/// The torques of a controller that follows a path of several frequencies.
fn law(state: &State<f64, 2>) -> Vector2<f64> {
    let t = state.t;
    let path = Vector2::new(
        0.8 * (1.1 * t).sin() + 0.5 * (2.9 * t).cos(),
        1.2 * (1.7 * t).cos() - 0.6 * (4.3 * t).sin(),
    );
    80.0 * (path - state.q) - 12.0 * state.v
}

/// The arm whose parameters are identified.
fn arm() -> Arm {
    Arm {
        i1: 0.12,
        m1: 4.0,
        c1: 0.25,
        d1: 0.8,
        i2: 0.05,
        m2: 2.5,
        c2: 0.2,
        d2: 0.5,
        l: 0.5,
        g: 9.81,
        torque: Vector2::zeros(),
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let real = arm();
    let times: Vec<f64> = (1..=400).map(|k| 0.025 * f64::from(k)).collect();
    let start = State::new(0.0, [0.5, 1.2], [0.0, 0.0]);
    let motion = Problem::new(&real, start)
        .feedback(law)
        .save(times)
        .solve(10.0, Dop853::new())?;

    let mut noise = Normal(88_172_645_463_325_252);
    let mut identification = Identification::new(Arm::BASE_PARAMETERS);
    let mut measured = Vec::new();
    for state in motion {
        let torque = law(&state);
        let accelerations = real.with_inputs(torque).accelerations(&state);
        let torque = torque + Vector2::from_fn(|_, _| NOISE * noise.number());
        let deviations = Vector2::repeat(NOISE);
        // Of the model only what is known enters: l, g and the torques.
        let model = real.with_inputs(torque);
        identification.add_weighted(
            &model,
            &state,
            &accelerations,
            &Vector2::zeros(),
            &deviations,
        );
        measured.push((state, accelerations, torque));
    }
    let found = identification.solve()?;
    report(&found, &real);

    let predicted = measured.iter().map(|(state, accelerations, _)| {
        // The torque that the identified parameters ask for: the inputs of the fields are zero.
        let forces = real.regressor(state, accelerations) * found.parameters;
        (state.t, forces)
    });
    let predicted: Vec<_> = predicted.collect();
    let measured: Vec<_> = measured
        .iter()
        .map(|(state, _, torque)| (state.t, *torque))
        .collect();
    fs::write("identification.svg", figure(&measured, &predicted))?;
    println!("torques, measured and by the identified parameters: identification.svg");
    Ok(())
}

/// Prints the identified parameters beside the real ones.
fn report(found: &Identified<6>, real: &Arm) {
    println!(
        "{:>28} {:>10} {:>10} {:>9}",
        "base parameter", "identified", "± σ", "real"
    );
    let expected: SVector<f64, 6> = real.base_parameters();
    let deviations = found.standard_deviations();
    for (i, name) in Arm::BASE_PARAMETERS.iter().enumerate() {
        println!(
            "{name:>28} {:>10.4} {:>10.4} {:>9.4}",
            found.parameters[i], deviations[i], expected[i]
        );
    }
    println!(
        "\n{} equations, condition number {:.1}, noise {:.3} of what was told",
        found.equations,
        found.condition_number,
        found.variance.sqrt()
    );
}

/// The measured torques as dots, and those of the identified parameters as lines.
fn figure(measured: &[(f64, Vector2<f64>)], predicted: &[(f64, Vector2<f64>)]) -> String {
    let title = "Parameters of an arm, identified";
    let subtitle = "Dots are measured torques, lines those of the identified base parameters.";
    let mut svg = Svg::titled(1000.0, 470.0, title, subtitle);
    let torques = measured.iter().flat_map(|(_, torque)| [torque.x, torque.y]);
    let [least, most] = extent(torques);
    let margin = 0.05 * (most - least);
    let panel = Panel::new(
        [84.0, 850.0, 112.0, 400.0],
        (
            extent(measured.iter().map(|(t, _)| *t)),
            [least - margin, most + margin],
        ),
        [10.0, 6.0],
    );
    panel.draw(
        &mut svg,
        "Torques of the joints",
        "time t / s",
        "torque / N m",
    );
    for (joint, class) in ["curve", "second"].into_iter().enumerate() {
        for (t, torque) in measured {
            svg.circle(class, panel.at(*t, torque[joint]), 1.2);
        }
        let points = predicted.iter().map(|(t, torque)| [*t, torque[joint]]);
        panel.curve(&mut svg, class, points);
        let y = if joint == 0 { 130.0 } else { 152.0 };
        svg.entry(class, [874.0, y], &format!("joint {}", joint + 1));
    }
    svg.finish()
}
