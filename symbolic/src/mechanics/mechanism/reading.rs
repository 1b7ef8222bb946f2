//! A mechanism from energies whose vectors are resolved last.
//!
//! T is ½ Σ W w w of components of velocities of points and of angular velocities. The place of a point is a sum of
//! vectors in frames that are turned one after the other: from the origin of each to that of the next. Frames whose
//! origins differ are different links. An origin may lie anywhere on the axis about which its link turns, and is put
//! where its place in the link before has no component along the axis, which costs least.
//!
//! What T has besides, in the velocities of the coordinates themselves, as of rotors behind gears, is left beside the
//! links. Energies in which both are multiplied make no mechanism.

use std::collections::BTreeMap;

use crate::matrix::factor::MatrixFactor;
use crate::matrix::unresolved_vector::{Frame, Term, UnresolvedVectors, VectorId};
use crate::mechanics::energy_forms::quasi_velocities::{QuasiVelocities, is_constant};
use crate::mechanics::mechanism::{Inertia, Link, Mechanism, Turn, Vector};
use crate::{EnergiesInFrames, Expression, Graph, Model, Node, Rational, Symbol};

/// A link, or the inertial frame, and a place along its axes.
type Point = (Option<usize>, Vector);

impl Mechanism {
    /// The mechanism of a model, if it is one.
    pub(crate) fn read(model: &mut Model) -> Option<Self> {
        let energies = model.in_frames.clone()?;
        let EnergiesInFrames {
            mut graph,
            kinetic,
            potential,
        } = energies;
        let velocities = QuasiVelocities::declared(&mut graph, kinetic)?;
        let vectors = graph.unresolved.as_deref()?.clone();
        let mut reader = Reader {
            graph,
            vectors,
            links: Vec::new(),
            frames: Vec::new(),
            masses: Vec::new(),
        };
        let kinetic = reader.read_inertia(&velocities)?;
        let (base_acceleration, potential) = reader.uniform_gravity(potential);
        let graph = &mut reader.graph;
        let rest = graph.resolved(&[kinetic, potential]);
        let mechanism = Self {
            links: reader.links,
            base_acceleration,
            other_kinetic: rest[0],
            other_potential: rest[1],
        };
        let bodies = mechanism
            .links
            .iter()
            .filter(|link| !link.inertia.vanishes(graph));
        // A single body is solved through its angular velocity.
        if bodies.count() < 2 {
            return None;
        }
        let mechanism = mechanism.imported(&mut model.graph, &reader.graph);
        Some(mechanism.regrouped(&mut model.graph))
    }

    /// The same mechanism in another graph.
    fn imported(mut self, graph: &mut Graph, from: &Graph) -> Self {
        let mut all = Vec::new();
        self.for_each_expression(|x| all.push(*x));
        let mut copies = graph.imported(from, &all).into_iter();
        self.for_each_expression(|x| *x = copies.next().unwrap_or(*x));
        self
    }

    fn for_each_expression(&mut self, mut visit: impl FnMut(&mut Expression)) {
        for link in &mut self.links {
            link.place.iter_mut().for_each(&mut visit);
            match &mut link.turn {
                Turn::Identity => {}
                Turn::Elementary(rotation) => visit(&mut rotation.angle),
                Turn::General(elements) => elements.iter_mut().for_each(&mut visit),
            }
            let inertia = &mut link.inertia;
            visit(&mut inertia.mass);
            inertia.first.iter_mut().for_each(&mut visit);
            inertia.second.iter_mut().flatten().for_each(&mut visit);
        }
        self.base_acceleration.iter_mut().for_each(&mut visit);
        visit(&mut self.other_kinetic);
        visit(&mut self.other_potential);
    }
}

/// A mechanism under construction.
struct Reader {
    graph: Graph,
    vectors: UnresolvedVectors,
    links: Vec<Link>,
    /// The frames of the links.
    frames: Vec<Frame>,
    /// The masses of points.
    masses: Vec<(Point, Expression)>,
}

impl Reader {
    /// Gives all links their inertia; the rest of T.
    fn read_inertia(&mut self, velocities: &QuasiVelocities) -> Option<Expression> {
        let mut blocks: BTreeMap<VectorId, [Vector; 3]> = BTreeMap::new();
        let zero = self.graph.zero();
        let components = velocities.forms.iter();
        let components: Vec<_> = components
            .map(|form| match self.graph.node(*form) {
                Node::Symbol(Symbol::VelocityComponent(i)) => Some(VectorId::of_component(*i)),
                _ => None,
            })
            .collect();
        let mut rest = vec![(velocities.rest, Rational::ONE)];
        for (k, row) in velocities.inertia.iter().enumerate() {
            for (l, entry) in row.iter().enumerate() {
                if self.graph.is_zero(*entry) {
                    continue;
                }
                match (components[k], components[l]) {
                    (Some((number, i)), Some((other, j))) if number == other => {
                        let block = blocks.entry(number).or_insert([[zero; 3]; 3]);
                        block[i][j] = *entry;
                    }
                    (None, None) => {
                        let factors = [*entry, velocities.forms[k], velocities.forms[l]];
                        let product = self.graph.product(factors.map(|x| (x, Rational::ONE)));
                        rest.push((product, Rational::HALF));
                    }
                    _ => return None,
                }
            }
        }
        let rest = self.graph.sum(rest);
        let is_component = |symbol: &Symbol| matches!(symbol, Symbol::VelocityComponent(_));
        if self.graph.symbols(&[rest]).iter().any(is_component) {
            return None;
        }
        for (number, tensor) in &blocks {
            self.read_point_mass(*number, tensor)?;
        }
        for (number, tensor) in &blocks {
            self.read_tensor(*number, tensor);
        }
        Some(rest)
    }

    /// The mass of ½ m |v|² of the velocity v of a point; nothing of an angular velocity along the axes of its frame.
    fn read_point_mass(&mut self, number: VectorId, tensor: &[Vector; 3]) -> Option<()> {
        let vector = self.vectors.vector(number).clone();
        if let [Term::AngularVelocity(frame, factor)] = vector.terms.as_slice() {
            return (*frame == vector.axes && *factor == self.graph.one()).then_some(());
        }
        let zero = self.graph.zero();
        let mass = tensor[0][0];
        let is_isotropic =
            (0..3).all(|i| (0..3).all(|j| tensor[i][j] == if i == j { mass } else { zero }));
        let terms = vector.terms.iter().map(|term| match term {
            Term::Rate(frame, place) => Some((*frame, *place)),
            _ => None,
        });
        let terms: Vec<_> = terms.collect::<Option<_>>()?;
        if !is_isotropic {
            return None;
        }
        let point = self.point(&terms)?;
        self.masses.push((point, mass));
        if let (Some(link), place) = point {
            let inertia = Inertia::point(&mut self.graph, mass, place);
            self.links[link].inertia.add(&mut self.graph, &inertia);
        }
        Some(())
    }

    /// The inertia tensor of ½ ωᵀ I ω.
    fn read_tensor(&mut self, number: VectorId, tensor: &[Vector; 3]) {
        let vector = self.vectors.vector(number).clone();
        if let [Term::AngularVelocity(frame, _)] = vector.terms.as_slice()
            && let Some(link) = self.link_of(*frame)
        {
            let inertia = Inertia::of_tensor(&mut self.graph, tensor);
            self.links[link].inertia.add(&mut self.graph, &inertia);
        }
    }

    /// A link with the axes of a frame.
    fn link_of(&mut self, frame: Frame) -> Option<usize> {
        let path = self.vectors.path(frame);
        let known = path.iter().rev().find_map(|(frame, _)| {
            let link = self.frames.iter().position(|known| known == frame)?;
            Some((link, *frame))
        });
        let (mut link, here) =
            known.map_or((None, Frame::INERTIAL), |(link, here)| (Some(link), here));
        let mut place = [self.graph.zero(); 3];
        self.walk(&mut link, (here, frame), &mut place)?;
        link
    }

    /// The point at Σ Rᵢ vᵢ: from the origin of each frame to that of the next, in the order in which they were declared.
    ///
    /// New links are made for the frames on the way, and for a place that varies in the last.
    fn point(&mut self, terms: &[(Frame, Vector)]) -> Option<Point> {
        let zero = self.graph.zero();
        let mut places: BTreeMap<Frame, Vector> = BTreeMap::new();
        for term in terms {
            let (frame, place) = self.carried(*term);
            let sum = places.entry(frame).or_insert([zero; 3]);
            *sum = [0, 1, 2].map(|i| self.graph.add(sum[i], place[i]));
        }
        let mut place = places.remove(&Frame::INERTIAL).unwrap_or([zero; 3]);
        let (mut link, mut last) = (None, Frame::INERTIAL);
        for (frame, own) in places {
            self.walk(&mut link, (last, frame), &mut place)?;
            last = frame;
            place = [0, 1, 2].map(|i| self.graph.add(place[i], own[i]));
        }
        if self.varies(place) {
            link = Some(self.link(link, last, place, Turn::Identity));
            place = [zero; 3];
        }
        Some((link, place))
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
                *place = [self.graph.zero(); 3];
            }
            *link = Some(self.next_link(*link, frame, factor, place)?);
        }
        Some(())
    }

    /// The frames on the way from one to another, each with its turn against the one before: back to the last that both
    /// have in common, and forth. Turns about one axis there and back are one, as of angles against the horizontal.
    fn steps(&mut self, here: Frame, there: Frame) -> Vec<(Frame, MatrixFactor)> {
        let (from, to) = (self.vectors.path(here), self.vectors.path(there));
        let pairs = from.iter().zip(&to);
        let common = pairs.take_while(|(x, y)| x == y).count();
        if common == from.len() {
            return to[common..].to_vec();
        }
        let back = from[common..].iter().rev();
        let back = back.map(|(_, factor)| factor.transpose());
        let forth = to[common..].iter().map(|(_, factor)| *factor);
        let factors = self.graph.combined(back.chain(forth));
        let mut path = self.vectors.factors(here);
        let mut steps = Vec::with_capacity(factors.len());
        for factor in factors {
            path.push(factor);
            steps.push((self.vectors.frame(&path), factor));
        }
        if let Some((frame, _)) = steps.last_mut() {
            *frame = there;
        }
        steps
    }

    /// The place along the axes of a frame that is turned against its own, if it is constant there: l (cos q, sin q, 0) is
    /// l (1, 0, 0) of the link that is turned by q.
    fn carried(&mut self, (frame, place): (Frame, Vector)) -> (Frame, Vector) {
        if !self.varies(place) {
            return (frame, place);
        }
        for (next, factor) in self.vectors.behind(frame) {
            let turned = factor.transpose().apply(&mut self.graph, place);
            let turned = turned.map(|x| self.graph.reduced(x));
            if !self.varies(turned) {
                return (next, turned);
            }
        }
        (frame, place)
    }

    fn varies(&self, place: Vector) -> bool {
        place.iter().any(|x| self.graph.contents(*x).varies())
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
        let zero = self.graph.zero();
        let mut origin = *place;
        *place = [zero; 3];
        if let Some(axis) = turn.axis()
            && !self.graph.contents(origin[axis]).varies()
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
                inertia: Inertia::none(&self.graph),
            });
            self.frames.push(frame);
            self.links.len() - 1
        })
    }

    /// The acceleration that stands in for the part of V that is Σ m a · r over all masses, and the rest of V.
    fn uniform_gravity(&mut self, potential: Expression) -> (Vector, Expression) {
        let count = self.links.len();
        if let Some(found) = self.gravity_and_rest(potential) {
            return found;
        }
        // Links of weights without masses.
        self.links.truncate(count);
        self.frames.truncate(count);
        ([self.graph.zero(); 3], potential)
    }

    fn gravity_and_rest(&mut self, potential: Expression) -> Option<(Vector, Expression)> {
        let zero = self.graph.zero();
        let mut weights: BTreeMap<VectorId, Vector> = BTreeMap::new();
        let mut removed = BTreeMap::new();
        for symbol in self.graph.symbols(&[potential]) {
            let Symbol::PositionComponent(index) = symbol else {
                continue;
            };
            let slope = self.graph.derivative(potential, symbol);
            if is_constant(&self.graph, slope) {
                let (number, axis) = VectorId::of_component(index);
                weights.entry(number).or_insert([zero; 3])[axis] = slope;
                removed.insert(symbol, zero);
            }
        }
        let mut acceleration = None;
        let mut heavy = Vec::new();
        for (number, weight) in weights {
            let point = self.marked_point(number)?;
            let mass = self.masses.iter().find(|(known, _)| *known == point)?.1;
            let ratio = weight.map(|x| self.graph.divide(x, mass));
            if *acceleration.get_or_insert(ratio) != ratio {
                return None;
            }
            heavy.push(point);
        }
        let is_moved = |(link, _): Point| link.is_some();
        let mut masses = self.masses.iter();
        if !masses.all(|(point, _)| !is_moved(*point) || heavy.contains(point)) {
            return None;
        }
        let rest = self.graph.substitute(&[potential], &removed)[0];
        Some((acceleration?, rest))
    }

    /// The point of a position that is resolved along inertial axes.
    fn marked_point(&mut self, number: VectorId) -> Option<Point> {
        let vector = self.vectors.vector(number).clone();
        let terms = vector.terms.iter().map(|term| match term {
            Term::Fixed(frame, place) if vector.axes == Frame::INERTIAL => Some((*frame, *place)),
            _ => None,
        });
        let terms: Vec<_> = terms.collect::<Option<_>>()?;
        let count = self.links.len();
        let point = self.point(&terms)?;
        // A weight without a mass has no link of its own.
        (self.links.len() == count).then_some(point)
    }
}
