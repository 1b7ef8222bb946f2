//! The sections of a listing.

use std::collections::BTreeSet;
use std::ops::Range;

use crate::limits::{
    MAX_LINE_LENGTH, MAX_SKIMMED_LENGTH, MAX_UNARRANGED_LENGTH, MIN_FOLDED_SECTION, MIN_SKIMMED,
};
use crate::mechanics::solvers::form::SolvedForm;
use crate::print::listing::Declared;
use crate::print::listing::as_declared::DeclaredLine;
use crate::print::listing::page_letters::{PageLetters, Quantity};
use crate::print::listing::sampling::Sampling;
use crate::print::listing::section::{Section, Side};
use crate::print::names::{Letters, Names};
use crate::print::printed::Printed;
use crate::{Energies, Equations, Expression, Graph, Model, Node, Rational, Symbol};

/// What the sections are made from.
pub(crate) struct Composer<'a> {
    pub(crate) model: &'a mut Model,
    pub(crate) energies: Energies,
    pub(crate) declared: &'a Declared,
    pub(crate) letters: Letters,
    pub(crate) page: PageLetters,
    /// The expressions of the sections composed so far.
    pub(crate) mentioned: Vec<Expression>,
    /// The definitions that are listed as they were declared.
    mentioned_as_declared: BTreeSet<String>,
}

impl<'a> Composer<'a> {
    pub(crate) fn new(
        model: &'a mut Model,
        energies: Energies,
        declared: &'a Declared,
        solved: &SolvedForm,
    ) -> Self {
        let mut names = Names {
            definitions: declared.names.definitions.clone(),
            ..declared.names.clone()
        };
        // A family has names for all of its members or for none.
        let worthy = declared.definitions.iter();
        let worthy = worthy.filter(|(_, x)| is_worth_a_name(&model.graph, *x));
        let families: BTreeSet<_> = worthy.map(|(name, _)| family(name)).collect();
        for (name, expression) in &declared.definitions {
            if families.contains(&family(name)) && !is_a_letter(&model.graph, *expression) {
                let entry = names.definitions.entry(*expression);
                entry.or_insert_with(|| name.clone());
            }
        }
        if let SolvedForm::QuasiVelocities(equations) = solved {
            names.quasi_velocities =
                quasi_velocity_names(&model.graph, &names, &equations.quasi_velocities);
        }
        let letters = Letters::new(&names);
        Self {
            page: PageLetters::of(declared, &letters),
            letters,
            model,
            energies,
            declared,
            mentioned: Vec::new(),
            mentioned_as_declared: BTreeSet::new(),
        }
    }

    /// An expression as it is short to read; as it is where it is so long that it has no room anyway.
    pub(crate) fn arranged(&mut self, expression: Expression) -> Expression {
        self.model.graph.arranged(expression, &self.letters)
    }

    /// Adds an equation to a section if there is room. What is too long is not even arranged.
    pub(crate) fn push(&mut self, section: &mut Section, left: Printed, right: Expression) {
        let symbols = self.model.graph.written_symbols(&[right], &self.letters);
        if symbols <= MAX_UNARRANGED_LENGTH && section.has_room() {
            let right = self.arranged(right);
            self.push_arranged(section, left, right);
        } else {
            section.leave_out(symbols);
        }
    }

    /// Adds an equation to a section if there is room, as it is.
    pub(crate) fn push_arranged(
        &self,
        section: &mut Section,
        left: impl Into<Side>,
        right: impl Into<Side>,
    ) {
        let sides = [left.into(), right.into()];
        section.push(&self.model.graph, &self.letters, sides);
    }

    /// A section whose definitions are to be listed.
    pub(crate) fn mention(&mut self, section: Section) -> Section {
        self.mentioned.extend(&section.expressions);
        section
    }

    /// Expressions whose definitions are to be listed.
    pub(crate) fn mention_all(&mut self, expressions: &[Expression]) {
        self.mentioned.extend(expressions);
    }

    /// T and V, or L: written out, or as they were declared where that is much shorter.
    pub(crate) fn energies(&mut self) -> Section {
        let energies = match self.energies {
            Energies::Natural { kinetic, potential } => vec![
                (Quantity::Kinetic, kinetic),
                (Quantity::Potential, potential),
            ],
            Energies::General(lagrangian) => vec![(Quantity::Lagrangian, lagrangian)],
        };
        let energies = energies
            .into_iter()
            .map(|(quantity, energy)| (self.page.letter(quantity), energy));
        let energies: Vec<_> = energies.collect();
        let mut section = Section::new(None, "the methods `lagrangian` and `energy`");
        for (letter, energy) in &energies {
            self.push(&mut section, letter.clone(), *energy);
        }
        let lengths = section.lengths(&self.letters);
        let declared = &self.declared.as_declared;
        let mut names = self.declared.names.coordinates.iter();
        let has_vectors = names.any(|name| name.contains('.'));
        let prefers = |(written, line): (&Option<usize>, &DeclaredLine)| {
            let length = line.right.length();
            // Definitions have to be read, too; vectors need no components.
            let (least, times) = match line.mentions.len() {
                0 if has_vectors => (0, 1),
                0 => (MIN_SKIMMED, 2),
                _ => (MAX_SKIMMED_LENGTH, 4),
            };
            let is_shorter = written.is_none_or(|written| written > least.max(times * length));
            length <= MAX_LINE_LENGTH && is_shorter
        };
        let preferred: Vec<_> = lengths
            .iter()
            .zip(&declared.energies)
            .map(prefers)
            .collect();
        let is_unmistakable = self.letters.as_written().is_empty();
        if declared.energies.len() != lengths.len()
            || !preferred.contains(&true)
            || !is_unmistakable
        {
            return self.mention(section);
        }
        // Definitions are listed in one way.
        let mut lines = preferred.iter().zip(&declared.energies);
        let all = lines.any(|(preferred, line)| *preferred && !line.mentions.is_empty());
        let mut section = Section::new(None, section.method);
        for ((letter, energy), (preferred, line)) in energies
            .iter()
            .zip(preferred.iter().zip(&declared.energies))
        {
            if all || *preferred {
                self.mentioned_as_declared.extend(line.mentions.clone());
                let [left, right] = [letter, &line.right].map(Clone::clone);
                self.push_arranged(&mut section, left, right);
            } else {
                self.push(&mut section, letter.clone(), *energy);
            }
        }
        self.mention(section)
    }

    pub(crate) fn events(&mut self) -> Section {
        let heading = ["Events, where a function vanishes:"; 2].map(String::from);
        let mut section = Section::new(Some(heading), "the method `event_functions`");
        for (name, function) in &self.declared.events {
            let latex = format!("g_{{\\mathrm{{{}}}}}", name.replace('_', "\\_"));
            let left = Printed::text([&format!("g[{name}]"), &latex]);
            self.push(&mut section, left, *function);
        }
        self.mention(section)
    }

    /// ∂L/∂q̇ᵢ, and which of them are constants of motion.
    pub(crate) fn momenta(&mut self, equations: &Equations) -> Section {
        let heading = self.page.texts([
            "Momenta {p} = ∂{L}/∂{q}\u{307}:",
            "Momenta ${p} = \\partial {L}/\\partial \\dot {q}$:",
        ]);
        let section = Section::new(Some(heading), "the method `momenta`");
        let names: Vec<_> = (0..self.model.coordinates)
            .map(|i| self.momentum(Symbol::Coordinate(i)))
            .collect();
        let is_long = self.is_long(&equations.momenta);
        let mut section = self.in_families(
            (section, is_long),
            |composer| composer.momentum_of_family(equations),
            |composer, section, coordinates| {
                for i in coordinates {
                    let left = names[i].clone();
                    composer.push(section, left, equations.momenta[i]);
                }
            },
        );
        let constant = names.iter().zip(&equations.conservation.momenta);
        let constant: Vec<_> = constant.filter(|(_, is_constant)| **is_constant).collect();
        section.sentence = [0, 1].map(|notation| {
            let names = constant.iter().map(|(name, _)| {
                let [unicode, latex] = name.both();
                [unicode, format!("${latex}$")][notation].clone()
            });
            are_constant(&names.collect::<Vec<_>>())
        });
        self.mention(section)
    }

    /// The momentum of a coordinate by name.
    pub(crate) fn momentum(&self, coordinate: Symbol) -> Printed {
        let [letter, in_latex] = self.page.signs(Quantity::Momenta);
        let opening = [format!("{letter}_"), format!("{in_latex}_{{")];
        let [opening, in_latex] = opening.each_ref().map(|signs| &**signs);
        let brackets = [[opening, ""], [in_latex, "}"]];
        Printed::within(brackets, vec![self.letters.printed(coordinate)])
    }

    /// A section of lines, or of one equation for a family of coordinates where lines are too long or twice as long; `lines`
    /// adds those of a range of coordinates.
    fn in_families(
        &mut self,
        (mut section, is_long): (Section, bool),
        family: impl Fn(&mut Self) -> Option<(Printed, Printed)>,
        lines: impl Fn(&mut Self, &mut Section, Range<usize>),
    ) -> Section {
        let empty = section.clone();
        let all = 0..self.model.coordinates as usize;
        let rows = Sampling::of(self).map(|sampling| sampling.rows());
        let folded = |composer: &mut Self| {
            let rows = rows.clone()?;
            let (left, right) = family(composer)?;
            let mut folded = empty.clone();
            lines(composer, &mut folded, all.start..rows.start);
            composer.push_arranged(&mut folded, left, right);
            folded.stands_for_more(rows.len() - 1);
            lines(composer, &mut folded, rows.end..all.end);
            Some(folded)
        };
        if is_long && let Some(folded) = folded(self) {
            return folded;
        }
        lines(self, &mut section, all.clone());
        if is_long || rows.is_none() {
            return section;
        }
        let length = section.written_length(&self.letters);
        if length >= MIN_FOLDED_SECTION
            && let Some(folded) = folded(self)
            && 2 * folded.written_length(&self.letters) <= length
        {
            return folded;
        }
        section
    }

    /// Whether one of these is too long to be written out.
    fn is_long(&self, expressions: &[Expression]) -> bool {
        let mut each = expressions.iter();
        each.any(|x| self.model.graph.written_symbols(&[*x], &self.letters) > MAX_UNARRANGED_LENGTH)
    }

    /// Σⱼ Mᵢⱼ q̈ⱼ + (Q − f)ᵢ = Qᵢ.
    pub(crate) fn lagrange(&mut self, equations: &Equations) -> Section {
        let mut heading = self.page.texts([
            "Lagrange's equations d/dt (∂{L}/∂{q}\u{307}) − ∂{L}/∂{q} = {Q} (4.6):",
            "Lagrange's equations $\\frac{d}{dt} \\frac{\\partial {L}}{\\partial \\dot {q}} - \\frac{\\partial {L}}{\\partial {q}} = {Q}$ (4.6):",
        ]);
        if !equations.constraints.is_empty() {
            let reactions = [" + Gᵀλ (4.6):", " + G^T \\lambda$ (4.6):"];
            let ends = [" (4.6):", "$ (4.6):"];
            for ((heading, end), reaction) in heading.iter_mut().zip(ends).zip(reactions) {
                *heading = heading.replace(end, reaction);
            }
        }
        let method = "the methods `mass_matrix`, `forcing` and `inverse_dynamics`";
        let section = Section::new(Some(heading), method);
        let empty = section.clone();
        let is_long = self.is_long(&equations.inverse_dynamics);
        let section = self.in_families(
            (section, is_long),
            |composer| composer.lagrange_of_family(equations),
            |composer, section, coordinates| {
                for i in coordinates {
                    composer.push_lagrange(section, equations, i);
                }
            },
        );
        let section = self.shorter_by_pairs(equations, section, empty);
        self.mention(section)
    }

    /// Adds Lagrange's equation of a coordinate if there is room.
    pub(crate) fn push_lagrange(&mut self, section: &mut Section, equations: &Equations, i: usize) {
        let roots = [&*equations.mass[i], &[equations.forcing[i]]].concat();
        let symbols = self.model.graph.written_symbols(&roots, &self.letters);
        if symbols > MAX_UNARRANGED_LENGTH || !section.has_room() {
            section.leave_out(symbols);
            return;
        }
        let sides = arranged_lagrange(&mut self.model.graph, equations, i, &self.letters);
        let [left, right] = sides;
        self.push_arranged(section, left, right);
    }

    /// The definitions that other sections mention, and those that these mention.
    pub(crate) fn definitions(&mut self) -> Section {
        let mut section = Section::new(None, "the declaration");
        let declared = &self.declared.as_declared;
        let mut defined = BTreeSet::new();
        for line in declared.definitions_of(&self.mentioned_as_declared) {
            let [left, right] = [&line.left, &line.right].map(Clone::clone);
            self.push_arranged(&mut section, left, right);
            defined.insert(line.left.both());
        }
        let mut open = core::mem::take(&mut self.mentioned);
        let mut seen = BTreeSet::new();
        while let Some(part) = open.pop() {
            if seen.insert(part) {
                let node = self.model.graph.node(part);
                node.for_each_operand(|x| open.push(x));
            }
        }
        let mut listed = BTreeSet::new();
        for (_, expression) in &self.declared.definitions {
            if seen.contains(expression)
                && listed.insert(*expression)
                && let Some(name) = self.letters.definition(*expression).cloned()
                && !defined.contains(&name.both())
            {
                self.push(&mut section, name, *expression);
            }
        }
        section
    }
}

/// The sides of Lagrange's equation of a coordinate as they are short to read in these letters.
pub(crate) fn arranged_lagrange(
    graph: &mut Graph,
    equations: &Equations,
    i: usize,
    letters: &Letters,
) -> [Expression; 2] {
    let force = equations.generalized_forces[i];
    let mut terms = Vec::new();
    for (j, entry) in (0..).zip(&equations.mass[i]) {
        let entry = graph.arranged(*entry, letters);
        let acceleration = graph.symbol(Symbol::Acceleration(j));
        terms.push((graph.multiply(entry, acceleration), Rational::ONE));
    }
    let rest = graph.subtract(force, equations.forcing[i]);
    let rest = graph.arranged_by_velocities(rest, letters);
    terms.push((rest, Rational::ONE));
    [graph.sum(terms), graph.arranged(force, letters)]
}

/// The sentence that these quantities are constant.
fn are_constant(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [one] => format!("{one} is constant."),
        [others @ .., last] => format!("{} and {last} are constant.", others.join(", ")),
    }
}

/// The name of a definition without its first index, or without the letter of a component.
fn family(name: &str) -> (&str, &str) {
    let Some((stem, rest)) = name.split_once('[') else {
        return (name.split_once('.').map_or(name, |(stem, _)| stem), "");
    };
    (stem, rest.split_once(']').map_or("", |(_, rest)| rest))
}

/// Whether an expression is a number, a symbol or a function, which has no name even in a family.
fn is_a_letter(graph: &Graph, expression: Expression) -> bool {
    let node = graph.node(expression);
    matches!(
        node,
        Node::Constant(_) | Node::Pi | Node::Symbol(_) | Node::Unary(..)
    )
}

/// Whether a definition is longer than a letter or a single product, which are as easily read as its name.
fn is_worth_a_name(graph: &Graph, expression: Expression) -> bool {
    match graph.node(expression) {
        Node::Constant(_) | Node::Pi | Node::Symbol(_) | Node::Unary(..) | Node::Opaque(_) => false,
        Node::Sum(terms) => terms.len() > 1,
        Node::Product(factors) => factors
            .iter()
            .any(|(base, k)| matches!(graph.node(*base), Node::Sum(_)) || k.is_negative()),
        Node::Binary(..) | Node::Application(..) => true,
    }
}

/// The names of quasi-velocities: those that the user gave them, else a letter that is not used, with a number.
fn quasi_velocity_names(graph: &Graph, names: &Names, forms: &[Expression]) -> Vec<String> {
    let taken = |letter: &str| names.all().any(|name| name.starts_with(letter));
    let letters = ["w", "omega", "u", "s", "eta", "nu", "quasi_velocity"];
    let letter = letters.into_iter().find(|letter| !taken(letter));
    let letter = letter.unwrap_or("quasi_velocity_");
    let mut unnamed = 0;
    let named = forms.iter().map(|form| {
        let named = names.definitions.get(form);
        named.cloned().unwrap_or_else(|| {
            unnamed += u32::from(!is_velocity(graph, *form));
            format!("{letter}{unnamed}")
        })
    });
    named.collect()
}

fn is_velocity(graph: &Graph, form: Expression) -> bool {
    matches!(graph.node(form), Node::Symbol(Symbol::Velocity(_)))
}
