//! Output matrices by dual numbers.

use nalgebra::{SMatrix, SVector};

use super::state_space::StateSpace;
use crate::linalg::IntoVector;
use crate::model::State;
use crate::scalar::Dual;

impl<const D: usize, const U: usize, const Y: usize> StateSpace<f64, D, U, Y> {
    /// Returns the model with the outputs y = `outputs(state, inputs)`, linearized about a state and inputs.
    ///
    /// C = ∂y/∂x and D = ∂y/∂u are exact: the function is evaluated on dual numbers.
    ///
    /// ```
    /// use lagrangian::analysis::StateSpace;
    /// use lagrangian::prelude::*;
    ///
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     coordinates(theta),
    ///     define(height = -l * cos(theta)),
    ///     kinetic = 0.5 * m * (l * dot(theta)).powi(2),
    ///     potential = m * g * height,
    ///     force(theta = torque),
    ///     output(height = height, acceleration = dot(dot(theta))),
    /// )]
    /// struct Pendulum { m: f64, l: f64, g: f64, #[lagrangian(input)] torque: f64 }
    ///
    /// let model = Pendulum { m: 2.0, l: 0.5, g: 9.81, torque: 0.0 };
    /// let (state, inputs) = (State::new(0.0, [0.5], [0.0]), [3.0].into());
    /// let plant = StateSpace::<f64, 2, 1, 2>::of(&model.with_inputs(inputs), &state)
    ///     .with_linearized_outputs(&state, &inputs, |state, inputs| {
    ///         let outputs = model.with_inputs(*inputs).outputs(state);
    ///         [outputs.height, outputs.acceleration]
    ///     });
    /// let (sine, cosine) = 0.5_f64.sin_cos();
    /// assert!((plant.c[(0, 0)] - 0.5 * sine).abs() < 1e-15);
    /// assert!((plant.c[(1, 0)] + 9.81 / 0.5 * cosine).abs() < 1e-13);
    /// assert!((plant.d[(1, 0)] - 1.0 / (2.0 * 0.5 * 0.5)).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn with_linearized_outputs<F, R, const N: usize, const Z: usize>(
        &self,
        state: &State<f64, N>,
        inputs: &SVector<f64, U>,
        outputs: F,
    ) -> StateSpace<f64, D, U, Z>
    where
        F: Fn(&State<Dual, N>, &SVector<Dual, U>) -> R,
        R: IntoVector<Dual, Z>,
    {
        const {
            assert!(
                D == 2 * N,
                "the state has twice as many components as there are coordinates: `D` is 2 `N`"
            );
        }
        // Evaluates the outputs, and their derivatives by the variable with an index.
        let evaluated = |index: Option<usize>| {
            let number = |value: f64, own: usize| {
                Dual::new(value, [if index == Some(own) { 1.0 } else { 0.0 }])
            };
            let state = State::new(
                Dual::constant(state.t),
                SVector::from_fn(|i, _| number(state.q[i], i)),
                SVector::from_fn(|i, _| number(state.v[i], N + i)),
            );
            let inputs = SVector::from_fn(|i, _| number(inputs[i], D + i));
            let found: SVector<Dual, Z> = outputs(&state, &inputs).into_vector();
            found
        };
        let mut c = SMatrix::<f64, Z, D>::zeros();
        for j in 0..D {
            c.set_column(j, &evaluated(Some(j)).map(|y| y.derivative[0]));
        }
        let mut d = SMatrix::<f64, Z, U>::zeros();
        for j in 0..U {
            d.set_column(j, &evaluated(Some(D + j)).map(|y| y.derivative[0]));
        }
        self.with_outputs(c, d, evaluated(None).map(|y| y.value))
    }
}
