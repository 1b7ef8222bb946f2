/// A symmetric top: (4.7) with gravity.
#[lagrangian(
    coordinates(phi, theta, psi),
    kinetic = 0.5 * (I * (dot(phi).powi(2) * sin(theta).powi(2) + dot(theta).powi(2))
        + I_s * (dot(phi) * cos(theta) + dot(psi)).powi(2)),
    potential = m * g * l * cos(theta),
)]
struct SymmetricTop { I: f64, I_s: f64, m: f64, g: f64, l: f64 }
