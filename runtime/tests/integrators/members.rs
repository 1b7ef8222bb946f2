//! Members of an ensemble, with all that a problem asks for, against each of them alone.

use core::fmt::Debug;
use core::ops::ControlFlow;

use crate::constrained::ROD;
use lagrangian::prelude::*;
use lagrangian::problem::{EnsembleIntegrator, Keep, Observer, Reactions, Watched};
use lagrangian::{Partial, SetTypicalSizes};
use nalgebra::SVector;

pub(crate) type Found<X, K> = Result<Solution<f64, X, K>, Partial<Solution<f64, X, K>>>;

/// What is found of each member, in lanes: to the last bit what is found of it in lanes of its own, and, but for the order of sums in
/// Taylor series, what is found of the problem.
#[allow(clippy::needless_pass_by_value)] // As `solve` takes the method.
pub(crate) fn alone_and_together<I, D, K, C, R, O>(
    count: usize,
    member: impl Fn(usize) -> (Problem<f64, D, K, C, R, O>, f64),
    method: I,
) -> Vec<Found<D::State, K::Kept>>
where
    D: Dynamics<f64, State: Debug>,
    C: Watched<f64, D>,
    R: Reactions<f64, D>,
    O: Observer<D::State>,
    I: EnsembleIntegrator<f64, D, 4> + EnsembleIntegrator<f64, D, 2>,
    K: Keep<f64, D, I::Stepper, Kept: Clone + Debug>,
{
    let problems = (0..count).map(|index| member(index).0);
    let together = Ensemble::new(problems).solve(|index| member(index).1, method.clone());
    assert_eq!(together.len(), count);
    for (index, found) in together.iter().enumerate() {
        let (problem, end) = member(index);
        let alone = Ensemble::new([problem]).lanes::<2>();
        let alone = alone.solve(end, method.clone());
        // As text, in which NaN is NaN, and numbers have all digits.
        assert_eq!(text(found), text(&alone[0]), "{index}");
        let (problem, end) = member(index);
        close(index, found, &problem.solve(end, method.clone()));
    }
    together
}

/// All that is found, but for the evaluations, which a lane may make for its neighbours.
fn text<X: Clone + Debug, K: Clone + Debug>(found: &Found<X, K>) -> String {
    let (error, solution) = match found {
        Ok(solution) => (None, solution),
        Err(partial) => (Some(partial.error()), partial.solution()),
    };
    let mut solution = solution.clone();
    solution.statistics.evaluations = 0;
    format!("{error:?} {solution:?}")
}

/// Events and ends are equal up to rounding.
#[track_caller]
fn close<X: VectorSpace<f64>, K>(index: usize, found: &Found<X, K>, expected: &Found<X, K>) {
    assert_eq!(found.is_ok(), expected.is_ok(), "{index}");
    let [found, expected] = [found, expected].map(|found| match found {
        Ok(solution) => solution,
        Err(partial) => partial.solution(),
    });
    assert_eq!(found.reason, expected.reason, "{index}");
    assert_eq!(found.met, expected.met, "{index}");
    assert_eq!(found.events().len(), expected.events().len(), "{index}");
    let near = |x: f64, y: f64| (x - y).abs() <= 1e-9 * (1.0 + y.abs()) || x.is_nan() && y.is_nan();
    for (found, expected) in found.events().iter().zip(expected.events()) {
        assert_eq!(found.event, expected.event, "{index}");
        assert!(near(found.t, expected.t), "{index}");
    }
    assert!(near(found.last.t, expected.last.t), "{index}");
    for (x, y) in found.last.x.components().zip(expected.last.x.components()) {
        assert!(near(x, y), "{index}: {x} {y}");
    }
}

/// From 0 on, in no order.
pub(crate) fn number(index: usize) -> f64 {
    f64::from(u32::try_from(index * 7919 % 101).unwrap()) / 101.0
}

#[derive(Lagrangian, Clone)]
#[lagrangian(
    taylor,
    coordinates(x, height),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(height).powi(2)),
    potential = m * g * height,
    force(x = -drag * dot(x)),
    event(floor = height, apex = dot(height)),
)]
struct Ball {
    m: f64,
    g: f64,
    drag: f64,
}

fn ball(index: usize) -> Ball {
    Ball {
        m: 1.0 + number(index),
        g: 9.0 + number(index + 1),
        drag: 0.1 * number(index + 2),
    }
}

fn thrown(index: usize) -> State<f64, 2> {
    State::new(
        number(index + 3),
        [0.0, number(index + 4)],
        [1.0, 5.0 * number(index + 5)],
    )
}

/// Bounces that keep a part of the speed: the motion ends, or the ball comes to rest in ever shorter ones.
#[test]
fn members_bounce_as_they_do_alone() {
    let member = |index: usize| {
        let restitution = 0.3 + 0.6 * number(index + 6);
        let start = thrown(index);
        let problem = Problem::new(ball(index), start)
            .on(Ball::FLOOR)
            .falling()
            .then(move |ball| ball.v[1] *= -restitution)
            .on(Ball::APEX)
            .record()
            .when(|ball| ball.q[0] - 0.5)
            .record()
            .save(Every(0.07));
        (problem, start.t + 3.0 * number(index + 7))
    };
    let found = alone_and_together(14, member, Taylor::new());
    let reasons = |reason| {
        found
            .iter()
            .flatten()
            .filter(|found| found.reason == reason)
            .count()
    };
    assert!(reasons(StopReason::Zeno) > 3 && reasons(StopReason::Completed) > 3);
    let events = found.iter().flatten().map(|found| found.events().len());
    assert!(events.sum::<usize>() > 60);
    alone_and_together(5, member, Dop853::new());
    alone_and_together(3, member, RungeKutta::classical(0.01));
}

/// Each reason to end, and each thing that is kept.
#[test]
fn members_stop_as_they_do_alone() {
    let member = |index: usize| {
        let start = thrown(index);
        let far = 0.1 + 0.3 * number(index + 6);
        let fast = 5.0 * number(index + 8) - 2.0;
        let problem = Problem::new(ball(index), start)
            .on(Ball::FLOOR)
            .falling()
            .stop()
            .stop_when(move |ball| ball.q[0] > far)
            .each_step(move |progress| {
                if progress.x.v[1] < fast {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            });
        (problem, start.t + 2.0)
    };
    let steps = |index| {
        let (problem, end) = member(index);
        (problem.save(StepEnds).max_steps(2 + index as u64 % 5), end)
    };
    let method = Taylor::order_12().max_step(0.05);
    let found = alone_and_together(40, steps, method);
    for reason in [
        StopReason::Condition,
        StopReason::Observer,
        StopReason::StepLimit,
    ] {
        let count = found
            .iter()
            .flatten()
            .filter(|found| found.reason == reason)
            .count();
        assert!(count > 2, "{reason:?}: {count}");
    }
    let whole = |index| {
        let (problem, end) = member(index);
        (
            problem.save([thrown(index).t, end.min(thrown(index).t + 0.1)]),
            end,
        )
    };
    alone_and_together(40, whole, Taylor::new());
}

/// The whole motion, backwards in time, at any time.
#[test]
fn members_are_kept_whole() {
    let member = |index: usize| Problem::new(ball(index), thrown(index)).save(Dense);
    let method = Taylor::order_16().max_step(0.3);
    let found = Ensemble::new((0..7).map(member)).solve(|index| thrown(index).t - 1.0, method);
    for (index, found) in found.into_iter().enumerate() {
        let end = thrown(index).t - 1.0;
        let alone = Ensemble::new([member(index)])
            .lanes::<2>()
            .solve(end, method);
        let (found, alone) = (found.unwrap(), alone.into_iter().next().unwrap().unwrap());
        assert!(found.times().eq(alone.times()));
        for part in 0..=20 {
            let t = thrown(index).t - 0.05 * f64::from(part);
            assert_eq!(found.at(t).unwrap(), alone.at(t).unwrap());
        }
    }
}

/// A reaction changes the parameters of its member alone.
#[test]
fn members_change_their_parameters_as_they_do_alone() {
    let member = |index: usize| {
        let start = thrown(index);
        let lighter = number(index + 6);
        let problem = Problem::new(ball(index), start)
            .on(Ball::APEX)
            .falling()
            .then_with(move |_, ball| {
                ball.change(|ball| (ball.m, ball.drag) = (0.1 + lighter, 1.0 + lighter));
            });
        (problem.save(Every(0.1)), start.t + 2.0)
    };
    let found = alone_and_together(21, member, Taylor::new());
    let fast = |found: &&Solution<f64, Phase<f64, 2>, _>| found.v[0] < 0.5;
    assert!(found.iter().flatten().filter(fast).count() > 10);
}

/// A struct with a type parameter for its scalar.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    taylor,
    coordinates(y[2]),
    kinetic = (0..2).map(|i| 0.5 * m[i] * dot(y[i]).powi(2)).sum(),
    potential = 0.5 * k * (y[1] - y[0]).powi(2) + pull.x * y[0] + pull.y * y[1],
    event(touch = y[1] - y[0]),
)]
struct Pair<T: Scalar> {
    m: [T; 2],
    k: T,
    pull: Vector2<T>,
}

#[test]
fn members_of_a_generic_struct_are_as_they_are_alone() {
    let member = |index: usize| {
        let pair = Pair {
            m: [1.0 + number(index), 1.0 + number(index + 1)],
            k: 4.0 * number(index + 2),
            pull: Vector2::new(number(index + 3), -number(index + 4)),
        };
        let start = State::new(0.0, [0.0, number(index + 5)], [number(index + 6), 0.0]);
        (
            Problem::new(pair, start).on(Pair::<f64>::TOUCH).record(),
            5.0 * number(index + 7),
        )
    };
    alone_and_together(19, member, Taylor::new());
}

/// Steps without events that end at a sample, at the limit of steps, or at the end of a motion, which may be next to an event.
#[test]
fn members_end_without_events_as_they_do_alone() {
    let member = |index: usize| {
        let pair = Pair {
            m: [1.0 + number(index), 1.0 + number(index + 1)],
            k: 10.0 + 4.0 * number(index + 2),
            pull: Vector2::new(number(index + 3), -number(index + 4)),
        };
        let start = State::new(0.0, [0.0, 1.0 + number(index + 5)], [0.0; 2]);
        Problem::new(pair, start).on(Pair::<f64>::TOUCH).record()
    };
    let limited = |index: usize| {
        let problem = member(index).save(Every(0.1 + number(index + 6)));
        (problem.max_steps(1 + 3 * (index as u64 % 7)), 4.0)
    };
    let method = Taylor::order_12();
    let found = alone_and_together(40, limited, method);
    let is_limited =
        |found: &&Solution<f64, Phase<f64, 2>, _>| found.reason == StopReason::StepLimit;
    assert!(found.iter().flatten().filter(is_limited).count() > 30);

    let first_event = |index| member(index).solve(4.0, method).unwrap().events()[0].t;
    let first_events: Vec<f64> = (0..12).map(first_event).collect();
    let next_to = |index: usize| {
        let (index, which) = (index / 3, index % 3);
        (
            member(index),
            first_events[index] + [-1e-12, 0.0, 1e-12][which],
        )
    };
    let found = alone_and_together(36, next_to, method);
    for (index, found) in found.into_iter().enumerate() {
        let events = found.unwrap().events().len();
        let expected = [0..=0, 0..=1, 1..=1];
        assert!(expected[index % 3].contains(&events), "{index}: {events}");
    }
}

/// A spring whose series has sums of many terms, which differ by rounding on one number.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.25 * g * x.powi(4),
    event(middle = x),
)]
struct Duffing {
    g: f64,
}

#[test]
fn members_with_long_sums_are_as_they_are_alone() {
    let member = |index: usize| {
        let start = State::new(0.0, [0.3 + 0.1 * number(index)], [number(index + 1)]);
        let duffing = Duffing {
            g: 1.7 + 40.0 * number(index + 2),
        };
        let problem = Problem::new(duffing, start).on(Duffing::MIDDLE).record();
        (problem, 1.0 + 12.0 * number(index + 3))
    };
    alone_and_together(40, member, Taylor::new());
}

/// From x = ẋ = x₀ the motion is x₀/(1 − x₀ t), with an inertia that vanishes for some members.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + (x - edge).powi(2) * dot(y).powi(2)),
    force(x = 2.0 * x.powi(3)),
)]
struct Hostile {
    edge: f64,
}

/// Errors come with what was found before them, in place of a motion, and in the middle of one.
#[test]
fn members_fail_as_they_do_alone() {
    let member = |index: usize| {
        let [x, edge] = [
            (0.5, -1.0),
            (0.3, 0.9),
            (1.0, -1.0),
            (f64::NAN, 0.0),
            (0.5, 0.5),
        ][index % 5]
            .into();
        let start = State::new(0.0, [x, 0.0], [x * x, 0.0]);
        let end = [1.0, 2.5, 1.5, 1.0, 1.0][index % 5];
        (Problem::new(Hostile { edge }, start).save(Every(0.25)), end)
    };
    let found = alone_and_together(20, member, Taylor::new());
    let errors = found.iter().filter_map(|found| found.as_ref().err());
    let partial = errors
        .clone()
        .filter(|error| !error.solution().samples().is_empty());
    assert!(errors.count() >= 12 && partial.count() >= 4);
}

/// Projected steps, events and sizes of each lane.
#[test]
fn projected_members_are_as_they_are_alone() {
    let member = |index: usize| {
        let size = 0.5 + number(index);
        let sizes = SVector::from([size, 2.0, size, 1.0]);
        let start = ROD.released(0.5 + number(index + 1));
        let problem = Problem::new(ROD.with_sizes(sizes), start)
            .when(|x| x[0])
            .rising()
            .record()
            .save(Every(0.2));
        (problem, 2.0 + 3.0 * number(index + 2))
    };
    let method = Taylor::order_16().absolute_tolerance(1e-10);
    let found = alone_and_together(9, member, method);
    assert!(
        found
            .iter()
            .flatten()
            .all(|found| found.statistics.projection > 0.0)
    );
}
