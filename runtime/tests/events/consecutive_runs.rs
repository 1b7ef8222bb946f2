//! Every event belongs to one of two consecutive runs, however the first of them ends: at its final time, by an observer at a
//! sample, at an event or at the end of a step, by a step limit, or as a call of an integration in progress.

use crate::directions::{Direction, EVERY, directed};
use crate::random_numbers::Random;
use crate::two_runs::{ENDS, Watching, X, in_two_runs, run};
use lagrangian::prelude::*;
use lagrangian::problem::Watched;
use lagrangian::{EquationsOfMotion, Resume};

/// A falling stone, and events at which it is 1 s after the start.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = g * x,
    event(floor = x, clock = t - 1),
)]
struct Stone {
    g: f64,
}

#[test]
fn a_terminal_floor_at_the_end_of_a_run_ends_it() {
    let stone = Stone { g: 10.0 };
    let start = State::new(0.0, [5.0], [0.0]);
    let fall = |start, end| {
        let floor = Problem::new(&stone, start).on(Stone::FLOOR);
        floor.falling().stop().solve(end, Taylor::new()).unwrap()
    };
    let second = fall(fall(start, 0.5).last, 1.0);
    assert_eq!(second.reason, StopReason::Condition);
    assert!(second.met.contains(0));
    // Five times the spacing of numbers behind it.
    let late = fall(start, 1.0 + 1e-15);
    assert_eq!(late.reason, StopReason::Condition);
    let clock = Problem::new(&stone, start).on(Stone::CLOCK);
    let motion = clock.rising().stop().solve(1.0, Taylor::new()).unwrap();
    assert_eq!(motion.reason, StopReason::Condition);
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn each_impact_is_seen_by_one_of_two_runs() {
    see_each_impact_once(1);
}

#[test]
fn some_impacts_are_seen_by_one_of_two_runs() {
    see_each_impact_once(5);
}

/// Under gravity of one strength of so many. Ends within eight spacings of the time of the impact.
fn see_each_impact_once(stride: usize) {
    for i in (0..24).step_by(stride) {
        let stone = Stone {
            g: 1.0 + 0.17 * f64::from(i),
        };
        let start = State::new(0.0, [5.0], [0.0]);
        for direction in [Direction::Falling, Direction::Either] {
            let fall = |start, end| {
                let floor = Problem::new(&stone, start).on(Stone::FLOOR);
                let floor = directed!(direction, floor).record();
                floor.solve(end, Taylor::new()).unwrap()
            };
            let time: f64 = fall(start, 10.0).events()[0].t;
            for ulps in 0..17 {
                let end = f64::from_bits(time.to_bits() + ulps - 8);
                let first = fall(start, end);
                let second = fall(first.last, 10.0);
                let seen = first.events().len() + second.events().len();
                assert_eq!(seen, 1, "{direction:?}, g = {}, end {end:e}", stone.g);
            }
        }
    }
}

/// A reaction at the end of a run is made: the stone is above the floor afterwards.
#[test]
fn an_impact_at_the_end_of_a_run_has_its_reaction() {
    for i in 0..8 {
        let stone = Stone {
            g: 1.0 + 0.5 * f64::from(i),
        };
        let start = State::new(0.0, [5.0], [0.0]);
        let fall = (10.0 / stone.g).sqrt();
        for ulps in 0..17 {
            let end = f64::from_bits(fall.to_bits() + ulps - 8);
            let bounce = |start: State<f64, 1>, end| {
                let floor = Problem::new(&stone, start).on(Stone::FLOOR).falling();
                let bouncing = floor.then(|x| x.v[0] = -x.v[0]);
                bouncing.solve(end, Taylor::new()).unwrap().last
            };
            let height = bounce(bounce(start, end), 2.0 * fall).q[0];
            assert!((height - 5.0).abs() < 1e-12, "{} {ulps}: {height}", stone.g);
        }
    }
}

/// An oscillator in a plane, with events that are crossed at an angle.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = 0.5 * k * (x.powi(2) + 4.1 * y.powi(2)) + 0.1 * x.powi(2) * y + g * y,
    event(
        line = x - 0.3,
        axis = y,
        circle = sqrt(x.powi(2) + y.powi(2)) - 0.9,
        turning = dot(x),
        clock = sin(3 * t),
        far = x + 100.1 - 100,
    ),
)]
struct Oscillator {
    k: f64,
    g: f64,
}

const COUNT: usize = 6;

type Equations<'a> = EquationsOfMotion<&'a Oscillator, f64, 2>;

fn functions(x: &At<f64, X>) -> [f64; COUNT] {
    let [a, b] = [x.q[0], x.q[1]];
    let circle = a.hypot(b) - 0.9;
    [
        a - 0.3,
        b,
        circle,
        x.v[0],
        (3.0 * x.t).sin(),
        a + 100.1 - 100.0,
    ]
}

fn each_event_once<I, C>(
    problem: impl for<'a> Fn(&'a Oscillator, &At<f64, X>) -> Watching<Equations<'a>, C>,
    method: I,
    tolerance: f64,
    (seed, cases, splits): (u64, usize, usize),
) where
    I: Copy + for<'a> Resume<f64, Equations<'a>>,
    C: for<'a> Watched<f64, Equations<'a>>,
{
    let mut random = Random(seed);
    let first = usize::from(random.below(2));
    for case in 0..cases {
        let model = Oscillator {
            k: 1.0 + random.uniform(),
            g: 0.2 * random.uniform(),
        };
        let (from, end) = [(-2.5, 2.7), (2.5, -2.7)][(case + first) % 2];
        let q = [1.0 + 0.3 * random.uniform(), 0.5 * random.uniform()];
        let v = [random.uniform(), -random.uniform()];
        let start = State::new(from, q, v);
        let problem = |start: &At<f64, X>| problem(&model, start);
        let whole = run(problem(&start), method, end);
        assert!(!whole.is_empty());
        for (n, kind) in ENDS.into_iter().cycle().take(splits).enumerate() {
            let (_, time) = whole[n % whole.len()];
            let ulp = time.abs().next_up() - time.abs();
            let offset = f64::from(random.below(17)) - 8.0;
            let at = time + offset * ulp * [1.0, 1.0, 100.0][n % 3];
            let parts = in_two_runs(problem, method, &start, (at, end), kind);
            for event in 0..COUNT {
                let times = |list: &[(usize, f64)]| {
                    let list = list.iter().filter(|told| told.0 == event);
                    list.map(|told| told.1).collect::<Vec<_>>()
                };
                let [parts, whole] = [&parts, &whole].map(|list| times(list));
                let mut pairs = parts.iter().zip(&whole);
                assert!(
                    parts.len() == whole.len() && pairs.all(|(a, b)| (a - b).abs() <= tolerance),
                    "{kind:?} at {at}, event {event} of {model:?} from {start:?}:\n{parts:?}\n{whole:?}"
                );
            }
        }
    }
}

/// So many motions, each split in so many ways.
fn under<I>(method: I, tolerance: f64, seed: u64, (cases, splits): (usize, usize))
where
    I: Copy + for<'a> Resume<f64, Equations<'a>>,
{
    let declared = [
        Oscillator::LINE,
        Oscillator::AXIS,
        Oscillator::CIRCLE,
        Oscillator::TURNING,
        Oscillator::CLOCK,
        Oscillator::FAR,
    ];
    for direction in EVERY {
        each_event_once(
            |model, start| directed!(direction, Problem::new(model, *start).on(declared)).record(),
            method,
            tolerance,
            (seed, cases, splits),
        );
        each_event_once(
            |model, start| {
                directed!(direction, Problem::new(model, *start).when(functions)).record()
            },
            method,
            tolerance,
            (seed + 1, cases, splits),
        );
    }
}

#[test]
fn taylor_reports_each_event_once() {
    under(Taylor::new(), 1e-12, 11, (1, ENDS.len()));
}

#[test]
fn dormand_prince_reports_each_event_once() {
    under(Dop853::new(), 1e-8, 15, (1, ENDS.len()));
}

#[test]
fn runge_kutta_reports_each_event_once() {
    under(RungeKutta::classical(0.02), 1e-6, 17, (1, ENDS.len()));
}

#[test]
#[ignore = "takes a minute; run with `--include-ignored`"]
fn every_method_reports_each_event_once() {
    let twice = 2 * ENDS.len();
    under(Taylor::new(), 1e-12, 11, (1, twice));
    under(Dop853::new(), 1e-8, 15, (1, twice));
    under(RungeKutta::classical(0.02), 1e-6, 17, (1, twice));
    under(Taylor::new(), 1e-12, 21, (4, twice));
    under(Taylor::new().max_step(0.03), 1e-12, 23, (2, twice));
    under(Dop853::new(), 1e-8, 25, (4, twice));
    under(RungeKutta::classical(0.02), 1e-6, 27, (4, twice));
}
