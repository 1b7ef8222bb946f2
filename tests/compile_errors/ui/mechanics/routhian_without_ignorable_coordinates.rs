use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi, x),
    define(w = angular_velocity_zxz(phi, theta, psi)),
    kinetic = 0.5 * m * dot(x).powi(2) + 0.5 * a * (w.x.powi(2) + w.y.powi(2)) + 0.5 * c * w.z.powi(2),
    potential = x * cos(theta),
    dissipation = 0.5 * friction * dot(psi).powi(2),
    force(phi = torque, psi = -m),
    routhian(Reduced),
)]
struct Model {
    m: f64,
    a: f64,
    c: f64,
    friction: f64,
    #[lagrangian(input)]
    torque: f64,
}

fn main() {}
