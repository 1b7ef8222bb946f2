//! The members of a study: how each is integrated.

use std::fmt::Debug;

use lagrangian::problem::{EnsembleIntegrator, Keep, Observer, Reactions, Watched};
use lagrangian::{At, Dynamics, Partial, Problem, Solution, VectorSpace};

use crate::end::End;
use crate::error::Error;
use crate::points::Points;

/// The result of a member.
pub(crate) type Found<X, K> = Result<Solution<f64, X, K>, Partial<Solution<f64, X, K>>>;

/// The members of a study: points, the problem of each, their ends and the method. A bound of functions that are
/// generic over studies.
#[diagnostic::on_unimplemented(
    message = "it is not known how the members of `Study<{Self}>` are integrated",
    note = "`Study::new` makes the members of a study; a function that is generic over studies needs the bound `Members`"
)]
pub trait Members: Sync {
    /// The points.
    type Points: Points;
    /// The state of the system.
    type State: Send;
    /// What is kept of each motion ([`Problem::save`]).
    type Kept: Send;

    /// Returns the points.
    fn points(&self) -> &Self::Points;

    /// Integrates the members of these indices, and passes the position of each in `indices` and its result to
    /// `report`.
    fn integrate(
        &self,
        indices: impl Iterator<Item = usize>,
        report: impl FnMut(usize, Found<Self::State, Self::Kept>),
    );

    /// Returns the initial state of a member, its derivative, and its end.
    fn numbers(&self, index: usize) -> Vec<f64>;

    /// Describes how members are integrated: the type of their problems, the method with its settings, and the lanes.
    fn description(&self) -> [String; 2];

    /// Returns an error if the points are invalid or there are none.
    ///
    /// # Errors
    ///
    /// [`Error::Points`].
    fn check(&self) -> Result<(), Error> {
        let points = self.points();
        points.check()?;
        match points.count() {
            0 => Err(Error::NoMembers),
            _ => Ok(()),
        }
    }
}

/// Members that are integrated by one method, in `L` lanes if it has them.
#[derive(Clone, Debug)]
pub struct Integrated<P, F, E, I, const L: usize> {
    pub(crate) points: P,
    pub(crate) problem: F,
    pub(crate) end: E,
    pub(crate) method: I,
}

impl<P, F, E, I, D, K, C, R, O, const L: usize> Members for Integrated<P, F, E, I, L>
where
    P: Points,
    F: Fn(P::Point) -> Problem<f64, D, K, C, R, O> + Sync,
    E: End<P::Point> + Sync,
    I: EnsembleIntegrator<f64, D, L> + Debug + Sync,
    D: Dynamics<f64, State: Send>,
    C: Watched<f64, D>,
    R: Reactions<f64, D>,
    O: Observer<D::State>,
    K: Keep<f64, D, I::Stepper, Kept: Send>,
{
    type Points = P;
    type State = D::State;
    type Kept = K::Kept;

    fn points(&self) -> &P {
        &self.points
    }

    fn integrate(
        &self,
        indices: impl Iterator<Item = usize>,
        report: impl FnMut(usize, Found<D::State, K::Kept>),
    ) {
        let members = indices.map(|index| {
            let point = || self.points.point(index);
            ((self.problem)(point()), self.end.of(point))
        });
        EnsembleIntegrator::<f64, D, L>::solve_each(&self.method, members, report);
    }

    fn description(&self) -> [String; 2] {
        let problem = std::any::type_name::<Problem<f64, D, K, C, R, O>>();
        // In one lane, series are summed in another order than in several.
        let lanes = if L == 1 { "one lane" } else { "lanes" };
        [problem.to_owned(), format!("{:?}, {lanes}", self.method)]
    }

    fn numbers(&self, index: usize) -> Vec<f64> {
        let point = || self.points.point(index);
        let problem = (self.problem)(point());
        let At { t, x } = problem.initial_state();
        let rates = problem.dynamics().derivative(*t, x);
        // At rest, or in a symmetric state, some parameters have no effect. Each component is moved by another amount.
        let mut change = 0.1;
        let elsewhere = x.map(|component| {
            change *= 0.9;
            component + change
        });
        let rates_elsewhere = problem.dynamics().derivative(*t, &elsewhere);
        let numbers = x.components().chain(rates.components());
        let numbers = numbers.chain(rates_elsewhere.components());
        numbers.chain([*t, self.end.of(point)]).collect()
    }
}
