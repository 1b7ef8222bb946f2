//! What models are evaluated at.

use lagrangian::State;
use lagrangian_tests::Random;

/// What a model is evaluated at.
#[derive(Clone, Debug)]
pub(super) struct Point {
    pub(super) t: f64,
    pub(super) q: Vec<f64>,
    pub(super) v: Vec<f64>,
    pub(super) u: Vec<f64>,
    /// Accelerations.
    pub(super) a: Vec<f64>,
    /// The length of a step.
    pub(super) h: f64,
}

impl Point {
    /// A random point for so many coordinates and inputs.
    pub(super) fn random(random: &mut Random, n: usize, inputs: usize) -> Self {
        let mut numbers = |count: usize, most: f64| -> Vec<f64> {
            (0..count).map(|_| random.between(-most, most)).collect()
        };
        let (q, v, u, a) = (
            numbers(n, 3.0),
            numbers(n, 2.0),
            numbers(inputs, 5.0),
            numbers(n, 10.0),
        );
        // Sums of the time and parts of these steps are exact.
        let eighths = (random.between(0.0, 8.0)).floor();
        Self {
            t: eighths / 8.0,
            q,
            v,
            u,
            a,
            h: 1.0 / 128.0,
        }
    }

    /// The state.
    pub(super) fn state<const N: usize>(&self) -> State<f64, N> {
        let of = |numbers: &[f64]| -> [f64; N] { std::array::from_fn(|i| numbers[i]) };
        State::new(self.t, of(&self.q), of(&self.v))
    }
}
