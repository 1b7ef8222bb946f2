//! Projections of states onto the manifold on which equations hold, against closed forms.

use crate::common::{assert_close, in_lanes};
use crate::constrained::{RELEASE, ROD, Rod};
use lagrangian::prelude::*;
use lagrangian::{
    DenseOutput, Dual, Integrator, Interpolant, LaneStates, Lanes, ObservationKind, Resume,
    TaylorLanes,
};
use nalgebra::SVector;

type X = SVector<f64, 4>;

/// The residual that a few roundings leave, in position and velocity.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The largest residual that is seen on the way, with a sample and an event in most steps.
fn largest_residual<I: Integrator<f64, Rod>>(rod: Rod, end: f64, method: I) -> [f64; 2] {
    let mut largest = [0.0; 2];
    let mut seen = [0; 3];
    Problem::new(rod, rod.released(RELEASE))
        .when(|x| x[0] - 0.3)
        .record()
        .save(Every(0.31))
        .each_step(|progress| {
            let residuals = rod.residuals(progress.x);
            largest = [0, 1].map(|i| f64::max(largest[i], residuals[i]));
            seen[match progress.kind {
                ObservationKind::Sample => 0,
                ObservationKind::Event(_) => 1,
                ObservationKind::Step => 2,
            }] += 1;
        })
        .solve(end, method)
        .unwrap();
    assert!(seen.iter().all(|count| *count > 10), "{seen:?}");
    largest
}

/// Fails unless a motion is that of the closed form, at its end, at samples and at events.
fn check_motion<I: Integrator<f64, Rod> + Copy>(method: I) {
    let end = 20.0;
    let near = |t: f64, x: &X| {
        let expected = ROD.closed_form(RELEASE, t);
        assert_close(x[0], expected[0], 1e-9);
        assert_close(x[1], expected[1], 1e-9);
        assert_close(ROD.energy(x), ROD.energy(&ROD.released(RELEASE)), 1e-9);
    };
    let motion = Problem::new(ROD, ROD.released(RELEASE))
        .when(|x| x[0])
        .record()
        .save([1.0, 7.7, 19.9])
        .solve(end, method)
        .unwrap();
    near(end, &motion.last.x);
    for sample in motion.samples() {
        near(sample.t, sample);
    }
    // It passes the lowest point in the middle of each half period.
    let half_period = ROD.half_period(RELEASE);
    let mut expected = 0.5 * half_period;
    for event in motion.events() {
        assert_close(event.t, expected, 1e-9);
        near(event.t, &event.x);
        expected += half_period;
    }
    assert!(expected > end);
    let residuals = largest_residual(ROD, end, method);
    assert!(
        residuals[0] <= ROUNDING && residuals[1] <= ROUNDING,
        "{residuals:?}"
    );
    let drift = largest_residual(ROD.drifting(), end, method);
    assert!(
        drift[0] > 30.0 * residuals[0] || drift[1] > 30.0 * residuals[1],
        "{drift:?}"
    );
}

#[test]
fn a_pendulum_under_taylor_stays_on_its_circle() {
    check_motion(Taylor::new());
}

#[test]
fn a_pendulum_under_dop853_stays_on_its_circle() {
    check_motion(
        Dop853::new()
            .relative_tolerance(1e-12)
            .absolute_tolerance(1e-12),
    );
}

#[test]
fn a_pendulum_under_fixed_steps_stays_on_its_circle() {
    check_motion(RungeKutta::classical(2e-3));
}

/// Fails unless a motion that is interrupted after some steps, stored and resumed is the same to the last bit.
fn check_resumed<I: Resume<f64, Rod> + Copy>(method: I) {
    let problem = || Problem::new(ROD, ROD.released(RELEASE));
    let whole = problem().solve(9.0, method).unwrap();
    for steps in [1, 4, 9] {
        let mut part = problem().max_steps(steps).start(method).unwrap();
        part.advance(9.0).unwrap();
        let mut resumed = problem().resume(part.checkpoint(), method).unwrap();
        let end = resumed.advance(9.0).unwrap();
        assert_eq!((end.last, end.statistics), (whole.last, whole.statistics));
    }
    assert!(whole.statistics.projection > 0.0);
}

#[test]
fn a_projected_motion_that_is_resumed_has_the_same_bits() {
    check_resumed(Taylor::new());
    check_resumed(Taylor::order_12().relative_tolerance(1e-7));
    check_resumed(Dop853::new());
    check_resumed(RungeKutta::classical(0.01));
}

#[test]
fn a_projected_motion_in_lanes_has_the_bits_that_it_has_alone() {
    let method = Taylor::order_16().relative_tolerance(1e-9);
    let motions: Vec<_> = [0.3, 1.2, 2.9, 0.7, 1.9, 1.1]
        .map(|angle| (ROD.released(angle), 4.0 + angle))
        .into();
    let together = in_lanes::<4, _, _>(method, &ROD, motions.clone());
    for (found, (start, end)) in together.iter().zip(motions) {
        let found = found.as_ref().unwrap();
        let alone = in_lanes::<1, _, _>(method, &ROD, [(start, end)]);
        assert_eq!(found, alone[0].as_ref().unwrap());
        let statistics = found.statistics;
        assert!(
            statistics.projection > 0.0 && statistics.projection < 1.0,
            "{statistics:?}"
        );
        // The steps are those of a single motion, but for rounding.
        let single = Problem::new(ROD, start).solve(end, method).unwrap();
        assert_eq!(single.statistics.steps, statistics.steps);
        assert_close(single.statistics.projection, statistics.projection, 1e-3);
        assert!((single.last.x - found.last.x).amax() < 1e-12);
    }
}

/// The closed form in lanes, step by step: residuals at each end, and a sample within each step.
#[test]
fn pendulums_in_lanes_stay_on_their_circles() {
    let angles = [0.4, 1.2, 2.0];
    let ends = [5.0, 9.0, 7.0];
    let starts = angles.map(|angle| ROD.released(angle).x);
    let mut stepper =
        TaylorLanes::<SVector<Lanes<3>, 4>, 3, 14>::new(Taylor::new(), 0.0, &starts[0]);
    for (lane, start) in starts.iter().enumerate() {
        stepper.set_lane(lane, 0.0, start);
    }
    let mut samples = 0;
    while (0..3).any(|lane| stepper.time(lane) < ends[lane]) {
        stepper.step(&ROD, &ends);
        let middle: [f64; 3] =
            core::array::from_fn(|lane| 0.5 * (stepper.time(lane) + stepper.previous_time(lane)));
        let sample = ROD
            .project(Lanes(middle), &stepper.interpolate(&middle))
            .unwrap();
        assert!(!sample.has_failed());
        for (lane, angle) in angles.into_iter().enumerate() {
            assert_eq!(stepper.error(lane), None);
            for (t, x) in [
                (stepper.time(lane), stepper.state(lane)),
                (middle[lane], sample.state().lane(lane)),
            ] {
                let expected = ROD.closed_form(angle, t);
                assert!(
                    (x[0] - expected[0]).hypot(x[1] - expected[1]) < 1e-12,
                    "{lane} {t}"
                );
                assert!(ROD.residuals(&x).into_iter().all(|r| r <= ROUNDING));
            }
            samples += 1;
        }
        // The polynomial ends at the projected state.
        let times = core::array::from_fn(|lane| stepper.time(lane));
        let end = stepper.interpolate(&times);
        for lane in 0..3 {
            assert!((end.lane(lane) - stepper.state(lane)).amax() <= 4.0 * f64::EPSILON);
        }
    }
    assert!(samples > 30);
}

/// Fails unless dense output ends at the projected state of each step, where the step is moved by far more than rounding.
fn check_dense_output<I>(method: &I)
where
    I: Integrator<f64, Rod, Stepper: DenseOutput<f64, Rod>>,
{
    let start = ROD.released(2.5);
    let mut stepper = method.start(&ROD, 0.0, start.x).unwrap();
    let mut steps = 0;
    while stepper.time() < 5.0 {
        stepper.step(&ROD, 5.0).unwrap();
        let (t, x) = (stepper.time(), *stepper.state());
        let interpolant = stepper.interpolant(&ROD).unwrap();
        for found in [interpolant.at(t), stepper.interpolate(&ROD, t)] {
            // Rounding of terms of the size of the velocity; the steps are moved by 10⁻¹⁰ and more.
            assert!((found - x).amax() <= 1e-14, "{:e}", (found - x).amax());
        }
        steps += 1;
    }
    let moved = stepper.statistics().projection;
    assert!(steps > 8 && moved > 1e-4, "{steps} {moved}");
}

#[test]
fn dense_output_ends_where_the_step_was_projected_to() {
    check_dense_output(&Taylor::order_12().relative_tolerance(1e-6));
    check_dense_output(
        &Dop853::new()
            .relative_tolerance(1e-6)
            .absolute_tolerance(1e-6),
    );
}

/// So short a step that high powers of its length are zero.
#[test]
fn the_polynomial_of_a_very_short_step_ends_where_it_was_projected_to() {
    let mut run = Problem::new(ROD, ROD.released(2.5))
        .start(Taylor::new())
        .unwrap();
    run.advance(1.0).unwrap();
    let end = 1.0 + 64.0 * f64::EPSILON;
    let last = run.advance(end).unwrap().last;
    assert_eq!(run.previous_time().to_bits(), 1.0_f64.to_bits());
    for t in [1.0, 1.0 + 32.0 * f64::EPSILON] {
        // The state moves by up to 40 a second.
        let moved = run.at(t).unwrap().x - last.x;
        assert!(
            moved.iter().all(|x| x.abs() <= 40.0 * 64.0 * f64::EPSILON),
            "{moved}"
        );
    }
}

/// A force with a jump: steps that end behind it are projected, too.
#[test]
fn ends_of_steps_at_jumps_are_projected() {
    let rod = Rod {
        friction: 1.0,
        ..ROD
    };
    let start = rod.released(RELEASE);
    // By so loose a tolerance the circle is left by much more than rounding in each step.
    let method = Taylor::order_12().relative_tolerance(1e-6);
    let mut jumps = 0;
    let mut before = start.x[0];
    let end = Problem::new(rod, start)
        .each_step(|progress| {
            assert!(rod.residuals(progress.x).into_iter().all(|r| r <= ROUNDING));
            jumps += usize::from(before * progress.x[0] < 0.0);
            before = progress.x[0];
        })
        .solve(20.0, method)
        .unwrap();
    assert!(jumps > 10);
    assert_close(rod.energy(&end.x), rod.energy(&start.x), 1e-5);
    let lanes = in_lanes::<2, _, _>(method, &rod, [(start, 20.0)]);
    let in_lanes = lanes[0].as_ref().unwrap();
    assert!(
        rod.residuals(&in_lanes.last.x)
            .into_iter()
            .all(|r| r <= ROUNDING)
    );
    assert!((in_lanes.last.x - end.last.x).amax() < 1e-10);
}

/// The derivatives of the end by the angle of release are those of differences of the closed form.
#[test]
fn dual_numbers_are_projected() {
    let at = |angle: Dual<f64, 1>| {
        let length = Dual::constant(ROD.length);
        let zero = Dual::constant(0.0);
        let position = [length * angle.sin(), -length * angle.cos()];
        let x = SVector::from([position[0], position[1], zero, zero]);
        let start = At::from((zero, x));
        Problem::new(ROD, start)
            .solve(3.0, Taylor::new())
            .unwrap()
            .last
            .x
    };
    let [angle] = Dual::variables([RELEASE]);
    let found = at(angle);
    let h = 1e-5;
    for i in 0..2 {
        let [more, less] = [h, -h].map(|h| ROD.closed_form(RELEASE + h, 3.0)[i]);
        assert_close(found[i].derivative[0], (more - less) / (2.0 * h), 1e-8);
    }
    // They are tangent to the circle.
    let tangent = found[0].value * found[0].derivative[0] + found[1].value * found[1].derivative[0];
    assert_close(tangent, 0.0, 1e-14);
}
