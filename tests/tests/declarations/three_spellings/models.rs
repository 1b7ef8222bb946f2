//! The declarations.

use lagrangian::nalgebra::{Matrix3, Vector3};
use lagrangian::prelude::*;

/// Equation (4.5) in scalars.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (i1 * w1.powi(2) + i2 * w2.powi(2) + i3 * w3.powi(2)),
    potential = m * g * (x * sin(theta) * sin(psi) + y * sin(theta) * cos(psi) + z * cos(theta)),
)]
pub(super) struct InScalars {
    pub(super) i1: f64,
    pub(super) i2: f64,
    pub(super) i3: f64,
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) z: f64,
}

/// The angular velocity of the angles, and the vertical as the body sees it.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        w = angular_velocity_zxz(phi, theta, psi),
        vertical = [sin(theta) * sin(psi), sin(theta) * cos(psi), cos(theta)],
    ),
    kinetic = 0.5 * w.dot(diagonal([i1, i2, i3]) * w),
    potential = m * g * center.dot(vertical),
)]
pub(super) struct InVectors {
    pub(super) i1: f64,
    pub(super) i2: f64,
    pub(super) i3: f64,
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) center: Vector3<f64>,
}

/// All from the rotation.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), w = angular_velocity(r)),
    kinetic = 0.5 * w.dot(inertia.component_mul(w)),
    potential = m * g * (r * center).z,
)]
pub(super) struct FromItsRotation {
    pub(super) inertia: [f64; 3],
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) center: Vector3<f64>,
}

/// The inertia turned into the axes of space.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        r = rotation_zxz(phi, theta, psi),
        w = angular_velocity_inertial(r),
        turned = r * diagonal(inertia) * r.transpose(),
    ),
    kinetic = 0.5 * w.dot(turned * w),
    potential = m * g * (r * center).z,
)]
pub(super) struct InSpace {
    pub(super) inertia: Vector3<f64>,
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) center: Vector3<f64>,
}

/// Products of inertia (2.1), in scalars.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (ixx * w1.powi(2) + iyy * w2.powi(2) + izz * w3.powi(2))
        - ixy * w1 * w2 - ixz * w1 * w3 - iyz * w2 * w3,
    potential = m * g * (x * sin(theta) * sin(psi) + y * sin(theta) * cos(psi) + z * cos(theta)),
)]
pub(super) struct ProductsOfInertia {
    pub(super) ixx: f64,
    pub(super) iyy: f64,
    pub(super) izz: f64,
    pub(super) ixy: f64,
    pub(super) ixz: f64,
    pub(super) iyz: f64,
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) z: f64,
}

/// The tensor of inertia (2.1) from six inertias.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        r = rotation_zxz(phi, theta, psi),
        w = angular_velocity(r),
        inertia = [[ixx, -ixy, -ixz], [-ixy, iyy, -iyz], [-ixz, -iyz, izz]],
    ),
    kinetic = 0.5 * w.dot(inertia * w),
    potential = m * g * (r * center).z,
)]
pub(super) struct SymmetricTensor {
    pub(super) ixx: f64,
    pub(super) iyy: f64,
    pub(super) izz: f64,
    pub(super) ixy: f64,
    pub(super) ixz: f64,
    pub(super) iyz: f64,
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) center: Vector3<f64>,
}

/// The same, turned into the axes of space.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), w = angular_velocity_inertial(r)),
    kinetic = 0.5 * w.dot(r * inertia * r.transpose() * w),
    potential = m * g * (r * center).z,
)]
pub(super) struct TensorInSpace {
    pub(super) inertia: Matrix3<f64>,
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) center: Vector3<f64>,
}

/// The tensor of inertia as one parameter, whose symmetry is nowhere written.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), w = angular_velocity(r)),
    kinetic = 0.5 * w.dot(inertia * w),
    potential = m * g * (r * center).z,
)]
pub(super) struct Tensor {
    pub(super) inertia: Matrix3<f64>,
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) center: Vector3<f64>,
}
