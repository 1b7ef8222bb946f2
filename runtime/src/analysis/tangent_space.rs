//! Perturbations of constrained states in independent coordinates and velocities.

use nalgebra::{SMatrix, SVector};

use super::equilibrium::Variable;
use super::tangent_choice::Chosen;
use super::tangent_error::{IndependentVariables, TangentError};
use super::tangents::{Tangents, check_finite};
use crate::integrate::SingleNumber;
use crate::linalg::largest;
use crate::model::{DirectionalDerivatives, Lagrangian, State};
use crate::scalar::Scalar;

/// The perturbations of a state that the constraints of a model allow, and a choice of the independent ones among them:
/// the variables of a linear model about the state ([`StateSpace::reduced`](crate::analysis::StateSpace::reduced)).
///
/// With h independent holonomic and k independent nonholonomic constraints, N − h coordinates and N − h − k velocities are
/// independent, and determine all others to first order (D. L. Peterson, G. Gede & M. Hubbard, *Symbolic linearization
/// of equations of motion of constrained multibody systems*, Multibody Syst. Dyn. **33** (2015) 143–161). Without a choice
/// [`degrees_of_freedom`](Lagrangian::degrees_of_freedom) proposes one. Variables are in the order of the coordinates of the
/// declaration: independent coordinates first, then independent velocities, of which there are `D` together.
///
/// The state meets the constraints, and is an equilibrium or a steady motion, unless [`along_motion`](Self::along_motion) allows others.
/// Coordinates that move in a steady motion, such as the angle of a wheel and its place on the road, are left out by
/// [`without`](Self::without).
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
///     constraint(rod = x.powi(2) + y.powi(2) - l.powi(2)),
/// )]
/// struct Pendulum { m: f64, g: f64, l: f64 }
///
/// let pendulum = Pendulum { m: 2.0, g: 9.81, l: 0.5 };
/// let hanging = State::new(0.0, [0.0, -0.5], [0.0; 2]);
/// let tangent = TangentSpace::at(&pendulum, &hanging);
/// // The one independent coordinate is x, for y does not change to first order.
/// let plant = StateSpace::<f64, 2, 0, 2>::reduced_free(&tangent)?;
/// assert!((plant.a[(1, 0)] + 9.81 / 0.5).abs() < 1e-13);
/// let poles = plant.poles().ok_or("no eigenvalues")?;
/// assert!((poles.radius() - (9.81_f64 / 0.5).sqrt()).abs() < 1e-13);
/// // The height determines nothing.
/// let refused = tangent.coordinates([Pendulum::Y]).basis::<2>();
/// assert!(refused.unwrap_err().to_string().contains("choose `x` in place of `y`"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
#[must_use = "the choice is used by `StateSpace::reduced` or `basis`"]
pub struct TangentSpace<'a, M: ?Sized, S: Scalar, const N: usize, const C: usize> {
    pub(super) model: &'a M,
    pub(super) state: State<S, N>,
    pub(super) chosen: Chosen<N>,
    pub(super) is_steady: bool,
    /// The first index of no coordinate.
    missing: Option<usize>,
}

/// The perturbations of all coordinates and velocities as linear functions of `D` independent variables x:
/// δq = `q` x and δq̇ = `v` x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TangentBasis<S: Scalar, const N: usize, const D: usize> {
    /// ∂qᵢ/∂xⱼ in row i, column j.
    pub q: SMatrix<S, N, D>,
    /// ∂q̇ᵢ/∂xⱼ in row i, column j.
    pub v: SMatrix<S, N, D>,
    /// The independent variables.
    pub variables: [Variable; D],
}

impl<S: Scalar, const N: usize, const D: usize> TangentBasis<S, N, D> {
    /// Returns the virtual displacements V, along which constraints do no work, G V = 0: the columns of `v` that belong to independent
    /// velocities, and columns of zeros for the independent coordinates.
    #[must_use]
    pub fn virtual_displacements(&self) -> SMatrix<S, N, D> {
        SMatrix::from_fn(|i, j| match self.variables[j] {
            Variable::Velocity(_) => self.v[(i, j)],
            _ => S::zero(),
        })
    }
}

impl<'a, M, S, const N: usize, const C: usize> TangentSpace<'a, M, S, N, C>
where
    M: Lagrangian<N, S, Model: DirectionalDerivatives<N, C, S>> + ?Sized,
    S: SingleNumber,
{
    /// The perturbations of a state that meets the constraints of a model.
    pub fn at(model: &'a M, state: &State<S, N>) -> Self {
        Self {
            model,
            state: *state,
            chosen: Chosen {
                coordinates: None,
                velocities: None,
                left_out: [false; N],
            },
            is_steady: true,
            missing: None,
        }
    }

    /// Sets the independent coordinates, besides those that are left out.
    pub fn coordinates(mut self, coordinates: impl IntoIterator<Item = usize>) -> Self {
        self.chosen.coordinates = Some(self.marked(coordinates));
        self
    }

    /// Sets the coordinates with independent velocities.
    pub fn velocities(mut self, coordinates: impl IntoIterator<Item = usize>) -> Self {
        self.chosen.velocities = Some(self.marked(coordinates));
        self
    }

    /// Leaves out coordinates on which the velocities and accelerations of the others do not depend, such as ignorable ones.
    /// Their velocities may be independent variables.
    pub fn without(mut self, coordinates: impl IntoIterator<Item = usize>) -> Self {
        self.chosen.left_out = self.marked(coordinates);
        self
    }

    /// Allows a state that is neither an equilibrium nor a steady motion. The linear model then changes along the motion, whose
    /// derivative f₀ is not zero.
    pub fn along_motion(mut self) -> Self {
        self.is_steady = false;
        self
    }

    /// Returns the perturbations of all coordinates and velocities as linear functions of the independent ones.
    ///
    /// # Errors
    ///
    /// [`TangentError`], with the names of what is not independent, not consistent or not steady.
    pub fn basis<const D: usize>(&self) -> Result<TangentBasis<S, N, D>, TangentError> {
        let tangents = Tangents::of(self)?;
        Ok(self.linearized(&tangents)?.0)
    }

    /// Returns the basis, and the state matrix in it.
    pub(super) fn linearized<const D: usize>(
        &self,
        tangents: &Tangents<'_, M::Model, S, N, C>,
    ) -> Result<(TangentBasis<S, N, D>, SMatrix<S, D, D>), TangentError> {
        let variables = tangents.variables::<D>()?;
        let mut basis = TangentBasis {
            q: SMatrix::zeros(),
            v: SMatrix::zeros(),
            variables,
        };
        let mut a = SMatrix::<S, D, D>::zeros();
        for (j, variable) in variables.into_iter().enumerate() {
            let direction = tangents.along(variable);
            basis.q.set_column(j, &direction.q);
            basis.v.set_column(j, &direction.v);
            let column = tangents.rates_along(&direction);
            a.set_column(j, &selected(&variables, &column.q, &column.v));
        }
        let largest = largest(&a);
        check_finite::<M::Model, S, N, C, D>(&variables, &a)?;
        tangents.check_left_out(&variables, largest)?;
        if self.is_steady {
            tangents.check_steady(&variables, largest)?;
        }
        Ok((basis, a))
    }

    /// Returns the space with the variables of these tangents, at any state near this one.
    pub(super) fn fixed(&self, tangents: &Tangents<'_, M::Model, S, N, C>) -> Self {
        let [coordinates, velocities] = tangents.independent();
        let chosen = Chosen {
            coordinates: Some(coordinates),
            velocities: Some(velocities),
            ..self.chosen
        };
        Self {
            chosen,
            is_steady: false,
            ..*self
        }
    }

    /// Returns the space with these choices at another state.
    pub(super) fn at_state(&self, state: &State<S, N>) -> Self {
        Self {
            state: *state,
            ..*self
        }
    }

    /// Returns the coordinates and velocities that determine others, as far as they are chosen.
    pub(super) fn held(&self) -> [[bool; N]; 2] {
        [self.chosen.coordinates, self.chosen.velocities].map(|marks| marks.unwrap_or([false; N]))
    }

    fn marked(&mut self, coordinates: impl IntoIterator<Item = usize>) -> [bool; N] {
        let mut marks = [false; N];
        for index in coordinates {
            match marks.get_mut(index) {
                Some(mark) => *mark = true,
                None => self.missing = self.missing.or(Some(index)),
            }
        }
        marks
    }

    pub(super) fn check_indices(&self) -> Result<(), TangentError> {
        let missing = self
            .missing
            .map(|index| TangentError::NoSuchCoordinate { index });
        missing.map_or(Ok(()), Err)
    }
}

/// Returns the components of coordinates and velocities that are variables.
pub(super) fn selected<S: Scalar, const N: usize, const D: usize>(
    variables: &[Variable; D],
    q: &SVector<S, N>,
    v: &SVector<S, N>,
) -> SVector<S, D> {
    let nothing = S::from_f64(f64::NAN);
    SVector::from_fn(|i, _| {
        let component = match variables[i] {
            Variable::Coordinate(i) => q.get(i),
            Variable::Velocity(i) => v.get(i),
            Variable::Input(_) => None,
        };
        component.copied().unwrap_or(nothing)
    })
}

impl IndependentVariables {
    pub(super) const fn of(self, level: [usize; 2]) -> usize {
        match self {
            Self::Coordinates => level[0],
            Self::Velocities => level[1],
        }
    }
}
