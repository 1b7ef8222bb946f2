use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * PI * dot(theta).powi(2),
)]
struct Model {
    #[allow(non_snake_case)]
    PI: f64,
}

fn main() {}
