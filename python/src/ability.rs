//! What only some models can do, told apart by the traits that they implement.
//!
//! Each ability has a trait with two implementations: for `&Probe` if the model has it, and for `Probe` otherwise. The call
//! `(&&probe).ability()` takes the first if there is one, since a method is looked for on a type before it is looked for on what the
//! type refers to.

mod laws;
mod series;

use std::marker::PhantomData;

use lagrangian::problem::{DeclaredBy, End};
use lagrangian::quantities::{Constraints, Energies, Events, Reflect, StateJacobian};
use lagrangian::{DeclaredEvent, Dynamics, EventDynamics, Lagrangian, Problem, State};

use crate::ensemble::{Ensemble, EnsembleMotions};
use crate::integrated::Integrated;
use crate::request::Request;

pub use laws::{HasInputs, HasNoInputs, PythonLaw, SampledPythonLaw, Under};
pub use series::{HasNoTaylorSeries, HasTaylorSeries};

/// Functions of a model, some of which only some models have.
pub struct Abilities<M, const N: usize> {
    /// The kinetic and the potential energy.
    pub energies: Option<BothEnergies<M, N>>,
    /// The event functions.
    pub event_functions: Option<Values<M, N>>,
    /// The state matrix, row by row.
    pub state_matrix: Option<Values<M, N>>,
    /// The input matrix, row by row.
    pub input_matrix: Option<Values<M, N>>,
    /// The coordinates and velocities that satisfy the constraints.
    pub assemble: Option<Assemble<M, N>>,
    /// A motion.
    pub integrate: fn(&M, &Request) -> Option<Integrated>,
    /// Many motions.
    pub ensemble: fn(&Ensemble) -> Option<Result<EnsembleMotions, String>>,
}

/// A model with N coordinates, U inputs, E events and C constraints.
pub struct Probe<M, const N: usize, const U: usize, const E: usize, const C: usize>(
    pub PhantomData<M>,
);

/// Numbers of a model at a state, which are appended to others.
pub type Values<M, const N: usize> = fn(&M, &State<f64, N>, &mut Vec<f64>);

/// The kinetic and the potential energy of a model at a state.
pub type BothEnergies<M, const N: usize> = fn(&M, &State<f64, N>) -> [f64; 2];

/// The coordinates and velocities that satisfy the constraints of a model near a state, or a message.
pub type Assemble<M, const N: usize> = fn(&M, State<f64, N>) -> Result<[Vec<f64>; 2], String>;

/// The kinetic and the potential energy.
pub trait HasEnergies<M, const N: usize> {
    /// The function, if the declaration has the clauses `kinetic` and `potential`.
    fn energies(&self) -> Option<BothEnergies<M, N>>;
}

impl<M, const N: usize, const U: usize, const E: usize, const C: usize> HasEnergies<M, N>
    for &Probe<M, N, U, E, C>
where
    M: Reflect<N, Model: Energies<N>>,
{
    fn energies(&self) -> Option<BothEnergies<M, N>> {
        Some(|model, state| [model.kinetic_energy(state), model.potential_energy(state)])
    }
}

/// No energies.
pub trait HasNoEnergies<M, const N: usize> {
    /// Nothing.
    fn energies(&self) -> Option<BothEnergies<M, N>> {
        None
    }
}

impl<M, const N: usize, const U: usize, const E: usize, const C: usize> HasNoEnergies<M, N>
    for Probe<M, N, U, E, C>
{
}

/// The state matrix.
pub trait HasStateMatrix<M, const N: usize> {
    /// The function, for a model without constraints.
    fn state_matrix(&self) -> Option<Values<M, N>>;
}

impl<M, const N: usize, const U: usize, const E: usize, const C: usize> HasStateMatrix<M, N>
    for &Probe<M, N, U, E, C>
where
    M: Reflect<N, Model: StateJacobian<N>>,
{
    fn state_matrix(&self) -> Option<Values<M, N>> {
        Some(|model, state, numbers| {
            let linearization = model.linearize(state);
            for row in 0..N {
                numbers.extend((0..2 * N).map(|column| f64::from(u8::from(column == N + row))));
            }
            let rows = linearization
                .position
                .row_iter()
                .zip(linearization.velocity.row_iter());
            for (position, velocity) in rows {
                numbers.extend(position.iter().chain(velocity.iter()));
            }
        })
    }
}

/// No state matrix.
pub trait HasNoStateMatrix<M, const N: usize> {
    /// Nothing.
    fn state_matrix(&self) -> Option<Values<M, N>> {
        None
    }
}

impl<M, const N: usize, const U: usize, const E: usize, const C: usize> HasNoStateMatrix<M, N>
    for Probe<M, N, U, E, C>
{
}

/// The declared events, where their functions rise and where they fall.
type RisingAndFalling<M, const E: usize> = (
    ((), <[DeclaredEvent<M>; E] as DeclaredBy<M>>::Events),
    <[DeclaredEvent<M>; E] as DeclaredBy<M>>::Events,
);

/// Events.
pub trait HasEvents<M, const N: usize, const E: usize> {
    /// The event functions.
    fn event_functions(&self) -> Option<Values<M, N>>;

    /// Records all events: first those whose functions rise.
    #[allow(clippy::type_complexity)] // The events are in the type of the problem.
    fn watch<D>(&self, problem: Problem<f64, D>) -> Problem<f64, D, End, RisingAndFalling<M, E>>
    where
        D: EventDynamics<f64, Model = M>;
}

impl<M, const N: usize, const U: usize, const E: usize, const C: usize> HasEvents<M, N, E>
    for &Probe<M, N, U, E, C>
where
    M: Reflect<N, Model = M> + Events<N>,
{
    fn event_functions(&self) -> Option<Values<M, N>> {
        Some(|model, state, numbers| {
            let functions = Lagrangian::event_functions(model, state);
            numbers.extend(functions.as_ref().iter().take(E));
        })
    }

    fn watch<D>(&self, problem: Problem<f64, D>) -> Problem<f64, D, End, RisingAndFalling<M, E>>
    where
        D: EventDynamics<f64, Model = M>,
    {
        let all = core::array::from_fn::<_, E, _>(DeclaredEvent::<M>::new);
        let problem = problem.on(all).rising().record();
        problem.on(all).falling().record()
    }
}

/// No events.
pub trait HasNoEvents<M, const N: usize> {
    /// Nothing.
    fn event_functions(&self) -> Option<Values<M, N>> {
        None
    }

    /// The problem as it is.
    fn watch<D: Dynamics<f64>>(&self, problem: Problem<f64, D>) -> Problem<f64, D> {
        problem
    }
}

impl<M, const N: usize, const U: usize, const E: usize, const C: usize> HasNoEvents<M, N>
    for Probe<M, N, U, E, C>
{
}

/// Constraints.
pub trait HasConstraints<M, const N: usize> {
    /// The function that finds a state which satisfies them.
    fn assemble(&self) -> Option<Assemble<M, N>>;
}

impl<M, const N: usize, const U: usize, const E: usize, const C: usize> HasConstraints<M, N>
    for &Probe<M, N, U, E, C>
where
    M: Reflect<N, Model: Constraints<N, C>>,
{
    fn assemble(&self) -> Option<Assemble<M, N>> {
        Some(|model, guess| {
            let assembled = model.assemble(guess).solve();
            let state = assembled.map_err(|error| error.to_string())?.state;
            Ok([state.q, state.v].map(|vector| vector.as_slice().to_vec()))
        })
    }
}

/// No constraints.
pub trait HasNoConstraints<M, const N: usize> {
    /// Nothing.
    fn assemble(&self) -> Option<Assemble<M, N>> {
        None
    }
}

impl<M, const N: usize, const U: usize, const E: usize, const C: usize> HasNoConstraints<M, N>
    for Probe<M, N, U, E, C>
{
}
