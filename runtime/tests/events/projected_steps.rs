//! Events where steps are projected: their ends are moved by far more than rounding, and no zero there is lost or found twice.

use crate::constrained::{RELEASE, ROD};
use crate::random_numbers::Random;
use lagrangian::prelude::*;
use lagrangian::problem::Projection;
use lagrangian::{
    DeclaredEvent, EventDynamics, Integrator, ObservationKind, Series, SeriesMemory,
    TaylorCoefficients,
};
use nalgebra::SVector;

type Pendulum = crate::constrained::Rod;

/// Seven half periods, from one turning point to another: each position between them is passed seven times, four times on the way
/// back.
const HALF_PERIODS: u32 = 7;
const BACK: usize = 4;

/// A position that counts is so far from the turning points that the errors of the method do not matter.
const INNER: f64 = 0.95;

fn end() -> f64 {
    f64::from(HALF_PERIODS) * ROD.half_period(RELEASE)
}

/// The events where one coordinate is c, in parts of the run that end at these times: in either direction, upwards, downwards.
fn crossings<I: Integrator<f64, Pendulum> + Copy>(method: I, c: f64, ends: &[f64]) -> [usize; 3] {
    let mut run = Problem::new(ROD, ROD.released(RELEASE))
        .when(move |x| x[0] - c)
        .record()
        .when(move |x| x[0] - c)
        .rising()
        .record()
        .when(move |x| c - x[0])
        .rising()
        .record()
        .start(method)
        .unwrap();
    let mut found = [0; 3];
    for end in ends {
        for event in run.advance(*end).unwrap().events() {
            found[event.event] += 1;
            let x = event.x;
            let residuals = ROD.residuals(&x);
            assert!(
                residuals.into_iter().all(|r| r <= 4.0 * f64::EPSILON),
                "{residuals:?}"
            );
            // The function is zero at the state that is shown.
            assert!((x[0] - c).abs() <= 1e-13, "{:e}", x[0] - c);
        }
    }
    found
}

/// The states at the ends of all steps, in parts of the run that end at these times.
fn step_ends<I: Integrator<f64, Pendulum>>(method: I, ends: &[f64]) -> (Vec<SVector<f64, 4>>, f64) {
    let mut states = Vec::new();
    let mut run = Problem::new(ROD, ROD.released(RELEASE))
        .each_step(|progress| {
            if progress.kind == ObservationKind::Step {
                states.push(*progress.x);
            }
        })
        .start(method)
        .unwrap();
    for end in ends {
        run.advance(*end).unwrap();
    }
    let moved = run.statistics().projection;
    drop(run);
    (states, moved)
}

/// Looks for the positions at all ends of steps, in runs that are divided at random. Returns how many events there are.
fn check<I: Integrator<f64, Pendulum> + Copy>(
    method: I,
    random: &mut Random,
    runs: usize,
) -> usize {
    let largest = RELEASE.sin() * ROD.length;
    let mut count = 0;
    for _ in 0..runs {
        let mut ends: Vec<_> = (0..random.below(6))
            .map(|_| random.uniform() * end())
            .collect();
        ends.push(end());
        ends.sort_by(f64::total_cmp);
        let (states, moved) = step_ends(method, &ends);
        assert!(moved > 0.0);
        for state in states.iter().filter(|x| x[0].abs() < INNER * largest) {
            let found = crossings(method, state[0], &ends);
            assert_eq!(found, [7, 7 - BACK, BACK], "{} {ends:?}", state[0]);
            count += 1;
        }
    }
    count
}

#[test]
fn zeros_at_ends_of_projected_steps_are_events_once() {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let counts = [
        check(Taylor::order_12().relative_tolerance(1e-5), &mut random, 3),
        check(
            Dop853::new()
                .relative_tolerance(1e-5)
                .absolute_tolerance(1e-5),
            &mut random,
            3,
        ),
        check(RungeKutta::classical(0.1), &mut random, 2),
    ];
    assert!(7 * counts.iter().sum::<usize>() > 2000, "{counts:?}");
}

/// The pendulum with a declared event, where x = c: it is found by the series of its function.
struct Level(f64);

impl Dynamics for Level {
    type State = SVector<f64, 4>;

    fn derivative(&self, t: f64, x: &Self::State) -> Self::State {
        ROD.derivative(t, x)
    }

    fn project(&self, t: f64, x: &Self::State) -> Option<Projection<f64, Self::State>> {
        ROD.project(t, x)
    }
}

impl Series for Level {
    fn series<const HALF: usize>(
        &self,
        begin: (f64, &Self::State),
        unit: f64,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        memory: Option<&mut SeriesMemory>,
    ) {
        ROD.series(begin, unit, coefficients, memory);
    }
}

impl EventDynamics<f64> for Level {
    type Model = Self;
    type Values = [f64; 1];

    fn names(&self) -> &'static [&'static str] {
        &["level"]
    }

    fn event_functions(&self, _: f64, x: &Self::State) -> [f64; 1] {
        [x[0] - self.0]
    }

    fn event_series<const HALF: usize, const OF_MOTION: usize>(
        &self,
        _: f64,
        x: &Self::State,
        _: f64,
        motion: &TaylorCoefficients<Self::State, OF_MOTION>,
    ) -> Option<TaylorCoefficients<[f64; 1], HALF>> {
        let mut series = TaylorCoefficients::new([x[0] - self.0]);
        for (term, motion) in series.higher_mut().iter_mut().zip(motion.higher()) {
            *term = [motion[0]];
        }
        Some(series)
    }
}

/// Every few ends of steps: the isolation of roots takes its time without optimization.
const EVERY: usize = 8;

#[test]
fn declared_events_at_ends_of_projected_steps_occur_once() {
    let mut random = Random(0xD1B5_4A32_D192_ED03);
    let largest = RELEASE.sin() * ROD.length;
    let mut count = 0;
    let tolerance = 1e-5;
    let method = Taylor::order_12().relative_tolerance(tolerance);
    for first in 0..3 {
        let mut ends: Vec<_> = (0..random.below(6))
            .map(|_| random.uniform() * end())
            .collect();
        ends.push(end());
        ends.sort_by(f64::total_cmp);
        let (states, _) = step_ends(method, &ends);
        let inner = states.iter().filter(|x| x[0].abs() < INNER * largest);
        for state in inner.skip(first).step_by(EVERY) {
            let level = Level(state[0]);
            let mut run = Problem::new(&level, ROD.released(RELEASE))
                .on(DeclaredEvent::new(0))
                .record()
                .on(DeclaredEvent::new(0))
                .falling()
                .record()
                .start(method)
                .unwrap();
            let mut found = [0; 2];
            for end in &ends {
                for event in run.advance(*end).unwrap().events() {
                    found[event.event] += 1;
                    let residuals = ROD.residuals(&event.x);
                    assert!(residuals.into_iter().all(|r| r <= 4.0 * f64::EPSILON));
                    // It is found on the polynomial, which is projected then.
                    assert!((event.x[0] - level.0).abs() < 1e-2 * tolerance);
                }
            }
            assert_eq!(found, [7, BACK], "{} {ends:?}", state[0]);
            count += 7;
        }
    }
    assert!(count > 70, "{count}");
}

/// The pendulum is turned back at each passage of its lowest point: it swings on one side, where a half period lies between two events.
#[test]
fn reactions_at_events_of_projected_steps_follow_each_other() {
    let level = Level(0.0);
    let back = |x: &mut At<f64, SVector<f64, 4>>| {
        x[2] = -x[2];
        x[3] = -x[3];
    };
    let half_period = ROD.half_period(RELEASE);
    let end = 40.0 * half_period;
    let problem = || Problem::new(&level, ROD.released(RELEASE));
    for tolerance in [1e-5, 1e-8] {
        let method = Taylor::order_12().relative_tolerance(tolerance);
        let declared = problem()
            .on(DeclaredEvent::new(0))
            .falling()
            .then(back)
            .solve(end, method);
        let sampled = problem().when(|x| x[0]).falling().then(back);
        let sampled = sampled.solve(end, method);
        for motion in [declared.unwrap(), sampled.unwrap()] {
            assert_eq!(motion.reason, StopReason::Completed);
            assert_eq!(motion.events().len(), 40);
            let mut expected = 0.5 * half_period;
            for event in motion.events() {
                assert!(
                    (event.t - expected).abs() < 100.0 * tolerance,
                    "{}",
                    event.t - expected
                );
                assert!(
                    ROD.residuals(&event.x)
                        .into_iter()
                        .all(|r| r <= 4.0 * f64::EPSILON)
                );
                expected += half_period;
            }
        }
    }
}
