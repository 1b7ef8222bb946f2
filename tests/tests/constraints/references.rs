//! Motions of the systems with constraints, and their multipliers, against integrations with 30 digits.

mod models;

use lagrangian::prelude::*;
use lagrangian::quantities::{Constraints, Energies, MotionSeries};
use lagrangian_tests::{
    Figures, Motion, array, list, motions, number, numbers, references, relative_error, rows, text,
};
use nalgebra::SVector;

use models::{Atwood, Bricard, Pendulum, Sleigh, Squeezer, disc};

/// Relative to the greatest entry of a vector along the motion.
const TOLERANCE: f64 = 1e-9;
/// The same for coordinates and velocities of Andrews' mechanism, whose published values miss the motion by 5e-10.
const SQUEEZER_TOLERANCE: f64 = 1e-10;
/// Of what is evaluated at the states of the reference.
const POINTWISE_TOLERANCE: f64 = 1e-12;
/// Residuals, relative to the gradients of the constraints times the state.
const ROUNDING: f64 = 1e-15;

/// The identifiers of the systems.
const SYSTEMS: [&str; 6] = [
    "andrews_squeezer",
    "atwood_constraint",
    "chaplygin_sleigh",
    "iftomm_a04_bricard",
    "pendulum_cartesian",
    "rolling_disc",
];

#[test]
fn andrews_squeezer_by_taylor() {
    check("andrews_squeezer", |motion, figures| {
        by_taylor(motion, &Squeezer::of(motion), figures);
    });
}

#[test]
fn andrews_squeezer_by_dormand_and_prince() {
    check("andrews_squeezer", |motion, figures| {
        by_dormand_and_prince(motion, &Squeezer::of(motion), figures);
        compare_forces(motion, &Squeezer::of(motion), figures);
    });
}

#[test]
fn atwood_machine() {
    check("atwood_constraint", |motion, figures| {
        compare(motion, &Atwood::of(motion), figures);
    });
}

#[test]
fn chaplygin_sleigh() {
    check("chaplygin_sleigh", |motion, figures| {
        compare(motion, &Sleigh::of(motion), figures);
    });
}

#[test]
fn bricard_mechanism() {
    check("iftomm_a04_bricard", |motion, figures| {
        let bricard = Bricard::of(motion);
        compare(motion, &bricard, figures);
        compare_points(motion, &bricard, figures);
    });
}

#[test]
fn cartesian_pendulum() {
    check("pendulum_cartesian", |motion, figures| {
        compare(motion, &Pendulum::of(motion), figures);
    });
}

#[test]
fn rolling_disc() {
    check("rolling_disc", |motion, figures| {
        compare(motion, &disc(motion), figures);
    });
}

fn check(id: &str, compare: impl Fn(&Motion, &mut Figures)) {
    assert!(SYSTEMS.contains(&id));
    let mut figures = Figures::new();
    for motion in motions(id) {
        compare(&motion, &mut figures);
    }
    figures.finish();
}

#[test]
fn no_system_with_constraints_is_left_out() {
    let document = references();
    let is_constrained = |system: &&serde_json::Value| {
        let kinds = ["holonomic", "nonholonomic"];
        kinds.iter().any(|kind| !list(&system[kind]).is_empty())
    };
    for system in list(&document["references"]).iter().filter(is_constrained) {
        let id = &system["id"];
        assert!(SYSTEMS.iter().any(|known| id == known), "{id}");
    }
}

/// Compares the motion by both methods, and what is evaluated at the states of the reference.
fn compare<M, const N: usize, const C: usize>(motion: &Motion, model: &M, figures: &mut Figures)
where
    M: Lagrangian<N, Model: Constraints<N, C> + Energies<N> + MotionSeries<N>>,
{
    by_taylor(motion, model, figures);
    by_dormand_and_prince(motion, model, figures);
    compare_forces(motion, model, figures);
}

fn by_taylor<M, const N: usize, const C: usize>(motion: &Motion, model: &M, figures: &mut Figures)
where
    M: Lagrangian<N, Model: Constraints<N, C> + MotionSeries<N>>,
{
    let (start, times) = start(motion);
    let end = times[times.len() - 1];
    let problem = Problem::new(model, start).save(times);
    let found = problem.solve(end, Taylor::new()).expect("a motion");
    compare_states(
        &Along::new(motion, "Taylor"),
        model,
        found.samples(),
        figures,
    );
}

fn by_dormand_and_prince<M, const N: usize, const C: usize>(
    motion: &Motion,
    model: &M,
    figures: &mut Figures,
) where
    M: Lagrangian<N, Model: Constraints<N, C>>,
{
    let (start, times) = start(motion);
    let end = times[times.len() - 1];
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let problem = Problem::new(model, start).save(times);
    let found = problem.solve(end, method).expect("a motion");
    compare_states(
        &Along::new(motion, "DOP853"),
        model,
        found.samples(),
        figures,
    );
}

/// The initial state, and the times of the samples.
fn start<const N: usize>(motion: &Motion) -> (State<f64, N>, Vec<f64>) {
    let samples = list(&motion.system["samples"]);
    let times: Vec<f64> = samples.iter().map(|sample| number(&sample["t"])).collect();
    let [q, v] = ["q", "qd"].map(|name| array(&motion.system["init"][name]));
    (State::new(times[0], q, v), times)
}

fn compare_states<M, const N: usize, const C: usize>(
    along: &Along<'_>,
    model: &M,
    states: &[State<f64, N>],
    figures: &mut Figures,
) where
    M: Lagrangian<N, Model: Constraints<N, C>>,
{
    assert_eq!(states.len(), along.samples.len(), "{}", along.name);
    let of_state = if along.name.starts_with("andrews") {
        SQUEEZER_TOLERANCE
    } else {
        TOLERANCE
    };
    let mut compare = |quantity, tolerance, value: &dyn Fn(&State<f64, N>) -> Vec<f64>| {
        along.record(quantity, states.iter().map(value), tolerance, figures);
    };
    compare("q", of_state, &|x| rows(&x.q));
    compare("qd", of_state, &|x| rows(&x.v));
    compare("qdd", TOLERANCE, &|x| rows(&model.accelerations(x)));
    compare("lambda", TOLERANCE, &|x| rows(&model.multipliers(x)));
    compare("jacobi", TOLERANCE, &|x| vec![model.energy(x)]);
    for state in states {
        let at = format!("{}, t = {}", along.name, state.t);
        figures.record("residuals", &at, largest_residual(model, state), ROUNDING);
    }
}

/// The largest residual of a constraint, in terms of its gradient times the state.
fn largest_residual<M, const N: usize, const C: usize>(model: &M, state: &State<f64, N>) -> f64
where
    M: Lagrangian<N, Model: Constraints<N, C>>,
{
    let (positions, velocities) = model.constraint_residuals(state);
    let slopes = model.constraint_jacobian(state).abs();
    let relative = |residuals: SVector<f64, C>, x: SVector<f64, N>| {
        let scales = (slopes * x.abs()).add_scalar(f64::MIN_POSITIVE);
        residuals.component_div(&scales).amax()
    };
    relative(positions, state.q).max(relative(velocities, state.v))
}

fn compare_forces<M, const N: usize, const C: usize>(
    motion: &Motion,
    model: &M,
    figures: &mut Figures,
) where
    M: Lagrangian<N, Model: Constraints<N, C> + Energies<N>>,
{
    let along = Along::new(motion, "at the reference");
    let states = along.samples.iter().map(|sample| {
        let [t, q, v] = ["t", "q", "qd"].map(|quantity| &sample[quantity]);
        State::new(number(t), array(q), array(v))
    });
    let states: Vec<State<f64, N>> = states.collect();
    let mut compare = |quantity, value: &dyn Fn(&State<f64, N>) -> Vec<f64>| {
        along.record(
            quantity,
            states.iter().map(value),
            POINTWISE_TOLERANCE,
            figures,
        );
    };
    compare("p", &|x| rows(&model.momenta(x)));
    compare("T", &|x| vec![model.kinetic_energy(x)]);
    compare("V", &|x| vec![model.potential_energy(x)]);
    compare("qdd", &|x| rows(&model.accelerations(x)));
    compare("lambda", &|x| rows(&model.multipliers(x)));
}

/// The samples of a motion, to which those of another are compared.
struct Along<'a> {
    name: String,
    samples: &'a [serde_json::Value],
}

impl<'a> Along<'a> {
    fn new(motion: &'a Motion, method: &str) -> Self {
        let (id, scenario) = (text(&motion.system["id"]), &motion.system["scenario"]);
        Self {
            name: format!("{id}, scenario {scenario}, {method}"),
            samples: list(&motion.system["samples"]),
        }
    }

    /// Takes note of the errors of a quantity, relative to its greatest entry along the motion.
    fn record(
        &self,
        quantity: &'static str,
        found: impl Iterator<Item = Vec<f64>>,
        tolerance: f64,
        figures: &mut Figures,
    ) {
        let expected = self.samples.iter().map(|sample| numbers(&sample[quantity]));
        let expected: Vec<_> = expected.collect();
        let scale = expected
            .iter()
            .flatten()
            .fold(0.0, |scale: f64, x| scale.max(x.abs()));
        for ((found, expected), sample) in found.zip(&expected).zip(self.samples) {
            let at = format!("{}, t = {}", self.name, text(&sample["t"]));
            let error = relative_error(&found, expected, scale.max(f64::MIN_POSITIVE));
            figures.record(quantity, &at, error, tolerance);
        }
    }
}

/// The corner of the chain that the data list besides.
fn compare_points(motion: &Motion, bricard: &Bricard, figures: &mut Figures) {
    for sample in list(&motion.system["samples"]) {
        let [q, v] = ["q", "qd"].map(|quantity| array(&sample[quantity]));
        let found = bricard
            .outputs(&State::new(number(&sample["t"]), q, v))
            .third;
        let expected = ["P3x", "P3y", "P3z"].map(|axis| number(&sample["observables"][axis]));
        let error = relative_error(found.as_slice(), &expected, 1.0);
        figures.record("points", text(&sample["t"]), error, POINTWISE_TOLERANCE);
    }
}
