//! Problems: each setting counts beside each other one, whatever the order; what is saved is what the motion passes.

use core::ops::ControlFlow;

use lagrangian::nalgebra::SVector;
use lagrangian::prelude::*;
use lagrangian::{Lanes, StepEnds};

/// A stone that falls from a height of 5 for 1 s, and passes a ledge on its way.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = g * x,
    event(floor = x, ledge = x - 2),
)]
struct Stone {
    g: f64,
}

const STONE: Stone = Stone { g: 10.0 };

/// When it passes the ledge: √(2 · 3/10).
const LEDGE: f64 = 0.774_596_669_241_483_4;

fn start() -> State<f64, 1> {
    State::new(0.0, [5.0], [0.0])
}

/// What a setting does.
#[derive(Default)]
struct Effects {
    /// It stops then.
    stop: Option<f64>,
    /// Events are recorded then.
    events: Vec<f64>,
    /// So many samples are kept, of a motion that ends at a time.
    samples: Option<fn(f64) -> usize>,
}

macro_rules! effects {
    ($($field:ident: $value:expr),*) => {
        Effects { $($field: $value,)* ..Effects::default() }
    };
}

/// Settings by their numbers: what is set, and its effects.
macro_rules! set {
    (0, $problem:expr) => {
        $problem.stop_when(|x| x.q[0] < -0.5)
    };
    (1, $problem:expr) => {
        $problem.when(|x| x.q[0] - 2.0).stop()
    };
    (2, $problem:expr) => {
        $problem.when(|x| x.q[0] - 2.0).falling().record()
    };
    (3, $problem:expr) => {
        $problem.when(|x| x.t - 0.25).then(|_| ())
    };
    (4, $problem:expr) => {
        $problem.on(Stone::FLOOR).falling().stop()
    };
    (5, $problem:expr) => {
        $problem.on([Stone::FLOOR, Stone::LEDGE]).record()
    };
    (6, $problem:expr) => {
        $problem.on(Stone::LEDGE).then_with(|_, _| ())
    };
    (7, $problem:expr) => {
        $problem.each_step(|progress| {
            if progress.t > 0.9 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        })
    };
    (8, $problem:expr) => {
        $problem.each_step(|_| ())
    };
    (9, $problem:expr) => {
        $problem.max_steps(1000)
    };
    (10, $problem:expr) => {
        $problem.singularity_tolerance(1.0)
    };
    (11, $problem:expr) => {
        $problem.save(Every(0.125))
    };
    (12, $problem:expr) => {
        $problem.save([0.125, 0.3, 0.8])
    };
    (13, $problem:expr) => {
        $problem.save(StepEnds)
    };
}

fn effects(setting: usize) -> Effects {
    match setting {
        // At the end of a step.
        0 => effects!(stop: Some(1.05)),
        1 => effects!(stop: Some(LEDGE), events: vec![LEDGE]),
        2 | 6 => effects!(events: vec![LEDGE]),
        3 => effects!(events: vec![0.25]),
        4 => effects!(stop: Some(1.0), events: vec![1.0]),
        5 => effects!(events: vec![LEDGE, 1.0]),
        7 => effects!(stop: Some(0.9)),
        11 => {
            effects!(samples: Some(|end| (0..=12).filter(|k| 0.125 * f64::from(*k) <= end).count()))
        }
        12 => {
            effects!(samples: Some(|end| [0.125, 0.3, 0.8].iter().filter(|t| **t <= end).count()))
        }
        _ => effects!(),
    }
}

/// What was found of a motion: when it ended, its events and how many samples were kept.
macro_rules! found {
    ($problem:expr, $method:expr, samples) => {{
        let solution = $problem.solve(1.5, $method).unwrap();
        let events: Vec<f64> = solution.events().iter().map(|event| event.t).collect();
        (solution.t, events, Some(solution.samples().len()))
    }};
    ($problem:expr, $method:expr, end) => {{
        let solution = $problem.solve(1.5, $method).unwrap();
        let events: Vec<f64> = solution.events().iter().map(|event| event.t).collect();
        (solution.t, events, None)
    }};
}

fn check(what: &str, (end, events, samples): (f64, Vec<f64>, Option<usize>), both: [usize; 2]) {
    let both = both.map(effects);
    let stops = both.iter().filter_map(|effects| effects.stop);
    let stop = stops.fold(1.5, f64::min);
    assert!(
        (end - stop).abs() < 0.06,
        "{what}: ends at {end}, not at {stop}"
    );
    let mut expected: Vec<f64> = both
        .iter()
        .flat_map(|effects| effects.events.clone())
        .collect();
    expected.retain(|t| *t <= stop + 1e-9);
    expected.sort_by(f64::total_cmp);
    assert_eq!(events.len(), expected.len(), "{what}: {events:?}");
    for (found, expected) in events.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-9, "{what}: {events:?}");
    }
    for wanted in both.iter().filter_map(|effects| effects.samples) {
        assert_eq!(samples, Some(wanted(end)), "{what}");
    }
}

/// Pairs of settings: each of the first list with each of the second, in both orders.
macro_rules! pairs {
    ($method:expr, $kind:ident, [$($first:tt)*], $second:tt) => {
        $(pairs!(one $method, $kind, $first, $second);)*
    };
    (one $method:expr, $kind:ident, $first:tt, $second:tt) => {
        let what = concat!(stringify!($first), " and ", stringify!($second));
        let found = found!(set!($second, set!($first, Problem::new(&STONE, start()))), $method, $kind);
        check(what, found, [$first, $second]);
        let found = found!(set!($first, set!($second, Problem::new(&STONE, start()))), $method, $kind);
        check(what, found, [$second, $first]);
    };
}

macro_rules! all_pairs {
    ($method:expr) => {
        pairs!($method, end, [0 1 2 3 4 5 6 7 8 9 10], 0);
        pairs!($method, end, [1 2 3 4 5 6 7 8 9 10], 1);
        pairs!($method, end, [2 3 4 5 6 7 8 9 10], 2);
        pairs!($method, end, [3 4 5 6 7 8 9 10], 3);
        pairs!($method, end, [4 5 6 7 8 9 10], 4);
        pairs!($method, end, [5 6 7 8 9 10], 5);
        pairs!($method, end, [6 7 8 9 10], 6);
        pairs!($method, end, [7 8 9 10], 7);
        pairs!($method, end, [8 9 10], 8);
        pairs!($method, end, [9 10], 9);
        pairs!($method, end, [10], 10);
        pairs!($method, samples, [0 1 2 3 4 5 6 7 8 9 10], 11);
        pairs!($method, samples, [0 1 2 3 4 5 6 7 8 9 10], 12);
        pairs!($method, samples, [0 1 2 3 4 5 6 7 8 9 10], 13);
    };
}

#[test]
fn all_pairs_of_settings_count_under_taylor() {
    all_pairs!(Taylor::new().max_step(0.05));
}

#[test]
fn all_pairs_of_settings_count_under_dop853() {
    all_pairs!(Dop853::new().max_step(0.05));
}

#[test]
fn all_pairs_of_settings_count_under_runge_kutta() {
    all_pairs!(RungeKutta::classical(0.05));
}

/// Samples from the start to the end, the last one exactly there where it differs by rounding alone.
#[test]
fn intervals_begin_at_the_start_and_end_at_the_end() {
    for (from, to, interval, count) in [
        (0.0_f64, 1.0_f64, 0.1, 11),
        (0.0, 0.95, 0.1, 10),
        (1.0, 0.0, 0.1, 11),
        (1e3, 1e3 + 0.3, 0.1, 4),
        (0.0, 0.05, 0.1, 1),
        (0.0, 0.0, 0.1, 1),
    ] {
        let start = State::new(from, [5.0], [0.0]);
        let motion = Problem::new(&STONE, start)
            .save(Every(interval))
            .solve(to, Dop853::new());
        let motion = motion.unwrap();
        assert_eq!(motion.t.to_bits(), to.to_bits());
        let times: Vec<f64> = motion.samples().iter().map(|state| state.t).collect();
        assert_eq!(times.len(), count, "{times:?}");
        assert_eq!(times[0].to_bits(), from.to_bits());
        for (k, t) in (0..).zip(&times) {
            let exact = from + (to - from).signum() * interval * f64::from(k);
            assert!(k == 0 || (t - exact).abs() < 1e-12);
        }
        let last = times[count - 1];
        assert!(
            (last - to).abs() >= 0.04 || last.to_bits() == to.to_bits(),
            "{times:?}"
        );
    }
}

#[test]
fn samples_steps_and_the_dense_motion_agree() {
    let top = |t: f64| 5.0 - 5.0 * t * t;
    let steps = Problem::new(&STONE, start())
        .save(StepEnds)
        .solve(1.0, Dop853::new())
        .unwrap();
    assert_eq!(steps.samples().len() as u64, steps.statistics.steps + 1);
    let times: Vec<f64> = steps.samples().iter().map(|state| state.t).collect();
    let dense = Problem::new(&STONE, start())
        .save(Dense)
        .solve(1.0, Dop853::new())
        .unwrap();
    assert_eq!(dense.times().collect::<Vec<_>>(), times);
    let sampled = Problem::new(&STONE, start())
        .save(&times)
        .solve(1.0, Dop853::new())
        .unwrap();
    assert_eq!(sampled.samples(), steps.samples());
    for t in [0.0, 0.123, 0.77, 1.0] {
        assert!((dense.at(t).unwrap().q[0] - top(t)).abs() < 1e-13);
        assert!((dense.derivative(t).unwrap().unwrap().q[0] + 10.0 * t).abs() < 1e-12);
    }
    assert!(matches!(
        dense.at(1.5),
        Err(IntegrationError::OutsideSolution { .. })
    ));
}

/// A jump is behind `at` and before `before`.
#[test]
fn reactions_change_the_state_and_the_model() {
    let bounce = Problem::new(&STONE, start())
        .on(Stone::FLOOR)
        .falling()
        .then(|x| x.v[0] *= -0.5)
        .save(Dense)
        .solve(1.25, Taylor::new())
        .unwrap();
    let floor = bounce.events()[0].t;
    assert!((floor - 1.0).abs() < 1e-15);
    assert!((bounce.before(floor).unwrap().v[0] + 10.0).abs() < 1e-13);
    assert!((bounce.at(floor).unwrap().v[0] - 5.0).abs() < 1e-13);
    // Gravitation ends at the ledge.
    let end = Problem::new(STONE, start())
        .when(|x| x.q[0] - 2.0)
        .falling()
        .then_with(|_, stone| stone.change(|stone| stone.g = 0.0))
        .solve(1.5, Taylor::new())
        .unwrap();
    let expected = 2.0 - 10.0 * LEDGE * (1.5 - LEDGE);
    assert!((end.q[0] - expected).abs() < 1e-12);
    // The third bounce ends it.
    let mut bounces = 0;
    let end = Problem::new(&STONE, start())
        .on(Stone::FLOOR)
        .falling()
        .then(|x| {
            x.v[0] *= -0.5;
            bounces += 1;
            if bounces == 3 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        })
        .solve(10.0, Taylor::new())
        .unwrap();
    assert_eq!((end.reason, end.events().len()), (StopReason::Condition, 3));
    assert!((end.t - 2.5).abs() < 1e-13);
}

/// What cannot be is an error with what was set, and nothing is lost of the motion before an error.
#[test]
fn mistakes_are_errors_and_keep_what_is_known() {
    for interval in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = Problem::new(&STONE, start())
            .save(Every(interval))
            .solve(1.0, Dop853::new());
        let error = refused.unwrap_err().error();
        assert!(
            matches!(error, IntegrationError::InvalidSampleInterval { .. }),
            "{error}"
        );
    }
    for times in [[-0.5, 0.5], [0.5, 1.5]] {
        let refused = Problem::new(&STONE, start())
            .save(times)
            .solve(1.0, Dop853::new());
        let error = refused.unwrap_err().error();
        assert!(
            matches!(error, IntegrationError::OutsideSpan { .. }),
            "{error}"
        );
    }
    let refused = Problem::new(&STONE, start())
        .save([0.5, 0.25])
        .solve(1.0, Dop853::new());
    let error = refused.unwrap_err().error();
    assert!(
        matches!(error, IntegrationError::UnorderedTimes { .. }),
        "{error}"
    );
    let refused = Problem::new(&STONE, start()).solve(f64::NAN, Dop853::new());
    assert!(matches!(
        refused.unwrap_err().error(),
        IntegrationError::NonFiniteTime { .. }
    ));
    // ẋ = x² reaches infinity at t = 1, but for the error of the integration.
    let failed = Problem::new(
        Blowup,
        At {
            t: 0.0,
            x: SVector::from([1.0]),
        },
    )
    .save(Every(0.25))
    .solve(2.0, Dop853::new())
    .unwrap_err();
    let known = failed.solution();
    assert_eq!(known.samples().len(), 5, "{failed}");
    assert!((known.samples()[3][0] - 4.0).abs() < 1e-7);
    assert!((known.t - 1.0).abs() < 1e-8 && known.reason == StopReason::Error);
    assert_eq!(format!("{failed:?}"), failed.to_string());
}

#[derive(Debug)]
struct Blowup;

impl Dynamics for Blowup {
    type State = SVector<f64, 1>;

    fn derivative(&self, _: f64, x: &Self::State) -> Self::State {
        SVector::from([x[0] * x[0]])
    }
}

/// Parts of a motion are the motion, to the last bit; a change begins anew.
#[test]
fn a_run_is_advanced_stored_and_changed() {
    let problem = Problem::new(&STONE, start()).on(Stone::LEDGE).record();
    let method = Dop853::new().max_step(0.1);
    let whole = problem.clone().solve(1.0, method).unwrap();
    let mut run = problem.clone().start(method).unwrap();
    let mut steps = 0;
    while let Some(step) = run.step(1.0).unwrap() {
        steps += 1;
        assert!(run.previous_time() < step.t);
        let middle = 0.5 * (run.previous_time() + run.state().t);
        assert!((run.at(middle).unwrap().q[0] - (5.0 - 5.0 * middle * middle)).abs() < 1e-12);
    }
    assert_eq!(steps, whole.statistics.steps);
    assert_eq!(run.state(), whole.last);
    assert!(run.at(0.1).is_err());
    // From a checkpoint within it.
    let mut run = problem.clone().start(method).unwrap();
    while run.state().t < 0.5 {
        run.step(1.0).unwrap();
    }
    let stored = run.checkpoint();
    let mut resumed = problem.resume(stored, method).unwrap();
    let end = resumed.advance(1.0).unwrap();
    assert_eq!((end.last, end.events().len()), (whole.last, 1));
    // Upwards again, under half of the weight.
    let mut run = Problem::new(STONE, start()).start(Taylor::new()).unwrap();
    run.advance(1.0).unwrap();
    run.change(|x, stone| {
        x.v[0] = 5.0;
        stone.change(|stone| stone.g = 5.0);
    })
    .unwrap();
    let end = run.advance(2.0).unwrap();
    assert!((end.q[0] - 2.5).abs() < 1e-13 && end.v[0].abs() < 1e-13);
    assert_eq!(run.dynamics().model().g.to_bits(), 5.0_f64.to_bits());
}

/// A reaction of a run that is advanced by hand.
#[test]
fn a_run_reacts() {
    let mut run = Problem::new(&STONE, start())
        .on(Stone::FLOOR)
        .falling()
        .then(|x| x.v[0] *= -1.0)
        .start(Taylor::new())
        .unwrap();
    let mut bounces = 0;
    for k in 1..=80 {
        bounces += run.advance(0.1 * f64::from(k)).unwrap().events().len();
    }
    assert_eq!(bounces, 4);
    assert!((run.state().q[0] - 5.0).abs() < 1e-11);
}

/// Other scalars: f32, and lanes whose motions go on together.
#[test]
fn events_are_functions_on_the_scalar() {
    let start = State::new(0.0_f32, [5.0], [0.0]);
    let end = Problem::new(&STONE, start)
        .when(|x| x.q[0])
        .falling()
        .stop();
    let end = end
        .solve(2.0, Dop853::new().relative_tolerance(1e-5))
        .unwrap();
    assert!((end.t - 1.0).abs() < 1e-5);
    let heights = Lanes([5.0, 20.0]);
    let start = State::new(Lanes([0.0; 2]), [heights], [Lanes([0.0; 2])]);
    let end = Problem::new(&STONE, start)
        .when(|x| x.q[0].0[0])
        .falling()
        .stop();
    let end = end.solve(2.0, Dop853::new()).unwrap();
    assert!((end.t.0[0] - 1.0).abs() < 1e-9);
    assert!((end.q[0].0[1] - 15.0).abs() < 1e-8);
}
