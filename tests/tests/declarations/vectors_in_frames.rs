//! Mechanisms in space whose points are vectors rotated by products of rotations, against the same mechanisms
//! with every point as its three components in the inertial frame. The accelerations agree, and rotated vectors
//! cost no more, but clearly less where rotations follow each other.

use lagrangian::nalgebra::{Matrix3, Vector3};
use lagrangian::prelude::*;
use lagrangian_tests::{Figures, Random, relative_error};

/// Where M is ill-conditioned, rounding is amplified.
const TOLERANCE: f64 = 1e-11;

/// A mechanism of point masses, whose points are rotated vectors or lists of components; the most operations
/// that the accelerations may take where they are rotated vectors.
macro_rules! mechanism {
    (
        $test:ident, $rotated:ident, $plain:ident: $most:literal,
        coordinates($($coordinate:ident),*),
        define($($definition:tt)*),
        masses($($mass:ident at $point:ident),*),
        $(kinetic = $kinetic:expr,)?
        parameters { $($field:ident: $type:ty = $value:expr),* }
    ) => {
        #[derive(Lagrangian)]
        #[lagrangian(
                            coordinates($($coordinate),*),
                            define($($definition)*),
                            $(kinetic = 0.5 * $mass * dot($point).norm_squared(),)*
                            $(kinetic = $kinetic,)?
                            $(potential = g * $mass * $point.z,)*
                        )]
        struct $rotated { $($field: $type),* }

        #[derive(Lagrangian)]
        #[lagrangian(
                            coordinates($($coordinate),*),
                            define($($definition)*),
                            $(kinetic = 0.5 * $mass
                                * dot([$point.x, $point.y, $point.z]).norm_squared(),)*
                            $(kinetic = $kinetic,)?
                            $(potential = g * $mass * $point.z,)*
                        )]
        struct $plain { $($field: $type),* }

        #[test]
        fn $test() {
            let rotated = $rotated { $($field: $value),* };
            let plain = $plain { $($field: $value),* };
            let mut figures = Figures::new();
            let mut random = Random::default();
            for _ in 0..200 {
                let state = random.state();
                let pivot = plain.relative_pivots(&state).min();
                let (found, expected) = (rotated.accelerations(&state), plain.accelerations(&state));
                let error = relative_error(found.as_slice(), expected.as_slice(), 1.0);
                figures.record("accelerations", &format!("{state:?}"), error, TOLERANCE / pivot);
            }
            figures.finish();
            let [found, before] = [$rotated::OPERATIONS, $plain::OPERATIONS]
                .map(|operations| operations.accelerations.total());
            println!("{found:>4} operations, {before:>4} in the inertial frame");
            assert!(found <= $most, "{found} operations, not {}", $most);
            // Ways are chosen by cost and part by part, so that one operation more is no loss.
            let limit = before + before / 100;
            assert!(found <= limit, "{found} operations, {before} in the inertial frame");
        }
    };
}

mechanism! {
    a_spherical_pendulum, SphericalPendulum, PlainSphericalPendulum: 10,
    coordinates(phi, theta),
    define(p = rotation_z(phi) * rotation_x(theta) * [0, 0, -l]),
    masses(m at p),
    parameters { m: f64 = 1.3, g: f64 = 9.81, l: f64 = 0.7 }
}

mechanism! {
    two_spherical_pendulums, TwoSphericalPendulums, TwoPlainSphericalPendulums: 158,
    coordinates(f1, t1, f2, t2),
    define(
        p1 = rotation_z(f1) * rotation_x(t1) * [0, 0, -l1],
        p2 = p1 + rotation_z(f2) * rotation_x(t2) * [0, 0, -l2],
    ),
    masses(m1 at p1, m2 at p2),
    parameters { m1: f64 = 1.3, m2: f64 = 0.8, g: f64 = 9.81, l1: f64 = 0.7, l2: f64 = 1.1 }
}

mechanism! {
    two_links_on_universal_joints, UniversalJoints, PlainUniversalJoints: 318,
    coordinates(a1, b1, a2, b2),
    define(
        r1 = rotation_x(a1) * rotation_y(b1),
        r2 = r1 * rotation_x(a2) * rotation_y(b2),
        p1 = r1 * [0, 0, -l1],
        p2 = p1 + r2 * [0, 0, -l2],
    ),
    masses(m1 at p1, m2 at p2),
    parameters { m1: f64 = 1.3, m2: f64 = 0.8, g: f64 = 9.81, l1: f64 = 0.7, l2: f64 = 1.1 }
}

mechanism! {
    an_arm_of_three_joints, Arm, PlainArm: 106,
    coordinates(a, b, c),
    define(
        r1 = rotation_z(a),
        r2 = r1 * rotation_y(b),
        r3 = r2 * rotation_y(c),
        p2 = r2 * [c2, 0, 0],
        p3 = r2 * [l2, 0, 0] + r3 * [c3, 0, 0],
        w1 = angular_velocity(r1),
        w2 = angular_velocity(r2),
        w3 = angular_velocity(r3),
    ),
    masses(m2 at p2, m3 at p3),
    kinetic = 0.5 * (w1.dot(diagonal(i1) * w1) + w2.dot(diagonal(i2) * w2) + w3.dot(diagonal(i3) * w3)),
    parameters {
        g: f64 = 9.81, m2: f64 = 1.3, m3: f64 = 0.8, c2: f64 = 0.4, c3: f64 = 0.3, l2: f64 = 0.9,
        i1: [f64; 3] = [0.3, 0.4, 0.5], i2: [f64; 3] = [0.1, 0.6, 0.7], i3: [f64; 3] = [0.1, 0.3, 0.4]
    }
}

mechanism! {
    an_arm_of_any_shape, GeneralArm, PlainGeneralArm: 375,
    coordinates(a, b, c),
    define(
        r1 = rotation_z(a),
        r2 = r1 * rotation_y(b),
        r3 = r2 * rotation_y(c),
        p1 = r1 * c1,
        p2 = r1 * l1 + r2 * c2,
        p3 = r1 * l1 + r2 * l2 + r3 * c3,
        w1 = angular_velocity(r1),
        w2 = angular_velocity(r2),
        w3 = angular_velocity(r3),
    ),
    masses(m1 at p1, m2 at p2, m3 at p3),
    kinetic = 0.5 * (w1.dot(i1 * w1) + w2.dot(i2 * w2) + w3.dot(i3 * w3)),
    parameters {
        g: f64 = 9.81, m1: f64 = 1.1, m2: f64 = 1.3, m3: f64 = 0.8,
        c1: Vector3<f64> = Vector3::new(0.1, 0.2, 0.3), c2: Vector3<f64> = Vector3::new(0.4, 0.1, -0.1),
        c3: Vector3<f64> = Vector3::new(0.3, -0.2, 0.1), l1: Vector3<f64> = Vector3::new(0.2, 0.1, 0.5),
        l2: Vector3<f64> = Vector3::new(0.9, 0.1, 0.2),
        i1: Matrix3<f64> = tensor(0.4), i2: Matrix3<f64> = tensor(0.6), i3: Matrix3<f64> = tensor(0.3)
    }
}

mechanism! {
    a_top_whose_centre_of_mass_is_anywhere, Top, PlainTop: 89,
    coordinates(phi, theta, psi),
    define(
        r = rotation_zxz(phi, theta, psi),
        w = angular_velocity(r),
        p = r * center,
    ),
    masses(m at p),
    kinetic = 0.5 * w.dot(diagonal(inertia) * w),
    parameters {
        m: f64 = 1.3, g: f64 = 9.81,
        center: Vector3<f64> = Vector3::new(0.05, 0.03, 0.4), inertia: [f64; 3] = [1.2, 1.5, 0.7]
    }
}

mechanism! {
    a_mass_that_moves_in_a_top, Slider, PlainSlider: 232,
    coordinates(phi, theta, psi, s),
    define(
        r = rotation_zxz(phi, theta, psi),
        w = angular_velocity(r),
        p = r * [d, 0, s],
    ),
    masses(m at p),
    kinetic = 0.5 * w.dot(diagonal(inertia) * w),
    parameters {
        m: f64 = 1.3, g: f64 = 9.81, d: f64 = 0.2, inertia: [f64; 3] = [1.2, 1.5, 0.7]
    }
}

mechanism! {
    a_free_body_about_any_point, FreeBody, PlainFreeBody: 118,
    coordinates(x, y, z, phi, theta, psi),
    define(
        r = rotation_zyx(psi, theta, phi),
        w = angular_velocity(r),
        p = [x, y, z] + r * center,
    ),
    masses(m at p),
    kinetic = 0.5 * w.dot(diagonal(inertia) * w),
    parameters {
        m: f64 = 1.3, g: f64 = 9.81,
        center: Vector3<f64> = Vector3::new(0.05, 0.03, 0.4), inertia: [f64; 3] = [1.2, 1.5, 0.7]
    }
}

/// A tensor of inertia about axes that are not principal.
fn tensor(size: f64) -> Matrix3<f64> {
    size * Matrix3::new(1.2, 0.1, -0.2, 0.1, 1.5, 0.15, -0.2, 0.15, 0.9)
}
