//! Tangents of the manifold of states that meet the constraints, and the derivatives of the motion along them.

use nalgebra::{SMatrix, SVector};

use super::equilibrium::Variable;
use super::exceeds;
use super::reduced_equations::{Part, Reduced};
use super::small_oscillations::negligible;
use super::tangent_choice::{Choice, Chosen};
use super::tangent_error::{IndependentVariables, TangentError};
use super::tangent_space::TangentSpace;
use crate::integrate::SingleNumber;
use crate::linalg::{DependentColumns, Undetermined, column_widths, kept, largest};
use crate::model::{
    DegreesOfFreedom, DirectionalDerivatives, Lagrangian, Phase, Quantities, State,
};

/// The tangents at a state, for a checked choice of independent variables.
pub(super) struct Tangents<'a, M, S, const N: usize, const C: usize>
where
    M: DirectionalDerivatives<N, C, S> + ?Sized,
    S: SingleNumber,
{
    model: &'a M,
    state: State<S, N>,
    inputs: M::Inputs,
    choice: Choice<N>,
    /// The dependent coordinates as functions of the independent ones, and of the velocities.
    solvers: [DependentColumns<S, C, N>; 2],
}

impl<'a, M, S, const N: usize, const C: usize> Tangents<'a, M, S, N, C>
where
    M: DirectionalDerivatives<N, C, S> + ?Sized,
    S: SingleNumber,
{
    pub(super) fn of<L>(space: &TangentSpace<'a, L, S, N, C>) -> Result<Self, TangentError>
    where
        L: Lagrangian<N, S, Model = M> + ?Sized,
    {
        space.check_indices()?;
        let (model, inputs) = (space.model.model(), space.model.inputs());
        Self::at(model, &space.state, inputs, space.chosen)
    }

    /// Returns the tangents at a state and inputs.
    pub(super) fn at(
        model: &'a M,
        state: &State<S, N>,
        inputs: M::Inputs,
        chosen: Chosen<N>,
    ) -> Result<Self, TangentError> {
        let state = *state;
        let prepared = model.prepare();
        let names = <M as Quantities<N, S>>::CONSTRAINTS;
        if let Some((constraint, residual)) = model.violated_constraint(&state, &prepared) {
            return Err(TangentError::Inconsistent {
                constraint: names.get(constraint).copied().unwrap_or("?"),
                residual: residual.largest(),
            });
        }
        let freedom = DegreesOfFreedom::<N, C>::of(model, &state, [&chosen.kept(), &[false; N]]);
        check_regular(model, &state, &freedom)?;
        let choice = chosen.completed(&freedom)?;
        let jacobian = model.constraint_jacobian(&state, &prepared);
        let widths = column_widths(&jacobian, &model.mass_matrix(&state, &prepared).diagonal());
        let holonomic = kept(&jacobian, |i, _| i < M::HOLONOMIC);
        let solver = |jacobian: &SMatrix<S, C, N>, independent: &[bool; N], variables| {
            let found = DependentColumns::of(jacobian, &widths, independent);
            found.map_err(|undetermined| {
                not_independent::<M, S, N, C>(variables, undetermined, independent)
            })
        };
        let Choice {
            coordinates,
            velocities,
            ..
        } = &choice;
        let solvers = [
            solver(&holonomic, coordinates, IndependentVariables::Coordinates)?,
            solver(&jacobian, velocities, IndependentVariables::Velocities)?,
        ];
        Ok(Self {
            model,
            state,
            inputs,
            choice,
            solvers,
        })
    }

    /// Returns the independent variables that are not left out.
    pub(super) fn variables<const D: usize>(&self) -> Result<[Variable; D], TangentError> {
        let of_velocities = self.choice.velocities.iter().filter(|mark| **mark).count();
        let all = self.all_variables();
        let counts = [all.clone().count() - of_velocities, of_velocities];
        if counts[0] + counts[1] != D {
            return Err(TangentError::Dimension {
                given: D,
                variables: counts,
            });
        }
        let mut variables = [Variable::Coordinate(0); D];
        for (place, variable) in variables.iter_mut().zip(all) {
            *place = variable;
        }
        Ok(variables)
    }

    /// Returns the independent variables that are not left out, the coordinates first.
    pub(super) fn all_variables(&self) -> impl Iterator<Item = Variable> + Clone + use<M, S, N, C> {
        let Choice {
            coordinates,
            velocities,
            left_out,
        } = self.choice;
        let coordinates = (0..N).filter(move |i| coordinates[*i] && !left_out[*i]);
        let velocities = (0..N).filter(move |i| velocities[*i]);
        let coordinates = coordinates.map(Variable::Coordinate);
        coordinates.chain(velocities.map(Variable::Velocity))
    }

    /// Returns which coordinates and which velocities are independent.
    pub(super) const fn independent(&self) -> [[bool; N]; 2] {
        [self.choice.coordinates, self.choice.velocities]
    }

    /// Returns the roles of the coordinates in small oscillations.
    pub(super) fn parts(&self) -> Result<[Part; N], TangentError> {
        let Choice {
            coordinates,
            velocities,
            left_out,
        } = self.choice;
        let without_velocity = |i: &usize| coordinates[*i] && !left_out[*i] && !velocities[*i];
        if let Some(i) = (0..N).find(without_velocity) {
            let name = M::COORDINATES[i];
            return Err(TangentError::NoVelocity { name });
        }
        Ok(core::array::from_fn(|i| {
            match (velocities[i], coordinates[i] && !left_out[i]) {
                (true, true) => Part::Oscillating,
                (true, false) => Part::Moving,
                (false, _) => Part::Eliminated,
            }
        }))
    }

    pub(super) fn mass_matrix(&self) -> SMatrix<S, N, N> {
        self.model.mass_matrix(&self.state, &self.model.prepare())
    }

    /// Checks what is left out of small oscillations, and that they are about an equilibrium or a steady motion.
    pub(super) fn check(
        &self,
        parts: &[Part; N],
        reduced: &Reduced<S, N>,
        is_steady: bool,
    ) -> Result<(), TangentError> {
        let entries = reduced.position.iter().chain(reduced.velocity.iter());
        let largest = largest(entries).max(1.0);
        let all = (0..N).filter(|i| parts[*i] != Part::Eliminated);
        for i in all {
            let of_coordinate = (parts[i] == Part::Oscillating).then_some(Variable::Coordinate(i));
            let variables = [
                Variable::Velocity(i),
                of_coordinate.unwrap_or(Variable::Velocity(i)),
            ];
            self.check_left_out(&variables, largest)?;
            if is_steady {
                self.check_steady(&variables, largest)?;
            }
        }
        Ok(())
    }

    /// Returns the tangent along which one independent variable changes by 1, and the others do not.
    pub(super) fn along(&self, variable: Variable) -> Phase<S, N> {
        let unit = |i: usize| SVector::from_fn(|j, _| if i == j { S::one() } else { S::zero() });
        let zero = SVector::zeros();
        let [positions, velocities] = &self.solvers;
        match variable {
            Variable::Coordinate(i) => {
                let q = positions.completed(&unit(i), &SVector::zeros());
                let change = self.derivatives(&Phase::new(q, zero)).constraint_velocities;
                Phase::new(q, velocities.completed(&zero, &-change))
            }
            Variable::Velocity(i) => {
                let v = velocities.completed(&unit(i), &SVector::zeros());
                Phase::new(zero, v)
            }
            Variable::Input(_) => Phase::new(zero, zero),
        }
    }

    /// Returns the changes of the velocities and of the accelerations along a tangent.
    pub(super) fn rates_along(&self, direction: &Phase<S, N>) -> Phase<S, N> {
        Phase::new(direction.v, self.derivatives(direction).accelerations)
    }

    /// Returns the derivatives of the accelerations by an input.
    pub(super) fn by_input(&self, input: usize) -> SVector<S, N> {
        let derivatives = self
            .model
            .derivatives_by_input(&self.state, &self.inputs, input);
        derivatives.accelerations
    }

    /// Returns the velocities and the accelerations at the state.
    pub(super) fn rates(&self) -> Phase<S, N> {
        let prepared = self.model.prepare();
        let accelerations = self
            .model
            .accelerations(&self.state, &self.inputs, &prepared);
        Phase::new(self.state.v, accelerations)
    }

    pub(super) const fn state(&self) -> &State<S, N> {
        &self.state
    }

    fn derivatives(&self, direction: &Phase<S, N>) -> crate::model::MotionDerivatives<S, N, C> {
        let direction = direction.at_time(S::zero());
        self.model
            .derivatives_along(&self.state, &self.inputs, &direction)
    }

    /// Checks that coordinates which are left out act on no variable.
    pub(super) fn check_left_out(
        &self,
        variables: &[Variable],
        largest: f64,
    ) -> Result<(), TangentError> {
        for i in (0..N).filter(|i| self.choice.left_out[*i]) {
            self.check_acts(i, variables.iter().copied(), largest)?;
        }
        Ok(())
    }

    /// Checks that a coordinate which is left out acts on no variable.
    pub(super) fn check_acts(
        &self,
        coordinate: usize,
        variables: impl Iterator<Item = Variable>,
        largest: f64,
    ) -> Result<(), TangentError> {
        let column = self.rates_along(&self.along(Variable::Coordinate(coordinate)));
        for variable in variables {
            let slope = component(variable, &column).largest();
            if exceeds(slope.abs(), negligible::<S>() * largest) {
                return Err(TangentError::Acts {
                    coordinate: M::COORDINATES[coordinate],
                    on: name::<M, S, N, C>(variable),
                    slope,
                });
            }
        }
        Ok(())
    }

    /// Returns the largest derivative of the rates of the variables by the variables.
    pub(super) fn largest_slope(&self) -> f64 {
        let variables = self.all_variables();
        let columns = variables
            .clone()
            .map(|variable| self.rates_along(&self.along(variable)));
        columns.fold(0.0, |most: f64, column| {
            let entries = variables
                .clone()
                .map(|i| component(i, &column).largest().abs());
            entries.fold(most, f64::max)
        })
    }

    /// Checks that no variable changes with time.
    pub(super) fn check_steady(
        &self,
        variables: &[Variable],
        largest: f64,
    ) -> Result<(), TangentError> {
        let rates = self.rates();
        for variable in variables {
            let rate = component(*variable, &rates).largest();
            let name = name::<M, S, N, C>(*variable);
            if exceeds(rate.abs(), negligible::<S>() * largest) {
                return Err(match variable {
                    Variable::Coordinate(_) => TangentError::Moving {
                        name,
                        velocity: rate,
                    },
                    _ => TangentError::Accelerated {
                        name,
                        acceleration: rate,
                    },
                });
            }
        }
        Ok(())
    }
}

/// Checks that all derivatives of the variables are finite.
pub(super) fn check_finite<M, S, const N: usize, const C: usize, const D: usize>(
    variables: &[Variable; D],
    a: &SMatrix<S, D, D>,
) -> Result<(), TangentError>
where
    M: DirectionalDerivatives<N, C, S> + ?Sized,
    S: SingleNumber,
{
    let is_finite = |i: usize| a.row(i).iter().all(|x| x.abs().largest().is_finite());
    let found = (0..D).find(|i| !is_finite(*i));
    found.map_or(Ok(()), |i| {
        let name = name::<M, S, N, C>(variables[i]);
        Err(TangentError::NotFinite { name })
    })
}

/// Checks that as many constraints are independent at the state as nearby.
fn check_regular<M, S, const N: usize, const C: usize>(
    model: &M,
    state: &State<S, N>,
    freedom: &DegreesOfFreedom<N, C>,
) -> Result<(), TangentError>
where
    M: DirectionalDerivatives<N, C, S> + ?Sized,
    S: SingleNumber,
{
    let rank = N.saturating_sub(freedom.velocities);
    let mut prepared = model.prepare();
    model.fix_rank(state, &mut prepared);
    let noted = prepared.as_ref().last().map_or(0.0, |rank| rank.largest());
    let nearby = (0..=C).find(|count| {
        let count = u32::try_from(*count).unwrap_or(u32::MAX);
        f64::from(count) >= noted
    });
    let nearby = nearby.unwrap_or(C);
    if nearby <= rank {
        return Ok(());
    }
    let names = <M as Quantities<N, S>>::CONSTRAINTS;
    let dependent = freedom.redundant_constraints().next();
    let constraint = dependent.and_then(|i| names.get(i));
    Err(TangentError::Singular {
        constraint: constraint.copied().unwrap_or("?"),
        rank,
        nearby,
    })
}

fn not_independent<M, S, const N: usize, const C: usize>(
    variables: IndependentVariables,
    undetermined: Undetermined,
    independent: &[bool; N],
) -> TangentError
where
    M: DirectionalDerivatives<N, C, S> + ?Sized,
    S: SingleNumber,
{
    let Undetermined { free, bound, pivot } = undetermined;
    let bound = bound.or_else(|| independent.iter().position(|mark| *mark));
    TangentError::NotIndependent {
        variables,
        free: M::COORDINATES[free],
        bound: bound.map_or("?", |i| M::COORDINATES[i]),
        pivot,
    }
}

/// Returns a component of coordinates and velocities.
fn component<S: SingleNumber, const N: usize>(variable: Variable, of: &Phase<S, N>) -> S {
    match variable {
        Variable::Coordinate(i) => of.q[i],
        Variable::Velocity(i) => of.v[i],
        Variable::Input(_) => S::zero(),
    }
}

fn name<M, S, const N: usize, const C: usize>(variable: Variable) -> &'static str
where
    M: DirectionalDerivatives<N, C, S> + ?Sized,
    S: SingleNumber,
{
    match variable {
        Variable::Coordinate(i) | Variable::Velocity(i) => M::COORDINATES[i],
        Variable::Input(_) => "?",
    }
}
