//! Ensembles in which a motion fails: errors and singularities are those of its lane.

use crate::common::{assert_close, in_lanes};
use lagrangian::prelude::*;
use lagrangian::signals::Constant;
use lagrangian::{InLanes, Lanes, Series, SeriesMemory, TaylorCoefficients, TaylorLanes};
use nalgebra::SVector;

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
        (_, x): (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        _: Option<&mut SeriesMemory>,
    ) {
        *coefficients.initial_mut() = *x;
        let mut next = unit;
        for coefficient in coefficients.higher_mut() {
            *coefficient = SVector::from([next]);
            next = S::zero() / x[0];
        }
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
    let found = in_lanes::<4, _, _>(Taylor::new(), &BlowUp.dynamics(), motions);
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
    let found = in_lanes::<8, _, _>(Taylor::new(), &Polar.dynamics(), motions);
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

/// The same with a force that is an input.
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
    fn check<D: InLanes<4, State = Phase<f64, 2>>>(dynamics: &D) {
        let motions = (0..8).map(|i| {
            let r = if i % 4 == 1 { 0.0 } else { 1.0 };
            (State::new(0.0, [r, 0.0], [0.0, 1.0]), 1.0)
        });
        let found = in_lanes::<4, _, _>(Taylor::new(), dynamics, motions);
        for (i, result) in found.into_iter().enumerate() {
            let singular = matches!(result, Err(IntegrationError::SingularConfiguration { .. }));
            assert_eq!(singular, i % 4 == 1, "{i} {result:?}");
        }
    }
    let pushed = Pushed { push: 0.0 };
    let start = State::new(0.0, [1.0; 2], [0.0; 2]);
    let driven = Problem::new(&pushed, start).driven_by([Constant(0.1)]);
    check(driven.dynamics());
    check(&pushed.with_inputs([0.1]).dynamics());
    check(&Polar.dynamics().with_sizes([1.0, 1.0]));
    check(&Polar.dynamics());
}

/// What is wrong with a lane is its error; the others go on.
#[test]
fn lanes_that_are_set_by_hand_are_checked() {
    let dynamics = Logarithm.dynamics();
    let start = Phase::new([1.0], [0.0]);
    let mut stepper = TaylorLanes::<_, 4, _>::new(Taylor::new(), 0.0, &start);
    stepper.set_lane(1, 0.0, &Phase::new([f64::NAN], [0.0]));
    stepper.set_lane(2, f64::INFINITY, &start);
    stepper.step(&dynamics, &[1.0, 1.0, 1.0, f64::NAN]);
    assert!(stepper.error(0).is_none() && stepper.time(0) > 0.0);
    let errors = [1, 2, 3].map(|lane| stepper.error(lane).unwrap());
    assert!(matches!(errors[0], IntegrationError::NonFiniteState { .. }));
    assert!(matches!(errors[1], IntegrationError::NonFiniteTime { .. }));
    assert!(matches!(errors[2], IntegrationError::NonFiniteTime { .. }));
    let invalid = Taylor::new().relative_tolerance(-1.0);
    let mut stepper = TaylorLanes::<_, 4, _>::new(invalid, 0.0, &start);
    stepper.step(&dynamics, &[1.0; 4]);
    assert!(matches!(
        stepper.error(1),
        Some(IntegrationError::InvalidTolerance { .. })
    ));
}
