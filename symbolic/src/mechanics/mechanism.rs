//! A mechanism: links that are turned and moved against each other, with what they carry (Featherstone, Rigid Body
//! Dynamics Algorithms, 2008, chapter 4).
//!
//! A link has axes and an origin. The origin is known by its place in the link before, and the axes by one rotation
//! against those of the link before. So the velocity of a link, its twist, is that of the link before, moved to the origin
//! and turned by one joint, plus the rate of this joint: no step knows more than one joint, however many there are.
//! A mechanism is [read](reading) off energies whose vectors are resolved last.

mod gravity;
mod inertia;
mod linked_constraint;
mod points;
mod reading;
mod turn;
mod turned_block;

pub(crate) use inertia::Inertia;
pub(crate) use linked_constraint::{LinkVelocity, LinkedConstraint, VelocityKind};
pub(crate) use turn::{Turn, cross, difference, inner, kept, slopes, total};

use crate::{Expression, Graph};

/// Three components.
pub(crate) type Vector = [Expression; 3];

/// A rigid link.
#[derive(Clone, Debug)]
pub(crate) struct Link {
    /// The link before; it stands earlier in the mechanism. None: the inertial frame.
    pub(crate) parent: Option<usize>,
    /// The place of the origin in the link before, along its axes.
    pub(crate) place: Vector,
    /// How the axes are turned against those of the link before.
    pub(crate) turn: Turn,
    /// What is fixed to the link.
    pub(crate) inertia: Inertia,
}

/// Links, parents before children, and what acts on them.
#[derive(Clone, Debug)]
pub(crate) struct Mechanism {
    pub(crate) links: Vec<Link>,
    /// The upward acceleration of the inertial frame that stands in for uniform gravity.
    pub(crate) base_acceleration: Vector,
    /// The part of T that no link has, such as that of rotors behind gears.
    pub(crate) other_kinetic: Expression,
    /// The part of V that is not the weight of links.
    pub(crate) other_potential: Expression,
    /// Of each link what has been [moved](Self::regrouped) to the link before.
    pub(crate) moved: Vec<Inertia>,
    /// The constraints as they are counted in the model; none if one of them contains what belongs to no link.
    pub(crate) constraints: Option<Vec<LinkedConstraint>>,
}

impl Mechanism {
    /// The same mechanism, in which what a link carries moves with the link before where that is the same motion: of a
    /// link that turns about an axis, all that lies on the axis; of one that is fixed to the link before, all. These are base inertial parameters (Gautier and
    /// Khalil, Direct calculation of minimum set of inertial parameters of serial robots, 1990).
    pub(crate) fn regrouped(mut self, graph: &mut Graph) -> Self {
        self.moved = vec![Inertia::none(graph); self.links.len()];
        for i in (0..self.links.len()).rev() {
            let link = &self.links[i];
            let is_fixed = link.place.iter().all(|x| !graph.contents(*x).varies());
            let (place, parent, turn) = (link.place, link.parent, link.turn);
            let inertia = &mut self.links[i].inertia;
            let mut moved = match turn.axis().filter(|_| is_fixed) {
                _ if is_fixed && turn.is_constant(graph) => {
                    core::mem::replace(inertia, Inertia::none(graph))
                }
                Some(axis) => inertia.take_axis(graph, axis),
                None => continue,
            };
            self.moved[i] = moved.clone();
            if turn.is_constant(graph) {
                moved = moved.turned(graph, &turn);
            }
            if let Some(parent) = parent {
                let moved = moved.moved(graph, place);
                self.links[parent].inertia.add(graph, &moved);
            }
        }
        for link in &mut self.links {
            link.inertia.keep(graph);
        }
        self
    }

    /// Lets wheels keep the axes of the link before them. A wheel is a last link that is symmetric about the axis about which it
    /// turns; its angle is then in no equation.
    pub(crate) fn with_spins(mut self, graph: &Graph) -> Self {
        for i in 0..self.links.len() {
            let mut others = self.links.iter();
            let link = &self.links[i];
            if let Turn::Elementary(rotation) = link.turn
                && others.all(|other| other.parent != Some(i))
                && link.inertia.is_symmetric_about(graph, rotation.axis)
            {
                self.links[i].turn = Turn::Spin(rotation);
            }
        }
        self
    }
}
