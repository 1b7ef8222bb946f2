//! Sampling, stop conditions, observers, and backward integration.

use core::ops::ControlFlow;

use crate::common::{Crossed, Oscillator, Pendulum, SymmetricTop, assert_close, equation};
use lagrangian::prelude::*;
use nalgebra::SVector;

const TOP: SymmetricTop = SymmetricTop {
    transverse: 1.0,
    axial: 0.6,
    weight: 2.0,
};

fn top_state(psi: f64) -> State<f64, 3> {
    State::new(0.0, [0.2, 0.7, psi], [0.4, -0.3, 6.0])
}

/// The oscillator from a time and a state on.
fn oscillator(t: f64, x: [f64; 2]) -> Problem<f64, Oscillator> {
    let x = SVector::from(x);
    Problem::new(Oscillator, At { t, x })
}

fn tight() -> Dop853 {
    Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12)
}

#[test]
fn the_symmetric_top_conserves_energy_and_momenta() {
    let initial = top_state(0.0);
    let times: Vec<f64> = (0..=100).map(|i| f64::from(i) * 0.1).collect();
    let motion = Problem::new(&TOP, initial)
        .save(&times)
        .solve(10.0, tight())
        .unwrap();
    assert_eq!(motion.samples().len(), 101);
    assert_eq!(motion.reason, StopReason::Completed);
    let steps = f64::from(u32::try_from(motion.statistics.steps).unwrap());
    let momenta = TOP.momenta(&initial);
    for state in motion {
        // Each step has an error up to the tolerance, and M has entries of about 1.
        let tolerance = 1e-12 * steps * 10.0;
        assert_close(TOP.energy(&state), TOP.energy(&initial), tolerance);
        assert_close(TOP.momenta(&state)[0], momenta[0], tolerance);
        assert_close(TOP.momenta(&state)[2], momenta[2], tolerance);
    }
}

#[test]
fn two_methods_agree() {
    let top = Problem::new(&TOP, top_state(0.0));
    let adaptive = top.clone().solve(3.0, tight()).unwrap();
    let fixed = top.solve(3.0, RungeKutta::classical(1e-3)).unwrap();
    for (a, b) in adaptive.x.components().zip(fixed.x.components()) {
        // (6 h)⁴/120 over three seconds at a frequency of 6.
        assert_close(a, b, 1e-10);
    }
}

#[test]
fn an_indefinite_mass_matrix_is_solved() {
    let initial = State::new(0.0, [1.0, 2.0], [0.0, 0.0]);
    let end = Problem::new(&Crossed, initial).solve(1.0, tight()).unwrap();
    assert_close(end.q[0], 1.0_f64.cos(), 1e-11);
    assert_close(end.q[1], 2.0 * 1.0_f64.cos(), 1e-11);
}

#[test]
fn backward_integration_returns() {
    let initial = top_state(0.0);
    let there = Problem::new(&TOP, initial).solve(5.0, tight()).unwrap();
    let back = Problem::new(&TOP, there.last).solve(0.0, tight()).unwrap();
    for (a, b) in back.x.components().zip(initial.x.components()) {
        assert_close(a, b, 1e-9);
    }
    let fixed = RungeKutta::classical(1e-3);
    let there = Problem::new(&TOP, initial).solve(1.0, fixed).unwrap();
    let back = Problem::new(&TOP, there.last).solve(0.0, fixed).unwrap();
    for (a, b) in back.x.components().zip(initial.x.components()) {
        assert_close(a, b, 1e-10);
    }
}

#[test]
fn samples_are_taken_backwards_too() {
    let times = [1.0, 0.5, 0.5, -0.25, -1.0];
    let sampled = || oscillator(1.0, [1.0_f64.cos(), -1.0_f64.sin()]).save(times);
    let dense = sampled().solve(-1.0, tight()).unwrap();
    let fixed = sampled().solve(-1.0, RungeKutta::classical(1e-3)).unwrap();
    for motion in [dense, fixed] {
        assert_eq!(motion.samples().len(), times.len());
        for (sample, t) in motion.samples().iter().zip(times) {
            assert_eq!(sample.t.to_bits(), t.to_bits());
            assert_close(sample[0], t.cos(), 1e-11);
        }
    }
}

/// The steps depend on angles modulo whole turns only.
#[test]
fn the_size_of_an_angle_does_not_change_the_steps() {
    let run = |psi| {
        let end = Problem::new(&TOP, top_state(psi)).solve(5.0, tight());
        let end = end.unwrap();
        // φ and ψ are ignorable: no other component depends on them, to the last bit.
        (end.statistics, end.q[0], end.q[1], end.v)
    };
    assert_eq!(run(0.0), run(1e6));
    assert_eq!(run(0.0), run(-1e3));

    // The tolerance of a component that is not an angle is proportional to its magnitude.
    let steps = |x| {
        let shifted = equation::<2, _>(move |t, _| SVector::from([t.cos(), t.sin()]));
        let method = Dop853::new()
            .relative_tolerance(1e-10)
            .absolute_tolerance(1e-10);
        let initial = At::from((0.0, SVector::from([x, x])));
        let end = Problem::new(shifted, initial).solve(20.0, method);
        end.unwrap().statistics.steps
    };
    assert!(steps(1e6) < steps(0.0));
}

#[test]
fn an_empty_list_of_times_gives_an_empty_trajectory() {
    let initial = top_state(0.0);
    let top = Problem::new(&TOP, initial);
    let motion = top.clone().save([]).solve(0.0, tight()).unwrap();
    assert!(motion.samples().is_empty());
    assert_eq!(motion.last, initial);
    assert_eq!(motion.statistics.steps, 0);
    let motion = top.save([0.0, -0.0, 0.0]).solve(0.0, tight()).unwrap();
    assert_eq!(motion.samples().len(), 3);
}

#[test]
fn a_condition_stops_at_the_end_of_a_step() {
    let motion = oscillator(0.0, [1.0, 0.0])
        .stop_when(|x| x.t > 1.0)
        .save([0.5, 1.0, 100.0])
        .solve(100.0, tight())
        .unwrap();
    assert_eq!(motion.reason, StopReason::Condition);
    assert_eq!(motion.samples().len(), 2);
    assert!(motion.t > 1.0 && motion.t < 10.0);
    assert_close(motion[0], motion.t.cos(), 1e-11);

    let stopped = oscillator(0.0, [1.0, 0.0]).stop_when(|_| true);
    let end = stopped.solve(1.0, tight()).unwrap();
    assert_eq!((end.reason, end.t), (StopReason::Condition, 0.0));
}

#[test]
fn a_zero_is_located_within_a_step() {
    let quarter = core::f64::consts::FRAC_PI_2;
    let until_zero = |t, x| oscillator(t, x).when(|x| x[0]).stop();
    let end = until_zero(0.0, [1.0, 0.0]).solve(10.0, tight()).unwrap();
    assert_eq!(end.reason, StopReason::Condition);
    assert_close(end.t, quarter, 1e-11);

    let motion = until_zero(0.0, [1.0, 0.0])
        .save([1.5, 1.571, 10.0])
        .solve(10.0, RungeKutta::classical(0.01))
        .unwrap();
    let count = motion.samples().len();
    assert_eq!(count, 1, "the second time is after the zero");
    // h⁴/120 over the way.
    assert_close(motion.t, quarter, 1e-9);

    // Backwards, and from a start at zero, which is no crossing.
    let end = until_zero(quarter, [0.0, -1.0]).solve(-10.0, tight());
    assert_close(end.unwrap().t, -quarter, 1e-11);
}

#[test]
fn an_observer_sees_samples_and_steps_in_order_and_can_stop() {
    let mut seen: Vec<(f64, f64, ObservationKind)> = Vec::new();
    let end = oscillator(0.0, [1.0, 0.0])
        .save([0.0, 1.0, 1.1, 5.0, 10.0])
        .each_step(|progress| {
            seen.push((progress.t, progress.fraction(), progress.kind));
            if progress.t < 4.0 {
                ControlFlow::Continue(())
            } else {
                ControlFlow::Break(())
            }
        })
        .solve(10.0, tight())
        .unwrap();
    assert_eq!(end.reason, StopReason::Observer);
    assert!(end.t >= 4.0 && end.t <= 5.0);
    assert!(seen.is_sorted_by(|a, b| a.0 <= b.0));
    let samples: Vec<f64> = seen
        .iter()
        .filter(|(.., kind)| *kind == ObservationKind::Sample)
        .map(|(t, ..)| *t)
        .collect();
    assert_eq!(samples, [0.0, 1.0, 1.1]);
    let steps = seen.len() - samples.len();
    assert_eq!(steps as u64, end.statistics.steps);
    assert!(
        seen.iter()
            .all(|(t, fraction, _)| (fraction * 10.0 - t).abs() < 1e-12)
    );
}

#[test]
fn a_clone_of_a_stepper_is_a_checkpoint() {
    let dynamics = TOP.dynamics();
    let initial = Phase::from(top_state(0.0));
    let mut stepper = tight().start(&dynamics, 0.0, initial).unwrap();
    for _ in 0..5 {
        stepper.step(&dynamics, 9.0).unwrap();
    }
    let mut checkpoint = stepper.clone();
    for _ in 0..20 {
        stepper.step(&dynamics, 9.0).unwrap();
        checkpoint.step(&dynamics, 9.0).unwrap();
    }
    assert_eq!(stepper.state(), checkpoint.state());
    assert_eq!(stepper.time().to_bits(), checkpoint.time().to_bits());
}

/// A held input changes between steps; the stored derivative must be discarded.
#[test]
fn a_restart_forgets_the_derivative() {
    let pull = |force: f64| equation::<1, _>(move |_, _| SVector::from([force]));
    let mut stepper = tight()
        .start(&pull(1.0), 0.0, SVector::from([0.0]))
        .unwrap();
    while stepper.time() < 1.0 {
        stepper.step(&pull(1.0), 1.0).unwrap();
    }
    stepper.restart(&pull(-1.0));
    while stepper.time() < 2.0 {
        stepper.step(&pull(-1.0), 2.0).unwrap();
    }
    assert_close(stepper.state()[0], 0.0, 1e-14);
}

/// 1.1 / 0.1 is 11.000000000000002 in `f64`.
#[test]
fn a_multiple_of_the_step_takes_that_many_steps() {
    for steps in [3_u32, 6, 7, 11, 23] {
        let end = f64::from(steps) / 10.0;
        let end = oscillator(0.0, [1.0, 0.0]).solve(end, RungeKutta::classical(0.1));
        assert_eq!(end.unwrap().statistics.steps, u64::from(steps));
    }
}

/// A step that is shortened to land on a time does not shorten the following ones.
#[test]
fn landing_often_does_not_shorten_the_steps() {
    let dynamics = TOP.dynamics();
    let mut stepper = tight()
        .start(&dynamics, 0.0, Phase::from(top_state(0.0)))
        .unwrap();
    for target in [1.0, 1.0 + 1e-9, 2.0] {
        while stepper.time() < target {
            stepper.step(&dynamics, target).unwrap();
        }
    }
    let straight = Problem::new(&TOP, top_state(0.0))
        .solve(2.0, tight())
        .unwrap();
    assert!(stepper.statistics().steps <= straight.statistics.steps + 3);
}

#[test]
fn a_pendulum_has_the_period_of_the_elliptic_integral() {
    // T = 4 K(sin ½θ₀) √(l/g) by the arithmetic-geometric mean: K(k) = π / (2 agm(1, √(1 − k²))).
    let amplitude = 2.0_f64;
    let (mut a, mut b) = (1.0, (amplitude / 2.0).cos());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    let pendulum = Pendulum {
        m: 0.3,
        g: 9.81,
        l: 0.7,
    };
    let period = 2.0 * core::f64::consts::PI / a * (pendulum.l / pendulum.g).sqrt();
    let initial = State::new(0.0, [amplitude], [0.0]);
    let end = Problem::new(&pendulum, initial)
        .solve(3.0 * period, tight())
        .unwrap();
    assert_close(end.q[0], amplitude, 1e-10);
    assert_close(end.v[0], 0.0, 1e-9);
}
