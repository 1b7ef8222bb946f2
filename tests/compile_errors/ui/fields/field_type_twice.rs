use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, x),
    kinetic = 0.5 * m * (dot(theta).powi(2) + dot(x).powi(2)),
)]
struct Model {
    m: f64,
    #[lagrangian(type = f64, type = f32)]
    l: f64,
}

fn main() {}
