//! A module without the prelude of the standard library: emitted code brings what it needs.
#![no_implicit_prelude]

use ::std::{assert, primitive::f64};

#[derive(::lagrangian::Lagrangian)]
#[lagrangian(
    crate = "::lagrangian",
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2) * (1 + x * x)),
    potential = 0.5 * x * x * y + k[(0, 1)] * x,
    force(y = u),
    output(both = [x, y], acceleration = dot(dot(x))),
    event(floor = y),
    taylor,
    hamiltonian,
    energy_balance,
    sensitivities,
    regressor(m),
)]
struct Model {
    m: f64,
    k: ::lagrangian::nalgebra::Matrix2<f64>,
    #[lagrangian(input)]
    u: f64,
}

#[derive(::lagrangian::Lagrangian)]
#[lagrangian(
    crate = "::lagrangian",
    coordinates(x, angle),
    kinetic = 0.5 * m * (dot(x).powi(2) + x.powi(2) * dot(angle).powi(2)),
    potential = 0.5 * x.powi(2),
    routhian(Radial),
    taylor,
)]
struct Planar {
    m: f64,
}

#[test]
fn emitted_code_needs_no_prelude() {
    use ::lagrangian::{Lagrangian as _, State};
    let model = Model {
        m: 2.0,
        k: ::lagrangian::nalgebra::Matrix2::new(1.0, 2.0, 3.0, 4.0),
        u: 1.0,
    };
    let state = State::new(0.0, [1.0, 2.0], [0.0, 0.0]);
    let x: f64 = model.accelerations(&state)[0];
    assert!((x + 2.0).abs() < 1e-15);
    let planar = Planar { m: 2.0 };
    let state = State::new(0.0, [1.0, 0.0], [0.0, 1.0]);
    let x: f64 = planar.accelerations(&state)[0];
    assert!((x - 0.5).abs() < 1e-15);
}
