//! The elimination of multipliers between coordinates, along the links of a mechanism.
//!
//! Where the coordinates of some links are eliminated, −G M⁻¹ Gᵀ of these is what is left at the multipliers of the constraints on
//! them. As soon as it is regular, the multipliers are eliminated, too: the loop is closed, and what remains of it is a part of
//! the inertia of the link before (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 8; Baraff, Linear-time dynamics
//! using Lagrange multipliers, 1996). So a constraint is carried only as far as its loop reaches.
//!
//! As in the [factors of a saddle point problem](crate::matrix::ldlt), this is stable where conditions hold: no pivot is a small
//! remainder of what it is subtracted from, and what a constraint adds to the inertia of a link is no large multiple of it.

use std::collections::{BTreeMap, BTreeSet};

use crate::limits::MIN_SADDLE_POINT_PIVOT;
use crate::mechanics::solvers::articulated_links::Step;
use crate::mechanics::solvers::link_constraints::LinkConstraint;
use crate::mechanics::solvers::twist_elimination::{
    EliminatedRow, TwistElimination, Unknown, angular, linear,
};
use crate::{Expression, Graph, Rational};

/// The multipliers that are to be eliminated, as further coordinates.
pub(crate) struct MultiplierElimination {
    waiting: Vec<usize>,
    /// The eliminated coordinates that the constraint of a multiplier restricts.
    restricted: BTreeMap<usize, BTreeSet<usize>>,
    /// What the multipliers before have taken from the diagonal entry of another.
    reductions: BTreeMap<usize, Expression>,
    /// How many coordinates a group restricted that was not regular.
    tried: BTreeMap<Vec<usize>, usize>,
    /// Expressions that are positive where the elimination is stable.
    pub(crate) conditions: Vec<Expression>,
}

impl MultiplierElimination {
    /// Adds the constraints to a quadratic form, with multipliers behind so many coordinates.
    pub(crate) fn of(
        graph: &mut Graph,
        elimination: &mut TwistElimination,
        constraints: &[LinkConstraint],
        coordinates: usize,
    ) -> Self {
        for (multiplier, constraint) in (coordinates..).zip(constraints) {
            let own = Unknown::Coordinate(multiplier);
            for (link, [turning, moving]) in &constraint.links {
                let unknowns = angular(*link).into_iter().chain(linear(*link));
                for (unknown, coefficient) in unknowns.zip(turning.iter().chain(moving)) {
                    let entry = graph.negate(*coefficient);
                    elimination.add(graph, own, unknown, entry);
                }
            }
            for (coordinate, coefficient) in &constraint.coordinates {
                let entry = graph.negate(*coefficient);
                elimination.add(graph, own, Unknown::Coordinate(*coordinate), entry);
            }
        }
        Self {
            waiting: (coordinates..coordinates + constraints.len()).collect(),
            restricted: BTreeMap::new(),
            reductions: BTreeMap::new(),
            tried: BTreeMap::new(),
            conditions: Vec::new(),
        }
    }

    /// Takes notice of a coordinate that has been eliminated.
    pub(crate) fn notice(&mut self, row: &EliminatedRow) {
        for (unknown, ..) in &row.others {
            if let Unknown::Coordinate(i) = unknown
                && self.waiting.contains(i)
            {
                let coordinates = self.restricted.entry(*i).or_default();
                coordinates.insert(row.coordinate);
            }
        }
    }

    /// Eliminates the multipliers that the eliminated coordinates determine.
    pub(crate) fn eliminate_determined(
        &mut self,
        graph: &mut Graph,
        elimination: &mut TwistElimination,
        steps: &mut Vec<Step>,
    ) {
        for (group, restricted) in self.groups() {
            let is_new = self.tried.get(&group) != Some(&restricted);
            if restricted < group.len() || !is_new {
                continue;
            }
            if self.eliminate(graph, elimination, &group, steps).is_none() {
                self.tried.insert(group, restricted);
            }
        }
    }

    /// Eliminates all others, unless a pivot vanishes.
    pub(crate) fn eliminate_rest(
        &mut self,
        graph: &mut Graph,
        elimination: &mut TwistElimination,
        steps: &mut Vec<Step>,
    ) -> Option<()> {
        let group = self.waiting.clone();
        self.eliminate(graph, elimination, &group, steps)
    }

    /// Multipliers whose constraints restrict the same eliminated coordinates, with how many these are.
    fn groups(&self) -> Vec<(Vec<usize>, usize)> {
        let mut groups: Vec<(Vec<usize>, BTreeSet<usize>)> = Vec::new();
        for multiplier in &self.waiting {
            let Some(coordinates) = self.restricted.get(multiplier) else {
                continue;
            };
            let (mut members, mut union) = (vec![*multiplier], coordinates.clone());
            groups.retain(|(others, theirs)| {
                let is_apart = theirs.is_disjoint(&union);
                if !is_apart {
                    members.extend(others);
                    union.extend(theirs);
                }
                is_apart
            });
            members.sort_unstable();
            groups.push((members, union));
        }
        let groups = groups.into_iter();
        groups
            .map(|(members, union)| (members, union.len()))
            .collect()
    }

    /// Eliminates some multipliers, unless a pivot vanishes, or a constraint acts on what has no inertia yet.
    fn eliminate(
        &mut self,
        graph: &mut Graph,
        elimination: &mut TwistElimination,
        group: &[usize],
        steps: &mut Vec<Step>,
    ) -> Option<()> {
        let mut trial = elimination.clone();
        let mut rows = Vec::with_capacity(group.len());
        for multiplier in group {
            let row = trial.eliminate(graph, *multiplier)?;
            if graph.vanishes(&[row.pivot]) {
                return None;
            }
            rows.push(row);
        }
        let mut added: BTreeMap<Unknown, Vec<(Expression, Rational)>> = BTreeMap::new();
        for row in &rows {
            for (unknown, entry, ratio) in &row.others {
                let product = graph.multiply(*entry, *ratio);
                added
                    .entry(*unknown)
                    .or_default()
                    .push((product, Rational::MINUS_ONE));
            }
        }
        let mut conditions = Vec::new();
        for (unknown, terms) in &added {
            let change = graph.sum(terms.iter().cloned());
            let own = elimination.entry(graph, *unknown, *unknown);
            match unknown {
                Unknown::Coordinate(i) if self.waiting.contains(i) => {}
                _ if graph.is_zero(own) => return None,
                _ => conditions.push(exceeds(graph, own, change)),
            }
        }
        for row in &rows {
            let own = Unknown::Coordinate(row.coordinate);
            let before = elimination.entry(graph, own, own);
            let reduction = self.reductions.get(&row.coordinate).copied();
            let reduction = reduction.unwrap_or(graph.zero());
            let before = graph.subtract(reduction, before);
            let pivot = graph.negate(row.pivot);
            if pivot != before {
                conditions.push(exceeds(graph, pivot, before));
            }
        }
        for (unknown, terms) in added {
            if let Unknown::Coordinate(i) = unknown {
                let change = graph.sum(terms);
                let known = self.reductions.get(&i).copied().unwrap_or(graph.zero());
                self.reductions.insert(i, graph.add(known, change));
            }
        }
        self.conditions.extend(conditions);
        self.waiting
            .retain(|multiplier| !group.contains(multiplier));
        *elimination = trial;
        steps.extend(rows.into_iter().map(Step::Eliminate));
        Some(())
    }
}

/// What is positive where `x` is no small part of `y`.
fn exceeds(graph: &mut Graph, x: Expression, y: Expression) -> Expression {
    let (numerator, denominator) = MIN_SADDLE_POINT_PIVOT;
    let least = Rational::new(-numerator, denominator).unwrap_or(Rational::ZERO);
    graph.sum([(x, Rational::ONE), (y, least)])
}
