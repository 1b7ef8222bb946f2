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
use crate::matrix::ldlt::stability::exceeds;
use crate::mechanics::mechanism::Inertia;
use crate::mechanics::solvers::link_constraints::LinkConstraint;
use crate::mechanics::solvers::twist_elimination::{
    EliminatedRow, Step, TwistElimination, Unknown, twist,
};
use crate::{Expression, Graph, Rational};

/// The multipliers that are to be eliminated, as further coordinates.
pub(crate) struct MultiplierElimination {
    waiting: Vec<usize>,
    /// The eliminated coordinates that the constraint of a multiplier restricts.
    restricted: BTreeMap<usize, BTreeSet<usize>>,
    /// What the multipliers before have taken from the diagonal entry of another.
    reductions: BTreeMap<Unknown, Expression>,
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
            for (link, coefficients) in &constraint.links {
                for (unknown, coefficient) in twist(*link).zip(coefficients.components()) {
                    let entry = graph.negate(coefficient);
                    elimination.increase(graph, own, unknown, entry);
                }
            }
            for (coordinate, coefficient) in &constraint.coordinates {
                let entry = graph.negate(*coefficient);
                elimination.increase(graph, own, Unknown::Coordinate(*coordinate), entry);
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

    /// Records which constraints restrict a coordinate that has been eliminated.
    pub(crate) fn record(&mut self, row: &EliminatedRow) {
        for (unknown, ..) in &row.others {
            if let Unknown::Coordinate(i) = unknown
                && self.waiting.contains(i)
            {
                let coordinates = self.restricted.entry(*i).or_default();
                coordinates.insert(row.coordinate);
            }
        }
    }

    /// Eliminates the multipliers that the eliminated coordinates determine, of constraints on what moves with a link. Of this link
    /// some inertia may have been moved to the link before.
    pub(crate) fn eliminate_determined(
        &mut self,
        graph: &mut Graph,
        elimination: &mut TwistElimination,
        (link, moved): (usize, &Inertia),
        steps: &mut Vec<Step>,
    ) {
        for (group, restricted) in self.groups() {
            let is_new = self.tried.get(&group) != Some(&restricted);
            let is_elsewhere = |multiplier: &usize| {
                let row = elimination.row(Unknown::Coordinate(*multiplier));
                let mut unknowns = row.keys();
                unknowns.any(|unknown| matches!(unknown, Unknown::Twist(i, _) if *i != link))
            };
            if restricted < group.len() || !is_new || group.iter().any(is_elsewhere) {
                continue;
            }
            let Some(eliminated) = Eliminated::of(graph, elimination, &group) else {
                self.tried.insert(group, restricted);
                continue;
            };
            let moved = diagonal(graph, link, moved);
            if let Some(conditions) = self.conditions_of(graph, elimination, &eliminated, &moved) {
                self.conditions.extend(conditions);
                self.accept(graph, elimination, eliminated, steps);
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
        let eliminated = Eliminated::of(graph, elimination, &self.waiting)?;
        let none = BTreeMap::new();
        let conditions = self.conditions_of(graph, elimination, &eliminated, &none)?;
        self.conditions.extend(conditions);
        self.accept(graph, elimination, eliminated, steps);
        Some(())
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

    /// The conditions for a stable elimination of a group; none where a constraint acts on what has no inertia yet.
    fn conditions_of(
        &self,
        graph: &mut Graph,
        before: &TwistElimination,
        eliminated: &Eliminated,
        moved: &BTreeMap<Unknown, Expression>,
    ) -> Option<Vec<Expression>> {
        let mut conditions = Vec::new();
        for (unknown, change) in eliminated.changes(graph) {
            if self.is_waiting(unknown) {
                continue;
            }
            let inertia = before.entry(graph, unknown, unknown);
            let moved = moved.get(&unknown).copied().unwrap_or(graph.zero());
            let inertia = graph.add(inertia, moved);
            if graph.is_zero(inertia) {
                return None;
            }
            conditions.push(exceeds(graph, inertia, change, MIN_SADDLE_POINT_PIVOT));
        }
        for row in &eliminated.rows {
            let own = Unknown::Coordinate(row.coordinate);
            let reduction = self.reductions.get(&own).copied();
            let reduction = reduction.unwrap_or(graph.zero());
            let entry = before.entry(graph, own, own);
            let whole = graph.subtract(reduction, entry);
            let pivot = graph.negate(row.pivot);
            if pivot != whole {
                conditions.push(exceeds(graph, pivot, whole, MIN_SADDLE_POINT_PIVOT));
            }
        }
        Some(conditions)
    }

    fn accept(
        &mut self,
        graph: &mut Graph,
        elimination: &mut TwistElimination,
        eliminated: Eliminated,
        steps: &mut Vec<Step>,
    ) {
        for (unknown, change) in eliminated.changes(graph) {
            if self.is_waiting(unknown) {
                let known = self.reductions.get(&unknown).copied();
                let known = known.unwrap_or(graph.zero());
                self.reductions.insert(unknown, graph.add(known, change));
            }
        }
        let of_group = |multiplier: &usize| {
            let mut rows = eliminated.rows.iter();
            rows.any(|row| row.coordinate == *multiplier)
        };
        self.waiting.retain(|multiplier| !of_group(multiplier));
        *elimination = eliminated.rest;
        steps.extend(eliminated.rows.into_iter().map(Step::Eliminate));
    }

    fn is_waiting(&self, unknown: Unknown) -> bool {
        matches!(unknown, Unknown::Coordinate(i) if self.waiting.contains(&i))
    }
}

/// Multipliers that have been eliminated from a quadratic form, and what is left of it.
struct Eliminated {
    rows: Vec<EliminatedRow>,
    rest: TwistElimination,
}

impl Eliminated {
    /// Eliminates multipliers, unless a pivot vanishes.
    fn of(graph: &mut Graph, elimination: &TwistElimination, group: &[usize]) -> Option<Self> {
        let mut rest = elimination.clone();
        let mut rows = Vec::with_capacity(group.len());
        for multiplier in group {
            let row = rest.eliminate(graph, *multiplier)?;
            if graph.vanishes(&[row.pivot]) {
                return None;
            }
            rows.push(row);
        }
        Some(Self { rows, rest })
    }

    /// What is added to the diagonal entries.
    fn changes(&self, graph: &mut Graph) -> BTreeMap<Unknown, Expression> {
        let mut terms: BTreeMap<Unknown, Vec<(Expression, Rational)>> = BTreeMap::new();
        for row in &self.rows {
            for (unknown, entry, ratio) in &row.others {
                let product = graph.multiply(*entry, *ratio);
                let terms = terms.entry(*unknown).or_default();
                terms.push((product, Rational::MINUS_ONE));
            }
        }
        let changes = terms.into_iter();
        changes
            .map(|(unknown, terms)| (unknown, graph.sum(terms)))
            .collect()
    }
}

/// The diagonal entries of the inertia of a link.
fn diagonal(graph: &mut Graph, link: usize, inertia: &Inertia) -> BTreeMap<Unknown, Expression> {
    let tensor = inertia.tensor(graph);
    let entries = [tensor[0][0], tensor[1][1], tensor[2][2]];
    let entries = entries.into_iter().chain([inertia.mass; 3]);
    twist(link).zip(entries).collect()
}
