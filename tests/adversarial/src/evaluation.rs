//! Everything that a model evaluates, by the names that the data have for it.

use lagrangian::quantities::{
    Constraints, Energies, EnergyBalance, Inputs, Quantities, StateJacobian,
};
use lagrangian::{Dop853, Lagrangian, Problem, RouthReduction, Routhian, State, StopReason};
use nalgebra::{SMatrix, SVector};

use crate::At;

/// The entries of a quantity row by row, or why there are none.
pub type Entries = Result<Vec<f64>, String>;

/// A quantity and its entries.
pub type Found = (&'static str, Entries);

/// The function that evaluates a model.
pub type Evaluate = fn(&At) -> Vec<Found>;

/// What every model without constraints has.
#[must_use]
pub fn motion<M: Lagrangian<N, Model: StateJacobian<N>>, const N: usize>(
    model: &M,
    at: &At,
) -> Vec<Found> {
    let linearization = model.linearize(&at.state::<N>());
    let mut found = common(model, at);
    found.extend([
        ("dqdd_dq", Ok(rows(&linearization.position))),
        ("dqdd_dqd", Ok(rows(&linearization.velocity))),
        ("dqdd_dt", Ok(rows(&linearization.time))),
    ]);
    found
}

/// What every model with constraints has.
#[must_use]
pub fn constrained<M, const N: usize, const C: usize>(model: &M, at: &At) -> Vec<Found>
where
    M: Lagrangian<N, Model: Constraints<N, C>>,
{
    let state = at.state::<N>();
    let (positions, velocities) = model.constraint_residuals(&state);
    let quantities = model.model();
    let rates = quantities.constraint_rates(&state, &quantities.prepare());
    let mut found = common(model, at);
    found.extend([
        ("lambda", Ok(rows(&model.multipliers(&state)))),
        ("G", Ok(rows(&model.constraint_jacobian(&state)))),
        ("g", Ok(rows(&positions))),
        ("w", Ok(rows(&velocities))),
        ("gamma", Ok(rows(&rates))),
    ]);
    found
}

/// The rate of the energy, of models with the clause `energy_balance`.
#[must_use]
pub fn energy_rate<M: Lagrangian<N, Model: EnergyBalance<N>>, const N: usize>(
    model: &M,
    at: &At,
) -> Vec<Found> {
    vec![("energy_rate", Ok(vec![model.energy_rate(&at.state::<N>())]))]
}

/// What every model has.
fn common<M: Lagrangian<N>, const N: usize>(model: &M, at: &At) -> Vec<Found> {
    let state = at.state::<N>();
    let equations = model.dynamics();
    let trial = SVector::<f64, N>::from(at.trial::<N>());
    vec![
        ("L", Ok(vec![model.lagrangian(&state)])),
        ("h", Ok(vec![model.energy(&state)])),
        ("p", Ok(rows(&model.momenta(&state)))),
        ("M", Ok(rows(&model.mass_matrix(&state)))),
        ("f", Ok(rows(&model.forcing(&state)))),
        ("Q", Ok(rows(&model.generalized_forces(&state)))),
        ("qdd", Ok(rows(&model.accelerations(&state)))),
        ("qdd", Ok(rows(&equations.accelerations(&state)))),
        ("inverse", Ok(rows(&model.inverse_dynamics(&state, &trial)))),
    ]
}

/// What a model has that is declared by its energies.
#[must_use]
pub fn energies<M: Lagrangian<N, Model: Energies<N>>, const N: usize>(
    model: &M,
    at: &At,
) -> Vec<Found> {
    let state = at.state::<N>();
    vec![
        ("T", Ok(vec![model.kinetic_energy(&state)])),
        ("V", Ok(vec![model.potential_energy(&state)])),
    ]
}

/// What a model with inputs has besides.
#[must_use]
pub fn driven<M: Lagrangian<N, Model: Inputs<N, U>>, const N: usize, const U: usize>(
    model: &M,
    at: &At,
) -> Vec<Found> {
    let jacobian = model.input_jacobian(&at.state::<N>());
    vec![("dqdd_du", Ok(rows(&jacobian)))]
}

/// What a model has that is reduced by its ignorable coordinates: the reduced model at its state, and the way back.
#[must_use]
pub fn reduced<M, const N: usize, const R: usize, const K: usize>(
    model: &M,
    ignorable: [usize; K],
    at: &At,
) -> Vec<Found>
where
    M: Lagrangian<N> + RouthReduction<N, R, Scalar = f64>,
    M::Reduced: Routhian<R, K, FullState = State<f64, N>>,
    <M::Reduced as Lagrangian<R>>::Model: StateJacobian<R>,
{
    let full = at.state::<N>();
    let (reduced, state) = model.reduce(&full);
    let places = SVector::from(ignorable.map(|i| full.q[i]));
    let linearization = reduced.linearize(&state);
    vec![
        ("reduced constants", Ok(rows(&reduced.constants()))),
        (
            "reduced velocities",
            Ok(rows(&reduced.ignorable_velocities(&state))),
        ),
        ("reduced routhian", Ok(vec![reduced.routhian(&state)])),
        (
            "reduced potential",
            Ok(vec![reduced.effective_potential(&state)]),
        ),
        ("reduced h", Ok(vec![reduced.energy(&state)])),
        ("reduced p", Ok(rows(&reduced.momenta(&state)))),
        ("reduced Q", Ok(rows(&reduced.generalized_forces(&state)))),
        ("reduced qdd", Ok(rows(&reduced.accelerations(&state)))),
        ("reduced dqdd_dq", Ok(rows(&linearization.position))),
        ("reduced dqdd_dqd", Ok(rows(&linearization.velocity))),
        (
            "full state",
            Ok(rows(&reduced.full_state(&state, &places).v)),
        ),
        (
            "reconstruction",
            Ok(reconstruction(model, &reduced, (&full, &state, places))),
        ),
    ]
}

/// Motions that take more steps are not compared: those of parameters that are apart by many powers of ten.
const MAX_STEPS: u64 = 10_000;

/// How far the reconstructed motion is from the full one a little later, relative to how far that has gone; nothing where one of
/// them cannot be integrated.
fn reconstruction<M, D, const N: usize, const R: usize, const K: usize>(
    model: &M,
    reduced: &D,
    (full, state, places): (&State<f64, N>, &State<f64, R>, SVector<f64, K>),
) -> Vec<f64>
where
    M: Lagrangian<N>,
    D: Routhian<R, K, FullState = State<f64, N>>,
{
    let method = Dop853::new()
        .relative_tolerance(1e-11)
        .absolute_tolerance(1e-12);
    let end = full.t + 0.05;
    let equations = reduced.reconstruction();
    let start = beside(state, places);
    let motions = (
        Problem::new(model, *full)
            .max_steps(MAX_STEPS)
            .solve(end, method),
        Problem::new(&equations, start)
            .max_steps(MAX_STEPS)
            .solve(end, method),
    );
    let (Ok(expected), Ok(found)) = motions else {
        return vec![0.0; N];
    };
    let completed = [expected.reason, found.reason].map(|reason| reason == StopReason::Completed);
    if completed != [true; 2] {
        return vec![0.0; N];
    }
    let found = equations.full_state(&found);
    let gone = (expected.q - full.q).amax() + (expected.v - full.v).amax() + full.v.amax() + 1.0;
    rows(&((found.q - expected.q) / gone))
}

/// A state of a reduced model with the ignorable coordinates beside it.
pub(crate) fn beside<const R: usize, const K: usize>(
    state: &State<f64, R>,
    ignorable: SVector<f64, K>,
) -> State<f64, R, SVector<f64, K>> {
    (*state, ignorable).into()
}

/// The entries of a matrix row by row.
#[must_use]
pub fn rows<const R: usize, const C: usize>(matrix: &SMatrix<f64, R, C>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}
