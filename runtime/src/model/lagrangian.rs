//! Models, as programs see them.

use nalgebra::{SMatrix, SVector};

use super::assembly::Assembly;
use super::canonical_equations::CanonicalEquations;
use super::canonical_phase::CanonicalPhase;
use super::constraints::Constraints;
use super::degrees_of_freedom::DegreesOfFreedom;
use super::energy_balance::EnergyBalance;
use super::equations_of_motion::EquationsOfMotion;
use super::events::Events;
use super::generalized_coordinates::GeneralizedCoordinates;
use super::hamiltonian::{Hamiltonian, NoVelocities};
use super::impacts::{self, Impacts};
use super::inputs::Inputs;
use super::legendre;
use super::linearization::Linearization;
use super::outputs::Outputs;
use super::quantities::{Energies, Quantities};
use super::regressor::Regressor;
use super::sensitivities::{MultiplierSensitivities, Sensitivities};
use super::state::State;
use super::state_jacobian::StateJacobian;
use super::with_inputs::WithInputs;
use crate::integrate::DeclaredEvent;
use crate::linalg::IntoVector;
use crate::scalar::Scalar;

/// A model with the equations of motion of Lagrange, d/dt (∂L/∂q̇) − ∂L/∂q = Q (4.6), at its parameters and inputs.
///
/// `#[derive(Lagrangian)]` implements it. All methods are functions of the state and the parameters, do not allocate, and
/// return NaN or infinity where the declaration has no value. Inputs have the values of their fields, or those of
/// [`with_inputs`](Self::with_inputs). Some methods need a clause of the declaration; without it the compiler says which.
pub trait Lagrangian<const N: usize, S: Scalar = f64>: GeneralizedCoordinates<N> {
    /// The type with the equations: the struct of the declaration.
    type Model: Quantities<N, S>;

    /// The model with the equations.
    fn model(&self) -> &Self::Model;

    /// The values of the inputs.
    #[inline]
    fn inputs(&self) -> <Self::Model as Quantities<N, S>>::Inputs {
        self.model().inputs()
    }

    /// The Lagrangian function L = T − V.
    #[inline]
    fn lagrangian(&self, state: &State<S, N>) -> S {
        let model = self.model();
        model.lagrangian(state, &self.inputs(), &model.prepare())
    }

    /// The energy function h = Σ pᵢ q̇ᵢ − L: conserved where L does not contain the time and no generalized force does work.
    /// It is T + V only if T is quadratic in q̇ and V does not contain q̇.
    #[inline]
    fn energy(&self, state: &State<S, N>) -> S {
        self.model().energy(state, &self.inputs())
    }

    /// The kinetic energy T, if the declaration has the clauses `kinetic` and `potential`.
    #[inline]
    fn kinetic_energy(&self, state: &State<S, N>) -> S
    where
        Self::Model: Energies<N, S>,
    {
        self.model().kinetic_energy(state, &self.inputs())
    }

    /// The potential energy V, generalized if it contains velocities, if the declaration has the clauses `kinetic` and
    /// `potential`.
    #[inline]
    fn potential_energy(&self, state: &State<S, N>) -> S
    where
        Self::Model: Energies<N, S>,
    {
        self.model().potential_energy(state, &self.inputs())
    }

    /// The generalized momenta p = ∂L/∂q̇.
    #[inline]
    fn momenta(&self, state: &State<S, N>) -> SVector<S, N> {
        let model = self.model();
        model.momenta(state, &model.prepare())
    }

    /// The mass matrix M = ∂²L/∂q̇².
    #[inline]
    fn mass_matrix(&self, state: &State<S, N>) -> SMatrix<S, N, N> {
        let model = self.model();
        model.mass_matrix(state, &model.prepare())
    }

    /// The forcing f in M q̈ = f: all terms of the equations of motion but M q̈.
    #[inline]
    fn forcing(&self, state: &State<S, N>) -> SVector<S, N> {
        let model = self.model();
        model.forcing(state, &self.inputs(), &model.prepare())
    }

    /// The generalized forces Q, from the clauses `force` and `dissipation`.
    #[inline]
    fn generalized_forces(&self, state: &State<S, N>) -> SVector<S, N> {
        self.model().generalized_forces(state, &self.inputs())
    }

    /// The accelerations q̈. In a loop, [`dynamics`](Self::dynamics) has them without computing again what depends on
    /// parameters alone.
    #[inline]
    fn accelerations(&self, state: &State<S, N>) -> SVector<S, N> {
        let model = self.model();
        model.accelerations(state, &self.inputs(), &model.prepare())
    }

    /// Inverse dynamics: the generalized forces M q̈ − f that must be added to the declared ones, at the inputs, for these
    /// accelerations. Where the inputs are 0 and no other forces act, they are the forces of the actuators.
    #[inline]
    fn inverse_dynamics(
        &self,
        state: &State<S, N>,
        accelerations: &SVector<S, N>,
    ) -> SVector<S, N> {
        let model = self.model();
        model.inverse_dynamics(state, &self.inputs(), accelerations, &model.prepare())
    }

    /// The multipliers λ in d/dt (∂L/∂q̇) − ∂L/∂q = Q + Gᵀ λ, for each component of the
    /// [constraints](crate::quantities::Constraints), if the declaration has some. Where constraints depend on each other, λ
    /// is not unique, and the [compliances](crate::quantities::Constraints::compliances) choose one.
    #[inline]
    fn multipliers<const C: usize>(&self, state: &State<S, N>) -> SVector<S, C>
    where
        Self::Model: Constraints<N, C, S>,
    {
        let (model, inputs) = (self.model(), self.inputs());
        let prepared = model.prepare();
        model
            .accelerations_and_multipliers(state, &inputs, &prepared)
            .1
    }

    /// G = ∂w/∂q̇ of the constraints, with a row for each component.
    #[inline]
    fn constraint_jacobian<const C: usize>(&self, state: &State<S, N>) -> SMatrix<S, C, N>
    where
        Self::Model: Constraints<N, C, S>,
    {
        let model = self.model();
        model.constraint_jacobian(state, &model.prepare())
    }

    /// The residuals of the constraints: g(q, t) of the holonomic ones, with 0 for the others, and w = G q̇ + a. Both vanish
    /// at a consistent state.
    #[inline]
    fn constraint_residuals<const C: usize>(
        &self,
        state: &State<S, N>,
    ) -> (SVector<S, C>, SVector<S, C>)
    where
        Self::Model: Constraints<N, C, S>,
    {
        let model = self.model();
        let prepared = model.prepare();
        let positions = model.constraint_positions(state, &prepared);
        (positions, model.constraint_velocities(state, &prepared))
    }

    /// The [degrees of freedom](DegreesOfFreedom) at a state, and coordinates that are independent there; of several lanes,
    /// the first counts.
    fn degrees_of_freedom<const C: usize>(&self, state: &State<S, N>) -> DegreesOfFreedom<N, C>
    where
        Self::Model: Constraints<N, C, S>,
    {
        DegreesOfFreedom::of(self.model(), state, [&[false; N]; 2])
    }

    /// The search ([`Assembly`]) for a state that meets the constraints: `model.assemble(guess).solve()?.state`.
    fn assemble<const C: usize>(&self, guess: State<S, N>) -> Assembly<'_, Self::Model, S, N, C>
    where
        Self::Model: Constraints<N, C, S>,
    {
        Assembly::new(self.model(), guess)
    }

    /// The state after an impact at an event, whose function of coordinates and time is the distance of two bodies: the velocity
    /// of approach changes its sign and is multiplied by the coefficient of restitution, by an impulse along the gradient of the
    /// function. All velocities that the mass matrix or constraints couple with it change, too. [`Impacts`] has an example.
    fn impact(
        &self,
        state: &State<S, N>,
        event: DeclaredEvent<Self::Model>,
        restitution: f64,
    ) -> State<S, N>
    where
        Self::Model: Impacts<N, S>,
    {
        let restitution = S::from_f64(restitution);
        impacts::impact(self.model(), state, event.index(), restitution)
    }

    /// The derivatives of the accelerations with respect to q, q̇ and t, at constant inputs.
    ///
    /// In the first-order form ẋ = A x + B u, x = (q, q̇), they are the lower rows of A, below (0 1); the lower rows of B are
    /// [`input_jacobian`](Self::input_jacobian).
    ///
    /// For more than a few coupled coordinates they are solved for with a numerical factorization of M. Near a singularity
    /// of M their accuracy is then what [`relative_pivots`](crate::Factorization::relative_pivots) says.
    #[inline]
    fn linearize(&self, state: &State<S, N>) -> Linearization<S, N>
    where
        Self::Model: StateJacobian<N, S>,
    {
        self.model().linearize(state, &self.inputs())
    }

    /// For each coordinate, a measure of the conditioning of M q̈ = f: near 1 if it is well-conditioned,
    /// 0 or NaN if M is singular. Its inverse estimates the factor by which the rounding errors of what is solved
    /// are amplified in [`accelerations`](Self::accelerations); those of the forcing are not part of it.
    ///
    /// It looks at how the accelerations are solved for: each pivot is compared with the terms whose rounding errors it has.
    /// Through quasi-velocities w = E q̇ the pivots are the determinants of the diagonal blocks of E, such as sin θ, and the
    /// pivots of their inertia; for articulated bodies those of the elimination along the tree; else those of the
    /// factorization of M. Of several pivots of one coordinate it is the product. Where M is indefinite and regular, as for
    /// ẋ ẏ, and is factored numerically, it is the reciprocal of (|M⁻¹| |M|)ᵢᵢ.
    #[inline]
    fn relative_pivots(&self, state: &State<S, N>) -> SVector<S, N> {
        let model = self.model();
        model.relative_pivots(state, &model.prepare())
    }

    /// The derivatives ∂q̈ᵢ/∂uⱼ by the inputs in row i, column j.
    #[inline]
    fn input_jacobian<const U: usize>(&self, state: &State<S, N>) -> SMatrix<S, N, U>
    where
        Self::Model: Inputs<N, U, S>,
    {
        self.model().input_jacobian(state, &self.inputs())
    }

    /// All outputs at a state, if the declaration has the clause `output`: a struct with a field for each. Accelerations in
    /// them are [`accelerations`](Self::accelerations).
    #[inline]
    fn outputs(&self, state: &State<S, N>) -> <Self::Model as Outputs<N, S>>::Outputs
    where
        Self::Model: Outputs<N, S>,
    {
        self.model().outputs(state, &self.inputs())
    }

    /// The values of the event functions, if the declaration has the clause `event`.
    #[inline]
    fn event_functions(&self, state: &State<S, N>) -> <Self::Model as Events<N, S>>::EventValues
    where
        Self::Model: Events<N, S>,
    {
        let model = self.model();
        model.event_functions(state, &self.inputs(), &model.prepare())
    }

    /// The regressor Y(q, q̇, q̈, t) in M q̈ − f = Y π + r, whose columns belong to the base parameters π, if the declaration
    /// has the clause `regressor`.
    #[inline]
    fn regressor<const B: usize>(
        &self,
        state: &State<S, N>,
        accelerations: &SVector<S, N>,
    ) -> SMatrix<S, N, B>
    where
        Self::Model: Regressor<N, B, S>,
    {
        self.model().regressor(state, &self.inputs(), accelerations)
    }

    /// r = M q̈ − f − Y π, which contains no unknown parameter, if the declaration has the clause `regressor`.
    #[inline]
    fn known_terms<const B: usize>(
        &self,
        state: &State<S, N>,
        accelerations: &SVector<S, N>,
    ) -> SVector<S, N>
    where
        Self::Model: Regressor<N, B, S>,
    {
        self.model()
            .known_terms(state, &self.inputs(), accelerations)
    }

    /// The base parameters π that the parameters of this model give, if the declaration has the clause `regressor`.
    #[inline]
    fn base_parameters<const B: usize>(&self) -> SVector<S, B>
    where
        Self::Model: Regressor<N, B, S>,
    {
        self.model().base_parameters()
    }

    /// The derivatives ∂q̈ᵢ/∂πⱼ by parameters in row i, column j, at fixed q, q̇, t and inputs, if the declaration has the
    /// clause `sensitivities`.
    #[inline]
    fn sensitivities<const P: usize>(&self, state: &State<S, N>) -> SMatrix<S, N, P>
    where
        Self::Model: Sensitivities<N, P, S>,
    {
        self.model().sensitivities(state, &self.inputs())
    }

    /// The derivatives ∂λᵢ/∂πⱼ of the multipliers by parameters in row i, column j, if the declaration has constraints and the clause
    /// `sensitivities`. The state is fixed, also where a parameter, such as a length, moves a constraint away from it. Of reactions that
    /// are not [unique](DegreesOfFreedom::indeterminate_reactions), they have no meaning.
    #[inline]
    fn multiplier_sensitivities<const C: usize, const P: usize>(
        &self,
        state: &State<S, N>,
    ) -> SMatrix<S, C, P>
    where
        Self::Model: MultiplierSensitivities<N, C, P, S>,
    {
        let (model, inputs) = (self.model(), self.inputs());
        model
            .accelerations_and_multipliers_by_parameters(state, &inputs)
            .1
    }

    /// The rate Q·q̇ − ∂L/∂t of the energy function h along every motion: the power of the generalized forces, and what
    /// supports that move by themselves, and parameters that depend on time, put into the system (Whittaker, Analytical
    /// Dynamics, 1937, section 41). The declaration has the clause `energy_balance`.
    #[inline]
    fn energy_rate(&self, state: &State<S, N>) -> S
    where
        Self::Model: EnergyBalance<N, S>,
    {
        self.model().energy_rate(state, &self.inputs())
    }

    /// The power Q·q̇ of the generalized forces.
    #[inline]
    fn power(&self, state: &State<S, N>) -> S {
        self.generalized_forces(state).dot(&state.v)
    }

    /// The rates of the momenta, ṗ = ∂L/∂q + Q, at constant velocities, if the declaration has the clause `hamiltonian`.
    #[inline]
    fn momentum_rates(&self, state: &State<S, N>) -> SVector<S, N>
    where
        Self::Model: Hamiltonian<N, S>,
    {
        let model = self.model();
        model.momentum_rates(state, &self.inputs(), &model.prepare())
    }

    /// The velocities that have these momenta at a time, p = ∂L/∂q̇ solved for q̇ (the Legendre transformation), if the
    /// declaration has the clause `hamiltonian`.
    ///
    /// Where L is quadratic in the velocities, M(q, t) q̇ = p − p(q, 0, t) is solved with the factors of the accelerations, or M
    /// is factored here, and it is solved once more for the rounding errors that are left; else Newton's method goes
    /// on until the velocities stay, with steps that are halved where they miss. Velocities are unique where L is convex in them, and
    /// are found there even if M is singular or infinite on the way, as it is at rest for L = |q̇|^(3/2) or q̇⁴.
    ///
    /// # Errors
    ///
    /// [`NoVelocities`] where M is singular, where Newton's method does not converge, or where L is not quadratic and not convex
    /// at what it finds: M is not positive definite there, and other velocities may have the same momenta.
    fn velocities(&self, t: S, phase: &CanonicalPhase<S, N>) -> Result<SVector<S, N>, NoVelocities>
    where
        Self::Model: Hamiltonian<N, S>,
    {
        let model = self.model();
        legendre::velocities(model, &model.prepare(), t, phase)
    }

    /// The Hamiltonian function H(q, p, t) = Σ pᵢ q̇ᵢ − L, if the declaration has the clause `hamiltonian`.
    ///
    /// # Errors
    ///
    /// Those of [`velocities`](Self::velocities).
    fn hamiltonian(&self, t: S, phase: &CanonicalPhase<S, N>) -> Result<S, NoVelocities>
    where
        Self::Model: Hamiltonian<N, S>,
    {
        let v = self.velocities(t, phase)?;
        Ok(self.energy(&State::new(t, phase.q, v)))
    }

    /// Hamilton's equations, for an integrator, if the declaration has the clause `hamiltonian`.
    fn canonical_equations(&self) -> CanonicalEquations<'_, Self::Model, S, N>
    where
        Self::Model: Hamiltonian<N, S>,
    {
        CanonicalEquations::new(self.model(), self.inputs())
    }

    /// The equations of motion, for an integrator or a loop: what depends on parameters alone is computed once.
    fn dynamics(&self) -> EquationsOfMotion<&Self, S, N>
    where
        Self: Sized,
    {
        EquationsOfMotion::new(self)
    }

    /// The equations of motion together with the model, so that a reaction to an event can change its parameters.
    fn into_dynamics(self) -> EquationsOfMotion<Self, S, N>
    where
        Self: Sized,
    {
        EquationsOfMotion::new(self)
    }

    /// The model under other, constant inputs: an array, an `SVector`, or one number for one input. They may be of another
    /// scalar than the fields, such as dual numbers.
    fn with_inputs<const U: usize>(
        &self,
        inputs: impl IntoVector<S, U>,
    ) -> WithInputs<'_, Self::Model, S, U>
    where
        Self::Model: Inputs<N, U, S>,
    {
        WithInputs::new(self.model(), inputs.into_vector())
    }
}
