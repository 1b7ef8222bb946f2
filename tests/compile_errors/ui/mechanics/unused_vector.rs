use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, r: Vector3, s[2]: Vector2, p[3]),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(s[0]).norm_squared() + dot(p[1]).powi(2)),
    potential = g * l,
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
