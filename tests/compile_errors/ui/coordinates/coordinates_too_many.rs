use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r[500]: Vector3, s[100][11], p[2][10][51]: Vector2),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
