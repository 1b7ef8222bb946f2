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
        Self {
            t: of("t")[0],
            q: of("q"),
            v: of("qd"),
            params: of("params"),
            trial: of("trial"),
        }
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
