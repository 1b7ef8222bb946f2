//! Single precision, with parameters in single precision, against double.

use lagrangian::prelude::*;
use lagrangian::quantities::StateJacobian;
use lagrangian_tests::{Figures, relative_error};

use crate::models::{
    BentPendulum, DampedCart, DoublePendulum, Gearbox, HeavyTop, Numbered, everything, gearing, on,
    parameters, state,
};

/// About 80 units in the last place: derivatives of accelerations lose the most.
const TOLERANCE: f64 = 1e-5;

fn compare<Single, Double, const N: usize, const P: usize>(
    figures: &mut Figures,
    name: &'static str,
    parameters: fn(usize) -> [f64; P],
) where
    Single: Numbered<f32, P> + Lagrangian<N, f32, Model: StateJacobian<N, f32>>,
    Double: Numbered<f64, P> + Lagrangian<N, Model: StateJacobian<N>>,
{
    for index in 0..20 {
        let parameters = parameters(index);
        // All numbers given are exact in single precision.
        let single = Single::with(parameters.map(Scalar::from_f64));
        let double = Double::with(parameters);
        let state = state::<N>(index);
        let found = everything(&single, &on(&state));
        for ((quantity, found), (_, expected)) in found.iter().zip(everything(&double, &state)) {
            let found: Vec<f64> = found.iter().copied().map(f64::from).collect();
            let error = relative_error(&found, &expected, 1.0);
            figures.record(
                quantity,
                &format!("{name}, state {index}"),
                error,
                TOLERANCE,
            );
        }
    }
}

#[test]
fn single_precision_gives_its_digits() {
    let mut figures = Figures::new();
    compare::<HeavyTop<f32>, HeavyTop<f64>, _, _>(&mut figures, "heavy top", parameters);
    compare::<DoublePendulum<f32>, DoublePendulum<f64>, _, _>(&mut figures, "pendulum", parameters);
    compare::<BentPendulum<f32>, BentPendulum<f64>, _, _>(&mut figures, "bent", parameters);
    compare::<DampedCart<f32>, DampedCart<f64>, _, _>(&mut figures, "cart", parameters);
    compare::<Gearbox<f32>, Gearbox<f64>, _, _>(&mut figures, "gearbox", gearing);
    figures.finish();
}
