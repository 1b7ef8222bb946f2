use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(inputs),
    kinetic = 0.5 * m * dot(inputs).powi(2),
    force(inputs = push),
)]
struct Model {
    m: f64,
    #[lagrangian(input)]
    push: f64,
}

fn main() {
    let _ = Model::INPUTS[Model::PUSH];
}
