//! Whether the recurrence of a Taylor series gives the time derivatives of the values of a program along any motion.
//!
//! The coefficients of order 0 to 3 are computed twice: by the recurrence, and from the program on jets.

use crate::identity::real_point::RealPoint;
use crate::program::taylor::TaylorProgram;
use crate::validation::comparison::{Comparison, Comparisons};
use crate::validation::jet::Jet;
use crate::validation::method::Method;
use crate::validation::number::Number as _;
use crate::validation::perturbation::Perturbation;
use crate::validation::recurrence_tape::{Known, RecurrenceTape, agree, input};
use crate::validation::tape::Tape;
use crate::{Graph, Program, Symbol};

/// Distinguishes the random numbers of the third derivatives of coordinates.
const THIRD_DERIVATIVES: u64 = 0x6a65_726b;

/// The tapes of what is compared.
pub struct ValueSeriesCheck {
    values: Tape,
    taylor: RecurrenceTape,
    /// The number of values.
    count: usize,
}

impl ValueSeriesCheck {
    /// The check of `taylor`, which was made of `program`, scheduled from `graph`.
    #[must_use]
    pub fn new(graph: &Graph, program: &Program, taylor: &TaylorProgram) -> Self {
        let values = Tape::of_program_with_slopes(graph, program);
        Self {
            count: values.outputs().len(),
            values,
            taylor: RecurrenceTape::of(taylor),
        }
    }

    /// Whether the two agree at random points of the domain, and exist at most of them; true if there is none.
    #[must_use]
    pub fn agrees(&self) -> bool {
        agree(&|point, perturbation| self.compare(point, perturbation))
    }

    /// The differences of the coefficients at a point; none outside of the domain.
    fn compare(&self, point: RealPoint, perturbation: Perturbation) -> Option<Vec<Comparison>> {
        let jets = self
            .values
            .run(&|symbol| along(point, symbol), perturbation);
        let expected = self.values.outputs_of(&jets);
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
        comparisons.forgive_overflow(Jet::largest(&jets));
        Some(comparisons.0)
    }

    /// The coefficients of order 0 to 3 by the recurrence.
    fn series(&self, point: RealPoint, perturbation: Perturbation) -> [Vec<f64>; 4] {
        let value = |symbol: Symbol| point.value(symbol);
        let (mut initial, invariants) = self.taylor.initial(&value, perturbation);
        initial.truncate(self.count);
        let mut found = [initial, Vec::new(), Vec::new(), Vec::new()];
        // The factors of order 1, 2, …
        let mut factors: Vec<Vec<f64>> = Vec::new();
        for (k, found) in found.iter_mut().enumerate().skip(1) {
            let known = Known {
                invariants: &invariants,
                factors: &factors,
            };
            let term = |symbol: Symbol| along(point, symbol).0[k];
            let mut terms = self.taylor.terms(&known, &term, perturbation);
            factors.push(terms.split_off(self.count));
            *found = terms;
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
