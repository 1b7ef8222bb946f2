//! Velocities that a declaration computes along a chain of links, as the outward recursion does (Luh, Walker and Paul,
//! On-line computational scheme for mechanical manipulators, 1980): ωᵢ = Aᵢᵀ ωᵢ₋₁ + sᵢ q̇ᵢ and vᵢ = Aᵢᵀ (vᵢ₋₁ + ωᵢ₋₁ × r)
//! along the axes of each link, or ωᵢ = ωᵢ₋₁ + Rᵢ₋₁ sᵢ q̇ᵢ and vᵢ = vᵢ₋₁ + ωᵢ₋₁ × R r along inertial ones.
//!
//! Such a sum is the angular velocity of a frame if it is the sum of the frame's own turns, and the product of an angular
//! velocity with a vector that is fixed to its frame is the rate of that vector. A sum of vectors that were turned back
//! only, and of which no position is known, is seen from the last of their frames: the first is then the one that turns
//! with what was declared for it. The components are the same, whatever the frames are called.

use crate::frames::axis::Axis;
use crate::frames::factor::{ElementaryRotation, MatrixFactor};
use crate::frames::frame_tree::Frame;
use crate::frames::matrix::{Matrix, Part};
use crate::frames::unresolved::along;
use crate::frames::vector_in_frames::{Term, VectorInFrames};
use crate::limits::MAX_TURNS_OF_A_BASE;
use crate::{Expression, Geometry, Graph, Rational, Symbol};

type Vector = [Expression; 3];

impl VectorInFrames {
    /// Whether its components are known only along axes that may be those of any frame: it is a sum of turned vectors
    /// with velocities.
    pub(crate) fn is_relative(&self, graph: &Graph) -> bool {
        self.axes == Frame::INERTIAL
            && self.terms.iter().any(|term| term.moves(graph))
            && self
                .terms
                .iter()
                .all(|term| matches!(term, Term::Fixed(..)))
    }
}

impl Geometry {
    /// ω × r, or r × ω, of an angular velocity and a vector of the frame that turns with it: the rate of r, less that along
    /// the axes of the frame.
    pub(crate) fn unresolved_cross_product(&mut self, x: &Matrix, y: &Matrix) -> Option<Matrix> {
        self.unresolved.as_ref()?;
        if x.shape() != (3, 1) {
            return None;
        }
        let moves = [x, y].map(|x| self.graph.has_velocity(x));
        let (rate, place, sign) = match moves {
            [true, false] => (x, y, Rational::ONE),
            [false, true] => (y, x, Rational::MINUS_ONE),
            _ => return None,
        };
        let [rate, place] = match self.along_common_axes(rate, place) {
            None if self
                .unresolved_of(rate)
                .or(self.unresolved_of(place))
                .is_none() =>
            {
                let frame = self.frame_that_turns(rate.components()?)?;
                [along(frame, rate)?, along(frame, place)?]
            }
            found => found?,
        };
        let factor = self.graph.constant(&sign);
        let mut terms = Vec::new();
        for term in place.terms {
            let Term::Fixed(frame, vector) = term else {
                return None;
            };
            if !self.turn_with(&rate.terms, frame) {
                return None;
            }
            let coordinates = self.unresolved.as_ref()?.coordinates;
            let own = self.time_derivatives(&vector, coordinates);
            let own = <[_; 3]>::try_from(own).ok()?.map(|x| self.graph.negate(x));
            for term in [Term::Rate(frame, vector), Term::Fixed(frame, own)] {
                let term = self.graph.scaled_term(&term, factor)?;
                self.graph.add_term(&mut terms, term);
            }
        }
        let axes = rate.axes;
        self.column_of(VectorInFrames { axes, terms })
    }

    /// A vector resolved along the axes of a frame: itself, or one that may be seen from any frame.
    pub(crate) fn seen_from(
        &mut self,
        vector: VectorInFrames,
        axes: Frame,
    ) -> Option<VectorInFrames> {
        if vector.axes == axes {
            return Some(vector);
        }
        if !vector.is_relative(&self.graph) {
            return None;
        }
        let base = self.frames.factors(axes);
        let terms = self.behind(&base, &vector.terms)?;
        Some(VectorInFrames { axes, terms })
    }

    /// The frame behind this one that turns with a sum of terms, or else this one.
    pub(crate) fn turned_with(&mut self, terms: &[Term], frame: Frame) -> Frame {
        if terms.iter().any(|term| matches!(term, Term::Rate(..))) || self.turn_with(terms, frame) {
            return frame;
        }
        let next = self.frames.behind(frame);
        let mut next = next.into_iter().map(|(next, _)| next);
        next.find(|next| self.turn_with(terms, *next))
            .unwrap_or(frame)
    }

    /// The same vector, with turned velocities put together: to the angular velocity of a frame, and to rates.
    pub(crate) fn with_known_velocities(&mut self, vector: VectorInFrames) -> VectorInFrames {
        let is_turned = |term: &Term| matches!(term, Term::Fixed(..)) && term.moves(&self.graph);
        if !vector.terms.iter().any(is_turned) {
            return vector;
        }
        if vector
            .terms
            .iter()
            .any(|term| matches!(term, Term::Rate(..)))
        {
            let axes = vector.axes;
            let terms = self.with_rates_of_places(vector.terms);
            return VectorInFrames { axes, terms };
        }
        let frame = if self.turn_with(&vector.terms, vector.axes) {
            Some(vector.axes)
        } else if vector.is_relative(&self.graph) {
            self.frame_seen_from(&vector.terms)
        } else {
            None
        };
        frame.map_or(vector, |axes| VectorInFrames {
            axes,
            terms: vec![Term::AngularVelocity(axes, self.graph.one())],
        })
    }

    /// A column that was written out along inertial axes, turned to those of a frame of which it is the angular velocity.
    pub(crate) fn turned_rate(
        &mut self,
        rotations: &[MatrixFactor],
        column: &Matrix,
    ) -> Option<Matrix> {
        if !self.graph.has_velocity(column) {
            return None;
        }
        let VectorInFrames { terms, .. } = along(Frame::INERTIAL, column)?;
        let back = rotations.iter().rev().map(MatrixFactor::transpose);
        let path = self.merged(back);
        let axes = self.frames.frame(&path);
        let turns = self.turn_with(&terms, axes);
        turns.then(|| self.column_of(VectorInFrames { axes, terms }))?
    }

    /// Terms of which those with velocities are the rate of a place along inertial axes, if they are.
    fn with_rates_of_places(&mut self, terms: Vec<Term>) -> Vec<Term> {
        let own = terms.iter().filter_map(|term| match term {
            Term::Fixed(frame, vector) if term.moves(&self.graph) => Some((*frame, *vector)),
            _ => None,
        });
        let own: Vec<_> = own.collect();
        let velocity = self.sum_of_parts(&own);
        let Some(place) = self.integral(velocity) else {
            return terms;
        };
        let is_other = |term: &Term| !matches!(term, Term::Fixed(..)) || !term.moves(&self.graph);
        let mut sum: Vec<_> = terms.into_iter().filter(is_other).collect();
        self.graph
            .add_term(&mut sum, Term::Rate(Frame::INERTIAL, place));
        sum
    }

    /// Whether a sum of terms is the angular velocity of a frame: what is left of both is zero along its axes.
    fn turn_with(&mut self, terms: &[Term], frame: Frame) -> bool {
        if frame == Frame::INERTIAL {
            return false;
        }
        let minus = self.graph.constant(&Rational::MINUS_ONE);
        let opposite = Term::AngularVelocity(frame, minus);
        let Some(difference) = self.turns(terms.iter().chain([&opposite])) else {
            return false;
        };
        let difference = self.resolve_in(frame, &difference);
        difference.iter().all(|x| self.graph.is_zero(*x)) || self.graph.vanishes(&difference)
    }

    /// A sum of turned vectors and of angular velocities as turned vectors alone: the angular velocity of a frame is the sum of
    /// the turns of all frames before it.
    fn turns<'t>(&mut self, terms: impl Iterator<Item = &'t Term>) -> Option<Vec<Part>> {
        let coordinates = self.unresolved.as_ref()?.coordinates;
        let mut turns = Vec::new();
        for term in terms {
            match *term {
                Term::Rate(..) => return None,
                Term::Fixed(frame, vector) => turns.push((frame, vector)),
                Term::AngularVelocity(frame, multiple) => {
                    for (frame, factor) in self.frames.path(frame) {
                        let rate = self.angular_velocity_of_product(&[factor], coordinates);
                        let rate = rate.ok()?.map(|x| self.graph.multiply(multiple, x));
                        turns.push((frame, rate));
                    }
                }
            }
        }
        Some(self.graph.added_by_frame(turns))
    }

    /// The frame with whose angular velocity a sum of turned vectors agrees, if it is seen from there.
    fn frame_seen_from(&mut self, terms: &[Term]) -> Option<Frame> {
        let frames = &self.frames;
        let paths = terms
            .iter()
            .map(|term| (frames.factors(term.frame()), term));
        let (path, first) = paths.max_by_key(|(path, _)| path.len())?;
        let Term::Fixed(_, rate) = *first else {
            return None;
        };
        let first = self.frame_that_turns(rate)?;
        let base = self.frames.factors(first);
        let back = path.iter().rev().map(MatrixFactor::transpose);
        let path = self.merged(base.into_iter().chain(back));
        let frame = self.frames.frame(&path);
        let terms = self.behind(&path, terms)?;
        self.turn_with(&terms, frame).then_some(frame)
    }

    /// The same terms seen from the frame with these factors.
    fn behind(&mut self, base: &[MatrixFactor], terms: &[Term]) -> Option<Vec<Term>> {
        let mut behind = Vec::with_capacity(terms.len());
        for term in terms {
            let Term::Fixed(frame, vector) = *term else {
                return None;
            };
            let factors = self.frames.factors(frame);
            let factors = self.merged(base.iter().copied().chain(factors));
            let frame = self.frames.frame(&factors);
            self.graph.add_term(&mut behind, Term::Fixed(frame, vector));
        }
        Some(behind)
    }

    /// A frame whose angular velocity along its own axes has these components: one that is known, or that is turned about a
    /// coordinate axis.
    fn frame_that_turns(&mut self, rate: Vector) -> Option<Frame> {
        let zero = self.graph.zero();
        if rate == [zero; 3] {
            return None;
        }
        let known = self.turning_frames().find(|(_, own)| *own == rate);
        if let Some((frame, _)) = known {
            return Some(frame);
        }
        let axis = Axis::ALL.into_iter().find(|axis| {
            let [_, j, k] = axis.cycle();
            rate[j] == zero && rate[k] == zero
        })?;
        let [k, ..] = axis.cycle();
        let angle = self.integral(rate)?[k];
        let rotation = MatrixFactor::Elementary(ElementaryRotation {
            axis,
            angle,
            reversed: false,
        });
        Some(self.frames.frame(&[rotation]))
    }

    /// The frames near the inertial one, each with its angular velocity along its own axes.
    pub(crate) fn turning_frames(&mut self) -> impl Iterator<Item = (Frame, Vector)> {
        let coordinates = self.unresolved.as_ref().map(|vectors| vectors.coordinates);
        let frames = self.frames.nearest(MAX_TURNS_OF_A_BASE).into_iter();
        frames.filter_map(move |(frame, factors)| {
            let rate = self.angular_velocity_of_product(&factors, coordinates?);
            Some((frame, rate.ok()?))
        })
    }

    /// The functions of the coordinates with these rates, which are linear in the velocities with constant coefficients.
    fn integral(&mut self, rates: Vector) -> Option<Vector> {
        let mut integrals = [self.graph.zero(); 3];
        for (rate, integral) in rates.iter().zip(&mut integrals) {
            let mut found = Vec::new();
            for symbol in self.graph.symbols(&[*rate]) {
                if let Symbol::Velocity(i) = symbol {
                    let slope = self.graph.derivative(*rate, symbol);
                    if self.graph.contents(slope).varies() {
                        return None;
                    }
                    let coordinate = self.graph.symbol(Symbol::Coordinate(i));
                    found.push((self.graph.multiply(slope, coordinate), Rational::ONE));
                }
            }
            *integral = self.graph.sum(found);
        }
        let coordinates = self.unresolved.as_ref()?.coordinates;
        let again = self.time_derivatives(&integrals, coordinates);
        (again == rates).then_some(integrals)
    }
}

impl Graph {
    pub(crate) fn has_velocity(&self, column: &Matrix) -> bool {
        let mut elements = column.elements().iter();
        elements.any(|x| self.contents(*x).has_velocity())
    }
}
