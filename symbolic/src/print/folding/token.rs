//! Printed lines as tokens: characters, indices, variables, sums.

use crate::print::listing::index_letters::IndexLetters;
use crate::print::notation::{Notation, subscript, superscript};

/// The marks around an index.
pub(crate) const MARKS: [char; 2] = ['\u{E000}', '\u{E001}'];

/// A part of a line.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Token {
    Char(char),
    Index(i64),
    /// A variable and what is added to it.
    Variable(char, i64),
    /// A sum over a variable, of terms with a minus sign or without, from the index that follows to the next.
    Sum(char, bool),
    /// A sum over a variable, which is any member of the family but i.
    SumOfOthers(char),
    EndOfSum,
}

/// A printed line.
pub(crate) type Line = Vec<Token>;

/// Takes a line apart.
pub(crate) fn tokens(text: &str) -> Line {
    let mut line = Line::new();
    let mut rest = text.chars();
    while let Some(c) = rest.next() {
        if c == MARKS[0] {
            let digits: String = rest.by_ref().take_while(|c| *c != MARKS[1]).collect();
            line.push(Token::Index(digits.parse().unwrap_or(0)));
        } else {
            line.push(Token::Char(c));
        }
    }
    line
}

/// The line as it is read.
pub(crate) fn written(line: &[Token], notation: Notation, letters: IndexLetters) -> String {
    let mut text = String::new();
    let mut bounds = 0;
    let mut previous = None;
    for token in line {
        match token {
            Token::Char(c) => text.push(*c),
            Token::Sum(variable, _) if notation == Notation::Unicode => {
                text.extend(["Σ", &lowered(&letters.text(*variable)), "₌"]);
                bounds = 2;
            }
            Token::Sum(variable, _) => {
                text.extend(["\\sum_{", &letters.text(*variable), "="]);
                bounds = 2;
            }
            Token::SumOfOthers(variable) => {
                let (j, i) = (letters.text(*variable), letters.text('i'));
                let [before, between, after] = match notation {
                    Notation::Unicode => ["Σ_(", "≠", ") "],
                    Notation::Latex => ["\\sum_{", " \\ne ", "} "],
                };
                text.extend([before, &j, between, &i, after]);
            }
            Token::EndOfSum => {}
            Token::Index(_) | Token::Variable(..) => {
                let index = index_text(token, letters);
                match (notation, bounds) {
                    (Notation::Unicode, 1) => text.push_str(&raised(&index)),
                    (Notation::Unicode, _) => {
                        let after: Option<&String> = previous.as_ref();
                        let apart = after.is_some_and(|last| last.len().max(index.len()) > 1);
                        text.push_str(if apart && bounds == 0 { "," } else { "" });
                        text.push_str(&lowered(&index));
                    }
                    (Notation::Latex, 2) => text.extend([&*index, "}^{"]),
                    (Notation::Latex, 1) => text.extend([&*index, "} "]),
                    (Notation::Latex, _) => text.push_str(&index),
                }
                if bounds == 1 && notation == Notation::Unicode {
                    text.push(' ');
                }
                previous = (bounds == 0).then_some(index);
                bounds = usize::saturating_sub(bounds, 1);
                continue;
            }
        }
        previous = None;
    }
    text
}

fn index_text(token: &Token, letters: IndexLetters) -> String {
    match token {
        Token::Variable(c, 0) => letters.text(*c),
        Token::Variable(c, offset) => format!("{}{offset:+}", letters.written(*c)),
        Token::Index(index) => index.to_string(),
        _ => String::new(),
    }
}

pub(crate) fn lowered(text: &str) -> String {
    let lower = |c| match c {
        'i' => 'ᵢ',
        'j' => 'ⱼ',
        'k' => 'ₖ',
        'l' => 'ₗ',
        'm' => 'ₘ',
        'n' => 'ₙ',
        'a' => 'ₐ',
        'r' => 'ᵣ',
        's' => 'ₛ',
        '+' => '₊',
        '-' | '−' => '₋',
        other => other,
    };
    subscript(&text.chars().map(lower).collect::<String>())
}

pub(crate) fn raised(text: &str) -> String {
    let raise = |c| match c {
        'i' => 'ⁱ',
        'j' => 'ʲ',
        'k' => 'ᵏ',
        'l' => 'ˡ',
        'm' => 'ᵐ',
        'n' => 'ⁿ',
        'a' => 'ᵃ',
        'r' => 'ʳ',
        's' => 'ˢ',
        '+' => '⁺',
        '−' => '⁻',
        other => other,
    };
    superscript(&text.chars().map(raise).collect::<String>())
}
