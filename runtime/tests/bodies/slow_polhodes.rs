//! Free rotations whose angular velocity hardly moves in the body: slow polhodes of symmetric and nearly symmetric bodies.

use lagrangian::prelude::*;
use lagrangian::rigid_body::{FreeRotation, InertiaTensor, RotationState};
use lagrangian::{DoubleDouble, SingleNumber};
use nalgebra::UnitQuaternion;

/// A symmetric body turns about **L** with L/I₁, and about its axis with ω₃ (1 − I₃/I₁) (Landau and Lifshitz, § 33), however slowly.
#[test]
fn symmetric_bodies_that_turn_slowly_about_their_axis() {
    let orientation = UnitQuaternion::from_euler_angles(0.4, 0.2, -1.0);
    for (across, along) in [(1.0, 2.0), (1.0, 1.2), (1.0, 0.5)] {
        for spin in [1.0, 1e-3, 1e-6, -1e-9, 1e-12, 1e-15, 0.0] {
            let omega = Vector3::new(0.0, 5.0, spin);
            let start = RotationState::new(&orientation, omega);
            let body = InertiaTensor::principal([across, across, along]);
            let motion = FreeRotation::new(&body, &start).unwrap();
            let momentum = orientation * Vector3::new(0.0, across * 5.0, along * spin);
            for time in [1e-3, 0.5, 3.0, -3.0, 40.0, 1000.0] {
                let about_momentum = UnitQuaternion::from_scaled_axis(momentum / across * time);
                let angle = spin * (1.0 - along / across) * time;
                let about_axis = UnitQuaternion::from_scaled_axis(Vector3::z() * angle);
                let expected = about_momentum * orientation * about_axis;
                let found = motion.at(time);
                for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
                    let error = (found.to_space(&axis) - expected * axis).norm();
                    assert!(
                        error < 1e-12 + 1e-15 * 5.0 * time.abs(),
                        "{along} {spin} {time}: {error:e}"
                    );
                }
            }
        }
    }
}

fn motion<S: SingleNumber>(moments: [f64; 3], omega: [f64; 3]) -> FreeRotation<S> {
    let start = RotationState::aligned(omega.map(S::from_f64).into());
    let body = InertiaTensor::principal(moments.map(S::from_f64));
    FreeRotation::new(&body, &start).unwrap()
}

/// The same in double-doubles.
#[test]
fn nearly_symmetric_bodies() {
    let mut worst = 0.0_f64;
    for moments in [
        [1.0, 1.0 + 1e-9, 2.0],
        [1.0, 2.0 - 1e-9, 2.0],
        [0.1, 1.0, 1.0 + 1e-7],
        [1.0, 1.0 + 1e-13, 1.9],
        [1.0, 1.0001, 2.0],
    ] {
        for axis in 0..3 {
            for small in [1e-2, 1e-6, 1e-10, 1e-13] {
                let mut omega = [small, -0.5 * small, 0.3 * small];
                omega[axis] = 5.0;
                let rough = motion::<f64>(moments, omega);
                let precise = motion::<DoubleDouble>(moments, omega);
                for time in [0.5, 3.0] {
                    let rough = rough.at(time).quaternion;
                    let precise = precise.at(DoubleDouble::from_f64(time)).quaternion;
                    let product: f64 = (0..4).map(|i| rough[i] * precise[i].to_f64()).sum();
                    let sign = 1.0_f64.copysign(product);
                    for i in 0..4 {
                        let error = rough[i] - sign * precise[i].to_f64();
                        worst = worst.max(error.abs());
                        println!("{moments:?} {omega:?} {time}: {error:e}");
                    }
                }
            }
        }
    }
    assert!(worst < 1e-12, "{worst:e}");
}
