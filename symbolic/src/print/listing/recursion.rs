//! The recursion of Newton and Euler along the links of a mechanism (Luh, Walker and Paul, On-line computational scheme for
//! mechanical manipulators, 1980), in vectors along the axes of each link: what a person writes of an arm whose equations are
//! too long to be written out.
//!
//! The links are those from which the program of inverse dynamics is made, before what they carry is regrouped.

use crate::frames::factor::MatrixFactor;
use crate::mechanics::mechanism::{Inertia, Mechanism, Turn, Vector};
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::print::index::Index;
use crate::print::listing::composer::Composer;
use crate::print::listing::recursion_text::LinkLetters;
use crate::print::listing::section::Section;
use crate::print::listing::vector_text::{list, vector};
use crate::print::names::Letters;
use crate::print::printed::Printed;
use crate::print::spelling::Spelling;
use crate::{Equations, Expression, Graph, Node, Rational, Symbol};

/// The sections of the recursion.
struct Recursion<'a> {
    graph: &'a mut Graph,
    letters: Letters,
    parameters: &'a [String],
    links: &'a LinkEquations,
    quantities: LinkLetters,
    /// The number of the first link.
    first: i64,
}

impl Composer<'_> {
    /// The recursion, where the model is a mechanism, some of Lagrange's equations are left out, and all of it has room.
    pub(crate) fn recursion(&mut self, equations: &Equations, lagrange: &Section) -> Vec<Section> {
        if self.model.declaration.is_none() || lagrange.has_room_for_all(&self.letters) {
            return Vec::new();
        }
        let sections = self.recursion_of_links(equations);
        let sections = sections.filter(|sections| {
            let mut sections = sections.iter();
            sections.all(|section| section.has_room_for_all(&self.letters))
        });
        sections.unwrap_or_default()
    }

    fn recursion_of_links(&mut self, equations: &Equations) -> Option<Vec<Section>> {
        let mechanism = Mechanism::declared(self.model)?;
        let forces = &equations.generalized_forces;
        let links = LinkEquations::of_mechanism(self.model, mechanism, forces);
        let names = &self.declared.names;
        let mut recursion = Recursion {
            graph: &mut self.model.graph,
            letters: self.letters.of_symbols(),
            parameters: &names.parameters,
            quantities: LinkLetters::free(names, &self.declared.definitions),
            first: first_number(names.coordinates.first(), &links),
            links: &links,
        };
        let names_of_masses = recursion.masses_by_name();
        let rows = recursion.rows(names_of_masses)?;
        let equations = recursion.equations(forces)?;
        let statements = recursion.statements();
        let own = Index::Variable("i".to_owned(), 0);
        let place = recursion.quantities.quantity('D', 0, own).both();
        let acceleration = self.base_acceleration(&links)?.both();
        let mut sections = Vec::new();
        let mut section = Section::new(Some(HEADING.map(String::from)), "");
        for [left, right] in statements {
            self.push_arranged(&mut section, left, right);
        }
        section.sentence = recursion_sentence(&links, &acceleration, &place);
        sections.push(section);
        for lines in [rows, equations] {
            let mut section = Section::new(None, "");
            for [left, right] in lines {
                self.push_arranged(&mut section, left, right);
            }
            sections.push(section);
        }
        Some(sections)
    }

    /// The acceleration before the first link.
    fn base_acceleration(&mut self, links: &LinkEquations) -> Option<Printed> {
        let letters = self.letters.of_symbols();
        let parameters = &self.declared.names.parameters;
        let acceleration = links.mechanism.base_acceleration;
        vector(&mut self.model.graph, &letters, parameters, acceleration)
    }
}

const HEADING: [&str; 2] = [
    "Recursion of Newton and Euler (Luh, Walker and Paul), along the axes of each link i:",
    "Recursion of Newton and Euler (Luh, Walker and Paul), along the axes of each link $i$:",
];

/// Links have the numbers of their coordinates, where these are of a family and in order; else they count from 1.
fn first_number(first: Option<&String>, links: &LinkEquations) -> i64 {
    let number = first.and_then(|name| name.split_once('[')?.1.strip_suffix(']')?.parse().ok());
    let in_order = links.joints.iter().enumerate().all(|(i, joint)| {
        let coordinates = joint.turning.iter().chain(&joint.sliding);
        coordinates.into_iter().all(|(k, _)| *k == i)
    });
    number.filter(|_| in_order).unwrap_or(1)
}

fn is_chain(links: &LinkEquations) -> bool {
    let mut links = links.mechanism.links.iter().enumerate();
    links.all(|(i, link)| link.parent == i.checked_sub(1))
}

/// What stands before the first link, what p and j are, and along which axes s is.
fn recursion_sentence(
    links: &LinkEquations,
    acceleration: &[String; 2],
    place: &[String; 2],
) -> [String; 2] {
    let [text, latex] = acceleration;
    let behind = if is_chain(links) {
        ["Behind the last link there is nothing."; 2]
    } else {
        [
            "The link before i is p, the links behind it are j.",
            "The link before $i$ is $p$, the links behind it are $j$.",
        ]
    };
    let before = "Before the first link nothing turns, and the acceleration is";
    let along = "is along the axes of the link before; dots are rates of components.";
    [
        format!("{before} {text}. {} {} {along}", behind[0], place[0]),
        format!("{before} ${latex}$. {} ${}$ {along}", behind[1], place[1]),
    ]
}

impl Recursion<'_> {
    fn number(&self, link: usize) -> i64 {
        self.first + i64::try_from(link).unwrap_or(0)
    }

    fn quantity(&self, quantity: char, link: usize) -> Printed {
        let index = Index::Number(self.number(link));
        self.quantities.quantity(quantity, 0, index)
    }

    fn statements(&self) -> Vec<[Printed; 2]> {
        // By a coordinate, or with the time.
        let mut links = self.links.mechanism.links.iter();
        let slides = links.any(|link| {
            let mut place = link.place.iter();
            place.any(|x| self.graph.contents(*x).varies())
        });
        self.quantities.statements(is_chain(self.links), slides)
    }

    /// Whether the masses are those of a family with the numbers of the links; then they are called by its name.
    fn masses_by_name(&mut self) -> bool {
        let links = self.links.mechanism.links.iter().enumerate();
        let mut stem = None;
        let named = links.into_iter().all(|(i, link)| {
            let Node::Symbol(Symbol::Parameter(k)) = self.graph.node(link.inertia.mass) else {
                return false;
            };
            let name = self.parameters.get(*k as usize);
            let own = name.and_then(|name| name.strip_suffix(&format!("[{}]", self.number(i))));
            own.is_some() && *stem.get_or_insert(own) == own
        });
        if let (true, Some(Some(stem))) = (named, stem) {
            self.quantities.call('M', Spelling::of_parameter(stem));
        }
        named
    }

    /// What each link is: R, s, σ, m, c and I, in this order.
    fn rows(&mut self, named_masses: bool) -> Option<Vec<[Printed; 2]>> {
        let links = self.links.mechanism.links.iter().zip(&self.links.joints);
        let mut rows: [Vec<_>; 7] = Default::default();
        for (i, (link, joint)) in links.enumerate() {
            let (center, tensor) = self.about_center(&link.inertia)?;
            if !is_chain(self.links) {
                let before = match link.parent {
                    Some(parent) => self.number(parent),
                    None => self.first - 1,
                };
                let left = format!("p({})", self.number(i));
                let before = Printed::number(&Rational::integer(before));
                rows[0].push([Printed::text([&left, &left]), before]);
            }
            let turn = self.turn(&link.turn)?;
            rows[1].push([self.quantity('R', i), turn]);
            for (row, quantity, value) in
                [(2, 'D', link.place), (3, 'S', joint.rate), (5, 'C', center)]
            {
                let value = vector(self.graph, &self.letters, self.parameters, value)?;
                rows[row].push([self.quantity(quantity, i), value]);
            }
            if !named_masses {
                let mass = self.printed(link.inertia.mass)?;
                rows[4].push([self.quantity('M', i), mass]);
            }
            let tensor = self.tensor(tensor)?;
            rows[6].push([self.quantity('I', i), tensor]);
        }
        Some(rows.concat())
    }

    /// The centre of mass of a link, and its inertia tensor about it.
    fn about_center(&mut self, inertia: &Inertia) -> Option<(Vector, [Vector; 3])> {
        let graph = &mut *self.graph;
        let zero = graph.zero();
        if graph.is_zero(inertia.mass) {
            let is_zero = inertia.first.iter().all(|x| graph.is_zero(*x));
            return is_zero.then(|| ([zero; 3], inertia.tensor(graph)));
        }
        let center = inertia.first.map(|x| graph.divide(x, inertia.mass));
        let back = center.map(|x| graph.negate(x));
        let mut about = inertia.moved(graph, back);
        for entry in about.second.iter_mut().flatten() {
            *entry = graph.arranged(*entry, &self.letters);
        }
        Some((center, about.tensor(graph)))
    }

    fn turn(&mut self, turn: &Turn) -> Option<Printed> {
        match *turn {
            Turn::Identity => Some(Printed::number(&Rational::ONE)),
            Turn::Elementary(rotation) | Turn::Spin(rotation) => {
                let angle = self.graph.scale(rotation.angle, &rotation.sign());
                let names = [["R_x", "R_{x}"], ["R_y", "R_{y}"], ["R_z", "R_{z}"]];
                let name = names[rotation.axis.cycle()[0]];
                Some(Printed::call(name, vec![self.printed(angle)?]))
            }
            Turn::General(elements) => {
                let factor = MatrixFactor::Rotation(elements);
                let columns = factor.elements(self.graph);
                self.matrix([0, 1, 2].map(|i| [columns[i], columns[3 + i], columns[6 + i]]))
            }
        }
    }

    /// A symmetric matrix: 0, of a diagonal that diagonal, or the symmetric part of a parameter.
    fn tensor(&mut self, tensor: [Vector; 3]) -> Option<Printed> {
        let tensor = tensor.map(|row| row.map(|x| self.graph.arranged(x, &self.letters)));
        let is_zero = |graph: &Graph, x: Expression| graph.is_zero(x);
        let off = [(0, 1), (0, 2), (1, 2)];
        if off.iter().all(|(i, j)| is_zero(self.graph, tensor[*i][*j])) {
            let diagonal = [0, 1, 2].map(|i| tensor[i][i]);
            if diagonal.iter().all(|x| is_zero(self.graph, *x)) {
                return Some(Printed::zero());
            }
            let diagonal = diagonal
                .iter()
                .map(|x| self.graph.printed(*x, &self.letters));
            let diagonal = diagonal.collect::<Option<_>>()?;
            return Some(Printed::call(["diag", "\\operatorname{diag}"], diagonal));
        }
        if let Some(name) = self.symmetric_part(&tensor) {
            let transposed = name.clone().followed_by(["ᵀ", "^{T}"]);
            let half = Printed::number(&Rational::HALF);
            return Some(half.times(name.plus(transposed, false)));
        }
        self.matrix(tensor)
    }

    /// The parameter of which a tensor is the symmetric part.
    fn symmetric_part(&mut self, tensor: &[Vector; 3]) -> Option<Printed> {
        let Node::Symbol(Symbol::Parameter(first)) = self.graph.node(tensor[0][0]) else {
            return None;
        };
        let name = self.parameters.get(*first as usize)?;
        let stem = name.strip_suffix("[(0, 0)]")?.to_owned();
        for (i, row) in tensor.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                let [one, other] = [(i, j), (j, i)].map(|(i, j)| format!("{stem}[({i}, {j})]"));
                let place = |name| {
                    let place = self.parameters.iter().position(|known| *known == name)?;
                    u32::try_from(place).ok()
                };
                let places = [place(one)?, place(other)?];
                let graph = &mut *self.graph;
                let halves = places.map(|k| (graph.symbol(Symbol::Parameter(k)), Rational::HALF));
                let mean = graph.sum(halves);
                let difference = graph.subtract(*entry, mean);
                if !graph.vanishes(&[difference]) {
                    return None;
                }
            }
        }
        Some(Printed::name(&stem, true, Vec::new(), 0))
    }

    fn matrix(&self, rows: [Vector; 3]) -> Option<Printed> {
        let rows = rows.iter().map(|row| list(self.graph, &self.letters, row));
        Some(Printed::list(rows.collect::<Option<_>>()?))
    }

    fn printed(&mut self, x: Expression) -> Option<Printed> {
        let x = self.graph.arranged(x, &self.letters);
        self.graph.printed(x, &self.letters)
    }

    /// For each coordinate, the components of moments and forces that do work on it, and Q.
    fn equations(&mut self, forces: &[Expression]) -> Option<Vec<[Printed; 2]>> {
        let links = self.links;
        let mut letters = self.letters.clone();
        let mut arguments = (0..).map(Symbol::Argument);
        for (i, link) in links.mechanism.links.iter().enumerate() {
            let moment = self.quantity('N', i);
            let [turn, force] = ['R', 'P'].map(|quantity| self.quantity(quantity, i));
            let moved = match link.turn {
                Turn::Identity => force,
                _ => Printed::list(vec![turn.times(force)]),
            };
            for vector in [moment, moved] {
                for (axis, argument) in ["x", "y", "z"].into_iter().zip(&mut arguments) {
                    letters.call(self.graph.symbol(argument), vector.clone().component(axis));
                }
            }
        }
        let others = links.residuals_of_others(self.graph);
        let mut lines = Vec::new();
        for (k, (other, force)) in others.into_iter().zip(forces).enumerate() {
            let graph = &mut *self.graph;
            let mut terms = vec![(other, Rational::ONE), (*force, Rational::ONE)];
            for (i, joint) in links.joints.iter().enumerate() {
                let slopes = joint.turning.iter().chain(&joint.sliding);
                for (_, slope) in slopes.filter(|(coordinate, _)| *coordinate == k) {
                    for (axis, entry) in slope.components().enumerate() {
                        let argument = u32::try_from(6 * i + axis).unwrap_or(u32::MAX);
                        let argument = graph.symbol(Symbol::Argument(argument));
                        terms.push((graph.multiply(entry, argument), Rational::ONE));
                    }
                }
            }
            let left = graph.sum(terms);
            let left = graph.arranged(left, &letters);
            let left = graph.printed(left, &letters)?;
            lines.push([left, self.printed(*force)?]);
        }
        Some(lines)
    }
}
