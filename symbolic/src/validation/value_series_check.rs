//! Whether the recurrence of a Taylor series gives the time derivatives of the values of a program along any motion.
//!
//! The coefficients of order 0 to 3 are computed twice: by the recurrence, and from the program on jets.

use crate::identity::real_point::RealPoint;
use crate::limits::{VALIDATED_POINTS, VALIDATION_ATTEMPTS};
use crate::program::taylor::TaylorProgram;
use crate::validation::comparison::{Comparison, Comparisons};
use crate::validation::jet::Jet;
use crate::validation::number::Number as _;
use crate::validation::perturbation::Perturbation;
use crate::validation::programs::Method;
use crate::validation::series_check::input;
use crate::validation::tape::Tape;
use crate::validation::validator::unexplained;
use crate::{Program, Symbol};

/// Distinguishes the random numbers of the third derivatives of coordinates.
const THIRD_DERIVATIVES: u64 = 0x6a65_726b;

/// The tapes of what is compared.
pub struct ValueSeriesCheck {
    values: Tape,
    initial: Tape,
    recurrence: Tape,
    convolutions: Vec<[usize; 2]>,
    invariants: usize,
    /// The number of values.
    count: usize,
}

impl ValueSeriesCheck {
    /// The check of `taylor`, which was made of `program`.
    #[must_use]
    pub fn new(program: &Program, taylor: &TaylorProgram) -> Self {
        let last = taylor.initial.groups.last();
        let pairs = taylor.convolutions.iter();
        let values = Tape::of_program(program);
        Self {
            count: values.outputs().len(),
            values,
            initial: Tape::of_program(&taylor.initial),
            recurrence: Tape::of_program(&taylor.recurrence),
            convolutions: pairs.map(|pair| [pair.0, pair.1]).collect(),
            invariants: last.map_or(0, |group| group.outputs.len()),
        }
    }

    /// Whether the two agree at random points of the domain, and exist at most of them; true if there is none.
    #[must_use]
    pub fn agrees(&self) -> bool {
        let (mut points, mut undefined) = (0, 0);
        for number in 0..VALIDATION_ATTEMPTS {
            let point = RealPoint::new(number);
            let compare = |perturbation| self.compare(point, perturbation);
            let Some(comparisons) = compare(Perturbation(None)) else {
                continue;
            };
            points += 1;
            if comparisons.iter().any(|x| !x.difference.is_finite()) {
                undefined += 1;
            }
            if !unexplained(&comparisons, &compare).is_empty() {
                return false;
            }
            if points == VALIDATED_POINTS {
                break;
            }
        }
        2 * undefined <= points
    }

    /// The differences of the coefficients at a point; none outside of the domain.
    fn compare(&self, point: RealPoint, perturbation: Perturbation) -> Option<Vec<Comparison>> {
        let jets = self
            .values
            .run(&|symbol| along(point, symbol), perturbation);
        let expected = self.values.outputs().iter();
        let expected: Vec<Jet> = expected.map(|slot| jets[*slot as usize]).collect();
        let is_finite = expected.iter().flat_map(|jet| jet.0).all(f64::is_finite);
        if !is_finite {
            return None;
        }
        let found = self.series(point, perturbation);
        let mut comparisons = Comparisons::default();
        for (k, found) in found.iter().enumerate() {
            let expected: Vec<f64> = expected.iter().map(|jet| jet.0[k]).collect();
            comparisons.values(Method::Outputs, found, &expected);
        }
        Some(comparisons.0)
    }

    /// The coefficients of order 0 to 3 by the recurrence.
    fn series(&self, point: RealPoint, perturbation: Perturbation) -> [Vec<f64>; 4] {
        let value = |symbol: Symbol| point.value(symbol);
        let mut initial = self.initial.evaluate(&value, perturbation);
        let invariants = initial.split_off(initial.len() - self.invariants);
        initial.truncate(self.count);
        let mut found = [initial, Vec::new(), Vec::new(), Vec::new()];
        // The factors of order 1, 2, …
        let mut factors: Vec<Vec<f64>> = Vec::new();
        for (k, order) in (1..).zip([1.0, 2.0, 3.0]) {
            let term = |symbol: Symbol| match symbol {
                Symbol::Time | Symbol::Coordinate(_) | Symbol::Velocity(_) | Symbol::Input(_) => {
                    along(point, symbol).0[k]
                }
                Symbol::Order => order,
                Symbol::ReciprocalOrder => 1.0 / order,
                Symbol::Convolution(i) => {
                    let [first, second] = self.convolutions[i as usize];
                    let products =
                        (1..k).map(|j| factors[j - 1][first] * factors[k - j - 1][second]);
                    products.sum()
                }
                Symbol::Invariant(i) => invariants[i as usize],
                _ => f64::NAN,
            };
            let mut terms = self.recurrence.evaluate(&term, perturbation);
            factors.push(terms.split_off(self.count));
            found[k] = terms;
        }
        found
    }
}

/// A symbol along a motion with random derivatives.
fn along(point: RealPoint, symbol: Symbol) -> Jet {
    let value = point.value(symbol);
    let higher = |i: u32| {
        let second = point.value(Symbol::Acceleration(i));
        (second, point.weight(THIRD_DERIVATIVES, i as usize))
    };
    match symbol {
        Symbol::Time => Jet([value, 1.0, 0.0, 0.0]),
        Symbol::Coordinate(i) => {
            let (second, third) = higher(i);
            let velocity = point.value(Symbol::Velocity(i));
            Jet([value, velocity, second / 2.0, third / 6.0])
        }
        Symbol::Velocity(i) => {
            let (second, third) = higher(i);
            Jet([value, second, third / 2.0, value * third / 6.0])
        }
        Symbol::Input(_) => input(value),
        _ => Jet::constant(value),
    }
}
