//! The way from the leaves to the root in the [derivatives of q̈ along the links](super::articulated_derivatives): the forces that
//! perturbations take, and the response of what is behind a link to its motion.

use std::collections::BTreeSet;

use crate::mechanics::mechanism::{Vector, difference, total};
use crate::mechanics::solvers::articulated_coriolis::ArticulatedCoriolis;
use crate::mechanics::solvers::articulated_links::ArticulatedLinks;
use crate::mechanics::solvers::coriolis_matrix::CoriolisMatrix;
use crate::mechanics::solvers::joint_perturbations::{JointPerturbations, symbols};
use crate::mechanics::solvers::link_vectors::{Accelerations, RightHandSide};
use crate::mechanics::solvers::newton_euler::JointPart;
use crate::mechanics::solvers::spatial_vectors::Wrench;
use crate::mechanics::solvers::twist_elimination::{Step, Unknown, linear, twist};
use crate::{Graph, Symbol};

/// The negative acceleration of an eliminated coordinate, by the acceleration of a link before it.
#[derive(Clone)]
pub(super) struct Row {
    pub(super) coordinate: usize,
    /// The coefficients of unknowns.
    pub(super) forces: RightHandSide,
    /// The coefficients of 2 δω.
    pub(super) of_turning: Vector,
}

/// What a coordinate or a velocity perturbs at a joint.
pub(super) struct Column {
    pub(super) symbol: Symbol,
    /// The change of the acceleration of the link.
    pub(super) perturbation: Accelerations,
    /// 2 δω.
    pub(super) turning: Vector,
    /// The forces that it takes.
    pub(super) forces: RightHandSide,
}

/// What meets at one part of a joint.
#[derive(Default)]
pub(super) struct Meeting {
    pub(super) rows: Vec<Row>,
    pub(super) columns: Vec<Column>,
}

/// The meetings at the turning and the sliding part of a joint, and the rows that pass it.
#[derive(Default)]
pub(super) struct PassedJoint {
    pub(super) turning: Meeting,
    pub(super) sliding: Meeting,
    pub(super) passed: Vec<Row>,
}

/// The steps past one joint.
pub(super) struct JointSteps<'a> {
    pub(super) turning: &'a [Step],
    pub(super) turn: &'a Step,
    pub(super) sliding: &'a [Step],
    pub(super) shift: &'a Step,
}

/// The steps of each joint.
pub(super) fn steps_of_joints(solver: &ArticulatedLinks) -> Option<Vec<JointSteps<'_>>> {
    let mut joints = Vec::with_capacity(solver.inertias.len());
    let is_shift = |step: &Step| matches!(step, Step::Shift(..));
    for steps in solver.steps.split_inclusive(is_shift) {
        let turn = steps
            .iter()
            .position(|step| matches!(step, Step::Turn(..)))?;
        let (shift, sliding) = steps[turn + 1..].split_last()?;
        joints.push(JointSteps {
            turning: &steps[..turn],
            turn: &steps[turn],
            sliding,
            shift,
        });
    }
    joints.reverse();
    (joints.len() == solver.inertias.len()).then_some(joints)
}

impl JointSteps<'_> {
    fn steps(&self) -> impl Iterator<Item = &Step> {
        self.turning.iter().chain(self.sliding)
    }
}

/// For each link, the coordinates that move joints behind it or of its own and are eliminated before it; none unless each is
/// eliminated at a link on the way to the root.
pub(super) fn coordinates_before(
    solver: &ArticulatedLinks,
    steps: &[JointSteps<'_>],
) -> Option<Vec<BTreeSet<usize>>> {
    let mut needed = vec![BTreeSet::new(); steps.len()];
    for (i, joint) in steps.iter().enumerate().rev() {
        let mut before = core::mem::take(&mut needed[i]);
        let mut eliminated = Vec::new();
        for step in joint.steps() {
            match step {
                Step::SplitOff(slope) => {
                    before.insert(slope.coordinate);
                }
                Step::Eliminate(row) => {
                    for (unknown, ..) in &row.others {
                        match unknown {
                            Unknown::Coordinate(other) => {
                                before.insert(*other);
                            }
                            Unknown::Twist(link, _) if *link != i => return None,
                            Unknown::Twist(..) => {}
                        }
                    }
                    eliminated.push(row.coordinate);
                }
                Step::Turn(..) | Step::Shift(..) => {}
            }
        }
        for coordinate in eliminated {
            if !before.remove(&coordinate) {
                return None;
            }
        }
        match solver.equations.mechanism.links[i].parent {
            Some(parent) => needed[parent].extend(before.iter().copied()),
            None if !before.is_empty() => return None,
            None => {}
        }
        needed[i] = before;
    }
    Some(needed)
}

/// The way from the leaves to the root.
pub(super) struct Forces<'a> {
    solver: &'a ArticulatedLinks,
    perturbations: JointPerturbations<'a>,
    /// Whether columns are asked for.
    with_columns: bool,
    coriolis: Vec<ArticulatedCoriolis>,
    /// The wrenches on all that is behind each joint.
    wrenches: Vec<Wrench>,
    /// The rows that have come to each link.
    rows: Vec<Vec<Row>>,
}

impl<'a> Forces<'a> {
    pub(super) fn new(graph: &mut Graph, solver: &'a ArticulatedLinks, with_columns: bool) -> Self {
        let equations = &solver.equations;
        let perturbations = JointPerturbations::new(graph, equations);
        let mut coriolis = Vec::with_capacity(solver.inertias.len());
        let links = equations.mechanism.links.iter();
        for (i, (link, motion)) in links.zip(&perturbations.motions).enumerate() {
            let own = CoriolisMatrix::of(graph, &link.inertia, motion.angular_velocity);
            let mut articulated = ArticulatedCoriolis::default();
            articulated.add_link(graph, i, &own);
            coriolis.push(articulated);
        }
        Self {
            wrenches: equations.wrenches(graph, true),
            rows: vec![Vec::new(); solver.inertias.len()],
            coriolis,
            perturbations,
            with_columns,
            solver,
        }
    }

    /// What meets at each joint.
    pub(super) fn joints(
        mut self,
        graph: &mut Graph,
        steps: &[JointSteps<'_>],
    ) -> Vec<PassedJoint> {
        let mut joints = Vec::with_capacity(steps.len());
        for (i, joint) in steps.iter().enumerate().rev() {
            joints.push(self.pass(graph, i, joint));
        }
        joints.reverse();
        joints
    }

    fn pass(&mut self, graph: &mut Graph, index: usize, steps: &JointSteps<'_>) -> PassedJoint {
        let link = &self.solver.equations.mechanism.links[index];
        let mut rows = core::mem::take(&mut self.rows[index]);
        let mut coriolis = core::mem::take(&mut self.coriolis[index]);
        let wrench = self.wrenches[index];
        let turning = Meeting {
            rows: rows.clone(),
            columns: self.columns(graph, index, JointPart::Turning, &coriolis, &wrench),
        };
        Self::eliminate(graph, steps.turning, &mut rows, &mut coriolis);
        coriolis.turn(graph, index, &link.turn);
        for row in &mut rows {
            row.forces.turn(graph, index, &link.turn);
            row.of_turning = link.turn.outward(graph, row.of_turning);
        }
        let wrench = wrench.turned(graph, &link.turn);
        let sliding = Meeting {
            rows: rows.clone(),
            columns: self.columns(graph, index, JointPart::Sliding, &coriolis, &wrench),
        };
        Self::eliminate(graph, steps.sliding, &mut rows, &mut coriolis);
        let Some(parent) = link.parent else {
            return PassedJoint {
                turning,
                sliding,
                passed: Vec::new(),
            };
        };
        let speed = self.perturbations.speed(graph, index);
        for row in &mut rows {
            row.shift(graph, [index, parent], link.place, speed);
        }
        let masses = &self.solver.inertias[index].shift;
        coriolis.shift(graph, index, link.place, speed, masses);
        self.coriolis[parent].add(graph, &coriolis, [index, parent]);
        let wrench = wrench.moved(graph, link.place);
        self.wrenches[parent] = self.wrenches[parent].plus(graph, wrench);
        self.rows[parent].extend(rows.iter().cloned());
        PassedJoint {
            turning,
            sliding,
            passed: rows,
        }
    }

    /// Passes a part of a joint.
    fn eliminate(
        graph: &mut Graph,
        steps: &[Step],
        rows: &mut Vec<Row>,
        coriolis: &mut ArticulatedCoriolis,
    ) {
        for step in steps {
            match step {
                Step::SplitOff(slope) => {
                    coriolis.split_off(graph, slope);
                    for row in rows.iter_mut() {
                        row.forces.split_off(graph, slope);
                    }
                }
                Step::Eliminate(eliminated) => {
                    let of_turning = coriolis.eliminate(graph, eliminated);
                    for row in rows.iter_mut() {
                        let own = row.forces.give_way(graph, eliminated);
                        row.of_turning = [0, 1, 2].map(|i| {
                            let change = graph.multiply(own, of_turning[i]);
                            difference(graph, row.of_turning[i], change)
                        });
                    }
                    let ratios = eliminated.others.iter().map(|(u, _, ratio)| (*u, *ratio));
                    rows.push(Row {
                        coordinate: eliminated.coordinate,
                        forces: RightHandSide(ratios.collect()),
                        of_turning,
                    });
                }
                Step::Turn(..) | Step::Shift(..) => {}
            }
        }
    }

    /// The columns of a part of a joint, which carries a body with this wrench.
    fn columns(
        &self,
        graph: &mut Graph,
        index: usize,
        part: JointPart,
        coriolis: &ArticulatedCoriolis,
        wrench: &Wrench,
    ) -> Vec<Column> {
        if !self.with_columns {
            return Vec::new();
        }
        let slopes = self.solver.equations.joints[index].slopes(part);
        let inertia = self.solver.inertias[index].before(part);
        let mut columns = Vec::new();
        for slope in slopes {
            let changes = self.perturbations.at(graph, index, part, *slope);
            for (symbol, change) in symbols(slope.0).into_iter().zip(changes) {
                let perturbation = Accelerations {
                    values: twist(index).zip(change.acceleration.components()).collect(),
                };
                let mut forces = RightHandSide(coriolis.forces(graph, change.turning));
                forces.add_products(graph, inertia, &perturbation);
                if matches!(symbol, Symbol::Coordinate(_)) {
                    // What the joint carries along with it; the coordinates of the joint have no part in it.
                    let carried = slope.1.rate_of(graph, wrench);
                    forces.add_wrench(graph, index, &carried);
                    for (other, direction) in slopes {
                        let carried = direction.power(graph, &carried);
                        let changed = direction.derivative(graph, symbol);
                        let changed = changed.power(graph, wrench);
                        let difference = graph.subtract(changed, carried);
                        forces.add(graph, Unknown::Coordinate(*other), difference);
                    }
                }
                forces.keep(graph);
                columns.push(Column {
                    symbol,
                    perturbation,
                    turning: change.turning,
                    forces,
                });
            }
        }
        columns
    }
}

impl Row {
    /// About the origin of the link before, relative to which the origin has the velocity `speed`.
    fn shift(
        &mut self,
        graph: &mut Graph,
        [link, parent]: [usize; 2],
        place: Vector,
        speed: Vector,
    ) {
        let force = self.forces.vector(graph, linear(link));
        let change = graph.cross(speed, force);
        let before = self.of_turning;
        self.of_turning = [0, 1, 2].map(|i| total(graph, &[before[i], change[i]]));
        self.forces.shift(graph, link, Some(parent), place);
        for unknown in twist(link) {
            self.forces.0.remove(&unknown);
        }
    }
}
