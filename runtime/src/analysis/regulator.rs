//! The linear-quadratic regulator.
//!
//! R. E. Kalman, *Contributions to the theory of optimal control*, Bol. Soc. Mat. Mexicana **5** (1960) 102–119; B. D. O. Anderson and
//! J. B. Moore, *Optimal Control: Linear Quadratic Methods*, 1990.

use nalgebra::SMatrix;

use super::controllability::Controllability;
use super::exceeds;
use super::regulator_error::RegulatorError;
use super::riccati;
use super::spectrum::{Spectrum, modulus};
use super::state_space::{DiscreteStateSpace, StateSpace, poles};
use super::symmetric_eigenvalues::symmetric_eigenvalues;
use crate::limits::analysis::{BORDER, RICCATI_RESIDUAL};
use crate::linalg::Factorization;

/// The linear-quadratic regulator u = −K x, which minimizes ∫ xᵀ Q x + uᵀ R u dt, or the sum of the same over samples.
///
/// ```
/// use lagrangian::analysis::StateSpace;
/// use lagrangian::prelude::*;
/// use nalgebra::{Matrix1, Matrix2};
/// # use lagrangian::nalgebra;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), force(x = push))]
/// struct Cart { m: f64, #[lagrangian(input)] push: f64 }
///
/// let cart = Cart { m: 1.0, push: 0.0 };
/// let plant = StateSpace::<f64, 2, 1, 2>::of(&cart, &State::new(0.0, [0.0], [0.0]));
/// let regulator = plant.regulator(&Matrix2::identity(), &Matrix1::identity())?;
/// assert!((regulator.gain[0] - 1.0).abs() < 1e-14);
/// assert!((regulator.gain[1] - 3.0_f64.sqrt()).abs() < 1e-14);
/// # Ok::<(), lagrangian::analysis::RegulatorError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regulator<const D: usize, const U: usize> {
    /// The gain K.
    pub gain: SMatrix<f64, U, D>,
    /// The solution P of the Riccati equation: xᵀ P x is the cost from x on.
    pub cost: SMatrix<f64, D, D>,
    /// The eigenvalues of the closed loop A − B K.
    pub poles: Spectrum<D>,
    /// The norm of what P leaves of the Riccati equation, in relation to its terms.
    pub residual: f64,
}

/// The matrices of a regulator problem.
struct Problem<'a, const D: usize, const U: usize> {
    a: &'a SMatrix<f64, D, D>,
    b: &'a SMatrix<f64, D, U>,
    q: &'a SMatrix<f64, D, D>,
    r: &'a SMatrix<f64, U, U>,
    is_discrete: bool,
}

impl<const D: usize, const U: usize, const Y: usize> StateSpace<f64, D, U, Y> {
    /// The regulator that minimizes ∫ xᵀ Q x + uᵀ R u dt, with Q positive semidefinite and R positive definite.
    ///
    /// A point of linearization that is no equilibrium has to be held by other inputs: f₀ is left out.
    ///
    /// # Errors
    ///
    /// [`RegulatorError`]: weights that are none, or a mode that is not stabilized at any cost, or at none.
    pub fn regulator(
        &self,
        state_weight: &SMatrix<f64, D, D>,
        input_weight: &SMatrix<f64, U, U>,
    ) -> Result<Regulator<D, U>, RegulatorError> {
        let problem = Problem {
            a: &self.a,
            b: &self.b,
            q: state_weight,
            r: input_weight,
            is_discrete: false,
        };
        problem.solved()
    }
}

impl<const D: usize, const U: usize, const Y: usize> DiscreteStateSpace<f64, D, U, Y> {
    /// The regulator that minimizes Σ xᵀ Q x + uᵀ R u over samples, with Q positive semidefinite and R positive definite.
    ///
    /// For the weights of an integral, take them times the period, or nearly so.
    ///
    /// # Errors
    ///
    /// [`RegulatorError`]: weights that are none, or a mode that is not stabilized at any cost, or at none.
    pub fn regulator(
        &self,
        state_weight: &SMatrix<f64, D, D>,
        input_weight: &SMatrix<f64, U, U>,
    ) -> Result<Regulator<D, U>, RegulatorError> {
        let problem = Problem {
            a: &self.a,
            b: &self.b,
            q: state_weight,
            r: input_weight,
            is_discrete: true,
        };
        problem.solved()
    }
}

impl<const D: usize, const U: usize> Problem<'_, D, U> {
    fn solved(&self) -> Result<Regulator<D, U>, RegulatorError> {
        self.check_weights()?;
        self.check_modes()?;
        let Self { a, b, q, r, .. } = *self;
        let g = b * Factorization::new(*r).solve(&b.transpose());
        let g = (g + g.transpose()) * 0.5;
        let found = if self.is_discrete {
            riccati::discrete(a, &g, q)
        } else {
            riccati::continuous(a, &g, q)
        };
        let cost = found.ok_or(RegulatorError::NoConvergence)?;
        let gain = if self.is_discrete {
            let weight = r + b.transpose() * cost * b;
            Factorization::new(weight).solve(&(b.transpose() * cost * a))
        } else {
            Factorization::new(*r).solve(&(b.transpose() * cost))
        };
        let residual = self.residual(&cost, &gain);
        let poles = poles(&(a - b * gain)).ok_or(RegulatorError::NoConvergence)?;
        if exceeds(residual, RICCATI_RESIDUAL) || poles.iter().any(|pole| self.excess(*pole) >= 0.0)
        {
            return Err(RegulatorError::Inaccurate { residual });
        }
        Ok(Regulator {
            gain,
            cost,
            poles,
            residual,
        })
    }

    fn residual(&self, cost: &SMatrix<f64, D, D>, gain: &SMatrix<f64, U, D>) -> f64 {
        let Self { a, b, q, .. } = *self;
        let [free, controlled, start] = if self.is_discrete {
            let free = a.transpose() * cost * a;
            [free, a.transpose() * cost * b * gain, *cost]
        } else {
            let free = a.transpose() * cost + cost * a;
            [free, cost * b * gain, SMatrix::zeros()]
        };
        let left = free - controlled - start + q;
        left.norm() / (free.norm() + controlled.norm() + start.norm() + q.norm())
    }

    /// How far an eigenvalue is beyond the border of stability; negative if it is stable.
    fn excess(&self, eigenvalue: nalgebra::Complex<f64>) -> f64 {
        if self.is_discrete {
            modulus(eigenvalue) - 1.0
        } else {
            eigenvalue.re
        }
    }

    fn check_weights(&self) -> Result<(), RegulatorError> {
        let Self { q, r, .. } = *self;
        check_symmetric("the weight Q of states", q)?;
        check_symmetric("the weight R of inputs", r)?;
        let (of_states, _) = symmetric_eigenvalues(q, D);
        let (of_inputs, _) = symmetric_eigenvalues(r, U);
        let rounding = 64.0 * f64::EPSILON * of_states.amax();
        if let Some(least) = of_states.iter().next().filter(|least| **least < -rounding) {
            return Err(RegulatorError::NotPositive {
                matrix: "the weight Q of states",
                eigenvalue: *least,
                zero_is_allowed: true,
            });
        }
        if let Some(least) = of_inputs
            .iter()
            .next()
            .filter(|least| least.is_nan() || **least <= 0.0)
        {
            return Err(RegulatorError::NotPositive {
                matrix: "the weight R of inputs",
                eigenvalue: *least,
                zero_is_allowed: false,
            });
        }
        Ok(())
    }

    /// Whether inputs stabilize all modes, and whether those on the border of stability have a cost.
    fn check_modes(&self) -> Result<(), RegulatorError> {
        let Self { a, b, q, .. } = *self;
        let open = poles(a).ok_or(RegulatorError::NotFinite)?;
        if !b.iter().chain(q).all(|x| x.is_finite()) {
            return Err(RegulatorError::NotFinite);
        }
        let border = if self.is_discrete {
            BORDER
        } else {
            BORDER * open.radius()
        };
        let controllability = Controllability::of(a, b);
        let unreached = controllability.uncontrollable();
        let unreached = unreached.ok_or(RegulatorError::NoConvergence)?;
        let unstable = unreached.iter().find(|x| self.excess(**x) >= -border);
        if let Some(eigenvalue) = unstable {
            let mode = controllability.mode(*eigenvalue);
            return Err(RegulatorError::NotStabilizable { mode });
        }
        let observability = Controllability::of(&a.transpose(), q);
        let unseen = observability.uncontrollable();
        let unseen = unseen.ok_or(RegulatorError::NoConvergence)?;
        let mut on_border = unseen.iter().filter(|x| self.excess(**x).abs() <= border);
        match on_border.next() {
            Some(eigenvalue) => Err(RegulatorError::NoCost {
                mode: observability.mode(*eigenvalue),
            }),
            None => Ok(()),
        }
    }
}

fn check_symmetric<const K: usize>(
    name: &'static str,
    matrix: &SMatrix<f64, K, K>,
) -> Result<(), RegulatorError> {
    for i in 0..K {
        for j in 0..i {
            let [entry, opposite] = [matrix[(i, j)], matrix[(j, i)]];
            if exceeds(
                (entry - opposite).abs(),
                64.0 * f64::EPSILON * matrix.amax(),
            ) {
                return Err(RegulatorError::NotSymmetric {
                    matrix: name,
                    row: i,
                    column: j,
                    difference: entry - opposite,
                });
            }
        }
    }
    Ok(())
}
