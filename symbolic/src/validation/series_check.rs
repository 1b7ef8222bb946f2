//! Whether the recurrence of a Taylor series gives the time derivatives of the accelerations.
//!
//! The coefficients of order 0 to 3 are computed twice: by the recurrence, and from the program for q̈ on jets. A
//! recurrence is the same for all orders; in order 3 the factors of order 2 of every convolution count.

use crate::identity::real_point::RealPoint;
use crate::program::taylor::TaylorProgram;
use crate::validation::comparison::{Comparison, Comparisons};
use crate::validation::jet::Jet;
use crate::validation::method::Method;
use crate::validation::number::Number as _;
use crate::validation::perturbation::Perturbation;
use crate::validation::recurrence_tape::{Known, RecurrenceTape, agree, input};
use crate::validation::square_matrix::SquareMatrix;
use crate::validation::tape::Tape;
use crate::{Graph, Program, Symbol};

/// The coefficients of the accelerations, of order 0 to 3.
type Coefficients = [Vec<f64>; 4];

/// The tapes of what is compared.
pub struct SeriesCheck {
    preparation: Tape,
    accelerations: Tape,
    taylor: RecurrenceTape,
    coordinates: usize,
    /// The number of pivots before q̈, unless M and f are computed.
    pivots: Option<usize>,
    /// Whether the recurrence leaves it to solve for q̈ numerically.
    is_numerical: bool,
    /// The number of quasi-velocities, if the recurrence is that of velocities and of these.
    quasi_velocities: Option<usize>,
}

impl SeriesCheck {
    /// The check of `taylor`, which was made of the program `accelerations` with the setup program `preparation`, both
    /// scheduled from `graph`. That program computes as many pivots and q̈, or M and f. The last numbers are those of
    /// accelerations and multipliers, and whether these are solved for numerically.
    #[must_use]
    pub fn new(
        graph: &Graph,
        preparation: &Program,
        (accelerations, pivots): (&Program, Option<usize>),
        taylor: &TaylorProgram,
        (coordinates, is_numerical): (usize, bool),
    ) -> Self {
        Self {
            preparation: Tape::of_program(preparation),
            accelerations: Tape::of_program_with_slopes(graph, accelerations),
            taylor: RecurrenceTape::of(taylor),
            coordinates,
            pivots,
            is_numerical,
            quasi_velocities: taylor.quasi_velocities,
        }
    }

    /// Whether the two agree at random points of the domain, and exist at most of them; true if there is none.
    #[must_use]
    pub fn agrees(&self) -> bool {
        agree(&|point, perturbation| {
            let prepared = self
                .preparation
                .evaluate(&|symbol| point.value(symbol), perturbation);
            let at_point = AtPoint {
                check: self,
                point,
                prepared,
                perturbation,
            };
            at_point.compare()
        })
    }
}

/// A check at one point.
struct AtPoint<'a> {
    check: &'a SeriesCheck,
    point: RealPoint,
    /// The invariants of the program for q̈.
    prepared: Vec<f64>,
    perturbation: Perturbation,
}

impl AtPoint<'_> {
    /// The differences of the coefficients; none outside of the domain.
    fn compare(&self) -> Option<Vec<Comparison>> {
        let (motion, largest) = self.motion()?;
        let found = match self.check.quasi_velocities {
            Some(count) => self.recurrence_in_quasi_velocities(count, &motion),
            None => self.recurrence(&motion)?,
        };
        let mut comparisons = Comparisons::default();
        for (found, expected) in found.iter().zip(&motion) {
            if self.check.is_numerical {
                comparisons.solutions(Method::Accelerations, found, expected);
            } else {
                comparisons.values(Method::Accelerations, found, expected);
            }
        }
        comparisons.forgive_overflow(largest);
        Some(comparisons.0)
    }

    /// The coefficients of the accelerations, by automatic differentiation, and the largest intermediate result.
    fn motion(&self) -> Option<(Coefficients, f64)> {
        let mut largest = 0.0_f64;
        let unknown = vec![0.0; self.check.coordinates];
        let mut motion: Coefficients = core::array::from_fn(|_| unknown.clone());
        for order in 0..motion.len() {
            let (along, size) = self.along(&motion);
            largest = largest.max(size);
            motion[order] = self.solution(&along, &motion, order)?;
        }
        let is_finite = motion.iter().flatten().all(|x| x.is_finite());
        is_finite.then_some((motion, largest))
    }

    /// The outputs of the program along the motion, as far as it is known, and the largest coefficient of a result.
    fn along(&self, motion: &Coefficients) -> (Vec<Jet>, f64) {
        let symbol = |symbol: Symbol| {
            let value = self.point.value(symbol);
            match symbol {
                Symbol::Time => Jet([value, 1.0, 0.0, 0.0]),
                Symbol::Coordinate(i) => {
                    let velocity = self.point.value(Symbol::Velocity(i));
                    let i = i as usize;
                    Jet([value, velocity, motion[0][i] / 2.0, motion[1][i] / 6.0])
                }
                Symbol::Velocity(i) => {
                    let i = i as usize;
                    Jet([value, motion[0][i], motion[1][i] / 2.0, motion[2][i] / 3.0])
                }
                Symbol::Input(_) => input(value),
                Symbol::Invariant(i) => Jet::constant(self.prepared[i as usize]),
                _ => Jet::constant(value),
            }
        };
        let tape = &self.check.accelerations;
        let values = tape.run(&symbol, self.perturbation);
        (tape.outputs_of(&values), Jet::largest(&values))
    }

    /// The coefficient of this order of the accelerations, where those of lower orders are known.
    fn solution(&self, outputs: &[Jet], motion: &Coefficients, order: usize) -> Option<Vec<f64>> {
        let of_order = |part: &[Jet], order: usize| -> Vec<f64> {
            part.iter().map(|jet| jet.0[order]).collect()
        };
        if let Some(pivots) = self.check.pivots {
            return Some(of_order(&outputs[pivots..], order));
        }
        // M₀ q̈ₖ = fₖ − Σ Mᵢ q̈ₖ₋ᵢ.
        let n = self.check.coordinates;
        let (lower, forcing) = outputs.split_at(outputs.len() - n);
        let mass = |order| SquareMatrix::symmetric(&of_order(lower, order), n);
        let mut right = of_order(forcing, order);
        for i in 1..=order {
            for (x, product) in right.iter_mut().zip(mass(i).times(&motion[order - i])) {
                *x -= product.total;
            }
        }
        mass(0).solve(&right)
    }

    /// The coefficients by the recurrence, where that of order 0 is given.
    fn recurrence(&self, motion: &Coefficients) -> Option<Coefficients> {
        let n = self.check.coordinates;
        let (outputs, invariants) = self.initial(motion);
        let mut found = motion.clone();
        // The factors of order 1, 2, …
        let mut factors: Vec<Vec<f64>> = Vec::new();
        for (k, found) in found.iter_mut().enumerate().skip(1) {
            let known = Known {
                invariants: &invariants,
                factors: &factors,
            };
            let unknown = vec![0.0; n];
            let evaluate = |accelerations: &[f64]| {
                let symbol = |symbol| match symbol {
                    Symbol::Acceleration(i) => accelerations[i as usize],
                    _ => term(self.point, motion, symbol, k),
                };
                self.check.taylor.terms(&known, &symbol, self.perturbation)
            };
            let mut terms = evaluate(&unknown);
            *found = terms[..n].to_vec();
            if self.check.is_numerical {
                let (lower, _) = outputs.split_at(outputs.len() - n);
                *found = SquareMatrix::symmetric(lower, n).solve(found)?;
                terms = evaluate(found);
            }
            factors.push(terms.split_off(n));
        }
        Some(found)
    }

    /// The coefficients by a recurrence for velocities and quasi-velocities: those of q̈ are k q̇ₖ, k = 1, 2, …
    fn recurrence_in_quasi_velocities(&self, count: usize, motion: &Coefficients) -> Coefficients {
        let n = self.check.coordinates;
        let (mut outputs, invariants) = self.initial(motion);
        // The rates of the order before.
        let mut rates = outputs.split_off(count + n);
        let mut factors: Vec<Vec<f64>> = Vec::new();
        let orders = [1.0, 2.0, 3.0, 4.0];
        orders.map(|order| {
            let known = Known {
                invariants: &invariants,
                factors: &factors,
            };
            let symbol = |symbol| match symbol {
                Symbol::QuasiVelocity(i) => rates[i as usize] / order,
                _ => term(self.point, motion, symbol, factors.len() + 1),
            };
            let mut terms = self.check.taylor.terms(&known, &symbol, self.perturbation);
            factors.push(terms.split_off(n + count));
            rates = terms.split_off(n);
            terms.iter().map(|velocity| velocity * order).collect()
        })
    }

    /// The outputs of order 0, and the invariants.
    fn initial(&self, motion: &Coefficients) -> (Vec<f64>, Vec<f64>) {
        let symbol = |symbol: Symbol| match symbol {
            Symbol::Acceleration(i) => motion[0][i as usize],
            Symbol::Invariant(i) => self.prepared[i as usize],
            _ => self.point.value(symbol),
        };
        self.check.taylor.initial(&symbol, self.perturbation)
    }
}

/// The term of order k ≥ 1 of what varies along a motion, from the coefficients of its accelerations.
fn term(point: RealPoint, motion: &Coefficients, symbol: Symbol, k: usize) -> f64 {
    let order = (0..k).fold(0.0, |order, _| order + 1.0);
    match symbol {
        Symbol::Time => f64::from(u8::from(k == 1)),
        Symbol::Coordinate(i) if k == 1 => point.value(Symbol::Velocity(i)),
        Symbol::Coordinate(i) => motion[k - 2][i as usize] / (order * (order - 1.0)),
        Symbol::Velocity(i) => motion[k - 1][i as usize] / order,
        Symbol::Input(_) => input(point.value(symbol)).0.get(k).copied().unwrap_or(0.0),
        _ => f64::NAN,
    }
}
