//! The committed expansions of the derive, compiled as they stand: they give the same numbers, to the
//! bit, as what the derive emits today.

// The expansions are as public as the structs that they are of, and as long as they are.
#![allow(
    unreachable_pub,
    clippy::inline_always,
    clippy::let_and_return,
    clippy::redundant_static_lifetimes,
    clippy::too_many_lines,
    clippy::unused_self
)]

use lagrangian::prelude::*;
use lagrangian::quantities::{Energies, StateJacobian};

/// The declarations, expanded by the derive.
mod derived {
    use lagrangian::Lagrangian;

    include!("../../../derive/golden/heavy_top/declaration.rs");
    include!("../../../derive/golden/driven_pendulum/declaration.rs");
    include!("../../../derive/golden/slider/declaration.rs");
}

/// The same structs without the derive, and the committed expansions.
mod committed {
    pub struct HeavyTop {
        pub i1: f64,
        pub i2: f64,
        pub i3: f64,
        pub m: f64,
        pub g: f64,
        pub l: f64,
    }

    pub struct DrivenPendulum {
        pub m: f64,
        pub g: f64,
        pub l: f64,
        pub friction: f64,
        pub torque: f64,
    }

    pub struct Slider {
        pub m: f64,
        pub k: f64,
        pub weight: f64,
        pub width: f64,
    }

    include!("../../../derive/golden/heavy_top/expansion.rs");
    include!("../../../derive/golden/driven_pendulum/expansion.rs");
    include!("../../../derive/golden/slider/expansion.rs");
}

/// The heavy top once more, in few scopes.
#[allow(dead_code)] // Its methods alone are compared.
mod in_few_scopes {
    pub struct HeavyTop {
        pub i1: f64,
        pub i2: f64,
        pub i3: f64,
        pub m: f64,
        pub g: f64,
        pub l: f64,
    }

    include!("../../../derive/golden/heavy_top/in_few_scopes.rs");
}

/// The same as if there were many coordinates: matrices are computed column by column.
#[allow(dead_code)] // Its methods alone are compared.
mod by_columns {
    pub struct HeavyTop {
        pub i1: f64,
        pub i2: f64,
        pub i3: f64,
        pub m: f64,
        pub g: f64,
        pub l: f64,
    }

    pub struct DrivenPendulum {
        pub m: f64,
        pub g: f64,
        pub l: f64,
        pub friction: f64,
        pub torque: f64,
    }

    include!("../../../derive/golden/heavy_top/by_columns.rs");
    include!("../../../derive/golden/driven_pendulum/by_columns.rs");
}

/// All that a model computes at a state.
fn numbers<const N: usize>(
    model: &impl Lagrangian<N, Model: Energies<N> + StateJacobian<N>>,
    state: &State<f64, N>,
) -> Vec<f64> {
    let accelerations = model.accelerations(state);
    let linearization = model.linearize(state);
    let mut numbers = vec![
        model.lagrangian(state),
        model.energy(state),
        model.kinetic_energy(state),
        model.potential_energy(state),
    ];
    numbers.extend(model.momenta(state).iter());
    numbers.extend(model.mass_matrix(state).iter());
    numbers.extend(model.forcing(state).iter());
    numbers.extend(model.generalized_forces(state).iter());
    numbers.extend(accelerations.iter());
    numbers.extend(
        model
            .inverse_dynamics(state, &accelerations.add_scalar(1.0))
            .iter(),
    );
    numbers.extend(model.relative_pivots(state).iter());
    numbers.extend(linearization.position.iter());
    numbers.extend(linearization.velocity.iter());
    numbers.extend(linearization.time.iter());
    numbers
}

/// Panics unless both computed the same finite numbers, to some roundings.
#[track_caller]
fn assert_near(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        let error = (found - expected).abs() / (1.0 + expected.abs());
        assert!(error < 1e-13, "{found} is not {expected}");
    }
}

/// Panics unless both computed the same finite numbers.
#[track_caller]
fn assert_same(derived: &[f64], committed: &[f64]) {
    assert!(
        derived.iter().all(|number| number.is_finite()),
        "{derived:?}"
    );
    let bits = |numbers: &[f64]| -> Vec<u64> { numbers.iter().map(|x| x.to_bits()).collect() };
    assert_eq!(
        bits(derived),
        bits(committed),
        "{derived:?} is not {committed:?}"
    );
}

#[test]
fn the_committed_heavy_top_computes_what_the_derived_one_does() {
    macro_rules! top {
        ($module:ident) => {
            $module::HeavyTop {
                i1: 1.0,
                i2: 1.5,
                i3: 2.0,
                m: 0.7,
                g: 9.81,
                l: 0.1,
            }
        };
    }
    let state = State::new(0.0, [0.1, 0.5, 0.2], [0.3, -0.4, 20.0]);
    assert_same(
        &numbers(&top!(derived), &state),
        &numbers(&top!(committed), &state),
    );
    // How variables are declared is no matter of numbers.
    assert_same(
        &numbers(&top!(derived), &state),
        &numbers(&top!(in_few_scopes), &state),
    );
    assert_eq!(derived::HeavyTop::EQUATIONS, committed::HeavyTop::EQUATIONS);
    assert_eq!(derived::HeavyTop::LATEX, committed::HeavyTop::LATEX);
    assert_eq!(
        derived::HeavyTop::OPERATIONS,
        committed::HeavyTop::OPERATIONS
    );
    assert_eq!(
        derived::HeavyTop::CONSERVES_ENERGY,
        committed::HeavyTop::CONSERVES_ENERGY
    );
    assert_eq!(
        [
            derived::HeavyTop::PHI,
            derived::HeavyTop::THETA,
            derived::HeavyTop::PSI
        ],
        [
            committed::HeavyTop::PHI,
            committed::HeavyTop::THETA,
            committed::HeavyTop::PSI
        ],
    );
}

#[test]
fn the_committed_slider_computes_what_the_derived_one_does() {
    macro_rules! slider {
        ($module:ident) => {
            $module::Slider {
                m: 0.7,
                k: 3.0,
                weight: 6.9,
                width: 0.1,
            }
        };
    }
    let (derived, committed) = (slider!(derived), slider!(committed));
    let state = State::new(0.0, [0.5], [-0.04]);
    assert_same(&numbers(&derived, &state), &numbers(&committed, &state));
    macro_rules! functions {
        ($model:expr) => {
            [
                $model.function(0, &[0.3, 2.0]),
                $model.derivative(0, 0, &[0.3, 2.0]).unwrap(),
                $model.derivative(0, 1, &[0.3, 2.0]).unwrap(),
            ]
        };
    }
    assert_same(&functions!(derived), &functions!(committed));
    assert!(committed.function(0, &[0.3]).is_nan() && committed.function(2, &[0.3]).is_nan());
    assert_eq!(committed.derivative(0, 2, &[0.3, 2.0]), None);
    assert_eq!(committed.derivative(1, 0, &[0.3]), Some(0.0));
    let region = || [-3.0..=3.0, 0.0..=10.0];
    assert_eq!(committed.check_derivatives("friction", region()), Ok(()));
    assert_eq!(derived::Slider::X, committed::Slider::X);
    assert_eq!(derived::Slider::EQUATIONS, committed::Slider::EQUATIONS);
    assert_eq!(derived::Slider::LATEX, committed::Slider::LATEX);
    assert_eq!(derived::Slider::OPERATIONS, committed::Slider::OPERATIONS);
}

#[test]
fn the_committed_pendulum_computes_what_the_derived_one_does() {
    macro_rules! pendulum {
        ($module:ident) => {
            $module::DrivenPendulum {
                m: 0.7,
                g: 9.81,
                l: 0.3,
                friction: 0.05,
                torque: 0.2,
            }
        };
    }
    let (derived, committed) = (pendulum!(derived), pendulum!(committed));
    let state = State::new(0.0, [0.5], [-0.4]);
    assert_same(&numbers(&derived, &state), &numbers(&committed, &state));
    macro_rules! driven {
        ($model:expr) => {{
            let (model, inputs) = (&$model, [0.7]);
            let outputs = model.outputs(&state);
            [
                outputs.height,
                outputs.acceleration,
                model.with_inputs(inputs).accelerations(&state)[0],
                model.inputs()[0],
                model.input_jacobian(&state)[0],
                model.with_inputs(inputs).linearize(&state).position[0],
            ]
        }};
    }
    assert_same(&driven!(derived), &driven!(committed));
    assert_eq!(
        derived::DrivenPendulum::EQUATIONS,
        committed::DrivenPendulum::EQUATIONS
    );
    assert_eq!(
        derived::DrivenPendulum::LATEX,
        committed::DrivenPendulum::LATEX
    );
    assert_eq!(
        derived::DrivenPendulum::THETA,
        committed::DrivenPendulum::THETA
    );
    assert_eq!(
        derived::DrivenPendulum::TORQUE,
        committed::DrivenPendulum::TORQUE
    );
    assert_eq!(
        derived::DrivenPendulum::OPERATIONS,
        committed::DrivenPendulum::OPERATIONS
    );
}

#[test]
fn matrices_are_the_same_column_by_column() {
    macro_rules! top {
        ($module:ident) => {
            $module::HeavyTop {
                i1: 1.0,
                i2: 1.5,
                i3: 2.0,
                m: 0.7,
                g: 9.81,
                l: 0.1,
            }
        };
    }
    macro_rules! pendulum {
        ($module:ident) => {
            $module::DrivenPendulum {
                m: 0.7,
                g: 9.81,
                l: 0.3,
                friction: 0.05,
                torque: 0.2,
            }
        };
    }
    let state = State::new(0.0, [0.1, 0.5, 0.2], [0.3, -0.4, 20.0]);
    let (found, expected) = (top!(by_columns), top!(derived));
    assert_near(&numbers(&found, &state), &numbers(&expected, &state));
    let state = State::new(0.0, [0.5], [-0.4]);
    let (found, expected) = (pendulum!(by_columns), pendulum!(derived));
    assert_near(&numbers(&found, &state), &numbers(&expected, &state));
    let inputs = [0.7];
    assert_near(
        found.with_inputs(inputs).input_jacobian(&state).as_slice(),
        expected
            .with_inputs(inputs)
            .input_jacobian(&state)
            .as_slice(),
    );
    assert_near(
        found
            .with_inputs(inputs)
            .linearize(&state)
            .position
            .as_slice(),
        expected
            .with_inputs(inputs)
            .linearize(&state)
            .position
            .as_slice(),
    );
}
