//! The quadratic form of Gauss's principle, ½ xᵀ H x, in the accelerations of links and coordinates.
//!
//! The acceleration of a link is its angular acceleration and that of its origin, six unknowns. Each step of the way to
//! the root is a congruence of H that knows the structure of one joint: a coordinate is split off, the axes are turned,
//! the origin is moved. A turn about a coordinate axis takes four products for each symmetric block of two rows, by
//! the double angle.

use std::collections::BTreeMap;

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

/// H, both triangles, without zeros.
#[derive(Clone, Default)]
pub(crate) struct TwistElimination {
    rows: BTreeMap<Unknown, InertiaRow>,
}

impl TwistElimination {
    /// ½ q̈ᵀ M q̈.
    pub(crate) fn of_coordinates(graph: &Graph, mass: &[Vec<Expression>]) -> Self {
        let mut all = Self::default();
        for (i, row) in mass.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                all.set(
                    graph,
                    Unknown::Coordinate(i),
                    Unknown::Coordinate(j),
                    *entry,
                );
            }
        }
        all
    }

    /// An entry, zero where there is none.
    pub(crate) fn entry(&self, graph: &Graph, u: Unknown, v: Unknown) -> Expression {
        let entry = self.rows.get(&u).and_then(|row| row.get(&v));
        entry.copied().unwrap_or(graph.zero())
    }

    fn set(&mut self, graph: &Graph, u: Unknown, v: Unknown, value: Expression) {
        for (x, y) in [(u, v), (v, u)] {
            let row = self.rows.entry(x).or_default();
            if graph.is_zero(value) {
                row.remove(&y);
            } else {
                row.insert(y, value);
            }
        }
    }

    /// Adds to an entry.
    pub(crate) fn add(&mut self, graph: &mut Graph, u: Unknown, v: Unknown, change: Expression) {
        let sum = graph.add(self.entry(graph, u, v), change);
        let sum = kept(graph, sum);
        self.set(graph, u, v, sum);
    }

    /// The row of an unknown.
    pub(crate) fn row(&self, unknown: Unknown) -> InertiaRow {
        self.rows.get(&unknown).cloned().unwrap_or_default()
    }

    /// The rows of a link.
    pub(crate) fn rows(&self, link: usize) -> Vec<InertiaRow> {
        twist(link).map(|u| self.row(u)).collect()
    }

    /// A block of three by three.
    fn block(&self, graph: &Graph, rows: [Unknown; 3], columns: [Unknown; 3]) -> [Vector; 3] {
        rows.map(|u| columns.map(|v| self.entry(graph, u, v)))
    }

    /// The unknowns other than those of a link.
    fn others(&self, link: usize) -> Vec<Unknown> {
        let is_other = |u: &Unknown| !matches!(u, Unknown::Twist(known, _) if *known == link);
        self.rows.keys().copied().filter(is_other).collect()
    }

    /// Adds ½ m |a|² + … of what a link carries.
    pub(crate) fn add_inertia(&mut self, graph: &mut Graph, link: usize, inertia: &Inertia) {
        let (angular, linear) = (angular(link), linear(link));
        let tensor = inertia.tensor(graph);
        for i in 0..3 {
            for j in i..3 {
                self.add(graph, angular[i], angular[j], tensor[i][j]);
            }
            self.add(graph, linear[i], linear[i], inertia.mass);
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let minus = graph.negate(inertia.first[k]);
            self.add(graph, angular[i], linear[j], minus);
            self.add(graph, angular[i], linear[k], inertia.first[j]);
        }
    }

    /// x := x + e q̈ᵢ.
    pub(crate) fn split_off(&mut self, graph: &mut Graph, slope: &Slope) {
        let own = Unknown::Coordinate(slope.coordinate);
        let mut changes = Vec::new();
        for v in self.rows.keys().copied().collect::<Vec<_>>() {
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
                self.add(graph, own, v, change);
            }
        }
        let square = graph.sum(square);
        self.add(graph, own, own, square);
    }

    /// Eliminates a coordinate, unless its pivot vanishes.
    pub(crate) fn eliminate(
        &mut self,
        graph: &mut Graph,
        coordinate: usize,
    ) -> Option<EliminatedRow> {
        let own = Unknown::Coordinate(coordinate);
        let mut row = self.rows.remove(&own)?;
        let pivot = row.remove(&own)?;
        let reciprocal = graph.power(pivot, &Rational::MINUS_ONE);
        let reciprocal = kept(graph, reciprocal);
        let mut others = Vec::with_capacity(row.len());
        for (v, entry) in row {
            if let Some(row) = self.rows.get_mut(&v) {
                row.remove(&own);
            }
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
                self.add(graph, *u, *v, change);
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
        for other in self.others(link) {
            for unknowns in [angular, linear] {
                let column = unknowns.map(|u| self.entry(graph, u, other));
                let column = turn.outward(graph, column);
                self.set_column(graph, unknowns, other, column);
            }
        }
        for [rows, columns] in [[angular, angular], [linear, linear], [angular, linear]] {
            let block = self.block(graph, rows, columns);
            let block = turn.outward_block(graph, block, rows == columns);
            for i in 0..3 {
                let first = if rows == columns { i } else { 0 };
                for j in first..3 {
                    self.set(graph, rows[i], columns[j], block[i][j]);
                }
            }
        }
    }

    fn set_column(&mut self, graph: &Graph, rows: [Unknown; 3], column: Unknown, values: Vector) {
        for (u, value) in rows.into_iter().zip(values) {
            self.set(graph, u, column, value);
        }
    }

    /// Replaces the acceleration of the origin by that of the origin of the link before, from which it is at `place`.
    pub(crate) fn shift(&mut self, graph: &mut Graph, link: usize, place: Vector) {
        let (angular, linear) = (angular(link), linear(link));
        for other in self.others(link) {
            let forces = linear.map(|u| self.entry(graph, u, other));
            let lever = graph.cross(place, forces);
            for (u, change) in angular.into_iter().zip(lever) {
                self.add(graph, u, other, change);
            }
        }
        let before = self.block(graph, angular, linear);
        let masses = self.block(graph, linear, linear);
        for j in 0..3 {
            let lever = graph.cross(place, [masses[0][j], masses[1][j], masses[2][j]]);
            for (u, change) in angular.into_iter().zip(lever) {
                self.add(graph, u, linear[j], change);
            }
        }
        let after = self.block(graph, angular, linear);
        for i in 0..3 {
            for j in i..3 {
                let [rows, columns] = [
                    graph.cross(place, before[j])[i],
                    graph.cross(place, after[i])[j],
                ];
                let sum = graph.add(rows, columns);
                self.add(graph, angular[i], angular[j], sum);
            }
        }
    }

    /// Adds the rows of a link to those of the link before, or drops them where that is the inertial frame.
    pub(crate) fn merge(&mut self, graph: &mut Graph, link: usize, parent: Option<usize>) {
        let rename = |u: Unknown| match (u, parent) {
            (Unknown::Twist(known, i), Some(parent)) if known == link => Unknown::Twist(parent, i),
            _ => u,
        };
        for i in 0..6 {
            let own = Unknown::Twist(link, i);
            let row = self.rows.remove(&own).unwrap_or_default();
            for (v, entry) in row {
                if let Some(row) = self.rows.get_mut(&v) {
                    row.remove(&own);
                }
                if parent.is_some() {
                    // Each pair is met once: the row of the other one is gone then.
                    self.add(graph, rename(own), rename(v), entry);
                }
            }
        }
    }
}
