//! A pan-tilt head: what its motors tell of its masses and frictions.

// ANCHOR: model
use lagrangian::identification::Identification;
use lagrangian::prelude::*;
use lagrangian_ensembles::{Parameter, Points, Sample};
use lagrangian_guide::{Curve, Figure};

/// A camera that turns about the vertical (pan) and about a horizontal axis (tilt), which meet.
#[derive(Lagrangian, Default)]
#[lagrangian(
    coordinates(pan, tilt),
    define(
        axes = rotation_z(pan) * rotation_y(tilt),
        w = angular_velocity(axes),
    ),
    kinetic = 0.5 * i_base * dot(pan).powi(2) + 0.5 * w.dot(diagonal([i_x, i_y, i_z]) * w),
    potential = m * g * (axes * [c_x, 0.0, c_z]).z,
    dissipation = 0.5 * (d_pan * dot(pan).powi(2) + d_tilt * dot(tilt).powi(2)),
    force(
        pan = torque[0] - f_pan * tanh(dot(pan) / smooth),
        tilt = torque[1] - f_tilt * tanh(dot(tilt) / smooth),
    ),
    regressor(i_base, i_x, i_y, i_z, m, c_x, c_z, d_pan, d_tilt, f_pan, f_tilt),
)]
struct Head {
    /// Moments of inertia of the base about the vertical, and of the camera about the point where
    /// the axes meet.
    i_base: f64,
    i_x: f64,
    i_y: f64,
    i_z: f64,
    /// The mass of the camera, and its centre of gravity.
    m: f64,
    c_x: f64,
    c_z: f64,
    /// Viscous and dry friction.
    d_pan: f64,
    d_tilt: f64,
    f_pan: f64,
    f_tilt: f64,
    /// The speed below which dry friction is smoothed, and gravity: both are known.
    smooth: f64,
    g: f64,
    #[lagrangian(input)]
    torque: Vector2<f64>,
}
// ANCHOR_END: model

// ANCHOR: measure
/// The standard deviation of a measured torque in N m.
const NOISE: f64 = 0.02;

/// The torques of a controller that follows a path of several frequencies.
fn law(x: &State<f64, 2>) -> Vector2<f64> {
    let pan = 1.2 * (0.9 * x.t).sin() + 0.6 * (2.3 * x.t).sin();
    let tilt = 0.7 * (1.3 * x.t).sin() + 0.4 * (3.1 * x.t).cos();
    12.0 * (Vector2::new(pan, tilt) - x.q) - 1.5 * x.v
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let real = Head {
        i_base: 0.02,
        i_x: 0.03,
        i_y: 0.05,
        i_z: 0.04,
        m: 2.0,
        c_x: 0.06,
        c_z: -0.02,
        d_pan: 0.08,
        d_tilt: 0.05,
        f_pan: 0.15,
        f_tilt: 0.1,
        smooth: 0.02,
        g: 9.81,
        torque: Vector2::zeros(),
    };
    // The measurement: here a motion of the model, and noise on its torques.
    let start = State::new(0.0, [0.0, 0.4], [0.0, 0.0]);
    let motion = Problem::new(&real, start)
        .feedback(law)
        .save(Every(0.02))
        .solve(20.0, Dop853::new())?;
    let deviations = ["pan", "tilt"].map(|name| Parameter::normal(name, 0.0, NOISE));
    let noise = Sample::new(motion.samples().len(), deviations);

    // ANCHOR_END: measure

    // ANCHOR: identify
    // Of the model only what is known enters: g and the smoothing.
    let model = Head {
        smooth: real.smooth,
        g: real.g,
        ..Head::default()
    };
    let mut identification = Identification::new(Head::BASE_PARAMETERS);
    let mut measured = Vec::new();
    for (k, x) in motion.samples().iter().enumerate() {
        let torque = law(x);
        let accelerations = real.with_inputs(torque).accelerations(x);
        let torque = torque + Vector2::from(noise.point(k));
        let deviations = Vector2::repeat(NOISE);
        identification.add_weighted(&model, x, &accelerations, &torque, &deviations);
        measured.push((x, accelerations, torque));
    }
    let found = identification.solve()?;
    let (true_values, deviations) = (real.base_parameters(), found.standard_deviations());
    println!("base parameter      found ±  std. dev.     true");
    for (i, name) in Head::BASE_PARAMETERS.iter().enumerate() {
        let (found, true_value): (f64, f64) = (found.parameters[i], true_values[i]);
        println!(
            "{name:16} {found:8.4} ± {:8.4} {true_value:10.4}",
            deviations[i]
        );
        assert!((found - true_value).abs() < 4.0 * deviations[i]);
    }
    println!("Condition number {:.0}", found.condition_number);
    println!(
        "Residuals: {:.2} of the expected noise",
        found.variance.sqrt()
    );

    let [mut dots, mut line] = [Vec::new(), Vec::new()];
    for (x, accelerations, torque) in measured.into_iter().take(300) {
        let predicted = model.regressor(x, &accelerations) * found.parameters;
        dots.push([x.t, torque[1]]);
        line.push([x.t, predicted[1]]);
    }
    Figure::new("identify", "t in s", "torque of tilt in N m")
        .draw(&[Curve::new("measured", dots), Curve::new("identified", line)])
}
// ANCHOR_END: identify
