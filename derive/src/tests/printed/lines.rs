//! Pages taken apart: headings, sentences and equations.

use super::formula::{Formula, formula};
use super::token::Indices;
use super::value::Reading;
use super::{latex, unicode};

/// How a page is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Notation {
    Unicode,
    Latex,
}

/// A line of a page.
#[derive(Clone, Debug)]
pub(super) enum Line {
    /// A heading or a sentence.
    Words(String),
    Equation(Equation),
}

/// An equation, for all values of its indices.
#[derive(Clone, Debug)]
pub(super) struct Equation {
    pub(super) text: String,
    pub(super) sides: [String; 2],
    pub(super) ranges: Vec<(String, i64, i64)>,
}

impl Notation {
    /// The formula that a text says.
    pub(super) fn formula(self, text: &str) -> Reading<Formula> {
        let tokens = match self {
            Self::Unicode => unicode::tokens(text),
            Self::Latex => latex::tokens(text),
        };
        formula(&tokens?)
    }

    /// The lines of a page.
    pub(super) fn lines(self, page: &str) -> Reading<Vec<Line>> {
        match self {
            Self::Unicode => unicode_lines(page),
            Self::Latex => latex_lines(page),
        }
    }
}

/// Whether a line has no equation, though there may be a sign = in it.
fn is_of_words(line: &str) -> bool {
    line.ends_with([':', '.'])
}

fn unicode_lines(page: &str) -> Reading<Vec<Line>> {
    let lines = page.lines().filter(|line| !line.is_empty());
    lines
        .map(|line| {
            if is_of_words(line) {
                return Ok(Line::Words(line.to_owned()));
            }
            Ok(Line::Equation(Equation::of(line, "  (")?))
        })
        .collect()
}

fn latex_lines(page: &str) -> Reading<Vec<Line>> {
    let mut lines = Vec::new();
    let mut rest = page;
    while !rest.is_empty() {
        if let Some(display) = rest.strip_prefix("\\begin{align*}\n") {
            let end = display
                .find("\n\\end{align*}\n")
                .ok_or("a display does not end")?;
            for row in rows(&display[..end])? {
                lines.push(Line::Equation(Equation::of(&row, " \\quad (")?));
            }
            rest = &display[end + "\n\\end{align*}\n".len()..];
        } else {
            let (line, after) = rest.split_once('\n').unwrap_or((rest, ""));
            lines.push(Line::Words(line.to_owned()));
            rest = after;
        }
    }
    Ok(lines)
}

/// The rows of a display, each with the rows that continue it.
fn rows(display: &str) -> Reading<Vec<String>> {
    let mut rows: Vec<String> = Vec::new();
    for row in display.split(" \\\\\n") {
        match (row.strip_prefix("&\\quad "), rows.last_mut()) {
            (Some(more), Some(row)) => row.extend([" ", more]),
            (Some(_), None) => return Err("a display begins with the rest of a row".into()),
            (None, _) => rows.push(row.to_owned()),
        }
    }
    let plain = rows.iter().map(|row| {
        let signs = row.matches('&').count();
        if signs != 1 {
            return Err(format!("{signs} marks of alignment in {row}"));
        }
        let row = row.replacen("&= ", "= ", 1);
        Ok(row.strip_prefix('&').map_or(row.clone(), str::to_owned))
    });
    plain.collect()
}

impl Equation {
    fn of(line: &str, range: &str) -> Reading<Self> {
        let (equation, range) = match line.rsplit_once(range) {
            Some((equation, range)) if range.contains(" = ") => (equation, Some(range)),
            _ => (line, None),
        };
        let (left, right) = equation
            .split_once(" = ")
            .ok_or(format!("neither a sentence nor an equation: {line}"))?;
        let ranges = range.map_or(Ok(Vec::new()), ranges)?;
        Ok(Self {
            text: line.to_owned(),
            sides: [left, right].map(str::to_owned),
            ranges,
        })
    }

    /// All values of its indices.
    pub(super) fn cases(&self) -> Vec<Indices> {
        let mut cases = vec![Indices::new()];
        for (variable, first, last) in &self.ranges {
            let longer = cases.iter().flat_map(|case| {
                (*first..=*last).map(move |index| {
                    let mut case = case.clone();
                    case.insert(variable.clone(), index);
                    case
                })
            });
            cases = longer.collect();
        }
        cases
    }
}

/// `i = 0, …, 5; j = 1, 2)`.
fn ranges(text: &str) -> Reading<Vec<(String, i64, i64)>> {
    let text = text.strip_suffix(')').ok_or("a range is not closed")?;
    let range = |range: &str| {
        let (variable, values) = range
            .split_once(" = ")
            .ok_or(format!("no range: {range}"))?;
        let values = values.replace('−', "-");
        let values: Vec<&str> = values.split(", ").collect();
        let number = |text: &str| text.parse::<i64>().map_err(|_| format!("no index: {text}"));
        let (first, last) = (number(values[0])?, number(values[values.len() - 1])?);
        let listed = values.iter().filter_map(|value| value.parse::<i64>().ok());
        let listed: Vec<i64> = listed.collect();
        let has_ellipsis = values.iter().any(|value| ["…", "\\ldots"].contains(value));
        if !has_ellipsis && listed != (first..=last).collect::<Vec<_>>() {
            return Err(format!("what are {values:?}?"));
        }
        Ok((variable.to_owned(), first, last))
    };
    text.split("; ").map(range).collect()
}
