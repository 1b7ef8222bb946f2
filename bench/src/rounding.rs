//! How a form of the accelerations rounds.

use lagrangian::{Lagrangian, State};
use nalgebra::SVector;

/// The error of the accelerations in single precision: the root of its mean square over all states,
/// relative to the size of the accelerations there, in units of the precision.
///
/// The same code in double precision, at the same states, is the truth. What rounds badly in one precision
/// does in the other, so that this tells well from badly conditioned forms where no exact values are known.
/// Parameters are rounded too, which costs every form the same.
pub(crate) fn rounding<const N: usize, M: Lagrangian<N> + Lagrangian<N, f32>>(
    model: &M,
    states: &[Vec<f64>],
) -> f64 {
    let mut sum = 0.0;
    let mut count = 0.0;
    for row in states {
        let (q, v) = row.split_at(N);
        let [q, v] = [q, v].map(single::<N>);
        let state = State::new(0.0_f64, q.cast(), v.cast());
        let exact: SVector<f64, N> = model.accelerations(&state);
        let rounded: SVector<f32, N> = model.accelerations(&State::new(0.0_f32, q, v));
        let error = (rounded.cast::<f64>() - exact).norm() / exact.norm().max(1.0);
        sum += error * error;
        count += 1.0;
    }
    f64::sqrt(sum / count) / f64::from(f32::EPSILON)
}

#[allow(clippy::cast_possible_truncation)] // Rounding is what is wanted.
fn single<const N: usize>(numbers: &[f64]) -> SVector<f32, N> {
    SVector::from_iterator(numbers.iter().map(|x| *x as f32))
}
