//! An arm of three joints that motors turn, against the references, and its base parameters.

use lagrangian::nalgebra::DMatrix;
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
    regressor(j1, m2, a2, i2, m3, a3, i3, friction),
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
        let start = State::new(0.0, [0.0; 3], [0.0; 3]);
        let controlled = Problem::new(&model, start).feedback(law);
        motion.compare("arm", controlled.dynamics(), 1e-10, &mut figures);
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
        let torque = model
            .with_inputs(SVector::zeros())
            .inverse_dynamics(&state, &wanted);
        let found = model.with_inputs(torque).accelerations(&state);
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
        let (state, torque) = (random.state(), random.array::<3>(-5.0, 5.0));
        let outputs = model.with_inputs(torque).outputs(&state);
        let [yaw, shoulder, elbow] = state.q.into();
        let reach = 0.4 * shoulder.cos() + 0.8 * (shoulder + elbow).cos();
        let height = 0.4 * shoulder.sin() + 0.8 * (shoulder + elbow).sin();
        let tip = [reach * yaw.cos(), reach * yaw.sin(), height];
        assert_close("tip", outputs.tip.as_slice(), &tip, 1e-14);

        let accelerations = model.with_inputs(torque).accelerations(&state);
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

/// How many singular values count, which has to be seen from a gap between them and rounding errors.
fn rank(matrix: &DMatrix<f64>) -> usize {
    let values = matrix.singular_values();
    let largest = values.max();
    let count = |bound: f64| values.iter().filter(|x| **x > bound * largest).count();
    assert_eq!(count(1e-10), count(1e-4), "{values}");
    count(1e-10)
}

/// T and V of unit inertial parameters, in which they are linear: j₁, then m, m a and i + m a² of either link.
fn energies(state: &State<f64, 3>, l: f64, g: f64) -> ([f64; 7], [f64; 7]) {
    let ([_, shoulder, elbow], [yaw, up, bend]) = (state.q.into(), state.v.into());
    let [(s, c), (s_lower, c_lower)] = [shoulder, shoulder + elbow].map(f64::sin_cos);
    let lower_rate: f64 = up + bend;
    let upper = up.powi(2) + (yaw * c).powi(2);
    let lower = lower_rate.powi(2) + (yaw * c_lower).powi(2);
    let both = up * lower_rate * elbow.cos() + yaw.powi(2) * c * c_lower;
    let half = [
        yaw.powi(2),
        0.0,
        0.0,
        upper,
        l * l * upper,
        2.0 * l * both,
        lower,
    ];
    let potential = [0.0, 0.0, g * s, 0.0, g * l * s, g * s_lower, 0.0];
    (half.map(|x| 0.5 * x), potential)
}

/// The arm with the seven numbers in which its energies are linear.
fn linear(model: &RobotArm) -> [f64; 7] {
    let moments = |m: f64, a: f64, i: f64| [m, m * a, i + m * a * a];
    let [[m2, ma2, ii2], [m3, ma3, ii3]] = [
        moments(model.m2, model.a2, model.i2),
        moments(model.m3, model.a3, model.i3),
    ];
    [model.j1, m2, ma2, ii2, m3, ma3, ii3]
}

/// Eight: five of the energies, and the friction of three joints. Any bodies on these joints would have the fifteen of
/// `tests/base_parameters.rs`; slender links in a plane through the first axis are symmetric, which leaves these five.
///
/// That base parameters are as many as the columns of the energies that are independent is of M. Gautier and W. Khalil,
/// Direct calculation of minimum set of inertial parameters of serial robots, 1990.
#[test]
fn base_parameters_are_as_many_as_the_ranks_of_the_regressor_and_of_the_energies() {
    let model = arm(|name| if name == "g" { 9.81 } else { 0.4 });
    let mut random = Random::default();
    let motions = 60;
    let mut stacked = DMatrix::zeros(3 * motions, RobotArm::BASE_PARAMETERS.len());
    let mut samples = DMatrix::zeros(2 * motions, 7);
    for motion in 0..motions {
        let state: State<f64, 3> = random.state();
        let accelerations: SVector<f64, 3> = random.array(-5.0, 5.0).into();
        let torque = SVector::zeros();
        let rows = model.with_inputs(torque).regressor(&state, &accelerations);
        stacked.rows_mut(3 * motion, 3).copy_from(&rows);
        let forces = model
            .with_inputs(torque)
            .inverse_dynamics(&state, &accelerations);
        let found = rows * model.base_parameters();
        assert_close("forces", found.as_slice(), forces.as_slice(), 1e-13);

        let (kinetic, potential) = energies(&state, model.l2, model.g);
        let sum = |of: [f64; 7]| std::iter::zip(of, linear(&model)).map(|(x, y)| x * y).sum();
        let (t, v) = (model.kinetic_energy(&state), model.potential_energy(&state));
        assert_close("energies", &[t, v], &[sum(kinetic), sum(potential)], 1e-13);
        for (row, values) in [(2 * motion, kinetic), (2 * motion + 1, potential)] {
            samples.row_mut(row).copy_from_slice(&values);
        }
    }
    let frictions = model.friction.len();
    assert_eq!(rank(&samples), 5);
    assert_eq!(rank(&stacked), 5 + frictions);
    assert_eq!(RobotArm::BASE_PARAMETERS.len(), 5 + frictions);
}
