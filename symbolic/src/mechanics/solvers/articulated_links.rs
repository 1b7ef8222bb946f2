//! Articulated-body elimination along the links of a mechanism (Vereshchagin 1974; Featherstone, The calculation of robot
//! dynamics using articulated-body inertias, 1983).
//!
//! The wrenches that the motion takes at q̈ = 0 come from [Newton and Euler](crate::mechanics::solvers::newton_euler), so
//! that nothing but accelerations is left to eliminate: from the last link on, its coordinate is split off and
//! eliminated, and what remains is turned into the axes of the link before and moved to its origin. A coordinate that
//! moves several joints is eliminated where the last of them has been passed. Back from the root to the leaves, the
//! accelerations are substituted.

use std::collections::BTreeMap;

use crate::mechanics::mechanism::{Turn, Vector, kept, total};
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::mechanics::solvers::newton_euler::Joint;
use crate::mechanics::solvers::pivots::Pivot;
use crate::mechanics::solvers::twist_elimination::{
    EliminatedRow, TwistElimination, Unknown, angular, linear,
};
use crate::{Expression, Graph, Rational};

/// One step of the factorization.
enum Step {
    /// x := x + e q̈ of three unknowns.
    SplitOff([Unknown; 3], usize, Vector),
    Eliminate(EliminatedRow),
    Turn(usize, Turn),
    /// From a link to the link before, from whose origin this one's is at a place.
    Shift(usize, Option<usize>, Vector),
}

/// The factored equations of a mechanism.
pub(crate) struct ArticulatedLinks {
    equations: LinkEquations,
    steps: Vec<Step>,
    /// The expressions that must be positive.
    pub(crate) pivots: Vec<Expression>,
}

impl ArticulatedLinks {
    /// Factors the equations, unless a pivot vanishes.
    pub(crate) fn factor(graph: &mut Graph, equations: LinkEquations) -> Option<Self> {
        let mut uses = vec![0_usize; equations.forces.len()];
        let all = |joint: &Joint| {
            let all = joint.turning.iter().chain(&joint.sliding);
            all.map(|(i, _)| *i).collect::<Vec<_>>()
        };
        for coordinate in equations.joints.iter().flat_map(all) {
            uses[coordinate] += 1;
        }
        let mut elimination = TwistElimination::of_coordinates(graph, &equations.other_mass);
        let mut steps = Vec::new();
        // What moves no link.
        for coordinate in (0..uses.len()).filter(|i| uses[*i] == 0) {
            steps.push(Step::Eliminate(elimination.eliminate(graph, coordinate)?));
        }
        let links = equations.mechanism.links.iter().zip(&equations.joints);
        for (i, (link, joint)) in links.enumerate().rev() {
            elimination.add_inertia(graph, i, &link.inertia);
            let mut passage = Passage {
                elimination: &mut elimination,
                steps: &mut steps,
                uses: &mut uses,
            };
            passage.split_off(graph, angular(i), &joint.turning)?;
            passage.elimination.turn(graph, i, &link.turn);
            passage.steps.push(Step::Turn(i, link.turn));
            passage.split_off(graph, linear(i), &joint.sliding)?;
            passage.elimination.shift(graph, i, link.place);
            passage.elimination.merge(graph, i, link.parent);
            let step = Step::Shift(i, link.parent, link.place);
            passage.steps.push(step);
        }
        let pivots = steps.iter().filter_map(|step| match step {
            Step::Eliminate(row) => Some(row.pivot),
            _ => None,
        });
        let mut pivots: Vec<_> = pivots.collect();
        if pivots.len() != equations.forces.len() {
            return None;
        }
        pivots.retain(|pivot| graph.as_constant(*pivot).is_none_or(Rational::is_negative));
        Some(Self {
            equations,
            steps,
            pivots,
        })
    }

    /// What q̈ is divided by: the pivot of each coordinate.
    pub(crate) fn divisors(&self) -> Vec<Pivot> {
        let pivots = self.steps.iter().filter_map(|step| match step {
            Step::Eliminate(row) => Some(Pivot {
                value: row.pivot,
                coordinates: vec![row.coordinate],
            }),
            _ => None,
        });
        pivots.collect()
    }

    /// The accelerations.
    pub(crate) fn accelerations(&self, graph: &mut Graph) -> Vec<Expression> {
        let wrenches = self.equations.wrenches(graph, false);
        let mut right = RightHandSide::of(&self.equations.forces);
        for (link, wrench) in wrenches.iter().enumerate() {
            let moments = angular(link).into_iter().zip(wrench.moment);
            let forces = linear(link).into_iter().zip(wrench.force);
            for (unknown, value) in moments.chain(forces) {
                let value = graph.negate(value);
                right.0.insert(unknown, value);
            }
        }
        self.solve(graph, right)
    }

    /// x in M x = r.
    pub(crate) fn solution(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        self.solve(graph, RightHandSide::of(right))
    }

    /// M q̈ − f with the accelerations as symbols.
    pub(crate) fn inverse_dynamics(&self, graph: &mut Graph) -> Vec<Expression> {
        self.equations.inverse_dynamics(graph)
    }

    fn solve(&self, graph: &mut Graph, mut right: RightHandSide) -> Vec<Expression> {
        let mut quotients = BTreeMap::new();
        for step in &self.steps {
            match step {
                Step::SplitOff(unknowns, coordinate, slope) => {
                    right.split_off(graph, *unknowns, *coordinate, *slope);
                }
                Step::Eliminate(row) => {
                    quotients.insert(row.coordinate, right.eliminate(graph, row));
                }
                Step::Turn(link, turn) => right.turn(graph, *link, turn),
                Step::Shift(link, parent, place) => right.shift(graph, *link, *parent, *place),
            }
        }
        let zero = graph.zero();
        let mut known = Accelerations {
            values: BTreeMap::new(),
        };
        for step in self.steps.iter().rev() {
            known.substitute(graph, step, &quotients);
        }
        let coordinates = 0..self.equations.forces.len();
        let values = coordinates.map(|i| known.values.get(&Unknown::Coordinate(i)).copied());
        values.map(|value| value.unwrap_or(zero)).collect()
    }
}

/// The way past one joint.
struct Passage<'a> {
    elimination: &'a mut TwistElimination,
    steps: &'a mut Vec<Step>,
    /// How many joints that have not been passed a coordinate moves.
    uses: &'a mut [usize],
}

impl Passage<'_> {
    /// Splits coordinates off, and eliminates those that move no other joint.
    fn split_off(
        &mut self,
        graph: &mut Graph,
        unknowns: [Unknown; 3],
        slopes: &[(usize, Vector)],
    ) -> Option<()> {
        for (coordinate, slope) in slopes {
            self.elimination
                .split_off(graph, unknowns, *coordinate, *slope);
            self.steps
                .push(Step::SplitOff(unknowns, *coordinate, *slope));
            self.uses[*coordinate] -= 1;
        }
        for (coordinate, _) in slopes {
            if self.uses[*coordinate] == 0 {
                let row = self.elimination.eliminate(graph, *coordinate)?;
                self.steps.push(Step::Eliminate(row));
            }
        }
        Some(())
    }
}

/// The right-hand side h of ½ xᵀ H x − hᵀ x.
struct RightHandSide(BTreeMap<Unknown, Expression>);

impl RightHandSide {
    fn of(forces: &[Expression]) -> Self {
        let forces = forces.iter().enumerate();
        Self(forces.map(|(i, x)| (Unknown::Coordinate(i), *x)).collect())
    }

    fn get(&self, graph: &Graph, unknown: Unknown) -> Expression {
        self.0.get(&unknown).copied().unwrap_or(graph.zero())
    }

    fn vector(&self, graph: &Graph, unknowns: [Unknown; 3]) -> Vector {
        unknowns.map(|u| self.get(graph, u))
    }

    fn set(&mut self, unknowns: [Unknown; 3], values: Vector) {
        self.0.extend(unknowns.into_iter().zip(values));
    }

    fn split_off(
        &mut self,
        graph: &mut Graph,
        unknowns: [Unknown; 3],
        coordinate: usize,
        slope: Vector,
    ) {
        let own = Unknown::Coordinate(coordinate);
        let pairs = slope.into_iter().zip(self.vector(graph, unknowns));
        let change = graph.sum_of_products(pairs);
        let sum = graph.add(self.get(graph, own), change);
        self.0.insert(own, sum);
    }

    /// The right-hand side over the pivot.
    fn eliminate(&mut self, graph: &mut Graph, row: &EliminatedRow) -> Expression {
        let own = self.get(graph, Unknown::Coordinate(row.coordinate));
        let force = kept(graph, own);
        let quotient = graph.multiply(force, row.reciprocal);
        let quotient = kept(graph, quotient);
        for (v, entry, _) in &row.others {
            let change = if *entry == row.pivot {
                own
            } else {
                graph.multiply(*entry, quotient)
            };
            let change = graph.subtract(self.get(graph, *v), change);
            let change = kept(graph, change);
            self.0.insert(*v, change);
        }
        quotient
    }

    fn turn(&mut self, graph: &mut Graph, link: usize, turn: &Turn) {
        for unknowns in [angular(link), linear(link)] {
            let vector = self.vector(graph, unknowns);
            let vector = turn.outward(graph, vector);
            self.set(unknowns, vector);
        }
    }

    fn shift(&mut self, graph: &mut Graph, link: usize, parent: Option<usize>, place: Vector) {
        let Some(parent) = parent else {
            return;
        };
        let force = self.vector(graph, linear(link));
        let moment = self.vector(graph, angular(link));
        let lever = graph.cross(place, force);
        let before = self.vector(graph, angular(parent));
        let sum = [0, 1, 2].map(|i| total(graph, &[before[i], moment[i], lever[i]]));
        self.set(angular(parent), sum);
        let before = self.vector(graph, linear(parent));
        let sum = [0, 1, 2].map(|i| total(graph, &[before[i], force[i]]));
        self.set(linear(parent), sum);
    }
}

/// The accelerations found so far.
struct Accelerations {
    values: BTreeMap<Unknown, Expression>,
}

impl Accelerations {
    fn vector(&self, graph: &Graph, unknowns: [Unknown; 3]) -> Vector {
        let value = |u: Unknown| self.values.get(&u).copied();
        unknowns.map(|u| value(u).unwrap_or(graph.zero()))
    }

    fn set(&mut self, unknowns: [Unknown; 3], values: Vector) {
        self.values.extend(unknowns.into_iter().zip(values));
    }

    /// Undoes a step with the values that are known then.
    fn substitute(
        &mut self,
        graph: &mut Graph,
        step: &Step,
        quotients: &BTreeMap<usize, Expression>,
    ) {
        match step {
            Step::Shift(link, parent, place) => {
                let Some(parent) = parent else {
                    return;
                };
                let turning = self.vector(graph, angular(*parent));
                let before = self.vector(graph, linear(*parent));
                let lever = graph.cross(turning, *place);
                let moved = [0, 1, 2].map(|i| total(graph, &[before[i], lever[i]]));
                self.set(angular(*link), turning);
                self.set(linear(*link), moved);
            }
            Step::Turn(link, turn) => {
                for unknowns in [angular(*link), linear(*link)] {
                    let vector = self.vector(graph, unknowns);
                    let vector = turn.inward(graph, vector);
                    self.set(unknowns, vector);
                }
            }
            Step::Eliminate(row) => self.eliminate(graph, row, quotients),
            Step::SplitOff(unknowns, coordinate, slope) => {
                let rate = self.values.get(&Unknown::Coordinate(*coordinate)).copied();
                let rate = rate.unwrap_or(graph.zero());
                let vector = self.vector(graph, *unknowns);
                let changed = [0, 1, 2].map(|i| {
                    let change = graph.multiply(slope[i], rate);
                    let sum = graph.add(vector[i], change);
                    kept(graph, sum)
                });
                self.set(*unknowns, changed);
            }
        }
    }

    /// q̈ = h/D − Σ entries/D · x, with what has the coefficient 1 subtracted last: the sum before it is the total
    /// acceleration about the axis.
    fn eliminate(
        &mut self,
        graph: &mut Graph,
        row: &EliminatedRow,
        quotients: &BTreeMap<usize, Expression>,
    ) {
        let zero = graph.zero();
        let value = |u: &Unknown| self.values.get(u).copied().unwrap_or(zero);
        let quotient = quotients.get(&row.coordinate).copied().unwrap_or(zero);
        let mut terms = vec![(quotient, Rational::ONE)];
        let mut units = Vec::new();
        for (u, entry, ratio) in &row.others {
            if *entry == row.pivot {
                units.push((value(u), Rational::MINUS_ONE));
            } else {
                let product = graph.multiply(*ratio, value(u));
                terms.push((product, Rational::MINUS_ONE));
            }
        }
        let sum = graph.sum(terms);
        units.push((kept(graph, sum), Rational::ONE));
        let acceleration = graph.sum(units);
        self.values
            .insert(Unknown::Coordinate(row.coordinate), acceleration);
    }
}
