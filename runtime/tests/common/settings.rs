//! Settings of a problem, each of which counts beside each other one, whatever the order.
#![allow(dead_code, unused_imports, unused_macros)] // The pairs under some methods are in another package.

use core::cell::Cell;
use core::ops::ControlFlow;

use lagrangian::EquationsOfMotion;
use lagrangian::prelude::*;

/// A stone that falls from a height of 5 for 1 s, and passes a ledge on its way.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = g * x,
    event(floor = x, ledge = x - 2),
)]
pub(crate) struct Stone {
    pub(crate) g: f64,
}

pub(crate) const STONE: Stone = Stone { g: 10.0 };

/// When it passes the ledge: √(2 · 3/10).
pub(crate) const LEDGE: f64 = 0.774_596_669_241_483_4;

pub(crate) fn start() -> State<f64, 1> {
    State::new(0.0, [5.0], [0.0])
}

std::thread_local! {
    /// How often setting 8 was called.
    pub(crate) static CALLS: Cell<u32> = const { Cell::new(0) };
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
    /// The ends of steps are kept.
    at_steps: bool,
    /// It is called at each step.
    calls: bool,
}

macro_rules! effects {
    ($($field:ident: $value:expr),*) => {
        Effects { $($field: $value,)* ..Effects::default() }
    };
}

pub(crate) type At1 = At<f64, Phase<f64, 1>>;

// Functions and not closures: each closure is a type of its own, and so would be each problem that has one.
pub(crate) fn is_below(x: &At1) -> bool {
    x.q[0] < -0.5
}

pub(crate) fn height(x: &At1) -> f64 {
    x.q[0] - 2.0
}

pub(crate) fn clock(x: &At1) -> f64 {
    x.t - 0.25
}

pub(crate) fn nothing(_: &mut At1) {}

pub(crate) fn nothing_to_dynamics(_: &mut At1, _: &mut EquationsOfMotion<&'_ Stone, f64, 1>) {}

pub(crate) fn stop_late(progress: &Progress<'_, Phase<f64, 1>>) -> ControlFlow<()> {
    if progress.t > 0.9 {
        ControlFlow::Break(())
    } else {
        ControlFlow::Continue(())
    }
}

pub(crate) fn count(_: &Progress<'_, Phase<f64, 1>>) {
    CALLS.set(CALLS.get() + 1);
}

/// Settings by their numbers: what is set, and its effects.
macro_rules! set {
    (0, $problem:expr) => {
        $problem.stop_when($crate::settings::is_below)
    };
    (1, $problem:expr) => {
        $problem.when($crate::settings::height).stop()
    };
    (2, $problem:expr) => {
        $problem.when($crate::settings::height).falling().record()
    };
    (3, $problem:expr) => {
        $problem
            .when($crate::settings::clock)
            .then($crate::settings::nothing)
    };
    (4, $problem:expr) => {
        $problem.on($crate::settings::Stone::FLOOR).falling().stop()
    };
    (5, $problem:expr) => {
        $problem
            .on([
                $crate::settings::Stone::FLOOR,
                $crate::settings::Stone::LEDGE,
            ])
            .record()
    };
    (6, $problem:expr) => {
        $problem
            .on($crate::settings::Stone::LEDGE)
            .then_with($crate::settings::nothing_to_dynamics)
    };
    (7, $problem:expr) => {
        $problem.each_step($crate::settings::stop_late)
    };
    (8, $problem:expr) => {
        $problem.each_step($crate::settings::count)
    };
    (9, $problem:expr) => {
        $problem.max_steps(6)
    };
    (10, $problem:expr) => {
        $problem.singularity_tolerance(0.0)
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
        8 => effects!(calls: true),
        // Steps of fixed size are divided by samples.
        9 => effects!(stop: Some(0.28)),
        11 => {
            effects!(samples: Some(|end| (0..=12).filter(|k| 0.125 * f64::from(*k) <= end).count()))
        }
        12 => {
            effects!(samples: Some(|end| [0.125, 0.3, 0.8].iter().filter(|t| **t <= end).count()))
        }
        13 => effects!(at_steps: true),
        _ => effects!(),
    }
}

/// When a motion ended, its events and how many samples were kept.
pub(crate) type Found = Result<(f64, Vec<f64>, usize), IntegrationError>;

/// What was found of a motion.
macro_rules! found {
    ($problem:expr, $method:expr, samples) => {
        $crate::settings::found!(of $problem, $method, |solution| solution.samples().len())
    };
    ($problem:expr, $method:expr, end) => {
        $crate::settings::found!(of $problem, $method, |_| 0)
    };
    (of $problem:expr, $method:expr, |$solution:pat_param| $samples:expr) => {{
        $crate::settings::CALLS.set(0);
        let solution = $problem.solve(1.5, $method);
        solution.map_err(IntegrationError::from).map(|solution| {
            let events = solution.events().iter().map(|event| event.t).collect();
            let $solution = &solution;
            (solution.t, events, $samples)
        })
    }};
}

pub(crate) fn check(what: &str, found: Found, both: [usize; 2]) {
    if both.contains(&10) {
        let error = found.unwrap_err();
        let is_refused = matches!(error, IntegrationError::InvalidSingularityTolerance { .. });
        return assert!(is_refused, "{what}: {error}");
    }
    let (end, events, samples) = found.unwrap();
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
        assert_eq!(samples, wanted(end), "{what}");
    }
    if both.iter().any(|effects| effects.at_steps) {
        assert!(samples > 2, "{what}: {samples}");
    }
    let is_called = both.iter().any(|effects| effects.calls);
    assert_eq!(CALLS.get() > 2, is_called, "{what}: {}", CALLS.get());
}

/// Pairs of settings: each of the first list with each of the second, in both orders or in one.
macro_rules! pairs {
    ($method:tt, $kind:ident, [$($first:tt)*], $second:tt) => {
        $($crate::settings::pairs!(one $method, $kind, $first, $second);)*
    };
    (one (both, $method:expr), $kind:ident, $first:tt, $second:tt) => {
        $crate::settings::pairs!(one (first, $method), $kind, $first, $second);
        $crate::settings::pairs!(one (first, $method), $kind, $second, $first);
    };
    (one (first, $method:expr), $kind:ident, $first:tt, $second:tt) => {
        let what = concat!(stringify!($first), " and ", stringify!($second));
        let problem = Problem::new(&$crate::settings::STONE, $crate::settings::start());
        let problem = $crate::settings::set!($first, problem);
        let problem = $crate::settings::set!($second, problem);
        let found = $crate::settings::found!(problem, $method, $kind);
        $crate::settings::check(what, found, [$first, $second]);
    };
}

macro_rules! all_pairs {
    ($method:tt) => {
        $crate::settings::pairs!($method, end, [0 1 2 3 4 5 6 7 8 9 10], 0);
        $crate::settings::pairs!($method, end, [1 2 3 4 5 6 7 8 9 10], 1);
        $crate::settings::pairs!($method, end, [2 3 4 5 6 7 8 9 10], 2);
        $crate::settings::pairs!($method, end, [3 4 5 6 7 8 9 10], 3);
        $crate::settings::pairs!($method, end, [4 5 6 7 8 9 10], 4);
        $crate::settings::pairs!($method, end, [5 6 7 8 9 10], 5);
        $crate::settings::pairs!($method, end, [6 7 8 9 10], 6);
        $crate::settings::pairs!($method, end, [7 8 9 10], 7);
        $crate::settings::pairs!($method, end, [8 9 10], 8);
        $crate::settings::pairs!($method, end, [9 10], 9);
        $crate::settings::pairs!($method, end, [10], 10);
        $crate::settings::pairs!($method, samples, [0 1 2 3 4 5 6 7 8 9 10], 11);
        $crate::settings::pairs!($method, samples, [0 1 2 3 4 5 6 7 8 9 10], 12);
        $crate::settings::pairs!($method, samples, [0 1 2 3 4 5 6 7 8 9 10], 13);
    };
}

pub(crate) use {all_pairs, found, pairs, set};
