//! The recursion of Newton and Euler along the links of a mechanism (Luh, Walker and Paul, On-line computational scheme for
//! mechanical manipulators, 1980), in vectors along the axes of each link: what a person writes of an arm whose equations are
//! too long to be written out.
//!
//! The links are those from which the program of inverse dynamics is made, before what they carry is regrouped.

use crate::frames::factor::MatrixFactor;
use crate::mechanics::mechanism::{Inertia, Mechanism, Turn, Vector};
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::print::listing::composer::Composer;
use crate::print::listing::recursion_text::{LinkLetters, component};
use crate::print::listing::section::{Section, Side};
use crate::print::listing::vector_text::{list_text, name_texts, plain_text, vector_text};
use crate::print::names::Letters;
use crate::print::spelling::Spelling;
use crate::{Equations, Expression, Graph, Node, Rational, Symbol};

/// What a component of the forces on links is called until it is printed.
const FIRST_SIGN: u32 = 0xE100;

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
        if self.model.declaration.is_none()
            || lagrange.has_room_for_all(&self.model.graph, &self.letters)
        {
            return Vec::new();
        }
        let sections = self.recursion_of_links(equations);
        let graph = &self.model.graph;
        let sections = sections.filter(|sections| {
            let mut sections = sections.iter();
            sections.all(|section| section.has_room_for_all(graph, &self.letters))
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
        let equations = recursion.equations(forces);
        let statements = recursion.statements();
        let place = recursion.quantities.quantity('D', 0, "i");
        let acceleration = self.base_acceleration(&links);
        let mut sections = Vec::new();
        let mut section = Section::new(Some(HEADING.map(String::from)), "");
        for [left, right] in statements
            .iter()
            .map(|sides| sides.each_ref().map(Side::texts))
        {
            self.push_arranged(&mut section, left, right);
        }
        section.sentence = recursion_sentence(&links, &acceleration, &place);
        sections.push(section);
        for lines in [rows, equations] {
            let mut section = Section::new(None, "");
            for [left, right] in lines.iter().map(|sides| sides.each_ref().map(Side::texts)) {
                self.push_arranged(&mut section, left, right);
            }
            sections.push(section);
        }
        Some(sections)
    }

    /// The acceleration before the first link.
    fn base_acceleration(&mut self, links: &LinkEquations) -> [String; 2] {
        let letters = self.letters.of_symbols();
        let parameters = &self.declared.names.parameters;
        let acceleration = links.mechanism.base_acceleration;
        vector_text(&mut self.model.graph, &letters, parameters, acceleration)
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
    fn number(&self, link: usize) -> String {
        (self.first + i64::try_from(link).unwrap_or(0)).to_string()
    }

    fn quantity(&self, quantity: char, dots: usize, link: usize) -> [String; 2] {
        self.quantities.quantity(quantity, dots, &self.number(link))
    }

    fn statements(&self) -> Vec<[[String; 2]; 2]> {
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
    fn rows(&mut self, named_masses: bool) -> Option<Vec<[[String; 2]; 2]>> {
        let links = self.links.mechanism.links.iter().zip(&self.links.joints);
        let mut rows: [Vec<_>; 7] = Default::default();
        for (i, (link, joint)) in links.enumerate() {
            let (center, tensor) = self.about_center(&link.inertia)?;
            if !is_chain(self.links) {
                let before = match link.parent {
                    Some(parent) => self.number(parent),
                    None => (self.first - 1).to_string(),
                };
                let left = [
                    format!("p({})", self.number(i)),
                    format!("p({})", self.number(i)),
                ];
                rows[0].push([left, [before.replace('-', "−"), before]]);
            }
            let turn = self.turn(&link.turn);
            rows[1].push([self.quantity('R', 0, i), turn]);
            for (row, quantity, vector) in
                [(2, 'D', link.place), (3, 'S', joint.rate), (5, 'C', center)]
            {
                let text = vector_text(self.graph, &self.letters, self.parameters, vector);
                rows[row].push([self.quantity(quantity, 0, i), text]);
            }
            if !named_masses {
                let mass = self.text(link.inertia.mass);
                rows[4].push([self.quantity('M', 0, i), mass]);
            }
            let tensor = self.tensor(tensor);
            rows[6].push([self.quantity('I', 0, i), tensor]);
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

    fn turn(&mut self, turn: &Turn) -> [String; 2] {
        match *turn {
            Turn::Identity => ["1", "1"].map(String::from),
            Turn::Elementary(rotation) | Turn::Spin(rotation) => {
                let angle = self.graph.scale(rotation.angle, &rotation.sign());
                let [unicode, latex] = self.text(angle);
                let axis = ["x", "y", "z"][rotation.axis.cycle()[0]];
                [
                    format!("R_{axis}({unicode})"),
                    format!("R_{{{axis}}}\\left({latex}\\right)"),
                ]
            }
            Turn::General(elements) => {
                let factor = MatrixFactor::Rotation(elements);
                let columns = factor.elements(self.graph);
                self.matrix([0, 1, 2].map(|i| [columns[i], columns[3 + i], columns[6 + i]]))
            }
        }
    }

    /// A symmetric matrix: 0, of a diagonal that diagonal, or the symmetric part of a parameter.
    fn tensor(&mut self, tensor: [Vector; 3]) -> [String; 2] {
        let tensor = tensor.map(|row| row.map(|x| self.graph.arranged(x, &self.letters)));
        let is_zero = |graph: &Graph, x: Expression| graph.is_zero(x);
        let off = [(0, 1), (0, 2), (1, 2)];
        if off.iter().all(|(i, j)| is_zero(self.graph, tensor[*i][*j])) {
            let diagonal = [0, 1, 2].map(|i| tensor[i][i]);
            if diagonal.iter().all(|x| is_zero(self.graph, *x)) {
                return ["0", "0"].map(String::from);
            }
            let [unicode, latex] = self.list(&diagonal);
            return [
                format!("diag{unicode}"),
                format!("\\operatorname{{diag}}{latex}"),
            ];
        }
        if let Some([unicode, latex]) = self.symmetric_part(&tensor) {
            return [
                format!("½ ({unicode} + {unicode}ᵀ)"),
                format!("\\frac{{1}}{{2}} \\left({latex} + {latex}^{{T}}\\right)"),
            ];
        }
        self.matrix(tensor)
    }

    /// The parameter of which a tensor is the symmetric part.
    fn symmetric_part(&mut self, tensor: &[Vector; 3]) -> Option<[String; 2]> {
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
        Some(name_texts(&self.letters, &stem))
    }

    fn matrix(&self, rows: [Vector; 3]) -> [String; 2] {
        let rows = rows.map(|row| self.list(&row));
        let both =
            [0, 1].map(|notation| rows.each_ref().map(|row| row[notation].clone()).join(", "));
        [
            format!("({})", both[0]),
            format!("\\left({}\\right)", both[1]),
        ]
    }

    fn list(&self, expressions: &[Expression]) -> [String; 2] {
        list_text(self.graph, &self.letters, expressions)
    }

    fn text(&mut self, x: Expression) -> [String; 2] {
        let x = self.graph.arranged(x, &self.letters);
        plain_text(self.graph, &self.letters, x)
    }

    /// For each coordinate, the components of moments and forces that do work on it, and Q.
    fn equations(&mut self, forces: &[Expression]) -> Vec<[[String; 2]; 2]> {
        let links = self.links;
        let mut letters = self.letters.clone();
        let mut names = Vec::new();
        for i in 0..links.joints.len() {
            let moment = self.quantity('N', 0, i);
            let [turn, force] = ['R', 'P'].map(|quantity| self.quantity(quantity, 0, i));
            let moved = match links.mechanism.links[i].turn {
                Turn::Identity => force,
                _ => [0, 1].map(|k| ["(", &turn[k], " ", &force[k], ")"].concat()),
            };
            for name in [moment, moved] {
                names.extend((0..3).map(|axis| component(name.clone(), axis)));
            }
        }
        for (k, sign) in (0..).zip(FIRST_SIGN..).take(names.len()) {
            let argument = self.graph.symbol(Symbol::Argument(k));
            letters = letters.with_sign(argument, char::from_u32(sign).unwrap_or('?'));
        }
        let others = links.residuals_of_others(self.graph);
        let mut lines = Vec::new();
        for (k, (other, force)) in others.into_iter().zip(forces).enumerate() {
            let graph = &mut *self.graph;
            let mut terms = vec![(other, Rational::ONE), (*force, Rational::ONE)];
            for (i, joint) in links.joints.iter().enumerate() {
                for (kind, slopes) in [&joint.turning, &joint.sliding].into_iter().enumerate() {
                    for (_, slope) in slopes.iter().filter(|(coordinate, _)| *coordinate == k) {
                        for (axis, entry) in slope.iter().enumerate() {
                            let argument = u32::try_from(6 * i + 3 * kind + axis);
                            let argument = Symbol::Argument(argument.unwrap_or(u32::MAX));
                            let argument = graph.symbol(argument);
                            terms.push((graph.multiply(*entry, argument), Rational::ONE));
                        }
                    }
                }
            }
            let left = graph.sum(terms);
            let left = graph.arranged(left, &letters);
            let mut left = match graph.node(left) {
                // A formula that is a name itself is written out.
                Node::Symbol(Symbol::Argument(argument)) => names[*argument as usize].clone(),
                _ => plain_text(graph, &letters, left),
            };
            for (name, sign) in names.iter().zip(FIRST_SIGN..) {
                let sign = char::from_u32(sign).unwrap_or('?');
                for (text, name) in left.iter_mut().zip(name) {
                    *text = text.replace(sign, name);
                }
            }
            lines.push([left, self.text(*force)]);
        }
        lines
    }
}
