use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * stiffness * x.powi(2),
    force(x = push),
)]
struct Model<T> {
    m: T,
    stiffness: T,
    #[lagrangian(input)]
    push: T,
}

fn main() {
    let model = Model {
        m: 1.0,
        stiffness: 2.0,
        push: 3.0,
    };
    let state = State::new(0.0, [1.0], [0.0]);
    let accelerations: SVector<f64, 1> = model.accelerations(&state);
    println!("{} {}", accelerations[0], model.inputs()[0]);
}
