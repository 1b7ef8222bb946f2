//! Compiler messages for constants or methods that need a clause that the declaration lacks.
//!
//! If the trait of an item is not implemented, the compiler does not use the trait's `on_unimplemented` message, which
//! applies only to unmet bounds, such as those on the methods of `Lagrangian`. Each other item therefore has a namesake
//! in a trait that is implemented for every type under a bound that no type meets. The compiler skips the namesake if
//! it finds another item, and otherwise reports the bound. Namesakes take `&mut self`, which the compiler tries last,
//! and are never called. The prelude imports their traits without names.
//!
//! `reduce` has no namesake, because types of other crates have methods of this name.

/// A bound met by models with a field `#[lagrangian(input)]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no inputs: mark the fields that a control law or a signal sets `#[lagrangian(input)]`"
)]
pub trait DeclaresInputs {}

/// A bound met by models with the clause `event`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no events: write the clause `event(name = expression)` in its declaration"
)]
pub trait DeclaresEvents {}

/// A bound met by models with the clause `regressor`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no regressor: write the clause `regressor`, or `regressor(m, inertia)` with the unknown \
               parameters, in its declaration"
)]
pub trait DeclaresRegressor {}

/// A bound met by models with the clause `sensitivities`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no derivatives by parameters: write the clause `sensitivities`, or `sensitivities(m, l)` with \
               some parameters, in its declaration"
)]
pub trait DeclaresSensitivities {}

/// A bound met by models with the clause `c`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not written in C: write the clause `c` in its declaration"
)]
pub trait DeclaresC {}

/// A bound met by the reduced model of a clause `routhian`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a reduced model: write the clause `routhian(Name)` in its declaration, and \
               `let (reduced, start) = model.reduce(&start)`"
)]
pub trait IsReduced {}

/// A bound met by models with an ignorable coordinate or a constant energy.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no constants of motion: a force, dissipation or an input acts on each coordinate, or the \
               Lagrangian depends on it; and the energy changes"
)]
pub trait HasConstantsOfMotion {}

/// Defines the traits of namesakes, each under its bound.
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
        const INPUTS;
    }
    OfEvents: DeclaresEvents { const EVENTS; }
    OfRegressor: DeclaresRegressor { const BASE_PARAMETERS, WITHOUT_EFFECT; }
    OfSensitivities: DeclaresSensitivities { const PARAMETERS; }
    OfC: DeclaresC { const C_SOURCE, C_HEADER, C_CASADI; }
    OfReducedModels: IsReduced {
        fn routhian, effective_potential, ignorable_velocities, full_state, reconstruction;
        const ELIMINATED;
    }
    OfConstantsOfMotion: HasConstantsOfMotion {
        fn constants_of_motion, watch_constants;
        const CONSTANTS_OF_MOTION, IGNORABLE_COORDINATES, CONSERVES_ENERGY;
    }
}
