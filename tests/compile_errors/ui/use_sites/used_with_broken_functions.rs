use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(drag(v) = v * v, derivative(v) = 2.0 * height),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -drag(dot(x))),
)]
struct Model {
    m: f64,
}

fn main() {
    let model = Model { m: 1.0 };
    let state = State::new(0.0, [0.0], [1.0]);
    println!("{}", model.accelerations(&state)[0]);
    println!("{:?}", model.check_derivatives("drag", [0.0..=1.0]));
}
