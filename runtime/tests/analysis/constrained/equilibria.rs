//! Equilibria of mechanisms, and the inputs that hold them.

use lagrangian::analysis::{
    EquilibriumError, EquilibriumSearch, StateSpace, TangentSpace, Variable,
};
use lagrangian::prelude::*;

use super::linkages::*;
use super::mechanisms::*;

/// A bob on a rod that a force holds, and a spring of no length at its support.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    force(x = push),
    constraint(rod = x.powi(2) + y.powi(2) - l.powi(2)),
)]
struct Held {
    m: f64,
    g: f64,
    l: f64,
    #[lagrangian(input)]
    push: f64,
}

/// A bead that slides down a straight wire.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = 9.81 * y,
    constraint(wire = y - slope * x),
)]
struct Slide {
    slope: f64,
}

#[test]
fn equilibria_of_a_crank_in_all_coordinates() {
    let (three, seven, alone) = (Crank::EXAMPLE, CrankOfBodies::EXAMPLE, CrankAlone::EXAMPLE);
    for angle in [-1.5, -2.0, 0.5] {
        let minimal = EquilibriumSearch::of(&alone).near(&State::new(0.0, [angle], [0.0]));
        let alpha = minimal.expect("an equilibrium").state.q[0];
        // From states that do not meet the constraints.
        let mut guess = three.turned(angle, 0.0);
        guess.q[Crank::BETA] += 0.05;
        let found = EquilibriumSearch::constrained(&three)
            .near(&guess)
            .expect("an equilibrium");
        let mut guess = seven.turned(angle, 0.0);
        guess.q.iter_mut().for_each(|q| *q += 0.02);
        let other = EquilibriumSearch::constrained(&seven)
            .near(&guess)
            .expect("an equilibrium");
        let found = [
            found.state.q[Crank::ALPHA],
            other.state.q[CrankOfBodies::ALPHA],
        ];
        assert!(
            found.iter().all(|x| (x - alpha).abs() < 1e-11),
            "{found:?} {alpha}"
        );
        let tangent = TangentSpace::at(&seven, &other.state).coordinates([CrankOfBodies::ALPHA]);
        let tangent = tangent.velocities([CrankOfBodies::ALPHA]);
        let reduced = StateSpace::<f64, 2, 0, 2>::reduced_free(&tangent).expect("an equilibrium");
        let minimal = StateSpace::<f64, 2, 0, 2>::free(&alone, &State::new(0.0, [alpha], [0.0]));
        assert!((reduced.a - minimal.a).amax() < 1e-10 * minimal.a.amax());
    }
}

/// Along the linkage the potential energy is least.
#[test]
fn a_linkage_settles() {
    let linkage = FourBar::EXAMPLE;
    let guess = State::new(0.0, [-0.5, 0.9, 1.8], [0.0; 3]);
    let found = EquilibriumSearch::constrained(&linkage)
        .near(&guess)
        .expect("an equilibrium");
    let energy = |change: f64| {
        let mut moved = found.state;
        moved.q[FourBar::CRANK] += change;
        let moved = linkage.assemble(moved).hold([FourBar::CRANK]).solve();
        linkage.potential_energy(&moved.expect("it closes").state)
    };
    let slope = (energy(1e-5) - energy(-1e-5)) / 2e-5;
    assert!(slope.abs() < 1e-8 && energy(0.1) > energy(0.0) && energy(-0.1) > energy(0.0));
    let tangent = TangentSpace::at(&linkage, &found.state);
    let plant = StateSpace::<f64, 2, 0, 2>::reduced_free(&tangent).expect("an equilibrium");
    assert!(plant.poles().expect("finite").abscissa() < 0.0);
}

#[test]
fn redundant_constraints_and_contacts() {
    let platform = Platform {
        m: 2.0,
        g: 9.81,
        l: 0.9,
    };
    let guess = State::new(0.0, [0.3, -0.8, 0.0], [0.0; 3]);
    let found = EquilibriumSearch::constrained(&platform)
        .near(&guess)
        .expect("it hangs");
    assert!(
        (found.state.q - Vector3::new(0.0, -0.9, 0.0)).amax() < 1e-11,
        "{found:?}"
    );

    let disc = Disc {
        m: 0.4,
        r: 0.4,
        g: 9.81,
    };
    let guess = State::new(0.0, [1.0, 2.0, 0.3, 0.5, 1.2, 0.3], [0.0; 6]);
    let found = EquilibriumSearch::constrained(&disc)
        .near(&guess)
        .expect("it stands upright");
    assert!((found.state.q[Disc::THETA] - core::f64::consts::FRAC_PI_2).abs() < 1e-11);
}

#[test]
fn a_force_holds_a_bob() {
    let held = Held {
        m: 0.3,
        g: 9.81,
        l: 0.7,
        push: 0.0,
    };
    let (sine, cosine) = 0.6_f64.sin_cos();
    let guess = State::new(0.0, [0.7 * sine, -0.7 * cosine], [0.0; 2]);
    let push = Variable::Input(Held::PUSH);
    let found = EquilibriumSearch::constrained_trim(&held)
        .unknown(&[push])
        .near(&guess);
    let found = found.expect("it is held");
    assert!((found.inputs[0] - 0.3 * 9.81 * 0.6_f64.tan()).abs() < 1e-13);
    assert!((found.state.q - guess.q).amax() < 1e-15);
    // With the push held, the bob finds its place.
    let pushed = held.with_inputs(found.inputs);
    let found =
        EquilibriumSearch::constrained(&pushed).near(&State::new(0.0, [0.2, -0.65], [0.0; 2]));
    assert!((found.expect("an equilibrium").state.q - guess.q).amax() < 1e-13);
}

#[test]
fn what_has_no_equilibrium() {
    let slide = Slide { slope: 0.5 };
    let error = EquilibriumSearch::constrained(&slide).near(&State::new(0.0, [1.0, 0.5], [0.0; 2]));
    let error = error.expect_err("it slides");
    assert!(
        matches!(
            error,
            EquilibriumError::Unbalanced { .. } | EquilibriumError::Stalled { .. }
        ),
        "{error}"
    );
    // What is given does not meet the constraint.
    let bob = Bob::EXAMPLE;
    let guess = State::new(0.0, [1.0, 0.0], [0.0; 2]);
    let error = EquilibriumSearch::constrained(&bob)
        .unknown(&[Variable::Coordinate(Bob::Y)])
        .near(&guess);
    let error = error.expect_err("the rod is shorter");
    assert!(
        error.last().is_some() && !error.to_string().is_empty(),
        "{error}"
    );
    let error = EquilibriumSearch::constrained(&bob)
        .momentum(Bob::X, 1.0)
        .near(&bob.at(0.0, 0.0));
    assert!(matches!(
        error,
        Err(EquilibriumError::NoConstantMomentum { name: "x" })
    ));
}
