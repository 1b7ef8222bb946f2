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

/// What the ignorable coordinates do at a point: u and du/dt.
struct Eliminated {
    velocities: Vec<f64>,
    accelerations: Vec<f64>,
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

    /// The largest relative difference at a point; none outside of the domain.
    fn largest_difference(&self, point: RealPoint) -> Option<f64> {
        let exact = Perturbation(None);
        let (eliminated, potential) = self.eliminated(point)?;
        let velocities = &eliminated.velocities;
        let constants = (0..velocities.len()).map(|k| point.value(self.constant(k)));
        let constants: Vec<f64> = constants.collect();
        let lagrangian = self.lagrangian(point, &eliminated, None);
        if !lagrangian.value.is_finite() || velocities.iter().any(|u| !u.is_finite()) {
            return None;
        }
        let mut most = Largest(0.0);
        let mut routhian = lagrangian.value;
        let mut size = lagrangian.value.abs();
        for (k, (constant, velocity)) in constants.iter().zip(velocities).enumerate() {
            let varied = Some(self.reduction.ignorable[k]);
            let momentum = self.lagrangian(point, &eliminated, varied);
            most.compare(momentum.first, *constant, 1e-3);
            routhian -= constant * velocity;
            size += (constant * velocity).abs();
        }
        let symbol = |symbol| point.value(symbol);
        let roots = self.reduced.evaluate(&symbol, exact);
        most.compare(weighted(&roots, self.reduced_weights), routhian, size);
        if let Some((tape, weights)) = &self.evaluated {
            let evaluated = tape.evaluate(&symbol, exact);
            most.compare(weighted(&evaluated, weights), routhian, size);
        }
        let still = |symbol: Symbol| match symbol {
            Symbol::Velocity(_) => 0.0,
            other => point.value(other),
        };
        let resting = weighted(&self.reduced.evaluate(&still, exact), self.reduced_weights);
        most.compare(potential, -resting, size);
        let (of_full, of_reduced) = (self.weights.len() + 1, self.reduced_weights.len() + 1);
        let remaining = &self.reduction.remaining;
        for (k, i) in remaining.iter().enumerate() {
            let expected = self.force(point, &eliminated, *i);
            most.compare(roots[of_reduced + k], expected, 1e-3);
        }
        let all = self.roots_at(point, &eliminated, None);
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

    /// u and du/dt along a motion through the point, and `V_eff` there.
    fn eliminated(&self, point: RealPoint) -> Option<(Eliminated, f64)> {
        let moving = |symbol: Symbol| HyperDual {
            first: match symbol {
                Symbol::Time => 1.0,
                Symbol::Coordinate(i) => point.value(Symbol::Velocity(i)),
                Symbol::Velocity(i) => point.value(Symbol::Acceleration(i)),
                _ => 0.0,
            },
            ..HyperDual::constant(point.value(symbol))
        };
        let values = self.eliminated.run(&moving, Perturbation(None));
        let slots = self.eliminated.outputs().iter();
        let values: Vec<HyperDual> = slots.map(|slot| values[*slot as usize]).collect();
        let (potential, velocities) = values.split_last()?;
        let eliminated = Eliminated {
            velocities: velocities.iter().map(|u| u.value).collect(),
            accelerations: velocities.iter().map(|u| u.first).collect(),
        };
        Some((eliminated, potential.value))
    }

    fn constant(&self, k: usize) -> Symbol {
        Symbol::Parameter(self.parameters + u32::try_from(k).unwrap_or(u32::MAX))
    }

    /// The roots of the full model where one velocity has the derivative 1.
    fn roots_at(
        &self,
        point: RealPoint,
        eliminated: &Eliminated,
        varied: Option<usize>,
    ) -> Vec<HyperDual> {
        let symbol = |symbol: Symbol| HyperDual {
            first: match symbol {
                Symbol::Velocity(i) if varied == Some(i as usize) => 1.0,
                _ => 0.0,
            },
            ..HyperDual::constant(self.value(point, eliminated, symbol))
        };
        let values = self.full.run(&symbol, Perturbation(None));
        let slots = self.full.outputs().iter();
        slots.map(|slot| values[*slot as usize]).collect()
    }

    fn lagrangian(
        &self,
        point: RealPoint,
        eliminated: &Eliminated,
        varied: Option<usize>,
    ) -> HyperDual {
        let roots = self.roots_at(point, eliminated, varied);
        let mut sum = HyperDual::default();
        for (root, weight) in roots.iter().zip(self.weights) {
            sum.value += weight * root.value;
            sum.first += weight * root.first;
        }
        sum
    }

    /// The generalized force on a coordinate of the full model.
    fn force(&self, point: RealPoint, eliminated: &Eliminated, coordinate: usize) -> f64 {
        let roots = self.roots_at(point, eliminated, Some(coordinate));
        let dissipation = self.weights.len();
        roots[dissipation + 1 + coordinate].value - roots[dissipation].first
    }

    /// The value of a symbol of the full model.
    fn value(&self, point: RealPoint, eliminated: &Eliminated, symbol: Symbol) -> f64 {
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
                (None, Some(k)) => eliminated.velocities[k],
                (None, None) => 0.0,
            },
            Symbol::Acceleration(i) => match (place(i), ignorable(i)) {
                (Some(place), _) => point.value(Symbol::Acceleration(place)),
                (None, Some(k)) => eliminated.accelerations[k],
                // A multiplier.
                (None, None) => {
                    let behind = u32::try_from(self.reduction.ignorable.len()).unwrap_or(0);
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
