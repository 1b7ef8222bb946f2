//! The linear-quadratic regulator.
//!
//! R. E. Kalman, *Contributions to the theory of optimal control*, Bol. Soc. Mat. Mexicana **5** (1960) 102–119; B. D.
//! O. Anderson and J. B. Moore, *Optimal Control: Linear Quadratic Methods*, 1990. Newton's method in double-double
//! arithmetic starts from the result of a doubling algorithm in `f64`. Where doubling does not find a stabilizing gain,
//! for example because an unstable mode has no cost, it starts from the sign of a matrix. The last step of Newton's
//! method shows whether the digits are reliable.

use nalgebra::{SMatrix, SVector};

use super::controllability::Controllability;
use super::eigenvalues::balancing;
use super::equilibrium::Variable;
use super::exceeds;
use super::lyapunov::{Square, lyapunov};
use super::regulator_error::RegulatorError;
use super::riccati;
use super::riccati_newton::{Riccati, Solution, largest_ratio};
use super::spectrum::{Spectrum, modulus};
use super::state_space::{DiscreteStateSpace, StateSpace, poles};
use super::symmetric_eigenvalues::symmetric_eigenvalues;
use super::tangent_space::selected;
use crate::limits::analysis::{BORDER, RICCATI_CHANGE, UNREACHED};
use crate::linalg::Factorization;
use crate::model::State;
use crate::scalar::{DoubleDouble, Scalar};

/// The linear-quadratic regulator u = u₀ − K (x − x₀).
///
/// x₀ is the state of the linearization, coordinates first, then velocities, as far as they are independent, and u₀ are its inputs. In the deviations x
/// and u from this point, the regulator minimizes ∫ xᵀ Q x + uᵀ R u dt, or in discrete time the sum Σ xᵀ Q x + uᵀ R u
/// over samples.
///
/// ```
/// use lagrangian::analysis::StateSpace;
/// use lagrangian::prelude::*;
/// use lagrangian::nalgebra::{Matrix1, Matrix2};
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
    /// The solution P of the Riccati equation: xᵀ P x is the cost of the motion that starts at x.
    pub cost: SMatrix<f64, D, D>,
    /// The eigenvalues of the closed loop A − B K.
    pub poles: Spectrum<D>,
    /// The relative residual of P in the Riccati equation: the largest entry, each in units of the terms of its row and
    /// its column.
    pub residual: f64,
    /// The coordinates and velocities x₀.
    pub state: SVector<f64, D>,
    /// The inputs u₀.
    pub inputs: SVector<f64, U>,
    /// The coordinates and velocities that the components of x are.
    pub variables: [Variable; D],
}

impl<const D: usize, const U: usize> Regulator<D, U> {
    /// Returns the inputs u = u₀ − K (x − x₀) at a state of the linearized model.
    ///
    /// A `D` larger than 2 `N` does not compile.
    #[must_use]
    pub fn input<const N: usize>(&self, state: &State<f64, N>) -> SVector<f64, U> {
        const {
            assert!(
                D <= 2 * N,
                "the regulator is for states of at most twice as many components as there are coordinates"
            );
        }
        let x = selected(&self.variables, &state.q, &state.v);
        self.inputs - self.gain * (x - self.state)
    }
}

/// The matrices of a regulator problem.
struct Problem<'a, const D: usize, const U: usize> {
    state: SVector<f64, D>,
    inputs: SVector<f64, U>,
    variables: [Variable; D],
    a: &'a SMatrix<f64, D, D>,
    b: &'a SMatrix<f64, D, U>,
    q: &'a SMatrix<f64, D, D>,
    r: &'a SMatrix<f64, U, U>,
    is_discrete: bool,
}

macro_rules! regulators {
    ($($(#[$documentation:meta])* $system:ident, $is_discrete:literal;)*) => {$(
        impl<const D: usize, const U: usize, const Y: usize> $system<f64, D, U, Y> {
            $(#[$documentation])*
            pub fn regulator(
                &self,
                state_weight: &SMatrix<f64, D, D>,
                input_weight: &SMatrix<f64, U, U>,
            ) -> Result<Regulator<D, U>, RegulatorError> {
                let problem = Problem {
                    state: self.state,
                    inputs: self.inputs,
                    variables: self.variables,
                    a: &self.a,
                    b: &self.b,
                    q: state_weight,
                    r: input_weight,
                    is_discrete: $is_discrete,
                };
                problem.solved()
            }
        }
    )*};
}

regulators! {
    /// Computes the regulator that minimizes ∫ xᵀ Q x + uᵀ R u dt, with Q positive semidefinite and R positive
    /// definite.
    ///
    /// If the point of linearization is not an equilibrium, it has to be held by additional inputs: f₀ is ignored.
    ///
    /// # Errors
    ///
    /// [`RegulatorError`] if a weight is not positive (semi)definite, if no input reaches an unstable mode, or if a
    /// mode that neither grows nor decays has no cost. States without a cost are allowed: with Q = 0, unstable modes
    /// are stabilized with the least effort.
    StateSpace, false;

    /// Computes the regulator that minimizes Σ xᵀ Q x + uᵀ R u over samples, with Q positive semidefinite and R
    /// positive definite.
    ///
    /// To approximate an integral, multiply its weights by the period.
    ///
    /// # Errors
    ///
    /// [`RegulatorError`] if a weight is not positive (semi)definite, if no input reaches an unstable mode, or if a
    /// mode that neither grows nor decays has no cost. States without a cost are allowed: with Q = 0, unstable modes
    /// are stabilized with the least effort.
    DiscreteStateSpace, true;
}

impl<const D: usize, const U: usize> Problem<'_, D, U> {
    fn solved(&self) -> Result<Regulator<D, U>, RegulatorError> {
        self.check_weights()?;
        if !self.a.iter().chain(self.b).all(|x| x.is_finite()) {
            return Err(RegulatorError::NotFinite);
        }
        // If the scales are very different, a reachable mode may seem unreachable; then a regulator that is found
        // decides.
        let checked = self.check_modes();
        let riccati = self.riccati();
        let starts: [&dyn Fn() -> Option<Square<D>>; 3] = [
            &|| checked.ok().and_then(|()| self.by_doubling()),
            &|| riccati.by_sign(),
            // The gain 0, for a stable plant.
            &|| Some(Square::zeros()),
        ];
        let mut least = f64::INFINITY;
        for start in starts {
            let solution = start().and_then(|cost| riccati.refined(&cost));
            let Some(solution) = solution else { continue };
            if exceeds(solution.change, RICCATI_CHANGE) {
                least = solution.change.min(least);
            } else if let Some(regulator) = self.rounded(&riccati, &solution)
                && (checked.is_ok() || self.is_certain(&regulator))
            {
                return Ok(regulator);
            }
        }
        checked?;
        Err(if least.is_finite() {
            RegulatorError::Inaccurate { change: least }
        } else {
            RegulatorError::NoConvergence
        })
    }

    fn riccati(&self) -> Riccati<D, U> {
        let [a, q] = [self.a, self.q].map(|matrix| matrix.map(DoubleDouble::from));
        Riccati {
            a,
            b: self.b.map(DoubleDouble::from),
            q,
            r: self.r.map(DoubleDouble::from),
            is_discrete: self.is_discrete,
        }
    }

    /// Returns the cost found by doubling in `f64`, from which Newton's method starts.
    fn by_doubling(&self) -> Option<Square<D>> {
        let Self { a, b, q, r, .. } = *self;
        let g = b * Factorization::new(*r).solve(&b.transpose());
        let g = (g + g.transpose()) * 0.5;
        let cost = if self.is_discrete {
            riccati::discrete(a, &g, q)
        } else {
            riccati::continuous(a, &g, q)
        };
        Some(cost?.map(DoubleDouble::from))
    }

    /// Returns the regulator of a solution, unless the rounded gain leaves a mode unstable.
    fn rounded(
        &self,
        riccati: &Riccati<D, U>,
        solution: &Solution<D, U>,
    ) -> Option<Regulator<D, U>> {
        let gain = solution.gain.map(Scalar::largest);
        let cost = solution.cost.map(Scalar::largest);
        let closed = riccati.closed(&gain.map(DoubleDouble::from));
        lyapunov(&closed, &Square::zeros(), self.is_discrete)?;
        Some(Regulator {
            gain,
            cost,
            poles: poles(&closed)?,
            residual: self.residual(&cost, &gain),
            state: self.state,
            inputs: self.inputs,
            variables: self.variables,
        })
    }

    /// Returns whether the closed loop remains stable under rounding errors of the system, in units in which it is
    /// balanced: no mode is stabilized merely by rounding errors of B.
    fn is_certain(&self, regulator: &Regulator<D, U>) -> bool {
        let Regulator { gain, poles, .. } = regulator;
        let closed = self.a - self.b * gain;
        let exponents = balancing(&closed);
        let terms = self.a.abs() + self.b.abs() * gain.abs();
        let balanced = SMatrix::<f64, D, D>::from_fn(|i, j| {
            libm::ldexp(terms[(i, j)], exponents[j] - exponents[i])
        });
        let rounding = UNREACHED * f64::EPSILON * balanced.norm();
        poles.iter().all(|pole| self.excess(*pole) < -rounding)
    }

    /// Returns the largest relative entry of the residual of P in the Riccati equation. Each entry is relative to the
    /// terms in its row and column, so that states with small and large costs count equally.
    fn residual(&self, cost: &SMatrix<f64, D, D>, gain: &SMatrix<f64, U, D>) -> f64 {
        let Self { a, b, q, .. } = *self;
        let [transposed, sizes] = [a.transpose(), cost.abs()];
        let absolute = transposed.abs();
        let (left, terms) = if self.is_discrete {
            let controlled = transposed * cost * b * gain;
            let left = transposed * cost * a - controlled - cost + q;
            let terms = absolute * sizes * a.abs() + controlled.abs() + sizes + q.abs();
            (left, terms)
        } else {
            let controlled = cost * b * gain;
            let left = transposed * cost + cost * a - controlled + q;
            let terms = absolute * sizes + sizes * a.abs() + controlled.abs() + q.abs();
            (left, terms)
        };
        largest_ratio::<D>(|i, j| {
            let size = libm::sqrt(terms[(i, i)]) * libm::sqrt(terms[(j, j)]);
            let entry = left[(i, j)].abs();
            (entry, entry / size.max(terms[(i, j)]))
        })
    }

    /// Returns the distance of an eigenvalue from the border of stability; negative if it is stable.
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
        let not_positive = |matrix, eigenvalue, zero_is_allowed| {
            Err(RegulatorError::NotPositive {
                matrix,
                eigenvalue,
                zero_is_allowed,
            })
        };
        match (of_states.iter().next(), of_inputs.iter().next()) {
            (Some(least), _) if *least < -rounding => {
                not_positive("the weight Q of states", *least, true)
            }
            (_, Some(least)) if least.is_nan() || *least <= 0.0 => {
                not_positive("the weight R of inputs", *least, false)
            }
            _ => Ok(()),
        }
    }

    /// Checks that the inputs stabilize all modes, and that modes on the border of stability have a cost.
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
