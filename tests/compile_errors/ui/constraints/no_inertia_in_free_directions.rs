use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, z),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = m * g * y,
    constraint(rod = x + y + z - l),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
