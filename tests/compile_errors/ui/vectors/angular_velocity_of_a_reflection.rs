use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b, c),
    kinetic = 0.5 * m * (dot(a).powi(2) + dot(b).powi(2) + dot(c).powi(2)),
    potential = angular_velocity(diagonal([1, 1, -1]) * rotation_x(a)).norm(),
)]
struct Model {
    m: f64,
    k: f64,
}

fn main() {}
