//! A gyroscope that finds north.

use lagrangian::prelude::*;

/// A gyrocompass: a symmetric rotor whose axis a frame keeps horizontal, at the azimuth α from north, and that turns about
/// its axis by ψ. The Earth carries it along.
///
/// The axis swings about north with the period 2π √(A/(C ω Ω cos λ)), since C ω₃ is constant.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian_models::Gyrocompass;
///
/// let (a, c, rate, latitude) = (0.04, 0.06, 7.292e-5, 0.9_f64);
/// let compass = Gyrocompass { a, c, rate, latitude };
/// let (alpha, spin) = (0.3_f64, 2000.0);
/// let state = State::new(0.0, [alpha, 0.0], [1e-3, spin]);
/// let across = rate * latitude.cos();
/// let total = spin + across * alpha.cos();
/// let expected = -c * total * across * alpha.sin() + a * across * across * alpha.sin() * alpha.cos();
/// assert!((a * compass.accelerations(&state)[0] - expected).abs() < 1e-15);
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(alpha, psi),
    define(
        w1 = -rate * cos(latitude) * sin(alpha),
        w2 = dot(alpha) + rate * sin(latitude),
        w3 = dot(psi) + rate * cos(latitude) * cos(alpha),
    ),
    kinetic = 0.5 * a * (w1.powi(2) + w2.powi(2)) + 0.5 * c * w3.powi(2),
)]
pub struct Gyrocompass {
    /// The moment of inertia A of the rotor across its axis in kg m².
    pub a: f64,
    /// The moment of inertia C of the rotor about its axis in kg m².
    pub c: f64,
    /// The angular velocity Ω of the Earth in rad/s.
    pub rate: f64,
    /// The latitude λ in rad.
    pub latitude: f64,
}
