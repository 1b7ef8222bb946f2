use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, other),
    kinetic = 0.5 * intertia * (dot(theta).powi(2) + dot(other).powi(2)),
    potential = mass * z + z * gravty * length * cos(theta),
)]
struct Model {
    inertia: f64,
    gravity: f64,
    lengths: f64,
}

fn main() {}
