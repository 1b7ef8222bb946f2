//! The closed form of free rotation against integrations in double-doubles, and what is known of tennis rackets and
//! plates.

use crate::common::assert_close;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{
    BodyError, EulerEquations, FreeRotation, InertiaTensor, ProductsOfInertia, RotationState, Solid,
};
use lagrangian::rotation::{rotation_of, unit_quaternion};
use lagrangian::{DoubleDouble, Series, SingleNumber};
use nalgebra::Rotation3;

type D = DoubleDouble;
type V = Vector3<f64>;

fn d(value: f64) -> D {
    D::from_f64(value)
}

fn start<S: Scalar>(omega: [f64; 3]) -> RotationState<S> {
    let components = [0.8, -0.3, 0.4, 0.2].map(S::from_f64);
    let orientation = unit_quaternion(components).unwrap();
    RotationState::new(&orientation, omega.map(S::from_f64).into())
}

/// The largest of numbers, NaN if one of them is.
fn worst(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let larger = |most: f64, x: f64| if x > most || x.is_nan() { x } else { most };
    numbers.into_iter().fold(0.0, larger)
}

/// The largest difference of components; the quaternions may differ in sign.
fn precisely_apart(a: &RotationState<D>, b: &RotationState<D>) -> f64 {
    let by_sign = |sign: f64| {
        let pairs = a.quaternion.iter().zip(b.quaternion.iter());
        worst(pairs.map(|(x, y)| (*x - d(sign) * *y).to_f64().abs()))
    };
    let [same, opposite] = [1.0, -1.0].map(by_sign);
    let of_quaternion = if opposite < same { opposite } else { same };
    let omega = a.angular_velocity - b.angular_velocity;
    worst(
        omega
            .iter()
            .map(|x| x.to_f64().abs())
            .chain([of_quaternion]),
    )
}

/// The same for a state on `f64`.
fn apart(a: &RotationState, b: &RotationState<D>) -> f64 {
    let precise = RotationState {
        quaternion: a.quaternion.map(d),
        angular_velocity: a.angular_velocity.map(d),
    };
    precisely_apart(&precise, b)
}

/// Compares closed form and integration on double-doubles, and the closed form on `f64` with both.
fn check<F>(tensor: impl Fn() -> F, precise: &InertiaTensor<D>, omega: [f64; 3], tolerance: f64)
where
    F: Into<InertiaTensor<f64>>,
{
    let equations = EulerEquations::new(*precise).unwrap();
    let problem = Problem::new(&equations, At::from((d(0.0), start(omega))));
    let exact = FreeRotation::new(precise, &start(omega)).unwrap();
    let single = FreeRotation::new(&tensor().into(), &start(omega)).unwrap();
    for time in [0.0, 0.3, 2.0, -3.0, 7.0] {
        let expected = problem.clone().solve(time, Taylor::order_40()).unwrap();
        let found = exact.at(d(time));
        let error = precisely_apart(&found, &expected);
        assert!(error < tolerance * 1e-15, "{omega:?} at {time}: {error:e}");
        let error = apart(&single.at(time), &expected);
        assert!(error < tolerance, "{omega:?} at {time}: {error:e}");
    }
}

const MOMENTS: [[f64; 3]; 6] = [
    [1.0, 2.0, 2.8],
    [1.0, 2.8, 2.0],
    [2.0, 1.0, 2.8],
    [2.0, 2.8, 1.0],
    [2.8, 1.0, 2.0],
    [2.8, 2.0, 1.0],
];

const VELOCITIES: [[f64; 3]; 8] = [
    [1.1, -0.7, 1.9],
    [-1.1, 0.7, 0.2],
    [0.2, 1.7, -0.3],
    [-2.0, 0.1, -0.1],
    [0.0, 1.0, 2.0],
    [1.0, 0.0, 2.0],
    [2.0, 1.0, 0.0],
    [-0.4, -0.4, -0.4],
];

/// Each order, and each velocity.
#[test]
fn some_orders_of_moments_and_signs_of_velocities() {
    for (n, omega) in VELOCITIES.into_iter().enumerate() {
        let moments = MOMENTS[n % MOMENTS.len()];
        let precise = InertiaTensor::principal(moments.map(d));
        check(|| InertiaTensor::principal(moments), &precise, omega, 4e-14);
    }
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn all_orders_of_moments_and_signs_of_velocities() {
    for moments in MOMENTS {
        for omega in VELOCITIES {
            let precise = InertiaTensor::principal(moments.map(d));
            check(|| InertiaTensor::principal(moments), &precise, omega, 4e-14);
        }
    }
}

#[test]
fn axes_that_are_not_principal_axes() {
    fn tensor<S: SingleNumber>() -> InertiaTensor<S> {
        let [xy, xz, yz] = [0.2, -0.3, 0.1].map(S::from_f64);
        let products = ProductsOfInertia { xy, xz, yz };
        InertiaTensor::from_moments_and_products([2.0, 2.5, 3.0].map(S::from_f64), products)
    }
    for omega in VELOCITIES {
        check(tensor::<f64>, &tensor(), omega, 1e-13);
    }
}

#[test]
fn symmetric_bodies_and_steady_rotations() {
    for moments in [
        [1.0, 1.0, 1.5],
        [1.5, 1.5, 0.5],
        [2.0, 1.2, 2.0],
        [0.7, 1.0, 1.0],
        [1.0; 3],
    ] {
        for omega in VELOCITIES {
            let precise = InertiaTensor::principal(moments.map(d));
            check(|| InertiaTensor::principal(moments), &precise, omega, 4e-14);
        }
    }
    let moments = [1.0, 2.0, 2.8];
    for omega in [[3.0, 0.0, 0.0], [0.0, -3.0, 0.0], [0.0, 0.0, 3.0], [0.0; 3]] {
        let precise = InertiaTensor::principal(moments.map(d));
        check(|| InertiaTensor::principal(moments), &precise, omega, 4e-14);
        let motion = FreeRotation::new(&precise, &start(omega)).unwrap();
        assert_eq!(motion.period(), None);
    }
    // Almost steady: the amplitudes are at the limit of the digits, and so are their squares below it.
    for small in [1e-6, 1e-9, 1e-14, 1e-200] {
        for omega in [
            [2.0, small, small],
            [small, -small, 2.0],
            [small, 0.0, -2.0],
        ] {
            let precise = InertiaTensor::principal(moments.map(d));
            check(|| InertiaTensor::principal(moments), &precise, omega, 4e-14);
        }
    }
}

#[test]
fn near_the_separatrix_and_on_it() {
    // From near the middle axis, neighbouring motions part as e^(σt): the tolerance grows with it.
    let moments = [1.0, 2.0, 2.8];
    let precise = InertiaTensor::principal(moments.map(d));
    for (small, tolerance) in [(0.1, 1e-12), (1e-2, 1e-10), (1e-3, 1e-8)] {
        for omega in [[small, 2.0, 0.0], [0.0, 2.0, small]] {
            check(
                || InertiaTensor::principal(moments),
                &precise,
                omega,
                tolerance,
            );
        }
    }
    // L² = 2 E I₂ in exact numbers: I₃ (I₃ − I₂) ω₃² = I₁ (I₂ − I₁) ω₁².
    let moments = [1.0, 2.0, 2.25];
    let precise = InertiaTensor::principal(moments.map(d));
    let omega = [0.75, 0.5, 1.0];
    let motion = FreeRotation::new(&precise, &start(omega)).unwrap();
    assert_eq!(motion.period(), None);
    check(|| InertiaTensor::principal(moments), &precise, omega, 1e-12);
    // It ends about the middle axis.
    let end = motion.at(d(1000.0)).angular_velocity;
    assert_close(end.x.to_f64(), 0.0, 1e-30);
    assert_close(end.z.to_f64(), 0.0, 1e-30);
}

#[test]
fn closed_forms_satisfy_eulers_equations() {
    // By difference quotients of the closed form itself, and the constants of the motion.
    let tensor = InertiaTensor::principal([1.0, 2.0, 2.8].map(d));
    let equations = EulerEquations::new(tensor).unwrap();
    for omega in VELOCITIES {
        let motion = FreeRotation::new(&tensor, &start(omega)).unwrap();
        let momentum = equations.angular_momentum_in_space(&start(omega));
        let h = d(1e-9);
        for time in [-4.0, 0.2, 11.0, 1e4] {
            let time = d(time);
            let slopes = equations.derivative(d(0.0), &motion.at(time));
            let [ahead, behind] = [motion.at(time + h), motion.at(time - h)];
            let pairs = ahead
                .components()
                .zip(behind.components())
                .zip(slopes.components());
            for ((ahead, behind), slope) in pairs {
                let quotient = (ahead - behind) / (h + h);
                assert_close((quotient - slope).to_f64(), 0.0, 1e-15);
            }
            let kept = equations.angular_momentum_in_space(&motion.at(time)) - momentum;
            assert!(kept.iter().all(|x| x.to_f64().abs() < 1e-25));
        }
    }
}

#[test]
fn many_turns_lose_few_digits() {
    let moments = [1.0, 2.0, 2.8];
    let omega = [1.1, -0.7, 1.9];
    let precise = InertiaTensor::principal(moments.map(d));
    let exact = FreeRotation::new(&precise, &start(omega)).unwrap();
    let single = FreeRotation::new(&InertiaTensor::principal(moments), &start(omega)).unwrap();
    // Some 10⁵ radians.
    let time = 5e4;
    let error = apart(&single.at(time), &exact.at(d(time)));
    assert!(error < 1e-10, "{error:e}");
}

#[test]
fn derivatives_of_the_closed_form() {
    type Dual = lagrangian::Dual<f64, 4>;
    let derivatives = |state: &RotationState<Dual>| -> Vec<f64> {
        state.components().flat_map(|x| x.derivative).collect()
    };
    // By the components of the angular velocity, and by a moment of inertia.
    for omega in VELOCITIES.into_iter().chain([[0.05, 5.0, 0.0]]) {
        let [w1, w2, w3] = omega;
        let omega = [(w1, 0), (w2, 1), (w3, 2)].map(|(w, k)| Dual::variable(w, k));
        let middle = Dual::variable(2.0, 3);
        let tensor = InertiaTensor::principal([Dual::constant(1.0), middle, Dual::constant(2.8)]);
        let mut state = start::<Dual>([0.0; 3]);
        state.angular_velocity = omega.into();
        let motion = FreeRotation::new(&tensor, &state).unwrap();
        let equations = EulerEquations::new(tensor).unwrap();
        let problem = Problem::new(&equations, At::from((Dual::constant(0.0), state)));
        for time in [0.4, 3.0] {
            let found = derivatives(&motion.at(Dual::constant(time)));
            let end = problem.clone().solve(time, Taylor::new()).unwrap();
            let expected = derivatives(&end);
            // The quaternion has either sign.
            let sign = (motion.at(Dual::constant(time)).quaternion[0].value
                * end.quaternion[0].value)
                .signum();
            for (index, (found, expected)) in found.into_iter().zip(expected).enumerate() {
                let sign = if index < 16 { sign } else { 1.0 };
                assert_close(sign * found, expected, 1e-11 * (1.0 + expected.abs()));
            }
        }
    }
    let mut state = start::<Dual>([0.0, 2.0, 0.0]);
    let tensor = InertiaTensor::principal([1.0, 2.0, 2.8].map(Dual::constant));
    assert!(FreeRotation::new(&tensor, &state).is_ok());
    state.angular_velocity.x = Dual::variable(0.0, 0);
    let error = FreeRotation::new(&tensor, &state).unwrap_err();
    assert!(
        matches!(error, BodyError::NotDifferentiable { .. }),
        "{error}"
    );
}

/// A tennis racket in angles that are regular during the flip.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(a, b, c),
    define(w = angular_velocity(rotation_yxz(a, b, c))),
    kinetic = 0.5 * (i1 * w.x.powi(2) + i2 * w.y.powi(2) + i3 * w.z.powi(2)),
    output(middle = w.y),
)]
struct Racket {
    i1: f64,
    i2: f64,
    i3: f64,
}

/// The time between two zeros of a function of the state.
fn between_zeros<Dy, X>(dynamics: &Dy, start: X, zero: impl Fn(&X) -> f64) -> f64
where
    Dy: Series<f64, State = X>,
    X: VectorSpace<f64>,
{
    let next = |start, end| {
        let stopped = Problem::new(dynamics, start)
            .when(|x| zero(&x.x))
            .stop()
            .solve(end, Taylor::new())
            .unwrap();
        assert_eq!(stopped.reason, StopReason::Condition);
        stopped.last
    };
    let first = next(At { t: 0.0, x: start }, 100.0);
    next(first.clone(), 200.0).t - first.t
}

#[test]
fn the_flip_of_a_tennis_racket() {
    let moments = [1.0, 2.0, 2.8];
    let omega = V::new(0.05, 5.0, 0.0);
    let state = RotationState::aligned(omega);
    let tensor = InertiaTensor::principal(moments);
    let flip = FreeRotation::new(&tensor, &state)
        .unwrap()
        .half_period()
        .unwrap();
    // 2 K(m)/σ with 40 digits.
    assert_close(flip, FLIP, 1e-14);
    let equations = EulerEquations::new(tensor).unwrap();
    let found = between_zeros(&equations, state, |x| x.angular_velocity.y);
    assert_close(found, flip, 1e-9);
    let [i1, i2, i3] = moments;
    let racket = Racket { i1, i2, i3 };
    // In y-x-z from the identity, the rates are those of y, x and z.
    let at = State::new(0.0, [0.0; 3], [omega.y, omega.x, omega.z]);
    let middle = |x: &Phase<f64, 3>| racket.outputs(&At::from((0.0, *x))).middle;
    let found = between_zeros(&racket.dynamics(), at.into(), middle);
    assert_close(found, flip, 1e-9);
}

/// m = (I₂ − I₁)(2EI₃ − L²)/((I₃ − I₂)(L² − 2EI₁)), σ² = (I₃ − I₂)(L² − 2EI₁)/(I₁I₂I₃), numbered as for L² < 2 E I₂.
const FLIP: f64 = 4.439_427_330_872_694;

#[test]
fn free_symmetric_top() {
    // φ̇ = I_s ω₃/(I cos θ) about the angular momentum, and ω turns about the axis with (I − I_s)/I ω₃.
    let [i, i_s] = [1.5, 0.6];
    let state = RotationState::aligned(V::new(0.8, 0.0, 3.0));
    let tensor = InertiaTensor::principal([i, i, i_s]);
    let motion = FreeRotation::new(&tensor, &state).unwrap();
    let period = 2.0 * std::f64::consts::PI / ((i - i_s) / i * 3.0);
    assert_close(motion.period().unwrap(), period, 1e-14);
    let equations = EulerEquations::new(tensor).unwrap();
    let momentum = equations.angular_momentum_in_space(&state);
    let theta = (i * 0.8_f64).atan2(i_s * 3.0);
    let precession = i_s * 3.0 / (i * theta.cos());
    for time in [0.3, 1.7, 4.0] {
        // The axis of the body goes round that of the momentum.
        let turned = Rotation3::from_scaled_axis(momentum.normalize() * (precession * time));
        let axis = motion.at(time).to_space(&V::z());
        assert_close((axis - turned * V::z()).norm(), 0.0, 1e-14);
    }
}

#[test]
fn feynmans_plate_wobbles_twice_as_fast_as_it_spins() {
    let plate = Solid::disc(0.12).unwrap().with_mass(0.3).unwrap();
    let spin = 20.0;
    for tilt in [1e-1, 1e-3, 1e-5] {
        // I₃ = 2 I₁: L at a small angle from the axis.
        let state = RotationState::aligned(V::new(2.0 * spin * f64::tan(tilt), 0.0, spin));
        let motion = FreeRotation::new(&plate.inertia(), &state).unwrap();
        let equations = EulerEquations::about_center(&plate).unwrap();
        let momentum = equations.angular_momentum_in_space(&state).normalize();
        // The angle by which the axis has gone round the momentum in a short time.
        let time = 1e-2;
        let across = |axis: V| axis - momentum * momentum.dot(&axis);
        let [before, after] = [0.0, time].map(|t| across(motion.at(t).to_space(&V::z())));
        let wobble = before
            .cross(&after)
            .dot(&momentum)
            .atan2(before.dot(&after))
            / time;
        assert_close(wobble / spin * tilt.cos(), 2.0, 1e-9);
    }
}

#[test]
fn bodies_that_do_not_rotate_freely() {
    let rod = Solid::rod(1.0).unwrap().with_mass(2.0).unwrap();
    let error = FreeRotation::new(&rod.inertia(), &start([1.0, 2.0, 3.0])).unwrap_err();
    assert!(matches!(error, BodyError::NoInertia { .. }), "{error}");
    let tensor = InertiaTensor::principal([1.0, 2.0, 2.8]);
    let error = FreeRotation::new(&tensor, &start([1.0, f64::NAN, 3.0])).unwrap_err();
    assert!(matches!(error, BodyError::NotFinite { .. }), "{error}");
    // The orientation of a frame is a rotation.
    let orientation = rotation_of(&start::<f64>([0.0; 3]).orientation());
    assert_close(orientation.matrix().determinant(), 1.0, 1e-15);
}
