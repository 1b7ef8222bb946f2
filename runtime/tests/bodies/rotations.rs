//! Euler angles of all sequences, matrices and quaternions; rates, generalized forces, and the poles.

use crate::common::assert_close;
use lagrangian::prelude::*;
use lagrangian::rotation::{
    EulerAngles, EulerSequence, RotationError, quaternion_of, quaternion_rate, rotation_of,
    unit_quaternion, verified_rotation,
};
use lagrangian::{DoubleDouble, Lanes};
use nalgebra::{Rotation3, UnitQuaternion};

type V = Vector3<f64>;

use std::f64::consts::{FRAC_PI_2, PI};

fn number(index: u32) -> f64 {
    2.0 * (f64::from(index + 1) * 0.618_033_988_749_894_9).fract() - 1.0
}

/// Angles in the ranges that are returned.
fn angles(sequence: EulerSequence, index: u32) -> EulerAngles {
    let [phi, theta, psi] = [0, 1, 2].map(|k| number(3 * index + 7 * k * index + k));
    let theta = if sequence.repeats_axis() {
        (0.5 * theta + 0.5) * PI
    } else {
        theta * FRAC_PI_2
    };
    EulerAngles::new(sequence, [PI * phi, theta, PI * psi])
}

/// The product of elementary rotations by nalgebra.
fn by_nalgebra(angles: &EulerAngles) -> Rotation3<f64> {
    let units = [V::x_axis(), V::y_axis(), V::z_axis()];
    let axes = angles.sequence.axes();
    let [first, second, third] =
        [0, 1, 2].map(|k| Rotation3::from_axis_angle(&units[axes[k]], angles.angles[k]));
    first * second * third
}

fn apart(a: &Rotation3<f64>, b: &Rotation3<f64>) -> f64 {
    (a.matrix() - b.matrix()).norm()
}

#[test]
fn all_descriptions_of_all_sequences_agree() {
    for sequence in EulerSequence::ALL {
        for index in 0..500 {
            let angles = angles(sequence, index);
            let expected = by_nalgebra(&angles);
            assert_close(apart(&angles.rotation(), &expected), 0.0, 2e-15);
            assert_close(
                apart(&rotation_of(&angles.quaternion()), &expected),
                0.0,
                3e-15,
            );
            let from_matrix = quaternion_of(&expected);
            assert_close(from_matrix.angle_to(&angles.quaternion()), 0.0, 1e-7);
            assert_close(apart(&rotation_of(&from_matrix), &expected), 0.0, 3e-15);
            let by_nalgebra = UnitQuaternion::from_rotation_matrix(&expected);
            let [a, b] = [from_matrix, by_nalgebra].map(|q| q.coords);
            assert_close((a - b).norm().min((a + b).norm()), 0.0, 3e-15);
            for back in [
                EulerAngles::of_rotation(sequence, &expected),
                EulerAngles::of_quaternion(sequence, &angles.quaternion()),
            ] {
                // Errors of the angles grow towards the pole.
                let allowed = 4e-15 / angles.regularity();
                for (found, expected) in back.angles.into_iter().zip(angles.angles) {
                    assert_close(found, expected, allowed);
                }
                assert_close(apart(&back.rotation(), &expected), 0.0, 4e-15);
            }
        }
    }
}

#[test]
fn orientations_survive_the_poles() {
    for sequence in EulerSequence::ALL {
        let poles = if sequence.repeats_axis() {
            [0.0, PI]
        } else {
            [FRAC_PI_2, -FRAC_PI_2]
        };
        for pole in poles {
            for (distance, index) in [0.0, 1e-17, 1e-15, 1e-12, 1e-8, 1e-4].into_iter().zip(0..) {
                for sign in [1.0, -1.0] {
                    let [phi, psi] = [number(index), number(index + 40)].map(|x| PI * x);
                    let there = EulerAngles::new(sequence, [phi, pole + sign * distance, psi]);
                    let rotation = by_nalgebra(&there);
                    for back in [
                        EulerAngles::of_rotation(sequence, &rotation),
                        EulerAngles::of_quaternion(sequence, &there.quaternion()),
                    ] {
                        assert_close(apart(&back.rotation(), &rotation), 0.0, 4e-15);
                        assert!(back.angles.iter().all(|angle| angle.abs() <= PI));
                    }
                }
            }
        }
        // At the pole itself, the third angle is 0.
        let there = EulerAngles::new(sequence, [0.3, poles[0], 0.5]);
        let back = EulerAngles::of_quaternion(sequence, &there.quaternion());
        assert_close(back.angles[2], 0.0, 0.0);
    }
    // Half turns, where a component of the quaternion is zero.
    for axis in [V::x_axis(), V::y_axis(), V::z_axis()] {
        let half_turn = Rotation3::from_axis_angle(&axis, PI);
        assert_close(
            apart(&rotation_of(&quaternion_of(&half_turn)), &half_turn),
            0.0,
            1e-15,
        );
    }
}

type D = DoubleDouble;

#[test]
fn angular_velocities_are_rates_of_rotations() {
    let d = D::from_f64;
    for sequence in EulerSequence::ALL {
        let at = [0.4, 0.7, -1.9].map(d);
        let rates = [1.3, -0.6, 2.2].map(d);
        let path = |t: D| {
            let [a, b, c] = [0, 1, 2].map(|k| at[k] + t * rates[k]);
            EulerAngles::new(sequence, [a, b, c])
        };
        let h = d(1e-9);
        let rotation = |t: D| path(t).rotation().into_inner();
        let slope = (rotation(h) - rotation(-h)) / (h + h);
        let spin = rotation(d(0.0)).transpose() * slope;
        let found = path(d(0.0)).angular_velocity(&rates.into());
        for (found, (i, j)) in found.iter().zip([(2, 1), (0, 2), (1, 0)]) {
            assert_close((*found - spin[(i, j)]).to_f64(), 0.0, 1e-16);
            assert_close((*found + spin[(j, i)]).to_f64(), 0.0, 1e-16);
        }
        let spin = slope * rotation(d(0.0)).transpose();
        let found = path(d(0.0)).angular_velocity_in_space(&rates.into());
        for (found, (i, j)) in found.iter().zip([(2, 1), (0, 2), (1, 0)]) {
            assert_close((*found - spin[(i, j)]).to_f64(), 0.0, 1e-16);
        }
        // The same by the quaternion.
        let parts = |t: D| {
            let [x, y, z, w]: [D; 4] = path(t).quaternion().coords.into();
            [w, x, y, z]
        };
        let omega = path(d(0.0)).angular_velocity(&rates.into());
        let slopes = quaternion_rate(&parts(d(0.0)), &omega);
        let ends = parts(h).into_iter().zip(parts(-h));
        for (found, (ahead, behind)) in slopes.into_iter().zip(ends) {
            let slope = (ahead - behind) / (h + h);
            assert_close((found - slope).to_f64(), 0.0, 1e-16);
        }
    }
}

#[test]
fn precession_nutation_and_spin() {
    // (4.4), entry by entry.
    let (phi, theta, psi) = (0.3, 0.8, -1.1_f64);
    let angles = EulerAngles::new(EulerSequence::Zxz, [phi, theta, psi]);
    let expected = Matrix3::new(
        theta.sin() * psi.sin(),
        psi.cos(),
        0.0,
        theta.sin() * psi.cos(),
        -psi.sin(),
        0.0,
        theta.cos(),
        0.0,
        1.0,
    );
    assert_close((angles.rate_matrix() - expected).norm(), 0.0, 1e-16);
    assert_close(angles.regularity(), theta.sin(), 1e-16);
    // Q = Eᵀ N, and its inverse.
    let [n1, n2, n3] = [0.4, -1.2, 0.9];
    let q = angles.generalized_forces(&V::new(n1, n2, n3));
    assert_close(
        q.x,
        (n1 * psi.sin() + n2 * psi.cos()) * theta.sin() + n3 * theta.cos(),
        1e-15,
    );
    assert_close(q.y, n1 * psi.cos() - n2 * psi.sin(), 1e-15);
    assert_close(q.z, n3, 1e-16);
    let n = angles.moment(&q).unwrap();
    let about_normal = (q.x - q.z * theta.cos()) / theta.sin();
    assert_close(n.x, psi.sin() * about_normal + psi.cos() * q.y, 1e-15);
    assert_close(n.y, psi.cos() * about_normal - psi.sin() * q.y, 1e-15);
    // Rates, likewise.
    let w = V::new(0.7, 1.9, -0.3);
    let rates = angles.rates(&w).unwrap();
    let precession = (w.x * psi.sin() + w.y * psi.cos()) / theta.sin();
    assert_close(rates.x, precession, 1e-15);
    assert_close(rates.y, w.x * psi.cos() - w.y * psi.sin(), 1e-15);
    assert_close(rates.z, w.z - precession * theta.cos(), 1e-15);
}

#[test]
fn rates_and_moments_are_inverted() {
    for sequence in EulerSequence::ALL {
        let pole = if sequence.repeats_axis() {
            0.0
        } else {
            FRAC_PI_2
        };
        for (distance, index) in [0.9, 1e-3, 1e-6, 1e-9].into_iter().zip(0..) {
            let at = EulerAngles::new(
                sequence,
                [number(index), pole + distance, number(index + 9)],
            );
            let vector = V::new(0.3, -1.7, 0.8);
            let found = at.rates(&at.angular_velocity(&vector)).unwrap();
            // Rates of parallel axes are lost in their sum.
            assert_close((found - vector).norm(), 0.0, 1e-15 / distance);
            // The other way round nothing is lost, however near the pole is.
            let omega = at.angular_velocity(&at.rates(&vector).unwrap());
            assert_close((omega - vector).norm(), 0.0, 2e-15 / distance);
            let forces = at.generalized_forces(&vector);
            assert_close(
                (at.moment(&forces).unwrap() - vector).norm(),
                0.0,
                2e-15 / distance,
            );
            // Virtual power.
            let rates = V::new(-0.4, 0.6, 1.5);
            assert_close(
                forces.dot(&rates),
                vector.dot(&at.angular_velocity(&rates)),
                2e-15,
            );
        }
    }
}

#[test]
fn poles_are_errors() {
    for sequence in EulerSequence::ALL {
        let poles = if sequence.repeats_axis() {
            [0.0, PI, -3.0 * PI, 200.0 * PI]
        } else {
            [FRAC_PI_2, -FRAC_PI_2, 5.0 * FRAC_PI_2, 201.0 * FRAC_PI_2]
        };
        for pole in poles {
            let at = EulerAngles::new(sequence, [0.3, pole, 0.4]);
            let error = at.rates(&V::x()).unwrap_err();
            let RotationError::Singular {
                angle, determinant, ..
            } = error
            else {
                panic!("{error}");
            };
            assert_close(angle, pole, 0.0);
            assert!(determinant.abs() < 1e-13);
            assert_eq!(at.moment(&V::x()), Err(error));
            let [a, b, c] = at.angles.map(f32::from_f64);
            let single = EulerAngles::new(sequence, [a, b, c]);
            assert!(single.rates(&Vector3::x()).is_err());
        }
    }
    let at = EulerAngles::new(EulerSequence::Zxz, [0.0, 0.0, 0.0]);
    let text = at.rates(&V::x()).unwrap_err().to_string();
    assert!(
        text.starts_with("the z-x-z angles are singular where the second angle is 0"),
        "{text}"
    );
    // One lane is enough.
    let lanes = EulerAngles::new(
        EulerSequence::Zxz,
        [Lanes([0.1, 0.2]), Lanes([1.0, 0.0]), Lanes([0.3, 0.4])],
    );
    assert!(lanes.rates(&Vector3::repeat(Lanes([1.0, 1.0]))).is_err());
}

#[test]
fn states_go_on_in_other_sequences() {
    for (sequence, index) in EulerSequence::ALL.into_iter().zip(0..) {
        let at = angles(sequence, index + 3);
        let rates = V::new(0.5, -1.0, 2.0);
        let omega = at.angular_velocity_in_space(&rates);
        for other in EulerSequence::ALL {
            let (there, there_rates) = at.continued(other, &rates).unwrap();
            assert_eq!(there.sequence, other);
            assert_close(apart(&there.rotation(), &at.rotation()), 0.0, 4e-15);
            let found = there.angular_velocity_in_space(&there_rates);
            assert_close((found - omega).norm(), 0.0, 1e-14 / there.regularity());
        }
    }
    // Upright, z-x-z has no rates for a nutation about another axis.
    let upright = EulerAngles::new(EulerSequence::Xyz, [0.0, 0.0, 0.0]);
    assert!(upright.continued(EulerSequence::Zxz, &V::y()).is_err());
}

#[test]
fn what_is_no_rotation() {
    let rotation = by_nalgebra(&angles(EulerSequence::Zxz, 5));
    assert_eq!(verified_rotation(rotation.matrix()), Ok(rotation));
    let error = verified_rotation(&(rotation.matrix() * 2.0)).unwrap_err();
    let RotationError::NotOrthonormal {
        columns: [0, 0],
        product,
    } = error
    else {
        panic!("{error}");
    };
    assert_close(product, 4.0, 1e-14);
    let mut sheared = Matrix3::<f64>::identity();
    sheared[(0, 1)] = 0.6;
    sheared[(1, 1)] = 0.8;
    let error = verified_rotation(&sheared).unwrap_err();
    assert_eq!(
        error,
        RotationError::NotOrthonormal {
            columns: [0, 1],
            product: 0.6
        }
    );
    let error = verified_rotation(&-rotation.matrix()).unwrap_err();
    assert!(matches!(error, RotationError::Reflection { .. }), "{error}");
    assert!(verified_rotation(&Matrix3::repeat(f64::NAN)).is_err());
    assert_eq!(
        unit_quaternion([0.0; 4]),
        Err(RotationError::NoOrientation { norm: 0.0 })
    );
    assert!(unit_quaternion([f64::INFINITY, 0.0, 0.0, 0.0]).is_err());
    let unit = unit_quaternion([1.0, -2.0, 2.0, 4.0]).unwrap();
    assert_close(unit.k, 0.8, 1e-16);
}

/// The declarations of the text, (4.4) in each.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(w = angular_velocity(rotation_zxz(phi, theta, psi))),
    kinetic = 0.5 * w.dot(inertia * w),
)]
struct Zxz {
    inertia: Matrix3<f64>,
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b, c),
    define(w = angular_velocity(rotation_yxz(a, b, c))),
    kinetic = 0.5 * w.dot(inertia * w),
)]
struct Yxz {
    inertia: Matrix3<f64>,
}

#[test]
fn sequences_are_those_of_declarations() {
    let inertia = Matrix3::new(2.0, 0.1, -0.3, 0.1, 2.5, 0.2, -0.3, 0.2, 3.0);
    let (q, rates) = ([0.4, 0.9, -0.7], [1.0, -0.5, 2.0]);
    let momenta = |sequence| {
        let angles = EulerAngles::new(sequence, q);
        let momentum = inertia * angles.angular_velocity(&rates.into());
        angles.generalized_forces(&momentum)
    };
    let state = State::new(0.0, q, rates);
    // p = ∂T/∂q̇ = Eᵀ [I] E q̇.
    let expected = Zxz { inertia }.momenta(&state);
    assert_close((momenta(EulerSequence::Zxz) - expected).norm(), 0.0, 1e-14);
    let expected = Yxz { inertia }.momenta(&state);
    assert_close((momenta(EulerSequence::Yxz) - expected).norm(), 0.0, 1e-14);
}

#[test]
fn double_doubles_have_all_digits() {
    let d = D::from_f64;
    for sequence in EulerSequence::ALL {
        let angles = EulerAngles::new(sequence, [0.3, 1.1, -2.0].map(d));
        let back = EulerAngles::of_rotation(sequence, &angles.rotation());
        for (found, expected) in back.angles.into_iter().zip(angles.angles) {
            assert_close((found - expected).to_f64(), 0.0, 1e-29);
        }
    }
}
