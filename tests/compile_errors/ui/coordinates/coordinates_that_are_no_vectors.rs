use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r: Rotation3, a: Matrix3<f64>, b: [f64; 3], c: &Vector3, d: Vector3<usize>, e[0]: Vector2),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
