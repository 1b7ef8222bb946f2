use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, r: Vector3),
    kinetic = 0.5 * m * l * dot(theta) + 0.5 * m * dot(r[0]).powi(2),
    kinetic = m * (dot(r).y + dot(r).z),
    potential = -m * g * l * cos(theta),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
