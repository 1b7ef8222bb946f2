//! The inputs of given motions of mechanisms.

use lagrangian::analysis::{RequiredInputs, RequiredInputsError, StateSpace, TangentSpace};
use lagrangian::prelude::*;

/// A four-bar linkage with motors at both joints of the frame and one between the crank and the coupler.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(crank, coupler, rocker),
    define(
        pin = [cos(crank), sin(crank)],
        arm = [2.5 * cos(coupler), 2.5 * sin(coupler)],
        end = [3.0 + 2.0 * cos(rocker), 2.0 * sin(rocker)],
        middle = pin + 0.5 * arm,
    ),
    kinetic = m * (dot(crank).powi(2) + 4.0 * dot(rocker).powi(2)) / 6.0,
    kinetic = 0.5 * m * (dot(middle).norm_squared() + 6.25 / 12.0 * dot(coupler).powi(2)),
    potential = m * g * middle.y,
    force(crank = torque.x - torque.z, rocker = torque.y, coupler = torque.z),
    constraint(joint = pin + arm - end),
)]
struct Linkage {
    m: f64,
    g: f64,
    #[lagrangian(input)]
    torque: Vector3<f64>,
}

/// A knife on the ice, which is pushed along.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, theta),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)) + 0.5 * inertia * dot(theta).powi(2),
    force(x = push * cos(theta), y = push * sin(theta)),
    nonholonomic(knife = -sin(theta) * dot(x) + cos(theta) * dot(y)),
)]
struct Knife {
    m: f64,
    inertia: f64,
    #[lagrangian(input)]
    push: f64,
}

fn linkage() -> (Linkage, State<f64, 3>) {
    let linkage = Linkage {
        m: 0.4,
        g: 9.81,
        torque: Vector3::zeros(),
    };
    let guess = State::new(0.0, [0.9, 0.2, 1.5], [1.7, 0.0, 0.0]);
    let held = [Linkage::CRANK];
    let found = linkage
        .assemble(guess)
        .hold(held)
        .hold_velocities(held)
        .solve();
    (linkage, found.expect("it closes").state)
}

/// Of all torques with the same motion, those that are found are the smallest, and the motion is the one that was asked for.
#[test]
fn the_smallest_torques_of_a_linkage() {
    let (linkage, state) = linkage();
    let other = Vector3::new(0.7, -1.1, 0.4);
    let accelerations = linkage.with_inputs(other).accelerations(&state);
    let found =
        RequiredInputs::of(&linkage, &state, &accelerations, [1.0; 3]).expect("one freedom");
    let there = linkage.with_inputs(found.inputs);
    assert!((there.accelerations(&state) - accelerations).amax() < 1e-12);
    assert!((there.multipliers(&state) - found.multipliers).amax() < 1e-12);
    // The gradient of the motion by the torques: what is orthogonal to it has no effect.
    let slopes = linkage
        .input_jacobian(&state)
        .row(Linkage::CRANK)
        .transpose();
    let smallest = slopes * (slopes.dot(&other) / slopes.norm_squared());
    assert!((found.inputs - smallest).amax() < 1e-12 && smallest.norm() < 0.99 * other.norm());
    // M q̈ − f − Gᵀ λ, by a way of its own.
    let forces = there.inverse_dynamics(&state, &accelerations);
    let reactions = linkage.constraint_jacobian(&state).transpose() * found.multipliers;
    assert!((forces - reactions).amax() < 1e-12);
}

/// Of all torques with the same motion, Σ wᵢ uᵢ² is least: u is W⁻¹ times the gradient of the motion by the torques.
#[test]
fn the_cheapest_torques_of_a_linkage() {
    let (linkage, state) = linkage();
    let other = Vector3::new(0.7, -1.1, 0.4);
    let accelerations = linkage.with_inputs(other).accelerations(&state);
    let slopes = linkage
        .input_jacobian(&state)
        .row(Linkage::CRANK)
        .transpose();
    for weights in [[1.0, 4.0, 0.25], [1e-6, 1.0, 1e6], [3.0; 3]] {
        let weights = Vector3::from(weights);
        let found = RequiredInputs::of(&linkage, &state, &accelerations, weights);
        let found = found.expect("one freedom").inputs;
        let direction = slopes.component_div(&weights);
        let expected = direction * (slopes.dot(&other) / slopes.dot(&direction));
        assert!((found - expected).amax() < 1e-12, "{found} {expected}");
        let cost = |u: &Vector3<f64>| u.component_mul(&weights).dot(u);
        assert!(cost(&found) < cost(&other));
    }
    for weight in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        let error = RequiredInputs::of(&linkage, &state, &accelerations, [1.0, weight, 1.0]);
        let error = error.expect_err("no weight");
        assert!(matches!(
            error,
            RequiredInputsError::Weight { input: 1, .. }
        ));
        assert!(error.to_string().contains("the input 1 has to be positive"));
    }
}

/// The input matrix has the rows of the derived ∂q̈/∂u.
#[test]
fn the_input_matrix_of_a_linkage() {
    let (linkage, state) = linkage();
    let tangent = TangentSpace::at(&linkage, &state).along_motion();
    let tangent = tangent
        .coordinates([Linkage::ROCKER])
        .velocities([Linkage::ROCKER]);
    let plant = StateSpace::<f64, 2, 3, 2>::reduced(&tangent).expect("regular");
    let expected = linkage.input_jacobian(&state);
    assert!((plant.b.row(1) - expected.row(Linkage::ROCKER)).amax() < 1e-13);
    assert!(plant.b.row(0).amax() <= 0.0 && plant.b.row(1).amax() > 0.1);
    // Of the discrete model, to first order.
    let discrete = plant.discretized(1e-4).b;
    assert!((discrete.row(1) * 1e4 - plant.b.row(1)).amax() < 1e-2);
}

#[test]
fn what_no_inputs_do() {
    let (linkage, state) = linkage();
    let bent = Vector3::new(1.0, 0.0, 0.0);
    let error = RequiredInputs::of(&linkage, &state, &bent, [1.0; 3]).expect_err("the joint opens");
    assert!(
        matches!(error, RequiredInputsError::InconsistentAccelerations { constraint, .. } if constraint.starts_with("joint"))
    );
    let mut open = state;
    open.q[Linkage::ROCKER] += 0.1;
    let error =
        RequiredInputs::of(&linkage, &open, &bent, [1.0; 3]).expect_err("the joint is open");
    assert!(matches!(
        error,
        RequiredInputsError::InconsistentState { .. }
    ));

    let knife = Knife {
        m: 2.0,
        inertia: 0.3,
        push: 0.0,
    };
    let state = State::new(0.0, [0.0; 3], [1.5, 0.0, 0.4]);
    // Along its edge it is pushed, and ÿ is that of the turn.
    let pushed = Vector3::new(0.8, 1.5 * 0.4, 0.0);
    let found = RequiredInputs::of(&knife, &state, &pushed, [1.0]).expect("the push is enough");
    assert!((found.inputs[0] - 1.6).abs() < 1e-14 && (found.multipliers[0] - 1.2).abs() < 1e-14);
    let turned = Vector3::new(0.8, 1.5 * 0.4, 0.1);
    let error = RequiredInputs::of(&knife, &state, &turned, [1.0]).expect_err("nothing turns it");
    let expected = RequiredInputsError::TooFewInputs {
        coordinate: "theta",
        missing: 0.1,
        inputs: 1,
        freedoms: 2,
    };
    assert_eq!(error, expected);
    assert!(error.to_string().contains("1 of 2 degrees of freedom"));
}
