//! Ensembles: lanes with steps of their own, against single motions and closed forms.

mod common;

use common::assert_close;
use lagrangian::prelude::*;
use lagrangian::{Lanes, Series, TaylorCoefficients, TaylorLanes};
use nalgebra::SVector;

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta),
    kinetic = 0.5 * (l * dot(theta)).powi(2),
    potential = -g * l * cos(theta),
)]
struct Pendulum<T: Scalar> {
    l: T,
    g: f64,
}

/// Without parameters, so that it is one model on all scalars.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(alpha, beta),
    define(
        p = [sin(alpha), -cos(alpha)],
        r = p + [sin(beta), -cos(beta)],
    ),
    kinetic = 0.5 * (dot(p).norm_squared() + dot(r).norm_squared()),
    potential = 9.81 * (p.y + r.y),
)]
struct DoublePendulum;

#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = -rate.powi(2) * x + push * sin(2.0 * t)))]
struct Driven<T: Scalar> {
    rate: T,
    push: T,
}

/// From x = ẋ = x₀ the motion is x₀/(1 − x₀ t).
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = 2.0 * x.powi(3)))]
struct BlowUp;

/// A mass in polar coordinates, which are singular at r = 0.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(r, phi),
    kinetic = 0.5 * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    potential = 0.5 * r.powi(2),
)]
struct Polar;

/// A force with a corner at x = 0.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), potential = abs(x))]
struct Valley;

#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = -ln(x)))]
struct Logarithm;

/// ẋ = 1 with a series that is not finite at x = 0.
struct Broken;

impl<S: Scalar> Dynamics<S> for Broken {
    type State = SVector<S, 1>;

    fn derivative(&self, _: S, _: &Self::State) -> Self::State {
        SVector::from([S::one()])
    }
}

impl<S: Scalar> Series<S> for Broken {
    fn series<const HALF: usize>(
        &self,
        _: S,
        x: &Self::State,
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
    ) {
        *coefficients.initial_mut() = *x;
        let mut next = unit;
        for coefficient in coefficients.higher_mut() {
            *coefficient = SVector::from([next]);
            next = S::zero() / x[0];
        }
    }
}

/// Thirty motions of different lengths, forwards and backwards, from different times.
fn motions() -> Vec<(State<f64, 2>, f64)> {
    let numbers = (0..30).map(|i| 0.37 * f64::from(i));
    let motion = |s: f64| {
        let start = State::new(s, [2.0 * s.sin(), 1.5 * (3.0 * s).cos()], [s.cos(), 0.2]);
        (start, s + 4.0 * (1.7 * s).sin())
    };
    numbers.map(motion).collect()
}

#[test]
fn a_motion_has_the_bits_that_it_has_alone() {
    let method = Taylor::new();
    let together = method
        .ensemble::<8>()
        .collect(&DoublePendulum.dynamics(), motions());
    assert_eq!(together.len(), 30);
    for (found, (start, end)) in together.iter().zip(motions()) {
        let found = found.as_ref().unwrap();
        let alone = method
            .ensemble::<2>()
            .collect(&DoublePendulum.dynamics(), [(start, end)]);
        assert_eq!(found, alone[0].as_ref().unwrap());
        assert_eq!(found.reason, StopReason::Completed);
        assert_eq!(found.last.t.to_bits(), end.to_bits());
    }
}

#[test]
fn the_order_of_the_motions_does_not_matter() {
    let ensemble = Taylor::order_16().ensemble::<4>();
    let forwards = ensemble.collect(&DoublePendulum.dynamics(), motions());
    let reversed = motions().into_iter().rev();
    let mut backwards = ensemble.collect(&DoublePendulum.dynamics(), reversed);
    backwards.reverse();
    assert_eq!(forwards, backwards);
}

#[test]
fn lanes_take_the_steps_of_single_motions() {
    let method = Taylor::new();
    let together = method
        .ensemble::<8>()
        .collect(&DoublePendulum.dynamics(), motions());
    for (found, (start, end)) in together.iter().zip(motions()) {
        let found = found.as_ref().unwrap();
        let dynamics = DoublePendulum.dynamics();
        let alone = method.driver().run_until(&dynamics, start, end).unwrap();
        for i in 0..2 {
            assert_close(found.last.x.q[i], alone.last.x.q[i], 1e-11);
            assert_close(found.last.x.v[i], alone.last.x.v[i], 1e-11);
        }
        let steps = [found.statistics.steps, alone.statistics.steps];
        assert!(steps[0].abs_diff(steps[1]) <= 1, "{steps:?}");
    }
}

/// x = a cos ωt + b sin ωt + sin 2t/(ω² − 4) from x = 1, ẋ = 0: the lanes have different times, too.
#[test]
fn parameters_initial_times_and_ends_are_those_of_the_motion() {
    let mut driven = Driven {
        rate: Lanes([1.0; 4]),
        push: Lanes([0.0; 4]),
    };
    let numbers = (0..50).map(|i| 0.1 * f64::from(i));
    let mut ends = vec![None; 50];
    Taylor::new().ensemble::<4>().run_with_parameters(
        &mut driven,
        numbers,
        |driven, lane, s| {
            driven.rate.set(lane, 2.5 + s);
            driven.push.set(lane, 1.0 + s);
            (State::new(-s, [1.0], [0.0]), 10.0 - s)
        },
        |index, result| ends[index] = Some(result.unwrap().last),
    );
    for (i, end) in (0..50).zip(ends) {
        let (s, end) = (0.1 * f64::from(i), end.unwrap());
        let (rate, push) = (2.5 + s, 1.0 + s);
        let share = push / (rate * rate - 4.0);
        let forced = |t: f64| [share * (2.0 * t).sin(), 2.0 * share * (2.0 * t).cos()];
        let from = forced(-s);
        let free = [1.0 - from[0], -from[1] / rate];
        let (sine, cosine) = (rate * 10.0).sin_cos();
        let expected = free[0] * cosine + free[1] * sine + forced(10.0 - s)[0];
        assert!((end.x.q[0] - expected).abs() < 2e-13 * (1.0 + share), "{i}");
    }
}

#[test]
fn a_lane_that_fails_does_not_stop_the_others() {
    // Every third one has its pole before the end.
    let number = |i: u32| {
        if i.is_multiple_of(3) {
            2.0
        } else {
            0.5 / f64::from(i)
        }
    };
    let motions = (0..30).map(|i| (State::new(0.0, [number(i)], [number(i).powi(2)]), 1.0));
    let found = Taylor::new()
        .ensemble::<4>()
        .collect(&BlowUp.dynamics(), motions);
    for (i, result) in (0..30).zip(found) {
        if i % 3 == 0 {
            let IntegrationError::StepTooSmall { time, .. } = result.unwrap_err() else {
                panic!("a pole");
            };
            assert_close(time, 0.5, 1e-6);
        } else {
            assert_close(
                result.unwrap().last.x.q[0],
                number(i) / (1.0 - number(i)),
                1e-13,
            );
        }
    }
}

#[test]
fn singularities_are_those_of_a_lane() {
    // With an angular momentum, and without one through the origin.
    let motions = (0..12).map(|i| {
        let turning = if i % 2 == 0 { 1.0 } else { 0.0 };
        let x = if i == 5 { f64::NAN } else { 1.0 };
        let r = if i == 7 { 0.0 } else { x };
        (State::new(0.0, [r, 0.0], [0.0, turning]), 5.0)
    });
    let found = Taylor::new()
        .ensemble::<8>()
        .collect(&Polar.dynamics(), motions);
    for (i, result) in found.into_iter().enumerate() {
        match (i, result) {
            (5, Err(IntegrationError::NonFiniteState { component, .. })) => {
                assert_eq!(component.to_string(), "the coordinate r");
            }
            (7, Err(IntegrationError::SingularConfiguration { time, .. })) => {
                assert_close(time, 0.0, 0.0);
            }
            (_, Ok(outcome)) => {
                // The circle, and the line through the origin, past which the steps may leap.
                let expected = if i % 2 == 0 { 1.0 } else { 5.0_f64.cos() };
                assert!((outcome.last.x.q[0].abs() - expected.abs()).abs() < 1e-9);
            }
            (_, Err(error)) => {
                assert!(
                    i % 2 == 1 && error.to_string().contains("r = "),
                    "{i} {error}"
                );
            }
        }
    }
}

#[test]
fn corners_shorten_the_steps_of_their_lane_alone() {
    let motions = [1.0, 2.0, 3.0, 4.0].map(|x: f64| {
        let quarter = (2.0 * x).sqrt();
        (State::new(0.0, [x], [0.0]), 2.0 * quarter)
    });
    let found = Taylor::new()
        .ensemble::<4>()
        .collect(&Valley.dynamics(), motions);
    for (x, result) in [1.0, 2.0, 3.0, 4.0].into_iter().zip(found) {
        let outcome = result.unwrap();
        assert!((outcome.last.x.q[0] + x).abs() < 1e-9);
        assert!(outcome.statistics.rejected > 0);
        let start = State::new(0.0, [x], [0.0]);
        let end = 2.0 * (2.0 * x).sqrt();
        let alone = Taylor::new()
            .ensemble::<1>()
            .collect(&Valley.dynamics(), [(start, end)]);
        assert_eq!(&outcome, alone[0].as_ref().unwrap());
    }
}

#[test]
fn limits_and_settings_are_errors_of_each_motion() {
    let motions = || motions().into_iter().take(5);
    let dynamics = DoublePendulum.dynamics();
    let ensemble = Taylor::new().ensemble::<2>();
    for (result, (start, end)) in ensemble
        .max_steps(2)
        .collect(&dynamics, motions())
        .into_iter()
        .zip(motions())
    {
        let outcome = result.unwrap();
        let last = outcome.last.t;
        assert!(outcome.statistics.steps + outcome.statistics.rejected <= 2);
        match outcome.reason {
            StopReason::Completed => assert_eq!(last.to_bits(), end.to_bits()),
            reason => {
                assert_eq!(reason, StopReason::StepLimit);
                assert!((last - start.t).abs() < (end - start.t).abs());
            }
        }
    }
    for tolerance in [0.0, f64::NAN, -1.0] {
        let results = ensemble
            .singularity_tolerance(tolerance)
            .collect(&dynamics, motions());
        assert!(results.iter().all(|result| matches!(
            result,
            Err(IntegrationError::InvalidSingularityTolerance { .. })
        )));
        let invalid = Taylor::new().relative_tolerance(tolerance).ensemble::<2>();
        let results = invalid.collect(&dynamics, motions());
        assert_eq!(results.len(), 5);
        assert!(
            results
                .iter()
                .all(|result| matches!(result, Err(IntegrationError::InvalidTolerance { .. })))
        );
    }
    for end in [f64::NAN, f64::INFINITY] {
        let results = ensemble.collect(&dynamics, motions().map(|(start, _)| (start, end)));
        assert!(
            results
                .iter()
                .all(|result| matches!(result, Err(IntegrationError::NonFiniteTime { .. })))
        );
    }
    let nothing = ensemble.collect(&dynamics, core::iter::empty::<(State<f64, 2>, f64)>());
    assert!(nothing.is_empty());
    let still = ensemble.collect(&dynamics, motions().map(|(start, _)| (start, start.t)));
    for (result, (start, _)) in still.into_iter().zip(motions()) {
        assert_eq!(result.unwrap().last.state(), start);
    }
}

#[test]
fn dense_output_of_each_lane_is_within_its_step() {
    let lengths = [0.5, 1.0, 2.0, 4.0];
    let pendulums = Pendulum {
        l: Lanes(lengths),
        g: 1.0,
    };
    let dynamics = pendulums.dynamics();
    let small = 1e-6;
    let start = Phase::new([small], [0.0]);
    let mut stepper = TaylorLanes::new(Taylor::new(), 0.0, &start);
    for _ in 0..5 {
        stepper.step(&dynamics, &[100.0; 4]);
        let middle = core::array::from_fn(|lane| {
            0.3 * stepper.previous_time(lane) + 0.7 * stepper.time(lane)
        });
        let states = stepper.interpolate(&middle);
        for lane in 0..4 {
            // A swing so small has the period of the linear equation, up to its square.
            let expected = small * (middle[lane] / lengths[lane].sqrt()).cos();
            assert!((states.q[0].lane(lane) - expected).abs() < 1e-16);
        }
    }
    let times: [f64; 4] = core::array::from_fn(|lane| stepper.time(lane));
    assert!(times[3] > 1.5 * times[0], "{times:?}");
}

/// ẍ = −ln x has no series at x ≤ 0, which a lane reaches.
#[test]
fn a_lane_with_an_error_stays_where_it_is() {
    let dynamics = Logarithm.dynamics();
    let mut stepper = TaylorLanes::<_, 2, _>::new(Taylor::new(), 0.0, &Phase::new([1.0], [0.0]));
    stepper.set_lane(1, 0.0, &Phase::new([1.0], [-3.0]));
    let mut steps = 0;
    while stepper.time(0) < 50.0 || stepper.error(1).is_none() {
        stepper.step(&dynamics, &[50.0; 2]);
        steps += 1;
        assert!(steps < 10_000);
    }
    let error = stepper.error(1).unwrap();
    assert!(stepper.error(0).is_none());
    let (time, x) = (stepper.time(1), stepper.state(1).q[0]);
    assert!(
        0.2 < time && time < 1.0 && x.abs() < 0.1,
        "{error} {time} {x}"
    );

    let [one, zero] = [1.0, 0.0].map(|x| SVector::from([x]));
    let mut stepper = TaylorLanes::<SVector<Lanes<2>, 1>, 2, _>::new(Taylor::new(), 0.0, &one);
    stepper.set_lane(1, 0.0, &zero);
    stepper.step(&Broken, &[1.0; 2]);
    assert!(matches!(
        stepper.error(1),
        Some(IntegrationError::NoTaylorSeries { .. })
    ));
    assert_eq!((stepper.time(1), stepper.state(1)), (0.0, zero));
    assert!(stepper.error(0).is_none());
    assert_close(stepper.time(0), 1.0, 0.0);
    assert_close(stepper.state(0)[0], 2.0, 1e-15);
}

/// The same in polar coordinates with a force that is an input.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(r, phi),
    kinetic = 0.5 * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    potential = 0.5 * r.powi(2),
    force(r = push),
)]
struct Pushed {
    #[lagrangian(input)]
    push: f64,
}

/// Under inputs, and with typical sizes, a singular lane is that lane alone, too.
#[test]
fn singularities_are_those_of_a_lane_in_all_systems() {
    use lagrangian::Constant;

    fn check<D: Series<Lanes<4>, State = Phase<Lanes<4>, 2>>>(dynamics: &D) {
        let motions = (0..8).map(|i| {
            let r = if i % 4 == 1 { 0.0 } else { 1.0 };
            (State::new(0.0, [r, 0.0], [0.0, 1.0]), 1.0)
        });
        let found = Taylor::new().ensemble::<4>().collect(dynamics, motions);
        for (i, result) in found.into_iter().enumerate() {
            let singular = matches!(result, Err(IntegrationError::SingularConfiguration { .. }));
            assert_eq!(singular, i % 4 == 1, "{i} {result:?}");
        }
    }
    let pushed = Pushed { push: 0.0 };
    check(&pushed.driven_by([Constant(0.1)]));
    check(&pushed.with_inputs([Lanes([0.1; 4])]).dynamics());
    let dynamics = Polar.dynamics();
    check(&dynamics.with_sizes([1.0, 1.0]));
    check(&dynamics);
}

/// Dynamics by hand, whose state is a vector.
#[test]
fn systems_that_are_no_models_have_ensembles() {
    use common::Oscillator;

    let starts = (0..9).map(|i| ((0.0, SVector::from([f64::from(i), 0.0])), 2.0));
    let found = Taylor::new().ensemble::<4>().collect(&Oscillator, starts);
    for (i, result) in (0..9).zip(found) {
        assert_close(
            result.unwrap().last.x[0],
            f64::from(i) * 2.0_f64.cos(),
            1e-14,
        );
    }
}
