//! The quadratic form of Gauss's principle, ½ xᵀ H x, in the accelerations of links and coordinates.
//!
//! The acceleration of a link is its angular acceleration and that of its origin, six unknowns. Each step of the way to
//! the root is a congruence of H that knows the structure of one joint: a coordinate is split off, the axes are turned,
//! the origin is moved. A turn about a coordinate axis takes four products for each symmetric block of two rows, by
//! the double angle.

use std::collections::BTreeMap;

use crate::matrix::symmetric_elimination::SymmetricElimination;
use crate::mechanics::mechanism::{Inertia, Turn, Vector, kept};
use crate::mechanics::solvers::spatial_vectors::Twist;
use crate::{Expression, Graph, Rational};

/// An unknown.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Unknown {
    /// q̈ᵢ.
    Coordinate(usize),
    /// A component of the angular acceleration of a link, then of the acceleration of its origin: 0 to 5.
    Twist(usize, usize),
}

impl Unknown {
    /// The same unknown of another link, where it is one of a link.
    pub(crate) fn moved(self, from: usize, to: usize) -> Self {
        match self {
            Self::Twist(link, i) if link == from => Self::Twist(to, i),
            other => other,
        }
    }
}

/// A row of H, without zeros.
pub(crate) type InertiaRow = BTreeMap<Unknown, Expression>;

/// The three unknowns of an angular acceleration.
pub(crate) const fn angular(link: usize) -> [Unknown; 3] {
    [
        Unknown::Twist(link, 0),
        Unknown::Twist(link, 1),
        Unknown::Twist(link, 2),
    ]
}

/// The three unknowns of the acceleration of an origin.
pub(crate) const fn linear(link: usize) -> [Unknown; 3] {
    [
        Unknown::Twist(link, 3),
        Unknown::Twist(link, 4),
        Unknown::Twist(link, 5),
    ]
}

/// The six unknowns of a link.
pub(crate) fn twist(link: usize) -> impl Iterator<Item = Unknown> {
    (0..6).map(move |i| Unknown::Twist(link, i))
}

/// The row of an eliminated coordinate: D q̈ = h − Σ entries · x.
#[derive(Clone, Debug)]
pub(crate) struct EliminatedRow {
    pub(crate) coordinate: usize,
    pub(crate) pivot: Expression,
    /// 1/D.
    pub(crate) reciprocal: Expression,
    /// The other unknowns, each with its entry and the entry over D.
    pub(crate) others: Vec<(Unknown, Expression, Expression)>,
}

/// The part e q̈ that a coordinate has in the accelerations of a link.
pub(crate) struct Slope {
    pub(crate) coordinate: usize,
    /// e, of the angular acceleration if it turns, and of the acceleration of the origin if it slides.
    pub(crate) along: Vec<(Unknown, Expression)>,
}

impl Slope {
    /// The twist of a link that a unit velocity of a coordinate gives.
    pub(crate) fn of(graph: &Graph, link: usize, (coordinate, of): (usize, Twist)) -> Self {
        let mut along = Vec::new();
        for (unknowns, e) in [(angular(link), of.angular), (linear(link), of.linear)] {
            if !e.iter().all(|x| graph.is_zero(*x)) {
                along.extend(unknowns.into_iter().zip(e));
            }
        }
        Self { coordinate, along }
    }
}

/// One step of an elimination along links.
pub(crate) enum Step {
    /// x := x + e q̈.
    SplitOff(Slope),
    Eliminate(EliminatedRow),
    Turn(usize, Turn),
    /// From a link to the link before, from whose origin this one's is at a place.
    Shift(usize, Option<usize>, Vector),
}

/// H.
pub(crate) type TwistElimination = SymmetricElimination<Unknown>;

impl TwistElimination {
    /// Adds to an entry, which becomes an intermediate result.
    pub(crate) fn increase(
        &mut self,
        graph: &mut Graph,
        u: Unknown,
        v: Unknown,
        change: Expression,
    ) {
        let sum = graph.add(self.entry(graph, u, v), change);
        let sum = kept(graph, sum);
        self.set(graph, u, v, sum);
    }

    /// The rows of a link.
    pub(crate) fn rows_of(&self, link: usize) -> Vec<InertiaRow> {
        twist(link).map(|u| self.row(u)).collect()
    }

    /// Adds ½ m |a|² + … of what a link carries.
    pub(crate) fn add_inertia(&mut self, graph: &mut Graph, link: usize, inertia: &Inertia) {
        let (angular, linear) = (angular(link), linear(link));
        let tensor = inertia.tensor(graph);
        for i in 0..3 {
            for j in i..3 {
                self.increase(graph, angular[i], angular[j], tensor[i][j]);
            }
            self.increase(graph, linear[i], linear[i], inertia.mass);
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let minus = graph.negate(inertia.first[k]);
            self.increase(graph, angular[i], linear[j], minus);
            self.increase(graph, angular[i], linear[k], inertia.first[j]);
        }
    }

    /// x := x + e q̈ᵢ.
    pub(crate) fn split_off(&mut self, graph: &mut Graph, slope: &Slope) {
        let own = Unknown::Coordinate(slope.coordinate);
        let mut changes = Vec::new();
        for v in self.unknowns().collect::<Vec<_>>() {
            let pairs = slope.along.iter();
            let pairs: Vec<_> = pairs.map(|(u, e)| (*e, self.entry(graph, *u, v))).collect();
            changes.push((v, graph.sum_of_products(pairs)));
        }
        let mut square = Vec::new();
        for (v, change) in changes {
            if let Some((_, e)) = slope.along.iter().find(|(u, _)| *u == v) {
                square.push((graph.multiply(*e, change), Rational::ONE));
            }
            if v == own {
                square.push((change, Rational::integer(2)));
            } else {
                self.increase(graph, own, v, change);
            }
        }
        let square = graph.sum(square);
        self.increase(graph, own, own, square);
    }

    /// Eliminates a coordinate, unless its pivot vanishes.
    pub(crate) fn eliminate(
        &mut self,
        graph: &mut Graph,
        coordinate: usize,
    ) -> Option<EliminatedRow> {
        let row = self.take(graph, Unknown::Coordinate(coordinate));
        let pivot = row.pivot;
        if graph.is_zero(pivot) {
            return None;
        }
        let reciprocal = graph.power(pivot, &Rational::MINUS_ONE);
        let reciprocal = kept(graph, reciprocal);
        let mut others = Vec::with_capacity(row.others.len());
        for (v, entry) in row.others {
            let ratio = if entry == pivot {
                graph.one()
            } else {
                let ratio = graph.multiply(entry, reciprocal);
                kept(graph, ratio)
            };
            others.push((v, entry, ratio));
        }
        for (position, (u, entry, _)) in others.iter().enumerate() {
            for (v, other, ratio) in &others[position..] {
                // Of the two factors, a ratio of one leaves the entry of the other.
                let change = if *entry == pivot {
                    *other
                } else {
                    graph.multiply(*ratio, *entry)
                };
                let change = graph.negate(change);
                self.increase(graph, *u, *v, change);
            }
        }
        Some(EliminatedRow {
            coordinate,
            pivot,
            reciprocal,
            others,
        })
    }

    /// Turns the axes of a link into those of the link before.
    pub(crate) fn turn(&mut self, graph: &mut Graph, link: usize, turn: &Turn) {
        let (angular, linear) = (angular(link), linear(link));
        let is_other = |u: &Unknown| !angular.contains(u) && !linear.contains(u);
        for other in self.unknowns().filter(is_other).collect::<Vec<_>>() {
            for unknowns in [angular, linear] {
                let column = unknowns.map(|u| self.entry(graph, u, other));
                let column = turn.outward(graph, column);
                for (u, value) in unknowns.into_iter().zip(column) {
                    self.set(graph, u, other, value);
                }
            }
        }
        for [rows, columns] in [[angular, angular], [linear, linear], [angular, linear]] {
            let block = rows.map(|u| columns.map(|v| self.entry(graph, u, v)));
            let block = turn.outward_block(graph, block, rows == columns);
            for i in 0..3 {
                let first = if rows == columns { i } else { 0 };
                for j in first..3 {
                    self.set(graph, rows[i], columns[j], block[i][j]);
                }
            }
        }
    }

    /// Replaces the acceleration of the origin by that of the origin of the link before, from which it is at `place`.
    pub(crate) fn shift(&mut self, graph: &mut Graph, link: usize, place: Vector) {
        self.add_levers(graph, [linear(link), angular(link)], |graph, force| {
            graph.cross(place, force)
        });
    }

    /// y := y + L x of three unknowns x and three others y, with a linear L.
    pub(crate) fn add_levers(
        &mut self,
        graph: &mut Graph,
        [from, to]: [[Unknown; 3]; 2],
        lever: impl Fn(&mut Graph, Vector) -> Vector,
    ) {
        let before = to.map(|u| from.map(|v| self.entry(graph, u, v)));
        let before = before.map(|row| lever(graph, row));
        for other in self.unknowns().collect::<Vec<_>>() {
            if !to.contains(&other) {
                let column = from.map(|u| self.entry(graph, u, other));
                for (u, change) in to.into_iter().zip(lever(graph, column)) {
                    self.increase(graph, u, other, change);
                }
            }
        }
        let after = to.map(|u| from.map(|v| self.entry(graph, u, v)));
        let after = after.map(|row| lever(graph, row));
        for i in 0..3 {
            for j in i..3 {
                let sum = graph.add(before[j][i], after[i][j]);
                self.increase(graph, to[i], to[j], sum);
            }
        }
    }

    /// Adds the rows of a link to those of the link before, or drops them where that is the inertial frame.
    pub(crate) fn merge(&mut self, graph: &mut Graph, link: usize, parent: Option<usize>) {
        for own in twist(link) {
            let row = self.take(graph, own);
            let Some(parent) = parent else {
                continue;
            };
            // Each pair is met once: the row of the other one is gone then.
            for (v, entry) in row.others.into_iter().chain([(own, row.pivot)]) {
                self.increase(graph, own.moved(link, parent), v.moved(link, parent), entry);
            }
        }
    }
}
