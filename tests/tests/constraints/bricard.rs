//! Bricard's mechanism as it is drawn, with more constraints than are independent, against data with 24 digits (`data/README.md`).

// The matrix of its equations has 60 rows.
#![allow(clippy::large_stack_arrays)]

use lagrangian::nalgebra::{Matrix3, Vector3};
use lagrangian::prelude::*;
use lagrangian::rigid_body::{InertiaTensor, RigidBody};
use lagrangian_tests::{Figures, array, bricard, list, number, relative_error, text};
use serde_json::Value;

/// Bricard's mechanism as it is drawn: five rods, each with a place and three angles, and six revolute joints with five
/// constraints each.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(p[5]: Vector3, a[5], b[5], c[5]),
    define(
        r[0] = rotation_yzx(a[0], b[0], c[0]),
        r[1] = rotation_yxz(a[1], b[1], c[1]),
        r[2] = rotation_yzx(a[2], b[2], c[2]),
        r[3] = rotation_zxy(a[3], b[3], c[3]),
        r[4] = rotation_zyx(a[4], b[4], c[4]),
        end[i] = p[i] + r[i] * edges[i] for i in 0..5,
    ),
    body(rods[i] = (r[i], p[i]) for i in 0..5),
    gravity = [0.0, -g, 0.0],
    constraint(
        pin[0] = p[0],
        pin[i] = p[i] - end[i - 1] for i in 1..5,
        pin[5] = end[4] - [0.0, 0.0, 1.0],
        axis[0] = [r[0][(0, 1)], r[0][(2, 1)]],
        axis[1] = [r[0].column(0).dot(r[1].column(2)), r[0].column(1).dot(r[1].column(2))],
        axis[2] = [r[1].column(1).dot(r[2].column(0)), r[1].column(2).dot(r[2].column(0))],
        axis[3] = [r[2].column(2).dot(r[3].column(1)), r[2].column(0).dot(r[3].column(1))],
        axis[4] = [r[3].column(0).dot(r[4].column(2)), r[3].column(1).dot(r[4].column(2))],
        axis[5] = [r[4][(1, 0)], r[4][(2, 0)]],
    ),
)]
struct Bricard {
    rods: [RigidBody; 5],
    edges: [Vector3<f64>; 5],
    g: f64,
}

impl Bricard {
    fn of(parameters: &Value) -> Self {
        let [m, across, along, g] = ["m", "it", "ia", "g"].map(|name| number(&parameters[name]));
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
        let edges = [x, -y, z, -x, y];
        let rods = edges.map(|edge| {
            let axial = edge * edge.transpose();
            let inertia = across * (Matrix3::identity() - axial) + along * axial;
            let inertia = InertiaTensor::from_matrix(&inertia).expect("it is symmetric");
            RigidBody::new(m, 0.5 * edge, inertia).expect("it is a body")
        });
        Self { rods, edges, g }
    }
}

/// The largest difference, of numbers of which the largest is the unit.
fn difference(found: &[f64], expected: &[f64]) -> f64 {
    let size = expected.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
    relative_error(found, expected, size)
}

fn check(
    figures: &mut Figures,
    model: &Bricard,
    state: &State<f64, 30>,
    sample: &Value,
    tolerance: f64,
) {
    let at = text(&sample["t"]);
    let accelerations: [f64; 30] = array(&sample["qdd"]);
    let multipliers: [f64; 30] = array(&sample["lambda"]);
    for (quantity, found, expected) in [
        ("q̈", model.accelerations(state), accelerations),
        ("λ", model.multipliers(state), multipliers),
    ] {
        figures.record(
            quantity,
            at,
            difference(found.as_slice(), &expected),
            tolerance,
        );
    }
}

#[test]
fn accelerations_and_least_multipliers_are_those_of_the_pseudo_inverse() {
    let document = bricard();
    let model = Bricard::of(&document["params"]);
    let mut figures = Figures::new();
    for sample in list(&document["samples"]) {
        let [q, v] = ["q", "qd"].map(|name| array(&sample[name]));
        let state = State::new(number(&sample["t"]), q, v);
        let freedom = model.degrees_of_freedom(&state);
        assert_eq!((freedom.coordinates, freedom.velocities), (1, 1));
        assert_eq!(freedom.redundant_constraints().count(), 1);
        check(&mut figures, &model, &state, sample, 1e-12);
    }
    figures.finish();
}

/// The motion at the times of the data up to an end, and its energy.
fn follow(end: f64) -> Result<(), IntegrationError> {
    let document = bricard();
    let model = Bricard::of(&document["params"]);
    let samples = list(&document["samples"]).iter();
    let samples: Vec<_> = samples.filter(|one| number(&one["t"]) <= end).collect();
    let times: Vec<f64> = samples.iter().map(|one| number(&one["t"])).collect();
    let mut figures = Figures::new();
    let start = State::new(0.0, array(&samples[0]["q"]), [0.0; 30]);
    let problem = Problem::new(&model, start).save(times);
    let motion = problem.solve(end, Taylor::new())?;
    let energy = model.energy(&start);
    for state in motion.samples().iter().chain([&motion.last]) {
        let error = (model.energy(state) / energy - 1.0).abs();
        figures.record("energy", &state.t.to_string(), error, 1e-12);
    }
    assert_eq!(motion.samples().len(), samples.len());
    for (state, sample) in motion.samples().iter().zip(samples) {
        for (quantity, found) in [("q", &state.q), ("qd", &state.v)] {
            let expected: [f64; 30] = array(&sample[quantity]);
            let error = difference(found.as_slice(), &expected);
            figures.record(quantity, text(&sample["t"]), error, 1e-9);
        }
        check(&mut figures, &model, state, sample, 1e-9);
    }
    figures.finish();
    Ok(())
}

#[test]
fn the_mechanism_moves_as_its_two_angles_do() -> Result<(), IntegrationError> {
    follow(1.0)
}

#[test]
#[ignore = "without optimization it takes 20 s; run with `--include-ignored`"]
fn the_mechanism_keeps_its_energy_over_many_turns() -> Result<(), IntegrationError> {
    follow(10.0)
}
