//! Constraints of a mechanism by the velocities of its links.
//!
//! A constraint w = G q̇ + a is a sum of components of velocities: of points, of vectors that are fixed to a link, and of angular
//! velocities. The velocity of a point is Σ d(Rᵢ vᵢ)/dt along the frames from the root to its link. The part of the sum that is
//! the origin of a link belongs to that link, so that one constraint concerns few links, however many there are before them.

use std::collections::BTreeMap;

use crate::frames::factor::MatrixFactor;
use crate::frames::frame_tree::Frame;
use crate::frames::vector_in_frames::{Term, VectorId};
use crate::mechanics::mechanism::points::Places;
use crate::mechanics::mechanism::reading::Reader;
use crate::mechanics::mechanism::{Link, Vector};
use crate::{Expression, Symbol};

/// A constraint as Σ n·v of velocities v that belong to links, and what is left of it.
#[derive(Clone, Debug)]
pub(crate) struct LinkedConstraint {
    pub(crate) velocities: Vec<LinkVelocity>,
    /// The part in the velocities of the coordinates themselves.
    pub(crate) rest: Expression,
}

/// A component n·v of a velocity.
#[derive(Clone, Debug)]
pub(crate) struct LinkVelocity {
    pub(crate) link: usize,
    pub(crate) kind: VelocityKind,
    /// n, along the axes of the link.
    pub(crate) direction: Vector,
    /// n along inertial axes, where it is constant.
    pub(crate) constant: Option<Vector>,
}

/// What has the velocity.
#[derive(Clone, Copy, Debug)]
pub(crate) enum VelocityKind {
    /// A point of the link, at this place from its origin.
    Point(Vector),
    /// A vector that is fixed to the link.
    Fixed(Vector),
    /// The axes of the link: an angular velocity.
    Axes,
}

/// The components of vectors, along inertial axes or the axes of a link.
#[derive(Clone, Copy)]
struct Direction {
    axes: Option<usize>,
    components: Vector,
    is_constant: bool,
}

impl Reader {
    /// A constraint by velocities of links, if all that it contains belongs to some.
    pub(super) fn linked_constraint(&mut self, w: Expression) -> Option<LinkedConstraint> {
        let zero = self.geometry.graph.zero();
        let mut coefficients: BTreeMap<VectorId, Vector> = BTreeMap::new();
        let mut removed = BTreeMap::new();
        for symbol in self.geometry.graph.symbols(&[w]) {
            if let Symbol::VelocityComponent(i) = symbol {
                let slope = self.geometry.graph.derivative(w, symbol);
                let slope = self.geometry.resolved(&[slope])[0];
                let (number, axis) = VectorId::of_component(i);
                coefficients.entry(number).or_insert([zero; 3])[axis] = slope;
                removed.insert(symbol, zero);
            }
        }
        let all: Vec<_> = coefficients.values().flatten().copied().collect();
        let is_linear = all
            .iter()
            .all(|x| !self.geometry.graph.contents(*x).has_velocity());
        if !is_linear {
            return None;
        }
        let rest = self.geometry.graph.substitute(&[w], &removed);
        let rest = self.geometry.resolved(&rest)[0];
        let mut constraint = LinkedConstraint {
            velocities: Vec::new(),
            rest,
        };
        for (number, components) in coefficients {
            self.add_velocity(number, components, &mut constraint)?;
        }
        Some(constraint)
    }

    /// Adds the product of a velocity with coefficients along its axes.
    fn add_velocity(
        &mut self,
        number: VectorId,
        coefficients: Vector,
        constraint: &mut LinkedConstraint,
    ) -> Option<()> {
        let vector = self.vectors.vector(number).clone();
        let is_inertial = vector.axes == Frame::INERTIAL;
        let direction = Direction {
            axes: if is_inertial {
                None
            } else {
                Some(self.frames.iter().position(|f| *f == vector.axes)?)
            },
            components: coefficients,
            is_constant: is_inertial && !self.varies(coefficients),
        };
        let mut places = Places::new();
        for term in vector.terms {
            match term {
                Term::Fixed(..) => return None,
                Term::AngularVelocity(frame, factor) => {
                    let link = self.frames.iter().position(|known| *known == frame)?;
                    let kind = VelocityKind::Axes;
                    let velocity = self.velocity(link, kind, direction, factor);
                    constraint.velocities.push(velocity);
                }
                Term::Rate(frame, place) => {
                    let (frame, place) = self.carried((frame, place));
                    self.add_place(&mut places, frame, place);
                }
            }
        }
        self.add_points(places, direction, constraint)
    }

    /// Adds the velocity of a sum of vectors: of points of links, as far as they add up to these, and of vectors that are fixed to
    /// links.
    fn add_points(
        &mut self,
        places: Places,
        direction: Direction,
        constraint: &mut LinkedConstraint,
    ) -> Option<()> {
        let mut places = self.moving(places);
        let one = self.geometry.graph.one();
        let minus = self.geometry.graph.negate(one);
        while let Some(frame) = self.deepest(&places) {
            let mut best: Option<(Places, usize, Expression, Vector)> = None;
            for link in 0..self.links.len() {
                if self.frames[link] != frame {
                    continue;
                }
                for sign in [one, minus] {
                    let Some((rest, place)) = self.without_point(&places, link, sign) else {
                        continue;
                    };
                    let fewest = best.as_ref().map_or(places.len(), |(rest, ..)| rest.len());
                    if rest.len() < fewest {
                        best = Some((rest, link, sign, place));
                    }
                }
            }
            if let Some((rest, link, sign, place)) = best {
                let kind = VelocityKind::Point(place);
                let velocity = self.velocity(link, kind, direction, sign);
                constraint.velocities.push(velocity);
                places = rest;
                continue;
            }
            let vector = places.remove(&frame)?;
            if frame == Frame::INERTIAL && direction.axes.is_none() {
                let coordinates = self.vectors.coordinates;
                let rates = self.geometry.graph.time_derivatives(&vector, coordinates);
                let pairs = direction.components.into_iter().zip(rates);
                let rate = self.geometry.graph.sum_of_products(pairs);
                constraint.rest = self.geometry.graph.add(constraint.rest, rate);
                continue;
            }
            let link = self.frames.iter().position(|known| *known == frame)?;
            if self.varies(vector) {
                return None;
            }
            let kind = VelocityKind::Fixed(vector);
            let velocity = self.velocity(link, kind, direction, one);
            constraint.velocities.push(velocity);
        }
        Some(())
    }

    /// What is left of a sum of vectors without the place of a point of a link, times a sign, and the place of this point: all
    /// that the sum has in the axes of the link.
    fn without_point(
        &mut self,
        places: &Places,
        link: usize,
        sign: Expression,
    ) -> Option<(Places, Vector)> {
        let zero = self.geometry.graph.zero();
        let mut rest = places.clone();
        for on_the_way in self.way(link) {
            let Link { parent, place, .. } = self.links[on_the_way];
            let frame = parent.map_or(Frame::INERTIAL, |parent| self.frames[parent]);
            let minus = self.geometry.graph.negate(sign);
            let place = place.map(|x| self.geometry.graph.multiply(minus, x));
            self.add_place(&mut rest, frame, place);
        }
        let mut rest = self.along_axes_before(rest);
        let frame = self.frames[link];
        let mut own = rest.remove(&frame).unwrap_or([zero; 3]);
        // What lies along the axis of the turn is known in the frame before, too.
        let mut here = frame;
        let mut axis = None;
        while let Some((before, factor)) = self.geometry.frames.before(here) {
            let Some(own_axis) = axis_of(&factor) else {
                break;
            };
            if axis.is_some_and(|axis| axis != own_axis) {
                break;
            }
            axis = Some(own_axis);
            if let Some(place) = rest.get_mut(&before)
                && !self.geometry.graph.contents(place[own_axis]).varies()
            {
                let along = core::mem::replace(&mut place[own_axis], zero);
                own[own_axis] = self.geometry.graph.add(own[own_axis], along);
            }
            here = before;
        }
        if self.varies(own) {
            return None;
        }
        let place = own.map(|x| self.geometry.graph.multiply(sign, x));
        Some((self.moving(rest), place))
    }

    /// A sum of vectors without zeros, and without what is constant along inertial axes, which no velocity shows.
    fn moving(&mut self, places: Places) -> Places {
        let mut places = self.along_axes_before(places);
        if let Some(place) = places.get_mut(&Frame::INERTIAL) {
            *place = place.map(|x| self.moving_part(x));
        }
        let zero = self.geometry.graph.zero();
        places.retain(|_, place| *place != [zero; 3]);
        places
    }

    /// A sum of vectors in which no constant component lies along the axis about which a frame is turned: it is counted among
    /// the vectors of the frame before.
    fn along_axes_before(&mut self, mut places: Places) -> Places {
        let zero = self.geometry.graph.zero();
        let mut frames: Vec<_> = places.keys().copied().collect();
        let depth = |frame: &Frame| self.geometry.frames.depth(*frame);
        frames.sort_by_key(|frame| core::cmp::Reverse((depth(frame), *frame)));
        for mut frame in frames {
            while let Some((before, factor)) = self.geometry.frames.before(frame)
                && let Some(axis) = axis_of(&factor)
                && let Some(place) = places.get_mut(&frame)
                && place[axis] != zero
                && !self.geometry.graph.contents(place[axis]).varies()
            {
                let mut along = [zero; 3];
                along[axis] = core::mem::replace(&mut place[axis], zero);
                self.add_place(&mut places, before, along);
                frame = before;
            }
        }
        places
    }

    /// The frame that is turned most.
    fn deepest(&self, places: &Places) -> Option<Frame> {
        let frames = places.keys().copied();
        frames.max_by_key(|frame| (self.geometry.frames.depth(*frame), *frame))
    }

    /// The links from the first to this one.
    fn way(&self, link: usize) -> Vec<usize> {
        let mut way: Vec<_> =
            core::iter::successors(Some(link), |i| self.links[*i].parent).collect();
        way.reverse();
        way
    }

    /// A multiple of the component of a velocity of a link.
    fn velocity(
        &mut self,
        link: usize,
        kind: VelocityKind,
        direction: Direction,
        factor: Expression,
    ) -> LinkVelocity {
        let graph = &mut self.geometry.graph;
        let inertial = direction.components.map(|x| graph.multiply(factor, x));
        let there = self.way(link);
        let back = direction.axes.map_or(Vec::new(), |axes| self.way(axes));
        let common = there.iter().zip(&back).take_while(|(x, y)| x == y).count();
        let mut along = inertial;
        for i in back[common..].iter().rev() {
            along = self.links[*i].turn.outward(&mut self.geometry.graph, along);
        }
        for i in &there[common..] {
            along = self.links[*i].turn.inward(&mut self.geometry.graph, along);
        }
        LinkVelocity {
            link,
            kind,
            direction: along,
            constant: direction.is_constant.then_some(inertial),
        }
    }
}

/// The coordinate axis about which a factor turns.
const fn axis_of(factor: &MatrixFactor) -> Option<usize> {
    match factor {
        MatrixFactor::Elementary(rotation) => Some(rotation.axis.cycle()[0]),
        MatrixFactor::Rotation(_) | MatrixFactor::General(_) => None,
    }
}
