//! The statements of the recursion of Newton and Euler in Unicode and in LaTeX.

use std::collections::BTreeMap;

use crate::print::names::Names;
use crate::print::notation::Notation;
use crate::print::spelling::Spelling;

/// What occurs in the statements: a letter for it, and how it may be called, the first that no name of the model has.
const QUANTITIES: [(char, &[&str]); 11] = [
    ('R', &["R", "A", "Q"]),
    ('D', &["s", "d", "b", "place"]),
    ('S', &["sigma", "nu", "eta", "rate"]),
    ('W', &["omega", "Omega", "w", "angular_velocity"]),
    ('A', &["a", "alpha", "acceleration"]),
    ('M', &["m", "mu", "M", "mass"]),
    ('C', &["c", "rho", "e", "center"]),
    ('I', &["I", "J", "Theta", "inertia"]),
    ('F', &["F", "K", "inertial_force"]),
    ('P', &["f", "phi", "force"]),
    ('N', &["n", "N", "tau", "moment"]),
];

/// From the root to the leaves: b is the link before i. What stands behind `|` is there if a link slides along the one before.
const OUTWARD: [&str; 4] = [
    "W[i] = R[i]' W[b] + S[i]",
    "W.[i] = R[i]' W.[b] + R[i]' W[b] × S[i] + S.[i]",
    "A[i] = R[i]' (A[b] + W.[b] × D[i] + W[b] × (W[b] × D[i])| + 2 W[b] × D.[i] + D..[i])",
    "F[i] = M[i] (A[i] + W.[i] × C[i] + W[i] × (W[i] × C[i]))",
];
/// And back: the links j behind i.
const INWARD: [&str; 2] = [
    "P[i] = F[i] + #R[j] P[j]",
    "N[i] = I[i] W.[i] + W[i] × I[i] W[i] + C[i] × F[i] + #{R[j] N[j] + D[j] × R[j] P[j]}",
];

/// How the quantities of links are called.
#[derive(Clone, Debug)]
pub(crate) struct LinkLetters(BTreeMap<char, Spelling>);

impl LinkLetters {
    /// Letters that no name of the model has, nor one of its definitions.
    pub(crate) fn free(names: &Names, definitions: &[(String, crate::Expression)]) -> Self {
        let defined = definitions.iter().map(|(name, _)| name.as_str());
        let printed = |name: &str| {
            let spellings = [Spelling::of(name), Spelling::of_parameter(name)];
            spellings.map(|spelling| spelling.print(0, Notation::Unicode))
        };
        let taken: Vec<_> = names.all().chain(defined).flat_map(printed).collect();
        let is_free = |letter: &Spelling| {
            let letter = letter.print(0, Notation::Unicode);
            taken.iter().all(|name| match name.strip_prefix(&*letter) {
                Some(rest) => rest.starts_with(char::is_alphabetic),
                None => true,
            })
        };
        let letters = QUANTITIES.iter().map(|(quantity, candidates)| {
            let mut spellings = candidates.iter().map(|name| Spelling::of(name));
            let last = candidates.last().copied().unwrap_or_default();
            let free = spellings.find(is_free);
            (*quantity, free.unwrap_or_else(|| Spelling::verbatim(last)))
        });
        Self(letters.collect())
    }

    /// Calls a quantity by a name of the model.
    pub(crate) fn call(&mut self, quantity: char, spelling: Spelling) {
        self.0.insert(quantity, spelling);
    }

    /// A quantity of a link, with dots above it.
    pub(crate) fn quantity(&self, quantity: char, dots: usize, index: &str) -> [String; 2] {
        let Some(spelling) = self.0.get(&quantity) else {
            return Default::default();
        };
        let index = [index.to_owned()];
        [Notation::Unicode, Notation::Latex]
            .map(|notation| spelling.print_with_indices(&index, dots, notation))
    }

    /// The statements for link i, each as its left and its right side. Of a chain, the link before is i − 1; else it is called p.
    pub(crate) fn statements(&self, is_chain: bool, slides: bool) -> Vec<[[String; 2]; 2]> {
        let all = OUTWARD.iter().chain(&INWARD);
        let statements = all.map(|statement| {
            let statement = match statement.split_once('|') {
                None => (*statement).to_owned(),
                Some((whole, sliding)) if slides => format!("{whole}{sliding}"),
                // The bracket that the terms of sliding are in.
                Some((whole, _)) => format!("{whole})"),
            };
            let (left, right) = statement.split_once(" = ").unwrap_or_default();
            [left, right].map(|side| self.statement(side, is_chain))
        });
        statements.collect()
    }

    fn statement(&self, text: &str, is_chain: bool) -> [String; 2] {
        let mut written = [String::new(), String::new()];
        let mut rest = text.chars();
        while let Some(c) = rest.next() {
            let both = match c {
                '#' | '{' | '}' if is_chain => ["", ""].map(String::from),
                '#' => ["Σⱼ ", "\\sum_j "].map(String::from),
                '{' => ["(", "("].map(String::from),
                '}' => [")", ")"].map(String::from),
                '×' => ["×", "\\times"].map(String::from),
                '\'' => ["ᵀ", "^{T}"].map(String::from),
                c if c.is_ascii_uppercase() => {
                    let dotted: String = rest.by_ref().take_while(|c| *c != '[').collect();
                    let index: String = rest.by_ref().take_while(|c| *c != ']').collect();
                    let index = match (&*index, is_chain) {
                        ("b", true) => "i-1",
                        ("b", false) => "p",
                        ("j", true) => "i+1",
                        (index, _) => index,
                    };
                    self.quantity(c, dotted.len(), index)
                }
                c => [c, c].map(String::from),
            };
            for (text, part) in written.iter_mut().zip(both) {
                text.push_str(&part);
            }
        }
        written
    }
}

/// A component along an axis of a link: `n₂_z`.
pub(crate) fn component([unicode, latex]: [String; 2], axis: usize) -> [String; 2] {
    let axis = ["x", "y", "z"][axis];
    let latex = match latex.strip_suffix('}') {
        Some(indexed) => format!("{indexed},{axis}}}"),
        None => format!("{latex}_{axis}"),
    };
    [format!("{unicode}_{axis}"), latex]
}
