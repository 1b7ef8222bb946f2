//! Where a model is evaluated.

use lagrangian::State;
use nalgebra::SMatrix;
use serde_json::Value;

/// A state, with the values of the parameters and inputs, and trial accelerations.
#[derive(Clone, Debug)]
pub struct At {
    t: f64,
    q: Vec<f64>,
    v: Vec<f64>,
    params: Vec<f64>,
    trial: Vec<f64>,
    /// The final time, if a motion is integrated.
    end: f64,
    /// Coordinates, velocities and final times of motions in lanes.
    starts: Vec<f64>,
    run: Option<Run>,
    /// The quantities that there are references for.
    asked: Vec<String>,
}

/// How a motion is split into runs, and what is watched for.
#[derive(Clone, Debug)]
pub(crate) struct Run {
    pub(crate) method: String,
    pub(crate) way: String,
    /// Whether declared events are watched for, or a closure.
    pub(crate) is_declared: bool,
    /// The greatest step, or that of a method with fixed steps.
    pub(crate) step: f64,
    /// The indices of events among those declared, and the signs of their directions.
    pub(crate) watched: [(usize, f64); 2],
    /// Where the runs end.
    pub(crate) times: Vec<f64>,
}

impl Run {
    /// The run of the data.
    fn new(run: &Value) -> Self {
        let of = |name: &str| run[name].as_str().expect("a string").to_owned();
        let watched = numbers(&run["watched"]);
        let watched = [0, 2].map(|i| (index(watched[i]), watched[i + 1]));
        Self {
            method: of("method"),
            way: of("way"),
            is_declared: run["declared"]
                .as_bool()
                .expect("whether events are declared"),
            step: numbers(&run["step"])[0],
            watched,
            times: numbers(&run["times"]),
        }
    }
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // A small integer.
fn index(number: f64) -> usize {
    number as usize
}

impl At {
    /// The state of the data.
    ///
    /// # Panics
    ///
    /// If one of its vectors is missing.
    #[must_use]
    pub fn new(state: &Value) -> Self {
        let of = |name: &str| numbers(&state[name]);
        let some = |name: &str| state.get(name).map_or_else(Vec::new, numbers);
        Self {
            t: of("t")[0],
            q: of("q"),
            v: of("qd"),
            params: of("params"),
            trial: of("trial"),
            end: some("end").first().copied().unwrap_or(f64::NAN),
            starts: some("starts"),
            run: state.get("run").map(Run::new),
            asked: state["values"]
                .as_object()
                .map(|values| values.keys().cloned().collect())
                .unwrap_or_default(),
        }
    }

    /// Whether there is a reference for a quantity.
    pub(crate) fn asks_for(&self, quantity: &str) -> bool {
        self.asked.iter().any(|name| name == quantity)
    }

    /// The final time of the motion, not a number where there is none.
    pub(crate) fn end(&self) -> f64 {
        self.end
    }

    /// The states at which motions begin, and when they end.
    pub(crate) fn starts<const N: usize>(&self) -> Vec<(State<f64, N>, f64)> {
        let each = self.starts.chunks(2 * N + 1);
        each.map(|start| {
            let state = State::new(self.t, array(&start[..N]), array(&start[N..2 * N]));
            (state, start[2 * N])
        })
        .collect()
    }

    pub(crate) fn run(&self) -> &Run {
        self.run.as_ref().expect("how a motion is split into runs")
    }

    /// Time, coordinates and velocities.
    ///
    /// # Panics
    ///
    /// If they are not `N`.
    #[must_use]
    pub fn state<const N: usize>(&self) -> State<f64, N> {
        State::new(self.t, array(&self.q), array(&self.v))
    }

    /// Accelerations that are not those of the motion.
    ///
    /// # Panics
    ///
    /// If they are not `N`.
    #[must_use]
    pub fn trial<const N: usize>(&self) -> [f64; N] {
        array(&self.trial)
    }
}

fn array<const N: usize>(entries: &[f64]) -> [f64; N] {
    entries.try_into().expect("as many numbers as coordinates")
}

/// The decimal numbers of a string, apart by blanks.
///
/// # Panics
///
/// If it is no such string.
#[must_use]
pub(crate) fn numbers(value: &Value) -> Vec<f64> {
    let text = value
        .as_str()
        .unwrap_or_else(|| panic!("expected numbers, found {value}"));
    let number = |word: &str| {
        word.parse()
            .unwrap_or_else(|_| panic!("`{word}` is no number"))
    };
    text.split_whitespace().map(number).collect()
}

/// The values of a model's fields, one after the other and matrices row by row.
#[derive(Debug)]
pub struct Values(Box<dyn Numbers>);

trait Numbers: Iterator<Item = f64> + std::fmt::Debug {}

impl<I: Iterator<Item = f64> + std::fmt::Debug> Numbers for I {}

impl Values {
    /// Those at a state.
    #[must_use]
    pub fn of(at: &At) -> Self {
        Self(Box::new(at.params.clone().into_iter()))
    }

    /// Not a number, for every field.
    #[must_use]
    pub fn unknown() -> Self {
        Self(Box::new(std::iter::repeat(f64::NAN)))
    }

    /// The next field, a number.
    ///
    /// # Panics
    ///
    /// If there is none.
    pub fn number(&mut self) -> f64 {
        self.0.next().expect("a value for each field")
    }

    /// The next field, a vector or matrix.
    ///
    /// # Panics
    ///
    /// If there are too few numbers.
    pub fn matrix<const R: usize, const C: usize>(&mut self) -> SMatrix<f64, R, C> {
        SMatrix::from_row_iterator((0..R * C).map(|_| self.number()))
    }
}
