//! What the compiler says where a constant or a method needs a clause that the declaration lacks.
//!
//! Where the trait of an item is not implemented, the compiler does not read the trait's `on_unimplemented`: that speaks of
//! unmet bounds alone, such as those of the methods of `Lagrangian`. Each other item therefore has a namesake in a trait that is
//! implemented for every type under a bound that none meets. The compiler passes the namesake over, and reports the bound where it finds nothing else. Namesakes take
//! `&mut self`, which the compiler tries last, and are never called. The prelude imports their traits without names.
//!
//! `reduce` has none: the types of other crates have methods of that name.

/// What a model with a field `#[lagrangian(input)]` has.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no inputs: mark the fields that a control law or a signal sets `#[lagrangian(input)]`"
)]
pub trait DeclaresInputs {}

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
        const INPUTS;
    }
    OfEvents: DeclaresEvents { const EVENTS; }
    OfRegressor: DeclaresRegressor { const BASE_PARAMETERS, WITHOUT_EFFECT; }
    OfSensitivities: DeclaresSensitivities { const PARAMETERS; }
    OfReducedModels: IsReduced {
        fn routhian, effective_potential, ignorable_velocities, full_state, reconstruction;
        const ELIMINATED;
    }
    OfConstantsOfMotion: HasConstantsOfMotion {
        fn constants_of_motion, watch_constants;
        const CONSTANTS_OF_MOTION, IGNORABLE_COORDINATES, CONSERVES_ENERGY;
    }
}
