//! Models on numbers of twice the digits, with parameters of as many.

use lagrangian::Factorization;
use lagrangian::prelude::*;
use lagrangian::quantities::StateJacobian;
use lagrangian_tests::{DoubleDouble, Figures, relative_error};

use crate::models::{
    BentPendulum, DampedCart, DoublePendulum, Gearbox, HeavyTop, Numbered, everything, gearing, on,
    parameters, state,
};

/// The greatest distance between two entries, relative to the greatest entry or to 1. The distance is
/// taken in double-double, where it does not vanish.
fn distance(found: &[DoubleDouble], expected: &[DoubleDouble]) -> f64 {
    assert_eq!(found.len(), expected.len());
    let differences: Vec<f64> = found
        .iter()
        .zip(expected)
        .map(|(found, expected)| (*found - *expected).to_f64())
        .collect();
    let scale = expected
        .iter()
        .fold(1.0, |scale: f64, entry| scale.max(entry.to_f64().abs()));
    relative_error(&differences, &vec![0.0; differences.len()], scale)
}

/// Parameters that no number of `f64` is: thirds.
fn thirds<const P: usize>(parameters: [f64; P]) -> [DoubleDouble; P] {
    parameters
        .map(|parameter| DoubleDouble::from_f64(3.0 * parameter) / DoubleDouble::from_f64(9.0))
}

/// What a model gives on double-doubles against what it gives on `f64`.
fn compare<Fine, Coarse, const N: usize, const P: usize>(
    figures: &mut Figures,
    name: &'static str,
    parameters: fn(usize) -> [f64; P],
) where
    Fine: Numbered<DoubleDouble, P>
        + Lagrangian<N, DoubleDouble, Model: StateJacobian<N, DoubleDouble>>,
    Coarse: Numbered<f64, P> + Lagrangian<N, Model: StateJacobian<N>>,
{
    for index in 0..10 {
        let parameters = parameters(index);
        let fine = Fine::with(parameters.map(Scalar::from_f64));
        let coarse = Coarse::with(parameters);
        let state = state::<N>(index);
        let found = everything(&fine, &on(&state));
        for ((quantity, found), (_, expected)) in found.iter().zip(everything(&coarse, &state)) {
            let found: Vec<f64> = found.iter().map(|number| number.to_f64()).collect();
            let error = relative_error(&found, &expected, 1.0);
            figures.record(quantity, &format!("{name}, state {index}"), error, 1e-13);
        }
    }
}

#[test]
fn double_doubles_give_what_doubles_give() {
    type Fine = DoubleDouble;
    let mut figures = Figures::new();
    compare::<HeavyTop<Fine>, HeavyTop<f64>, _, _>(&mut figures, "heavy top", parameters);
    compare::<DoublePendulum<Fine>, DoublePendulum<f64>, _, _>(
        &mut figures,
        "pendulum",
        parameters,
    );
    compare::<BentPendulum<Fine>, BentPendulum<f64>, _, _>(&mut figures, "bent", parameters);
    compare::<DampedCart<Fine>, DampedCart<f64>, _, _>(&mut figures, "cart", parameters);
    compare::<Gearbox<Fine>, Gearbox<f64>, _, _>(&mut figures, "gearbox", gearing);
    figures.finish();
}

/// What a model gives in one way against what it gives in another.
fn agree_with_themselves<M, const N: usize, const P: usize>(
    figures: &mut Figures,
    name: &'static str,
    parameters: fn(usize) -> [f64; P],
) where
    M: Numbered<DoubleDouble, P>
        + Lagrangian<N, DoubleDouble, Model: StateJacobian<N, DoubleDouble>>,
{
    for index in 0..10 {
        let model = M::with(thirds(parameters(index)));
        let state = on(&state::<N>(index));
        let accelerations = model.accelerations(&state);
        // Euler's equations, or a symbolic elimination, against a numerical one.
        let factors = Factorization::new(model.mass_matrix(&state));
        let solved = factors.solve(&model.forcing(&state));
        let at = format!("{name}, state {index}");
        let error = distance(accelerations.as_slice(), solved.as_slice());
        figures.record("M⁻¹ f", &at, error, TOLERANCE);
        let left = model.inverse_dynamics(&state, &accelerations);
        let error = distance(left.as_slice(), &[DoubleDouble::from_f64(0.0); N]);
        figures.record("M q̈ − f", &at, error, TOLERANCE);
        let twice = model.momenta(&state).component_mul(&state.v).sum();
        let error = distance(&[twice - model.lagrangian(&state)], &[model.energy(&state)]);
        figures.record("p·q̇ − L", &at, error, TOLERANCE);
    }
}

/// Twelve digits more than there are in a number of `f64`.
const TOLERANCE: f64 = 1e-28;

#[test]
fn two_ways_agree_to_twice_the_digits() {
    type Fine = DoubleDouble;
    let mut figures = Figures::new();
    agree_with_themselves::<HeavyTop<Fine>, _, _>(&mut figures, "heavy top", parameters);
    agree_with_themselves::<DoublePendulum<Fine>, _, _>(&mut figures, "pendulum", parameters);
    agree_with_themselves::<BentPendulum<Fine>, _, _>(&mut figures, "bent", parameters);
    agree_with_themselves::<DampedCart<Fine>, _, _>(&mut figures, "cart", parameters);
    agree_with_themselves::<Gearbox<Fine>, _, _>(&mut figures, "gearbox", gearing);
    figures.finish();
}

#[test]
fn two_declarations_of_one_pendulum_agree_to_twice_the_digits() {
    for index in 0..20 {
        let [m1, m2, l1, l2, g] = thirds(parameters(index));
        let pendulum = DoublePendulum { m1, m2, l1, l2, g };
        let bent = BentPendulum { m1, m2, l1, l2, g };
        let state: State<DoubleDouble, 2> = on(&state(index));
        // β = α + bend.
        let relative = State::new(
            state.t,
            SVector::from([state.q[0], state.q[1] - state.q[0]]),
            SVector::from([state.v[0], state.v[1] - state.v[0]]),
        );
        let [alpha, beta]: [DoubleDouble; 2] = pendulum.accelerations(&state).into();
        let found: [DoubleDouble; 2] = bent.accelerations(&relative).into();
        let error = distance(&found, &[alpha, beta - alpha]);
        assert!(error <= TOLERANCE, "state {index}: {error:e}");
        let error = distance(&[bent.energy(&relative)], &[pendulum.energy(&state)]);
        assert!(error <= TOLERANCE, "state {index}: {error:e}");
    }
}

/// The relative change of the energy over a quarter of a unit of time, in steps of length `step`.
fn drift(step: f64) -> Result<f64, IntegrationError> {
    let top = HeavyTop::with(thirds(parameters(2)));
    let start: State<DoubleDouble, 3> = on(&state(2));
    let method = RungeKutta::classical(step);
    let end = Problem::new(&top, start).solve(start.t.to_f64() + 0.25, method)?;
    let before = top.energy(&start);
    let change = (top.energy(&end) - before) / before;
    Ok(change.to_f64().abs())
}

/// In `f64` the drift would end among rounding errors, near 1e-16.
#[test]
fn the_order_of_a_method_shows_beyond_the_digits_of_f64() -> Result<(), IntegrationError> {
    let mut before = drift(0.5_f64.powi(11))?;
    for n in 12..=14 {
        let drift = drift(0.5_f64.powi(n))?;
        let ratio = before / drift;
        assert!(
            (ratio - 16.0).abs() < 0.1,
            "half a step: {before:e}, {drift:e}"
        );
        before = drift;
    }
    assert!(before < 1e-18, "{before:e}");
    Ok(())
}
