//! Linear state-space models of constrained mechanisms.

use nalgebra::{SMatrix, SVector};

use super::state_space::StateSpace;
use super::tangent_error::TangentError;
use super::tangent_space::{TangentSpace, selected};
use super::tangents::Tangents;
use crate::integrate::SingleNumber;
use crate::model::{DirectionalDerivatives, Inputs, Lagrangian};

impl<S: SingleNumber, const D: usize> StateSpace<S, D, 0, D> {
    /// Linearizes a constrained model in independent coordinates and velocities, without inputs or with the inputs held.
    ///
    /// # Errors
    ///
    /// [`TangentError`], if the choice of variables or the state does not allow it, or `D` is not the number of variables.
    pub fn reduced_free<M, const N: usize, const C: usize>(
        tangent: &TangentSpace<'_, M, S, N, C>,
    ) -> Result<Self, TangentError>
    where
        M: Lagrangian<N, S, Model: DirectionalDerivatives<N, C, S>> + ?Sized,
    {
        linearized(tangent, SVector::zeros())
    }
}

impl<S: SingleNumber, const D: usize, const U: usize> StateSpace<S, D, U, D> {
    /// Linearizes a constrained model and its inputs in independent coordinates and velocities.
    ///
    /// ```
    /// use lagrangian::analysis::{StateSpace, TangentSpace};
    /// use lagrangian::nalgebra::{Matrix1, Matrix2};
    /// use lagrangian::prelude::*;
    ///
    /// /// A pendulum in Cartesian coordinates, pushed sideways.
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     coordinates(x, y),
    ///     kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    ///     potential = m * g * y,
    ///     force(x = push),
    ///     constraint(rod = x.powi(2) + y.powi(2) - l.powi(2)),
    /// )]
    /// struct Pendulum { m: f64, g: f64, l: f64, #[lagrangian(input)] push: f64 }
    ///
    /// let pendulum = Pendulum { m: 2.0, g: 9.81, l: 0.5, push: 0.0 };
    /// let upright = State::new(0.0, [0.0, 0.5], [0.0; 2]);
    /// let tangent = TangentSpace::at(&pendulum, &upright);
    /// let plant = StateSpace::<f64, 2, 1, 2>::reduced(&tangent)?;
    /// assert!((plant.b[1] - 0.5).abs() < 1e-15);
    /// let regulator = plant.regulator(&Matrix2::identity(), &Matrix1::identity())?;
    /// assert!(regulator.poles.abscissa() < 0.0);
    /// // The push at a state of the constrained model.
    /// let tilted = State::new(0.0, [0.01, (0.25_f64 - 1e-4).sqrt()], [0.0; 2]);
    /// assert_eq!(regulator.input(&tilted)[0], -regulator.gain[0] * 0.01);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Those of [`reduced_free`](StateSpace::reduced_free).
    pub fn reduced<M, const N: usize, const C: usize>(
        tangent: &TangentSpace<'_, M, S, N, C>,
    ) -> Result<Self, TangentError>
    where
        M: Lagrangian<N, S, Model: DirectionalDerivatives<N, C, S> + Inputs<N, U, S>> + ?Sized,
    {
        linearized(tangent, tangent.model.inputs())
    }
}

/// Returns the linear model, at the inputs by which it is differentiated.
fn linearized<M, S, const N: usize, const C: usize, const D: usize, const U: usize>(
    tangent: &TangentSpace<'_, M, S, N, C>,
    inputs: SVector<S, U>,
) -> Result<StateSpace<S, D, U, D>, TangentError>
where
    M: Lagrangian<N, S, Model: DirectionalDerivatives<N, C, S>> + ?Sized,
    S: SingleNumber,
{
    let tangents = Tangents::of(tangent)?;
    let (basis, a) = tangent.linearized::<D>(&tangents)?;
    let variables = basis.variables;
    let mut b = SMatrix::<S, D, U>::zeros();
    for input in 0..U {
        let column = selected(&variables, &SVector::zeros(), &tangents.by_input(input));
        b.set_column(input, &column);
    }
    let (rates, state) = (tangents.rates(), tangents.state());
    let state = selected(&variables, &state.q, &state.v);
    Ok(StateSpace {
        derivative: selected(&variables, &rates.q, &rates.v),
        output: state,
        state,
        inputs,
        variables,
        ..StateSpace::new(a, b)
    })
}
