//! Linear least squares by orthogonal transformations, one equation at a time.
//!
//! The triangular factor R of Y (Golub, Numerical methods for solving linear least squares problems, 1965) is updated
//! by Givens rotations (Gentleman, Least squares computations by Givens transformations without square roots, 1973;
//! Bierman, Factorization Methods for Discrete Sequential Estimation, 1977).

use nalgebra::{SMatrix, SVector};

use super::error::IdentificationError;
use super::identified::Identified;
use super::singular_values::SingularValues;
use crate::limits::MAX_CONDITION_NUMBER;
use crate::model::{Lagrangian, Regressor, State};
use crate::scalar::Scalar;

/// Equations for the base parameters of a model, accumulated from measurements.
///
/// ```
/// use lagrangian::identification::Identification;
/// use lagrangian::prelude::*;
///
/// /// A pendulum; its mass, the place of its centre of mass and its inertia are unknown.
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(theta),
///     kinetic = 0.5 * (i + m * c.powi(2)) * dot(theta).powi(2),
///     potential = -m * g * c * cos(theta),
///     force(theta = torque),
///     regressor(i, m, c),
/// )]
/// struct Pendulum { i: f64, m: f64, c: f64, g: f64, #[lagrangian(input)] torque: f64 }
///
/// let real = Pendulum { i: 0.02, m: 1.5, c: 0.3, g: 9.81, torque: 0.0 };
/// assert_eq!(Pendulum::BASE_PARAMETERS, ["I + m c²", "m c"]);
/// let mut identification = Identification::new(Pendulum::BASE_PARAMETERS);
/// // What is known of the pendulum: g.
/// let model = Pendulum { i: 0.0, m: 0.0, c: 0.0, g: 9.81, torque: 0.0 };
/// for k in 0..20 {
///     let torque = f64::from(k % 5);
///     let state = State::new(0.0, [0.3 * f64::from(k)], [0.0]);
///     let measured = real.with_inputs([torque]).accelerations(&state);
///     // No force acts but those that the model has.
///     identification.add(&model.with_inputs([torque]), &state, &measured, &SVector::zeros());
/// }
/// let identified = identification.solve()?;
/// assert!((identified.parameters - real.base_parameters()).norm() < 1e-12);
/// # Ok::<(), lagrangian::identification::IdentificationError<2>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Identification<const B: usize> {
    names: [&'static str; B],
    largest_condition_number: f64,
    /// The upper triangular factor R of Y.
    factor: SMatrix<f64, B, B>,
    /// Qᵀ (τ − r), whose first components belong to R.
    right: SVector<f64, B>,
    /// The sum of the squares of the other components.
    residual: f64,
    equations: usize,
    /// The first equation with a number that is not finite.
    not_finite: Option<usize>,
}

impl<const B: usize> Identification<B> {
    /// Creates an identification without equations, for base parameters with these names:
    /// [`Regressor::BASE_PARAMETERS`].
    #[must_use]
    pub fn new(names: [&'static str; B]) -> Self {
        Self {
            names,
            largest_condition_number: MAX_CONDITION_NUMBER,
            factor: SMatrix::zeros(),
            right: SVector::zeros(),
            residual: 0.0,
            equations: 0,
            not_finite: None,
        }
    }

    /// Sets the condition number above which a combination of parameters counts as not excited; 10⁸ by default.
    #[must_use]
    pub const fn with_largest_condition_number(mut self, number: f64) -> Self {
        self.largest_condition_number = number;
        self
    }

    /// Adds the equations Y π = τ − r of one instant, where τ are the forces that act in addition to the
    /// model's own.
    pub fn add<M, const N: usize>(
        &mut self,
        model: &M,
        state: &State<f64, N>,
        accelerations: &SVector<f64, N>,
        forces: &SVector<f64, N>,
    ) where
        M: Lagrangian<N, Model: Regressor<N, B>>,
    {
        self.add_weighted(model, state, accelerations, forces, &SVector::repeat(1.0));
    }

    /// Adds the equations of one instant, each divided by the standard deviation of its measured force.
    pub fn add_weighted<M, const N: usize>(
        &mut self,
        model: &M,
        state: &State<f64, N>,
        accelerations: &SVector<f64, N>,
        forces: &SVector<f64, N>,
        deviations: &SVector<f64, N>,
    ) where
        M: Lagrangian<N, Model: Regressor<N, B>>,
    {
        let regressor = model.regressor(state, accelerations);
        let right = forces - model.known_terms(state, accelerations);
        for i in 0..N {
            let row = SVector::from_fn(|b, _| regressor[(i, b)] / deviations[i]);
            self.add_equation(row, right[i] / deviations[i]);
        }
    }

    /// Adds the equations of one instant along [virtual displacements](crate::analysis::TangentBasis::virtual_displacements) V of a
    /// constrained model, Vᵀ Y π = Vᵀ (τ − r). With constraints M q̈ − f = τ + Gᵀ λ, and G V = 0 takes the unknown reactions out
    /// of the equations. Columns of zeros give no equations.
    ///
    /// What is known of the constraints has to be right, since V depends on it. Where the motion of a mechanism leaves combinations of
    /// its base parameters open, [`solve`](Self::solve) names one.
    pub fn add_along<M, const N: usize, const D: usize>(
        &mut self,
        model: &M,
        (state, accelerations): (&State<f64, N>, &SVector<f64, N>),
        forces: &SVector<f64, N>,
        directions: &SMatrix<f64, N, D>,
    ) where
        M: Lagrangian<N, Model: Regressor<N, B>>,
    {
        let regressor = model.regressor(state, accelerations);
        let right = forces - model.known_terms(state, accelerations);
        for direction in directions.column_iter() {
            if direction.iter().any(|entry| *entry != 0.0) {
                let row = SVector::from_fn(|b, _| regressor.column(b).dot(&direction));
                self.add_equation(row, right.dot(&direction));
            }
        }
    }

    /// Adds the equation row · π = right.
    pub fn add_equation(&mut self, mut row: SVector<f64, B>, mut right: f64) {
        if !(right.is_finite() && row.iter().all(|entry| entry.is_finite())) {
            self.not_finite = self.not_finite.or(Some(self.equations));
        }
        self.equations += 1;
        for k in 0..B {
            let length = length(self.factor[(k, k)], row[k]);
            if length == 0.0 {
                continue;
            }
            let (cosine, sine) = (self.factor[(k, k)] / length, row[k] / length);
            for j in k..B {
                let (x, y) = (self.factor[(k, j)], row[j]);
                self.factor[(k, j)] = cosine * x + sine * y;
                row[j] = cosine * y - sine * x;
            }
            let (x, y) = (self.right[k], right);
            self.right[k] = cosine * x + sine * y;
            right = cosine * y - sine * x;
        }
        self.residual += right * right;
    }

    /// Returns the base parameters that minimize the sum of the squares of the residuals.
    ///
    /// # Errors
    ///
    /// If there are too few equations, if one is not finite, or if the motion does not excite all base parameters.
    pub fn solve(&self) -> Result<Identified<B>, IdentificationError<B>> {
        if let Some(equation) = self.not_finite {
            return Err(IdentificationError::NotFinite { equation });
        }
        let equations = self.equations;
        if equations <= B {
            return Err(IdentificationError::TooFewEquations { equations });
        }
        // Columns of length 1 nearly minimize the condition number (van der Sluis 1969).
        let scales = SVector::<f64, B>::from_fn(|j, _| match self.factor.column(j).norm() {
            0.0 => 1.0,
            length => 1.0 / length,
        });
        let scaled = SMatrix::<f64, B, B>::from_fn(|i, j| self.factor[(i, j)] * scales[j]);
        let decomposition = SingularValues::of(scaled);
        let values: SVector<f64, B> = decomposition.values();
        let smallest = position_of(&values, |one, least| one < least);
        let largest = position_of(&values, |one, most| one > most);
        let condition_number = values[largest] / values[smallest];
        // NaN counts as too large.
        if condition_number.is_nan() || condition_number > self.largest_condition_number {
            let direction = decomposition.right.column(smallest).into_owned();
            return Err(IdentificationError::PoorExcitation {
                direction: direction
                    / direction[position_of(&direction, |one, most| one.abs() > most.abs())],
                names: self.names,
                condition_number,
            });
        }
        // π = D V Σ⁻² (U Σ)ᵀ Qᵀ (τ − r), and (YᵀY)⁻¹ = (D V Σ⁻¹) (D V Σ⁻¹)ᵀ.
        let along = SVector::<f64, B>::from_fn(|j, _| {
            decomposition.products.column(j).dot(&self.right) / (values[j] * values[j])
        });
        let roots = SMatrix::<f64, B, B>::from_fn(|i, j| {
            scales[i] * decomposition.right[(i, j)] / values[j]
        });
        let parameters = (decomposition.right * along).component_mul(&scales);
        #[allow(clippy::cast_precision_loss)] // Of 2⁵³ equations.
        let variance = self.residual / (equations - B) as f64;
        Ok(Identified {
            parameters,
            covariance: roots * roots.transpose() * variance,
            variance,
            condition_number,
            equations,
        })
    }
}

/// Returns √(x² + y²), even where the squares overflow or underflow.
fn length(x: f64, y: f64) -> f64 {
    let (most, least) = (x.abs().max(y.abs()), x.abs().min(y.abs()));
    if most == 0.0 {
        return 0.0;
    }
    let ratio = least / most;
    most * Scalar::sqrt(1.0 + ratio * ratio)
}

/// Returns the position of the component that comes before all others.
fn position_of<const B: usize>(vector: &SVector<f64, B>, before: fn(f64, f64) -> bool) -> usize {
    let mut position = 0;
    for (i, component) in vector.iter().enumerate() {
        if before(*component, vector[position]) {
            position = i;
        }
    }
    position
}
