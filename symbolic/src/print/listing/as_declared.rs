//! Equations as they were declared, with their vectors and their sums, for what is long when it is written out.

use std::collections::BTreeSet;

use crate::print::folding::token::{lowered, raised};
use crate::print::notation::Notation;
use crate::print::spelling::Spelling;

/// A line that is printed as it was declared, in Unicode and in LaTeX.
#[derive(Clone, Debug, Default)]
pub struct DeclaredLine {
    /// What is defined: the name of a definition, or T, V or L.
    pub name: String,
    /// The left side.
    pub left: [String; 2],
    /// The right side.
    pub right: [String; 2],
    /// The definitions that the right side mentions.
    pub mentions: BTreeSet<String>,
}

/// The energies and the definitions as they were declared, as far as they can be printed.
#[derive(Clone, Debug, Default)]
pub struct AsDeclared {
    /// T and V, or L.
    pub energies: Vec<DeclaredLine>,
    /// The definitions, in order.
    pub definitions: Vec<DeclaredLine>,
}

impl AsDeclared {
    /// The definitions that are mentioned, and those that these mention.
    pub(crate) fn definitions_of(&self, mentioned: &BTreeSet<String>) -> Vec<&DeclaredLine> {
        let mut needed = mentioned.clone();
        // A definition mentions those before it, and members of its own family.
        for line in self.definitions.iter().rev() {
            if needed.contains(&line.name) {
                needed.extend(line.mentions.iter().cloned());
            }
        }
        let lines = self.definitions.iter();
        lines.filter(|line| needed.contains(&line.name)).collect()
    }
}

/// A name with indices behind it, and dots above it, in Unicode and in LaTeX. Indices are sums of variables and integers,
/// or letters of axes; integers are marked for the listing, which folds what differs in them only.
#[must_use]
pub fn print_with_indices(
    name: &str,
    is_parameter: bool,
    indices: &[String],
    dots: usize,
) -> [String; 2] {
    let spelling = if is_parameter {
        Spelling::of_parameter(name)
    } else {
        Spelling::of(name)
    };
    [Notation::Unicode, Notation::Latex]
        .map(|notation| spelling.print_with_indices(indices, dots, notation))
}

/// The values of an index: `i = 0, …, 19`, or one by one where they are three.
#[must_use]
pub fn print_range(variable: &str, first: &str, last: &str) -> [String; 2] {
    if first == last {
        return [
            format!("{variable} = {}", first.replace('-', "−")),
            format!("{variable} = {first}"),
        ];
    }
    let between = match (first.parse::<i64>(), last.parse::<i64>()) {
        (Ok(first), Ok(last)) if last - first == 1 => {
            let minus = |index: i64| index.to_string().replace('-', "−");
            return [
                format!("{variable} = {}, {}", minus(first), minus(last)),
                format!("{variable} = {first}, {last}"),
            ];
        }
        (Ok(first), Ok(last)) if last - first == 2 => {
            [(first + 1).to_string(), (first + 1).to_string()]
        }
        _ => ["…".to_owned(), "\\ldots".to_owned()],
    };
    let [unicode, latex] = between;
    let minus = |text: &str| text.replace('-', "−");
    [
        format!("{variable} = {}, {unicode}, {}", minus(first), minus(last)),
        format!("{variable} = {first}, {latex}, {last}"),
    ]
}

/// The sign of a sum, with its bounds.
#[must_use]
pub fn print_sum_sign(variable: &str, first: &str, last: &str) -> [String; 2] {
    let below = format!("{variable}={first}");
    let (lower, upper) = (lowered(&below).replace('=', "₌"), raised(last));
    let is_plain = |text: &str| text.chars().any(|c| c.is_ascii());
    let unicode = if is_plain(&lower) || is_plain(&upper) {
        format!("Σ_({below})^({last}) ")
    } else {
        format!("Σ{lower}{upper} ")
    };
    [unicode, format!("\\sum_{{{below}}}^{{{last}}} ")]
}
