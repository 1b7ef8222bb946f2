//! Modes and stability of mechanisms, against minimal coordinates.

use lagrangian::analysis::{
    EquilibriumSearch, LinearStability, SecondVariation, SmallOscillations, TangentError,
    TangentSpace, Verdict,
};
use lagrangian::prelude::*;

use super::linkages::*;
use super::mechanisms::*;

/// A bead on a wire of the shape y = a x² + b x⁴.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = 9.81 * y,
    constraint(wire = y - a * x.powi(2) - b * x.powi(4)),
)]
struct Valley {
    a: f64,
    b: f64,
}

#[test]
fn cranks_oscillate_alike() {
    let (three, seven, alone) = (Crank::EXAMPLE, CrankOfBodies::EXAMPLE, CrankAlone::EXAMPLE);
    for (angle, verdict) in [(-2.0, Verdict::Stable), (0.4, Verdict::Unstable)] {
        let minimal = EquilibriumSearch::of(&alone).near(&State::new(0.0, [angle], [0.0]));
        let minimal = minimal.expect("an equilibrium").state;
        let expected = SmallOscillations::about(&alone, &minimal).expect("an equilibrium");
        let square = expected
            .normal_modes()
            .expect("a mode")
            .squared_frequency(0);
        assert_eq!(expected.stability().expect("finite").verdict(), verdict);
        let check = |found: f64, stability: Verdict| {
            assert!((found / square - 1.0).abs() < 1e-10, "{found} {square}");
            assert_eq!(stability, verdict);
        };
        let state = three.turned(minimal.q[0], 0.0);
        let found = SmallOscillations::constrained(&TangentSpace::at(&three, &state));
        let found = found.expect("an equilibrium");
        let modes = found.normal_modes().expect("a mode");
        check(
            modes.squared_frequency(0),
            found.stability().expect("finite").verdict(),
        );
        let state = seven.turned(minimal.q[0], 0.0);
        let found = SmallOscillations::constrained(&TangentSpace::at(&seven, &state));
        let found = found.expect("an equilibrium");
        let modes = found.normal_modes().expect("a mode");
        check(
            modes.squared_frequency(0),
            found.stability().expect("finite").verdict(),
        );
    }
}

#[test]
fn bobs_oscillate_like_pendulums() {
    let (bobs, angles) = (Bobs { g: 9.81 }, Angles { g: 9.81 });
    let hanging = Bobs::at([0.0; 3], [0.0; 3]);
    let found =
        SmallOscillations::constrained(&TangentSpace::at(&bobs, &hanging)).expect("it hangs");
    let expected = SmallOscillations::about(&angles, &State::new(0.0, [0.0; 3], [0.0; 3]));
    let (found_modes, expected) = (
        found.normal_modes().expect("modes"),
        expected.expect("it hangs"),
    );
    let expected = expected.normal_modes().expect("modes");
    for i in 0..3 {
        let ratio = found_modes.squared_frequency(i) / expected.squared_frequency(i);
        assert!((ratio - 1.0).abs() < 1e-11, "{ratio}");
    }
    assert_eq!(
        found.stability().expect("finite").verdict(),
        Verdict::Stable
    );
    // With its redundant bar, a platform is a pendulum.
    let platform = Platform {
        m: 2.0,
        g: 9.81,
        l: 0.9,
    };
    let hanging = platform.at(0.0, 0.0);
    let found = SmallOscillations::constrained(&TangentSpace::at(&platform, &hanging));
    let square = found
        .expect("it hangs")
        .normal_modes()
        .expect("a mode")
        .squared_frequency(0);
    assert!((square - 9.81 / 0.9).abs() < 1e-12);
}

#[test]
fn what_friction_does() {
    let (rope, alone) = (Rope::EXAMPLE, RopeAlone::EXAMPLE);
    let state = State::new(0.0, [0.0; 3], [0.0; 3]);
    let found = SmallOscillations::constrained(&TangentSpace::at(&rope, &state)).expect("it hangs");
    let expected = SmallOscillations::about(&alone, &State::new(0.0, [0.0], [0.0]));
    let expected = expected.expect("it hangs").stability().expect("finite");
    let found = found.stability().expect("finite");
    let LinearStability::Decaying { rate } = expected.linear else {
        panic!("{expected:?}");
    };
    let decays = |x: LinearStability| matches!(x, LinearStability::Decaying { rate: found } if (found - rate).abs() < 1e-11);
    assert!(decays(found.linear) && found.verdict() == Verdict::AsymptoticallyStable);
}

/// Only higher orders decide at the bottom of x⁴, and a motor makes the equations depend on time.
#[test]
fn what_stays_undecided() {
    let still = State::new(0.0, [0.0; 2], [0.0; 2]);
    for (a, b, verdict) in [
        (1.0, 0.0, Verdict::Stable),
        (-1.0, 0.0, Verdict::Unstable),
        (0.0, 1.0, Verdict::Undecided),
        (0.0, -1.0, Verdict::Undecided),
    ] {
        let valley = Valley { a, b };
        let found = SmallOscillations::constrained(&TangentSpace::at(&valley, &still));
        let stability = found.expect("an equilibrium").stability().expect("finite");
        assert_eq!(stability.verdict(), verdict, "{stability:?}");
    }
    let hoop = Hoop::EXAMPLE;
    let theta = (9.81_f64 / (0.5 * 36.0)).acos();
    let tangent = [0.0, theta];
    let turning = State::new(0.0, tangent, [6.0, 0.0]);
    let found = SmallOscillations::constrained(&TangentSpace::at(&hoop, &turning));
    let stability = found.expect("steady").stability().expect("finite");
    assert_eq!(
        stability.second_variation,
        SecondVariation::PositiveDefinite
    );
    assert!(stability.contains_time && stability.verdict() == Verdict::Undecided);
}

/// A disc that rolls fast enough, v² > g r/3, stays upright, and a slow one falls.
#[test]
fn a_rolling_disc() {
    let disc = Disc {
        m: 0.4,
        r: 0.4,
        g: 9.81,
    };
    for (omega, grows) in [(2.0, true), (4.0, false)] {
        let state = disc.upright(omega);
        let tangent = TangentSpace::at(&disc, &state)
            .without([Disc::X, Disc::Y, Disc::PHI, Disc::PSI])
            .velocities([Disc::PHI, Disc::THETA, Disc::PSI]);
        let found = SmallOscillations::constrained(&tangent).expect("steady");
        let stability = found.stability().expect("finite");
        let growing = matches!(stability.linear, LinearStability::Growing { .. });
        assert_eq!(growing, grows, "{stability:?}");
        assert_eq!(stability.second_variation, SecondVariation::NoPotential);
    }
    let state = disc.upright(4.0);
    let error = SmallOscillations::constrained(&TangentSpace::at(&disc, &state).along_motion());
    assert!(
        matches!(error, Err(TangentError::NoVelocity { .. })),
        "{error:?}"
    );
}
