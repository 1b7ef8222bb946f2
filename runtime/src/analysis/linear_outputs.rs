//! Output matrices by dual numbers.

use nalgebra::{SMatrix, SVector};

use super::state_space::StateSpace;
use super::tangent_space::TangentBasis;
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
        let unit = |index: usize, first: usize| {
            SVector::from_fn(|i, _| if first + i == index { 1.0 } else { 0.0 })
        };
        let along = |j: usize| [unit(j, 0), unit(j, N)];
        self.with_outputs_in(along, (state, inputs), outputs)
    }

    /// Returns the model of a [constrained](StateSpace::reduced) mechanism with the outputs y = `outputs(state, inputs)`, such as
    /// reactions, linearized along a basis of its perturbations.
    ///
    /// ```
    /// use lagrangian::analysis::{StateSpace, TangentSpace};
    /// use lagrangian::prelude::*;
    ///
    /// /// A bob on a rod, in Cartesian coordinates.
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     coordinates(x, y),
    ///     kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    ///     potential = m * g * y,
    ///     force(x = push),
    ///     constraint(rod = [x, y].norm() - l),
    /// )]
    /// struct Pendulum { m: f64, g: f64, l: f64, #[lagrangian(input)] push: f64 }
    ///
    /// // Held at 60° from the vertical by a push to the side.
    /// let push = 2.0 * 9.81 * 3.0_f64.sqrt();
    /// let pendulum = Pendulum { m: 2.0, g: 9.81, l: 0.5, push };
    /// let state = State::new(0.0, [0.25 * 3.0_f64.sqrt(), -0.25], [0.0; 2]);
    /// let tangent = TangentSpace::at(&pendulum, &state).coordinates([Pendulum::X]);
    /// let tangent = tangent.velocities([Pendulum::X]);
    /// let (plant, basis) = (StateSpace::<f64, 2, 1, 2>::reduced(&tangent)?, tangent.basis()?);
    /// let plant = plant.with_linearized_outputs_along(&basis, (&state, &[push].into()), |x, u| {
    ///     [pendulum.with_inputs(*u).multipliers(x)[0], x.q[1]]
    /// });
    /// // λ = −m g cos φ − u sin φ.
    /// assert!((plant.output[0] + 2.0 * 9.81 * 0.5 + push * 0.75_f64.sqrt()).abs() < 1e-13);
    /// assert!((plant.d[0] + 0.75_f64.sqrt()).abs() < 1e-15);
    /// // The height changes with x as the tangent of the circle.
    /// assert!(plant.c[(0, 0)].abs() < 1e-13 && (plant.c[(1, 0)] - 3.0_f64.sqrt()).abs() < 1e-14);
    /// # Ok::<(), lagrangian::analysis::TangentError>(())
    /// ```
    #[must_use]
    pub fn with_linearized_outputs_along<F, R, const N: usize, const Z: usize>(
        &self,
        basis: &TangentBasis<f64, N, D>,
        at: (&State<f64, N>, &SVector<f64, U>),
        outputs: F,
    ) -> StateSpace<f64, D, U, Z>
    where
        F: Fn(&State<Dual, N>, &SVector<Dual, U>) -> R,
        R: IntoVector<Dual, Z>,
    {
        let along =
            |j: usize| [basis.q.column(j), basis.v.column(j)].map(nalgebra::Matrix::into_owned);
        self.with_outputs_in(along, at, outputs)
    }

    /// Returns the model with the outputs y = `outputs(state, inputs)`, given how coordinates and velocities change with each component
    /// of x.
    fn with_outputs_in<F, R, const N: usize, const Z: usize>(
        &self,
        along: impl Fn(usize) -> [SVector<f64, N>; 2],
        (state, inputs): (&State<f64, N>, &SVector<f64, U>),
        outputs: F,
    ) -> StateSpace<f64, D, U, Z>
    where
        F: Fn(&State<Dual, N>, &SVector<Dual, U>) -> R,
        R: IntoVector<Dual, Z>,
    {
        let evaluated = |[q, v]: [SVector<f64, N>; 2], input: Option<usize>| {
            let number = |value: f64, slope: f64| Dual::new(value, [slope]);
            let state = State::new(
                Dual::constant(state.t),
                state.q.zip_map(&q, number),
                state.v.zip_map(&v, number),
            );
            let slope = |i: usize| if input == Some(i) { 1.0 } else { 0.0 };
            let inputs = SVector::from_fn(|i, _| number(inputs[i], slope(i)));
            let found: SVector<Dual, Z> = outputs(&state, &inputs).into_vector();
            found
        };
        let mut c = SMatrix::<f64, Z, D>::zeros();
        for j in 0..D {
            c.set_column(j, &evaluated(along(j), None).map(|y| y.derivative[0]));
        }
        let still = [SVector::zeros(); 2];
        let mut d = SMatrix::<f64, Z, U>::zeros();
        for j in 0..U {
            d.set_column(j, &evaluated(still, Some(j)).map(|y| y.derivative[0]));
        }
        self.with_outputs(c, d, evaluated(still, None).map(|y| y.value))
    }
}
