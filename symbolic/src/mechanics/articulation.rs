//! q̈ along a tree of quasi-velocities, leaf by leaf.
//!
//! By Gauss's principle the accelerations minimize ½ ẇᵀ W ẇ − rᵀ q̈ under ẇₖ = ẇ_parent + Σ eₖᵢ q̈ᵢ + Dwₖ.
//! Rates that nothing builds on are put in, then a coordinate that is left in the quadratic form alone is
//! eliminated: what remains is the inertia that the rest of the chain feels. For a chain it takes as many
//! steps as there are links, each of a fixed size, where an elimination of M takes the cube; for forms
//! that do not build on each other it is the elimination of M, with Schur complements simplified.

use std::collections::BTreeMap;

use crate::mechanics::kinematic_tree::KinematicTree;
use crate::{Expression, Graph, Node, Rational};

/// An unknown: q̈ᵢ or ẇₖ.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Unknown {
    Coordinate(usize),
    Rate(usize),
}

/// q̈ⱼ from what is found after it: D q̈ⱼ = h − Σ row·x.
struct Elimination {
    coordinate: usize,
    pivot: Expression,
    row: Vec<(Unknown, Expression)>,
    right: Expression,
}

/// The pivots, which have to be positive, and the accelerations.
pub(crate) struct Articulation {
    pub(crate) pivots: Vec<Expression>,
    pub(crate) accelerations: Vec<Expression>,
}

/// Sums of more terms than this are kept whole.
const LONGEST_MERGED: usize = 2;

impl Articulation {
    /// Solves Eᵀ W ẇ = r along the tree, unless a pivot vanishes or more than `limit` unknowns meet.
    pub(crate) fn solve(graph: &mut Graph, tree: &KinematicTree, limit: usize) -> Option<Self> {
        let mut quadratic = Quadratic::new(graph, tree);
        let mut waiting: Vec<usize> = (0..tree.right.len()).collect();
        let mut eliminations = Vec::with_capacity(waiting.len());
        while let Some(coordinate) = quadratic.cheapest(&waiting) {
            waiting.retain(|i| *i != coordinate);
            let elimination = quadratic.eliminate(graph, coordinate, limit)?;
            eliminations.push(elimination);
        }
        let mut pivots: Vec<_> = eliminations
            .iter()
            .map(|elimination| elimination.pivot)
            .collect();
        pivots.push(tree.unit);
        pivots.retain(|pivot| graph.as_constant(*pivot).is_none_or(Rational::is_negative));
        let accelerations = substitute(graph, tree, &eliminations);
        Some(Self {
            pivots,
            accelerations,
        })
    }
}

/// ½ xᵀ H x − hᵀ x over the unknowns that are left.
struct Quadratic<'a> {
    tree: &'a KinematicTree,
    /// The rows of H, both triangles, without zeros.
    rows: BTreeMap<Unknown, BTreeMap<Unknown, Expression>>,
    right: BTreeMap<Unknown, Expression>,
    /// Which forms have been put in.
    done: Vec<bool>,
}

impl<'a> Quadratic<'a> {
    fn new(graph: &Graph, tree: &'a KinematicTree) -> Self {
        let mut rows: BTreeMap<Unknown, BTreeMap<Unknown, Expression>> = BTreeMap::new();
        for (k, row) in tree.inertia.iter().enumerate() {
            let entries = row
                .iter()
                .enumerate()
                .filter(|(_, entry)| !graph.is_zero(**entry));
            let entries = entries.map(|(l, entry)| (Unknown::Rate(l), *entry));
            rows.insert(Unknown::Rate(k), entries.collect());
        }
        let right = tree.right.iter().enumerate();
        Self {
            tree,
            rows,
            right: right
                .map(|(i, value)| (Unknown::Coordinate(i), *value))
                .collect(),
            done: vec![false; tree.forms.len()],
        }
    }

    /// The forms to be put in before a coordinate can be eliminated, leaves first.
    fn above(&self, coordinate: usize) -> Vec<usize> {
        let mut wanted = vec![false; self.done.len()];
        for (k, form) in self.tree.forms.iter().enumerate() {
            let uses = form.local.iter().any(|(i, _)| *i == coordinate);
            wanted[k] = !self.done[k] && (uses || form.parent.is_some_and(|parent| wanted[parent]));
        }
        (0..wanted.len()).rev().filter(|k| wanted[*k]).collect()
    }

    /// The coordinate for which the fewest forms have to be put in; of several, the last.
    fn cheapest(&self, waiting: &[usize]) -> Option<usize> {
        waiting
            .iter()
            .copied()
            .min_by_key(|i| (self.above(*i).len(), core::cmp::Reverse(*i)))
    }

    fn eliminate(
        &mut self,
        graph: &mut Graph,
        coordinate: usize,
        limit: usize,
    ) -> Option<Elimination> {
        for k in self.above(coordinate) {
            self.put_in(graph, k);
        }
        let unknown = Unknown::Coordinate(coordinate);
        let mut row = self.rows.remove(&unknown)?;
        let pivot = row.remove(&unknown)?;
        let zero = graph.zero();
        let right = self.right.remove(&unknown).unwrap_or(zero);
        if row.len() > limit {
            return None;
        }
        for (u, entry) in &row {
            let factor = graph.divide(*entry, pivot);
            for (v, other) in &row {
                if v <= u {
                    let change = graph.multiply(factor, *other);
                    self.subtract(graph, *u, *v, change);
                }
            }
            let change = graph.multiply(factor, right);
            let before = self.right.get(u).copied().unwrap_or(zero);
            let after = graph.subtract(before, change);
            self.right.insert(*u, kept(graph, after));
            if let Some(entries) = self.rows.get_mut(u) {
                entries.remove(&unknown);
            }
        }
        self.keep(graph, &row);
        Some(Elimination {
            coordinate,
            pivot,
            row: row.into_iter().collect(),
            right,
        })
    }

    /// Keeps the entries of H among these unknowns whole.
    fn keep(&mut self, graph: &mut Graph, row: &BTreeMap<Unknown, Expression>) {
        for u in row.keys() {
            if let Some(entries) = self.rows.get_mut(u) {
                for (v, entry) in entries.iter_mut() {
                    if row.contains_key(v) {
                        *entry = kept(graph, *entry);
                    }
                }
            }
        }
    }

    /// H(u, v) −= change, on both sides of the diagonal.
    fn subtract(&mut self, graph: &mut Graph, u: Unknown, v: Unknown, change: Expression) {
        let change = graph.negate(change);
        self.add(graph, u, v, change);
    }

    fn add(&mut self, graph: &mut Graph, u: Unknown, v: Unknown, change: Expression) {
        let zero = graph.zero();
        let before = self
            .rows
            .get(&u)
            .and_then(|row| row.get(&v))
            .copied()
            .unwrap_or(zero);
        let after = graph.add(before, change);
        for (x, y) in [(u, v), (v, u)] {
            let row = self.rows.entry(x).or_default();
            if graph.is_zero(after) {
                row.remove(&y);
            } else {
                row.insert(y, after);
            }
        }
    }

    /// Puts ẇₖ = ẇ_parent + Σ e q̈ + Dw into the quadratic form.
    fn put_in(&mut self, graph: &mut Graph, k: usize) {
        self.done[k] = true;
        let form = &self.tree.forms[k];
        let one = graph.one();
        let mut parts: Vec<(Unknown, Expression)> = form
            .local
            .iter()
            .map(|(i, e)| (Unknown::Coordinate(*i), *e))
            .collect();
        parts.extend(form.parent.map(|parent| (Unknown::Rate(parent), one)));
        let unknown = Unknown::Rate(k);
        let mut row = self.rows.remove(&unknown).unwrap_or_default();
        let zero = graph.zero();
        let own = row.remove(&unknown).unwrap_or(zero);
        let right = self.right.remove(&unknown).unwrap_or(zero);
        // ½ H (Σ s x + d)² − h (Σ s x + d)
        let drift = graph.multiply(own, form.drift);
        let load = graph.subtract(right, drift);
        for (position, (u, s)) in parts.iter().enumerate() {
            let scaled = graph.multiply(*s, own);
            for (v, t) in &parts[..=position] {
                let change = graph.multiply(scaled, *t);
                self.add(graph, *u, *v, change);
            }
            self.add_right(graph, *u, *s, load);
        }
        // H v (Σ s x + d)
        for (v, entry) in row {
            if let Some(entries) = self.rows.get_mut(&v) {
                entries.remove(&unknown);
            }
            for (u, s) in &parts {
                let mut change = graph.multiply(*s, entry);
                if *u == v {
                    change = graph.scale(change, &Rational::integer(2));
                }
                self.add(graph, *u, v, change);
            }
            let load = graph.multiply(entry, form.drift);
            let load = graph.negate(load);
            self.add_right(graph, v, one, load);
        }
    }

    /// h(u) += s · load.
    fn add_right(&mut self, graph: &mut Graph, u: Unknown, s: Expression, load: Expression) {
        let zero = graph.zero();
        let change = graph.multiply(s, load);
        let before = self.right.get(&u).copied().unwrap_or(zero);
        self.right.insert(u, graph.add(before, change));
    }
}

/// The accelerations, from the last elimination back to the first.
fn substitute(
    graph: &mut Graph,
    tree: &KinematicTree,
    eliminations: &[Elimination],
) -> Vec<Expression> {
    let zero = graph.zero();
    let mut accelerations: Vec<Option<Expression>> = vec![None; tree.right.len()];
    let mut rates: Vec<Option<Expression>> = vec![None; tree.forms.len()];
    for elimination in eliminations.iter().rev() {
        let mut terms = vec![(elimination.right, Rational::ONE)];
        for (unknown, entry) in &elimination.row {
            let value = match unknown {
                Unknown::Coordinate(i) => accelerations[*i],
                Unknown::Rate(k) => rate(graph, tree, *k, &accelerations, &mut rates),
            };
            let product = graph.multiply(*entry, value.unwrap_or(zero));
            terms.push((product, Rational::MINUS_ONE));
        }
        let rest = graph.sum(terms);
        let acceleration = graph.divide(rest, elimination.pivot);
        accelerations[elimination.coordinate] = Some(graph.whole(acceleration));
    }
    accelerations
        .into_iter()
        .map(|value| value.unwrap_or(zero))
        .collect()
}

/// ẇₖ, where the accelerations it is made of are known.
fn rate(
    graph: &mut Graph,
    tree: &KinematicTree,
    k: usize,
    accelerations: &[Option<Expression>],
    rates: &mut [Option<Expression>],
) -> Option<Expression> {
    // From k towards the root until a rate is known, then back.
    let mut path = vec![k];
    while let Some(parent) = path.last().and_then(|k| tree.forms[*k].parent) {
        if rates[parent].is_some() {
            break;
        }
        path.push(parent);
    }
    for k in path.into_iter().rev() {
        if rates[k].is_some() {
            continue;
        }
        let form = &tree.forms[k];
        let mut terms = vec![(form.drift, Rational::ONE)];
        terms.extend(
            form.parent
                .and_then(|parent| rates[parent])
                .map(|rate| (rate, Rational::ONE)),
        );
        for (i, coefficient) in &form.local {
            let product = graph.multiply(*coefficient, accelerations[*i]?);
            terms.push((product, Rational::ONE));
        }
        let sum = graph.sum(terms);
        rates[k] = Some(graph.whole(sum));
    }
    rates[k]
}

/// The expression, kept whole unless it is short.
fn kept(graph: &mut Graph, expression: Expression) -> Expression {
    match graph.node(expression) {
        Node::Sum(terms) if terms.len() > LONGEST_MERGED => graph.whole(expression),
        _ => expression,
    }
}
