//! What stands below the line behind a letter: indices of families, and other numbers and words.

use crate::print::notation::{Notation, lowered, raised};
use crate::print::spelling::latex_letter;

/// Something below the line.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Index {
    /// A letter, a word, or a number that counts no members.
    Word(String),
    /// The member of a family with a number,
    Number(i64),
    /// or with the number that a variable and an integer are together.
    Variable(String, i64),
    /// The member with the greatest or the least of some numbers, of which this says which and what they are.
    Extreme(&'static str, String),
}

impl Index {
    /// The index as it stands on the line.
    pub(crate) fn text(&self) -> String {
        match self {
            Self::Word(text) | Self::Variable(text, 0) => text.clone(),
            Self::Number(number) => number.to_string(),
            Self::Variable(variable, offset) => format!("{variable}{offset:+}"),
            Self::Extreme(which, of) => format!("{which}({of})"),
        }
    }

    pub(crate) fn latex(&self) -> String {
        match self {
            Self::Number(number) => number.to_string(),
            Self::Extreme(..) => format!("\\{}", self.text()),
            Self::Word(_) | Self::Variable(..) => latex_letter(&self.text()),
        }
    }

    /// The index plus a number; a word stays as it is.
    #[must_use]
    pub fn plus(self, number: i64) -> Self {
        match self {
            Self::Number(own) => Self::Number(own + number),
            Self::Variable(variable, offset) => Self::Variable(variable, offset + number),
            other => other,
        }
    }

    /// Whether it is a word, which would run into what follows.
    pub(crate) fn is_word(&self) -> bool {
        match self {
            Self::Word(text) => !is_number(text) && text.chars().count() > 1,
            Self::Number(_) | Self::Variable(..) => false,
            Self::Extreme(..) => true,
        }
    }

    /// The index in characters that stand below the line; none where there are no such characters.
    pub(crate) fn lowered(&self) -> Option<String> {
        match self {
            Self::Word(text) if !is_number(text) => None,
            _ => Some(lowered(&self.text())).filter(|text| !text.chars().any(|c| c.is_ascii())),
        }
    }

    /// The index behind a line below.
    pub(crate) fn behind_line(&self) -> String {
        match self {
            // What is added to an index belongs to it.
            Self::Variable(_, offset) if *offset != 0 => format!("_({})", self.text()),
            _ => format!("_{}", self.text()),
        }
    }
}

fn is_number(text: &str) -> bool {
    text.chars().all(|c| c.is_ascii_digit())
}

/// The values of an index from the first to the last.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Range {
    /// The index.
    pub variable: String,
    /// The first value.
    pub first: Index,
    /// The last value.
    pub last: Index,
}

impl Range {
    /// `i = 0, …, 19`, or one by one where they are three.
    pub(crate) fn print(&self, notation: Notation) -> String {
        let [first, last] = [&self.first, &self.last].map(|index| match notation {
            Notation::Unicode => index.text().replace('-', "−"),
            Notation::Latex => index.text(),
        });
        let variable = &self.variable;
        let count = match (&self.first, &self.last) {
            (Index::Number(first), Index::Number(last)) => last - first,
            (first, last) => i64::from(first != last) * i64::MAX,
        };
        let ellipsis = match notation {
            Notation::Unicode => "…",
            Notation::Latex => "\\ldots",
        };
        match count {
            0 => format!("{variable} = {first}"),
            1 => format!("{variable} = {first}, {last}"),
            2 => {
                let middle = Self {
                    last: self.first.clone().plus(1),
                    ..self.clone()
                };
                format!("{}, {last}", middle.print(notation))
            }
            _ => format!("{variable} = {first}, {ellipsis}, {last}"),
        }
    }

    /// The sign of a sum over the index.
    pub(crate) fn sum_sign(&self, notation: Notation) -> String {
        let below = format!("{}={}", self.variable, self.first.text());
        if notation == Notation::Latex {
            let [first, last] = [&self.first, &self.last].map(|bound| match bound {
                Index::Extreme(..) => bound.latex(),
                bound => bound.text(),
            });
            return format!("\\sum_{{{}={first}}}^{{{last}}} ", self.variable);
        }
        let last = self.last.text();
        let [lower, upper] = [lowered(&below), raised(&last)];
        if [&lower, &upper]
            .iter()
            .any(|text| text.chars().any(|c| c.is_ascii()))
        {
            format!("Σ_({below})^({last}) ")
        } else {
            format!("Σ{lower}{upper} ")
        }
    }
}
