//! q̈ along a tree of quasi-velocities, leaf by leaf.
//!
//! By Gauss's principle the accelerations minimize ½ ẇᵀ W ẇ − rᵀ q̈ under ẇₖ = ẇₚ + Σ eₖᵢ q̈ᵢ + Dwₖ.
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

/// One step of the factorization.
enum Step {
    PutIn(PutIn),
    Eliminate(Eliminate),
}

/// ẇₖ = Σ parts in the place of ẇₖ, which stood in `own`·½ẇₖ² + ẇₖ Σ row.
struct PutIn {
    form: usize,
    parts: Vec<(Unknown, Expression)>,
    own: Expression,
    row: Vec<(Unknown, Expression)>,
}

/// q̈ⱼ from what is found after it: D q̈ⱼ = h − Σ row·x.
struct Eliminate {
    coordinate: usize,
    pivot: Expression,
    row: Vec<(Unknown, Expression)>,
}

/// The factors of a tree's equations.
pub(crate) struct Articulation {
    tree: KinematicTree,
    steps: Vec<Step>,
    /// What has to be positive: the pivots, and the inertia in units of which they are.
    pub(crate) pivots: Vec<Expression>,
}

/// Sums of more terms than this are kept whole.
const LONGEST_MERGED: usize = 2;

impl Articulation {
    /// Factors the equations Eᵀ W ẇ = r of `tree`, unless a pivot vanishes or more than `limit` unknowns
    /// meet.
    pub(crate) fn factor(graph: &mut Graph, tree: KinematicTree, limit: usize) -> Option<Self> {
        let mut quadratic = Quadratic::new(graph, &tree);
        let mut waiting: Vec<usize> = (0..tree.right.len()).collect();
        while let Some(coordinate) = quadratic.cheapest(&waiting) {
            waiting.retain(|i| *i != coordinate);
            quadratic.eliminate(graph, coordinate, limit)?;
        }
        let steps = quadratic.steps;
        let mut pivots: Vec<_> = steps
            .iter()
            .filter_map(|step| match step {
                Step::Eliminate(elimination) => Some(elimination.pivot),
                Step::PutIn(_) => None,
            })
            .collect();
        pivots.push(tree.unit);
        pivots.retain(|pivot| graph.as_constant(*pivot).is_none_or(Rational::is_negative));
        Some(Self {
            tree,
            steps,
            pivots,
        })
    }

    /// The accelerations.
    pub(crate) fn accelerations(&self, graph: &mut Graph) -> Vec<Expression> {
        let drifts: Vec<_> = self.tree.forms.iter().map(|form| form.drift).collect();
        self.solve(graph, &self.tree.right, &drifts)
    }

    /// x in M x = r, for M and r in the tree's unit.
    pub(crate) fn solution(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        let drifts = vec![graph.zero(); self.tree.forms.len()];
        self.solve(graph, right, &drifts)
    }

    /// M q̈ − f in the tree's unit.
    pub(crate) fn inverse_dynamics(&self, graph: &mut Graph) -> Vec<Expression> {
        self.tree.inverse_dynamics(graph)
    }

    fn solve(
        &self,
        graph: &mut Graph,
        right: &[Expression],
        drifts: &[Expression],
    ) -> Vec<Expression> {
        let mut loads = Loads::new(right);
        let mut rights = vec![graph.zero(); right.len()];
        for step in &self.steps {
            match step {
                Step::PutIn(step) => loads.put_in(graph, step, drifts[step.form]),
                Step::Eliminate(step) => {
                    rights[step.coordinate] = loads.eliminate(graph, step);
                }
            }
        }
        self.substitute(graph, &rights, drifts)
    }

    /// The accelerations, from the last elimination back to the first.
    fn substitute(
        &self,
        graph: &mut Graph,
        rights: &[Expression],
        drifts: &[Expression],
    ) -> Vec<Expression> {
        let zero = graph.zero();
        let mut known = Known {
            tree: &self.tree,
            drifts,
            accelerations: vec![None; self.tree.right.len()],
            rates: vec![None; self.tree.forms.len()],
        };
        for step in self.steps.iter().rev() {
            let Step::Eliminate(step) = step else {
                continue;
            };
            let mut terms = vec![(rights[step.coordinate], Rational::ONE)];
            for (unknown, entry) in &step.row {
                let value = known.value(graph, *unknown).unwrap_or(zero);
                terms.push((graph.multiply(*entry, value), Rational::MINUS_ONE));
            }
            let rest = graph.sum(terms);
            let acceleration = graph.divide(rest, step.pivot);
            known.accelerations[step.coordinate] = Some(graph.whole(acceleration));
        }
        let accelerations = known.accelerations.into_iter();
        accelerations.map(|value| value.unwrap_or(zero)).collect()
    }
}

/// ½ xᵀ H x over the unknowns that are left.
struct Quadratic<'a> {
    tree: &'a KinematicTree,
    /// The rows of H, both triangles, without zeros.
    rows: BTreeMap<Unknown, BTreeMap<Unknown, Expression>>,
    /// Which forms have been put in.
    done: Vec<bool>,
    steps: Vec<Step>,
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
        Self {
            tree,
            rows,
            done: vec![false; tree.forms.len()],
            steps: Vec::new(),
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

    /// Eliminates a coordinate, after the forms that contain it have been put in.
    fn eliminate(&mut self, graph: &mut Graph, coordinate: usize, limit: usize) -> Option<()> {
        for k in self.above(coordinate) {
            self.put_in(graph, k);
        }
        let unknown = Unknown::Coordinate(coordinate);
        let mut row = self.rows.remove(&unknown)?;
        let pivot = row.remove(&unknown)?;
        if row.len() > limit {
            return None;
        }
        for (u, entry) in &row {
            let factor = graph.divide(*entry, pivot);
            for (v, other) in row.range(..=u) {
                let change = graph.multiply(factor, *other);
                let change = graph.negate(change);
                self.add(graph, *u, *v, change);
            }
            if let Some(entries) = self.rows.get_mut(u) {
                entries.remove(&unknown);
            }
        }
        self.keep(graph, &row);
        self.steps.push(Step::Eliminate(Eliminate {
            coordinate,
            pivot,
            row: row.into_iter().collect(),
        }));
        Some(())
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

    /// H(u, v) += change, on both sides of the diagonal.
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

    /// Puts ẇₖ = ẇₚ + Σ e q̈ into the quadratic form.
    fn put_in(&mut self, graph: &mut Graph, k: usize) {
        self.done[k] = true;
        let form = &self.tree.forms[k];
        let (zero, one) = (graph.zero(), graph.one());
        let local = form
            .local
            .iter()
            .map(|(i, e)| (Unknown::Coordinate(*i), *e));
        let parent = form.parent.map(|parent| (Unknown::Rate(parent), one));
        let parts: Vec<_> = local.chain(parent).collect();
        let unknown = Unknown::Rate(k);
        let mut row = self.rows.remove(&unknown).unwrap_or_default();
        let own = row.remove(&unknown).unwrap_or(zero);
        for (position, (u, s)) in parts.iter().enumerate() {
            let scaled = graph.multiply(*s, own);
            for (v, t) in &parts[..=position] {
                let change = graph.multiply(scaled, *t);
                self.add(graph, *u, *v, change);
            }
        }
        for (v, entry) in &row {
            if let Some(entries) = self.rows.get_mut(v) {
                entries.remove(&unknown);
            }
            for (u, s) in &parts {
                let mut change = graph.multiply(*s, *entry);
                if u == v {
                    change = graph.scale(change, &Rational::integer(2));
                }
                self.add(graph, *u, *v, change);
            }
        }
        self.steps.push(Step::PutIn(PutIn {
            form: k,
            parts,
            own,
            row: row.into_iter().collect(),
        }));
    }
}

/// The linear terms h of ½ xᵀ H x − hᵀ x.
struct Loads(BTreeMap<Unknown, Expression>);

impl Loads {
    fn new(right: &[Expression]) -> Self {
        let right = right.iter().enumerate();
        Self(
            right
                .map(|(i, load)| (Unknown::Coordinate(i), *load))
                .collect(),
        )
    }

    fn of(&self, graph: &Graph, unknown: Unknown) -> Expression {
        self.0.get(&unknown).copied().unwrap_or(graph.zero())
    }

    /// h(u) += s · load.
    fn add(&mut self, graph: &mut Graph, u: Unknown, s: Expression, load: Expression) {
        let change = graph.multiply(s, load);
        let before = self.of(graph, u);
        self.0.insert(u, graph.add(before, change));
    }

    /// The same step with ẇₖ = Σ parts + drift.
    fn put_in(&mut self, graph: &mut Graph, step: &PutIn, drift: Expression) {
        let own = graph.multiply(step.own, drift);
        let before = self.of(graph, Unknown::Rate(step.form));
        let load = graph.subtract(before, own);
        for (u, s) in &step.parts {
            self.add(graph, *u, *s, load);
        }
        let opposite = graph.negate(drift);
        for (v, entry) in &step.row {
            self.add(graph, *v, *entry, opposite);
        }
    }

    /// The right-hand side of the eliminated coordinate.
    fn eliminate(&mut self, graph: &mut Graph, step: &Eliminate) -> Expression {
        let right = self.of(graph, Unknown::Coordinate(step.coordinate));
        for (u, entry) in &step.row {
            let factor = graph.divide(*entry, step.pivot);
            let change = graph.multiply(factor, right);
            let before = self.of(graph, *u);
            let after = graph.subtract(before, change);
            self.0.insert(*u, kept(graph, after));
        }
        right
    }
}

/// What has been found so far.
struct Known<'a> {
    tree: &'a KinematicTree,
    drifts: &'a [Expression],
    accelerations: Vec<Option<Expression>>,
    rates: Vec<Option<Expression>>,
}

impl Known<'_> {
    fn value(&mut self, graph: &mut Graph, unknown: Unknown) -> Option<Expression> {
        match unknown {
            Unknown::Coordinate(i) => self.accelerations[i],
            Unknown::Rate(k) => self.rate(graph, k),
        }
    }

    /// ẇₖ, where the accelerations it is made of are known.
    fn rate(&mut self, graph: &mut Graph, k: usize) -> Option<Expression> {
        // From k towards the root until a rate is known, then back.
        let mut path = vec![k];
        while let Some(parent) = path.last().and_then(|k| self.tree.forms[*k].parent) {
            if self.rates[parent].is_some() {
                break;
            }
            path.push(parent);
        }
        for k in path.into_iter().rev() {
            if self.rates[k].is_none() {
                self.rates[k] = self.step(graph, k);
            }
        }
        self.rates[k]
    }

    /// ẇₖ from that of its parent.
    fn step(&self, graph: &mut Graph, k: usize) -> Option<Expression> {
        let form = &self.tree.forms[k];
        let mut terms = vec![(self.drifts[k], Rational::ONE)];
        if let Some(parent) = form.parent {
            terms.push((self.rates[parent]?, Rational::ONE));
        }
        for (i, coefficient) in &form.local {
            let product = graph.multiply(*coefficient, self.accelerations[*i]?);
            terms.push((product, Rational::ONE));
        }
        let sum = graph.sum(terms);
        Some(graph.whole(sum))
    }
}

/// The expression, kept whole unless it is short.
fn kept(graph: &mut Graph, expression: Expression) -> Expression {
    match graph.node(expression) {
        Node::Sum(terms) if terms.len() > LONGEST_MERGED => graph.whole(expression),
        _ => expression,
    }
}
