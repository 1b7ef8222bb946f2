//! Linear models of constrained mechanisms: against differences along the manifold of their states, against mechanisms in
//! minimal coordinates, and against closed forms.

use lagrangian::analysis::{StateSpace, TangentSpace, Variable};
use lagrangian::prelude::*;
use lagrangian::quantities::DirectionalDerivatives;

mod derivatives;
mod equilibria;
mod identification;
mod in_space;
mod inverse_dynamics;
mod linkages;
mod mechanisms;
mod mistakes;
mod moving;
mod oscillations;
mod press;
mod sensitivities;
mod steady;
mod trailer;
mod type_parameters;

use linkages::*;
use mechanisms::*;

/// The part of a unit by which variables are displaced, and the weights of the differences between both sides at once and twice
/// this distance.
const STEP: f64 = 1e-4;
const WEIGHTS: [f64; 2] = [8.0 / 12.0, -1.0 / 12.0];

/// The error of what is differentiated numerically, relative to the largest entry.
fn error<const R: usize, const C: usize>(
    found: &SMatrix<f64, R, C>,
    expected: &SMatrix<f64, R, C>,
) -> f64 {
    (found - expected).amax() / expected.amax().max(1.0)
}

/// Linearizes a mechanism about a state, which need not be steady, and compares with differences between consistent states. Some
/// coordinates are left out, and velocities are chosen, or proposed if there are none.
fn checked<M, const N: usize, const C: usize, const D: usize>(
    model: &M,
    state: &State<f64, N>,
    [without, velocities]: [&[usize]; 2],
) -> StateSpace<f64, D, 0, D>
where
    M: Lagrangian<N, Model: DirectionalDerivatives<N, C>>,
{
    let mut tangent = TangentSpace::at(model, state)
        .without(without.iter().copied())
        .along_motion();
    if !velocities.is_empty() {
        tangent = tangent.velocities(velocities.iter().copied());
    }
    let basis = tangent.basis::<D>().expect("a regular state");
    let plant = StateSpace::<f64, D, 0, D>::reduced_free(&tangent).expect("a regular state");
    let index = |variable: &Variable| match *variable {
        Variable::Coordinate(i) => (Some(i), None),
        Variable::Velocity(i) => (None, Some(i)),
        Variable::Input(_) => (None, None),
    };
    let coordinates = basis.variables.iter().filter_map(|x| index(x).0);
    let velocities = basis.variables.iter().filter_map(|x| index(x).1);
    let moved = |variable: &Variable, distance: f64| {
        let mut moved = *state;
        match *variable {
            Variable::Coordinate(i) => moved.q[i] += distance,
            Variable::Velocity(i) => moved.v[i] += distance,
            Variable::Input(_) => {}
        }
        let held = coordinates.clone().chain(without.iter().copied());
        let found = model
            .assemble(moved)
            .hold(held)
            .hold_velocities(velocities.clone());
        let found = found.solve().expect("states nearby").state;
        let rates = [found.v, model.accelerations(&found)];
        let rates = SVector::<f64, D>::from_fn(|i, _| match basis.variables[i] {
            Variable::Coordinate(i) => rates[0][i],
            Variable::Velocity(i) => rates[1][i],
            Variable::Input(_) => f64::NAN,
        });
        (found.q, found.v, rates)
    };
    for (j, variable) in basis.variables.iter().enumerate() {
        let (mut q, mut v, mut rates) = (SVector::zeros(), SVector::zeros(), SVector::zeros());
        for (times, weight) in [1.0, 2.0].into_iter().zip(WEIGHTS) {
            let sides = [STEP, -STEP].map(|step| moved(variable, times * step));
            let factor = weight / STEP;
            q += (sides[0].0 - sides[1].0) * factor;
            v += (sides[0].1 - sides[1].1) * factor;
            rates += (sides[0].2 - sides[1].2) * factor;
        }
        let errors = [
            error(&basis.q.column(j).into_owned(), &q),
            error(&basis.v.column(j).into_owned(), &v),
            error(&plant.a.column(j).into_owned(), &rates),
        ];
        assert!(
            errors.iter().all(|error| *error < 1e-8),
            "{variable:?}: {errors:?}"
        );
    }
    plant
}

/// Compares linear models of one mechanism in different coordinates by their poles.
fn same_poles<const D: usize>(
    found: &StateSpace<f64, D, 0, D>,
    minimal: &StateSpace<f64, D, 0, D>,
) {
    let [found, minimal] = [found, minimal].map(|plant| plant.poles().expect("finite"));
    for pole in minimal.iter() {
        let distance = found
            .iter()
            .map(|x| (x - pole).norm())
            .fold(f64::INFINITY, f64::min);
        assert!(distance < 1e-11 * minimal.radius(), "{found:?} {minimal:?}");
    }
}

/// Compares linear models in the same coordinates.
fn same_matrix<const D: usize>(
    found: &StateSpace<f64, D, 0, D>,
    minimal: &StateSpace<f64, D, 0, D>,
) {
    let error = error(&found.a, &minimal.a);
    assert!(error < 1e-11, "{error:e}: {} {}", found.a, minimal.a);
}

#[test]
fn a_pendulum_by_its_bob() {
    let (bob, angle) = (Bob::EXAMPLE, Angle { g: 9.81, l: 0.7 });
    for (direction, phi) in [(-1.0, 0.0), (1.0, core::f64::consts::PI)] {
        let state = State::new(0.0, [0.0, direction * bob.l], [0.0; 2]);
        let found = checked::<_, 2, 1, 2>(&bob, &state, [&[]; 2]);
        let minimal = StateSpace::<f64, 2, 0, 2>::free(&angle, &State::new(0.0, [phi], [0.0]));
        same_poles(&found, &minimal);
    }
    // Where x and y both move.
    let swinging = bob.at(1.0, 2.0);
    let plant = checked::<_, 2, 1, 2>(&bob, &swinging, [&[]; 2]);
    assert!(!plant.is_at_equilibrium(1.0));
}

#[test]
fn pendulums_by_their_bobs() {
    let chain = Bobs { g: 9.81 };
    let hanging = Bobs::at([0.0; 3], [0.0; 3]);
    let minimal = Angles { g: chain.g };
    let found = checked::<_, 6, 3, 6>(&chain, &hanging, [&[]; 2]);
    same_poles(
        &found,
        &StateSpace::<f64, 6, 0, 6>::free(&minimal, &State::new(0.0, [0.0; 3], [0.0; 3])),
    );
    checked::<_, 6, 3, 6>(
        &chain,
        &Bobs::at([0.4, -0.8, 1.5], [1.0, 2.0, -0.5]),
        [&[]; 2],
    );
}

#[test]
fn slider_cranks_turn_like_their_crank() {
    let (three, seven, minimal) = (Crank::EXAMPLE, CrankOfBodies::EXAMPLE, CrankAlone::EXAMPLE);
    for (angle, speed) in [(0.4, 3.0), (2.0, -1.5), (4.0, 0.0)] {
        let expected =
            StateSpace::<f64, 2, 0, 2>::free(&minimal, &State::new(0.0, [angle], [speed]));
        let state = three.turned(angle, speed);
        let tangent = TangentSpace::at(&three, &state)
            .coordinates([Crank::ALPHA])
            .velocities([Crank::ALPHA]);
        let found = StateSpace::<f64, 2, 0, 2>::reduced_free(&tangent.along_motion());
        same_matrix(&found.expect("regular"), &expected);
        checked::<_, 3, 2, 2>(&three, &state, [&[]; 2]);

        let state = seven.turned(angle, speed);
        let alpha = [CrankOfBodies::ALPHA];
        let tangent = TangentSpace::at(&seven, &state)
            .coordinates(alpha)
            .velocities(alpha);
        let found = StateSpace::<f64, 2, 0, 2>::reduced_free(&tangent.along_motion());
        same_matrix(&found.expect("regular"), &expected);
        checked::<_, 7, 6, 2>(&seven, &state, [&[]; 2]);
    }
}

#[test]
fn a_four_bar_linkage() {
    let linkage = FourBar::EXAMPLE;
    let guess = State::new(0.0, [0.9, 0.2, 1.5], [1.0, 0.0, 0.0]);
    let held = [FourBar::CRANK];
    let state = linkage
        .assemble(guess)
        .hold(held)
        .hold_velocities(held)
        .solve();
    let state = state.expect("it closes").state;
    checked::<_, 3, 2, 2>(&linkage, &state, [&[]; 2]);
    // A linkage that is driven has no freedom.
    let driven = DrivenFourBar::EXAMPLE;
    let state = driven.assemble(guess).solve().expect("it closes").state;
    let plant = checked::<_, 3, 3, 0>(&driven, &state, [&[]; 2]);
    assert_eq!(plant.a.len(), 0);
}

#[test]
fn a_bead_on_a_wire() {
    let (wire, minimal) = (
        Wire {
            m: 0.3,
            g: 9.81,
            c: 1.7,
        },
        WireAlone {
            m: 0.3,
            g: 9.81,
            c: 1.7,
        },
    );
    let (x, v) = (0.4, 1.3);
    let state = State::new(0.0, [x, wire.c * x * x], [v, 2.0 * wire.c * x * v]);
    checked::<_, 2, 1, 2>(&wire, &state, [&[]; 2]);
    let tangent = TangentSpace::at(&wire, &state)
        .coordinates([Wire::X])
        .velocities([Wire::X]);
    let found = StateSpace::<f64, 2, 0, 2>::reduced_free(&tangent.along_motion()).expect("regular");
    same_matrix(
        &found,
        &StateSpace::free(&minimal, &State::new(0.0, [x], [v])),
    );
}

#[test]
fn a_conical_pendulum() {
    let bob = Spherical {
        m: 0.8,
        g: 9.81,
        l: 1.3,
    };
    let (angle, height) = (0.5_f64, 1.3 * 0.5_f64.cos());
    let rate = (9.81 / height).sqrt();
    let radius = 1.3 * angle.sin();
    let state = State::new(0.0, [radius, 0.0, -height], [0.0, radius * rate, 0.0]);
    let plant = checked::<_, 3, 1, 4>(&bob, &state, [&[]; 2]);
    assert!((plant.a[(0, 2)] - 1.0).abs() <= 0.0);
}

#[test]
fn redundant_bars_of_a_platform() {
    let platform = Platform {
        m: 2.0,
        g: 9.81,
        l: 0.9,
    };
    let state = platform.at(0.0, 0.0);
    let found = checked::<_, 3, 3, 2>(&platform, &state, [&[]; 2]);
    same_poles(
        &found,
        &StateSpace::free(&Angle { g: 9.81, l: 0.9 }, &State::new(0.0, [0.0], [0.0])),
    );
    checked::<_, 3, 3, 2>(&platform, &platform.at(0.8, 1.5), [&[]; 2]);
}

#[test]
fn drives_at_constant_rates() {
    // A support that moves at a constant velocity leaves a pendulum as it is.
    let carried = Carried {
        m: 0.4,
        mass: 2.0,
        g: 9.81,
        l: 0.7,
        speed: 3.0,
    };
    let angle = Angle { g: 9.81, l: 0.7 };
    let state = State::new(0.0, [0.0, 0.0], [3.0, 0.0]);
    let tangent = TangentSpace::at(&carried, &state);
    let steady = StateSpace::<f64, 2, 0, 2>::reduced_free(&tangent).expect("steady");
    same_matrix(
        &steady,
        &StateSpace::free(&angle, &State::new(0.0, [0.0], [0.0])),
    );
    checked::<_, 2, 1, 2>(&carried, &state, [&[]; 2]);

    // A bead on a hoop that a motor turns.
    let (hoop, minimal) = (Hoop::EXAMPLE, HoopAlone::EXAMPLE);
    let theta = (9.81_f64 / (0.5 * 36.0)).acos();
    let state = State::new(0.0, [0.0, theta], [6.0, 0.0]);
    let tangent = TangentSpace::at(&hoop, &state);
    let steady = StateSpace::<f64, 2, 0, 2>::reduced_free(&tangent).expect("steady");
    same_matrix(
        &steady,
        &StateSpace::free(&minimal, &State::new(0.0, [theta], [0.0])),
    );
    checked::<_, 2, 1, 2>(&hoop, &state, [&[]; 2]);
}

#[test]
fn gears_and_ropes() {
    // A mass on a rope over a pulley, held by a spring and a damper: one linear equation.
    let (rope, minimal) = (Rope::EXAMPLE, RopeAlone::EXAMPLE);
    let state = State::new(0.0, [0.3, -0.3, 1.5], [0.0; 3]);
    let found = checked::<_, 3, 2, 2>(&rope, &state, [&[]; 2]);
    same_poles(
        &found,
        &StateSpace::free(&minimal, &State::new(0.0, [0.3], [0.0])),
    );
}

#[test]
fn a_rod_without_mass() {
    // The angle of the rod has no inertia.
    let (rod, minimal) = (
        MasslessRod {
            m: 0.5,
            g: 9.81,
            l: 0.7,
        },
        Angle { g: 9.81, l: 0.7 },
    );
    let (sine, cosine) = 0.6_f64.sin_cos();
    let state = State::new(
        0.0,
        [0.7 * sine, -0.7 * cosine, 0.6],
        [1.4 * cosine, 1.4 * sine, 2.0],
    );
    let phi = [MasslessRod::PHI];
    let tangent = TangentSpace::at(&rod, &state)
        .coordinates(phi)
        .velocities(phi)
        .along_motion();
    let found = StateSpace::<f64, 2, 0, 2>::reduced_free(&tangent).expect("regular");
    same_matrix(
        &found,
        &StateSpace::free(&minimal, &State::new(0.0, [0.6], [2.0])),
    );
    checked::<_, 3, 2, 2>(&rod, &state, [&[]; 2]);
}

/// v̇ = a ω², (I + m a²) ω̇ = −m a v ω: straight on with the knife behind, a turn decays at m a v/(I + m a²).
#[test]
fn a_sleigh_straight_on() {
    let sleigh = Sleigh {
        m: 1.5,
        inertia: 0.4,
        a: 0.3,
    };
    let state = State::new(0.0, [0.0; 3], [2.0, 0.0, 0.0]);
    let left_out = [Sleigh::X, Sleigh::Y, Sleigh::THETA];
    let tangent = TangentSpace::at(&sleigh, &state).without(left_out);
    let steady = StateSpace::<f64, 2, 0, 2>::reduced_free(&tangent).expect("steady");
    let poles = steady.poles().expect("finite");
    let rate = 1.5 * 0.3 * 2.0 / (0.4 + 1.5 * 0.09);
    assert!(
        poles[0].norm() < 1e-14 && (poles[1].re + rate).abs() < 1e-13,
        "{poles:?}"
    );
    checked::<_, 3, 1, 5>(&sleigh, &state, [&[]; 2]);
    checked::<_, 3, 1, 2>(&sleigh, &state, [&left_out, &[]]);
    // Turned, and in a turn.
    let (sine, cosine) = 0.7_f64.sin_cos();
    checked::<_, 3, 1, 5>(
        &sleigh,
        &State::new(0.0, [1.0, 2.0, 0.7], [2.0 * cosine, 2.0 * sine, 0.5]),
        [&[]; 2],
    );
}

/// A disc with A = ¼ m r² and C = ½ m r² that rolls straight on at ω: λ² = (g/r − 3 ω²)/1.25 for leaning (E. J. Routh, *Advanced Rigid
/// Dynamics*, 6th edition (1905), 244); three more modes are those of its speed, of its direction and of a turn at rest.
#[test]
fn a_disc_rolls_upright() {
    let disc = Disc {
        m: 0.4,
        r: 0.4,
        g: 9.81,
    };
    let left_out = [Disc::X, Disc::Y, Disc::PHI, Disc::PSI];
    let turning = [Disc::PHI, Disc::THETA, Disc::PSI];
    for omega in [2.0, 8.0, 20.0] {
        let state = disc.upright(omega);
        let tangent = TangentSpace::at(&disc, &state)
            .without(left_out)
            .velocities(turning);
        let steady = StateSpace::<f64, 4, 0, 4>::reduced_free(&tangent).expect("steady");
        let square = (9.81 / 0.4 - 3.0 * omega * omega) / 1.25;
        let expected = nalgebra::Complex::new(square, 0.0).sqrt();
        let poles = steady.poles().expect("finite");
        assert!(poles[..2].iter().all(|x| x.norm() < 1e-6), "{poles:?}");
        let distance = poles[2..]
            .iter()
            .map(|x| (x - expected).norm())
            .fold(f64::INFINITY, f64::min);
        assert!(distance < 1e-11 * expected.norm(), "{poles:?} {expected}");
        checked::<_, 6, 3, 4>(&disc, &state, [&left_out, &turning]);
    }
    checked::<_, 6, 3, 8>(&disc, &disc.upright(8.0), [&[]; 2]);
}
