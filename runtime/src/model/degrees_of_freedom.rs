//! The degrees of freedom of a constrained model.

use core::fmt::{self, Display, Formatter};

use nalgebra::{SMatrix, SVector};

use super::constraints::Constraints;
use super::state::State;
use crate::limits::assembly::NEGLIGIBLE_LEVERAGE;
use crate::linalg::{ColumnChoice, RowSpace, column_widths, kept};
use crate::scalar::Scalar;

/// The degrees of freedom of a model with `N` coordinates and `C` constraints at a state, and a choice of independent
/// coordinates and velocities; returned by [`Lagrangian::degrees_of_freedom`](crate::Lagrangian::degrees_of_freedom).
///
/// With h independent holonomic and k independent nonholonomic constraints, N − h coordinates and N − h − k velocities are
/// independent (D. L. Peterson, G. Gede & M. Hubbard, *Symbolic linearization of equations of motion of constrained multibody
/// systems*, Multibody Syst. Dyn. **33** (2015) 143–161). Which constraints depend on others is decided as by the equations of
/// motion. The dependent coordinates are chosen by pivoting, so that their columns of G M^(−1/2), with the diagonal of M, are
/// well-conditioned: units of coordinates and the scaling of constraints do not matter. Columns that are the
/// [same in all configurations](crate::quantities::Constraints::CONSTANT_COLUMNS) are chosen before others unless they are ten times as
/// short: of a disc that rolls, the velocities of its place follow from the rates of its angles, in whichever direction it rolls.
///
/// There is a [lower bound](crate::quantities::Constraints::MIN_DEGREES_OF_FREEDOM) everywhere. At a singular configuration
/// fewer constraints are independent than nearby, so that the numbers are larger there.
///
/// ```
/// use lagrangian::prelude::*;
///
/// /// A crank drives a slider along the x-axis by a connecting rod.
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(theta, phi, x),
///     kinetic = 0.5 * j * dot(theta).powi(2) + 0.5 * m * dot(x).powi(2) + 0.5 * i * dot(phi).powi(2),
///     constraint(pin = [r * cos(theta) + l * cos(phi) - x, r * sin(theta) + l * sin(phi)]),
/// )]
/// struct SliderCrank { j: f64, i: f64, m: f64, r: f64, l: f64 }
///
/// let mechanism = SliderCrank { j: 0.1, i: 0.02, m: 0.5, r: 0.1, l: 0.3 };
/// let guess = State::new(0.0, [1.0, -0.2, 0.3], [0.0; 3]);
/// let state = mechanism.assemble(guess).solve()?.state;
/// let freedom = mechanism.degrees_of_freedom(&state);
/// assert_eq!(freedom.velocities, 1);
/// println!("{freedom}"); // 1 degree of freedom in theta
/// // The coordinates that are independent determine the others.
/// let nearby = State::new(0.0, state.q.map(|q| q + 0.01), [0.0; 3]);
/// let found = mechanism.assemble(nearby).hold(freedom.independent_coordinates()).solve()?;
/// let independent = freedom.independent_coordinates().next().expect("there is one");
/// assert_eq!(found.state.q[independent], nearby.q[independent]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DegreesOfFreedom<const N: usize, const C: usize> {
    /// The number of independent coordinates, N less the rank of the holonomic constraints.
    pub coordinates: usize,
    /// The number of independent velocities, N less the rank of all constraints: the degrees of freedom.
    pub velocities: usize,
    dependent_coordinates: [bool; N],
    dependent_velocities: [bool; N],
    redundant: [bool; C],
    indeterminate: [bool; C],
    names: ([&'static str; N], [&'static str; C]),
}

impl<const N: usize, const C: usize> DegreesOfFreedom<N, C> {
    /// Proposes independent coordinates that contain those which are kept, as far as the constraints allow, and independent velocities among
    /// them, which contain those that are kept.
    pub(crate) fn of<M, S>(
        model: &M,
        state: &State<S, N>,
        [kept_coordinates, kept_velocities]: [&[bool; N]; 2],
    ) -> Self
    where
        M: Constraints<N, C, S> + ?Sized,
        S: Scalar,
    {
        let prepared = model.prepare();
        let mass = model.mass_matrix(state, &prepared).diagonal();
        let all = model.constraint_jacobian(state, &prepared);
        let holonomic = kept(&all, |i, _| i < M::HOLONOMIC);
        let holonomic = Rows::<N, C>::of(&holonomic, &mass);
        let all = Rows::<N, C>::of(&all, &mass);
        let constant = &<M as Constraints<N, C, S>>::CONSTANT_COLUMNS;
        let mut coordinates = ColumnChoice::new(holonomic.directions);
        for _ in 0..holonomic.rank {
            coordinates.choose_longest(kept_coordinates, constant);
        }
        let mut velocities = ColumnChoice::new(all.directions);
        for i in (0..N).filter(|i| coordinates.is_chosen[*i]) {
            velocities.choose(i);
        }
        for _ in holonomic.rank..all.rank {
            velocities.choose_longest(kept_velocities, constant);
        }
        Self {
            coordinates: N.saturating_sub(holonomic.rank),
            velocities: N.saturating_sub(all.rank),
            dependent_coordinates: coordinates.is_chosen,
            dependent_velocities: velocities.is_chosen,
            redundant: all.dependent,
            indeterminate: all.combinations,
            names: (M::COORDINATES, <M as Constraints<N, C, S>>::CONSTRAINTS),
        }
    }

    /// Returns which coordinates are independent, and which velocities.
    pub(crate) fn marks(&self) -> [[bool; N]; 2] {
        let dependent = [self.dependent_coordinates, self.dependent_velocities];
        dependent.map(|marks| marks.map(|is_dependent| !is_dependent))
    }

    /// The indices of coordinates that determine all others near this state, as
    /// [`Assembly::hold`](crate::assembly::Assembly::hold) takes them.
    pub fn independent_coordinates(&self) -> impl Iterator<Item = usize> + Clone + use<N, C> {
        indices(self.dependent_coordinates, false)
    }

    /// The indices of the coordinates whose velocities determine all other velocities, as
    /// [`Assembly::hold_velocities`](crate::assembly::Assembly::hold_velocities) takes them. They are among the
    /// independent coordinates.
    pub fn independent_velocities(&self) -> impl Iterator<Item = usize> + Clone + use<N, C> {
        indices(self.dependent_velocities, false)
    }

    /// The indices of constraints that follow from the others at this state. Which of several constraints that depend on each
    /// other are listed is a choice.
    pub fn redundant_constraints(&self) -> impl Iterator<Item = usize> + Clone + use<N, C> {
        indices(self.redundant, true)
    }

    /// The indices of constraints whose reactions the motion does not determine, since their gradients depend on the other
    /// gradients: all hinges of a door, of which one or two are redundant. Their multipliers are the least ones, weighed by the
    /// compliances that are declared. The reactions of all other constraints are unique.
    pub fn indeterminate_reactions(&self) -> impl Iterator<Item = usize> + Clone + use<N, C> {
        indices(self.indeterminate, true)
    }
}

/// The number of degrees of freedom with independent coordinates, and the constraints that are redundant, by their names.
impl<const N: usize, const C: usize> Display for DegreesOfFreedom<N, C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (coordinates, constraints) = &self.names;
        let plural = if self.velocities == 1 { "" } else { "s" };
        write!(f, "{} degree{plural} of freedom", self.velocities)?;
        list(f, " in ", coordinates, self.independent_velocities())?;
        let others = indices(self.dependent_coordinates, false);
        let others = others.filter(|i| self.dependent_velocities[*i]);
        list(
            f,
            "; independent coordinates without velocity: ",
            coordinates,
            others,
        )?;
        list(
            f,
            "; redundant: ",
            constraints,
            self.redundant_constraints(),
        )?;
        let indeterminate = self.indeterminate_reactions();
        list(
            f,
            "; reactions that are not unique: ",
            constraints,
            indeterminate,
        )
    }
}

/// Writes names, if there are any, behind a text.
fn list(
    f: &mut Formatter<'_>,
    text: &str,
    names: &[&str],
    indices: impl Iterator<Item = usize>,
) -> fmt::Result {
    for (count, name) in indices.filter_map(|i| names.get(i)).enumerate() {
        let before = if count == 0 { text } else { ", " };
        write!(f, "{before}{name}")?;
    }
    Ok(())
}

/// The rows of some constraints in the metric of M, at a state in the first lane.
struct Rows<const N: usize, const C: usize> {
    rank: usize,
    dependent: [bool; C],
    /// Which rows are combinations of others.
    combinations: [bool; C],
    /// An orthonormal basis.
    directions: SMatrix<f64, C, N>,
}

impl<const N: usize, const C: usize> Rows<N, C> {
    fn of<S: Scalar>(jacobian: &SMatrix<S, C, N>, mass: &SVector<S, N>) -> Self {
        let space = RowSpace::of(jacobian, mass);
        let dependent = core::array::from_fn(|i| space.dependent[i].in_lane(0) > 0.5);
        Self {
            rank: dependent.iter().filter(|dependent| !**dependent).count(),
            dependent,
            combinations: combinations(jacobian, mass),
            directions: SMatrix::from_fn(|i, j| space.directions[(i, j)].in_lane(0)),
        }
    }
}

/// Decides which rows are combinations of others: their leverage, the square of the projection of a unit vector onto the space of the
/// columns, is less than 1 (Hoaglin and Welsch, *The hat matrix in regression and ANOVA*, Am. Stat. **32** (1978) 17–22).
fn combinations<S: Scalar, const C: usize, const N: usize>(
    jacobian: &SMatrix<S, C, N>,
    mass: &SVector<S, N>,
) -> [bool; C] {
    let widths = column_widths(jacobian, mass);
    let columns = SMatrix::<f64, N, C>::from_fn(|j, i| {
        let row = (0..N).map(|j| (jacobian[(i, j)] / widths[j]).in_lane(0));
        let length = Scalar::sqrt(row.clone().map(|x| x * x).sum::<f64>());
        row.clone().nth(j).unwrap_or(0.0) / if length > 0.0 { length } else { 1.0 }
    });
    let space = RowSpace::of(&columns, &SVector::from_element(1.0));
    core::array::from_fn(|i| {
        let projection = space.directions.column(i).norm_squared();
        projection < 1.0 - NEGLIGIBLE_LEVERAGE
    })
}

/// The indices at which the marks have a value.
fn indices<const N: usize>(
    marks: [bool; N],
    value: bool,
) -> impl Iterator<Item = usize> + Clone + use<N> {
    let marks = marks.into_iter().enumerate();
    marks
        .filter(move |(_, mark)| *mark == value)
        .map(|(i, _)| i)
}
