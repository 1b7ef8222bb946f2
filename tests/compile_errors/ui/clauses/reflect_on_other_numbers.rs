use lagrangian::prelude::*;
use lagrangian::quantities::Reflect;

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), scalar = f32, reflect)]
struct Single {
    m: f32,
}

#[derive(Lagrangian)]
#[lagrangian(reflect, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), reflect)]
struct Twice {
    m: f64,
}

struct Unit;

#[derive(Lagrangian)]
#[lagrangian(reflect, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
struct WithoutDefault {
    m: f64,
    #[lagrangian(skip)]
    unit: Unit,
}

#[derive(Lagrangian)]
#[lagrangian(reflect, coordinates(x), kinetic = 0.5 * (turn[(0, 0)] + 2) * dot(x).powi(2))]
struct WithRotation {
    turn: lagrangian::nalgebra::Rotation3<f64>,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
struct WithoutClause {
    m: f64,
}

fn main() {
    let _ = WithoutClause::from_numbers(&[1.0]);
    let _ = <WithoutClause as Reflect<1>>::NAME;
}
