//! The states at which all sides are compared and measured: pseudo-random, the same on every run.

use crate::model::Model;

const STATES: usize = 256;

/// Coordinates and velocities, one row a state. The tops stay away from the poles of Euler's angles.
pub(crate) fn states(model: Model) -> Vec<Vec<f64>> {
    let degrees = model.degrees();
    let mut uniform = uniform();
    let mut row = || {
        let component = |index| {
            let (low, high) = range(model, degrees, index);
            low + (high - low) * uniform()
        };
        (0..2 * degrees).map(component).collect()
    };
    (0..STATES).map(|_| row()).collect()
}

fn range(model: Model, degrees: usize, index: usize) -> (f64, f64) {
    match model {
        _ if index >= degrees => (-2.0, 2.0),
        Model::Pendulum(_) | Model::DoublePendulumMultipliedOut => (-1.0, 1.0),
        _ if index == 1 => (0.3, 2.8),
        _ => (-3.0, 3.0),
    }
}

/// Marsaglia's xorshift with 64 bits, from the seed of his paper: numbers from 0 to 1.
#[allow(clippy::cast_precision_loss)] // 53 bits are kept.
pub(crate) fn uniform() -> impl FnMut() -> f64 {
    let mut state = 88_172_645_463_325_252_u64;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}
