use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(operations),
    kinetic = 0.5 * m * dot(operations).powi(2),
)]
struct Model {
    m: f64,
}

fn main() {
    let _ = Model::OPERATIONS;
}
