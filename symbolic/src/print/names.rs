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
    coordinates: Vec<Spelling>,
    parameters: Vec<Spelling>,
    inputs: Vec<Spelling>,
    quasi_velocities: Vec<Spelling>,
    multipliers: Vec<Spelling>,
    definitions: BTreeMap<Expression, Printed>,
    /// By expression, whether it is printed by name: this is asked of every part of what is printed.
    is_named: Vec<bool>,
    /// The names that are printed as they are written.
    as_written: BTreeSet<String>,
    /// How long expressions are in these letters.
    pub(crate) sizes: WrittenSizes,
}

/// Notes that an expression is printed by name.
fn note(is_named: &mut Vec<bool>, expression: Expression) {
    if expression.index() >= is_named.len() {
        is_named.resize(expression.index() + 1, false);
    }
    is_named[expression.index()] = true;
}

impl Letters {
    /// The letters in which `names` are printed.
    #[must_use]
    pub fn new(names: &Names) -> Self {
        let mut spelled = Collisions::default();
        for name in &names.parameters {
            spelled.note(name, &Spelling::of_parameter(name));
        }
        for name in names.all_but_parameters() {
            spelled.note(name, &Spelling::of(name));
        }
        let spelling = |name: &String| spelled.spelling(name, Spelling::of(name));
        let ambiguous = |name: &str, spelling| spelled.is_ambiguous(name, &spelling);
        let of_parameters = names.parameters.iter();
        let of_parameters =
            of_parameters.filter(|name| ambiguous(name, Spelling::of_parameter(name)));
        let others = names.all_but_parameters();
        let others = others.filter(|name| ambiguous(name, Spelling::of(name)));
        let as_written = of_parameters.map(String::as_str).chain(others);
        let as_written = as_written.map(str::to_owned).collect();
        let list = |names: &[String]| names.iter().map(spelling).collect();
        let parameters = names.parameters.iter();
        let parameters =
            parameters.map(|name| spelled.spelling(name, Spelling::of_parameter(name)));
        let mut is_named = Vec::new();
        for expression in names.definitions.keys() {
            note(&mut is_named, *expression);
        }
        Self {
            is_named,
            coordinates: list(&names.coordinates),
            parameters: parameters.collect(),
            inputs: list(&names.inputs),
            quasi_velocities: list(&names.quasi_velocities),
            multipliers: list(&names.multipliers),
            definitions: names
                .definitions
                .iter()
                .map(|(expression, name)| (*expression, Printed(Part::Name(spelling(name)))))
                .collect(),
            as_written,
            sizes: WrittenSizes::default(),
        }
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
        let lists = [
            &self.coordinates,
            &self.parameters,
            &self.inputs,
            &self.quasi_velocities,
            &self.multipliers,
        ];
        let definitions = self.definitions.values();
        let definitions = definitions.filter_map(|name| match &name.0 {
            Part::Name(spelling) => Some(spelling),
            _ => None,
        });
        lists.into_iter().flatten().chain(definitions)
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
        note(&mut self.is_named, expression);
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
        let find = |list: &[Spelling], letter: &str, index: u32| {
            list.get(index as usize)
                .cloned()
                .unwrap_or_else(|| Spelling::of(&format!("{letter}{}", u64::from(index) + 1)))
        };
        match symbol {
            Symbol::Time => Spelling::of("t"),
            Symbol::Coordinate(index) => find(&self.coordinates, "q", index),
            Symbol::Velocity(index) => find(&self.coordinates, "q", index).with_dots(1),
            Symbol::Acceleration(index) => {
                let coordinates = u32::try_from(self.coordinates.len()).unwrap_or(u32::MAX);
                match index.checked_sub(coordinates) {
                    Some(index) if !self.multipliers.is_empty() => {
                        find(&self.multipliers, "lambda", index)
                    }
                    _ => find(&self.coordinates, "q", index).with_dots(2),
                }
            }
            Symbol::Parameter(index) => find(&self.parameters, "p", index),
            Symbol::Input(index) => find(&self.inputs, "u", index),
            Symbol::Invariant(index) => find(&[], "c", index),
            Symbol::Argument(index) => find(&[], "x", index),
            Symbol::Order | Symbol::ReciprocalOrder => Spelling::of("k"),
            Symbol::Convolution(index) => find(&[], "s", index),
            Symbol::PositionComponent(index) | Symbol::RightHandSide(index) => {
                find(&[], "r", index)
            }
            Symbol::QuasiVelocity(index) => find(&self.quasi_velocities, "w", index),
            Symbol::QuasiVelocityRate(index) => {
                find(&self.quasi_velocities, "w", index).with_dots(1)
            }
            Symbol::VelocityComponent(index) => find(&[], "w", index),
            Symbol::Variation(index) => find(&[], "delta", index),
        }
    }
}

impl Names {
    pub(crate) fn all(&self) -> impl Iterator<Item = &str> {
        let parameters = self.parameters.iter().map(String::as_str);
        self.all_but_parameters().chain(parameters)
    }

    fn all_but_parameters(&self) -> impl Iterator<Item = &str> {
        let lists = [
            &self.coordinates,
            &self.inputs,
            &self.quasi_velocities,
            &self.multipliers,
        ];
        let definitions = self.definitions.values();
        lists
            .into_iter()
            .flatten()
            .chain(definitions)
            .map(String::as_str)
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
