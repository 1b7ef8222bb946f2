//! Whether a reduced model is the Routhian of its full model, numerically.
//!
//! At random points of the reduced model, p of the ignorable coordinates is computed by automatic differentiation of the
//! energies as they were first built, at the eliminated velocities u. By Routh's theorem it suffices that p = C, that
//! L − C·u = `L_R`, and that the generalized forces are the same; `V_eff` is −`L_R` at rest. Outputs are the same where the
//! ignorable coordinates have the velocities u and the accelerations du/dt, by automatic differentiation, too. That the
//! equations of the reduced model are those of `L_R` is checked as for every model.

use crate::identity::real_point::RealPoint;
use crate::limits::{VALIDATED_POINTS, VALIDATION_ATTEMPTS};
use crate::mechanics::routhian::Reduction;
use crate::validation::hyper_dual::HyperDual;
use crate::validation::number::Number as _;
use crate::validation::perturbation::Perturbation;
use crate::validation::tape::Tape;
use crate::{Expression, Model, Symbol};

/// Relative differences below this one are rounding errors, at most points.
const ROUNDED: f64 = 1e-7;

/// Nothing is perturbed.
const EXACT: Perturbation = Perturbation(None);

/// The tapes of what is compared.
pub struct ReductionCheck<'a> {
    reduction: &'a Reduction,
    parameters: u32,
    /// L of the full model as a sum of roots, then D, the forces, the constraints, and the outputs.
    full: Tape,
    weights: &'static [f64],
    /// u; then `V_eff`.
    eliminated: Tape,
    /// The same of the reduced model as of the full one, with the outputs that it determines.
    reduced: Tape,
    reduced_weights: &'static [f64],
    /// The energies of the reduced model as they are evaluated, and their weights.
    evaluated: Option<(Tape, &'static [f64])>,
}

impl<'a> ReductionCheck<'a> {
    /// The check of the reduction of `model`, which has so many `parameters`.
    #[must_use]
    pub fn new(model: &Model, reduction: &'a Reduction, parameters: u32) -> Self {
        let (mut full, weights) = roots(model);
        full.extend(&model.outputs);
        let (mut reduced, reduced_weights) = roots(&reduction.model);
        reduced.extend(reduction.outputs.iter().flatten());
        let mut eliminated = reduction.ignorable_velocities.clone();
        eliminated.push(reduction.effective_potential);
        let graph = &reduction.model.graph;
        Self {
            reduction,
            parameters,
            full: Tape::of_expressions(&model.graph, &full),
            weights,
            eliminated: Tape::of_expressions(graph, &eliminated),
            reduced: Tape::of_expressions(graph, &reduced),
            reduced_weights,
            evaluated: reduction.model.evaluated.map(|energies| {
                let (roots, weights) = energies.weighted();
                (Tape::of_expressions(graph, &roots), weights)
            }),
        }
    }

    /// Whether all agree at most random points of the domain; true if there is none.
    #[must_use]
    pub fn agrees(&self) -> bool {
        let points = (0..VALIDATION_ATTEMPTS).map(RealPoint::new);
        let errors = points.filter_map(|point| self.largest_difference(point));
        let errors: Vec<f64> = errors.take(VALIDATED_POINTS).collect();
        let is_wrong = |error: &&f64| error.is_nan() || **error >= ROUNDED;
        let wrong = errors.iter().filter(is_wrong).count();
        2 * wrong <= errors.len()
    }

    /// What is compared at a point, and `V_eff` there; none if there are no ignorable coordinates.
    fn at(&self, point: RealPoint) -> Option<(AtPoint<'_>, f64)> {
        let moving = |symbol: Symbol| HyperDual {
            first: match symbol {
                Symbol::Time => 1.0,
                Symbol::Coordinate(i) => point.value(Symbol::Velocity(i)),
                Symbol::Velocity(i) => point.value(Symbol::Acceleration(i)),
                _ => 0.0,
            },
            ..HyperDual::constant(point.value(symbol))
        };
        let values = self.eliminated.evaluate(&moving, EXACT);
        let (potential, velocities) = values.split_last()?;
        let at_point = AtPoint {
            check: self,
            point,
            velocities: velocities.iter().map(|u| u.value).collect(),
            accelerations: velocities.iter().map(|u| u.first).collect(),
        };
        Some((at_point, potential.value))
    }

    fn constant(&self, k: usize) -> Symbol {
        Symbol::Parameter(self.parameters + u32::try_from(k).unwrap_or(u32::MAX))
    }

    /// The largest relative difference at a point; none outside of the domain.
    fn largest_difference(&self, point: RealPoint) -> Option<f64> {
        let (at_point, potential) = self.at(point)?;
        let velocities = &at_point.velocities;
        let lagrangian = at_point.lagrangian(None);
        if !lagrangian.value.is_finite() || velocities.iter().any(|u| !u.is_finite()) {
            return None;
        }
        let mut most = Largest(0.0);
        let mut routhian = lagrangian.value;
        let mut size = lagrangian.value.abs();
        for (k, velocity) in velocities.iter().enumerate() {
            let constant = point.value(self.constant(k));
            let momentum = at_point.lagrangian(Some(self.reduction.ignorable[k]));
            most.compare(momentum.first, constant, 1e-3);
            routhian -= constant * velocity;
            size += (constant * velocity).abs();
        }
        let symbol = |symbol| point.value(symbol);
        let roots = self.reduced.evaluate(&symbol, EXACT);
        most.compare(weighted(&roots, self.reduced_weights), routhian, size);
        if let Some((tape, weights)) = &self.evaluated {
            let evaluated = tape.evaluate(&symbol, EXACT);
            most.compare(weighted(&evaluated, weights), routhian, size);
        }
        let still = |symbol: Symbol| match symbol {
            Symbol::Velocity(_) => 0.0,
            other => point.value(other),
        };
        let resting = weighted(&self.reduced.evaluate(&still, EXACT), self.reduced_weights);
        most.compare(potential, -resting, size);
        let (of_full, of_reduced) = (self.weights.len() + 1, self.reduced_weights.len() + 1);
        let remaining = &self.reduction.remaining;
        for (k, i) in remaining.iter().enumerate() {
            most.compare(roots[of_reduced + k], at_point.force(*i), 1e-3);
        }
        let all = at_point.roots(None);
        let observed = &all[of_full + remaining.len() + velocities.len()..];
        let constraints = self.reduction.model.constraints.len();
        let outputs = self.reduction.outputs.iter().map(Result::is_ok);
        let is_determined = core::iter::repeat_n(true, constraints).chain(outputs);
        let determined = observed.iter().zip(is_determined);
        let determined = determined.filter(|(_, is_determined)| *is_determined);
        let found = &roots[of_reduced + remaining.len()..];
        for ((expected, _), found) in determined.zip(found) {
            if expected.value.is_finite() {
                most.compare(*found, expected.value, 1e-3);
            }
        }
        Some(most.0)
    }
}

/// The full model at a point of the reduced one.
struct AtPoint<'a> {
    check: &'a ReductionCheck<'a>,
    point: RealPoint,
    /// u, the velocities of the ignorable coordinates.
    velocities: Vec<f64>,
    /// du/dt along a motion through the point.
    accelerations: Vec<f64>,
}

impl AtPoint<'_> {
    /// The roots of the full model where one velocity has the derivative 1.
    fn roots(&self, varied: Option<usize>) -> Vec<HyperDual> {
        let symbol = |symbol: Symbol| HyperDual {
            first: match symbol {
                Symbol::Velocity(i) if varied == Some(i as usize) => 1.0,
                _ => 0.0,
            },
            ..HyperDual::constant(self.value(symbol))
        };
        self.check.full.evaluate(&symbol, EXACT)
    }

    fn lagrangian(&self, varied: Option<usize>) -> HyperDual {
        let roots = self.roots(varied);
        let mut sum = HyperDual::default();
        for (root, weight) in roots.iter().zip(self.check.weights) {
            sum.value += weight * root.value;
            sum.first += weight * root.first;
        }
        sum
    }

    /// The generalized force on a coordinate of the full model.
    fn force(&self, coordinate: usize) -> f64 {
        let roots = self.roots(Some(coordinate));
        let dissipation = self.check.weights.len();
        roots[dissipation + 1 + coordinate].value - roots[dissipation].first
    }

    /// The value of a symbol of the full model.
    fn value(&self, symbol: Symbol) -> f64 {
        let (point, reduction) = (self.point, self.check.reduction);
        let position = |list: &[usize], i: u32| list.iter().position(|j| *j == i as usize);
        let place = |i: u32| u32::try_from(position(&reduction.remaining, i)?).ok();
        let ignorable = |i: u32| position(&reduction.ignorable, i);
        match symbol {
            Symbol::Coordinate(i) => match place(i) {
                Some(place) => point.value(Symbol::Coordinate(place)),
                // It does not matter.
                None => 1.0 + point.weight(0, i as usize) / 2.0,
            },
            Symbol::Velocity(i) => match (place(i), ignorable(i)) {
                (Some(place), _) => point.value(Symbol::Velocity(place)),
                (None, Some(k)) => self.velocities[k],
                (None, None) => 0.0,
            },
            Symbol::Acceleration(i) => match (place(i), ignorable(i)) {
                (Some(place), _) => point.value(Symbol::Acceleration(place)),
                (None, Some(k)) => self.accelerations[k],
                // A multiplier.
                (None, None) => {
                    let behind = u32::try_from(reduction.ignorable.len()).unwrap_or(0);
                    point.value(Symbol::Acceleration(i.saturating_sub(behind)))
                }
            },
            other => point.value(other),
        }
    }
}

/// The largest relative difference so far.
struct Largest(f64);

impl Largest {
    fn compare(&mut self, found: f64, expected: f64, size: f64) {
        let difference = (found - expected).abs() / (found.abs() + expected.abs() + size);
        self.0 = if difference.is_finite() {
            self.0.max(difference)
        } else {
            f64::INFINITY
        };
    }
}

/// T and V, or L; then D, the forces and the constraints; and the weights of the first ones in L.
fn roots(model: &Model) -> (Vec<Expression>, &'static [f64]) {
    let (mut roots, weights) = model.energies.weighted();
    roots.push(model.dissipation);
    roots.extend(&model.forces);
    let constraints = model.constraints.iter();
    roots.extend(constraints.map(|constraint| constraint.expression()));
    (roots, weights)
}

fn weighted(values: &[f64], weights: &[f64]) -> f64 {
    let terms = values.iter().zip(weights);
    terms.map(|(value, weight)| value * weight).sum()
}
