//! The coordinates of a model.

use crate::print::listing::composer::Composer;
use crate::print::listing::page_letters::Quantity;
use crate::print::listing::section::Section;
use crate::print::printed::Printed;
use crate::{Binary, Energies, Expression, Node, Symbol};

impl Composer<'_> {
    /// The coordinates by name.
    pub(crate) fn coordinates(&mut self) -> Section {
        let symbols = self.model.coordinate_symbols();
        let names = symbols
            .into_iter()
            .map(|symbol| self.letters.printed(symbol));
        let mut names: Vec<_> = names.collect();
        let list = match names.as_slice() {
            [_] => names.swap_remove(0),
            _ => Printed::within([["(", ")"]; 2], names),
        };
        let mut section = Section::new(None, "`COORDINATES`");
        let letter = self.page.letter(Quantity::Coordinates);
        self.push_arranged(&mut section, letter, list);
        let mut sentences = self.page.sentences.clone();
        sentences.extend(self.names_as_written());
        if let Some(kind) = self.what_is_raised_as_e() {
            sentences.push([
                format!("e is {kind}; the exponential function is exp."),
                format!("$e$ is {kind}; the exponential function is $\\exp$."),
            ]);
        }
        section.sentence = [0, 1].map(|notation| {
            let sentences: Vec<_> = sentences.iter().map(|texts| &*texts[notation]).collect();
            sentences.join("\n")
        });
        section
    }

    /// What is said of names that are printed as they are written.
    fn names_as_written(&self) -> Option<[String; 2]> {
        let names = self.letters.as_written().iter();
        // π is a number, which a name alone is not like.
        let names: Vec<_> = names.map(String::as_str).collect();
        let [first @ .., last] = &*names else {
            return None;
        };
        let (list, verb) = match first {
            [] => ((*last).to_owned(), "is"),
            first => (format!("{} and {last}", first.join(", ")), "are"),
        };
        let reason = "as in the declaration, since by letters it would look like another.";
        let reason = if first.is_empty() {
            reason.to_owned()
        } else {
            reason.replace("it would look like another", "they would look like others")
        };
        let unicode = format!("{list} {verb} printed {reason}");
        let latex = unicode.replace('_', "\\_");
        Some([unicode, latex])
    }

    /// What is called e, if the equations contain a power of it, which would be read as the exponential function.
    fn what_is_raised_as_e(&mut self) -> Option<&'static str> {
        let names = &self.declared.names;
        let place = |names: &[String]| {
            let place = names.iter().position(|name| name == "e")?;
            u32::try_from(place).ok()
        };
        let parameter = place(&names.parameters).map(Symbol::Parameter);
        let coordinate = place(&names.coordinates).map(Symbol::Coordinate);
        let input = place(&names.inputs).map(Symbol::Input);
        let kinds = ["a parameter", "a coordinate", "an input"];
        let called = [parameter, coordinate, input].into_iter().zip(kinds);
        let called = called.filter_map(|(symbol, kind)| Some((symbol?, kind)));
        let mut definitions = self.declared.definitions.iter();
        let defined = definitions.find(|(name, _)| name == "e");
        let graph = &mut self.model.graph;
        let called = called.map(|(symbol, kind)| (graph.symbol(symbol), kind));
        let defined = defined.map(|(_, x)| (*x, "a definition"));
        let (base, kind) = called.chain(defined).next()?;
        let is_power = |part: &Expression| match graph.node(*part) {
            Node::Binary(Binary::Power, x, _) => *x == base,
            Node::Product(factors) => factors.iter().any(|(x, k)| *x == base && !k.is_one()),
            _ => false,
        };
        let mut roots = self.mentioned.clone();
        match self.energies {
            Energies::Natural { kinetic, potential } => roots.extend([kinetic, potential]),
            Energies::General(lagrangian) => roots.push(lagrangian),
        }
        let parts = graph.descendants(&roots);
        parts.iter().any(is_power).then_some(kind)
    }
}
