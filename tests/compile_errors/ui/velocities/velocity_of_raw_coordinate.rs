use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r#type),
    kinetic = 0.5 * m * l.powi(2) * dot(r#type).powi(2),
    potential = -m * g * l * r#type_dot,
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
