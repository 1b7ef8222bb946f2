/// A top without symmetry: (4.5) with gravity.
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        omega_1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        omega_2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        omega_3 = dot(phi) * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (I_1 * omega_1.powi(2) + I_2 * omega_2.powi(2) + I_3 * omega_3.powi(2)),
    potential = m * g * l * cos(theta),
)]
struct GeneralTop { I_1: f64, I_2: f64, I_3: f64, m: f64, g: f64, l: f64 }
