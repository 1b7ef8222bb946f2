use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, a),
    kinetic = 0.5 * m * ((dot(x) * cos(a) - dot(y) * sin(a)).powi(2) + dot(a).powi(2)),
)]
struct Model {
    m: f64,
}

fn main() {}
