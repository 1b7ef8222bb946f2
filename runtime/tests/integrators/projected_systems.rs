//! Projections of other systems than pendulums: unit quaternions, components beside a manifold, states that are updated.

use crate::common::assert_close;
use crate::constrained::{RELEASE, ROD, UnitQuaternion};
use lagrangian::Integrator;
use lagrangian::prelude::*;
use lagrangian::problem::Projection;
use lagrangian::rigid_body::{EulerEquations, FreeRotation, InertiaTensor, RotationState};
use nalgebra::{SVector, Vector3};

/// The residual that a few roundings leave, in position and velocity.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Fails unless the quaternion of a free body keeps its length, and its motion is that of the closed form.
fn check_quaternion<I: Integrator<f64, UnitQuaternion> + Copy>(
    method: I,
    tolerance: f64,
    drifts: bool,
) {
    let inertia = InertiaTensor::principal([1.0, 2.0, 2.8]);
    let start = RotationState::aligned(Vector3::new(0.3, 2.0, 1.0));
    let motion = FreeRotation::new(&inertia, &start).unwrap();
    let norm = |projects| {
        let body = UnitQuaternion {
            body: EulerEquations::new(inertia).unwrap(),
            projects,
        };
        let mut largest: f64 = 0.0;
        let found = Problem::new(body, At::from((0.0, start)))
            .when(|x| x.angular_velocity.x)
            .record()
            .save(Every(0.7))
            .each_step(|progress| {
                let norm: f64 = progress.x.quaternion.norm();
                largest = largest.max((norm - 1.0).abs());
            })
            .solve(30.0, method)
            .unwrap();
        let expected = motion.at(30.0);
        let difference = (found.last.x.quaternion - expected.quaternion).amax();
        let difference = difference.min((found.last.x.quaternion + expected.quaternion).amax());
        assert!(difference < tolerance, "{difference:e}");
        assert!(found.events().len() > 3);
        largest
    };
    let [kept, drift] = [true, false].map(norm);
    assert!(kept <= 2.0 * f64::EPSILON, "{kept:e}");
    assert!(!drifts || drift > 1000.0 * f64::EPSILON, "{drift:e}");
}

#[test]
fn quaternions_stay_unit_quaternions() {
    check_quaternion(Taylor::order_12().relative_tolerance(1e-9), 1e-6, true);
    check_quaternion(Dop853::new(), 1e-7, true);
    check_quaternion(RungeKutta::classical(0.01), 1e-6, true);
    // By compensated sums of its own accuracy it hardly drifts.
    check_quaternion(Taylor::new(), 1e-12, false);
}

/// A point on the unit circle, beside a component that counts time in tenths.
struct Hand;

impl Dynamics for Hand {
    type State = SVector<f64, 3>;

    fn derivative(&self, _: f64, x: &Self::State) -> Self::State {
        SVector::from([-x[1], x[0], 1.0])
    }

    fn project(&self, _: f64, x: &Self::State) -> Option<Projection<f64, Self::State>> {
        let length = x[0].hypot(x[1]);
        Some(Projection::new(SVector::from([
            x[0] / length,
            x[1] / length,
            x[2],
        ])))
    }
}

/// The compensated sum goes on where a step is projected: steps of 0.1 and of a number near it add up to 2000 without the rounding
/// errors of 20,000 sums.
#[test]
fn projections_keep_what_rounding_removes() {
    let start = At::from((0.0, SVector::from([1.0, 0.0, 0.0])));
    let end = Problem::new(&Hand, start)
        .solve(2000.0, RungeKutta::classical(0.1))
        .unwrap();
    assert!(
        (end[2] - 2000.0).abs() <= 4.0 * f64::EPSILON * 2000.0,
        "{:e}",
        end[2] - 2000.0
    );
    let method = Dop853::new().max_step(0.1);
    let end = Problem::new(&Hand, start).solve(2000.0, method).unwrap();
    assert!(
        (end[2] - 2000.0).abs() <= 4.0 * f64::EPSILON * 2000.0,
        "{:e}",
        end[2] - 2000.0
    );
    assert!(end.statistics.projection > 0.0);
}

#[test]
fn how_far_steps_were_projected_is_kept_where_a_method_begins_anew() {
    let mut run = Problem::new(ROD, ROD.released(RELEASE))
        .start(Dop853::new())
        .unwrap();
    run.advance(3.0).unwrap();
    let moved = run.statistics().projection;
    run.change(|_, _| ()).unwrap();
    assert!(moved > 0.0);
    assert_eq!(run.statistics().projection.to_bits(), moved.to_bits());
}

/// The pendulum under a damper that is set ten times a second: behind (x, y, ẋ, ẏ) are the force along the circle over the distance,
/// and the time of the next update.
struct SampledDamper;

impl Dynamics for SampledDamper {
    type State = SVector<f64, 6>;

    fn derivative(&self, t: f64, x: &Self::State) -> Self::State {
        let slope = ROD.derivative(t, &x.fixed_rows::<4>(0).into_owned());
        let force = [-x[4] * x[1], x[4] * x[0]];
        SVector::from([
            slope[0],
            slope[1],
            slope[2] + force[0],
            slope[3] + force[1],
            0.0,
            0.0,
        ])
    }

    fn project(&self, t: f64, x: &Self::State) -> Option<Projection<f64, Self::State>> {
        let y = ROD
            .project(t, &x.fixed_rows::<4>(0).into_owned())?
            .into_state();
        Some(Projection::new(SVector::from([
            y[0], y[1], y[2], y[3], x[4], x[5],
        ])))
    }

    fn next_update(&self, x: &Self::State) -> Option<f64> {
        Some(x[5])
    }

    fn update(&self, _: f64, x: &mut Self::State) {
        x[4] = -0.5 * (x[0] * x[3] - x[1] * x[2]) / (ROD.length * ROD.length);
        x[5] += 0.1;
    }
}

#[test]
fn states_that_are_updated_are_projected() {
    let x = ROD.released(RELEASE).x;
    let start = At::from((0.0, SVector::from([x[0], x[1], x[2], x[3], 0.0, 0.0])));
    let mut steps = 0;
    let problem = Problem::new(&SampledDamper, start);
    let observed = problem.clone().each_step(|progress| {
        let residuals = ROD.residuals(&progress.x.fixed_rows::<4>(0).into_owned());
        assert!(
            residuals.into_iter().all(|r| r <= ROUNDING),
            "{residuals:?}"
        );
        steps += 1;
    });
    let end = observed.solve(20.0, Dop853::new()).unwrap();
    assert!(steps >= 200 && end.statistics.projection > 0.0);
    assert_close(end.x[5], 20.0, 0.11);
    // It comes to rest at the lowest point.
    assert!(end.x[0].abs() < 0.05);
    let fixed = problem
        .clone()
        .solve(20.0, RungeKutta::classical(0.005))
        .unwrap();
    assert!((end.last.x - fixed.last.x).amax() < 1e-6);
    let mut part = problem.clone().max_steps(57).start(Dop853::new()).unwrap();
    part.advance(20.0).unwrap();
    let mut resumed = problem.resume(part.checkpoint(), Dop853::new()).unwrap();
    assert_eq!(resumed.advance(20.0).unwrap().last, end.last);
}
