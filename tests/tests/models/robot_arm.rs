//! An arm of three joints that motors turn, against the references.

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, Random, assert_close, motions};

/// Yaw, shoulder and elbow; two slender links of unit directions `upper` and `lower`.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[3]),
    define(
        turn = rotation_z(q[0]),
        upper = turn * [cos(q[1]), 0.0, sin(q[1])],
        lower = turn * [cos(q[1] + q[2]), 0.0, sin(q[1] + q[2])],
        elbow = l2 * upper,
        c2 = a2 * upper,
        c3 = elbow + a3 * lower,
        rates = (0..3).map(|i| dot(q[i])).collect(),
    ),
    kinetic = 0.5 * j1 * dot(q[0]).powi(2),
    kinetic = 0.5 * (m2 * dot(c2).norm_squared() + i2 * dot(upper).norm_squared()),
    kinetic = 0.5 * (m3 * dot(c3).norm_squared() + i3 * dot(lower).norm_squared()),
    potential = g * (m2 * c2.z + m3 * c3.z),
    dissipation = 0.5 * rates.dot(friction.component_mul(rates)),
    force(q[i] = torque[i] for i in 0..3),
    output(tip = elbow + 2.0 * a3 * lower, velocity = dot(elbow + 2.0 * a3 * lower), power = torque.dot(rates)),
)]
pub(super) struct RobotArm {
    j1: f64,
    m2: f64,
    m3: f64,
    l2: f64,
    a2: f64,
    a3: f64,
    i2: f64,
    i3: f64,
    g: f64,
    friction: [f64; 3],
    #[lagrangian(input)]
    torque: SVector<f64, 3>,
}

fn arm(value: impl Fn(&str) -> f64) -> RobotArm {
    RobotArm {
        j1: value("j1"),
        m2: value("m2"),
        m3: value("m3"),
        l2: value("l2"),
        a2: value("a2"),
        a3: value("a3"),
        i2: value("i2"),
        i3: value("i3"),
        g: value("g"),
        friction: ["b1", "b2", "b3"].map(value),
        torque: SVector::zeros(),
    }
}

#[test]
fn it_moves_as_the_references() {
    let mut figures = Figures::new();
    for motion in motions("robot_arm_3dof") {
        let model = arm(|name| motion.parameter(name));
        let [k1, k2, k3, w] = motion.parameters(["k1", "k2", "k3", "w"]);
        let law = |state: &State<f64, 3>| {
            let (sin, cos) = (w * state.t).sin_cos();
            [k1 * sin, k2 * cos, k3]
        };
        motion.compare("arm", &model.controlled_by(law), 1e-10, &mut figures);
    }
    figures.finish();
}

/// The torques that are computed for an acceleration give this acceleration.
#[test]
fn torques_are_computed_for_accelerations() {
    let model = arm(|name| if name == "g" { 9.81 } else { 0.4 });
    let mut random = Random::default();
    for _ in 0..100 {
        let (state, wanted) = (random.state(), random.array(-5.0, 5.0).into());
        let torque = model.inverse_dynamics_with(&state, &SVector::zeros(), &wanted);
        let found = model.accelerations_with(&state, &torque);
        assert_close("accelerations", found.as_slice(), wanted.as_slice(), 1e-12);
    }
}

/// The tip is where trigonometry has it and moves as it changes its place, and the power goes into energy
/// and friction.
#[test]
fn outputs_are_those_of_elementary_mechanics() {
    let model = arm(|name| if name == "g" { 9.81 } else { 0.4 });
    let mut random = Random::default();
    for _ in 0..100 {
        let (state, torque) = (random.state(), random.array(-5.0, 5.0).into());
        let outputs = model.outputs_with(&state, &torque);
        let [yaw, shoulder, elbow] = state.q.into();
        let reach = 0.4 * shoulder.cos() + 0.8 * (shoulder + elbow).cos();
        let height = 0.4 * shoulder.sin() + 0.8 * (shoulder + elbow).sin();
        let tip = [reach * yaw.cos(), reach * yaw.sin(), height];
        assert_close("tip", outputs.tip.as_slice(), &tip, 1e-14);

        let accelerations = model.accelerations_with(&state, &torque);
        let later = |step: f64| {
            let q = state.q + state.v * step + accelerations * (0.5 * step.powi(2));
            State::new(0.0, q, state.v + accelerations * step)
        };
        let (step, [before, after]) = (1e-5, [later(-1e-5), later(1e-5)]);
        let path = model.outputs(&after).tip - model.outputs(&before).tip;
        let velocity = path / (2.0 * step);
        assert_close(
            "velocity",
            outputs.velocity.as_slice(),
            velocity.as_slice(),
            1e-7,
        );
        let work = model.energy(&after) - model.energy(&before);
        let friction = 0.4 * state.v.norm_squared();
        let power = [work / (2.0 * step) + friction];
        assert_close("power", &[outputs.power], &power, 1e-7);
    }
}
