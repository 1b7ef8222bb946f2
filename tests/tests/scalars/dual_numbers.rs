//! Derived models evaluated on dual numbers: emitted derivatives against automatic ones, for all
//! 200 cases.
//!
//! Forward differentiation of the emitted accelerations and the emitted Jacobians share the
//! declaration and the mass matrix, and nothing that comes after.

use lagrangian::quantities::{Energies, Inputs, StateJacobian};
use lagrangian::{Dual, Lagrangian, State};
use lagrangian_tests::{
    Figures, Parametrized, array, list, number, public_cases, relative_error, rows,
};
use nalgebra::{SMatrix, SVector};
use serde_json::Value;

/// Relative to the greatest entry of a vector or matrix, or to 1, the order of the terms that
/// cancel where a derivative vanishes.
const TOLERANCE: f64 = 1e-13;

/// The quantity, what was found, and what was expected.
type Comparison = (&'static str, Vec<f64>, Vec<f64>);

type Row = (&'static str, fn(&Value, &Value) -> Vec<Comparison>);

const CASES: &[Row] = &lagrangian_tests::public_cases!(free, driven);

#[test]
fn emitted_derivatives_are_those_of_dual_numbers() {
    let mut figures = Figures::new();
    for (case, &(id, compare)) in public_cases().iter().zip(CASES) {
        assert_eq!(case["id"], id);
        for (index, state) in list(&case["states"]).iter().enumerate() {
            let tolerance = TOLERANCE.max(lost_by_solving(case, state));
            for (quantity, found, expected) in compare(case, state) {
                let error = relative_error(&found, &expected, 1.0);
                figures.record(quantity, &format!("{id}, state {index}"), error, tolerance);
            }
        }
    }
    figures.finish();
}

/// Two solutions with M stand behind a derivative: q̈, and the derivative itself. Each may lose about
/// N cond(M) ε.
fn lost_by_solving(case: &Value, state: &Value) -> f64 {
    let number = |value: &Value| value.as_f64().expect("a number");
    2.0 * number(&case["n"]) * number(&state["cond_M"]) * f64::EPSILON
}

fn free<M, const N: usize>(case: &Value, state: &Value) -> Vec<Comparison>
where
    M: Parametrized
        + Lagrangian<N, Model: Energies<N> + StateJacobian<N>>
        + Lagrangian<N, Dual, Model: Energies<N, Dual>>,
{
    compare(&M::with(&|name| number(&case["params"][name])), state)
}

fn driven<M, const N: usize, const U: usize>(case: &Value, state: &Value) -> Vec<Comparison>
where
    M: Parametrized
        + Lagrangian<N, Model: Energies<N> + Inputs<N, U> + StateJacobian<N>>
        + Lagrangian<N, Dual, Model: Energies<N, Dual> + Inputs<N, U, Dual>>,
{
    let model = M::with(&|name| {
        number(
            state["u"]
                .get(name)
                .unwrap_or_else(|| &case["params"][name]),
        )
    });
    let mut comparisons = compare(&model, state);
    let at = point(state);
    let inputs: SVector<f64, U> = Lagrangian::<N>::inputs(&model);
    let resting = moving(&at, 0.0, &SVector::zeros(), &SVector::zeros());
    let columns: SMatrix<f64, N, U> = jacobian(|j| {
        let perturbed = SVector::from_fn(|i, _| Dual::new(inputs[i], [unit(i, j)]));
        model.with_inputs(perturbed).accelerations(&resting)
    });
    comparisons.push(("dqdd_du", rows(&columns), rows(&model.input_jacobian(&at))));
    comparisons
}

fn compare<M, const N: usize>(model: &M, state: &Value) -> Vec<Comparison>
where
    M: Lagrangian<N, Model: Energies<N> + StateJacobian<N>>
        + Lagrangian<N, Dual, Model: Energies<N, Dual>>,
{
    let mut comparisons = compare_linearization(model, &point(state));
    comparisons.extend(compare_momenta(model, &point(state)));
    comparisons.extend(compare_energy_rates(model, &point(state), state));
    comparisons
}

fn compare_linearization<M, const N: usize>(model: &M, at: &State<f64, N>) -> Vec<Comparison>
where
    M: Lagrangian<N, Model: StateJacobian<N>> + Lagrangian<N, Dual>,
{
    let none = SVector::zeros();
    let linearization = Lagrangian::<N>::linearize(model, at);
    let accelerations: SVector<f64, N> = model.accelerations(at);
    let position: SMatrix<f64, N, N> =
        jacobian(|j| model.accelerations(&moving(at, 0.0, &direction(j), &none)));
    let velocity: SMatrix<f64, N, N> =
        jacobian(|j| model.accelerations(&moving(at, 0.0, &none, &direction(j))));
    let dual: SVector<Dual, N> = model.accelerations(&moving(at, 1.0, &none, &none));
    vec![
        ("qdd", rows(&dual.map(|x| x.value)), rows(&accelerations)),
        ("dqdd_dq", rows(&position), rows(&linearization.position)),
        ("dqdd_dqd", rows(&velocity), rows(&linearization.velocity)),
        ("dqdd_dt", rows(&dual.map(slope)), rows(&linearization.time)),
    ]
}

/// p = ∂L/∂q̇.
fn compare_momenta<M, const N: usize>(model: &M, at: &State<f64, N>) -> Vec<Comparison>
where
    M: Lagrangian<N> + Lagrangian<N, Dual>,
{
    let none = SVector::zeros();
    let momenta: SVector<f64, N> = model.momenta(at);
    let slopes = SVector::<f64, N>::from_fn(|j, _| {
        slope(model.lagrangian(&moving(at, 0.0, &none, &direction(j))))
    });
    vec![("p", rows(&slopes), rows(&momenta))]
}

/// The rate of the energy function is Q·q̇ − ∂L/∂t, and its derivative along the motion.
///
/// The terms of the latter cancel where energy is conserved: their sum is compared with the
/// reference in relation to the greatest of them.
fn compare_energy_rates<M, const N: usize>(
    model: &M,
    at: &State<f64, N>,
    state: &Value,
) -> Vec<Comparison>
where
    M: Lagrangian<N> + Lagrangian<N, Dual>,
{
    let none = SVector::zeros();
    let rate =
        |q: &SVector<f64, N>, v: &SVector<f64, N>| slope(model.energy(&moving(at, 0.0, q, v)));
    let forces: SVector<f64, N> = model.generalized_forces(at);
    let explicit = slope(model.lagrangian(&moving(at, 1.0, &none, &none)));
    let accelerations = SVector::<f64, N>::from(array(&state["qdd"]));
    let mut terms = vec![slope(model.energy(&moving(at, 1.0, &none, &none)))];
    for j in 0..N {
        terms.push(rate(&direction(j), &none) * at.v[j]);
        terms.push(rate(&none, &direction(j)) * accelerations[j]);
    }
    let scale = terms
        .iter()
        .fold(1.0_f64, |scale, term| scale.max(term.abs()));
    let (along, expected) = (terms.iter().sum::<f64>(), number(&state["djacobi_dt"]));
    vec![
        (
            "Q·q̇ - ∂L/∂t",
            vec![forces.dot(&at.v) - explicit],
            vec![expected],
        ),
        ("dh/dt", vec![along / scale], vec![expected / scale]),
    ]
}

fn point<const N: usize>(state: &Value) -> State<f64, N> {
    State::new(number(&state["t"]), array(&state["q"]), array(&state["qd"]))
}

/// The state, moving at the given rates.
fn moving<const N: usize>(
    at: &State<f64, N>,
    t: f64,
    q: &SVector<f64, N>,
    v: &SVector<f64, N>,
) -> State<Dual, N> {
    State::new(
        Dual::new(at.t, [t]),
        at.q.zip_map(q, |x, rate| Dual::new(x, [rate])),
        at.v.zip_map(v, |x, rate| Dual::new(x, [rate])),
    )
}

/// The matrix whose columns are the derivatives of what `column` gives.
fn jacobian<const N: usize, const K: usize>(
    column: impl Fn(usize) -> SVector<Dual, N>,
) -> SMatrix<f64, N, K> {
    let columns: [SVector<f64, N>; K] = std::array::from_fn(|j| column(j).map(slope));
    SMatrix::from_columns(&columns)
}

fn slope(number: Dual) -> f64 {
    number.derivative[0]
}

fn direction<const N: usize>(j: usize) -> SVector<f64, N> {
    SVector::from_fn(|i, _| unit(i, j))
}

fn unit(i: usize, j: usize) -> f64 {
    if i == j { 1.0 } else { 0.0 }
}
