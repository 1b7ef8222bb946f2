//! The systems of these tests, with their reduced models.

use lagrangian::prelude::*;

/// A symmetric top as three squares (4.5), of which two have the same inertia.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(w = angular_velocity_zxz(phi, theta, psi)),
    kinetic = 0.5 * i * w.x.powi(2) + 0.5 * i * w.y.powi(2) + 0.5 * i_s * w.z.powi(2),
    potential = m * g * l * cos(theta),
    taylor,
    routhian(ReducedTop),
)]
pub(crate) struct Top {
    pub(crate) i: f64,
    pub(crate) i_s: f64,
    pub(crate) m: f64,
    pub(crate) g: f64,
    pub(crate) l: f64,
}

/// The same for motions through the poles.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(w = angular_velocity_zxz(phi, theta, psi)),
    kinetic = 0.5 * i * w.x.powi(2) + 0.5 * i * w.y.powi(2) + 0.5 * i_s * w.z.powi(2),
    potential = m * g * l * cos(theta),
    taylor,
    routhian(TopThroughPoles, half_angles),
)]
pub(crate) struct PolarTop {
    pub(crate) i: f64,
    pub(crate) i_s: f64,
    pub(crate) m: f64,
    pub(crate) g: f64,
    pub(crate) l: f64,
}

/// A body about a centre that attracts it. Its constants are in H. Goldstein, C. Poole and J. Safko, Classical Mechanics,
/// 3rd edition, 2002, 3.2.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    potential = -m * mu / r,
    routhian(RadialMotion),
)]
pub(crate) struct Kepler {
    pub(crate) m: f64,
    pub(crate) mu: f64,
}

/// A pendulum on a sphere. Its constants are in L. D. Landau and E. M. Lifshitz, Mechanics, 3rd edition, 1976, § 14, problem 1.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, phi),
    define(r = l * [sin(theta) * cos(phi), sin(theta) * sin(phi), -cos(theta)]),
    kinetic = 0.5 * m * dot(r).norm_squared(),
    potential = m * g * r.z,
    routhian(ReducedSphericalPendulum),
)]
pub(crate) struct SphericalPendulum {
    pub(crate) m: f64,
    pub(crate) l: f64,
    pub(crate) g: f64,
}

/// Furuta's pendulum without a motor; the rod is driven and damped: forces that are not on the arm depend on its velocity.
/// The free pendulum is that of J. Á. Acosta, Furuta's pendulum: a conservative nonlinear model for theory
/// and practise, Mathematical Problems in Engineering 2010, 742894.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(arm, rod),
    define(
        turn = rotation_z(arm),
        along = turn * [1.0, 0.0, 0.0],
        down = turn * [0.0, sin(rod), -cos(rod)],
        center = length * along + l * down,
    ),
    kinetic = 0.5 * inertia_arm * dot(along).norm_squared()
        + 0.5 * m * dot(center).norm_squared()
        + 0.5 * inertia_rod * dot(down).norm_squared(),
    potential = m * g * center.z,
    dissipation = 0.5 * friction * dot(rod).powi(2),
    force(rod = torque + 0.1 * friction * dot(arm)),
    taylor,
    routhian(ReducedFurutaPendulum),
)]
pub(crate) struct FurutaPendulum {
    pub(crate) inertia_arm: f64,
    pub(crate) inertia_rod: f64,
    pub(crate) m: f64,
    pub(crate) length: f64,
    pub(crate) l: f64,
    pub(crate) g: f64,
    pub(crate) friction: f64,
    #[lagrangian(input)]
    pub(crate) torque: f64,
}

/// A gyroscope in two gimbals: K. Magnus, Gyrodynamics, 1974, the chapter on gyrostats and gyros in gimbals.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(alpha, beta, gamma),
    define(
        inner = angular_velocity_zx(alpha, beta),
        rotor = angular_velocity_zxz(alpha, beta, gamma),
    ),
    kinetic = 0.5 * outer_gimbal * dot(alpha).powi(2)
        + 0.5 * inner.dot(diagonal(inner_gimbal) * inner)
        + 0.5 * rotor.dot(diagonal([a, a, c]) * rotor),
    potential = weight * cos(beta),
    routhian(ReducedGyroscope),
)]
pub(crate) struct Gyroscope {
    pub(crate) outer_gimbal: f64,
    pub(crate) inner_gimbal: [f64; 3],
    pub(crate) a: f64,
    pub(crate) c: f64,
    pub(crate) weight: f64,
}

/// A symmetric satellite on a circular orbit, in angles from the frame of the orbit: gyroscopic terms, and two coordinates
/// that remain. Of P. W. Likins, Stability of a symmetrical satellite in attitudes fixed in an orbiting reference frame,
/// Journal of the Astronautical Sciences 12, 1965, 18–24.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        r = rotation_zxz(phi, theta, psi),
        w = angular_velocity_zxz(phi, theta, psi) + r.transpose() * [0.0, n, 0.0],
    ),
    kinetic = 0.5 * w.dot(diagonal([i, i, i_s]) * w),
    potential = 1.5 * n.powi(2) * (i_s - i) * cos(theta).powi(2),
    taylor,
    routhian(ReducedSatellite),
)]
pub(crate) struct Satellite {
    pub(crate) i: f64,
    pub(crate) i_s: f64,
    pub(crate) n: f64,
}

/// A charge in the field of a magnet along z, and an oscillator whose spring is stiffer the faster it moves: L is of the
/// fourth degree in the velocities, and of the second one in that of φ. One coordinate of a vector is ignorable.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi, p: Vector2),
    lagrangian = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2) + dot(p).norm_squared())
        + 0.05 * dot(r).powi(4) + 0.2 * dot(r).powi(2) * dot(phi).powi(2)
        + 0.5 * field * r.powi(2) * dot(phi) + 0.3 * sin(t) * dot(p.y) - 0.5 * k * (r.powi(2) + p.x.powi(2)),
    routhian(ReducedCharge),
)]
pub(crate) struct Charge {
    pub(crate) m: f64,
    pub(crate) field: f64,
    pub(crate) k: f64,
}

/// Parameters of any scalar, and a constant that is one, too.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    potential = -m * mu / r,
    routhian(RadialMotionOf),
)]
pub(crate) struct KeplerOf<T: Scalar> {
    pub(crate) m: T,
    pub(crate) mu: T,
}

pub(crate) fn top() -> Top {
    Top {
        i: 0.4,
        i_s: 0.1,
        m: 1.3,
        g: 9.81,
        l: 0.2,
    }
}

pub(crate) fn polar_top() -> PolarTop {
    let Top { i, i_s, m, g, l } = top();
    PolarTop { i, i_s, m, g, l }
}
