//! Motions of constrained mechanisms have the same bits alone, in lanes among others, and where they are interrupted.

use core::fmt::Debug;

use lagrangian::prelude::*;
use lagrangian::problem::{End, EnsembleIntegrator, Keep, Observer, Reactions, Watched};
use lagrangian::{Lanes, Partial, Resume};
use serde::{Serialize, de::DeserializeOwned};

use crate::mechanisms::{Disc, FourBar, Hoop, Pendulum, Platform, SliderCrank, number};

type Found<X, K> = Result<Solution<f64, X, K>, Partial<Solution<f64, X, K>>>;

/// What is found of each member among others, in two orders: to the last bit what is found of it in lanes of its own.
#[allow(clippy::needless_pass_by_value)] // As `solve` takes the method.
fn alone_and_together<I, D, K, C, R, O>(
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
    let together = |number: &dyn Fn(usize) -> usize| {
        let problems = (0..count).map(|index| member(number(index)).0);
        Ensemble::new(problems).solve(|index| member(number(index)).1, method.clone())
    };
    let forwards = together(&|index| index);
    let backwards = together(&|index| count - 1 - index);
    assert_eq!(forwards.len(), count);
    for (index, (found, other)) in forwards.iter().zip(backwards.iter().rev()).enumerate() {
        let (problem, end) = member(index);
        let alone = Ensemble::new([problem]).lanes::<2>();
        let alone = text(&alone.solve(end, method.clone())[0]);
        assert_eq!(text(found), alone, "{index}");
        assert_eq!(text(other), alone, "{index}, backwards");
    }
    forwards
}

/// All that is found, but for the evaluations, which a lane may make for its neighbours: as text, in which NaN is NaN, and numbers
/// have all digits.
fn text<X: Clone + Debug, K: Clone + Debug>(found: &Found<X, K>) -> String {
    let (error, solution) = match found {
        Ok(solution) => (None, solution),
        Err(partial) => (Some(partial.error()), partial.solution()),
    };
    let mut solution = solution.clone();
    solution.statistics.evaluations = 0;
    format!("{error:?} {solution:?}")
}

/// Members of one kind in lanes, with samples and events.
macro_rules! in_lanes {
    ($Model:ident: $count:expr, $events:expr, $longest:expr, $method:expr) => {{
        let member = |index: usize| {
            let (model, start) = $Model::numbered(index);
            let problem = Problem::new(model, start).on($events).record();
            (
                problem.save(Every(0.3)),
                $longest * (0.3 + number(index + 9)),
            )
        };
        let found = alone_and_together($count, member, $method);
        let [mut ended, mut failed, mut events] = [0; 3];
        for found in &found {
            match found {
                Ok(solution) => {
                    ended += 1;
                    events += solution.events().len();
                }
                Err(_) => failed += 1,
            }
        }
        [ended, failed, events]
    }};
}

#[test]
fn pendulums_and_beads_have_the_bits_that_they_have_alone() {
    let watched = [Pendulum::SIDE, Pendulum::LEVEL, Pendulum::PULL];
    let found = in_lanes!(Pendulum: 6, watched, 2.0, Taylor::order_16());
    assert!(found[0] == 6 && found[2] > 20, "{found:?}");
    let watched = [Hoop::HEIGHT, Hoop::BEHIND, Hoop::PUSH];
    let found = in_lanes!(Hoop: 6, watched, 2.0, Taylor::order_16());
    assert!(found[0] == 6 && found[2] > 20, "{found:?}");
}

#[test]
fn slider_cranks_and_discs_have_the_bits_that_they_have_alone() {
    let watched = [
        SliderCrank::UPRIGHT,
        SliderCrank::MIDDLE,
        SliderCrank::FORCE,
    ];
    let found = in_lanes!(SliderCrank: 5, watched, 0.6, Taylor::order_16());
    assert!(found[0] == 5 && found[2] > 5, "{found:?}");
    let watched = [Disc::HEIGHT, Disc::AXIS, Disc::LOAD];
    let found = in_lanes!(Disc: 5, watched, 0.8, Taylor::order_16());
    assert!(found[0] == 5 && found[2] > 5, "{found:?}");
}

/// Members of which some have a redundant constraint and others none, and members that end with an error: at a start that is open or
/// not a number, and in a singular configuration.
#[test]
fn redundant_and_singular_members_leave_their_neighbours_alone() {
    let watched = [Platform::SIDE, Platform::LEVEL, Platform::PULL];
    let found = in_lanes!(Platform: 7, watched, 1.5, Taylor::order_16());
    assert!(found[0] == 7 && found[2] > 10, "{found:?}");
    let watched = [FourBar::FLAT, FourBar::ACROSS, FourBar::PUSH];
    let found = in_lanes!(FourBar: 12, watched, 0.8, Taylor::order_16());
    assert!(found[0] >= 7 && found[1] >= 2 && found[2] > 10, "{found:?}");
}

/// The steps of Runge–Kutta methods are given, so that states in lanes have those that each has alone.
fn states_in_lanes<M, const N: usize>(model: &M, starts: [State<f64, N>; 4], end: f64)
where
    M: Lagrangian<N, f64> + Lagrangian<N, Lanes<4>>,
{
    let together = |component: &dyn Fn(&State<f64, N>) -> f64| Lanes(starts.map(|x| component(&x)));
    let [q, v] =
        [0, 1].map(|part| SVector::<_, N>::from_fn(|i, _| together(&|x| [x.q, x.v][part][i])));
    let start = State::new(Lanes([0.0; 4]), q, v);
    let method = || RungeKutta::classical(0.01);
    let together = Problem::new(model, start).solve(end, method());
    let together = together.expect("in lanes").last;
    for (lane, start) in starts.into_iter().enumerate() {
        let alone = Problem::new(model, start).solve(end, method());
        let alone = alone.expect("alone").last;
        let found = [together.q, together.v].map(|part| part.map(|x| x.lane(lane)));
        let expected = [alone.q, alone.v];
        assert_eq!(format!("{found:?}"), format!("{expected:?}"), "{lane}");
    }
}

#[test]
fn states_in_lanes_have_the_bits_that_they_have_alone() {
    let (crank, _) = SliderCrank::numbered(3);
    let starts = [0.1, 1.4, 2.0, 4.5].map(|angle| crank.turned(angle, 6.0 - angle));
    states_in_lanes(&crank, starts, 1.0);
    let (disc, _) = Disc::numbered(3);
    let starts = [0.4, 1.0, 1.5, 2.0].map(|theta| disc.rolling([0.0, theta, 0.0], [1.0, 0.1, 8.0]));
    states_in_lanes(&disc, starts, 0.2);
    // The second one passes the configuration in which all bars are in line, and needs pivoting there.
    let (linkage, _) = FourBar::numbered(2);
    let starts = [1.0, 0.0237, 2.0, 2.9].map(|crank| linkage.closed(crank, -0.5));
    states_in_lanes(&linkage, starts, 0.5);
}

/// A motion that is taken step by step, and one that is stored after some of its steps, as text and as bytes, are the motion at one
/// go. Returns the ends of its steps.
fn interrupted<D, C, I>(
    problem: impl Fn() -> Problem<f64, D, End, C>,
    end: f64,
    method: I,
) -> Vec<At<f64, D::State>>
where
    D: Dynamics<f64, State: PartialEq + Debug>,
    C: Watched<f64, D>,
    I: Copy + Resume<f64, D, Memory: Serialize + DeserializeOwned>,
{
    let mut whole = problem().start(method).unwrap();
    whole.advance(end).unwrap();
    let mut single = problem().start(method).unwrap();
    let mut ends = Vec::new();
    while let Some(step) = single.step(end).unwrap() {
        ends.push(step.last);
    }
    assert!(ends.len() > 3, "{ends:?}");
    assert_eq!(single.state(), whole.state());
    let mut run = problem().max_steps(3).start(method).unwrap();
    let mut stops = 0;
    while run.advance(end).unwrap().reason == StopReason::StepLimit {
        let checkpoint = if stops % 2 == 0 {
            let text = serde_json::to_string(&run.checkpoint()).unwrap();
            serde_json::from_str(&text).unwrap()
        } else {
            let bytes = postcard::to_allocvec(&run.checkpoint()).unwrap();
            postcard::from_bytes(&bytes).unwrap()
        };
        run = problem().max_steps(3).resume(checkpoint, method).unwrap();
        stops += 1;
    }
    assert!(stops > 0);
    assert_eq!(run.state(), whole.state());
    let (found, expected) = (run.statistics(), whole.statistics());
    assert_eq!(
        (found.steps, found.rejected, found.projection),
        (expected.steps, expected.rejected, expected.projection)
    );
    ends
}

/// Parts that end with steps: polynomials are not changed by them. (The lengths of other steps are, by rounding.)
fn in_parts<D, C, I>(problem: Problem<f64, D, End, C>, ends: Vec<At<f64, D::State>>, method: I)
where
    D: Dynamics<f64, State: PartialEq + Debug>,
    C: Watched<f64, D>,
    I: Integrator<f64, D>,
{
    let mut parts = problem.start(method).unwrap();
    for end in ends {
        assert_eq!(parts.advance(end.t).unwrap().last, end);
    }
}

/// By all methods, some of which move the ends of their steps by much more than rounding.
macro_rules! interrupted {
    ($Model:ident: $index:expr, $events:expr, $end:expr) => {
        let (model, start) = $Model::numbered($index);
        let problem = || Problem::new(&model, start).on($events).record();
        let ends = interrupted(problem, $end, Taylor::order_16());
        in_parts(problem(), ends, Taylor::order_16());
        let method = Taylor::order_12().relative_tolerance(1e-6);
        in_parts(problem(), interrupted(problem, $end, method), method);
        let method = Dop853::new()
            .relative_tolerance(1e-7)
            .absolute_tolerance(1e-7);
        interrupted(problem, $end, method);
        interrupted(problem, $end, RungeKutta::classical(0.01 * $end));
    };
}

#[test]
fn interrupted_motions_have_the_same_bits() {
    interrupted!(Pendulum: 1, [Pendulum::SIDE, Pendulum::LEVEL, Pendulum::PULL], 1.5);
    interrupted!(Hoop: 2, [Hoop::HEIGHT, Hoop::BEHIND, Hoop::PUSH], 1.5);
    interrupted!(Platform: 3, [Platform::SIDE, Platform::LEVEL, Platform::PULL], 1.5);
    interrupted!(FourBar: 4, [FourBar::FLAT, FourBar::ACROSS, FourBar::PUSH], 1.5);
}

#[test]
fn interrupted_motions_of_many_constraints_have_the_same_bits() {
    interrupted!(SliderCrank: 1, [SliderCrank::UPRIGHT, SliderCrank::FORCE], 0.5);
    interrupted!(Disc: 2, [Disc::HEIGHT, Disc::AXIS, Disc::LOAD], 0.5);
}
