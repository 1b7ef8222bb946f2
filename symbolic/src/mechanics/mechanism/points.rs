//! Links and points of a mechanism, along the frames that are turned one after the other.

use std::collections::BTreeMap;

use crate::Expression;
use crate::frames::factor::MatrixFactor;
use crate::frames::frame_tree::Frame;
use crate::mechanics::mechanism::reading::{Point, Reader};
use crate::mechanics::mechanism::{Inertia, Link, Turn, Vector};

/// A sum of vectors along the axes of frames.
pub(super) type Places = BTreeMap<Frame, Vector>;

impl Reader {
    /// A link with the axes of a frame.
    pub(super) fn link_of(&mut self, frame: Frame) -> Option<usize> {
        let path = self.geometry.frames.path(frame);
        let known = path.iter().rev().find_map(|(frame, _)| {
            let link = self.frames.iter().position(|known| known == frame)?;
            Some((link, *frame))
        });
        let (mut link, here) =
            known.map_or((None, Frame::INERTIAL), |(link, here)| (Some(link), here));
        let mut place = [self.geometry.graph.zero(); 3];
        self.walk(&mut link, (here, frame), &mut place)?;
        link
    }

    /// The point at Σ Rᵢ vᵢ: from the origin of each frame to that of the next, in the order in which they were declared.
    ///
    /// New links are made for the frames on the way, and for a place that varies in the last.
    pub(super) fn point(&mut self, terms: &[(Frame, Vector)]) -> Option<Point> {
        let zero = self.geometry.graph.zero();
        let mut places = Places::new();
        for term in terms {
            let (frame, place) = self.carried(*term);
            self.add_place(&mut places, frame, place);
        }
        let place = places.remove(&Frame::INERTIAL).unwrap_or([zero; 3]);
        let mut place = place.map(|x| self.moving_part(x));
        let (mut link, mut last) = (None, Frame::INERTIAL);
        for (frame, own) in places {
            self.walk(&mut link, (last, frame), &mut place)?;
            last = frame;
            place = [0, 1, 2].map(|i| self.geometry.graph.add(place[i], own[i]));
        }
        if self.varies(place) {
            link = Some(self.link(link, last, place, Turn::Identity));
            place = [zero; 3];
        }
        Some((link, place))
    }

    pub(super) fn add_place(&mut self, places: &mut Places, frame: Frame, place: Vector) {
        let zero = self.geometry.graph.zero();
        let sum = places.entry(frame).or_insert([zero; 3]);
        *sum = [0, 1, 2].map(|i| self.geometry.graph.add(sum[i], place[i]));
    }

    /// A place along inertial axes without its constant terms, which no velocity shows.
    pub(super) fn moving_part(&mut self, place: Expression) -> Expression {
        let mut terms = self.geometry.graph.terms(place);
        terms.retain(|(x, _)| self.geometry.graph.contents(*x).varies());
        self.geometry.graph.sum(terms)
    }

    /// Goes from a link with the axes of the first frame to one with those of the second, at this place.
    fn walk(
        &mut self,
        link: &mut Option<usize>,
        (here, there): (Frame, Frame),
        place: &mut Vector,
    ) -> Option<()> {
        for (frame, factor) in self.steps(here, there) {
            // What is constant in the inertial frame moves nothing.
            if link.is_none() && !self.varies(*place) {
                *place = [self.geometry.graph.zero(); 3];
            }
            *link = Some(self.next_link(*link, frame, factor, place)?);
        }
        Some(())
    }

    /// The frames on the way from one to another, each with its turn against the one before: back to the last that both
    /// have in common, and forth. Turns about one axis there and back are one, as of angles against the horizontal.
    fn steps(&mut self, here: Frame, there: Frame) -> Vec<(Frame, MatrixFactor)> {
        let (from, to) = (
            self.geometry.frames.path(here),
            self.geometry.frames.path(there),
        );
        let pairs = from.iter().zip(&to);
        let common = pairs.take_while(|(x, y)| x == y).count();
        if common == from.len() {
            return to[common..].to_vec();
        }
        let back = from[common..].iter().rev();
        let back = back.map(|(_, factor)| factor.transpose());
        let forth = to[common..].iter().map(|(_, factor)| *factor);
        let factors = self.geometry.combined(back.chain(forth));
        let mut path = self.geometry.frames.factors(here);
        let mut steps = Vec::with_capacity(factors.len());
        for factor in factors {
            path.push(factor);
            steps.push((self.geometry.frames.frame(&path), factor));
        }
        if let Some((frame, _)) = steps.last_mut() {
            *frame = there;
        }
        steps
    }

    /// The place along the axes of a frame that is turned against its own, if it is constant there: l (cos q, sin q, 0) is
    /// l (1, 0, 0) of the link that is turned by q.
    pub(super) fn carried(&mut self, (frame, place): (Frame, Vector)) -> (Frame, Vector) {
        if !self.varies(place) {
            return (frame, place);
        }
        for (next, factor) in self.geometry.frames.behind(frame) {
            let turned = factor.transpose().apply(&mut self.geometry.graph, place);
            let turned = turned.map(|x| self.geometry.graph.reduced(x));
            if !self.varies(turned) {
                return (next, turned);
            }
        }
        (frame, place)
    }

    pub(super) fn varies(&self, place: Vector) -> bool {
        place
            .iter()
            .any(|x| self.geometry.graph.contents(*x).varies())
    }

    /// The link that is turned as `frame` is, with its origin at `place` in the link before; afterwards, `place` is that
    /// of the same point in the new link.
    fn next_link(
        &mut self,
        before: Option<usize>,
        frame: Frame,
        factor: MatrixFactor,
        place: &mut Vector,
    ) -> Option<usize> {
        let turn = Turn::of(factor)?;
        let zero = self.geometry.graph.zero();
        let mut origin = *place;
        *place = [zero; 3];
        if !self.keeps_origins
            && let Some(axis) = turn.axis()
            && !self.geometry.graph.contents(origin[axis]).varies()
        {
            place[axis] = core::mem::replace(&mut origin[axis], zero);
        }
        Some(self.link(before, frame, origin, turn))
    }

    /// The link with this origin and these axes.
    fn link(&mut self, parent: Option<usize>, frame: Frame, place: Vector, turn: Turn) -> usize {
        let known = self
            .links
            .iter()
            .position(|link| (link.parent, link.place, link.turn) == (parent, place, turn));
        known.unwrap_or_else(|| {
            self.links.push(Link {
                parent,
                place,
                turn,
                inertia: Inertia::none(&self.geometry.graph),
            });
            self.frames.push(frame);
            self.links.len() - 1
        })
    }
}
