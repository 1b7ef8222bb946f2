//! Whipple's bicycle as a nonlinear mechanism, against the published linear equations and eigenvalues
//! (`data/bicycle.json`), and its nonlinear motions.

use lagrangian::analysis::{StateSpace, TangentError, TangentSpace};
use lagrangian::prelude::*;
use lagrangian_models::Bicycle;
use lagrangian_tests::{Figures, bicycle, list, number, relative_error};
use nalgebra::{Complex, Matrix2};
use serde_json::Value;

/// Half a unit of the last digit that is printed.
const PRINTED: f64 = 5e-15;

/// Everything that moves in straight rolling, and what has no effect.
const LEFT_OUT: [usize; 5] = [
    Bicycle::X,
    Bicycle::Y,
    Bicycle::YAW,
    Bicycle::REAR,
    Bicycle::FRONT,
];

fn benchmark() -> Bicycle {
    Bicycle::benchmark().expect("its bodies have inertia")
}

fn matrix(value: &Value) -> Matrix2<f64> {
    Matrix2::from_fn(|i, j| number(&value[i][j]))
}

/// The linear model in lean and steer, their velocities and the angular velocity of the rear wheel, with the torques on lean and
/// steer and the drive.
fn plant(model: &Bicycle, speed: f64) -> Result<StateSpace<f64, 5, 3, 5>, TangentError> {
    let straight = model.straight(speed);
    let tangent = TangentSpace::at(model, &straight)
        .without(LEFT_OUT)
        .coordinates([Bicycle::LEAN, Bicycle::STEER])
        .velocities([Bicycle::LEAN, Bicycle::STEER, Bicycle::REAR]);
    StateSpace::reduced(&tangent)
}

/// A block of the rows of lean and steer: by their angles, or by their velocities.
fn block(plant: &StateSpace<f64, 5, 3, 5>, column: usize) -> Matrix2<f64> {
    plant.a.fixed_view::<2, 2>(2, column).into_owned()
}

/// Torques accelerate by M⁻¹.
#[test]
fn the_published_matrices() {
    let (model, data) = (benchmark(), bicycle());
    let at = |speed| plant(&model, speed).expect("it rolls steadily");
    let mut figures = Figures::new();
    let still = at(0.0);
    let torques = still.b.fixed_view::<2, 2>(2, 0).into_owned();
    let mass = torques.try_inverse().expect("a mass matrix");
    let k0 = -mass * block(&still, 0) / model.g;
    let mut record = |name: &'static str, speed: &str, found: Matrix2<f64>| {
        let expected = matrix(&data[name]);
        let error = relative_error(found.as_slice(), expected.as_slice(), 1e-300);
        figures.record(name, speed, error, 1e-12);
    };
    record("m", "0", mass);
    record("k0", "0", k0);
    for speed in [0.5, 1.0, 4.0, 10.0] {
        let (plant, label) = (at(speed), format!("{speed} m/s"));
        record("m", &label, plant.b.fixed_view::<2, 2>(2, 0).into_owned().try_inverse().expect("regular"));
        record("c1", &label, -mass * block(&plant, 2) / speed);
        record("k2", &label, -(mass * block(&plant, 0) + k0 * model.g) / speed.powi(2));
    }
    figures.finish();
}

/// The distance of an eigenvalue to the nearest that was found, and the largest distance that its printed digits and rounding
/// explain.
fn nearest(found: &[Complex<f64>], expected: Complex<f64>) -> f64 {
    let distances = found.iter().map(|x| (x - expected).norm());
    distances.fold(f64::INFINITY, f64::min)
}

/// Four eigenvalues belong to lean and steer; that of the speed is 0.
#[test]
fn the_published_eigenvalues() {
    let (model, data) = (benchmark(), bicycle());
    let mut figures = Figures::new();
    let mut record = |kind: &'static str, speed: f64, expected: Complex<f64>| {
        let poles = plant(&model, speed).expect("it rolls steadily").poles();
        let poles = poles.expect("a finite matrix");
        assert!(poles[0].norm() < 1e-13, "{poles:?}");
        let error = (nearest(&poles[1..], expected) - PRINTED).max(0.0) / expected.norm();
        figures.record(kind, &format!("{speed} m/s"), error, 1e-12);
    };
    for row in list(&data["eigenvalues"]) {
        let speed = number(&row["speed"]);
        let weave = Complex::new(number(&row["weave"][0]), number(&row["weave"][1]));
        record("weave", speed, weave);
        record("capsize", speed, number(&row["capsize"]).into());
        record("castering", speed, number(&row["castering"]).into());
    }
    for value in list(&data["at_rest"]) {
        record("at rest", 0.0, number(value).into());
        record("at rest", 0.0, (-number(value)).into());
    }
    figures.finish();
}
