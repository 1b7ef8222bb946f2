//! Steady rotations and what becomes of their perturbations (3.8), against Euler's equations.

use crate::common::assert_close;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{EulerEquations, RotationState, SteadyRotation};

type V = Vector3<f64>;

#[test]
fn perturbations_of_steady_rotations() {
    let moments = [1.0, 2.0, 2.8];
    let equations = EulerEquations::principal(moments).unwrap();
    let speed = 3.0;
    for (axis, kind) in SteadyRotation::about_axes(moments, speed)
        .into_iter()
        .enumerate()
    {
        let [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
        let mut omega = V::zeros();
        omega[axis] = speed;
        omega[next] = 1e-8;
        let start = At::from((0.0, RotationState::aligned(omega)));
        let at = |time: f64| {
            let end = Problem::new(&equations, start).solve(time, Taylor::new());
            end.unwrap().angular_velocity
        };
        match kind {
            SteadyRotation::Stable { frequency } => {
                // Half a period later, the perturbation is the opposite one.
                let found = at(std::f64::consts::PI / frequency);
                assert_close(found[next] / -1e-8, 1.0, 1e-6);
                assert_close(found[last] / 1e-8, 0.0, 1e-6);
            }
            SteadyRotation::Unstable { growth_rate } => {
                let found = at(2.0 / growth_rate);
                assert_close(found[next] / 1e-8, 2.0_f64.cosh(), 1e-6);
            }
            _ => panic!("{kind:?}"),
        }
        assert_eq!(kind.is_stable(), axis != 1);
    }
}

#[test]
fn steady_rotations_with_equal_moments() {
    use SteadyRotation::{Drifting, Indifferent, Stable};
    let [first, second, third] = SteadyRotation::about_axes([1.0, 1.0, 1.5], 2.0);
    assert!(matches!(third, Stable { .. }) && third.is_stable());
    // About axis 1, I₂ = I₁: a perturbation along 3 stays, and that along 2 grows as (I₃ − I₁) Ω ω₃/I₂.
    assert_eq!(first, Drifting { rate: 1.0 });
    assert_eq!(second, Drifting { rate: -1.0 });
    let equations = EulerEquations::principal([1.0, 1.0, 1.5]).unwrap();
    let state = RotationState::aligned(V::new(2.0, 0.0, 1e-8));
    let end = Problem::new(&equations, At::from((0.0, state)))
        .solve(5.0, Taylor::new())
        .unwrap();
    assert_close(end.angular_velocity.z, 1e-8, 1e-22);
    assert_close(end.angular_velocity.y / 1e-8, 5.0, 1e-6);
    assert_eq!(SteadyRotation::about_axes([2.0; 3], 1.0), [Indifferent; 3]);
    // Moments that differ by rounding are equal.
    let [.., third] = SteadyRotation::about_axes([1.5 + 4e-16, 1.0, 1.5], 2.0);
    assert!(matches!(third, Drifting { .. }), "{third:?}");
    // Without inner moments, all rotations in the plane of equal ones are steady.
    let state = RotationState::aligned(V::new(0.3, -0.8, 0.0));
    let rates = equations.derivative(0.0, &state).angular_velocity;
    assert_eq!(rates, V::zeros());
}
