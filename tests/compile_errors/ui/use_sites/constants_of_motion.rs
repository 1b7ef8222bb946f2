use lagrangian::prelude::*;

/// Driven along and held by a spring.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * m * x.powi(2),
    force(x = push),
)]
struct Cart {
    m: f64,
    #[lagrangian(input)]
    push: f64,
}

fn main() {
    let cart = Cart { m: 1.0, push: 0.0 };
    let start = State::new(0.0, [0.0], [0.0]);
    let _ = ConstantsOfMotion::<1, 1>::constants_of_motion(&cart, &start);
    let _ = RouthReduction::<1, 0>::reduce(&cart, &start);
}
