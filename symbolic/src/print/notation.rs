//! The two ways in which formulas are written: lines of Unicode, and LaTeX.

use crate::Unary;

/// What is written for what is left out.
pub(crate) const ELLIPSIS: [&str; 2] = ["…", "\\ldots "];

/// How a formula is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Notation {
    Unicode,
    Latex,
}

impl Notation {
    /// The one of two in this notation.
    pub(crate) fn of<T>(self, [unicode, latex]: [T; 2]) -> T {
        match self {
            Self::Unicode => unicode,
            Self::Latex => latex,
        }
    }

    /// The exponent `digits`, an integer.
    pub(crate) fn exponent(self, digits: &str) -> String {
        match self {
            Self::Unicode => raised(digits),
            Self::Latex => format!("^{{{digits}}}"),
        }
    }

    /// The name of a function that is in no book.
    pub(crate) fn operator(self, name: &str) -> String {
        match self {
            Self::Unicode => name.to_owned(),
            Self::Latex => format!("\\operatorname{{{}}}", name.replace('_', "\\_")),
        }
    }

    /// The name of a function in a book.
    pub(crate) fn function(self, function: Unary) -> String {
        let name = match function {
            Unary::Asin => "arcsin",
            Unary::Acos => "arccos",
            Unary::Atan => "arctan",
            Unary::Asinh => "arsinh",
            Unary::Acosh => "arcosh",
            Unary::Atanh => "artanh",
            Unary::Signum => "sgn",
            Unary::LogCosh => return self.of(["ln cosh", "\\ln\\cosh"]).to_owned(),
            other => other.name(),
        };
        if self == Self::Latex && COMMANDS.contains(&name) {
            return format!("\\{name}");
        }
        self.operator(name)
    }
}

/// The functions for which LaTeX has commands.
const COMMANDS: [&str; 11] = [
    "sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "exp", "ln",
];

/// What stands on the line, below it and above it.
const SHIFTED: [(char, char, char); 22] = [
    ('0', '₀', '⁰'),
    ('1', '₁', '¹'),
    ('2', '₂', '²'),
    ('3', '₃', '³'),
    ('4', '₄', '⁴'),
    ('5', '₅', '⁵'),
    ('6', '₆', '⁶'),
    ('7', '₇', '⁷'),
    ('8', '₈', '⁸'),
    ('9', '₉', '⁹'),
    ('i', 'ᵢ', 'ⁱ'),
    ('j', 'ⱼ', 'ʲ'),
    ('k', 'ₖ', 'ᵏ'),
    ('l', 'ₗ', 'ˡ'),
    ('m', 'ₘ', 'ᵐ'),
    ('n', 'ₙ', 'ⁿ'),
    ('a', 'ₐ', 'ᵃ'),
    ('r', 'ᵣ', 'ʳ'),
    ('s', 'ₛ', 'ˢ'),
    ('+', '₊', '⁺'),
    ('-', '₋', '⁻'),
    ('=', '₌', '⁼'),
];

/// Digits, signs and letters of indices above the line.
pub(crate) fn raised(text: &str) -> String {
    shifted(text, |row| row.2)
}

/// Digits, signs and letters of indices below the line.
pub(crate) fn lowered(text: &str) -> String {
    shifted(text, |row| row.1)
}

fn shifted(text: &str, place: fn(&(char, char, char)) -> char) -> String {
    let shifted = text.chars().map(|c| {
        let row = SHIFTED.iter().find(|(on_line, ..)| *on_line == c);
        row.map_or(c, place)
    });
    shifted.collect()
}
