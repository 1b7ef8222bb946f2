//! Ends of steps that are corrected by the derivative there.

use crate::common::{Oscillator, assert_close};
use crate::members::number;
use lagrangian::prelude::*;
use lagrangian::{Series, SeriesMemory, StateTransition, TaylorCoefficients};

/// One step of this length.
fn one_step<const HALF: usize>(step: f64) -> Taylor<HALF> {
    Taylor::of_half_order()
        .absolute_tolerance(1e9)
        .max_step(step)
}

/// For linear equations, the end is the value of the polynomial of one degree more.
#[test]
fn linear_motions_have_one_more_term() {
    let start = At {
        t: 0.0,
        x: SVector::from([1.0, 0.0]),
    };
    for step in [1.0, -0.75] {
        let solved = Problem::new(&Oscillator, start).solve(step, one_step::<2>(1.0));
        let found = solved.unwrap();
        assert_eq!(found.statistics.steps, 1);
        // The polynomials of degree 5 of cos t and −sin t.
        let cosine = 1.0 - step.powi(2) / 2.0 + step.powi(4) / 24.0;
        let sine = step - step.powi(3) / 6.0 + step.powi(5) / 120.0;
        assert_close(found[0], cosine, 1e-15);
        assert_close(found[1], -sine, 1e-15);
    }
}

/// ẋ = x², whose motion from 1 is 1/(1 − t), with the coefficients 1.
#[derive(Clone, Copy)]
struct Square;

impl<S: Scalar> Dynamics<S> for Square {
    type State = SVector<S, 1>;

    fn derivative(&self, _: S, x: &Self::State) -> Self::State {
        x.component_mul(x)
    }
}

impl<S: Scalar> Series<S> for Square {
    fn series<const HALF: usize>(
        &self,
        (_, x): (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        _: Option<&mut SeriesMemory>,
    ) {
        *coefficients.initial_mut() = *x;
        let mut last = *x;
        for coefficient in coefficients.higher_mut() {
            last *= x[0] * unit;
            *coefficient = last;
        }
    }
}

/// The error of one step is (xₙ₊₂hⁿ⁺² − h ∂f/∂x · xₙ₊₁hⁿ⁺¹)/(n + 1), here −hⁿ⁺²/(n + 1): the Taylor polynomial of one degree more has
/// n + 1 times this error.
#[test]
fn the_error_is_a_fraction_of_the_next_term() {
    let start = At {
        t: 0.0,
        x: SVector::from([1.0]),
    };
    for step in [1.0 / 64.0, -1.0 / 64.0] {
        let solved = Problem::new(&Square, start).solve(step, one_step::<2>(1.0));
        let found = solved.unwrap();
        assert_eq!(found.statistics.steps, 1);
        let error = found[0] - 1.0 / (1.0 - step);
        assert_close(error / step.powi(6), -1.0 / 5.0, 0.02);
    }
}

/// A swing whose length is pumped.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    taylor,
    coordinates(theta, x),
    kinetic = 0.5 * (l + 0.1 * sin(rate * t)).powi(2) * dot(theta).powi(2) + 0.5 * dot(x).powi(2),
    potential = -g * l * cos(theta) + 0.5 * (x - theta).powi(2),
    event(middle = theta),
)]
struct Swing {
    l: f64,
    g: f64,
    rate: f64,
}

impl Swing {
    fn numbered(index: usize) -> (Self, State<f64, 2>, f64) {
        let swing = Self {
            l: 1.0 + 0.2 * number(index),
            g: 9.81,
            rate: 1.0 + number(index + 1),
        };
        let q = [0.5 + number(index + 3), number(index + 4)];
        let start = State::new(0.0, q, [0.0, number(index + 5)]);
        let sign = if index % 4 == 1 { -1.0 } else { 1.0 };
        (swing, start, sign * (0.02 + 3.0 * number(index + 6)))
    }
}

/// Each motion alone, and in lanes that take steps of their own: to rounding, which is far below the corrections.
#[test]
fn motions_in_lanes_are_corrected_as_they_are_alone() {
    fn check<const HALF: usize>(method: Taylor<HALF>) {
        let member = |index: usize| {
            let (swing, start, end) = Swing::numbered(index);
            let problem = Problem::new(swing, start).on(Swing::MIDDLE).record();
            (problem.save(Every(0.21)), end)
        };
        let count = 23;
        let problems = (0..count).map(|index| member(index).0);
        let together = Ensemble::new(problems).solve(|index| member(index).1, method);
        for (index, together) in together.into_iter().enumerate() {
            let (problem, end) = member(index);
            let (found, alone) = (together.unwrap(), problem.solve(end, method).unwrap());
            assert_eq!(found.statistics.steps, alone.statistics.steps);
            assert_eq!(found.events().len(), alone.events().len());
            let events = found.events().iter().zip(alone.events());
            for (found, alone) in events {
                assert_close(found.t, alone.t, 1e-12);
            }
            assert_eq!(found.samples().len(), alone.samples().len());
            let samples = found.samples().iter().zip(alone.samples());
            for (found, alone) in samples.chain([(&found.last, &alone.last)]) {
                assert!((found.q - alone.q).norm() < 1e-12, "{index}, {}", found.t);
                assert!((found.v - alone.v).norm() < 1e-12, "{index}, {}", found.t);
            }
        }
    }
    check(Taylor::order_12().absolute_tolerance(1e-7));
    check(Taylor::order_16().absolute_tolerance(1e-9));
}

/// A step as short as a rounding error of the time has a polynomial, too.
#[test]
fn the_shortest_steps_have_polynomials() {
    let (swing, mut start, _) = Swing::numbered(2);
    for time in [0.0, 0.3] {
        start.t = time;
        for length in [f64::MIN_POSITIVE, 1e-310, 1e-200, 1e-16, 1e-9] {
            let end = (time + length).max(time.next_up());
            let method = Taylor::order_12().relative_tolerance(1e-8);
            let problem = Problem::new(&swing, start).on(Swing::MIDDLE).record();
            let found = problem.save(Dense).solve(end, method).unwrap();
            for t in [time, end] {
                let [before, at] = [found.before(t), found.at(t)].map(Result::unwrap);
                assert!((before.q - start.q).norm() < 1e-7, "{time} {length}");
                assert!((at.q - start.q).norm() < 1e-7, "{time} {length}");
            }
        }
    }
}

/// Derivatives of motions are corrected, too.
#[test]
fn transition_matrices_are_corrected() {
    let (swing, start, _) = Swing::numbered(5);
    let transition = |method: Taylor<6>| {
        let found = StateTransition::<2, 4>::over(&method, &swing.dynamics(), &start, 3.0);
        found.unwrap().matrix::<4>()
    };
    let expected = transition(Taylor::order_12().relative_tolerance(1e-13));
    let error = |tolerance| {
        (transition(Taylor::order_12().relative_tolerance(tolerance)) - expected).norm()
    };
    assert!(error(1e-6) < 1e-7 && error(1e-9) < 1e-11);
}

/// An oscillator for x > 0.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = -abs(x)))]
struct Branches;

/// A correction could move an end across a discontinuity surface: the end is the value of the polynomial of degree 4.
#[test]
fn equations_with_branches_are_not_corrected() {
    let start = State::new(0.0, [1.0], [0.0]);
    let member = || Problem::new(&Branches, start);
    let method = one_step::<2>(1.0);
    let together = Ensemble::new([member()]).solve(1.0, method);
    for found in together.into_iter().chain([member().solve(1.0, method)]) {
        let found = found.unwrap();
        assert_eq!(found.statistics.steps, 1);
        assert_close(found.q[0], 1.0 - 1.0 / 2.0 + 1.0 / 24.0, 1e-15);
        assert_close(found.v[0], -1.0 + 1.0 / 6.0, 1e-15);
    }
}

/// The polynomial of a step ends where the next one begins.
#[test]
fn solutions_are_continuous() {
    let swing = Swing {
        l: 1.0,
        g: 9.81,
        rate: 3.0,
    };
    let start = State::new(0.0, [1.0, 0.0], [0.0, 1.0]);
    let method = Taylor::order_12().relative_tolerance(1e-6);
    let solved = Problem::new(&swing, start).save(Dense).solve(5.0, method);
    let found = solved.unwrap();
    let ends: Vec<f64> = found.times().collect();
    assert!(ends.len() > 10);
    for t in ends {
        let [before, after] = [found.before(t), found.at(t)].map(Result::unwrap);
        assert!((before.q - after.q).norm() < 1e-14, "{t}");
        assert!((before.v - after.v).norm() < 1e-13, "{t}");
    }
}
