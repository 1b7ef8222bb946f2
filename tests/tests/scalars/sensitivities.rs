//! Derivatives with respect to parameters, which dual numbers carry, against two derivations that know
//! nothing of them.

use lagrangian::prelude::*;
use lagrangian_tests::{DoubleDouble, Dual, Figures, assert_close, relative_error};

use crate::models::{
    BentPendulum, DampedCart, DoublePendulum, Gearbox, HeavyTop, Numbered, gearing, on, parameters,
    state,
};

/// Parameters that do not move, but for one.
fn moving<const P: usize>(parameters: [f64; P], which: usize) -> [Dual; P] {
    std::array::from_fn(|i| Dual::new(parameters[i], if i == which { 1.0 } else { 0.0 }))
}

/// ∂q̈/∂p by a quotient of differences on double-doubles: the error is about h² = 1e-20 of what the third
/// derivative is, and 1e-32/h of rounding.
fn by_differences<M, const N: usize, const P: usize>(
    parameters: [f64; P],
    which: usize,
    state: &State<f64, N>,
) -> Vec<f64>
where
    M: Numbered<DoubleDouble, P> + Lagrangian<N, DoubleDouble>,
{
    let h = DoubleDouble::from_f64(1e-10);
    let beside = |offset: DoubleDouble| {
        let mut parameters = parameters.map(DoubleDouble::from_f64);
        parameters[which] += offset;
        M::with(parameters).accelerations(&on(state))
    };
    let difference = beside(h) - beside(-h);
    let quotients = difference.map(|entry| (entry / (h + h)).to_f64());
    quotients.as_slice().to_vec()
}

/// ∂q̈/∂p = M⁻¹ (∂f/∂p − ∂M/∂p q̈), from the dual numbers of M and f.
fn by_solving<M, F, const N: usize, const P: usize>(
    parameters: [f64; P],
    which: usize,
    state: &State<f64, N>,
) -> Vec<f64>
where
    M: Numbered<Dual, P> + Lagrangian<N, Dual>,
    F: Numbered<f64, P> + Lagrangian<N>,
{
    let dual = M::with(moving(parameters, which));
    let plain = F::with(parameters);
    let accelerations = plain.accelerations(state);
    let forcing = dual.forcing(&on(state)).map(Dual::derivative);
    let mass = dual.mass_matrix(&on(state)).map(Dual::derivative);
    let factors = lagrangian::Factorization::new(plain.mass_matrix(state));
    let derivatives = factors.solve(&(forcing - mass * accelerations));
    derivatives.as_slice().to_vec()
}

/// A unit in the last place, times what solving twice with M and differentiating may lose.
const TOLERANCE: f64 = 1e-13;

fn compare<D, F, Fine, const N: usize, const P: usize>(
    figures: &mut Figures,
    name: &'static str,
    parameters: fn(usize) -> [f64; P],
) where
    D: Numbered<Dual, P> + Lagrangian<N, Dual>,
    F: Numbered<f64, P> + Lagrangian<N>,
    Fine: Numbered<DoubleDouble, P> + Lagrangian<N, DoubleDouble>,
{
    for index in 0..10 {
        for which in 0..P {
            let (parameters, state) = (parameters(index), state::<N>(index));
            let model = D::with(moving(parameters, which));
            let accelerations = model.accelerations(&on(&state));
            let found: Vec<f64> = accelerations
                .iter()
                .map(|entry| entry.derivative())
                .collect();
            let at = format!("{name}, parameter {which}, state {index}");
            let expected = by_differences::<Fine, N, P>(parameters, which, &state);
            figures.record(
                "differences",
                &at,
                relative_error(&found, &expected, 1.0),
                TOLERANCE,
            );
            let expected = by_solving::<D, F, N, P>(parameters, which, &state);
            figures.record(
                "M⁻¹ (f' − M' q̈)",
                &at,
                relative_error(&found, &expected, 1.0),
                TOLERANCE,
            );
        }
    }
}

#[test]
fn accelerations_know_how_they_depend_on_parameters() {
    type Fine = DoubleDouble;
    let mut figures = Figures::new();
    compare::<HeavyTop<Dual>, HeavyTop<f64>, HeavyTop<Fine>, _, _>(
        &mut figures,
        "heavy top",
        parameters,
    );
    compare::<DoublePendulum<Dual>, DoublePendulum<f64>, DoublePendulum<Fine>, _, _>(
        &mut figures,
        "pendulum",
        parameters,
    );
    compare::<BentPendulum<Dual>, BentPendulum<f64>, BentPendulum<Fine>, _, _>(
        &mut figures,
        "bent",
        parameters,
    );
    compare::<DampedCart<Dual>, DampedCart<f64>, DampedCart<Fine>, _, _>(
        &mut figures,
        "cart",
        parameters,
    );
    compare::<Gearbox<Dual>, Gearbox<f64>, Gearbox<Fine>, _, _>(&mut figures, "gearbox", gearing);
    figures.finish();
}

/// Where a damped cart is after a unit of time.
fn end<S: Scalar>(parameters: [S; 9]) -> Result<[S; 2], IntegrationError> {
    let start = State::new(
        S::from_f64(0.0),
        [0.5, -0.25].map(S::from_f64),
        [0.0, 1.0].map(S::from_f64),
    );
    let cart = DampedCart::with(parameters);
    let end = Problem::new(&cart, start).solve(1.0, RungeKutta::classical(0.015_625))?;
    Ok(end.q.into())
}

/// The same steps are differentiated that are taken: they need not be short.
#[test]
fn a_motion_knows_how_it_depends_on_parameters() -> Result<(), IntegrationError> {
    let values = parameters(1);
    for which in 0..9 {
        let found = end(moving(values, which))?.map(Dual::derivative);
        let h = DoubleDouble::from_f64(1e-10);
        let beside = |offset| {
            let mut parameters = values.map(DoubleDouble::from_f64);
            parameters[which] += offset;
            end(parameters)
        };
        let (more, less) = (beside(h)?, beside(-h)?);
        let expected = std::array::from_fn(|i| ((more[i] - less[i]) / (h + h)).to_f64());
        let expected: [f64; 2] = expected;
        assert_close("∂q/∂p", &found, &expected, 1e-13);
    }
    Ok(())
}
