/// A heavy top, pinned at a fixed point; z-x-z Euler angles.
#[derive(Lagrangian)]
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
pub struct HeavyTop {
    pub i1: f64,
    pub i2: f64,
    pub i3: f64,
    pub m: f64,
    pub g: f64,
    pub l: f64,
}
