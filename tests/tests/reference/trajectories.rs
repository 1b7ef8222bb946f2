//! Motions of the systems without constraints, against integrations with 30 digits.

use std::cell::Cell;

use lagrangian::Partial;
use lagrangian::prelude::*;
use lagrangian::quantities::{Energies, Inputs, MotionSeries};
use lagrangian_tests::{
    Figures, Law, Observed, Parametrized, array, list, number, numbers, references, relative_error,
    rows, text,
};
use nalgebra::SVector;
use serde_json::Value;

/// Relative to the greatest entry of a vector, or to 1 if that is greater.
const TOLERANCE: f64 = 1e-9;
/// The same for a motion in which errors grow exponentially, by DOP853.
const CHAOTIC_TOLERANCE: f64 = 1e-8;

/// What the Taylor method reaches where the problem's condition allows it.
const TAYLOR_TOLERANCE: f64 = 1e-12;

/// By which part parameters and initial values are moved to see the condition: small enough to be linear where errors grow
/// a million times, and large beside what integrations lose.
const MOVED: f64 = 1e-10;

/// How many combinations of signs the condition is the worst of.
const DIRECTIONS: u32 = 3;

/// The one that passes 7e-7 rad from the pole of its angles.
const THROUGH_THE_POLE: &str = "heavy_top_benchmark_zxz";

/// What was found and what was expected of a quantity at a sample.
type Comparison = (&'static str, Vec<f64>, Vec<f64>);

/// A motion: the comparisons at each sample up to the end or up to an error.
struct Motion {
    method: &'static str,
    samples: Vec<Vec<Comparison>>,
    /// What each comparison allows, of a method of which more is asked than of others.
    allowed: Vec<Vec<f64>>,
    error: Option<IntegrationError>,
}

/// A system: its identifier, and its motion in one scenario by each method.
type Row = (&'static str, fn(&Value) -> Vec<Motion>);

const SYSTEMS: &[Row] = &lagrangian_tests::trajectories!(free, driven);

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn motions_follow_the_references() {
    follow_the_references(0, 1);
}

#[test]
fn some_motions_follow_the_references() {
    follow_the_references(1, 4);
}

/// Compares one motion of so many, from this one on.
fn follow_the_references(first: usize, stride: usize) {
    let mut figures = Figures::new();
    let document = references();
    for system in list(&document["references"])
        .iter()
        .skip(first)
        .step_by(stride)
    {
        let name = format!("{}, scenario {}", text(&system["id"]), system["scenario"]);
        for (_, integrate) in SYSTEMS.iter().filter(|(id, _)| system["id"] == *id) {
            for motion in integrate(system) {
                check_end(system, &motion);
                let name = format!("{name}, {}", motion.method);
                record(&mut figures, system, &name, &motion);
            }
        }
    }
    figures.finish();
}

#[test]
fn no_system_without_constraints_is_left_out() {
    let document = references();
    let is_constrained = |system: &Value| {
        ["holonomic", "nonholonomic"]
            .iter()
            .any(|kind| !list(&system[kind]).is_empty())
    };
    for system in list(&document["references"])
        .iter()
        .filter(|system| !is_constrained(system))
    {
        assert!(
            SYSTEMS.iter().any(|(id, _)| system["id"] == *id),
            "{}",
            system["id"]
        );
    }
}

/// Every motion reaches its end but the one that cannot, and that says which coordinate is the
/// reason.
fn check_end(system: &Value, motion: &Motion) {
    let samples = list(&system["samples"]).len();
    if system["id"] == THROUGH_THE_POLE {
        let Some(IntegrationError::SingularConfiguration { singularity, .. }) = motion.error else {
            panic!(
                "expected the error of the pole, found {:?} after {} samples",
                motion.error,
                motion.samples.len()
            );
        };
        assert!(singularity.to_string().contains("theta"), "{singularity}");
        assert!((1..samples).contains(&motion.samples.len()));
    } else {
        assert_eq!(motion.error, None, "{}", system["id"]);
        assert_eq!(motion.samples.len(), samples, "{}", system["id"]);
    }
}

fn record(figures: &mut Figures, system: &Value, name: &str, motion: &Motion) {
    let is_chaotic = list(&system["tags"]).iter().any(|tag| tag == "chaotic");
    let tolerance = if is_chaotic {
        CHAOTIC_TOLERANCE
    } else {
        TOLERANCE
    };
    let samples = motion.samples.iter().zip(list(&system["samples"]));
    for (index, (comparisons, sample)) in samples.enumerate() {
        let at = format!("{name}, t = {}", text(&sample["t"]));
        let allowed = motion.allowed.get(index);
        for (which, (quantity, found, expected)) in comparisons.iter().enumerate() {
            let allowed = allowed.and_then(|allowed| allowed.get(which));
            figures.record(
                quantity,
                &at,
                relative_error(found, expected, 1.0),
                allowed.map_or(tolerance, |allowed| allowed.min(TOLERANCE)),
            );
        }
    }
}

fn free<M, const N: usize>(system: &Value) -> Vec<Motion>
where
    M: Parametrized + Lagrangian<N, Model: Energies<N> + MotionSeries<N>> + Observed<N>,
{
    let model = M::with(&|name| number(&system["params"][name]));
    let compare = |state: &State<f64, N>, sample: &Value| {
        let mut comparisons = compare(&model, state, sample);
        comparisons.extend(compare_forces(&model, sample));
        comparisons
    };
    let dynamics = model.dynamics();
    let (initial, times) = start(system);
    let by_series = by_series(&model, initial, &times);
    let mut by_taylor = Motion::new("Taylor", by_series, system, compare);
    by_taylor.allow::<M, N>(system);
    vec![
        Motion::new("DOP853", dormand_prince(&dynamics, system), system, compare),
        by_taylor,
    ]
}

fn by_series<M, const N: usize>(model: &M, initial: State<f64, N>, times: &[f64]) -> Sampled<N>
where
    M: Lagrangian<N, Model: MotionSeries<N>>,
{
    sampled(Problem::new(model, initial), times, Taylor::new())
}

/// The inputs of the fields are no numbers, and everything that depends on inputs uses the law.
fn driven<M, const N: usize, const U: usize>(system: &Value) -> Vec<Motion>
where
    M: Parametrized + Lagrangian<N, Model: Energies<N> + Inputs<N, U>> + Observed<N> + Law<U>,
{
    let model = M::with(&|name| system["params"].get(name).map_or(f64::NAN, number));
    let law = |state: &State<f64, N>| SVector::from(model.inputs_at(state.t));
    let compare = |state: &State<f64, N>, sample: &Value| {
        let mut comparisons = compare(&model, state, sample);
        comparisons.extend(compare_forces(
            &model.with_inputs(law(&reference_state(sample))),
            sample,
        ));
        comparisons
    };
    let controlled = Problem::new(&model, start(system).0).feedback(law);
    let sampled = dormand_prince(controlled.dynamics(), system);
    vec![Motion::new("DOP853", sampled, system, compare)]
}

/// The motion at the times of the samples, or up to an error.
type Sampled<const N: usize> = Result<Samples<N>, Partial<Samples<N>>>;
type Samples<const N: usize> = Solution<f64, Phase<f64, N>, Vec<State<f64, N>>>;

fn sampled<D, I, const N: usize>(problem: Problem<f64, D>, times: &[f64], method: I) -> Sampled<N>
where
    D: Dynamics<State = Phase<f64, N>>,
    I: Integrator<f64, D>,
{
    let end = times[times.len() - 1];
    problem.max_steps(1_000_000).save(times).solve(end, method)
}

/// By DOP853, which is compiled for each number of coordinates, not for each model.
fn dormand_prince<const N: usize>(
    dynamics: &dyn Dynamics<State = Phase<f64, N>>,
    system: &Value,
) -> Sampled<N> {
    let (initial, times) = start(system);
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    sampled(Problem::new(dynamics, initial), &times, method)
}

/// The initial state, and the times of the samples.
fn start<const N: usize>(system: &Value) -> (State<f64, N>, Vec<f64>) {
    let samples = list(&system["samples"]);
    let times: Vec<f64> = samples.iter().map(|sample| number(&sample["t"])).collect();
    let [q, v] = ["q", "qd"].map(|name| array(&system["init"][name]));
    (State::new(times[0], q, v), times)
}

impl Motion {
    fn new<const N: usize>(
        method: &'static str,
        sampled: Sampled<N>,
        system: &Value,
        compare: impl Fn(&State<f64, N>, &Value) -> Vec<Comparison>,
    ) -> Self {
        let (solution, error) = match sampled {
            Ok(solution) => (solution, None),
            Err(partial) => {
                let error = partial.error();
                (partial.into_solution(), Some(error))
            }
        };
        let states = solution.samples().iter().zip(list(&system["samples"]));
        Self {
            allowed: Vec::new(),
            method,
            samples: states
                .map(|(state, sample)| compare(state, sample))
                .collect(),
            error,
        }
    }
}

impl Motion {
    /// Asks for 1e-12 where the condition allows it. What is moved by rounding at the beginning and in each of n steps is
    /// enlarged by the condition κ of the motion at most, and adds up like √n: κ ε √n. The condition is that of integrations
    /// from parameters and initial values that are moved in their digits, with signs that differ.
    fn allow<M, const N: usize>(&mut self, system: &Value)
    where
        M: Parametrized + Lagrangian<N, Model: Energies<N> + MotionSeries<N>> + Observed<N>,
    {
        let directions = (0..DIRECTIONS).filter_map(|direction| moved::<M, N>(system, direction));
        for (model, solution) in directions {
            #[allow(clippy::cast_precision_loss)] // Some steps.
            let steps = solution.statistics.steps as f64;
            let rounding = f64::EPSILON * steps.sqrt();
            let samples = solution.samples().iter().zip(list(&system["samples"]));
            for (index, (state, sample)) in samples.enumerate() {
                let moved = compare(&model, state, sample);
                let found = self.samples.get(index).into_iter().flatten();
                let allowed = moved.iter().zip(found).map(|(moved, found)| {
                    let condition = relative_error(&moved.1, &found.1, 1.0) / MOVED;
                    TAYLOR_TOLERANCE.max(condition * rounding)
                });
                let allowed: Vec<f64> = allowed.collect();
                match self.allowed.get_mut(index) {
                    Some(known) => {
                        let pairs = known.iter_mut().zip(allowed);
                        pairs.for_each(|(known, allowed)| *known = known.max(allowed));
                    }
                    None => self.allowed.push(allowed),
                }
            }
        }
    }
}

/// A motion of a model whose parameters and initial values are moved, each up or down as a bit of a hash of its number says;
/// none where it ends with an error.
fn moved<M, const N: usize>(system: &Value, direction: u32) -> Option<(M, Samples<N>)>
where
    M: Parametrized + Lagrangian<N, Model: MotionSeries<N>>,
{
    let count = Cell::new(0_u32);
    let factor = || {
        count.set(count.get() + 1);
        let bit = (count.get().wrapping_mul(2_654_435_761) >> (7 + 5 * direction)) & 1;
        1.0 + MOVED * (f64::from(bit) * 2.0 - 1.0)
    };
    let (initial, times) = start::<N>(system);
    let [q, v] = [initial.q, initial.v].map(|x| x.map(|x| x * factor()));
    let model = M::with(&|name| number(&system["params"][name]) * factor());
    let solution = by_series(&model, State::new(initial.t, q, v), &times).ok()?;
    Some((model, solution))
}

/// The state, and the energies and momenta there.
fn compare<M, const N: usize>(model: &M, state: &State<f64, N>, sample: &Value) -> Vec<Comparison>
where
    M: Lagrangian<N, Model: Energies<N>> + Observed<N>,
{
    let mut comparisons = vec![
        ("q", rows(&state.q), numbers(&sample["q"])),
        ("qd", rows(&state.v), numbers(&sample["qd"])),
        (
            "T",
            vec![model.kinetic_energy(state)],
            numbers(&sample["T"]),
        ),
        (
            "V",
            vec![model.potential_energy(state)],
            numbers(&sample["V"]),
        ),
        ("h", vec![model.energy(state)], numbers(&sample["jacobi"])),
        ("p", rows(&model.momenta(state)), numbers(&sample["p"])),
    ];
    comparisons.extend(model.observed(state).into_iter().map(|(name, value)| {
        let expected = sample["invariants"]
            .get(name)
            .unwrap_or_else(|| &sample["observables"][name]);
        ("invariants", vec![value], numbers(expected))
    }));
    comparisons
}

/// What depends on inputs, at the state of the reference: the damping of the governor is so strong
/// that a velocity off by 1e-14 changes the forces by 1e-9.
fn compare_forces<M, const N: usize>(model: &M, sample: &Value) -> [Comparison; 2]
where
    M: Lagrangian<N>,
{
    let state = reference_state(sample);
    [
        (
            "qdd",
            rows(&model.accelerations(&state)),
            numbers(&sample["qdd"]),
        ),
        (
            "Q",
            rows(&model.generalized_forces(&state)),
            numbers(&sample["Q"]),
        ),
    ]
}

fn reference_state<const N: usize>(sample: &Value) -> State<f64, N> {
    State::new(
        number(&sample["t"]),
        array(&sample["q"]),
        array(&sample["qd"]),
    )
}
