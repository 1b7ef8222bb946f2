//! The model: a rigid body that turns about a fixed pivot under its weight.

use lagrangian::Lagrangian;

/// A heavy top, pinned at a fixed point, in z-x-z Euler angles; its centre of mass lies on the third
/// principal axis.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        // The angular velocity in principal axes (4.4).
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    // (4.5)
    kinetic = 0.5 * (i1 * w1.powi(2) + i2 * w2.powi(2) + i3 * w3.powi(2)),
    potential = m * g * l * cos(theta),
)]
pub(crate) struct HeavyTop {
    /// First principal moment of inertia about the pivot in kg m².
    pub(crate) i1: f64,
    /// Second principal moment of inertia about the pivot in kg m².
    pub(crate) i2: f64,
    /// Third principal moment of inertia in kg m².
    pub(crate) i3: f64,
    /// Mass in kg.
    pub(crate) m: f64,
    /// Acceleration of gravity in m/s².
    pub(crate) g: f64,
    /// Distance from the pivot to the centre of mass in m.
    pub(crate) l: f64,
}
