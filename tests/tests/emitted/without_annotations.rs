//! What a model of plain numbers knows without a state is had without naming a scalar.

#![allow(clippy::float_cmp)] // Parameters are returned as they are.

use lagrangian::prelude::*;
use lagrangian::quantities;

/// Two carriages on a rail: one is pushed, the other floats. The energy at the height of the rail moves nothing.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * dot(x).powi(2) + 0.5 * n * dot(y).powi(2),
    potential = 0.5 * k * x.powi(2) + height,
    force(x = push),
    regressor(m, n, k, height),
    sensitivities(m),
    routhian(Carriage),
)]
struct Carriages {
    m: f64,
    n: f64,
    k: f64,
    height: f64,
    #[lagrangian(input)]
    push: f64,
}

const CARRIAGES: Carriages = Carriages {
    m: 2.0,
    n: 3.0,
    k: 5.0,
    height: 7.0,
    push: 0.25,
};

#[test]
fn constants_are_those_of_the_type() {
    assert_eq!(Carriages::WITHOUT_EFFECT, ["height"]);
    assert_eq!(Carriages::BASE_PARAMETERS.len(), 3);
    assert_eq!(Carriages::PARAMETERS, ["m"]);
    assert_eq!(Carriages::CONSTANTS_OF_MOTION, ["p_y"]);
    assert_eq!(Carriages::IGNORABLE_COORDINATES, [1]);
    const { assert!(!Carriages::CONSERVES_ENERGY) };
    assert_eq!(Carriage::ELIMINATED, ["y"]);
    // The traits have the same.
    assert_eq!(
        <Carriages as quantities::Regressor<2, 3, f32>>::WITHOUT_EFFECT,
        Carriages::WITHOUT_EFFECT
    );
    assert_eq!(
        <Carriages as ConstantsOfMotion<2, 1, f32>>::CONSTANTS_OF_MOTION,
        Carriages::CONSTANTS_OF_MOTION
    );
    assert_eq!(
        <Carriage as Routhian<1, 1, f32>>::ELIMINATED,
        Carriage::ELIMINATED
    );
}

#[test]
fn values_are_those_of_the_parameters() {
    let mut parameters = CARRIAGES.base_parameters().data.0[0];
    parameters.sort_by(f64::total_cmp);
    assert_eq!(parameters, [2.0, 3.0, 5.0]);
    assert_eq!(CARRIAGES.inputs()[Carriages::PUSH], 0.25);
    let start = State::new(0.0, [0.1, 0.2], [0.3, 0.4]);
    let (carriage, _) = CARRIAGES.reduce(&start);
    assert_eq!(carriage.constants()[0], 3.0 * 0.4);
    assert_eq!(carriage.inputs()[0], 0.25);
    // On other scalars they are the traits'.
    let inputs = quantities::Quantities::<2, f32>::inputs(&CARRIAGES);
    assert_eq!(inputs[0], 0.25_f32);
}
