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

use crate::frames::frame_tree::Frame;
use crate::frames::vector_in_frames::{Term, UnresolvedVectors, VectorId};
use crate::mechanics::energy_forms::quasi_velocities::QuasiVelocities;
use crate::mechanics::mechanism::{Inertia, Link, Mechanism, Vector};
use crate::typed::declared_system::SystemInFrames;
use crate::{Expression, Geometry, Graph, Model, Node, Rational, Symbol};

/// A link, or the inertial frame, and a place along its axes.
pub(super) type Point = (Option<usize>, Vector);

impl Mechanism {
    /// The mechanism of a model, if it is one.
    pub(crate) fn read(model: &mut Model) -> Option<Self> {
        let mechanism = Self::with_origins(model, false)?;
        Some(mechanism.regrouped(&mut model.graph))
    }

    /// The same with the origins of the links and with what each carries as they were declared.
    pub(crate) fn declared(model: &mut Model) -> Option<Self> {
        Self::with_origins(model, true)
    }

    fn with_origins(model: &mut Model, keeps_origins: bool) -> Option<Self> {
        let declaration = model.declaration.as_ref()?;
        let checkpoint = model.graph.checkpoint();
        let geometry = Geometry::from(core::mem::take(&mut model.graph));
        let mut geometry = geometry.with_unresolved_vectors(model.coordinates);
        let system = declaration.in_frames(&mut geometry);
        let mut reader = Reader {
            vectors: geometry.unresolved.clone().unwrap_or_default(),
            geometry,
            links: Vec::new(),
            frames: Vec::new(),
            masses: Vec::new(),
            keeps_origins,
        };
        let mechanism = system.and_then(|system| reader.mechanism(system));
        model.graph = reader.geometry.graph;
        // What is read in vain stays out of the equations.
        if mechanism.is_none() {
            model.graph.roll_back(checkpoint);
        }
        mechanism
    }
}

/// A mechanism under construction.
pub(super) struct Reader {
    pub(super) geometry: Geometry,
    pub(super) vectors: UnresolvedVectors,
    pub(super) links: Vec<Link>,
    /// The frames of the links.
    pub(super) frames: Vec<Frame>,
    /// The masses of points.
    pub(super) masses: Vec<(Point, Expression)>,
    /// Whether origins are not moved along the axes about which their links turn.
    pub(super) keeps_origins: bool,
}

impl Reader {
    /// The mechanism of a system, if it has several bodies.
    fn mechanism(&mut self, system: SystemInFrames) -> Option<Mechanism> {
        let velocities = QuasiVelocities::declared(&mut self.geometry.graph, system.kinetic)?;
        let kinetic = self.read_inertia(&velocities)?;
        let (base_acceleration, potential) = self.uniform_gravity(system.potential);
        let constraints = system.constraints.and_then(|velocities| {
            let velocities = velocities.into_iter();
            let linked = velocities.map(|velocity| self.linked_constraint(velocity));
            linked.collect::<Option<Vec<_>>>()
        });
        let rest = self.geometry.resolved(&[kinetic, potential]);
        let links = core::mem::take(&mut self.links);
        let bodies = links
            .iter()
            .filter(|link| !link.inertia.vanishes(&self.geometry.graph));
        // A single body is solved through its angular velocity.
        if bodies.count() < 2 {
            return None;
        }
        Some(Mechanism {
            links,
            base_acceleration,
            other_kinetic: rest[0],
            other_potential: rest[1],
            moved: Vec::new(),
            constraints,
        })
    }

    /// Gives all links their inertia; the rest of T.
    fn read_inertia(&mut self, velocities: &QuasiVelocities) -> Option<Expression> {
        let mut blocks: BTreeMap<(VectorId, VectorId), [Vector; 3]> = BTreeMap::new();
        let zero = self.geometry.graph.zero();
        let components = velocities.forms.iter();
        let components: Vec<_> = components
            .map(|form| match self.geometry.graph.node(*form) {
                Node::Symbol(Symbol::VelocityComponent(i)) => Some(VectorId::of_component(*i)),
                _ => None,
            })
            .collect();
        let mut others = Vec::new();
        for (k, row) in velocities.inertia.iter().enumerate() {
            for (l, entry) in row.iter().enumerate() {
                if self.geometry.graph.is_zero(*entry) {
                    continue;
                }
                match (components[k], components[l]) {
                    (Some((number, i)), Some((other, j))) => {
                        let block = blocks.entry((number, other)).or_insert([[zero; 3]; 3]);
                        block[i][j] = *entry;
                    }
                    (None, None) => {
                        others.push((*entry, [velocities.forms[k], velocities.forms[l]]));
                    }
                    _ => return None,
                }
            }
        }
        // The links of points of which first moments are declared, too.
        let mut carriers = BTreeMap::new();
        for ((number, other), tensor) in &blocks {
            if number < other {
                let carrier = self.first_moment([*number, *other], tensor)?;
                let velocity = self.vectors.vector(carrier.number).terms.clone();
                carriers.insert(velocity, carrier.frame);
                self.read_first_moment(carrier)?;
            }
        }
        for ((number, other), tensor) in &blocks {
            if number == other {
                let velocity = &self.vectors.vector(*number).terms;
                let frame = carriers.get(velocity).copied();
                self.read_point_mass(*number, tensor, frame)?;
            }
        }
        // Of links whose origins are known.
        for ((number, other), tensor) in &blocks {
            if number == other {
                self.read_tensor(*number, tensor);
            }
        }
        let rest = self.rest_of_kinetic(velocities.rest, &others);
        let is_component = |symbol: &Symbol| matches!(symbol, Symbol::VelocityComponent(_));
        let mut symbols = self.geometry.graph.symbols(&[rest]).into_iter();
        (!symbols.any(|symbol| is_component(&symbol))).then_some(rest)
    }

    /// Adds to what a link carries.
    fn carry(&mut self, link: usize, inertia: &Inertia) {
        let carried = &mut self.links[link].inertia;
        carried.add(&mut self.geometry.graph, inertia);
    }

    /// What T has besides, of terms ½ W u v: moments of inertia about axes that turn with u = v are those of their links.
    fn rest_of_kinetic(
        &mut self,
        rest: Expression,
        others: &[(Expression, [Expression; 2])],
    ) -> Expression {
        let mut terms = vec![(rest, Rational::ONE)];
        for (entry, [u, v]) in others {
            if u == v
                && let Some((link, axis)) = self.turning_link(*u)
            {
                let mut tensor = [[self.geometry.graph.zero(); 3]; 3];
                tensor[axis][axis] = *entry;
                let inertia = Inertia::of_tensor(&mut self.geometry.graph, &tensor);
                self.carry(link, &inertia);
                continue;
            }
            let product = self
                .geometry
                .graph
                .product([*entry, *u, *v].map(|x| (x, Rational::ONE)));
            terms.push((product, Rational::HALF));
        }
        self.geometry.graph.sum(terms)
    }

    /// The link whose angular velocity has this component along an axis, and no others.
    fn turning_link(&mut self, rate: Expression) -> Option<(usize, usize)> {
        let mut along = [[self.geometry.graph.zero(); 3]; 3];
        for (axis, velocity) in along.iter_mut().enumerate() {
            velocity[axis] = rate;
        }
        self.geometry
            .turning_frames()
            .find_map(|(frame, velocity)| {
                let axis = along.iter().position(|known| *known == velocity)?;
                let link = self.frames.iter().position(|known| *known == frame)?;
                Some((link, axis))
            })
    }

    /// The mass of ½ m |v|² of the velocity v of a point; nothing of an angular velocity along the axes of its frame.
    ///
    /// It lies on the link with the axes of a frame if one is named.
    fn read_point_mass(
        &mut self,
        number: VectorId,
        tensor: &[Vector; 3],
        frame: Option<Frame>,
    ) -> Option<()> {
        let vector = self.vectors.vector(number).clone();
        if let [Term::AngularVelocity(frame, factor)] = vector.terms.as_slice() {
            return (*frame == vector.axes && *factor == self.geometry.graph.one()).then_some(());
        }
        let mass = isotropic(&self.geometry.graph, tensor)?;
        let point = self.moving_point(number, frame)?;
        self.masses.push((point, mass));
        if let (Some(link), place) = point {
            let inertia = Inertia::point(&mut self.geometry.graph, mass, place);
            self.carry(link, &inertia);
        }
        Some(())
    }

    /// The first moment μ h of μ v · d(R h)/dt, where R h is fixed to the last of the links on which v depends.
    fn first_moment(&self, numbers: [VectorId; 2], tensor: &[Vector; 3]) -> Option<FirstMoment> {
        let mass = isotropic(&self.geometry.graph, tensor)?;
        let [first, second] = numbers;
        [(first, second), (second, first)]
            .into_iter()
            .find_map(|(number, other)| {
                let [Term::Rate(frame, place)] = *self.vectors.vector(other).terms else {
                    return None;
                };
                let path = self.geometry.frames.path(frame);
                let is_before = |known: Frame| {
                    known == Frame::INERTIAL || path.iter().any(|(frame, _)| *frame == known)
                };
                let mut velocity = self.vectors.vector(number).terms.iter();
                let fits = !self.varies(place) && velocity.all(|term| is_before(term.frame()));
                fits.then_some(FirstMoment {
                    number,
                    frame,
                    mass,
                    place,
                })
            })
    }

    fn read_first_moment(&mut self, moment: FirstMoment) -> Option<()> {
        let (link, place) = self.moving_point(moment.number, Some(moment.frame))?;
        let mut inertia = Inertia::none(&self.geometry.graph);
        inertia.first = moment
            .place
            .map(|x| self.geometry.graph.multiply(moment.mass, x));
        let inertia = inertia.moved(&mut self.geometry.graph, place);
        self.carry(link?, &inertia);
        Some(())
    }

    /// The point with this velocity, on the link with the axes of a frame if one is named.
    fn moving_point(&mut self, number: VectorId, frame: Option<Frame>) -> Option<Point> {
        let terms = self.vectors.vector(number).terms.iter();
        let terms = terms.map(|term| match term {
            Term::Rate(frame, place) => Some((*frame, *place)),
            _ => None,
        });
        let mut terms: Vec<_> = terms.collect::<Option<_>>()?;
        terms.extend(frame.map(|frame| (frame, [self.geometry.graph.zero(); 3])));
        self.point(&terms)
    }

    /// The inertia tensor of ½ ωᵀ I ω.
    fn read_tensor(&mut self, number: VectorId, tensor: &[Vector; 3]) {
        let vector = self.vectors.vector(number).clone();
        if let [Term::AngularVelocity(frame, _)] = vector.terms.as_slice()
            && let Some(link) = self.link_of(*frame)
        {
            let inertia = Inertia::of_tensor(&mut self.geometry.graph, tensor);
            self.carry(link, &inertia);
        }
    }
}

/// The number μ of a tensor μ 1.
fn isotropic(graph: &Graph, tensor: &[Vector; 3]) -> Option<Expression> {
    let (zero, number) = (graph.zero(), tensor[0][0]);
    let is_isotropic =
        (0..3).all(|i| (0..3).all(|j| tensor[i][j] == if i == j { number } else { zero }));
    is_isotropic.then_some(number)
}

/// A mass times a vector that is fixed to a link, about a point with a velocity that is resolved last.
#[derive(Clone, Copy)]
struct FirstMoment {
    /// The velocity of the point.
    number: VectorId,
    /// The axes of the link.
    frame: Frame,
    mass: Expression,
    /// The vector along these axes.
    place: Vector,
}
