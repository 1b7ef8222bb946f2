//! Linear models of mechanisms whose parameters are of a type parameter, such as dual numbers.

use lagrangian::analysis::{EquilibriumSearch, StateSpace, TangentSpace};
use lagrangian::prelude::*;
use lagrangian::{Dual, Scalar};

use super::mechanisms::Bob as Plain;

/// A bob on a rod, with parameters of all shapes.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m[0] * (dot(x).powi(2) + dot(y).powi(2)),
    potential = -m[0] * gravity.dot([x, y]) * half[1][1] * factor,
    constraint(rod = x.powi(2) + y.powi(2) - l.powi(2)),
)]
struct Bob<T: Scalar = f64> {
    m: [T; 2],
    gravity: Vector2<T>,
    half: Matrix2<T>,
    factor: f64,
    l: T,
    #[lagrangian(skip)]
    name: String,
}

fn bob<T: Scalar>(m: T, g: T, l: T) -> Bob<T> {
    let number = T::from_f64;
    Bob {
        m: [m, number(0.0)],
        gravity: Vector2::new(number(0.0), -g),
        half: Matrix2::from_element(number(0.5)),
        factor: 2.0,
        l,
        name: "a bob".to_owned(),
    }
}

#[test]
fn a_model_on_its_own_scalar() {
    let (found, expected) = (bob(0.3, 9.81, 0.7), Plain::EXAMPLE);
    assert_eq!(found.name.len(), 5);
    let swinging = expected.at(0.8, 1.7);
    let found = TangentSpace::at(&found, &swinging).along_motion();
    let found = StateSpace::<f64, 2, 0, 2>::reduced_free(&found).expect("regular");
    let expected = TangentSpace::at(&expected, &swinging).along_motion();
    let expected = StateSpace::<f64, 2, 0, 2>::reduced_free(&expected).expect("regular");
    assert!((found.a - expected.a).amax() < 1e-14);
}

/// ω² = g/l of the hanging bob, and its derivatives by g and by l; the equilibrium moves with the rod.
#[test]
fn linear_models_are_differentiated_by_parameters() {
    let [m, g, l] = [0.3, 9.81, 0.7];
    let dual = bob(
        Dual::<f64, 2>::constant(m),
        Dual::variable(g, 0),
        Dual::variable(l, 1),
    );
    let constant = Dual::<f64, 2>::constant;
    let guess = State::new(
        constant(0.0),
        [0.1, -0.6].map(constant),
        [0.0; 2].map(constant),
    );
    let found = EquilibriumSearch::constrained(&dual).near(&guess);
    let hanging = found.expect("it hangs").state;
    let lowest = hanging.q[Bob::<f64>::Y];
    assert!((lowest.value + l).abs() < 1e-14 && (lowest.derivative[1] + 1.0).abs() < 1e-13);
    assert!(lowest.derivative[0].abs() < 1e-13);
    let tangent = TangentSpace::at(&dual, &hanging);
    let plant = StateSpace::<Dual<f64, 2>, 2, 0, 2>::reduced_free(&tangent).expect("it hangs");
    let square = plant.a[(1, 0)];
    assert!((square.value + g / l).abs() < 1e-13);
    assert!((square.derivative[0] + 1.0 / l).abs() < 1e-12);
    assert!((square.derivative[1] - g / (l * l)).abs() < 1e-11);
}
