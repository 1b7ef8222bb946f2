use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, X),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(X).powi(2)),
)]
struct Model {
    m: f64,
}

fn main() {
    let _ = Model::X;
}
