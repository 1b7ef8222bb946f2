//! The recurrence of a Taylor series, evaluated order after order.

use crate::Symbol;
use crate::identity::real_point::RealPoint;
use crate::limits::{VALIDATED_POINTS, VALIDATION_ATTEMPTS};
use crate::program::taylor::TaylorProgram;
use crate::validation::comparison::Comparison;
use crate::validation::jet::Jet;
use crate::validation::perturbation::Perturbation;
use crate::validation::tape::Tape;
use crate::validation::validator::unexplained;

/// The tapes of a Taylor program.
pub(super) struct RecurrenceTape {
    initial: Tape,
    recurrence: Tape,
    convolutions: Vec<[usize; 2]>,
    invariants: usize,
}

/// What is known when the terms of an order are computed.
pub(super) struct Known<'a> {
    pub(super) invariants: &'a [f64],
    /// The factors of order 1, 2, … below the order.
    pub(super) factors: &'a [Vec<f64>],
}

impl RecurrenceTape {
    pub(super) fn of(taylor: &TaylorProgram) -> Self {
        let last = taylor.initial.groups.last();
        let pairs = taylor.convolutions.iter();
        Self {
            initial: Tape::of_program(&taylor.initial),
            recurrence: Tape::of_program(&taylor.recurrence),
            convolutions: pairs.map(|pair| [pair.0, pair.1]).collect(),
            invariants: last.map_or(0, |group| group.outputs.len()),
        }
    }

    /// The outputs of order 0, and the invariants.
    pub(super) fn initial(
        &self,
        symbol: &dyn Fn(Symbol) -> f64,
        perturbation: Perturbation,
    ) -> (Vec<f64>, Vec<f64>) {
        let mut outputs = self.initial.evaluate(&symbol, perturbation);
        let invariants = outputs.split_off(outputs.len() - self.invariants);
        (outputs, invariants)
    }

    /// The outputs of the recurrence for the order after that of the last factors. `symbol` tells the terms of that order
    /// of coordinates, velocities and the like.
    pub(super) fn terms(
        &self,
        known: &Known<'_>,
        symbol: &dyn Fn(Symbol) -> f64,
        perturbation: Perturbation,
    ) -> Vec<f64> {
        let k = known.factors.len() + 1;
        let order = (0..k).fold(0.0, |order, _| order + 1.0);
        let read = |of: Symbol| match of {
            Symbol::Order => order,
            Symbol::ReciprocalOrder => 1.0 / order,
            Symbol::Convolution(i) => {
                let [first, second] = self.convolutions[i as usize];
                let products =
                    (1..k).map(|j| known.factors[j - 1][first] * known.factors[k - j - 1][second]);
                products.sum()
            }
            Symbol::Invariant(i) => known.invariants[i as usize],
            other => symbol(other),
        };
        self.recurrence.evaluate(&read, perturbation)
    }
}

/// Whether two ways of computing coefficients agree at random points of the domain, and exist at most of them; true if
/// there is none. `compare` makes the comparisons at a point; none outside of the domain.
pub(super) fn agree(compare: &dyn Fn(RealPoint, Perturbation) -> Option<Vec<Comparison>>) -> bool {
    let (mut points, mut undefined) = (0, 0);
    for number in 0..VALIDATION_ATTEMPTS {
        let point = RealPoint::new(number);
        let compare = |perturbation| compare(point, perturbation);
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

/// An input as a function of time, from its value: some coefficients of every order that differ from input to input.
pub(super) fn input(value: f64) -> Jet {
    Jet([value, 0.5 - value, 0.25 + value, 0.75 * value])
}
