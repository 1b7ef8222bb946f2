//! The Taylor series of a model as an optimizing compiler makes it, compared with its series in double-doubles, whose convolutions
//! are in another layout. `.ci/run` runs this in release.
//!
//! The vectorizer of LLVM 22 (`SLPVectorizer`) exchanged two factors of the convolutions of this model, when it had two scales for
//! one point. The terms were wrong, and the residuals of the steps, which showed it, made the motion take a thousand times the
//! instructions. Whether the vectorizer does so depends on what else is in the crate, so that the model is alone in this one.

use std::hint::black_box;

use lagrangian::prelude::*;
use lagrangian::quantities::MotionSeries;
use lagrangian::{DoubleDouble, Series, TaylorCoefficients};

/// Half of the order of the series.
const HALF: usize = 14;

/// Of the magnitude of a term; a factor that is not the right one makes an error as large as the term.
const ALLOWED: f64 = 1e-10;

/// In the time 1, in which the models move by about 1.
const MAX_STEPS: u64 = 30;

type Terms<const N: usize> = Vec<[[f64; N]; 2]>;

fn terms<S: Scalar, const N: usize>(
    dynamics: &impl Series<S, State = Phase<S, N>>,
    state: &State<f64, N>,
) -> Terms<N> {
    let [q, v] = [state.q, state.v].map(|x| x.map(S::from_f64));
    let state = Phase::from(State::new(S::zero(), q, v));
    let mut series = TaylorCoefficients::<_, HALF>::new(state);
    let unit = S::from_f64(black_box(0.5));
    dynamics.series((S::zero(), &state), unit, &mut series, None);
    let numbers = |x: SVector<S, N>| x.map(Scalar::largest).into();
    let terms = series.higher().iter();
    terms
        .map(|term| [numbers(term.q), numbers(term.v)])
        .collect()
}

/// Fails unless the series of a model through (q, v) is the one in double-doubles, and its motion takes a few steps.
fn check<const N: usize, M>(name: &str, model: &M, [q, v]: [[f64; N]; 2])
where
    M: Lagrangian<N, Model: MotionSeries<N>>
        + Lagrangian<N, DoubleDouble, Model: MotionSeries<N, DoubleDouble>>,
{
    let state = State::new(0.0, q, v);
    let dynamics = &Lagrangian::<N, f64>::dynamics(model);
    let exact = &Lagrangian::<N, DoubleDouble>::dynamics(model);
    let found = terms::<f64, N>(dynamics, &state);
    let expected = terms::<DoubleDouble, N>(exact, &state);
    assert_eq!(found.len(), 2 * HALF);
    for (index, (found, expected)) in found.iter().zip(&expected).enumerate() {
        let (found, expected) = (found.as_flattened(), expected.as_flattened());
        let size = expected.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        let mut pairs = found.iter().zip(expected);
        assert!(
            pairs.all(|(found, expected)| (found - expected).abs() <= ALLOWED * size),
            "{name}: order {}: {found:?}, expected {expected:?}",
            index + 1
        );
    }
    let motion = Problem::new(dynamics, state).solve(1.0, Taylor::<HALF>::new());
    let steps = motion.unwrap().statistics.steps;
    assert!(steps <= MAX_STEPS, "{name}: {steps} steps");
}

/// The force is the angle times its slope, both of which have the squares of the distance in their recurrences.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = k * atan2(y, x).powi(2),
)]
struct Angle {
    m: f64,
    k: f64,
}

#[test]
fn series_are_those_in_double_doubles() {
    let plane = [[1.0, 0.3], [0.1, 0.2]];
    check("angle", &Angle { m: 1.3, k: 0.7 }, plane);
}
