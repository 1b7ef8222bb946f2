//! The inputs that a given motion of a constrained model requires.

use nalgebra::SVector;

use super::exceeds;
use super::jacobian_rows::{JacobianRows, Variables};
use super::required_inputs_error::RequiredInputsError;
use crate::integrate::SingleNumber;
use crate::limits::analysis::INPUT_STEPS;
use crate::linalg::{IntoVector, kept, largest};
use crate::model::{DegreesOfFreedom, DirectionalDerivatives, Inputs, Quantities, State};
use crate::scalar::Scalar;

/// The inputs that give a constrained model accelerations, and the multipliers of its constraints: the inverse dynamics of
/// mechanisms with actuators.
///
/// As many independent accelerations as there are degrees of freedom determine the motion. The inputs solve
/// q̈(u) = q̈ for these by Newton's method, which takes one step where forces are linear in the inputs. Where there are more inputs
/// than degrees of freedom, the weighted sum of squares Σ wᵢ uᵢ² is least (the minimum-norm solution of a scaled problem: G. H. Golub &
/// C. F. Van Loan, *Matrix Computations*, 4th edition (2013), 5.6 and 6.1). Weights 1/uₘₐₓ² share the load in proportion to what
/// actuators can do, and make forces and torques comparable.
///
/// ```
/// use lagrangian::analysis::RequiredInputs;
/// use lagrangian::prelude::*;
///
/// /// A bob on a rod, which two forces push.
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(x, y),
///     kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
///     potential = m * g * y,
///     force(x = push.x, y = push.y),
///     constraint(rod = 0.5 * (x.powi(2) + y.powi(2) - l.powi(2))),
/// )]
/// struct Bob { m: f64, g: f64, l: f64, #[lagrangian(input)] push: Vector2<f64> }
///
/// let bob = Bob { m: 2.0, g: 9.81, l: 0.5, push: Vector2::zeros() };
/// // At rest, 30° from the vertical: the smallest force that holds it acts along its circle.
/// let (sine, cosine) = (0.5, 0.75_f64.sqrt());
/// let state = State::new(0.0, [0.5 * sine, -0.5 * cosine], [0.0; 2]);
/// let required = RequiredInputs::of(&bob, &state, &Vector2::zeros(), [1.0, 1.0])?;
/// let along = 2.0 * 9.81 * sine * Vector2::new(cosine, sine);
/// assert!((required.inputs - along).norm() < 1e-13);
/// // The rod carries the rest of the weight: λ times its gradient, whose length is that of the rod.
/// assert!((required.multipliers[0] * 0.5 + 2.0 * 9.81 * cosine).abs() < 1e-13);
/// // Where a push upwards costs much more, one to the side holds the bob nearly alone, with m g tan 30°.
/// let aside = RequiredInputs::of(&bob, &state, &Vector2::zeros(), [1.0, 1e9])?;
/// assert!((aside.inputs - Vector2::new(2.0 * 9.81 * sine / cosine, 0.0)).norm() < 1e-7);
/// # Ok::<(), lagrangian::analysis::RequiredInputsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RequiredInputs<S: Scalar, const U: usize, const C: usize> {
    /// The inputs u.
    pub inputs: SVector<S, U>,
    /// The multipliers λ.
    pub multipliers: SVector<S, C>,
}

impl<S: SingleNumber, const U: usize, const C: usize> RequiredInputs<S, U, C> {
    /// Finds the inputs and multipliers at a state with these accelerations. Of several inputs that give them, those are found for which
    /// Σ wᵢ uᵢ² is least, with the `weights` w, one for each input; where there are no more inputs than degrees of freedom they do not
    /// matter.
    ///
    /// # Errors
    ///
    /// [`RequiredInputsError`], if a weight is not positive and finite, if the state or the accelerations do not meet the constraints, or if
    /// no inputs give these accelerations: they act on fewer degrees of freedom than there are.
    pub fn of<M, const N: usize>(
        model: &M,
        state: &State<S, N>,
        accelerations: &SVector<S, N>,
        weights: impl IntoVector<S, U>,
    ) -> Result<Self, RequiredInputsError>
    where
        M: DirectionalDerivatives<N, C, S> + Inputs<N, U, S> + ?Sized,
    {
        let motion = Motion {
            model,
            state,
            accelerations,
        };
        // Inputs are measured in units in which all weights are 1.
        let units = units(&weights.into_vector())?;
        motion.check_constraints()?;
        let freedom = DegreesOfFreedom::<N, C>::of(model, state, [&[false; N]; 2]);
        let [_, independent] = freedom.marks();
        let mut inputs = SVector::<S, U>::zeros();
        let mut rank = 0;
        for _ in 0..INPUT_STEPS {
            let missing = motion.missing(&inputs, &independent);
            let rows = motion.rows((&inputs, &units), &independent);
            rank = rows.rank();
            let step = rows.solve(&[missing, SVector::zeros()]).inputs;
            let step = step.component_mul(&units);
            inputs += step;
            if largest(&step) <= S::machine_epsilon() * largest(&inputs) {
                break;
            }
        }
        motion.check_reached(&inputs, rank, &freedom)?;
        let prepared = model.prepare();
        let (_, multipliers) = model.accelerations_and_multipliers(state, &inputs, &prepared);
        Ok(Self {
            inputs,
            multipliers,
        })
    }
}

/// Returns the inverse roots of the weights.
fn units<S: SingleNumber, const U: usize>(
    weights: &SVector<S, U>,
) -> Result<SVector<S, U>, RequiredInputsError> {
    let is_wrong = |weight: f64| !(weight > 0.0 && weight.is_finite());
    let wrong = (0..U).find(|i| is_wrong(weights[*i].largest()));
    wrong.map_or(
        Ok(weights.map(|weight| S::one() / weight.sqrt())),
        |input| {
            Err(RequiredInputsError::Weight {
                input,
                weight: weights[input].largest(),
            })
        },
    )
}

/// A state of a model and the accelerations that are asked for.
struct Motion<'a, M: ?Sized, S: Scalar, const N: usize> {
    model: &'a M,
    state: &'a State<S, N>,
    accelerations: &'a SVector<S, N>,
}

impl<M, S, const N: usize> Motion<'_, M, S, N>
where
    M: ?Sized,
    S: SingleNumber,
{
    /// Checks that the state and G q̈ + γ = 0 meet the constraints.
    fn check_constraints<const C: usize>(&self) -> Result<(), RequiredInputsError>
    where
        M: DirectionalDerivatives<N, C, S>,
    {
        let names = <M as Quantities<N, S>>::CONSTRAINTS;
        let name = |i: usize| names.get(i).copied().unwrap_or("?");
        let prepared = self.model.prepare();
        if let Some((constraint, residual)) = self.model.violated_constraint(self.state, &prepared)
        {
            return Err(RequiredInputsError::InconsistentState {
                constraint: name(constraint),
                residual: residual.largest(),
            });
        }
        let jacobian = self.model.constraint_jacobian(self.state, &prepared);
        let rates = self.model.constraint_rates(self.state, &prepared);
        let residuals = jacobian * self.accelerations + rates;
        let terms = jacobian.map(S::abs) * self.accelerations.map(S::abs) + rates.map(S::abs);
        let tolerance = libm::sqrt(S::machine_epsilon());
        let exceeding = (0..C).find(|i| {
            let size = residuals[*i].abs().largest();
            exceeds(size, tolerance * terms[*i].largest().max(tolerance))
        });
        exceeding.map_or(Ok(()), |i| {
            Err(RequiredInputsError::InconsistentAccelerations {
                constraint: name(i),
                residual: residuals[i].largest(),
            })
        })
    }

    /// Returns what is missing of the independent accelerations at some inputs.
    fn missing<const C: usize, const U: usize>(
        &self,
        inputs: &SVector<S, U>,
        independent: &[bool; N],
    ) -> SVector<S, N>
    where
        M: DirectionalDerivatives<N, C, S> + Inputs<N, U, S>,
    {
        let found = self
            .model
            .accelerations(self.state, inputs, &self.model.prepare());
        kept(&(self.accelerations - found), |i, _| independent[i])
    }

    /// Returns the factored derivatives of the independent accelerations by the inputs in their units.
    fn rows<const C: usize, const U: usize>(
        &self,
        (inputs, units): (&SVector<S, U>, &SVector<S, U>),
        independent: &[bool; N],
    ) -> JacobianRows<S, N, U>
    where
        M: DirectionalDerivatives<N, C, S> + Inputs<N, U, S>,
    {
        let mut rows = [[Variables::zeros(); N]; 2];
        for input in 0..U {
            let column = self.model.derivatives_by_input(self.state, inputs, input);
            for i in (0..N).filter(|i| independent[*i]) {
                rows[0][i].inputs[input] = column.accelerations[i] * units[input];
            }
        }
        JacobianRows::new(&rows)
    }

    /// Checks that the inputs give the accelerations, relative to what they are without them.
    fn check_reached<const C: usize, const U: usize>(
        &self,
        inputs: &SVector<S, U>,
        rank: usize,
        freedom: &DegreesOfFreedom<N, C>,
    ) -> Result<(), RequiredInputsError>
    where
        M: DirectionalDerivatives<N, C, S> + Inputs<N, U, S>,
    {
        let prepared = self.model.prepare();
        let found = self.model.accelerations(self.state, inputs, &prepared);
        let without = self
            .model
            .accelerations(self.state, &SVector::zeros(), &prepared);
        let size = largest(&found)
            .max(largest(&without))
            .max(largest(self.accelerations));
        let limit = libm::sqrt(S::machine_epsilon()) * size;
        let missed = |i: usize| (self.accelerations[i] - found[i]).largest();
        let worst = freedom
            .independent_velocities()
            .filter(|i| exceeds(missed(*i).abs(), limit))
            .max_by(|i, j| missed(*i).abs().total_cmp(&missed(*j).abs()));
        worst.map_or(Ok(()), |i| {
            Err(RequiredInputsError::TooFewInputs {
                coordinate: M::COORDINATES[i],
                missing: missed(i),
                inputs: rank,
                freedoms: freedom.velocities,
            })
        })
    }
}
