use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), force(x = push))]
struct Driven {
    m: f64,
    #[lagrangian(input)]
    push: f64,
}

fn main() {
    let driven = Driven { m: 1.0, push: 0.0 };
    let start = State::new(0.0, [0.0], [0.0]);
    let _ = Problem::new(&driven, start).driven_by([|t: f64| t.sin()]);
}
