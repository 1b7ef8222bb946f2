//! What printed formulas are made of, in either notation.

use std::collections::BTreeMap;

use super::value::Reading;

/// A part of a formula.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Token {
    Number(f64),
    Name(Name),
    /// A function that books know, such as sin.
    Function(String),
    /// A bracket, and whether it follows what is before it without a space.
    Open {
        adjacent: bool,
    },
    Close,
    OpenSquare,
    CloseSquare,
    Bar,
    Comma,
    Plus,
    Minus,
    Dot,
    Cross,
    Slash,
    Caret,
    Transposed,
    Root,
    /// d/dt.
    Rate,
    /// The component of what is before it along an axis.
    Component(usize),
    /// The sign of a sum over an index between bounds.
    Sum {
        variable: String,
        bounds: [String; 2],
    },
    /// The sign of a sum over all values of an index but another one's.
    SumOfOthers {
        variable: String,
        but: String,
    },
    /// The sign of a sum over the links behind one.
    SumOfLinks(String),
}

/// A name with what stands above and below it.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct Name {
    /// The letter or word with its accents.
    pub(super) letter: String,
    pub(super) dots: usize,
    /// What stands below the line, one index or word after the other, as it would be written on the line.
    pub(super) below: Vec<String>,
}

/// The values of indices.
pub(super) type Indices = BTreeMap<String, i64>;

/// The functions of books.
pub(super) const FUNCTIONS: [&str; 16] = [
    "sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "arsinh", "arcosh",
    "artanh", "exp", "ln", "sgn", "abs",
];
/// Those of several arguments.
pub(super) const OF_SEVERAL: [&str; 4] = ["atan2", "min", "max", "diag"];

impl Name {
    /// The name as it is printed in Unicode where its indices have these values, without dots.
    pub(super) fn written(&self, indices: &Indices) -> String {
        let mut text = self.letter.clone();
        let mut digits_before = 0;
        for part in &self.below {
            let is_number = part.chars().all(|c| c.is_ascii_digit());
            let value = index_value(part, indices).filter(|_| !is_number);
            let part = value.map_or_else(|| part.clone(), |i| i.to_string());
            if part.chars().all(|c| c.is_ascii_digit()) {
                if digits_before > 0 && digits_before.max(part.len()) > 1 {
                    text.push(',');
                }
                text.extend(part.chars().map(below_the_line));
                digits_before = part.len();
            } else {
                text.extend(["_", &part]);
                digits_before = 0;
            }
        }
        text
    }
}

/// The digit below the line.
pub(super) fn below_the_line(digit: char) -> char {
    let digit = digit.to_digit(10).unwrap_or(0);
    char::from_u32(0x2080 + digit).unwrap_or('₀')
}

/// The value of an index such as i, i−1, 12 or max(i,j); none of a word.
pub(super) fn index_value(text: &str, indices: &Indices) -> Option<i64> {
    let text = text.trim();
    for (name, choose) in [("max", i64::max as fn(i64, i64) -> i64), ("min", i64::min)] {
        if let Some(inner) = text.strip_prefix(name)
            && let Some(inner) = inner.strip_prefix('(').and_then(|t| t.strip_suffix(')'))
        {
            let (x, y) = inner.split_once(',')?;
            return Some(choose(index_value(x, indices)?, index_value(y, indices)?));
        }
    }
    let (mut total, mut sign, mut term) = (0, 1, String::new());
    for c in text.chars().chain(['+']) {
        match c {
            '+' | '-' | '−' => {
                let value = match term.parse::<i64>() {
                    Ok(number) => number,
                    Err(_) => *indices.get(&term)?,
                };
                total += sign * value;
                sign = if c == '+' { 1 } else { -1 };
                term.clear();
            }
            ' ' => {}
            c => term.push(c),
        }
    }
    Some(total)
}

/// The characters of a text, read one after the other.
pub(super) struct Characters<'a> {
    pub(super) rest: &'a str,
}

impl<'a> Characters<'a> {
    pub(super) fn next_is(&self, text: &str) -> bool {
        self.rest.starts_with(text)
    }

    pub(super) fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    /// Takes a text if it is next.
    pub(super) fn take(&mut self, text: &str) -> bool {
        match self.rest.strip_prefix(text) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    pub(super) fn take_while(&mut self, is_part: impl Fn(char) -> bool) -> &'a str {
        let end = self.rest.find(|c| !is_part(c)).unwrap_or(self.rest.len());
        let (taken, rest) = self.rest.split_at(end);
        self.rest = rest;
        taken
    }

    /// What stands within brackets that are open already.
    pub(super) fn take_group(&mut self, [open, close]: [char; 2]) -> Reading<&'a str> {
        let mut depth = 1;
        for (position, c) in self.rest.char_indices() {
            depth += i32::from(c == open) - i32::from(c == close);
            if depth == 0 {
                let inner = &self.rest[..position];
                self.rest = &self.rest[position + c.len_utf8()..];
                return Ok(inner);
            }
        }
        Err(format!("{close} is missing in {}", self.rest))
    }

    pub(super) fn number(&mut self) -> Reading<f64> {
        let digits = self.take_while(|c| c.is_ascii_digit() || c == '.');
        digits.parse().map_err(|_| format!("no number: {digits}"))
    }
}
