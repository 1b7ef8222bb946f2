//! The names of symbols and subexpressions.

use std::collections::{BTreeMap, BTreeSet};

use crate::print::listing::index_letters::IndexLetters;
use crate::print::notation::Notation;
use crate::print::printed::{Part, Printed};
use crate::print::size::WrittenSizes;
use crate::print::spelling::Spelling;
use crate::{Expression, Symbol};

/// The names under which a formula is printed.
///
/// They are written as in Rust and printed as in a book: `theta` as θ, `l1` as l₁, `c_phi` as `c_φ`, `x_hat` as x̂,
/// the velocity of `theta` as θ̇, and a parameter `i1`, a moment of inertia, as I₁. A symbol without a name is called by its kind and number.
#[derive(Clone, Debug, Default)]
pub struct Names {
    /// The names of the coordinates, in order; velocities and accelerations are those with dots.
    pub coordinates: Vec<String>,
    /// The names of the parameters, in order.
    pub parameters: Vec<String>,
    /// The names of the inputs, in order.
    pub inputs: Vec<String>,
    /// The names of the quasi-velocities, in order; their rates have the same names with dots.
    pub quasi_velocities: Vec<String>,
    /// The names of the multipliers of constraints, in order.
    pub multipliers: Vec<String>,
    /// Expressions that are printed by name wherever they occur within others.
    pub definitions: BTreeMap<Expression, String>,
}

/// Names as they are spelled in print, no two alike.
#[derive(Clone, Debug)]
pub struct Letters {
    symbols: BTreeMap<Symbol, Spelling>,
    definitions: BTreeMap<Expression, Printed>,
    /// By expression, whether it is printed by name: this is asked of every part of what is printed.
    is_named: Vec<bool>,
    /// The names that are printed as they are written.
    as_written: BTreeSet<String>,
    /// How long expressions are in these letters.
    pub(crate) sizes: WrittenSizes,
}

impl Letters {
    /// The letters in which `names` are printed.
    #[must_use]
    pub fn new(names: &Names) -> Self {
        let symbols = names.symbols().map(|(symbol, name)| {
            let spelling = match symbol {
                Symbol::Parameter(_) => Spelling::of_parameter(name),
                _ => Spelling::of(name),
            };
            (symbol, (name, spelling))
        });
        let symbols: Vec<_> = symbols.collect();
        let definitions = names.definitions.iter();
        let definitions: Vec<_> = definitions
            .map(|(x, name)| (*x, (name.as_str(), Spelling::of(name))))
            .collect();
        let all = symbols.iter().map(|(_, named)| named);
        let all = all.chain(definitions.iter().map(|(_, named)| named));
        let mut spelled = Collisions::default();
        for (name, spelling) in all.clone() {
            spelled.note(name, spelling);
        }
        let as_written = all.filter(|(name, spelling)| spelled.is_ambiguous(name, spelling));
        let as_written = as_written.map(|(name, _)| (*name).to_owned()).collect();
        let symbols = symbols.into_iter();
        let mut letters = Self {
            symbols: symbols
                .map(|(symbol, (name, spelling))| (symbol, spelled.spelling(name, spelling)))
                .collect(),
            definitions: BTreeMap::new(),
            is_named: Vec::new(),
            as_written,
            sizes: WrittenSizes::default(),
        };
        for (x, (name, spelling)) in definitions {
            letters.call(x, Printed(Part::Name(spelled.spelling(name, spelling))));
        }
        letters
    }

    /// The names that are printed as they are written, since they would look like others.
    pub(crate) const fn as_written(&self) -> &BTreeSet<String> {
        &self.as_written
    }

    /// A symbol as it is printed, such as θ̇.
    pub(crate) fn printed(&self, symbol: Symbol) -> Printed {
        Printed(Part::Name(self.symbol(symbol)))
    }

    /// All names as they are printed in Unicode.
    pub(crate) fn all_printed(&self) -> impl Iterator<Item = String> {
        self.spellings()
            .map(|spelling| spelling.print(Notation::Unicode))
    }

    /// The letters of indices, which are those of no name.
    pub(crate) fn index_letters(&self) -> IndexLetters {
        IndexLetters::free(&self.spellings().map(Spelling::stem).collect())
    }

    fn spellings(&self) -> impl Iterator<Item = &Spelling> {
        let definitions = self.definitions.values();
        let definitions = definitions.filter_map(|name| match &name.0 {
            Part::Name(spelling) => Some(spelling),
            _ => None,
        });
        self.symbols.values().chain(definitions)
    }

    /// The same letters without definitions.
    pub(crate) fn of_symbols(&self) -> Self {
        Self {
            definitions: BTreeMap::new(),
            is_named: Vec::new(),
            sizes: WrittenSizes::default(),
            ..self.clone()
        }
    }

    /// Prints one more expression by what it is called.
    pub(crate) fn call(&mut self, expression: Expression, name: Printed) {
        self.definitions.insert(expression, name);
        let place = expression.index();
        let length = self.is_named.len().max(place + 1);
        self.is_named.resize(length, false);
        self.is_named[place] = true;
    }

    /// The expressions that are printed by name.
    pub(crate) fn named(&self) -> impl Iterator<Item = Expression> {
        self.definitions.keys().copied()
    }

    /// The name of a subexpression, if it has one.
    pub(crate) fn definition(&self, expression: Expression) -> Option<&Printed> {
        match self.is_named.get(expression.index()) {
            Some(true) => self.definitions.get(&expression),
            _ => None,
        }
    }

    /// The name of a symbol with dots above it.
    pub(crate) fn symbol(&self, symbol: Symbol) -> Spelling {
        let (base, dots) = match symbol {
            Symbol::Velocity(index) => (Symbol::Coordinate(index), 1),
            // Multipliers are accelerations of further coordinates.
            Symbol::Acceleration(index) if !self.symbols.contains_key(&symbol) => {
                (Symbol::Coordinate(index), 2)
            }
            Symbol::QuasiVelocityRate(index) => (Symbol::QuasiVelocity(index), 1),
            other => (other, 0),
        };
        if let Some(spelling) = self.symbols.get(&base) {
            return spelling.clone().with_dots(dots);
        }
        let (letter, index) = match base {
            Symbol::Time => return Spelling::of("t"),
            Symbol::Order | Symbol::ReciprocalOrder => return Spelling::of("k"),
            Symbol::Coordinate(index) | Symbol::Velocity(index) | Symbol::Acceleration(index) => {
                ("q", index)
            }
            Symbol::Parameter(index) => ("p", index),
            Symbol::Input(index) => ("u", index),
            Symbol::Invariant(index) => ("c", index),
            Symbol::Argument(index) => ("x", index),
            Symbol::Convolution(index) => ("s", index),
            Symbol::PositionComponent(index) | Symbol::RightHandSide(index) => ("r", index),
            Symbol::QuasiVelocity(index)
            | Symbol::QuasiVelocityRate(index)
            | Symbol::VelocityComponent(index) => ("w", index),
            Symbol::Variation(index) => ("delta", index),
        };
        let name = format!("{letter}{}", u64::from(index) + 1);
        Spelling::of(&name).with_dots(dots)
    }
}

/// The names of symbols of one kind, and with which number they begin.
type Kind<'a> = (&'a [String], fn(u32) -> Symbol, usize);

impl Names {
    pub(crate) fn all(&self) -> impl Iterator<Item = &str> {
        let definitions = self.definitions.values().map(String::as_str);
        self.symbols().map(|(_, name)| name).chain(definitions)
    }

    /// The symbols that have names.
    fn symbols(&self) -> impl Iterator<Item = (Symbol, &str)> {
        let coordinates = self.coordinates.len();
        let lists: [Kind<'_>; 5] = [
            (&self.coordinates, Symbol::Coordinate, 0),
            (&self.inputs, Symbol::Input, 0),
            (&self.quasi_velocities, Symbol::QuasiVelocity, 0),
            (&self.multipliers, Symbol::Acceleration, coordinates),
            (&self.parameters, Symbol::Parameter, 0),
        ];
        lists.into_iter().flat_map(|(names, symbol, first)| {
            let first = u32::try_from(first).unwrap_or(u32::MAX);
            let named = (first..).zip(names);
            named.map(move |(index, name)| (symbol(index), name.as_str()))
        })
    }
}

/// Finds names that would be printed alike, such as `i1` and `i_1`; those are printed as written. Of one family, the members
/// keep their indices, which no name on the line has.
#[derive(Default)]
struct Collisions {
    /// By what is printed, the names.
    seen: BTreeMap<String, BTreeSet<String>>,
}

impl Collisions {
    fn note(&mut self, name: &str, spelling: &Spelling) {
        let printed = spelling.print(Notation::Unicode);
        self.seen.entry(printed).or_default().insert(name.into());
    }

    /// What a name is printed as.
    fn spelling(&self, name: &str, spelling: Spelling) -> Spelling {
        if self.is_ambiguous(name, &spelling) {
            Spelling::verbatim(name)
        } else {
            spelling
        }
    }

    fn is_ambiguous(&self, name: &str, spelling: &Spelling) -> bool {
        let printed = spelling.print(Notation::Unicode);
        // The number π is printed by that letter alone.
        if printed == "π" {
            return true;
        }
        let Some(names) = self.seen.get(&printed).filter(|names| names.len() > 1) else {
            return false;
        };
        let indexed = names.iter().filter(|name| name.contains('['));
        !name.contains('[') || indexed.count() > 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_would_look_alike_are_printed_as_written() {
        let names = Names {
            parameters: [
                "l1", "l_1", "theta", "pi", "x12", "x1_2", "i_s", "I_s", "i3", "k1", "k[1]",
            ]
            .map(String::from)
            .into(),
            coordinates: vec!["i3".into(), "i4".into()],
            ..Names::default()
        };
        let letters = Letters::new(&names);
        let printed = |index| {
            letters
                .symbol(Symbol::Parameter(index))
                .print(Notation::Unicode)
        };
        assert_eq!([0, 1, 2, 3].map(printed), ["l1", "l_1", "θ", "pi"]);
        assert_eq!([4, 5].map(printed), ["x12", "x1_2"]);
        assert_eq!([6, 7].map(printed), ["i_s", "I_s"]);
        assert_eq!([8, 9, 10, 11].map(printed), ["I₃", "k1", "k₁", "p₁₂"]);
        let coordinate = letters.symbol(Symbol::Coordinate(0));
        assert_eq!(coordinate.print(Notation::Unicode), "i₃");
    }
}
