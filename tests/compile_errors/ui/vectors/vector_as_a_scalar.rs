use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r[2]: Vector3, q: Vector2),
    kinetic = 0.5 * m * (dot(r).norm_squared() + dot(q).powi(2)),
    potential = g * r[2].x + l * r[0][3] + q.z + r_dot.x + q,
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
