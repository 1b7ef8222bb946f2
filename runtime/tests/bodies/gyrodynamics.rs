//! The equations of chapter 4, as they stand in the text, against derived models.

use crate::common::assert_close;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{EulerEquations, RigidBody, RotationState, SteadyPrecession};
use lagrangian::rotation::{EulerAngles, EulerSequence};

type V = Vector3<f64>;

/// A body that rotates about a fixed point or its centre of gravity, its potential energy a function of θ.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(phi, theta, psi),
    define(w = angular_velocity(rotation_zxz(phi, theta, psi))),
    kinetic = 0.5 * (i1 * w.x.powi(2) + i2 * w.y.powi(2) + i3 * w.z.powi(2)),
    potential = mgl * cos(theta),
)]
struct Top {
    i1: f64,
    i2: f64,
    i3: f64,
    mgl: f64,
}

const STATES: [([f64; 3], [f64; 3]); 3] = [
    ([0.3, 0.8, -1.1], [0.7, -0.4, 2.0]),
    ([-2.0, 2.1, 0.5], [-1.5, 0.9, 0.3]),
    ([1.0, -0.6, 3.0], [0.2, 1.7, -4.0]),
];

fn states() -> impl Iterator<Item = State<f64, 3>> {
    STATES.into_iter().map(|(q, v)| State::new(0.0, q, v))
}

#[test]
fn kinetic_energy_in_euler_angles() {
    let top = Top {
        i1: 1.2,
        i2: 2.0,
        i3: 2.7,
        mgl: 0.0,
    };
    for state in states() {
        let [_, theta, psi]: [f64; 3] = state.q.into();
        let [phi_dot, theta_dot, psi_dot]: [f64; 3] = state.v.into();
        // (4.5).
        let first = phi_dot * theta.sin() * psi.sin() + theta_dot * psi.cos();
        let second = phi_dot * theta.sin() * psi.cos() - theta_dot * psi.sin();
        let third = phi_dot * theta.cos() + psi_dot;
        let expected = 0.5 * (1.2 * first.powi(2) + 2.0 * second.powi(2) + 2.7 * third.powi(2));
        assert_close(top.lagrangian(&state), expected, 1e-14);
        // (4.2), by the angular velocity of the angles.
        let angles = EulerAngles::new(EulerSequence::Zxz, state.q.into());
        let omega = angles.angular_velocity(&state.v);
        let body = EulerEquations::principal([1.2, 2.0, 2.7]).unwrap();
        assert_close(
            body.kinetic_energy(&RotationState::aligned(omega)),
            expected,
            1e-14,
        );
    }
}

#[test]
fn lagranges_equations_are_those_of_euler() {
    // (4.6): Q = Eᵀ (I ω̇ + ω × I ω), for any accelerations.
    let top = Top {
        i1: 1.2,
        i2: 2.0,
        i3: 2.7,
        mgl: 0.0,
    };
    let inertia = lagrangian::rigid_body::InertiaTensor::principal([1.2, 2.0, 2.7]);
    let body = RigidBody::new(1.0, V::zeros(), inertia).unwrap();
    let accelerations = V::new(0.9, -1.3, 0.4);
    for state in states() {
        let angles = EulerAngles::new(EulerSequence::Zxz, state.q.into());
        let omega = angles.angular_velocity(&state.v);
        // ω̇ by a difference quotient along the path q + q̇ t + ½ q̈ t².
        let at = |t: f64| {
            let q = state.q + state.v * t + accelerations * (0.5 * t * t);
            let angles = EulerAngles::new(EulerSequence::Zxz, q.into());
            angles.angular_velocity(&(state.v + accelerations * t))
        };
        let h = 1e-5;
        let alpha = (at(h) - at(-h)) / (2.0 * h);
        let moment = body.moment_about_center(&omega, &alpha);
        let expected = angles.generalized_forces(&moment);
        let found = top.inverse_dynamics(&state, &accelerations);
        assert_close((found - expected).norm(), 0.0, 1e-8);
    }
}

#[test]
fn momenta_and_energy_of_a_symmetric_top() {
    let (i, i_s, mgl) = (1.2, 0.5, 5.1);
    let top = Top {
        i1: i,
        i2: i,
        i3: i_s,
        mgl,
    };
    for state in states() {
        let theta = state.q[1];
        let [phi_dot, theta_dot, psi_dot]: [f64; 3] = state.v.into();
        let spin = phi_dot * theta.cos() + psi_dot;
        // (4.7).
        let kinetic = 0.5
            * (i * (phi_dot.powi(2) * theta.sin().powi(2) + theta_dot.powi(2))
                + i_s * spin.powi(2));
        assert_close(top.lagrangian(&state), kinetic - mgl * theta.cos(), 1e-14);
        // (4.8): the momenta of φ and ψ.
        let c_phi = i * phi_dot * theta.sin().powi(2) + i_s * spin * theta.cos();
        let c_psi = i_s * spin;
        let momenta = top.momenta(&state);
        assert_close(momenta[0], c_phi, 1e-14);
        assert_close(momenta[2], c_psi, 1e-14);
        // (4.10): the energy, by the effective potential.
        let effective = mgl * theta.cos()
            + (c_phi - c_psi * theta.cos()).powi(2) / (2.0 * i * theta.sin().powi(2))
            + c_psi.powi(2) / (2.0 * i_s);
        assert_close(
            top.energy(&state),
            0.5 * i * theta_dot.powi(2) + effective,
            1e-13,
        );
        // They are constants of the motion.
        let end = Problem::new(&top, state).solve(1.0, Taylor::new()).unwrap();
        let kept = top.momenta(&end) - momenta;
        assert_close(kept[0], 0.0, 1e-12);
        assert_close(kept[2], 0.0, 1e-12);
        assert_close(top.energy(&end), top.energy(&state), 1e-12);
    }
}

#[test]
fn steady_precession() {
    let (i, i_s, mgl) = (1.2, 0.5, 5.1);
    let top = Top {
        i1: i,
        i2: i,
        i3: i_s,
        mgl,
    };
    // θ̈ at a precession rate, with ω₃ given.
    let nutation = |theta: f64, spin: f64, rate: f64| {
        let state = State::new(
            0.0,
            [0.2, theta, 0.3],
            [rate, 0.0, spin - rate * theta.cos()],
        );
        top.accelerations(&state)[1]
    };
    let of_top =
        |theta: f64, spin: f64| SteadyPrecession::of_top(i, i_s, spin, theta, -mgl * theta.sin());
    for (theta, spin) in [
        (0.5, 40.0),
        (0.5, -40.0),
        (1.2, 12.0),
        (2.5, 3.0),
        (2.5, 0.0),
        (-0.5, 40.0),
    ] {
        let SteadyPrecession::Two { slow, fast } = of_top(theta, spin) else {
            panic!("two rates at {theta}, {spin}");
        };
        assert!(slow.abs() <= fast.abs() * (1.0 + 1e-15));
        assert_close(
            nutation(theta, spin, slow),
            0.0,
            1e-12 * (1.0 + fast * fast),
        );
        assert_close(
            nutation(theta, spin, fast),
            0.0,
            1e-14 * (1.0 + fast * fast),
        );
        assert!(nutation(theta, spin, slow + 0.1).abs() > 1e-2);
    }
}

#[test]
fn steady_precession_where_there_are_not_two() {
    let (i, i_s, mgl) = (1.2, 0.5, 5.1);
    let of_top =
        |theta: f64, spin: f64| SteadyPrecession::of_top(i, i_s, spin, theta, -mgl * theta.sin());
    // Horizontal, where cos θ is 0 but for rounding: the fast precession is beyond all bounds.
    let spin = 4.0;
    match of_top(std::f64::consts::FRAC_PI_2, spin) {
        SteadyPrecession::Two { slow, fast } => {
            assert_close(slow, mgl / (i_s * spin), 1e-14);
            assert!(fast.abs() > 1e15);
        }
        other => panic!("{other:?}"),
    }
    // Too slow: |ω₃| < (2/I_s) √(I m g l cos θ).
    let least = 2.0 / i_s * (i * mgl * 0.5_f64.cos()).sqrt();
    let SteadyPrecession::None { discriminant, .. } = of_top(0.5, 0.999 * least) else {
        panic!("no rate");
    };
    assert!(discriminant < 0.0);
    assert!(matches!(
        of_top(0.5, 1.001 * least),
        SteadyPrecession::Two { .. }
    ));
    // Slow precession of a very fast top keeps its digits.
    let SteadyPrecession::Two { slow, .. } = of_top(0.5, 1e9) else {
        panic!("two rates");
    };
    assert_close(slow / (mgl / (i_s * 1e9)), 1.0, 1e-15);
    assert_eq!(of_top(0.0, 4.0), SteadyPrecession::Any);
    let pushed = SteadyPrecession::of_top(i, i_s, 4.0, 0.0, 1.0);
    assert!(matches!(pushed, SteadyPrecession::None { .. }));
    assert!(matches!(of_top(0.5, f64::NAN), SteadyPrecession::Two { slow, .. } if slow.is_nan()));
}
