//! Articulated-body elimination along the links of a mechanism (Vereshchagin 1974; Featherstone, The calculation of robot
//! dynamics using articulated-body inertias, 1983).
//!
//! The wrenches that the motion takes at q̈ = 0 come from [Newton and Euler](crate::mechanics::solvers::newton_euler), so
//! that nothing but accelerations is left to eliminate: from the last link on, its coordinate is split off and
//! eliminated, and what remains is turned into the axes of the link before and moved to its origin. A coordinate that
//! moves several joints is eliminated where the last of them has been passed. Multipliers of constraints are accelerations of further
//! coordinates, and are [eliminated](crate::mechanics::solvers::multiplier_elimination) as soon as the coordinates before
//! determine them. Back from the root to the leaves, the accelerations are substituted.

use std::collections::BTreeMap;

use crate::matrix::rows::sums;
use crate::mechanics::mechanism::Inertia;
use crate::mechanics::solvers::link_constraints::LinkConstraint;
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::mechanics::solvers::link_vectors::{Accelerations, RightHandSide};
use crate::mechanics::solvers::multiplier_elimination::MultiplierElimination;
use crate::mechanics::solvers::newton_euler::{Joint, JointPart};
use crate::mechanics::solvers::pivots::Pivot;
use crate::mechanics::solvers::spatial_vectors::Twist;
use crate::mechanics::solvers::twist_elimination::{
    InertiaRow, Slope, Step, TwistElimination, Unknown, linear, twist,
};
use crate::{Expression, Graph, Rational};

/// The rows of the quadratic form at what a joint moves, before it is passed and on the way.
#[derive(Clone, Default)]
pub(crate) struct PassedInertia {
    /// At the acceleration of the link, along its axes.
    turning: Vec<InertiaRow>,
    /// At the acceleration of the link, along the axes of the link before.
    sliding: Vec<InertiaRow>,
    /// At the acceleration of the origin, behind what slides.
    pub(crate) shift: [InertiaRow; 3],
}

impl PassedInertia {
    /// The rows at the acceleration of the link before a part of its joint is passed.
    pub(crate) fn before(&self, part: JointPart) -> &[InertiaRow] {
        match part {
            JointPart::Turning => &self.turning,
            JointPart::Sliding => &self.sliding,
        }
    }
}

/// The factored equations of a mechanism.
pub(crate) struct ArticulatedLinks {
    pub(crate) equations: LinkEquations,
    constraints: Vec<LinkConstraint>,
    pub(crate) steps: Vec<Step>,
    /// One for each link.
    pub(crate) inertias: Vec<PassedInertia>,
    /// The expressions that must be positive.
    pub(crate) pivots: Vec<Expression>,
    /// What q̈ is divided by, with the coordinate or multiplier of each: the pivots of coordinates, and the negated
    /// pivots of multipliers.
    pub(crate) divisors: Vec<Pivot>,
}

impl ArticulatedLinks {
    /// Factors the equations with these constraints, unless a pivot vanishes.
    pub(crate) fn factor(
        graph: &mut Graph,
        equations: LinkEquations,
        constraints: &[LinkConstraint],
    ) -> Option<Self> {
        let coordinates = equations.forces.len();
        let mut uses = uses(&equations.joints, coordinates);
        let mass = &equations.other_mass;
        let mut elimination = TwistElimination::new(graph, mass, Unknown::Coordinate);
        let mut multipliers =
            MultiplierElimination::of(graph, &mut elimination, constraints, coordinates);
        let mut steps = Vec::new();
        let nothing = Inertia::none(graph);
        let mut inertias = vec![PassedInertia::default(); equations.joints.len()];
        // What moves no link.
        for coordinate in (0..uses.len()).filter(|i| uses[*i] == 0) {
            let row = elimination.eliminate(graph, coordinate)?;
            multipliers.record(&row);
            steps.push(Step::Eliminate(row));
        }
        for (i, link, joint) in equations.inward() {
            elimination.add_inertia(graph, i, &link.inertia);
            let moved = (i, equations.mechanism.moved.get(i).unwrap_or(&nothing));
            multipliers.eliminate_determined(graph, &mut elimination, moved, &mut steps);
            let inertia = &mut inertias[i];
            inertia.turning = elimination.rows_of(i);
            let mut passage = Passage {
                elimination: &mut elimination,
                multipliers: &mut multipliers,
                steps: &mut steps,
                uses: &mut uses,
            };
            passage.split_off(graph, i, &joint.turning)?;
            passage.elimination.turn(graph, i, &link.turn);
            passage.steps.push(Step::Turn(i, link.turn));
            inertia.sliding = passage.elimination.rows_of(i);
            passage.split_off(graph, i, &joint.sliding)?;
            inertia.shift = linear(i).map(|unknown| passage.elimination.row(unknown));
            passage.elimination.shift(graph, i, link.place);
            passage.elimination.merge(graph, i, link.parent);
            let step = Step::Shift(i, link.parent, link.place);
            passage.steps.push(step);
        }
        multipliers.eliminate_rest(graph, &mut elimination, &mut steps)?;
        let divisors = divisors(graph, &steps, coordinates);
        if divisors.len() != coordinates + constraints.len() {
            return None;
        }
        let pivots = divisors.iter().map(|pivot| pivot.value);
        let mut pivots: Vec<_> = pivots.chain(multipliers.conditions).collect();
        pivots.retain(|pivot| graph.as_constant(*pivot).is_none_or(Rational::is_negative));
        Some(Self {
            equations,
            constraints: constraints.to_vec(),
            steps,
            inertias,
            pivots,
            divisors,
        })
    }

    /// Whether there are no constraints.
    pub(crate) const fn is_free(&self) -> bool {
        self.constraints.is_empty()
    }

    /// The accelerations, and the intermediate results of the recursion in its order: the wrenches of the links outwards, and
    /// inwards what is divided by each pivot.
    pub(crate) fn accelerations(&self, graph: &mut Graph) -> (Vec<Expression>, Vec<Expression>) {
        let wrenches = self.equations.wrenches(graph, false);
        let mut right = RightHandSide::of(&self.equations.forces);
        let coordinates = self.equations.forces.len();
        for (i, constraint) in (coordinates..).zip(&self.constraints) {
            right.0.insert(Unknown::Coordinate(i), constraint.rate);
        }
        let mut recursion = Vec::new();
        for (link, wrench) in wrenches.iter().enumerate() {
            for (unknown, value) in twist(link).zip(wrench.components()) {
                recursion.push(value);
                let value = graph.negate(value);
                right.0.insert(unknown, value);
            }
        }
        let quotients = self.eliminate(graph, right.clone());
        for step in &self.steps {
            if let Step::Eliminate(row) = step {
                recursion.push(row.reciprocal);
                recursion.extend(quotients.get(&row.coordinate));
            }
        }
        (self.refined(graph, &quotients, &right), recursion)
    }

    /// x in M x = r; with constraints, in the saddle point problem.
    pub(crate) fn solution(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        let right = RightHandSide::of(right);
        let quotients = self.eliminate(graph, right.clone());
        self.refined(graph, &quotients, &right)
    }

    /// The solution with these quotients, with constraints refined once by their residuals, for the reason that the
    /// [factors](crate::matrix::ldlt::Ldlt::solve) of a saddle point problem have.
    fn refined(
        &self,
        graph: &mut Graph,
        quotients: &BTreeMap<usize, Expression>,
        right: &RightHandSide,
    ) -> Vec<Expression> {
        let mut known = self.substitute(graph, quotients);
        let found = self.unknowns(graph, &known);
        if self.is_free() {
            return found;
        }
        for value in known.values.values_mut() {
            *value = graph.opaque(*value);
        }
        let mut residuals = RightHandSide::default();
        let coordinates = self.equations.forces.len();
        for (i, constraint) in (coordinates..).zip(&self.constraints) {
            let unknown = Unknown::Coordinate(i);
            let acceleration = constraint.acceleration(graph, &known);
            let residual = graph.add(right.get(graph, unknown), acceleration);
            residuals.0.insert(unknown, graph.opaque(residual));
        }
        let quotients = self.eliminate(graph, residuals);
        let corrections = self.substitute(graph, &quotients);
        let corrections = self.unknowns(graph, &corrections);
        sums(graph, &found, &corrections)
    }

    /// M q̈ − f with the accelerations as symbols.
    pub(crate) fn inverse_dynamics(&self, graph: &mut Graph) -> Vec<Expression> {
        self.equations.inverse_dynamics(graph)
    }

    /// What is left of the right-hand side at each coordinate, over its pivot.
    fn eliminate(
        &self,
        graph: &mut Graph,
        mut right: RightHandSide,
    ) -> BTreeMap<usize, Expression> {
        let mut quotients = BTreeMap::new();
        for step in &self.steps {
            match step {
                Step::SplitOff(slope) => right.split_off(graph, slope),
                Step::Eliminate(row) => {
                    quotients.insert(row.coordinate, right.eliminate(graph, row));
                }
                Step::Turn(link, turn) => right.turn(graph, *link, turn),
                Step::Shift(link, parent, place) => right.shift(graph, *link, *parent, *place),
            }
        }
        quotients
    }

    /// The accelerations, from the root to the leaves.
    fn substitute(
        &self,
        graph: &mut Graph,
        quotients: &BTreeMap<usize, Expression>,
    ) -> Accelerations {
        let mut known = Accelerations::default();
        for step in self.steps.iter().rev() {
            known.substitute(graph, step, quotients);
        }
        known
    }

    /// The accelerations of the coordinates, and the multipliers.
    fn unknowns(&self, graph: &Graph, known: &Accelerations) -> Vec<Expression> {
        let unknowns = (0..self.divisors.len()).map(Unknown::Coordinate);
        unknowns.map(|unknown| known.get(graph, unknown)).collect()
    }
}

/// How many joints each coordinate moves.
fn uses(joints: &[Joint], coordinates: usize) -> Vec<usize> {
    let mut uses = vec![0; coordinates];
    for joint in joints {
        for (coordinate, _) in joint.turning.iter().chain(&joint.sliding) {
            uses[*coordinate] += 1;
        }
    }
    uses
}

/// The pivots of the coordinates, and the opposites of the pivots of multipliers, which are behind so many coordinates.
fn divisors(graph: &mut Graph, steps: &[Step], coordinates: usize) -> Vec<Pivot> {
    let rows = steps.iter().filter_map(|step| match step {
        Step::Eliminate(row) => Some(row),
        _ => None,
    });
    rows.map(|row| Pivot {
        value: if row.coordinate < coordinates {
            row.pivot
        } else {
            graph.negate(row.pivot)
        },
        coordinates: vec![row.coordinate],
    })
    .collect()
}

/// The way past one joint.
struct Passage<'a> {
    elimination: &'a mut TwistElimination,
    multipliers: &'a mut MultiplierElimination,
    steps: &'a mut Vec<Step>,
    /// How many joints that have not been passed a coordinate moves.
    uses: &'a mut [usize],
}

impl Passage<'_> {
    /// Splits coordinates off, and eliminates those that move no other joint.
    fn split_off(
        &mut self,
        graph: &mut Graph,
        link: usize,
        slopes: &[(usize, Twist)],
    ) -> Option<()> {
        for (coordinate, slope) in slopes {
            let slope = Slope::of(graph, link, (*coordinate, *slope));
            self.elimination.split_off(graph, &slope);
            self.steps.push(Step::SplitOff(slope));
            self.uses[*coordinate] -= 1;
        }
        for (coordinate, _) in slopes {
            if self.uses[*coordinate] == 0 {
                let row = self.elimination.eliminate(graph, *coordinate)?;
                self.multipliers.record(&row);
                self.steps.push(Step::Eliminate(row));
            }
        }
        Some(())
    }
}
