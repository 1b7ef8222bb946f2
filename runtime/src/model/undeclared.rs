//! What the compiler says of a method or a constant whose clause a declaration does not have.
//!
//! Where a method's trait is not implemented, the compiler does not read the trait's `on_unimplemented`: that speaks of
//! unmet bounds alone. Each such item therefore has a namesake in a trait that is implemented for every type under a bound
//! that none meets. The compiler passes the namesake over, and reports the bound where it finds nothing else. Namesakes take
//! `&mut self`, which the compiler tries last, and are never called. The prelude imports their traits without names.
//!
//! `reduce` and `power` have none: the types of other crates have methods of these names.

/// What a model with a field `#[lagrangian(input)]` has.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no inputs: mark the fields that a control law or a signal sets `#[lagrangian(input)]`"
)]
pub trait DeclaresInputs {}

/// What a model with the clause `output` has.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no outputs: write the clause `output(name = expression)` in its declaration"
)]
pub trait DeclaresOutputs {}

/// What a model with the clause `event` has.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no events: write the clause `event(name = expression)` in its declaration"
)]
pub trait DeclaresEvents {}

/// What a model with the clause `regressor` has.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no regressor: write the clause `regressor`, or `regressor(m, inertia)` with the unknown \
               parameters, in its declaration"
)]
pub trait DeclaresRegressor {}

/// What a model with the clause `sensitivities` has.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no derivatives by parameters: write the clause `sensitivities`, or `sensitivities(m, l)` with \
               some parameters, in its declaration"
)]
pub trait DeclaresSensitivities {}

/// What a model with the clause `hamiltonian` has.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no Hamiltonian form: write the clause `hamiltonian` in its declaration"
)]
pub trait DeclaresHamiltonian {}

/// What a model with the clause `energy_balance` has.
#[diagnostic::on_unimplemented(
    message = "the rate of the energy of `{Self}` is not known: write the clause `energy_balance` in its declaration"
)]
pub trait DeclaresEnergyBalance {}

/// What a model with `kinetic` in place of `lagrangian` has.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no kinetic and potential energy apart: declare `kinetic = …` and `potential = …` in place of \
               `lagrangian = …`"
)]
pub trait DeclaresEnergies {}

/// What the reduced model of a clause `routhian` has.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a reduced model: write the clause `routhian(Name)` in its declaration, and \
               `let (reduced, start) = model.reduce(&start)`"
)]
pub trait IsReduced {}

/// What a model with an ignorable coordinate or a constant energy has.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no constants of motion: a force, dissipation or an input acts on each coordinate, or the \
               Lagrangian depends on it; and the energy changes"
)]
pub trait HasConstantsOfMotion {}

/// The traits of namesakes, each under its bound.
macro_rules! namesakes {
    ($($name:ident: $bound:ident {
        $(fn $($method:ident),+;)?
        $(const $($constant:ident),+;)?
    })*) => {
        $(
            #[doc(hidden)]
            pub trait $name {
                $($(fn $method(&mut self) {})+)?
                $($(const $constant: () = ();)+)?
            }

            impl<M: $bound + ?Sized> $name for M {}
        )*
    };
}

namesakes! {
    OfInputs: DeclaresInputs {
        fn controlled_by, with_controller, with_inputs, driven_by, inputs, lagrangian_with, energy_with, forcing_with,
            generalized_forces_with, accelerations_with, inverse_dynamics_with, linearize_with, input_jacobian,
            input_jacobian_with, input_matrix, input_matrix_with;
        const INPUTS;
    }
    OfOutputs: DeclaresOutputs { fn outputs, outputs_with; }
    OfEvents: DeclaresEvents {
        fn event_functions, event_functions_with;
        const EVENTS;
    }
    OfRegressor: DeclaresRegressor {
        fn regressor, regressor_with, known_terms, known_terms_with, base_parameters;
        const BASE_PARAMETERS, WITHOUT_EFFECT;
    }
    OfSensitivities: DeclaresSensitivities {
        fn sensitivities, sensitivities_with;
        const PARAMETERS;
    }
    OfHamiltonian: DeclaresHamiltonian {
        fn momentum_rates, momentum_rates_with, velocities, hamiltonian, canonical_equations;
    }
    OfEnergyBalance: DeclaresEnergyBalance { fn energy_rate, energy_rate_with; }
    OfEnergies: DeclaresEnergies { fn kinetic_energy, potential_energy; }
    OfReducedModels: IsReduced {
        fn routhian, effective_potential, ignorable_velocities, full_state, reconstruction;
        const ELIMINATED;
    }
    OfConstantsOfMotion: HasConstantsOfMotion {
        fn constants_of_motion, watch_constants;
        const CONSTANTS_OF_MOTION, IGNORABLE_COORDINATES, CONSERVES_ENERGY;
    }
}
