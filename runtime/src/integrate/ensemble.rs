//! Ensembles: many problems that are integrated by one method.

mod together;

#[cfg(feature = "alloc")]
use alloc::vec::Vec;

use super::dormand_prince::Dop853;
use super::dynamics::Dynamics;
use super::event::Watched;
use super::integrator::Integrator;
use super::observer::Observer;
use super::problem::{Found, Keep, Problem};
use super::reactions::Reactions;
use super::runge_kutta::RungeKutta;
use crate::scalar::Scalar;

/// Many problems that are integrated by one method.
///
/// Their initial values, parameters, inputs or control laws differ, and each has the events, samples, observers and
/// limits of its own [`Problem`].
///
/// [`Taylor`](crate::Taylor) integrates several members at once in SIMD lanes ([`InLanes`](crate::InLanes)), each with
/// its own steps and final time; when a member ends, its lane takes the next one. [`Dop853`] and [`RungeKutta`]
/// integrate one member after the other. Members do not affect each other: in two or more lanes, the result of a member
/// is the same to the last bit, whatever the others and their order. In one lane, and by [`Problem::solve`], its series
/// are summed in another order, and results differ by rounding. An error ends one member only, and is its result.
///
/// ```
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     taylor,
///     coordinates(theta),
///     kinetic = 0.5 * l.powi(2) * dot(theta).powi(2),
///     potential = -g * l * cos(theta),
///     event(bottom = theta),
/// )]
/// struct Pendulum { l: f64, g: f64 }
///
/// // A thousand lengths; each motion ends where it first passes the bottom.
/// let lengths = (0..1000).map(|i| 0.5 + 1e-3 * f64::from(i));
/// let swings = lengths.map(|l| {
///     Problem::new(Pendulum { l, g: 9.81 }, State::new(0.0, [1.0], [0.0]))
///         .on(Pendulum::BOTTOM)
///         .stop()
///         .save(Every(0.1))
/// });
/// let found = Ensemble::new(swings).solve(10.0, Taylor::new());
/// let [short, long] = [&found[0], &found[500]].map(|found| found.as_ref().expect("it is regular"));
/// assert!((long.t / short.t - 2.0_f64.sqrt()).abs() < 1e-13);
/// assert_eq!(long.samples().len(), 6);
/// ```
#[must_use = "an ensemble is integrated by `solve` or `solve_each`"]
#[derive(Clone, Debug)]
pub struct Ensemble<P, const L: usize = 4> {
    problems: P,
}

impl<P> Ensemble<P> {
    /// Creates an ensemble from problems: an iterator, an array or a `Vec`.
    pub fn new(problems: P) -> Self
    where
        P: IntoIterator,
    {
        Self { problems }
    }
}

impl<P, const L: usize> Ensemble<P, L> {
    /// Sets the number of SIMD lanes; methods without lanes ignore it. The default of 4 suits processors with AVX2, and
    /// 8 suits processors with AVX-512, when compiled with `-C target-cpu=native`.
    pub fn lanes<const M: usize>(self) -> Ensemble<P, M> {
        const { assert!(M > 0, "an ensemble has at least one lane") }
        Ensemble {
            problems: self.problems,
        }
    }

    /// Integrates each problem until its end, and passes its position and its result to `report`, in the order in which
    /// the problems end. `end` is a time for all problems, or a function of the position.
    ///
    /// At most as many problems are in progress as there are lanes. Nothing is allocated except for what the problems
    /// keep, and once for the terms of series.
    #[allow(clippy::needless_pass_by_value)] // By value, as in `Problem::solve`.
    pub fn solve_each<S, D, K, C, R, O, I>(
        self,
        end: impl Ends,
        method: I,
        report: impl FnMut(usize, Found<S, D::State, K::Kept>),
    ) where
        P: IntoIterator<Item = Problem<S, D, K, C, R, O>>,
        S: Scalar,
        D: Dynamics<S>,
        C: Watched<S, D>,
        R: Reactions<S, D>,
        O: Observer<D::State>,
        I: EnsembleIntegrator<S, D, L>,
        K: Keep<S, D, I::Stepper>,
    {
        let problems = self.problems.into_iter().enumerate();
        let members = problems.map(|(index, problem)| (problem, end.of(index)));
        method.solve_each(members, report);
    }

    /// Integrates each problem until its end, and returns the results in the order of the problems. A result is a
    /// solution, or an error with the solution up to it. `end` is a time for all problems, or a function of the
    /// position.
    #[cfg(feature = "alloc")]
    #[must_use]
    pub fn solve<S, D, K, C, R, O, I>(
        self,
        end: impl Ends,
        method: I,
    ) -> Vec<Found<S, D::State, K::Kept>>
    where
        P: IntoIterator<Item = Problem<S, D, K, C, R, O>>,
        S: Scalar,
        D: Dynamics<S>,
        C: Watched<S, D>,
        R: Reactions<S, D>,
        O: Observer<D::State>,
        I: EnsembleIntegrator<S, D, L>,
        K: Keep<S, D, I::Stepper>,
    {
        let mut ended = Vec::new();
        self.solve_each(end, method, |index, found| ended.push((index, found)));
        ended.sort_unstable_by_key(|(index, _)| *index);
        ended.into_iter().map(|(_, found)| found).collect()
    }
}

/// The final times of an ensemble: one for all problems, or a function of a problem's position.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say when the problems of an ensemble end",
    note = "write a time, `ensemble.solve(10.0, method)`, or a function of the position, `|index| 0.1 * index as f64`"
)]
pub trait Ends {
    /// Returns the final time of a problem.
    fn of(&self, index: usize) -> f64;
}

impl Ends for f64 {
    fn of(&self, _: usize) -> f64 {
        *self
    }
}

impl<F: Fn(usize) -> f64> Ends for F {
    fn of(&self, index: usize) -> f64 {
        self(index)
    }
}

/// A method that integrates an ensemble of problems with dynamics `D`, either one after the other or `L` at once.
pub trait EnsembleIntegrator<S: Scalar, D: Dynamics<S>, const L: usize>:
    Integrator<S, D> + Clone
{
    /// Integrates each problem until its end, and reports its position and its result.
    fn solve_each<K, C, R, O, Kept>(
        &self,
        members: impl Iterator<Item = (Problem<S, D, K, C, R, O>, f64)>,
        mut report: impl FnMut(usize, Found<S, D::State, Kept>),
    ) where
        C: Watched<S, D>,
        R: Reactions<S, D>,
        O: Observer<D::State>,
        K: Keep<S, D, Self::Stepper, Kept = Kept>,
    {
        for (index, (problem, end)) in members.enumerate() {
            report(index, problem.solve(end, self.clone()));
        }
    }
}

impl<S: Scalar, D: Dynamics<S>, const L: usize> EnsembleIntegrator<S, D, L> for Dop853 {}

impl<S: Scalar, D: Dynamics<S>, const STAGES: usize, const L: usize> EnsembleIntegrator<S, D, L>
    for RungeKutta<STAGES>
{
}
