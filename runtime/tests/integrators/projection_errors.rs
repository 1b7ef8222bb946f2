//! States that are off the manifold on which equations hold, and projections that fail.

use crate::common::{assert_close, in_lanes};
use crate::constrained::{RELEASE, ROD, Rod};
use lagrangian::prelude::*;
use lagrangian::problem::Projection;
use lagrangian::{ComponentName, Integrator, Lanes};
use nalgebra::SVector;

/// A start that is off by so much in y.
fn off(by: f64) -> At<f64, SVector<f64, 4>> {
    let mut start = ROD.released(RELEASE);
    start.x[1] += by;
    start
}

fn error_of<I: Integrator<f64, Rod>>(
    start: At<f64, SVector<f64, 4>>,
    method: I,
) -> IntegrationError {
    Problem::new(ROD, start)
        .solve(1.0, method)
        .unwrap_err()
        .error()
}

fn is_off(error: IntegrationError) -> bool {
    matches!(error, IntegrationError::OffManifold { .. })
}

#[test]
fn a_start_off_the_manifold_is_an_error() {
    for error in [
        error_of(off(1e-4), Dop853::new()),
        error_of(off(1e-4), Taylor::new()),
        error_of(off(1e-4), RungeKutta::classical(0.01)),
    ] {
        let IntegrationError::OffManifold {
            time,
            component,
            correction,
            limit,
        } = error
        else {
            panic!("{error}");
        };
        assert_eq!((time, component), (0.0, ComponentName::Index(0)));
        assert_close(correction, 1e-4 * RELEASE.sin() * RELEASE.cos(), 1e-8);
        assert!(limit < correction);
        let message = error.to_string();
        assert!(message.contains("component 0 of the state") && message.contains("constraints"));
    }
    assert!(is_off(error_of(off(1e-12), Taylor::new())));
    assert!(is_off(error_of(off(1e-7), Dop853::new())));
}

/// It is not changed before the first step.
#[test]
fn a_start_within_the_tolerance_is_taken_as_it_is() {
    let mut first = None;
    let start = off(1e-11);
    let end = Problem::new(ROD, start)
        .save([0.0])
        .each_step(|progress| {
            first.get_or_insert(*progress.x);
        })
        .solve(1.0, Dop853::new())
        .unwrap();
    assert_eq!(first, Some(start.x));
    assert!(ROD.residuals(&end.x)[0] <= 4.0 * f64::EPSILON);
    let fixed = Problem::new(ROD, off(1e-7)).solve(1.0, RungeKutta::classical(0.01));
    assert!(fixed.is_ok());
}

/// Rounding is no reason, whatever the unit of length and however the numbers were made.
#[test]
fn a_start_that_is_rounded_is_on_the_manifold() {
    for length in [1e-9, 0.3, 1e9] {
        for i in 0..40 {
            let rod = Rod {
                length,
                gravity: 9.81 * length,
                ..ROD
            };
            let start = rod.released(0.1 + 0.07 * f64::from(i));
            let problem = Problem::new(rod, start);
            let end = problem
                .clone()
                .solve(1.0, Taylor::new().relative_tolerance(f64::EPSILON))
                .unwrap();
            assert!(rod.residuals(&end.x)[0] <= 4.0 * f64::EPSILON);
            problem.solve(1.0, Taylor::new()).unwrap();
        }
    }
}

#[test]
fn a_projection_that_fails_names_its_constraint() {
    let mut at_origin = ROD.released(RELEASE);
    at_origin.x *= 0.0;
    for start in [off(1.0), at_origin] {
        for error in [
            error_of(start, Taylor::new()),
            error_of(start, RungeKutta::classical(0.01)),
        ] {
            let message = error.to_string();
            let is_known = matches!(
                error,
                IntegrationError::ProjectionFailed {
                    constraint: "the length of the rod",
                    ..
                } | IntegrationError::NonFiniteDerivative { .. }
            );
            assert!(is_known, "{message}");
        }
    }
}

#[test]
fn reactions_and_changes_leave_states_on_the_manifold() {
    let problem = || Problem::new(ROD, ROD.released(RELEASE));
    // Turning back is tangent to the circle, half of one component of the velocity is not.
    let turned = problem().when(|x| x[0]).then(|x| {
        x[2] *= -0.5;
        x[3] *= -0.5;
    });
    let turned = turned.solve(4.0, Dop853::new()).unwrap();
    assert!(
        ROD.residuals(&turned.x)
            .into_iter()
            .all(|r| r <= 4.0 * f64::EPSILON)
    );
    let broken = problem().when(|x| x[0] - 1.0).then(|x| x[2] *= -0.5);
    let partial = broken.solve(4.0, Dop853::new()).unwrap_err();
    assert!(is_off(partial.error()), "{partial}");
    assert_close(partial.solution().last.x[0], 1.0, 1e-12);
    let mut run = problem().start(Dop853::new()).unwrap();
    run.advance(0.5).unwrap();
    let before = run.state();
    assert!(is_off(run.change(|x, _| x[3] += 0.1).unwrap_err()));
    assert_eq!(run.state(), before);
    let end = run.advance(1.0).unwrap();
    let expected = ROD.closed_form(RELEASE, 1.0);
    assert_close(end.x[0], expected[0], 1e-8);
}

/// The dynamics stay changed where the state is not: the next step is one of the new dynamics.
#[test]
fn dynamics_stay_changed_where_the_changed_state_is_off_the_manifold() {
    let mut run = Problem::new(ROD, ROD.released(RELEASE))
        .start(Dop853::new())
        .unwrap();
    run.advance(0.5).unwrap();
    let here = run.state();
    let refused = run.change(|x, rod| {
        rod.gravity *= 2.0;
        x[3] += 0.1;
    });
    assert!(is_off(refused.unwrap_err()));
    let end = run.advance(2.0).unwrap();
    let heavy = Rod {
        gravity: 2.0 * ROD.gravity,
        ..ROD
    };
    let expected = Problem::new(heavy, here).solve(2.0, Dop853::new()).unwrap();
    assert!((end.last.x - expected.last.x).amax() < 1e-9);
}

/// Equations that leave the circle are an error at the end of the first step.
#[test]
fn a_derivative_that_does_not_keep_the_constraint_is_an_error() {
    struct Leaving;

    impl Dynamics for Leaving {
        type State = SVector<f64, 4>;

        fn derivative(&self, t: f64, x: &Self::State) -> Self::State {
            let mut slope = ROD.derivative(t, x);
            slope[2] += 1e-3;
            slope
        }

        fn project(&self, t: f64, x: &Self::State) -> Option<Projection<f64, Self::State>> {
            ROD.project(t, x)
        }
    }

    let start = ROD.released(RELEASE);
    let partial = Problem::new(Leaving, start)
        .solve(1.0, Dop853::new())
        .unwrap_err();
    assert!(is_off(partial.error()));
    assert_eq!(partial.solution().last, start);
    // Fixed steps have no tolerance to compare with: how far they are moved is known.
    let end = Problem::new(Leaving, start)
        .solve(1.0, RungeKutta::classical(0.01))
        .unwrap();
    assert!(end.statistics.projection > 1e-8);
}

/// A lane that begins off the manifold ends, and the others do not notice.
#[test]
fn a_lane_off_the_manifold_ends_alone() {
    let motions = [off(0.0), off(1e-6), off(1.0), off(0.0)].map(|start| (start, 2.0));
    let found = in_lanes::<3, _, _>(Taylor::new(), &ROD, motions);
    assert_eq!(found[0], found[3]);
    let alone = in_lanes::<1, _, _>(Taylor::new(), &ROD, [motions[0]]);
    assert_eq!(found[0], alone[0]);
    assert!(found[0].is_ok());
    // It takes no step.
    assert!(matches!(
        found[1],
        Err(IntegrationError::OffManifold { time: 0.0, .. })
    ));
    assert!(matches!(
        found[2],
        Err(IntegrationError::ProjectionFailed {
            constraint: "the length of the rod",
            ..
        })
    ));
}

/// A projection that fails in a short time within a step.
struct Failing;

impl Dynamics for Failing {
    type State = SVector<f64, 4>;

    fn derivative(&self, t: f64, x: &Self::State) -> Self::State {
        ROD.derivative(t, x)
    }

    fn project(&self, t: f64, x: &Self::State) -> Option<Projection<f64, Self::State>> {
        let residual = if (t - 0.505).abs() < 1e-4 {
            f64::NAN
        } else {
            0.0
        };
        Some(ROD.project(t, x)?.checked(7, residual, 1.0))
    }

    fn constraint_name(&self, index: usize) -> &'static str {
        if index == 7 { "the seventh" } else { "another" }
    }
}

#[test]
fn samples_and_events_at_which_the_projection_fails_are_errors() {
    let problem = || Problem::new(Failing, ROD.released(RELEASE));
    let fails = |error: IntegrationError| {
        let IntegrationError::ProjectionFailed {
            time,
            constraint,
            residual,
        } = error
        else {
            panic!("{error}");
        };
        assert_eq!((time, constraint), (0.505, "the seventh"));
        assert!(residual.is_nan());
    };
    let partial = problem()
        .save([0.5, 0.505, 0.6])
        .solve(1.0, Dop853::new())
        .unwrap_err();
    fails(partial.error());
    assert_eq!(partial.solution().samples().len(), 1);
    assert_close(partial.solution().last.t, 0.5, 0.0);
    let partial = problem()
        .when(|x| x.t - 0.505)
        .stop()
        .solve(1.0, Dop853::new())
        .unwrap_err();
    fails(partial.error());
    let mut run = problem().start(Dop853::new()).unwrap();
    while run.state().t < 0.505 {
        run.step(1.0).unwrap();
    }
    fails(run.at(0.505).unwrap_err());
    // Fixed steps end there.
    let partial = problem()
        .solve(1.0, RungeKutta::classical(0.005))
        .unwrap_err();
    assert_close(partial.solution().last.t, 0.5, 1e-12);
}

/// Each lane has the first constraint that is violated in it.
#[test]
fn constraints_are_checked_lane_by_lane() {
    let x = SVector::<Lanes<4>, 1>::from([Lanes([0.0; 4])]);
    let one = Lanes([1.0; 4]);
    let fine = Projection::new(x).checked(0, Lanes([1.0, -1.0, 0.0, -0.5]), one);
    assert!(!fine.has_failed());
    for bad in [1.1, -1.1, f64::INFINITY, f64::NAN] {
        for lane in 0..4 {
            let mut residual = Lanes([0.0; 4]);
            residual.set(lane, bad);
            assert!(fine.checked(1, residual, one).has_failed(), "{bad} {lane}");
        }
    }
}
