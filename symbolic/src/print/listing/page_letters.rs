//! The letters of a page that are no names of the model: T, V, L and h, the momenta p, and so on. Where the model has a name
//! that is printed so, another letter takes its place, and the page says so.

use std::collections::BTreeSet;

use crate::Symbol;
use crate::print::listing::Declared;
use crate::print::names::Letters;
use crate::print::notation::Notation;
use crate::print::printed::Printed;
use crate::print::spelling::Spelling;

/// A quantity that the page itself names.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Quantity {
    Coordinates,
    Momenta,
    Kinetic,
    Potential,
    Lagrangian,
    EnergyFunction,
    Forces,
}

/// What a quantity is, and its letters in Unicode and in LaTeX, of which the first one that is free is taken.
type Row = (Quantity, &'static str, &'static [[&'static str; 2]]);

const QUANTITIES: [Row; 7] = [
    (
        Quantity::Coordinates,
        "all coordinates",
        &[["q", "q"], ["ξ", "\\xi"], ["𝐪", "\\mathbf{q}"]],
    ),
    (
        Quantity::Momenta,
        "momenta",
        &[["p", "p"], ["P", "P"], ["𝐩", "\\mathbf{p}"]],
    ),
    (
        Quantity::Kinetic,
        "the kinetic energy",
        &[["T", "T"], ["K", "K"], ["E_kin", "E_{\\mathrm{kin}}"]],
    ),
    (
        Quantity::Potential,
        "the potential energy",
        &[["V", "V"], ["U", "U"], ["E_pot", "E_{\\mathrm{pot}}"]],
    ),
    (
        Quantity::Lagrangian,
        "the Lagrangian function",
        &[["L", "L"], ["ℒ", "\\mathcal{L}"]],
    ),
    (
        Quantity::EnergyFunction,
        "the energy function",
        &[["h", "h"], ["E", "E"], ["E_h", "E_{h}"]],
    ),
    (
        Quantity::Forces,
        "generalized forces",
        &[["Q", "Q"], ["F", "F"], ["𝐐", "\\mathbf{Q}"]],
    ),
];

/// The letters of a page.
#[derive(Clone, Debug)]
pub(crate) struct PageLetters {
    chosen: [[&'static str; 2]; 7],
    /// What is said of letters that are others than usual, in Unicode and in LaTeX.
    pub(crate) sentences: Vec<[String; 2]>,
}

impl PageLetters {
    /// Letters that no name of the model is printed as.
    pub(crate) fn of(declared: &Declared, letters: &Letters) -> Self {
        let definitions = declared.definitions.iter();
        let definitions = definitions.map(|(name, _)| Spelling::of(name).print(Notation::Unicode));
        let printed: BTreeSet<String> = letters.all_printed().chain(definitions).collect();
        let names = &declared.names;
        let components = [&names.coordinates, &names.parameters, &names.inputs];
        let components = components.into_iter().flatten();
        let vectors = components.filter_map(|name| Some(name.split_once('.')?.0));
        let vectors: BTreeSet<String> = vectors
            .map(|name| Spelling::of(name).print(Notation::Unicode))
            .collect();
        let count = u32::try_from(declared.names.coordinates.len()).unwrap_or(0);
        let coordinates: Vec<_> = (0..count)
            .map(|i| {
                letters
                    .symbol(Symbol::Coordinate(i))
                    .print(Notation::Unicode)
            })
            .collect();
        let only = match coordinates.as_slice() {
            [only] => only.as_str(),
            _ => "",
        };
        let is_free = |quantity, letter: &str| match quantity {
            // Of one coordinate that is called q, q is that coordinate.
            Quantity::Coordinates => letter == only || !printed.contains(letter),
            Quantity::Momenta => {
                let mut momenta = coordinates.iter().map(|name| format!("{letter}_{name}"));
                momenta.all(|name| !printed.contains(&name)) && !printed.contains(letter)
            }
            _ => !printed.contains(letter) && !vectors.contains(letter),
        };
        let mut sentences = Vec::new();
        let chosen = QUANTITIES.map(|(quantity, what, candidates)| {
            let mut free = candidates.iter();
            let free = free.find(|letters| is_free(quantity, letters[0]));
            let last = candidates[candidates.len() - 1];
            let [unicode, latex] = *free.unwrap_or(&last);
            let [usual, _] = candidates[0];
            if unicode != usual {
                let verb = if what.ends_with('s') || what == "momenta" {
                    "are"
                } else {
                    "is"
                };
                let reason = format!("{verb} {what}, since a name of the model is printed as");
                let usual = usual.to_owned()
                    + if what == "momenta" {
                        " or begins so"
                    } else {
                        ""
                    };
                sentences.push([
                    format!("{unicode} {reason} {usual}."),
                    format!("${latex}$ {reason} {usual}."),
                ]);
            }
            [unicode, latex]
        });
        Self { chosen, sentences }
    }

    /// The letter of a quantity.
    pub(crate) fn letter(&self, quantity: Quantity) -> Printed {
        Printed::text(self.signs(quantity))
    }

    /// The letter of a quantity in Unicode and in LaTeX.
    pub(crate) fn signs(&self, quantity: Quantity) -> [&'static str; 2] {
        let mut all = QUANTITIES.iter().zip(self.chosen);
        all.find(|((other, ..), _)| *other == quantity)
            .map_or(["", ""], |(_, letter)| letter)
    }

    /// A text in which `{q}`, `{p}`, `{T}`, `{V}`, `{L}`, `{h}` and `{Q}` stand for the letters.
    pub(crate) fn text(&self, template: &str, notation: Notation) -> String {
        let place = usize::from(notation == Notation::Latex);
        let mut text = template.to_owned();
        for ((_, _, candidates), chosen) in QUANTITIES.iter().zip(self.chosen) {
            text = text.replace(&format!("{{{}}}", candidates[0][0]), chosen[place]);
        }
        text
    }

    /// A template with the letters of the page, as a formula.
    pub(crate) fn printed(&self, templates: [&str; 2]) -> Printed {
        Printed::text(self.texts(templates).each_ref().map(|text| &**text))
    }

    /// The same in both notations.
    pub(crate) fn texts(&self, [unicode, latex]: [&str; 2]) -> [String; 2] {
        [
            self.text(unicode, Notation::Unicode),
            self.text(latex, Notation::Latex),
        ]
    }
}
