//! Jacobians, against central differences, against each other and against a matrix.

use lagrangian::nalgebra::SVector;
use lagrangian::prelude::*;
use lagrangian::{Dual, Dynamics, Phase, Scalar};
use lagrangian_solvers::{Jacobian, OdeSystem, OnDuals};

use crate::closeness::error;
use crate::models::{Balanced, CartPole, Spring, balance, cart_pole, top, van_der_pol};

/// The Jacobian of a system, row by row.
fn exact<D, J>(system: &OdeSystem<D, J>, t: f64, x: &[f64]) -> Vec<f64>
where
    D: Dynamics,
    J: Jacobian<State = D::State>,
{
    let mut rows = vec![f64::NAN; x.len() * x.len()];
    system.jacobian(t, x, &mut rows).unwrap();
    rows
}

/// The same by central differences of fourth order, whose step balances h⁴ and ε/h.
fn differences<D: Dynamics, J>(system: &OdeSystem<D, J>, t: f64, x: &[f64]) -> Vec<f64> {
    let size = x.len();
    let mut rows = vec![f64::NAN; size * size];
    for column in 0..size {
        let h = 1e-3 * x[column].abs().max(0.1);
        let at = |steps: f64| {
            let (mut moved, mut derivative) = (x.to_vec(), vec![f64::NAN; size]);
            moved[column] += steps * h;
            system.derivative(t, &moved, &mut derivative).unwrap();
            derivative
        };
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(at);
        for row in 0..size {
            rows[row * size + column] =
                (a[row] - 8.0 * b[row] + 8.0 * c[row] - d[row]) / (12.0 * h);
        }
    }
    rows
}

/// Some states near the initial one.
fn states(initial: &[f64]) -> impl Iterator<Item = Vec<f64>> {
    (0_u32..20).map(move |sample| {
        let mut angle = f64::from(sample);
        let shifted = initial.iter().map(|x| {
            angle += 1.7;
            x + 0.3 * angle.sin()
        });
        shifted.collect()
    })
}

fn assert_exact<D, J>(system: &OdeSystem<D, J>, tolerance: f64)
where
    D: Dynamics,
    J: Jacobian<State = D::State>,
{
    for x in states(&system.initial()) {
        let (found, expected) = (exact(system, 0.7, &x), differences(system, 0.7, &x));
        let error = error(&found, &expected);
        assert!(
            error <= tolerance,
            "{error:e} at {x:?}: {found:?} is not {expected:?}"
        );
    }
}

#[test]
fn models_have_the_jacobian_of_their_linearization() {
    let (model, start) = top();
    assert_exact(&OdeSystem::new(&model, start).unwrap(), 1e-9);
    let (model, start, _) = van_der_pol();
    assert_exact(&OdeSystem::new(&model, start).unwrap(), 1e-9);
    let (model, start) = cart_pole();
    assert_exact(&OdeSystem::new(&model, start).unwrap(), 1e-9);
    assert_exact(
        &OdeSystem::new(&model.with_inputs(7.0), start).unwrap(),
        1e-9,
    );
}

#[test]
fn a_law_is_differentiated_with_its_model() {
    let (model, start) = cart_pole();
    let balanced = Balanced(&model);
    let system = OdeSystem::new(&balanced, start)
        .unwrap()
        .jacobian_by(&balanced);
    assert_exact(&system, 1e-8);
    // The push, which changes with the state, is not held.
    let held = model.with_inputs(balance(&start));
    let held = OdeSystem::new(&held, start).unwrap();
    let upright = [0.0; 4];
    let (changing, held) = (exact(&system, 0.0, &upright), exact(&held, 0.0, &upright));
    // ∂ẍ/∂ẋ is 30 · 6 over the mass of the cart.
    assert!(
        (changing[2 * 4 + 2] - held[2 * 4 + 2] - 180.0).abs() < 1e-10,
        "{changing:?}"
    );
}

#[test]
fn dual_numbers_and_linearizations_agree() {
    let (model, start) = top();
    let derived = OdeSystem::new(&model, start).unwrap();
    let on_duals = model.dynamics();
    let automatic = derived.clone().jacobian_by(on_duals);
    for x in states(&derived.initial()) {
        assert!(error(&exact(&automatic, 0.0, &x), &exact(&derived, 0.0, &x)) < 1e-12);
    }
}

#[test]
fn a_linear_system_has_its_matrix() {
    let spring = Spring {
        rate: 4.0,
        damping: 3.0,
    };
    let start = At {
        t: 0.0,
        x: SVector::from([1.0, 2.0]),
    };
    let system = OdeSystem::new(&spring, start).unwrap().jacobian_by(&spring);
    assert_eq!(exact(&system, 0.0, &[1.0, 2.0]), [0.0, 1.0, -4.0, -3.0]);
}

/// A cart whose law has a state z: the integral of its position.
struct Integrating<'a>(&'a CartPole);

impl<S: Scalar> Dynamics<S> for Integrating<'_> {
    type State = Phase<S, 2, SVector<S, 1>>;

    fn derivative(&self, t: S, x: &Self::State) -> Self::State {
        let state = At { t, x: x.motion() };
        let push = balance(&state) + x.z[0] * x.z[0];
        Phase {
            q: x.v,
            v: self.0.with_inputs(push).accelerations(&state),
            z: SVector::from([x.q[0] * x.v[1]]),
        }
    }
}

#[test]
fn states_of_controllers_are_components() {
    let (model, start) = cart_pole();
    let law = Integrating(&model);
    let start: State<f64, 2, SVector<f64, 1>> = (start, [0.4]).into();
    let system = OdeSystem::new(&law, start).unwrap().jacobian_by(&law);
    assert_eq!(system.size(), 5);
    assert_exact(&system, 1e-8);
}

#[test]
fn states_keep_their_components_on_dual_numbers() {
    use lagrangian::{CanonicalPhase, VectorSpace};

    fn assert_constant<X: OnDuals>(x: &X) {
        let duals: Vec<Dual> = x.on_duals().components().collect();
        let numbers: Vec<f64> = x.components().collect();
        assert_eq!(duals.len(), numbers.len());
        for (dual, number) in duals.iter().zip(numbers) {
            assert_eq!((dual.value, dual.derivative), (number, [0.0]));
        }
    }
    let (q, v) = (SVector::from([1.0, 2.0]), SVector::from([3.0, 4.0]));
    assert_constant(&q);
    assert_constant(&Phase::new(q, v));
    assert_constant(&CanonicalPhase { q, p: v });
    let z = SVector::from([5.0]);
    assert_constant(&Phase { q, v, z });
}
