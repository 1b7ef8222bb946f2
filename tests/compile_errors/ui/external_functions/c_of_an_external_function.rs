use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(hill(x) = x.sin(), derivative(x) = cos(x)),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = m * hill(x),
    c,
)]
struct Model {
    m: f64,
}

fn main() {
    let _ = (Model::C_SOURCE, Model::C_HEADER);
}
