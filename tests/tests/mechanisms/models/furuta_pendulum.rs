//! Furuta's pendulum: a motor turns an arm, and at the end of it swings a rod, against the closed form.

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, Random, relative_error};
use nalgebra::{Matrix2, Vector2};

/// The arm turns about the vertical; the rod turns about the arm, hanging at 0. Both are slender.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(arm, rod),
    define(
        turn = rotation_z(arm),
        along = turn * [1.0, 0.0, 0.0],
        down = turn * [0.0, sin(rod), -cos(rod)],
        center = length * along + l * down,
    ),
    kinetic = 0.5 * inertia_arm * dot(along).norm_squared()
        + 0.5 * m * dot(center).norm_squared()
        + 0.5 * inertia_rod * dot(down).norm_squared(),
    potential = m * g * center.z,
    force(arm = torque),
    output(power = torque * dot(arm)),
)]
struct FurutaPendulum {
    inertia_arm: f64,
    inertia_rod: f64,
    m: f64,
    length: f64,
    l: f64,
    g: f64,
    #[lagrangian(input)]
    torque: f64,
}

#[test]
fn it_follows_the_closed_form() {
    let mut figures = Figures::new();
    let mut random = Random::default();
    for _ in 0..200 {
        let [inertia_arm, inertia_rod, m, length, l] = random.array(0.3, 1.5);
        let model = FurutaPendulum {
            inertia_arm,
            inertia_rod,
            m,
            length,
            l,
            g: 9.81,
            torque: 0.0,
        };
        let (state, torque) = (random.state(), random.between(-5.0, 5.0));
        let found = model.with_inputs([torque]).accelerations(&state);
        let expected = closed_form(&model, &state, torque);
        let error = relative_error(found.as_slice(), expected.as_slice(), 1.0);
        figures.record("accelerations", &format!("{state:?}"), error, 1e-12);
        let power = model.with_inputs([torque]).outputs(&state).power;
        figures.record(
            "power",
            &format!("{state:?}"),
            (power - torque * state.v[0]).abs(),
            1e-14,
        );
    }
    figures.finish();
}

fn closed_form(model: &FurutaPendulum, state: &State<f64, 2>, torque: f64) -> Vector2<f64> {
    let ((s, c), [arm, rod]) = (state.q[1].sin_cos(), state.v.into());
    let alpha = model.inertia_arm + model.m * model.length.powi(2);
    let beta = model.inertia_rod + model.m * model.l.powi(2);
    let gamma = model.m * model.length * model.l;
    let mass = Matrix2::new(alpha + beta * s * s, gamma * c, gamma * c, beta);
    let forcing = Vector2::new(
        torque - 2.0 * beta * s * c * arm * rod + gamma * s * rod.powi(2),
        beta * s * c * arm.powi(2) - model.m * model.g * model.l * s,
    );
    mass.lu().solve(&forcing).expect("M is positive definite")
}
