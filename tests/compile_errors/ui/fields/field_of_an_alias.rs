use lagrangian::Lagrangian;

type Inertia = [[f64; 3]; 3];

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, x),
    kinetic = 0.5 * m * (dot(theta).powi(2) + dot(x).powi(2)),
)]
struct Model {
    m: f64,
    l: Inertia,
}

fn main() {}
