//! An order in which a sparse saddle point problem is eliminated.
//!
//! Of the unknowns that are ready, the one is next whose elimination makes the fewest new entries (Tinney and Walker, Direct
//! solutions of sparse network equations by optimally ordered triangular factorization, 1967, scheme 3; Rose, A
//! graph-theoretic study of the numerical solution of sparse positive definite systems of linear equations, 1972). Loops that
//! are coupled to a few others each then take a fixed number of products, however many they are. Which entries are zero, after
//! cancellation too, is found at a random point in modular arithmetic.
//!
//! A constraint is ready when the coordinates that it restricts are eliminated, except those without mass. Its pivot is then
//! the square of its gradient's distance from the span of the gradients before it, in the metric of the inverse inertia, and
//! small near singular configurations alone: what is eliminated so far is the saddle point problem of these coordinates, which is
//! quasidefinite (Vanderbei, Symmetric quasidefinite matrices, 1995). Where many parts meet in a hub, as the legs of a platform
//! do, that couples all of them. There constraints need not wait for the coordinates of the hub, which leaves each part as an
//! inertia that is added to it.

use std::collections::{BTreeMap, BTreeSet};

use crate::identity::modular_point::ModularPoint;
use crate::identity::residue;
use crate::limits::{
    MAX_ELIMINATION_PRODUCTS, MAX_PIVOT_NEIGHBOURS, MIN_CONSTRAINTS_OF_HUB, MIN_SPARSITY,
    MIN_SPARSITY_OF_HUBS,
};
use crate::{Expression, Graph};

/// An order of elimination, and what it takes.
pub(crate) struct EliminationOrder {
    /// The unknowns.
    pub(crate) unknowns: Vec<usize>,
    /// The others to which each of them is coupled when it is eliminated, in order.
    pub(crate) neighbours: Vec<Vec<usize>>,
}

/// Products for a pivot with so many other entries, for the factors and for one right-hand side.
const fn products(neighbours: usize) -> usize {
    neighbours * (neighbours + 1) / 2 + 3 * neighbours
}

impl EliminationOrder {
    /// The order for a saddle point problem whose first unknowns are as many `coordinates`, if elimination as straight-line code is
    /// worth it. None where a pivot vanishes, as where a coordinate without mass is held by no constraint.
    pub(crate) fn of(
        graph: &Graph,
        matrix: &[Vec<Expression>],
        coordinates: usize,
    ) -> Option<Self> {
        let entries = Entries::of(graph, matrix)?;
        let whole = Self::in_turn(entries.clone(), (coordinates, usize::MAX));
        let by_hubs = Self::in_turn(entries, (coordinates, MIN_CONSTRAINTS_OF_HUB));
        let best = match (whole, by_hubs) {
            (Some(whole), Some(by_hubs)) => {
                let saves = MIN_SPARSITY_OF_HUBS * by_hubs.products() < whole.products();
                if saves { by_hubs } else { whole }
            }
            (whole, by_hubs) => whole.or(by_hubs)?,
        };
        best.is_sparse().then_some(best)
    }

    /// The order in which constraints, the unknowns behind so many coordinates, wait for those that fewer than so many constraints
    /// restrict.
    fn in_turn(mut entries: Entries, (coordinates, hub): (usize, usize)) -> Option<Self> {
        let mut order = Self {
            unknowns: Vec::new(),
            neighbours: Vec::new(),
        };
        let mut awaited = entries.awaited(coordinates, hub);
        let mut left: BTreeSet<_> = (0..entries.rows.len()).collect();
        while !left.is_empty() {
            let is_ready = |i: &usize| awaited[*i].is_empty() && entries.pivot(*i) != 0;
            let ready = left.iter().copied().filter(is_ready);
            let best = ready.min_by_key(|i| (entries.fill(*i), entries.rows[*i].len(), *i))?;
            left.remove(&best);
            for awaited in &mut awaited {
                awaited.remove(&best);
            }
            order.unknowns.push(best);
            order.neighbours.push(entries.eliminate(best)?);
        }
        Some(order)
    }

    fn products(&self) -> usize {
        self.neighbours.iter().map(|row| products(row.len())).sum()
    }

    /// Whether the rows of pivots are short, or elimination takes a small part of the products of a dense factorization.
    fn is_sparse(&self) -> bool {
        let sparse = self.products();
        let dense: usize = (0..self.neighbours.len()).map(products).sum();
        let mut rows = self.neighbours.iter();
        let are_short = rows.all(|row| row.len() <= MAX_PIVOT_NEIGHBOURS);
        sparse <= MAX_ELIMINATION_PRODUCTS && (are_short || MIN_SPARSITY * sparse <= dense)
    }
}

/// What is left of a symmetric matrix in the course of elimination, at a random point modulo a prime: rows without zeros.
#[derive(Clone)]
struct Entries {
    rows: Vec<BTreeMap<usize, u64>>,
    p: u64,
}

impl Entries {
    fn of(graph: &Graph, matrix: &[Vec<Expression>]) -> Option<Self> {
        let roots = matrix.concat();
        let mut found = ModularPoint::attempts()
            .filter_map(|point| Some((point.p(), point.evaluate(graph, &roots)?)));
        let (p, values) = found.next()?;
        let rows = values.chunks(matrix.len().max(1)).map(|row| {
            let entries = row.iter().copied().enumerate();
            entries.filter(|(_, value)| *value != 0).collect()
        });
        Some(Self {
            rows: rows.collect(),
            p,
        })
    }

    /// For each unknown behind so many coordinates: those with mass that it restricts, and that fewer constraints than those of a
    /// `hub` do.
    fn awaited(&self, coordinates: usize, hub: usize) -> Vec<BTreeSet<usize>> {
        let waits_for = |j: usize| {
            let constraints = self.rows[j].keys().filter(|i| **i >= coordinates);
            j < coordinates && self.pivot(j) != 0 && constraints.count() < hub
        };
        let rows = self.rows.iter().enumerate();
        let awaited = rows.map(|(i, row)| {
            let restricted = row.keys().copied().filter(|_| i >= coordinates);
            restricted.filter(|j| waits_for(*j)).collect()
        });
        awaited.collect()
    }

    fn pivot(&self, unknown: usize) -> u64 {
        self.entry(unknown, unknown)
    }

    fn entry(&self, i: usize, j: usize) -> u64 {
        self.rows[i].get(&j).copied().unwrap_or(0)
    }

    /// How many entries the elimination of an unknown adds.
    fn fill(&self, unknown: usize) -> usize {
        let row = &self.rows[unknown];
        let missing = row.keys().enumerate().map(|(position, i)| {
            let others = row.keys().skip(position + 1);
            let missing = others.filter(|j| *j != i && !self.rows[*i].contains_key(j));
            missing.count()
        });
        missing.sum()
    }

    /// Eliminates an unknown whose pivot does not vanish; the others to which it is coupled.
    fn eliminate(&mut self, unknown: usize) -> Option<Vec<usize>> {
        let mut row = core::mem::take(&mut self.rows[unknown]);
        let reciprocal = residue::reciprocal(row.remove(&unknown)?, self.p)?;
        for (i, entry) in &row {
            self.rows[*i].remove(&unknown);
            let factor = residue::negate(residue::multiply(*entry, reciprocal, self.p), self.p);
            for (j, other) in &row {
                let change = residue::multiply(factor, *other, self.p);
                let after = residue::add(self.entry(*i, *j), change, self.p);
                if after == 0 {
                    self.rows[*i].remove(j);
                } else {
                    self.rows[*i].insert(*j, after);
                }
            }
        }
        Some(row.into_keys().collect())
    }
}
