//! The search for equilibria and steady motions.

use nalgebra::SVector;

use super::balance::{Balance, FreeInputs, HeldInputs, Point};
use super::constrained_balance::OnConstraints;
use super::equilibrium::{Equilibrium, SearchReport, Variable};
use super::equilibrium_error::EquilibriumError;
use super::equilibrium_problem::EquilibriumProblem;
use super::jacobian_rows::Variables;
use super::levenberg_marquardt::descended;
use super::newton::Newton;
use super::tangent_error::TangentError;
use crate::integrate::SingleNumber;
use crate::limits::analysis::{EQUILIBRIUM_TOLERANCE, NEWTON_STEPS};
use crate::linalg::IntoVector;
use crate::model::{DirectionalDerivatives, Inputs, Lagrangian, Quantities, State, StateJacobian};
use crate::scalar::Scalar;

/// A search for equilibria, q̈ = 0 at q̇ = 0, and for steady motions (relative equilibria), in which only ignorable
/// coordinates move, with constant velocities.
///
/// The unknowns are all coordinates except the ignorable ones, on which nothing depends, unless
/// [`unknown`](Self::unknown) says otherwise. All other variables keep the values of the guess.
///
/// # Equilibria
///
/// ```
/// use lagrangian::analysis::EquilibriumSearch;
/// use lagrangian::prelude::*;
///
/// /// A bead on a hoop that turns about its vertical diameter.
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(theta),
///     kinetic = 0.5 * m * r.powi(2) * (dot(theta).powi(2) + (rate * sin(theta)).powi(2)),
///     potential = -m * g * r * cos(theta),
/// )]
/// struct Bead { m: f64, r: f64, g: f64, rate: f64 }
///
/// let bead = Bead { m: 0.1, r: 0.5, g: 9.81, rate: 6.0 };
/// let found = EquilibriumSearch::of(&bead).near(&State::new(0.0, [1.0], [0.0]))?;
/// assert!((found.state.q[0].cos() - 9.81 / (0.5 * 36.0)).abs() < 1e-14);
/// assert!(found.report.iterations < 10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Inputs that hold a configuration
///
/// ```
/// use lagrangian::analysis::{EquilibriumSearch, Variable};
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(theta),
///     kinetic = 0.5 * m * (l * dot(theta)).powi(2),
///     potential = m * g * l * sin(theta),
///     force(theta = torque),
/// )]
/// struct Arm { m: f64, l: f64, g: f64, #[lagrangian(input)] torque: f64 }
///
/// let arm = Arm { m: 2.0, l: 0.5, g: 9.81, torque: 0.0 };
/// let level = State::new(0.0, [0.0], [0.0]);
/// let held = EquilibriumSearch::trim(&arm)
///     .unknown(&[Variable::Input(Arm::TORQUE)])
///     .near(&level)?;
/// assert!((held.inputs[0] - 2.0 * 9.81 * 0.5).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Steady motions
///
/// A top precesses at a given inclination with a given momentum `I_s` ω₃ (4.11). Which of the solutions is found
/// depends on the guess.
///
/// ```
/// use lagrangian::analysis::{EquilibriumSearch, Variable};
/// use lagrangian::prelude::*;
/// use lagrangian::rigid_body::SteadyPrecession;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(phi, theta, psi),
///     kinetic = 0.5 * (i * (dot(phi).powi(2) * sin(theta).powi(2) + dot(theta).powi(2))
///         + i_s * (dot(phi) * cos(theta) + dot(psi)).powi(2)),
///     potential = mgl * cos(theta),
/// )]
/// struct Top { i: f64, i_s: f64, mgl: f64 }
///
/// let top = Top { i: 1.2, i_s: 0.5, mgl: 5.1 };
/// let (theta, spin) = (0.5_f64, 40.0);
/// let guess = State::new(0.0, [0.0, theta, 0.0], [0.2, 0.0, spin]);
/// let found = EquilibriumSearch::of(&top)
///     .unknown(&[Variable::Velocity(Top::PHI), Variable::Velocity(Top::PSI)])
///     .momentum(Top::PSI, top.i_s * spin)
///     .near(&guess)?;
/// let slope = -top.mgl * theta.sin();
/// let closed = SteadyPrecession::of_top(top.i, top.i_s, spin, theta, slope);
/// let SteadyPrecession::Two { slow, .. } = closed else { unreachable!() };
/// assert!((found.state.v[Top::PHI] - slow).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// There may be more or fewer unknowns than equations. Of several solutions, the search finds the one to which Newton
/// steps of minimal length lead; contradictory equations are an error.
///
/// Newton's method is damped. Where its path meets a singular Jacobian, the search restarts from the guess, minimizes
/// the accelerations in the sense of least squares, and continues with Newton's method from there.
///
/// On dual numbers, the result has derivatives by the parameters and by all other given values.
#[derive(Debug)]
pub struct EquilibriumSearch<B, S: Scalar, const N: usize, const U: usize> {
    problem: EquilibriumProblem<B, S, N, U>,
    /// The first variable that the model does not have.
    missing: Option<Variable>,
}

impl<'a, M, S, const N: usize> EquilibriumSearch<HeldInputs<'a, M>, S, N, 0>
where
    M: Lagrangian<N, S, Model: StateJacobian<N, S>> + ?Sized,
    S: SingleNumber,
{
    /// Searches for equilibria and steady motions of a model. If it has inputs, they are held at the values of its
    /// fields, or at the values given to [`with_inputs`](crate::Lagrangian::with_inputs).
    pub fn of(model: &'a M) -> Self {
        Self::about(HeldInputs(model))
    }
}

impl<'a, M, S, const N: usize, const U: usize> EquilibriumSearch<FreeInputs<'a, M>, S, N, U>
where
    M: Inputs<N, U, S> + StateJacobian<N, S> + ?Sized,
    S: SingleNumber,
{
    /// Searches for equilibria and steady motions of a model with inputs, some of which may be unknown. The fields of
    /// the model hold the guess of the inputs.
    pub fn trim(model: &'a M) -> Self {
        Self::about(FreeInputs(model))
    }
}

impl<'a, M, S, const N: usize, const C: usize>
    EquilibriumSearch<OnConstraints<'a, M, <M as Quantities<N, S>>::Inputs, S, C, 0>, S, N, 0>
where
    M: DirectionalDerivatives<N, C, S> + ?Sized,
    S: SingleNumber,
{
    /// Searches for equilibria and steady motions of a constrained model, with its inputs held, if it has some. The unknowns are all
    /// coordinates, unless [`unknown`](Self::unknown) says otherwise. What is not unknown keeps its value, and the rest meets the
    /// constraints.
    ///
    /// In a steady motion, coordinates move that have velocities in the guess, or unknown ones, and nothing else changes with time. They
    /// need not be ignorable, but nothing may depend on them where the constraints are met. Dependent velocities follow from the
    /// independent ones, which [`degrees_of_freedom`](Lagrangian::degrees_of_freedom) proposes, with those that are unknown among them.
    ///
    /// ```
    /// use lagrangian::analysis::EquilibriumSearch;
    /// use lagrangian::prelude::*;
    ///
    /// /// A load between the ends of two ropes, which are fixed at both sides.
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     coordinates(x, y),
    ///     kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    ///     potential = m * g * y,
    ///     constraint(rope = [x, y].norm() + [x - width, y].norm() - length),
    /// )]
    /// struct Load { m: f64, g: f64, width: f64, length: f64 }
    ///
    /// let load = Load { m: 2.0, g: 9.81, width: 3.0, length: 5.0 };
    /// let guess = State::new(0.0, [1.0, -1.0], [0.0; 2]);
    /// let found = EquilibriumSearch::constrained(&load).near(&guess)?;
    /// assert!((found.state.q - Vector2::new(1.5, -2.0)).norm() < 1e-14);
    /// // Both ropes carry half of the load, at a slope of 4/5.
    /// let pull = load.multipliers(&found.state)[0];
    /// assert!((pull + 9.81 / 0.8).abs() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// A conical pendulum, by its bob in a plane that turns:
    ///
    /// ```
    /// use lagrangian::analysis::{EquilibriumSearch, Variable};
    /// use lagrangian::prelude::*;
    ///
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     coordinates(phi, x, z),
    ///     kinetic = 0.5 * m * (dot(x).powi(2) + dot(z).powi(2) + (x * dot(phi)).powi(2)),
    ///     potential = m * g * z,
    ///     constraint(rod = [x, z].norm() - l),
    /// )]
    /// struct Conical { m: f64, g: f64, l: f64 }
    ///
    /// let bob = Conical { m: 2.0, g: 9.81, l: 0.5 };
    /// let guess = State::new(0.0, [0.0, 0.3, -0.4], [5.0, 0.0, 0.0]);
    /// let found = EquilibriumSearch::constrained(&bob)
    ///     .unknown(&[Variable::Velocity(Conical::PHI)])
    ///     .near(&guess)?;
    /// assert!((found.state.v[Conical::PHI].powi(2) - 9.81 / 0.4).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn constrained<L>(model: &'a L) -> Self
    where
        L: Lagrangian<N, S, Model = M> + ?Sized,
    {
        Self::in_all_coordinates(OnConstraints {
            model: model.model(),
            held: model.inputs(),
            inputs: SVector::zeros(),
            choose: |_, held| held.clone(),
        })
    }
}

impl<'a, M, S, const N: usize, const C: usize, const U: usize>
    EquilibriumSearch<OnConstraints<'a, M, SVector<S, U>, S, C, U>, S, N, U>
where
    M: DirectionalDerivatives<N, C, S> + Inputs<N, U, S> + ?Sized,
    S: SingleNumber,
{
    /// Searches for equilibria and steady motions of a constrained model with inputs, some of which may be unknown. The
    /// fields of the model hold the guess of the inputs.
    pub fn constrained_trim(model: &'a M) -> Self {
        Self::in_all_coordinates(OnConstraints {
            model,
            held: model.inputs(),
            inputs: model.inputs(),
            choose: |inputs, _| *inputs,
        })
    }
}

impl<B, S, const N: usize, const U: usize> EquilibriumSearch<B, S, N, U>
where
    B: Balance<S, N, U>,
    S: SingleNumber,
{
    fn about(model: B) -> Self {
        let mut unknown = Variables::zeros();
        unknown.positions =
            SVector::from_fn(|i, _| if B::IGNORABLE[i] { S::zero() } else { S::one() });
        let problem = EquilibriumProblem {
            model,
            unknown,
            momenta: [None; N],
            sizes: None,
            tolerance: EQUILIBRIUM_TOLERANCE * S::machine_epsilon(),
            max_iterations: NEWTON_STEPS,
        };
        Self {
            problem,
            missing: None,
        }
    }

    /// Also ignorable coordinates are unknown: constraints relate them to others.
    fn in_all_coordinates(model: B) -> Self {
        let mut search = Self::about(model);
        search.problem.unknown.positions.fill(S::one());
        search
    }

    /// Sets the unknown variables, instead of all coordinates that are not ignorable, or all of a constrained model.
    #[must_use]
    pub fn unknown(mut self, variables: &[Variable]) -> Self {
        self.problem.unknown = Variables::zeros();
        for variable in variables {
            let unknown = &mut self.problem.unknown;
            let entry = match *variable {
                Variable::Coordinate(i) => unknown.positions.get_mut(i),
                Variable::Velocity(i) => unknown.velocities.get_mut(i),
                Variable::Input(i) => unknown.inputs.get_mut(i),
            };
            match entry {
                Some(entry) => *entry = S::one(),
                None => self.missing = self.missing.or(Some(*variable)),
            }
        }
        self
    }

    /// Prescribes the momentum of an ignorable coordinate in a steady motion of a model without constraints. A velocity has to be
    /// unknown to make up for it.
    #[must_use]
    pub fn momentum(mut self, coordinate: usize, momentum: S) -> Self {
        match self.problem.momenta.get_mut(coordinate) {
            Some(entry) => *entry = Some(momentum),
            None => self.missing = self.missing.or(Some(Variable::Velocity(coordinate))),
        }
        self
    }

    /// Sets the accuracy of the unknowns relative to their sizes; 64 machine epsilons by default. The last correction
    /// is smaller than the accuracy.
    #[must_use]
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.problem.tolerance = tolerance;
        self
    }

    /// Sets the maximal number of Newton steps; 100 by default.
    #[must_use]
    pub fn max_iterations(mut self, count: usize) -> Self {
        self.problem.max_iterations = count;
        self
    }

    /// Sets the sizes of coordinates, velocities and inputs, in which steps and the condition are measured. By default,
    /// each size is the magnitude in the guess, or 1 if that is 0.
    #[must_use]
    pub fn sizes(
        mut self,
        coordinates: impl IntoVector<S, N>,
        velocities: impl IntoVector<S, N>,
        inputs: impl IntoVector<S, U>,
    ) -> Self {
        self.problem.sizes = Some(Variables {
            positions: coordinates.into_vector(),
            velocities: velocities.into_vector(),
            inputs: inputs.into_vector(),
        });
        self
    }

    /// Finds the equilibrium or steady motion to which Newton's method leads from a guess.
    ///
    /// # Errors
    ///
    /// [`EquilibriumError`], if the request is invalid or nothing is found; in the latter case it contains the last
    /// iterate.
    pub fn near(
        &self,
        guess: &State<S, N>,
    ) -> Result<Equilibrium<S, N, U>, EquilibriumError<S, N, U>> {
        self.check(guess)?;
        let start = self.start(guess);
        let Point { state, inputs, .. } = &start;
        let model = &self.problem.model;
        if let Some(reason @ TangentError::Acts { .. }) =
            model.unsteady(state, inputs, &start.independent)
        {
            return Err(EquilibriumError::NotSteady {
                last: Equilibrium {
                    state: *state,
                    inputs: *inputs,
                    report: SearchReport::default(),
                },
                reason,
            });
        }
        let failed = match Newton::new(&self.problem, &start).run() {
            Err(
                error @ (EquilibriumError::Stalled { .. } | EquilibriumError::NoConvergence { .. }),
            ) => error,
            result => return result,
        };
        let mut report = failed
            .last()
            .map_or_else(SearchReport::default, |last| last.report);
        // The Newton steps are counted anew.
        report.iterations = 0;
        let near = descended(&self.problem, &start, &mut report);
        Newton::new(&self.problem, &near).after(report).run()
    }

    /// Returns the point from which the search begins: what is given of the guess and meets the constraints, if it is found.
    fn start(&self, guess: &State<S, N>) -> Point<S, N, U> {
        let problem = &self.problem;
        let given = Point {
            state: *guess,
            inputs: problem.model.inputs(),
            independent: [true; N],
        };
        // Which velocities are independent is decided at a consistent configuration.
        let free = Point {
            independent: [false; N],
            ..given
        };
        let mut start = given;
        if let Some(consistent) = problem.corrected(free) {
            start.state.q = consistent.state.q;
        }
        let unknown: [bool; N] =
            core::array::from_fn(|i| problem.unknown.velocities[i].largest() > 0.0);
        let moving = core::array::from_fn(|i| {
            B::IGNORABLE[i] || unknown[i] || guess.v[i].largest().abs() > 0.0
        });
        start.independent = problem.model.independent(&start.state, [&moving, &unknown]);
        problem.corrected(start).unwrap_or(start)
    }

    fn check(&self, guess: &State<S, N>) -> Result<(), EquilibriumError<S, N, U>> {
        if let Some(variable) = self.missing {
            return Err(EquilibriumError::NoSuchVariable { variable });
        }
        if self.problem.unknown.largest() <= 0.0 {
            return Err(EquilibriumError::NoUnknown);
        }
        for (coordinate, name) in B::COORDINATES.into_iter().enumerate() {
            if B::CONSTRAINED && self.problem.momenta[coordinate].is_some() {
                return Err(EquilibriumError::NoConstantMomentum { name });
            }
            if B::CONSTRAINED || B::IGNORABLE[coordinate] {
                continue;
            }
            let velocity = guess.v[coordinate].largest();
            if velocity.abs() > 0.0 || self.problem.unknown.velocities[coordinate].largest() > 0.0 {
                return Err(EquilibriumError::Moving { name, velocity });
            }
            if self.problem.momenta[coordinate].is_some() {
                return Err(EquilibriumError::NoConstantMomentum { name });
            }
        }
        Ok(())
    }
}
