//! Uniform gravity: the part of V that is the weight of links, for which the inertial frame accelerates upwards.
//!
//! V is −Σ m a · r with one acceleration a if the weights on each link add up to its mass times a, and their moments to its
//! first moments of mass, whatever points they were declared at.

use std::collections::BTreeMap;

use crate::frames::frame_tree::Frame;
use crate::frames::vector_in_frames::{Term, VectorId};
use crate::mechanics::energy_forms::quasi_velocities::is_constant;
use crate::mechanics::mechanism::Vector;
use crate::mechanics::mechanism::reading::{Point, Reader};
use crate::{Expression, Rational, Symbol};

/// The weights on a link: their sum, and that of their products with their places.
type Weights = (Vector, [Vector; 3]);

impl Reader {
    /// The acceleration that stands in for the part of V that is Σ m a · r over all masses, and the rest of V.
    pub(super) fn uniform_gravity(&mut self, potential: Expression) -> (Vector, Expression) {
        let found = self.gravity_and_rest(potential);
        found.unwrap_or(([self.geometry.graph.zero(); 3], potential))
    }

    fn gravity_and_rest(&mut self, potential: Expression) -> Option<(Vector, Expression)> {
        let zero = self.geometry.graph.zero();
        let mut weights: BTreeMap<VectorId, Vector> = BTreeMap::new();
        for symbol in self.geometry.graph.symbols(&[potential]) {
            let Symbol::PositionComponent(index) = symbol else {
                continue;
            };
            let slope = self.geometry.graph.derivative(potential, symbol);
            if is_constant(&self.geometry.graph, slope) {
                let (number, axis) = VectorId::of_component(index);
                weights.entry(number).or_insert([zero; 3])[axis] = slope;
            }
        }
        let mut by_link: BTreeMap<usize, Weights> = BTreeMap::new();
        let mut heavy = Vec::new();
        let mut removed = BTreeMap::new();
        for (number, weight) in weights {
            // What has no mass, or none that moves but by turning, has its weight in the rest of V.
            let Some(point @ (Some(link), place)) = self.marked_point(number) else {
                continue;
            };
            let inertia = &self.links[link].inertia;
            if inertia.first == [zero; 3] && inertia.mass == zero {
                continue;
            }
            for (slope, index) in weight.iter().zip(number.components()) {
                if *slope != zero {
                    removed.insert(Symbol::PositionComponent(index), zero);
                }
            }
            let (sum, moments) = by_link.entry(link).or_insert(([zero; 3], [[zero; 3]; 3]));
            for i in 0..3 {
                sum[i] = self.geometry.graph.add(sum[i], weight[i]);
                for j in 0..3 {
                    let moment = self.geometry.graph.multiply(weight[i], place[j]);
                    moments[i][j] = self.geometry.graph.add(moments[i][j], moment);
                }
            }
            heavy.push((point, weight));
        }
        let accelerations = self.ratios(heavy.first()?);
        let mut accelerations = accelerations.into_iter();
        let acceleration = accelerations.find(|a| self.is_weight(&by_link, *a))?;
        let rest = self.geometry.graph.substitute(&[potential], &removed)[0];
        Some((acceleration, rest))
    }

    /// A weight over each of the masses on its link.
    fn ratios(&mut self, (point, weight): &(Point, Vector)) -> Vec<Vector> {
        let masses = self.masses.iter().filter(|(known, _)| known.0 == point.0);
        let mut masses: Vec<_> = masses.copied().collect();
        masses.sort_by_key(|(known, _)| known != point);
        let ratios = masses
            .into_iter()
            .map(|(_, mass)| weight.map(|x| self.geometry.graph.divide(x, mass)));
        ratios.collect()
    }

    /// Whether the weights are those of the masses of all links under an acceleration.
    fn is_weight(&mut self, weights: &BTreeMap<usize, Weights>, acceleration: Vector) -> bool {
        let zero = self.geometry.graph.zero();
        let mut residuals = Vec::new();
        for i in 0..self.links.len() {
            let inertia = self.links[i].inertia.clone();
            let nothing = ([zero; 3], [[zero; 3]; 3]);
            let (sum, moments) = *weights.get(&i).unwrap_or(&nothing);
            for (k, a) in acceleration.into_iter().enumerate() {
                let found = [sum[k], moments[k][0], moments[k][1], moments[k][2]];
                let [x, y, z] = inertia.first;
                for (found, moment) in found.into_iter().zip([inertia.mass, x, y, z]) {
                    let expected = self.geometry.graph.multiply(a, moment);
                    let terms = [(found, Rational::ONE), (expected, Rational::MINUS_ONE)];
                    let residual = self.geometry.graph.sum(terms);
                    if residual != zero {
                        residuals.push(residual);
                    }
                }
            }
        }
        residuals.is_empty() || self.geometry.graph.vanishes(&residuals)
    }

    /// The point of a position that is resolved along inertial axes.
    fn marked_point(&mut self, number: VectorId) -> Option<Point> {
        let vector = self.vectors.vector(number).clone();
        let terms = vector.terms.iter().map(|term| match term {
            Term::Fixed(frame, place) if vector.axes == Frame::INERTIAL => Some((*frame, *place)),
            _ => None,
        });
        let terms: Vec<_> = terms.collect::<Option<_>>()?;
        let count = self.links.len();
        let point = self.point(&terms)?;
        // A weight without a mass has no link of its own.
        let is_known = self.links.len() == count;
        self.links.truncate(count);
        self.frames.truncate(count);
        is_known.then_some(point)
    }
}
