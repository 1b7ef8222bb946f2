//! Steady motions of constrained mechanisms, against closed forms.

use lagrangian::analysis::{
    EquilibriumError, EquilibriumSearch, StateSpace, TangentError, TangentSpace, Variable,
};
use lagrangian::prelude::*;

use super::checked;
use super::mechanisms::*;

const DISC: Disc = Disc {
    m: 0.4,
    r: 0.4,
    g: 9.81,
};

/// A bob on a rod in a plane that turns about the vertical.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, x, z),
    define(p = rotation_z(phi) * [x, 0.0, z]),
    kinetic = 0.5 * m * dot(p).norm_squared(),
    potential = m * g * z,
    constraint(rod = [x, z].norm() - l),
)]
struct Conical {
    m: f64,
    g: f64,
    l: f64,
}

/// Watt's governor: two balls on arms, which are linked to a sleeve on the turning spindle.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, r, h, s),
    kinetic = m * (dot(r).powi(2) + dot(h).powi(2) + (r * dot(phi)).powi(2)),
    kinetic = 0.5 * sleeve * dot(s).powi(2) + 0.5 * j * dot(phi).powi(2),
    potential = -2.0 * m * g * h - sleeve * g * s,
    force(phi = torque - c * dot(phi)),
    constraint(
        arms = r.powi(2) + h.powi(2) - l.powi(2),
        links = r.powi(2) + (s - h).powi(2) - l.powi(2),
    ),
)]
struct Governor {
    m: f64,
    sleeve: f64,
    j: f64,
    g: f64,
    l: f64,
    c: f64,
    #[lagrangian(input)]
    torque: f64,
}

const GOVERNOR: Governor = Governor {
    m: 1.2,
    sleeve: 3.0,
    j: 0.1,
    g: 9.81,
    l: 0.3,
    c: 0.0,
    torque: 0.0,
};

/// Two equal weights on a rope over a pulley.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, phi),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)) + 0.5 * j * dot(phi).powi(2),
    potential = m * g * (x + y),
    constraint(rope = x + y, pulley = x - r * phi),
)]
struct Lift {
    m: f64,
    j: f64,
    g: f64,
    r: f64,
}

impl Governor {
    /// At an inclination of its arms.
    fn inclined(&self, angle: f64, rate: f64) -> State<f64, 4> {
        let (r, h) = (self.l * angle.sin(), self.l * angle.cos());
        State::new(0.0, [0.0, r, h, 2.0 * h], [rate, 0.0, 0.0, 0.0])
    }
}

/// (C + m r²) ω₃ Ω sin θ − A Ω² sin θ cos θ + m g r cos θ = 0 (E. A. Milne, *Vectorial Mechanics* (1948), 248; O. M. O'Reilly, *The
/// dynamics of rolling disks and sliding disks*, Nonlinear Dyn. **10** (1996) 287–305): each of θ, Ω and ω₃ from the others, in all
/// directions.
#[test]
fn a_disc_finds_its_circle() {
    for (theta, rate) in [(1.0, 2.0), (0.6, -3.0), (1.4, 0.7), (2.0, 5.0)] {
        let mut expected = DISC.circle(theta, rate);
        for heading in [0.0_f64, 1.3, -2.5] {
            let (sine, cosine) = heading.sin_cos();
            let speed = DISC.circle(theta, rate).v[Disc::X];
            expected.q[Disc::PHI] = heading;
            (expected.v[Disc::X], expected.v[Disc::Y]) = (speed * cosine, speed * sine);
            let search = || EquilibriumSearch::constrained(&DISC);

            let mut guess = expected;
            guess.v[Disc::PSI] *= 0.8;
            let found = search()
                .unknown(&[Variable::Velocity(Disc::PSI)])
                .near(&guess);
            let found = found.expect("a circle").state;
            assert!(
                (found.v - expected.v).amax() < 1e-12,
                "{found:?} {expected:?}"
            );
            assert!((found.q - expected.q).amax() < 1e-15);

            // The height and the velocity of the centre follow from the angles.
            let mut guess = expected;
            guess.q[Disc::THETA] += 0.1;
            (guess.v[Disc::X], guess.v[Disc::Y]) = (0.0, 0.0);
            let found = search()
                .unknown(&[
                    Variable::Coordinate(Disc::THETA),
                    Variable::Coordinate(Disc::Z),
                ])
                .near(&guess);
            let found = found.expect("a circle").state;
            assert!(
                (found.q - expected.q).amax() < 1e-12,
                "{found:?} {expected:?}"
            );
            assert!(
                (found.v - expected.v).amax() < 1e-11,
                "{found:?} {expected:?}"
            );

            // The linear model is that of a steady motion, without a choice of velocities.
            let left_out = [Disc::X, Disc::Y, Disc::PHI, Disc::PSI];
            let tangent = TangentSpace::at(&DISC, &found).without(left_out);
            let plant = StateSpace::<f64, 4, 0, 4>::reduced_free(&tangent).expect("steady");
            assert!(plant.is_at_equilibrium(1e-10));
        }
    }
}

/// A disc that rolls in a circle: its motion is steady without its place and the direction in which it rolls.
#[test]
fn a_disc_rolls_in_a_circle() {
    let state = DISC.circle(60_f64.to_radians(), 2.0);
    let left_out = [Disc::X, Disc::Y, Disc::PHI, Disc::PSI];
    let turning = [Disc::PHI, Disc::THETA, Disc::PSI];
    let tangent = TangentSpace::at(&DISC, &state)
        .without(left_out)
        .velocities(turning);
    let steady = StateSpace::<f64, 4, 0, 4>::reduced_free(&tangent).expect("steady");
    assert!(steady.is_at_equilibrium(1e-11));
    // Two families of circles, and nodding.
    let poles = steady.poles().expect("finite");
    assert!(
        poles[1].norm() < 1e-5 && poles[2].re.abs() < 1e-5 && poles[2].im > 1.0,
        "{poles:?}"
    );
    checked::<_, 6, 3, 4>(&DISC, &state, [&left_out, &turning]);
    checked::<_, 6, 3, 8>(&DISC, &state, [&[]; 2]);
}

/// φ̇² l cos θ = g.
#[test]
fn a_conical_pendulum_by_its_bob() {
    let (bob, angle) = (
        Conical {
            m: 0.8,
            g: 9.81,
            l: 1.3,
        },
        0.5_f64,
    );
    let rate = (9.81 / (1.3 * angle.cos())).sqrt();
    let expected = Vector3::new(0.4, 1.3 * angle.sin(), -1.3 * angle.cos());
    // From the rate, near a bob that is not on the sphere.
    let guess = State::new(0.0, [0.4, 0.5, -1.0], [rate, 0.0, 0.0]);
    let found = EquilibriumSearch::constrained(&bob).near(&guess);
    let found = found.expect("a circle").state;
    assert!((found.q - expected).amax() < 1e-13, "{found:?}");
    assert!((found.v - Vector3::new(rate, 0.0, 0.0)).amax() < 1e-15);
    // The rod pulls with m g/cos θ.
    let pull = bob.multipliers(&found)[0];
    assert!((pull + 0.8 * 9.81 / angle.cos()).abs() < 1e-12);
    // The rate.
    let guess = State::new(0.0, expected, [2.0, 0.0, 0.0]);
    let found = EquilibriumSearch::constrained(&bob)
        .unknown(&[Variable::Velocity(Conical::PHI)])
        .near(&guess);
    assert!((found.expect("a circle").state.v[0] - rate).abs() < 1e-13);
}

/// In x, y and z nothing is constant, though the motion is the same.
#[test]
fn a_conical_pendulum_in_a_fixed_frame() {
    let bob = Spherical {
        m: 0.8,
        g: 9.81,
        l: 1.3,
    };
    let (sine, cosine) = 0.5_f64.sin_cos();
    let speed = 1.3 * sine * (9.81 / (1.3 * cosine)).sqrt();
    let circle = State::new(0.0, [1.3 * sine, 0.0, -1.3 * cosine], [0.0, speed, 0.0]);
    let error = EquilibriumSearch::constrained(&bob).near(&circle);
    let error = error.expect_err("it changes");
    assert!(
        matches!(
            error,
            EquilibriumError::NotSteady {
                reason: TangentError::Acts {
                    coordinate: "y",
                    ..
                },
                ..
            }
        ),
        "{error}"
    );
    assert!(
        error.to_string().starts_with("`y` moves, and acts on `"),
        "{error}"
    );
}

/// cos α = (1 + M/m) g/(l ω²).
#[test]
fn a_governor() {
    let (angle, g) = (0.7_f64, GOVERNOR.g);
    let ratio = 1.0 + GOVERNOR.sleeve / GOVERNOR.m;
    let rate = (ratio * g / (GOVERNOR.l * angle.cos())).sqrt();
    let expected = GOVERNOR.inclined(angle, rate);
    let mut guess = GOVERNOR.inclined(0.9, rate);
    guess.q[Governor::S] += 0.02;
    let found = EquilibriumSearch::constrained(&GOVERNOR).near(&guess);
    let found = found.expect("it turns").state;
    assert!((found.q - expected.q).amax() < 1e-13, "{found:?}");
    let found = EquilibriumSearch::constrained(&GOVERNOR)
        .unknown(&[Variable::Velocity(Governor::PHI)])
        .near(&GOVERNOR.inclined(angle, 8.0));
    assert!((found.expect("it turns").state.v[0] - rate).abs() < 1e-12);
    // With friction, a torque holds the rate.
    let rough = Governor {
        c: 0.05,
        ..GOVERNOR
    };
    let error = EquilibriumSearch::constrained(&rough).near(&guess);
    assert!(
        matches!(
            error,
            Err(EquilibriumError::Unbalanced { .. } | EquilibriumError::Stalled { .. })
        ),
        "{error:?}"
    );
    let found = EquilibriumSearch::constrained_trim(&rough)
        .unknown(&[
            Variable::Input(Governor::TORQUE),
            Variable::Coordinate(Governor::R),
            Variable::Coordinate(Governor::H),
            Variable::Coordinate(Governor::S),
        ])
        .near(&guess)
        .expect("it turns");
    assert!((found.inputs[0] - 0.05 * rate).abs() < 1e-13);
    assert!((found.state.q - expected.q).amax() < 1e-13, "{found:?}");
}

/// No coordinate of the lift is ignorable, but nothing depends on where it is.
#[test]
fn a_lift_with_a_counterweight() {
    let lift = Lift {
        m: 2.0,
        j: 0.1,
        g: 9.81,
        r: 0.2,
    };
    let freedom = lift.degrees_of_freedom(&State::new(0.0, [0.0; 3], [0.0; 3]));
    let chosen = freedom.independent_velocities().next().expect("one");
    let rates = [1.5, -1.5, 7.5];
    let mut guess = State::new(0.0, [0.1, -0.1, 0.5], [0.0; 3]);
    guess.v[chosen] = rates[chosen];
    let found = EquilibriumSearch::constrained(&lift).near(&guess);
    let found = found.expect("it runs").state;
    assert!((found.v - Vector3::from(rates)).amax() < 1e-14, "{found:?}");
    assert!((found.q - guess.q).amax() < 1e-14);
}

/// A motor turns the hoop at a rate that the guess does not know.
#[test]
fn what_a_drive_prescribes() {
    let hoop = Hoop::EXAMPLE;
    let theta = (9.81_f64 / (0.5 * 36.0)).acos();
    let found = EquilibriumSearch::constrained(&hoop).near(&State::new(0.0, [0.0, 0.8], [0.0; 2]));
    let found = found.expect("it turns").state;
    assert!(
        (found.q - Vector2::new(0.0, theta)).amax() < 1e-13,
        "{found:?}"
    );
    assert!(
        (found.v - Vector2::new(6.0, 0.0)).amax() < 1e-14,
        "{found:?}"
    );
}

/// A sleigh turns at constant rates, but the velocities that are its variables are those along fixed axes.
#[test]
fn a_sleigh_in_a_turn() {
    let sleigh = Sleigh {
        m: 1.5,
        inertia: 0.4,
        a: 0.0,
    };
    let turning = State::new(0.0, [0.0; 3], [2.0, 0.0, 0.5]);
    let error = EquilibriumSearch::constrained(&sleigh).near(&turning);
    let error = error.expect_err("the place where it is going turns");
    assert!(
        matches!(
            error,
            EquilibriumError::NotSteady {
                reason: TangentError::Acts {
                    coordinate: "theta",
                    ..
                },
                ..
            }
        ),
        "{error}"
    );
}

/// Points of the search meet the constraints, also where it is not finished.
#[test]
fn a_search_stays_on_the_constraints() {
    let mut guess = GOVERNOR.inclined(1.2, 14.0);
    guess.q[Governor::R] += 0.1;
    for steps in 0..3 {
        let error = EquilibriumSearch::constrained(&GOVERNOR)
            .max_iterations(steps)
            .near(&guess);
        let error = error.expect_err("it takes more steps");
        let last = error.last().expect("the last point").state;
        let (positions, velocities) = GOVERNOR.constraint_residuals(&last);
        assert!(
            positions.amax() < 1e-13 && velocities.amax() < 1e-13,
            "{steps}: {positions}"
        );
    }
}
