//! Articulated-body elimination: q̈ along a tree of quasi-velocities, from the leaves to the root (Vereshchagin,
//! Computer simulation of the dynamics of complicated mechanisms of robot manipulators, 1974; Featherstone, The
//! calculation of robot dynamics using articulated-body inertias, 1983).
//!
//! By Gauss's principle of least constraint (1829) the accelerations make ½ ẇᵀ W ẇ − rᵀ q̈ stationary under
//! ẇₖ = ẇₚ + Σ eₖᵢ q̈ᵢ + Dwₖ, a minimum if M is positive definite. The ẇₖ of a leaf is substituted; then a coordinate
//! that occurs in the quadratic form alone is eliminated, and the remainder is the articulated-body inertia of the rest
//! of the tree. A chain takes as many steps of a fixed size as it has links, where elimination of M takes the cube. Where
//! no form has a parent, this is the elimination of M, with simplified Schur complements. Featherstone's bias force pᴬ is
//! the right-hand side h with the opposite sign.

use std::collections::BTreeMap;

use crate::limits::MAX_TRANSPARENT_INERTIA_LENGTH;
use crate::matrix::symmetric_elimination::{PivotRow, SymmetricElimination};
use crate::mechanics::solvers::kinematic_tree::KinematicTree;
use crate::mechanics::solvers::pivots::Pivot;
use crate::{Expression, Graph, Node, Rational};

/// An unknown: q̈ᵢ or ẇₖ.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Unknown {
    Coordinate(usize),
    Rate(usize),
}

/// One step of the factorization.
enum EliminationStep {
    Substitute(Substitution),
    /// Elimination of q̈ⱼ.
    Eliminate(usize, PivotRow<Unknown>),
}

/// Substitution of ẇₖ = Σ parts for ẇₖ, with its row of the quadratic form.
struct Substitution {
    form: usize,
    parts: Vec<(Unknown, Expression)>,
    row: PivotRow<Unknown>,
}

/// The factored equations of a tree.
pub(crate) struct ArticulatedBodies {
    tree: KinematicTree,
    steps: Vec<EliminationStep>,
    /// The expressions that must be positive: the pivots, and the unit of inertia that they are relative to.
    pub(crate) pivots: Vec<Expression>,
    /// What q̈ is divided by: the pivot of each coordinate, and the unit of inertia.
    pub(crate) divisors: Vec<Pivot>,
}

impl ArticulatedBodies {
    /// Factors the equations Eᵀ W ẇ = r of `tree`, unless a pivot vanishes or its row has more than `limit`
    /// other entries.
    pub(crate) fn factor(graph: &mut Graph, tree: KinematicTree, limit: usize) -> Option<Self> {
        let mut quadratic = Quadratic::new(graph, &tree);
        let mut waiting: Vec<usize> = (0..tree.right.len()).collect();
        while let Some(coordinate) = quadratic.next_coordinate(&waiting) {
            waiting.retain(|i| *i != coordinate);
            quadratic.eliminate(graph, coordinate, limit)?;
        }
        let steps = quadratic.steps;
        let divisors = steps.iter().filter_map(|step| match step {
            EliminationStep::Eliminate(coordinate, row) => Some(Pivot {
                value: row.pivot,
                coordinates: vec![*coordinate],
            }),
            EliminationStep::Substitute(_) => None,
        });
        let unit = Pivot {
            value: tree.unit,
            coordinates: (0..tree.right.len()).collect(),
        };
        let divisors: Vec<_> = divisors.chain([unit]).collect();
        let mut pivots: Vec<_> = divisors.iter().map(|pivot| pivot.value).collect();
        pivots.retain(|pivot| graph.as_constant(*pivot).is_none_or(Rational::is_negative));
        Some(Self {
            tree,
            steps,
            pivots,
            divisors,
        })
    }

    /// The accelerations.
    pub(crate) fn accelerations(&self, graph: &mut Graph) -> Vec<Expression> {
        self.solve(graph, &self.tree.right, &self.tree.velocity_products())
    }

    /// x in M x = r, for M and r in the tree's unit.
    pub(crate) fn solution(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        let velocity_products = vec![graph.zero(); self.tree.forms.len()];
        self.solve(graph, right, &velocity_products)
    }

    /// The unit of inertia.
    pub(crate) fn unit(&self) -> Expression {
        self.tree.unit
    }

    /// M q̈ − f in the tree's unit.
    pub(crate) fn inverse_dynamics(&self, graph: &mut Graph) -> Vec<Expression> {
        self.tree.inverse_dynamics(graph)
    }

    fn solve(
        &self,
        graph: &mut Graph,
        right: &[Expression],
        velocity_products: &[Expression],
    ) -> Vec<Expression> {
        let forces = right.iter().enumerate();
        let forces = forces.map(|(i, force)| (Unknown::Coordinate(i), *force));
        let mut right_hand_side = RightHandSide(forces.collect());
        for step in &self.steps {
            match step {
                EliminationStep::Substitute(step) => {
                    right_hand_side.substitute(graph, step, velocity_products[step.form]);
                }
                EliminationStep::Eliminate(_, row) => {
                    row.reduce_right(graph, &mut right_hand_side.0, opaque_unless_short);
                }
            }
        }
        self.back_substitute(graph, &right_hand_side, velocity_products)
    }

    /// The accelerations, from the last step back to the first: what a step needs was eliminated or substituted behind it.
    fn back_substitute(
        &self,
        graph: &mut Graph,
        right_hand_side: &RightHandSide,
        velocity_products: &[Expression],
    ) -> Vec<Expression> {
        let zero = graph.zero();
        let mut known = BTreeMap::new();
        let value = |known: &BTreeMap<_, _>, u: &Unknown| known.get(u).copied().unwrap_or(zero);
        for step in self.steps.iter().rev() {
            let (unknown, found) = match step {
                EliminationStep::Eliminate(_, row) => {
                    let others = |_: &mut Graph, u| value(&known, &u);
                    let found = row.solve(graph, &right_hand_side.0, others);
                    (row.unknown, found)
                }
                EliminationStep::Substitute(step) => {
                    let mut terms = vec![(velocity_products[step.form], Rational::ONE)];
                    for (u, s) in &step.parts {
                        let part = graph.multiply(*s, value(&known, u));
                        terms.push((part, Rational::ONE));
                    }
                    (step.row.unknown, graph.sum(terms))
                }
            };
            known.insert(unknown, graph.opaque(found));
        }
        let unknowns = (0..self.tree.right.len()).map(Unknown::Coordinate);
        unknowns.map(|unknown| value(&known, &unknown)).collect()
    }
}

/// ½ xᵀ H x over the remaining unknowns.
struct Quadratic<'a> {
    tree: &'a KinematicTree,
    /// H.
    matrix: SymmetricElimination<Unknown>,
    /// Which forms have been substituted.
    done: Vec<bool>,
    steps: Vec<EliminationStep>,
}

impl<'a> Quadratic<'a> {
    fn new(graph: &Graph, tree: &'a KinematicTree) -> Self {
        Self {
            tree,
            matrix: SymmetricElimination::new(graph, &tree.inertia, Unknown::Rate),
            done: vec![false; tree.forms.len()],
            steps: Vec::new(),
        }
    }

    /// The forms to be substituted before a coordinate can be eliminated, leaves first.
    fn forms_above(&self, coordinate: usize) -> Vec<usize> {
        let mut wanted = vec![false; self.done.len()];
        for (k, form) in self.tree.forms.iter().enumerate() {
            let uses = form.local.iter().any(|(i, _)| *i == coordinate);
            wanted[k] = !self.done[k] && (uses || form.parent.is_some_and(|parent| wanted[parent]));
        }
        (0..wanted.len()).rev().filter(|k| wanted[*k]).collect()
    }

    /// The coordinate for which the fewest forms have to be substituted; of several, the last.
    fn next_coordinate(&self, waiting: &[usize]) -> Option<usize> {
        waiting
            .iter()
            .copied()
            .min_by_key(|i| (self.forms_above(*i).len(), core::cmp::Reverse(*i)))
    }

    /// Eliminates a coordinate, after the forms that contain it have been substituted.
    fn eliminate(&mut self, graph: &mut Graph, coordinate: usize, limit: usize) -> Option<()> {
        for k in self.forms_above(coordinate) {
            self.substitute(graph, k);
        }
        let row = self.matrix.take(graph, Unknown::Coordinate(coordinate));
        if graph.is_zero(row.pivot) || row.others.len() > limit {
            return None;
        }
        self.matrix.reduce(graph, &row, opaque_unless_short);
        self.steps.push(EliminationStep::Eliminate(coordinate, row));
        Some(())
    }

    /// Substitutes ẇₖ = ẇₚ + Σ e q̈ in the quadratic form.
    fn substitute(&mut self, graph: &mut Graph, k: usize) {
        self.done[k] = true;
        let form = &self.tree.forms[k];
        let one = graph.one();
        let local = form
            .local
            .iter()
            .map(|(i, e)| (Unknown::Coordinate(*i), *e));
        let parent = form.parent.map(|parent| (Unknown::Rate(parent), one));
        let parts: Vec<_> = local.chain(parent).collect();
        let row = self.matrix.take(graph, Unknown::Rate(k));
        for (position, (u, s)) in parts.iter().enumerate() {
            let scaled = graph.multiply(*s, row.pivot);
            for (v, t) in &parts[..=position] {
                let change = graph.multiply(scaled, *t);
                self.matrix.add(graph, *u, *v, change);
            }
        }
        for (v, entry) in &row.others {
            for (u, s) in &parts {
                let mut change = graph.multiply(*s, *entry);
                if u == v {
                    change = graph.scale(change, &Rational::integer(2));
                }
                self.matrix.add(graph, *u, *v, change);
            }
        }
        self.steps.push(EliminationStep::Substitute(Substitution {
            form: k,
            parts,
            row,
        }));
    }
}

/// The right-hand side h of ½ xᵀ H x − hᵀ x.
struct RightHandSide(BTreeMap<Unknown, Expression>);

impl RightHandSide {
    fn of(&self, graph: &Graph, unknown: Unknown) -> Expression {
        self.0.get(&unknown).copied().unwrap_or(graph.zero())
    }

    /// h(u) += s · force.
    fn add(&mut self, graph: &mut Graph, u: Unknown, s: Expression, force: Expression) {
        let change = graph.multiply(s, force);
        let before = self.of(graph, u);
        self.0.insert(u, graph.add(before, change));
    }

    /// The same substitution in the linear terms, with ẇₖ = Σ parts + the velocity-product acceleration.
    fn substitute(&mut self, graph: &mut Graph, step: &Substitution, velocity_product: Expression) {
        let own = graph.multiply(step.row.pivot, velocity_product);
        let before = self.of(graph, Unknown::Rate(step.form));
        let force = graph.subtract(before, own);
        for (u, s) in &step.parts {
            self.add(graph, *u, *s, force);
        }
        let opposite = graph.negate(velocity_product);
        for (v, entry) in &step.row.others {
            self.add(graph, *v, *entry, opposite);
        }
    }
}

/// The expression, opaque unless it is a short sum.
fn opaque_unless_short(graph: &mut Graph, expression: Expression) -> Expression {
    match graph.node(expression) {
        Node::Sum(terms) if terms.len() > MAX_TRANSPARENT_INERTIA_LENGTH => {
            graph.opaque(expression)
        }
        _ => expression,
    }
}
