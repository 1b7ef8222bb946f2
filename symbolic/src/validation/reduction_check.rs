//! Whether a reduced model is the Routhian of its full model, numerically.
//!
//! At random points of the reduced model, p of the ignorable coordinates is computed by automatic differentiation of the
//! energies as they were first built, at the eliminated velocities u. By Routh's theorem it suffices that p = C, that
//! L − C·u = `L_R`, and that the generalized forces are the same; `V_eff` is −`L_R` at rest. That the equations of the reduced
//! model are those of `L_R` is checked as for every model.

use crate::identity::real_point::RealPoint;
use crate::limits::{VALIDATED_POINTS, VALIDATION_ATTEMPTS};
use crate::mechanics::model::Energies;
use crate::mechanics::routhian::Reduction;
use crate::validation::hyper_dual::HyperDual;
use crate::validation::perturbation::Perturbation;
use crate::validation::tape::Tape;
use crate::{Expression, Model, Symbol};

/// Relative differences below this one are rounding errors, at most points.
const ROUNDED: f64 = 1e-7;

/// The tapes of what is compared.
pub struct ReductionCheck<'a> {
    reduction: &'a Reduction,
    parameters: u32,
    /// L of the full model as a sum of roots, then D, then the forces.
    full: Tape,
    weights: &'static [f64],
    /// u; then `V_eff`.
    eliminated: Tape,
    /// The same of the reduced model as of the full one.
    reduced: Tape,
    reduced_weights: &'static [f64],
}

impl<'a> ReductionCheck<'a> {
    /// The check of the reduction of `model`, which has so many `parameters`.
    #[must_use]
    pub fn new(model: &Model, reduction: &'a Reduction, parameters: u32) -> Self {
        let (full, weights) = roots(model);
        let (reduced, reduced_weights) = roots(&reduction.model);
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

    /// The largest relative difference at a point; none outside of the domain.
    fn largest_difference(&self, point: RealPoint) -> Option<f64> {
        let exact = Perturbation(None);
        let eliminated = self
            .eliminated
            .evaluate(&|symbol| point.value(symbol), exact);
        let (potential, velocities) = eliminated.split_last()?;
        let constants = (0..velocities.len()).map(|k| point.value(self.constant(k)));
        let constants: Vec<f64> = constants.collect();
        let lagrangian = self.lagrangian(point, velocities, None);
        if !lagrangian.value.is_finite() || velocities.iter().any(|u| !u.is_finite()) {
            return None;
        }
        let mut most = 0.0_f64;
        let mut compare = |found: f64, expected: f64, size: f64| {
            let difference = (found - expected).abs() / (found.abs() + expected.abs() + size);
            most = if difference.is_finite() {
                most.max(difference)
            } else {
                f64::INFINITY
            };
        };
        let mut routhian = lagrangian.value;
        let mut size = lagrangian.value.abs();
        for (k, (constant, velocity)) in constants.iter().zip(velocities).enumerate() {
            let momentum = self.lagrangian(point, velocities, Some(self.reduction.ignorable[k]));
            compare(momentum.first, *constant, 1e-3);
            routhian -= constant * velocity;
            size += (constant * velocity).abs();
        }
        let symbol = |symbol| point.value(symbol);
        let reduced = weighted(&self.reduced.evaluate(&symbol, exact), self.reduced_weights);
        compare(reduced, routhian, size);
        let still = |symbol: Symbol| match symbol {
            Symbol::Velocity(_) => 0.0,
            other => point.value(other),
        };
        let resting = weighted(&self.reduced.evaluate(&still, exact), self.reduced_weights);
        compare(*potential, -resting, size);
        for (k, i) in self.reduction.remaining.iter().enumerate() {
            let forces = self.reduced.evaluate(&symbol, exact);
            let found = forces[self.reduced_weights.len() + 1 + k];
            compare(found, self.force(point, velocities, *i), 1e-3);
        }
        Some(most)
    }

    fn constant(&self, k: usize) -> Symbol {
        Symbol::Parameter(self.parameters + u32::try_from(k).unwrap_or(u32::MAX))
    }

    /// The roots of the full model where one velocity has the derivative 1.
    fn roots_at(
        &self,
        point: RealPoint,
        velocities: &[f64],
        varied: Option<usize>,
    ) -> Vec<HyperDual> {
        let symbol = |symbol: Symbol| HyperDual {
            first: match symbol {
                Symbol::Velocity(i) if varied == Some(i as usize) => 1.0,
                _ => 0.0,
            },
            ..HyperDual::constant(self.value(point, velocities, symbol))
        };
        let values = self.full.run(&symbol, Perturbation(None));
        let slots = self.full.outputs().iter();
        slots.map(|slot| values[*slot as usize]).collect()
    }

    fn lagrangian(&self, point: RealPoint, velocities: &[f64], varied: Option<usize>) -> HyperDual {
        let roots = self.roots_at(point, velocities, varied);
        let mut sum = HyperDual::default();
        for (root, weight) in roots.iter().zip(self.weights) {
            sum.value += weight * root.value;
            sum.first += weight * root.first;
        }
        sum
    }

    /// The generalized force on a coordinate of the full model.
    fn force(&self, point: RealPoint, velocities: &[f64], coordinate: usize) -> f64 {
        let roots = self.roots_at(point, velocities, Some(coordinate));
        let dissipation = self.weights.len();
        roots[dissipation + 1 + coordinate].value - roots[dissipation].first
    }

    /// The value of a symbol of the full model.
    fn value(&self, point: RealPoint, velocities: &[f64], symbol: Symbol) -> f64 {
        let place = |i: u32| {
            let mut remaining = self.reduction.remaining.iter();
            let place = remaining.position(|other| *other == i as usize);
            place.and_then(|place| u32::try_from(place).ok())
        };
        let ignorable = |i: u32| {
            let mut ignorable = self.reduction.ignorable.iter();
            ignorable.position(|other| *other == i as usize)
        };
        match symbol {
            Symbol::Coordinate(i) => match place(i) {
                Some(place) => point.value(Symbol::Coordinate(place)),
                // It does not matter.
                None => 1.0 + point.weight(0, i as usize) / 2.0,
            },
            Symbol::Velocity(i) => match (place(i), ignorable(i)) {
                (Some(place), _) => point.value(Symbol::Velocity(place)),
                (None, Some(k)) => velocities[k],
                (None, None) => 0.0,
            },
            other => point.value(other),
        }
    }
}

/// T and V, or L; then D; then the forces; and the weights of the first ones in L.
fn roots(model: &Model) -> (Vec<Expression>, &'static [f64]) {
    let (mut roots, weights): (Vec<_>, &[f64]) = match model.energies {
        Energies::Natural { kinetic, potential } => (vec![kinetic, potential], &[1.0, -1.0]),
        Energies::General(lagrangian) => (vec![lagrangian], &[1.0]),
    };
    roots.push(model.dissipation);
    roots.extend(&model.forces);
    (roots, weights)
}

fn weighted(values: &[f64], weights: &[f64]) -> f64 {
    let terms = values.iter().zip(weights);
    terms.map(|(value, weight)| value * weight).sum()
}
