use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(coordinates(theta), kinetic = 0.5 * m * dot(theta).powi(2))]
enum Model {
    One,
}

fn main() {
    let _ = Model::One;
    let _ = Model::THETA;
}
