//! Constraints of which some follow from others where all hold.

use lagrangian::Lanes;
use lagrangian::prelude::*;
use nalgebra::{SMatrix, SVector};

use crate::mechanisms::Platform;

/// The pendulum as which the platform moves.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * m * (l * dot(theta)).powi(2),
    potential = -m * g * l * cos(theta),
    taylor,
)]
struct Pendulum {
    m: f64,
    l: f64,
    g: f64,
}

fn start() -> State<f64, 3> {
    let (theta, rate) = (0.8_f64, 1.1);
    let l = Platform::PARALLEL.l;
    let (sin, cos) = theta.sin_cos();
    State::new(
        0.0,
        [l * sin, -l * cos, 0.0],
        [l * rate * cos, l * rate * sin, 0.0],
    )
}

fn expected(t: f64) -> [f64; 2] {
    let Platform { m, l, g, .. } = Platform::PARALLEL;
    let pendulum = Pendulum { m, l, g };
    let start = State::new(0.0, [0.8], [1.1]);
    let end = Problem::new(&pendulum, start).solve(t, Taylor::new().relative_tolerance(1e-15));
    let end = end.expect("a pendulum swings");
    [l * end.q[0].sin(), -l * end.q[0].cos()]
}

#[test]
fn a_platform_on_three_parallel_bars_moves_as_a_pendulum() -> Result<(), IntegrationError> {
    let start = start();
    let expected = expected(10.0);
    let taylor = Problem::new(&Platform::PARALLEL, start)
        .solve(10.0, Taylor::new().relative_tolerance(1e-13))?;
    let dop853 = Problem::new(&Platform::PARALLEL, start)
        .solve(10.0, Dop853::new().relative_tolerance(1e-12))?;
    for end in [taylor.last, dop853.last] {
        println!("{end:?} {expected:?}");
        assert!((end.q[0] - expected[0]).abs() < 1e-9);
        assert!((end.q[1] - expected[1]).abs() < 1e-9);
        assert!(end.q[2].abs() < 1e-12);
    }
    Ok(())
}

/// The loads of the bars where they are stiff springs: λ = −K G δ with the displacement δ at which they hold the reactions,
/// Gᵀ λ = M q̈ − f.
fn loads_of_springs(platform: &Platform, state: &State<f64, 3>) -> SVector<f64, 3> {
    let reactions = platform.inverse_dynamics(state, &platform.accelerations(state));
    let g: SMatrix<f64, 3, 3> = platform.constraint_jacobian(state);
    let springs = SMatrix::from_diagonal(&SVector::from(platform.stiffness));
    let whole = g.transpose() * springs * g;
    // Along the motion that the bars allow they have no stiffness.
    let negligible = 1e-12 * whole.norm();
    let flexibility = whole.pseudo_inverse(negligible).expect("a tolerance");
    springs * g * flexibility * reactions
}

#[test]
fn bars_share_a_load_as_stiff_springs_do() {
    let state = start();
    for stiffness in [[1.0; 3], [5.0, 1.0, 2.0], [1e6, 2e3, 1e6]] {
        let platform = Platform {
            stiffness,
            ..Platform::PARALLEL
        };
        let expected = loads_of_springs(&platform, &state);
        let found = platform.multipliers(&state);
        let error = (found - expected).amax() / expected.amax();
        println!("{found:?} {expected:?} {error:.1e}");
        assert!(error < 1e-13);
        assert_eq!(
            platform.outputs(&state).left_load.to_bits(),
            found[0].to_bits()
        );
        // Neither the accelerations nor the sum of the loads know of it.
        assert_eq!(
            platform.accelerations(&state),
            Platform::PARALLEL.accelerations(&state)
        );
        assert!(
            (found.sum() - Platform::PARALLEL.multipliers(&state).sum()).abs()
                < 1e-13 * expected.amax()
        );
    }
    // Equal bars carry equal loads, and of two outer bars without stiffness the middle one carries all.
    let [left, middle, right] = Platform::PARALLEL.multipliers(&state).into();
    assert!((left / middle - 1.0).abs() < 1e-14 && (right / middle - 1.0).abs() < 1e-14);
    let soft = Platform {
        stiffness: [1e-9, 1.0, 1e-9],
        ..Platform::PARALLEL
    };
    let [left, middle, _] = soft.multipliers(&state).into();
    assert!((left / middle).abs() < 1e-8);
}

#[test]
fn compliances_are_the_same_in_lanes_and_along_a_motion() -> Result<(), IntegrationError> {
    let platform = Platform {
        stiffness: [5.0, 1.0, 2.0],
        ..Platform::PARALLEL
    };
    let state = start();
    let lanes = State::new(
        Lanes::<2>::from_f64(0.0),
        state.q.map(Lanes::from_f64),
        state.v.map(Lanes::from_f64),
    );
    let found = platform.multipliers(&lanes);
    let alone = platform.multipliers(&state);
    for i in 0..3 {
        assert_eq!(found[i].in_lane(1).to_bits(), alone[i].to_bits());
    }
    // The motion is that of equal bars.
    let end = Problem::new(&platform, state).solve(2.0, Taylor::new())?;
    let equal = Problem::new(&Platform::PARALLEL, state).solve(2.0, Taylor::new())?;
    assert!((end.q - equal.q).amax() < 1e-13 && (end.v - equal.v).amax() < 1e-12);
    Ok(())
}

#[test]
fn compliances_are_positive() {
    for (stiffness, compliance) in [(-2.0, -0.5), (f64::INFINITY, 0.0), (0.0, f64::INFINITY)] {
        let platform = Platform {
            stiffness: [1.0, 1.0, stiffness],
            ..Platform::PARALLEL
        };
        let error = Problem::new(&platform, start()).solve(1.0, Dop853::new());
        let error = error.expect_err("the compliance is refused");
        let expected = IntegrationError::InvalidCompliance {
            constraint: "right_bar",
            compliance,
        };
        assert_eq!(error.error(), expected);
        assert!(error.to_string().contains("right_bar"));
        let loads = platform.multipliers(&start());
        assert!(loads.iter().any(|load| !load.is_finite()), "{loads}");
    }
}

/// Its angle is zero, and so are the accelerations of the angle but for rounding errors, which do not shorten steps.
#[test]
fn what_a_redundant_constraint_keeps_at_zero_does_not_shorten_steps() {
    for index in [0, 1, 3, 4] {
        let (platform, start) = Platform::numbered(index);
        for tolerance in [1e-6, 1e-10, 1e-14] {
            let problem = Problem::new(&platform, start);
            let motion = problem.solve(2.0, Taylor::new().relative_tolerance(tolerance));
            let statistics = motion.expect("a motion").statistics;
            assert!(statistics.rejected <= statistics.steps, "{statistics:?}");
        }
    }
}

/// Three bars that are not parallel hold it, whatever its weight.
#[test]
fn a_structure_that_is_held_stays_at_rest() -> Result<(), IntegrationError> {
    let (platform, start) = Platform::numbered(2);
    let end = Problem::new(&platform, start).solve(10.0, Taylor::new())?;
    assert!((end.q - start.q).amax() < 1e-15 && end.v.amax() < 1e-15);
    let method = || Dop853::new().absolute_tolerance(1e-12);
    let end = Problem::new(&platform, start).solve(10.0, method())?;
    assert!((end.q - start.q).amax() < 1e-15 && end.v.amax() < 1e-15);
    Ok(())
}
