//! The equations that an equilibrium or a steady motion satisfies, and the choice of their unknowns.

use nalgebra::{SMatrix, SVector};

use super::balance::{Balance, Point, momentum_gradients};
use super::jacobian_rows::{JacobianRows, Residuals, Variables};
use crate::integrate::SingleNumber;
use crate::model::State;
use crate::scalar::Scalar;

/// The problem that a search solves, and the required accuracy.
#[derive(Debug)]
pub(super) struct EquilibriumProblem<B, S: Scalar, const N: usize, const U: usize> {
    pub(super) model: B,
    /// 1 for unknown variables, 0 for given ones.
    pub(super) unknown: Variables<S, N, U>,
    /// The prescribed momenta.
    pub(super) momenta: [Option<S>; N],
    /// The sizes in which steps are measured, if they are set.
    pub(super) sizes: Option<Variables<S, N, U>>,
    pub(super) tolerance: f64,
    pub(super) max_iterations: usize,
}

impl<B, S, const N: usize, const U: usize> EquilibriumProblem<B, S, N, U>
where
    B: Balance<S, N, U>,
    S: SingleNumber,
{
    /// Returns 1 for the unknowns in a search from a point, 0 for given variables. Dependent velocities follow from the others.
    fn unknown(&self, start: &Point<S, N, U>) -> Variables<S, N, U> {
        let velocities = &self.unknown.velocities;
        Variables {
            velocities: SVector::from_fn(|i, _| {
                if start.independent[i] {
                    velocities[i]
                } else {
                    S::one()
                }
            }),
            ..self.unknown
        }
    }

    /// Returns the sizes of the unknowns in a search from a point; 0 for given variables.
    pub(super) fn sizes(&self, start: &Point<S, N, U>) -> Variables<S, N, U> {
        let magnitudes = self.sizes.unwrap_or(Variables {
            positions: start.state.q,
            velocities: start.state.v,
            inputs: start.inputs,
        });
        magnitudes.zip_map(&self.unknown(start), |value, unknown| {
            let size = value.abs().largest();
            let size = if size > 0.0 { size } else { 1.0 };
            S::from_f64(size) * unknown
        })
    }

    /// Returns the point displaced by `factor · step`, where the step is measured in `sizes`, on the constraints of the model. It is
    /// not a number where no state nearby meets them.
    pub(super) fn moved(
        &self,
        point: &Point<S, N, U>,
        (step, factor): (&Variables<S, N, U>, f64),
        sizes: &Variables<S, N, U>,
    ) -> Point<S, N, U> {
        let moved = point.moved(step, factor, sizes);
        self.corrected(moved).unwrap_or_else(|| {
            let nothing = SVector::repeat(S::from_f64(f64::NAN));
            Point {
                state: State::new(moved.state.t, nothing, nothing),
                ..moved
            }
        })
    }

    /// Returns a point on the constraints of the model, with the given variables unchanged, if one is found.
    pub(super) fn corrected(&self, point: Point<S, N, U>) -> Option<Point<S, N, U>> {
        let is_given =
            |unknown: &SVector<S, N>| core::array::from_fn(|i| unknown[i].largest() <= 0.0);
        let unknown = self.unknown(&point);
        let held = [&unknown.positions, &unknown.velocities].map(is_given);
        let state = self.model.corrected(point.state, held)?;
        Some(Point { state, ..point })
    }

    /// Returns the accelerations, and the differences of the momenta from their prescribed values, or the corrections onto constraints. In
    /// place of dependent accelerations are the corrections of dependent velocities.
    pub(super) fn residuals(&self, point: &Point<S, N, U>) -> Residuals<S, N> {
        let accelerations = self.model.accelerations(&point.state, &point.inputs);
        if self.momenta.iter().all(Option::is_none) {
            let [positions, velocities] = self.model.corrections(&point.state, &point.independent);
            let accelerations = SVector::from_fn(|i, _| {
                if point.independent[i] {
                    accelerations[i]
                } else {
                    velocities[i]
                }
            });
            return [accelerations, positions];
        }
        let found = self.model.momenta(&point.state);
        let difference = |i: usize| self.momenta[i].map(|momentum| found[i] - momentum);
        let differences = SVector::from_fn(|i, _| difference(i).unwrap_or(S::zero()));
        [accelerations, differences]
    }

    /// Returns the rows of the Jacobian of the residuals by all variables.
    fn jacobian(&self, point: &Point<S, N, U>) -> [[Variables<S, N, U>; N]; 2] {
        let Point {
            state,
            inputs,
            independent,
        } = point;
        let row = |[by_positions, by_velocities]: [&SMatrix<S, N, N>; 2], i: usize| Variables {
            positions: by_positions.row(i).transpose(),
            velocities: by_velocities.row(i).transpose(),
            inputs: SVector::zeros(),
        };
        let slopes = self.model.linearize(state, inputs);
        let by_inputs = self.model.input_jacobian(state, inputs);
        let acceleration = |i: usize| Variables {
            inputs: by_inputs.row(i).transpose(),
            ..row([&slopes.position, &slopes.velocity], i)
        };
        if self.momenta.iter().all(Option::is_none) {
            let [of_positions, of_velocities] = self.model.correction_slopes(state, independent);
            let accelerations = core::array::from_fn(|i| {
                if independent[i] {
                    acceleration(i)
                } else {
                    row(of_velocities.each_ref(), i)
                }
            });
            let positions = core::array::from_fn(|i| row(of_positions.each_ref(), i));
            return [accelerations, positions];
        }
        let mass = self.model.mass_matrix(state);
        let gradients = momentum_gradients(&self.model, point);
        let momentum = |i: usize| self.momenta[i].map(|_| row([&gradients, &mass], i));
        let momenta = core::array::from_fn(|i| momentum(i).unwrap_or(Variables::zeros()));
        [core::array::from_fn(acceleration), momenta]
    }

    /// Returns the Jacobian at a point by the unknowns, in their sizes.
    pub(super) fn scaled_jacobian(
        &self,
        point: &Point<S, N, U>,
        sizes: &Variables<S, N, U>,
    ) -> JacobianRows<S, N, U> {
        let mut rows = self.jacobian(point);
        for row in rows.as_flattened_mut() {
            *row = row.zip_map(sizes, |slope, size| {
                if size.largest() > 0.0 {
                    slope * size
                } else {
                    S::zero()
                }
            });
        }
        JacobianRows::new(&rows)
    }
}
