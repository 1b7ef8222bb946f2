//! The accelerations of tops near the poles of their Euler angles, where those of φ and ψ are large and
//! opposite: the error of q̈, in relation to its length.

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, list, near_the_poles, number, numbers};
use nalgebra::SVector;
use serde_json::Value;

/// Were what cancels in M, which is nearly singular there, left to rounding, those of the general top
/// would be off by 1e-9.
const TOLERANCE: f64 = 1e-13;

/// The symmetric top (4.7) with gravity.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    kinetic = 0.5 * (i * (dot(phi).powi(2) * sin(theta).powi(2) + dot(theta).powi(2))
        + i_s * (dot(phi) * cos(theta) + dot(psi)).powi(2)),
    potential = m * g * l * cos(theta),
)]
struct SymmetricTop {
    i: f64,
    i_s: f64,
    m: f64,
    g: f64,
    l: f64,
}

/// The general top (4.5) with gravity, its centre of mass beside all axes.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (i1 * w1.powi(2) + i2 * w2.powi(2) + i3 * w3.powi(2)),
    potential = m * g * (x * sin(theta) * sin(psi) + y * sin(theta) * cos(psi) + z * cos(theta)),
)]
struct GeneralTop {
    i1: f64,
    i2: f64,
    i3: f64,
    m: f64,
    g: f64,
    x: f64,
    y: f64,
    z: f64,
}

#[test]
fn accelerations_near_the_poles() {
    let references = near_the_poles();
    let mut figures = Figures::new();
    symmetric_top(&references["symmetric"], &mut figures);
    general_top(&references["general"], &mut figures);
    figures.finish();
}

fn symmetric_top(reference: &Value, figures: &mut Figures) {
    let parameter = |name: &str| number(&reference["parameters"][name]);
    let top = SymmetricTop {
        i: parameter("i"),
        i_s: parameter("i_s"),
        m: parameter("m"),
        g: parameter("g"),
        l: parameter("l"),
    };
    let names = [
        "symmetric, θ = 1e-2",
        "symmetric, θ = 1e-4",
        "symmetric, θ = 1e-6",
        "symmetric, θ = π − 1e-2",
        "symmetric, θ = π − 1e-4",
        "symmetric, θ = π − 1e-6",
    ];
    let accelerations = |state: &State<f64, 3>| top.accelerations(state);
    compare(reference, names, accelerations, figures);
}

fn general_top(reference: &Value, figures: &mut Figures) {
    let parameter = |name: &str| number(&reference["parameters"][name]);
    let top = GeneralTop {
        i1: parameter("i1"),
        i2: parameter("i2"),
        i3: parameter("i3"),
        m: parameter("m"),
        g: parameter("g"),
        x: parameter("x"),
        y: parameter("y"),
        z: parameter("z"),
    };
    let names = [
        "general, θ = 1e-2",
        "general, θ = 1e-4",
        "general, θ = 1e-6",
        "general, θ = π − 1e-2",
        "general, θ = π − 1e-4",
        "general, θ = π − 1e-6",
    ];
    let accelerations = |state: &State<f64, 3>| top.accelerations(state);
    compare(reference, names, accelerations, figures);
}

/// The error at each inclination, in the order of the data.
fn compare(
    reference: &Value,
    names: [&'static str; 6],
    accelerations: impl Fn(&State<f64, 3>) -> SVector<f64, 3>,
    figures: &mut Figures,
) {
    let keys = ["1e-2", "1e-4", "1e-6", "π-1e-2", "π-1e-4", "π-1e-6"];
    for (key, name) in keys.into_iter().zip(names) {
        for case in list(&reference["theta"][key]) {
            let [q, v, expected] = ["q", "qd", "qdd"].map(|quantity| vector(&case[quantity]));
            let found = accelerations(&State::new(0.0, q, v));
            let error = (found - expected).norm() / expected.norm();
            figures.record(name, &format!("q = {q:?}, q̇ = {v:?}"), error, TOLERANCE);
        }
    }
}

fn vector(value: &Value) -> SVector<f64, 3> {
    SVector::from_vec(numbers(value))
}
