//! The models that are measured, derived and written by hand.
//!
//! By hand means as somebody writes it who knows the trick: the tops through Euler's equations
//! (3.5)–(3.7) mapped back to the angles, the double pendulum by Cramer's rule.

use lagrangian::prelude::*;
use nalgebra::SVector;

/// The symmetric top (4.7) with gravity.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    kinetic = 0.5 * (i * (dot(phi).powi(2) * sin(theta).powi(2) + dot(theta).powi(2))
        + i_s * (dot(phi) * cos(theta) + dot(psi)).powi(2)),
    potential = m * g * l * cos(theta),
)]
pub(crate) struct SymmetricTop {
    /// The inertia about the axes across.
    pub(crate) i: f64,
    /// The inertia about the axis of symmetry.
    pub(crate) i_s: f64,
    /// The mass.
    pub(crate) m: f64,
    /// The acceleration of gravity.
    pub(crate) g: f64,
    /// The distance of the centre of mass from the pivot.
    pub(crate) l: f64,
}

impl SymmetricTop {
    /// The accelerations by hand.
    #[inline]
    #[must_use]
    pub(crate) fn by_hand(&self, state: &State<f64, 3>) -> SVector<f64, 3> {
        let (sin, cos) = state.q[1].sin_cos();
        let [phi, theta, psi] = [state.v[0], state.v[1], state.v[2]];
        let spin = self.i_s * (phi * cos + psi);
        let phi_rate = theta * (spin - 2.0 * self.i * phi * cos) / (self.i * sin);
        let fall = self.m * self.g * self.l;
        let theta_rate = sin * (fall + phi * (self.i * phi * cos - spin)) / self.i;
        SVector::from([phi_rate, theta_rate, phi * theta * sin - phi_rate * cos])
    }
}

/// The general top (4.5) with gravity, its centre of mass on the third axis.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (i1 * w1.powi(2) + i2 * w2.powi(2) + i3 * w3.powi(2)),
    potential = m * g * l * cos(theta),
)]
pub(crate) struct GeneralTop {
    /// The inertia about the first axis.
    pub(crate) i1: f64,
    /// The inertia about the second axis.
    pub(crate) i2: f64,
    /// The inertia about the third axis.
    pub(crate) i3: f64,
    /// The mass.
    pub(crate) m: f64,
    /// The acceleration of gravity.
    pub(crate) g: f64,
    /// The distance of the centre of mass from the pivot.
    pub(crate) l: f64,
}

impl GeneralTop {
    /// The accelerations by hand.
    #[inline]
    #[must_use]
    pub(crate) fn by_hand(&self, state: &State<f64, 3>) -> SVector<f64, 3> {
        let (st, ct) = state.q[1].sin_cos();
        let (sp, cp) = state.q[2].sin_cos();
        let [phi, theta, psi] = [state.v[0], state.v[1], state.v[2]];
        let w1 = phi * st * sp + theta * cp;
        let w2 = phi * st * cp - theta * sp;
        let w3 = phi * ct + psi;
        let fall = self.m * self.g * self.l * st;
        let a1 = ((self.i2 - self.i3) * w2 * w3 + fall * cp) / self.i1;
        let a2 = ((self.i3 - self.i1) * w3 * w1 - fall * sp) / self.i2;
        let a3 = (self.i1 - self.i2) * w1 * w2 / self.i3;
        // ω̇ = E q̈ + Ė q̇, solved for q̈.
        let across = a1 * sp + a2 * cp - phi * ct * theta + theta * psi;
        let along = a1 * cp - a2 * sp - phi * st * psi;
        let phi_rate = across / st;
        SVector::from([phi_rate, along, a3 - phi_rate * ct + phi * st * theta])
    }
}

/// Two equal masses on massless rods, at absolute angles.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(a, b),
    define(
        x1 = l * sin(a), y1 = -l * cos(a),
        x2 = x1 + l * sin(b), y2 = y1 - l * cos(b),
    ),
    kinetic = 0.5 * m * (dot(x1).powi(2) + dot(y1).powi(2) + dot(x2).powi(2) + dot(y2).powi(2)),
    potential = m * g * (y1 + y2),
)]
pub(crate) struct DoublePendulum {
    /// Each mass.
    pub(crate) m: f64,
    /// The acceleration of gravity.
    pub(crate) g: f64,
    /// The length of each rod.
    pub(crate) l: f64,
}

impl DoublePendulum {
    /// The accelerations by hand.
    #[inline]
    #[must_use]
    pub(crate) fn by_hand(&self, state: &State<f64, 2>) -> SVector<f64, 2> {
        let [a, b] = [state.q[0], state.q[1]];
        let (sin, cos) = (a - b).sin_cos();
        let pull = self.g / self.l;
        let first = -sin * state.v[1] * state.v[1] - 2.0 * pull * a.sin();
        let second = sin * state.v[0] * state.v[0] - pull * b.sin();
        let determinant = 1.0 + sin * sin;
        SVector::from([
            (first - cos * second) / determinant,
            (2.0 * second - cos * first) / determinant,
        ])
    }
}
