//! Lines that differ in their indices only, folded to one: sums over an index, and one equation for the members of a
//! family (anti-unification: Plotkin, A note on inductive generalization, 1970).
//!
//! Indices are marked where names are printed. A fold is taken only if the pattern, with its index put in and its sums
//! written out, is again the line that was printed.

pub(crate) mod others;
pub(crate) mod token;

use std::collections::BTreeMap;

use crate::limits::{MIN_FOLDED_LINES, MIN_FOLDED_TERMS};
use crate::print::folding::token::{Line, Token, written};
use crate::print::listing::as_declared::print_range;
use crate::print::listing::index_letters::IndexLetters;
use crate::print::notation::Notation;

/// The line with runs of so many terms or more that differ by one in some of their indices as sums.
fn with_sums(line: &[Token], fewest: usize) -> Line {
    let mut inner = Line::new();
    let mut position = 0;
    while position < line.len() {
        let end = closing(line, position);
        inner.push(line[position].clone());
        if end > position {
            let (content, close) = content(&line[position + 1..end]);
            let content = with_sums(content, fewest);
            inner.extend(content);
            inner.extend(close.iter().cloned());
            inner.push(line[end].clone());
        }
        position = end + 1;
    }
    let terms = terms(&inner);
    let mut folded = Line::new();
    let mut start = 0;
    while start < terms.len() {
        let mut end = start + 1;
        let mut step = None;
        while end < terms.len() && terms[end].0 == terms[start].0 {
            let found = difference(&terms[end - 1].1, &terms[end].1);
            if found.is_none() || (step.is_some() && step != found) {
                break;
            }
            step = found;
            end += 1;
        }
        let folds = end - start >= fewest;
        let step = step.filter(|_| folds);
        let (negative, first) = &terms[start];
        folded.extend(sign(start == 0, *negative, &inner));
        match step {
            Some(step) => folded.extend(sum(first, &step, end - start, *negative)),
            None => folded.extend(first.iter().cloned()),
        }
        start = if folds { end } else { start + 1 };
    }
    folded
}

/// What stands within brackets, and what closes them in LaTeX.
fn content(line: &[Token]) -> (&[Token], &[Token]) {
    let right = ['\\', 'r', 'i', 'g', 'h', 't'].map(Token::Char);
    let length = line.len()
        - if line.ends_with(&right) {
            right.len()
        } else {
            0
        };
    line.split_at(length)
}

/// Where the bracket at a position closes; the position itself if it is none.
fn closing(line: &[Token], position: usize) -> usize {
    let mut depth = 0_usize;
    for (i, token) in line.iter().enumerate().skip(position) {
        match token {
            Token::Char('(' | '{') => depth += 1,
            Token::Char(')' | '}') => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return i;
        }
    }
    position
}

/// The terms of a sum, and which have a minus sign.
fn terms(line: &[Token]) -> Vec<(bool, Line)> {
    let is_minus = |token: &Token| matches!(token, Token::Char('−' | '-'));
    let mut terms = vec![(false, Line::new())];
    let mut position = 0;
    if line.first().is_some_and(is_minus) {
        terms[0].0 = true;
        position = 1;
    }
    while position < line.len() {
        if let [Token::Char(' '), sign, Token::Char(' '), ..] = &line[position..]
            && (is_minus(sign) || *sign == Token::Char('+'))
        {
            terms.push((is_minus(sign), Line::new()));
            position += 3;
            continue;
        }
        let end = closing(line, position);
        if let Some((_, term)) = terms.last_mut() {
            term.extend(line[position..=end].iter().cloned());
        }
        position = end + 1;
    }
    terms
}

/// The sign before a term, in the characters of the line.
fn sign(first: bool, negative: bool, line: &[Token]) -> Line {
    let unicode = line.contains(&Token::Char('−'));
    let minus = if unicode { '−' } else { '-' };
    match (first, negative) {
        (true, false) => Line::new(),
        (true, true) => vec![Token::Char(minus)],
        (false, negative) => {
            let sign = if negative { minus } else { '+' };
            [' ', sign, ' '].map(Token::Char).to_vec()
        }
    }
}

/// By how much each index grows from one line to another, by one or not at all; none if they differ in more.
fn difference(first: &[Token], second: &[Token]) -> Option<Vec<i64>> {
    if first.len() != second.len() {
        return None;
    }
    let mut steps = Vec::new();
    for pair in first.iter().zip(second) {
        match pair {
            (Token::Index(x), Token::Index(y)) if (0..=1).contains(&(y - x)) => steps.push(y - x),
            (x, y) if x == y => {}
            _ => return None,
        }
    }
    steps.contains(&1).then_some(steps)
}

/// The sum over as many terms, of which this is the first.
fn sum(first: &[Token], steps: &[i64], count: usize, negative: bool) -> Line {
    let used = |c: &char| {
        first
            .iter()
            .any(|token| matches!(token, Token::Sum(x, _) if x == c))
    };
    let variable = ['j', 'k', 'l']
        .into_iter()
        .find(|c| !used(c))
        .unwrap_or('m');
    let moving: Vec<_> = indices(first)
        .zip(steps)
        .filter(|(_, s)| **s == 1)
        .collect();
    let start = moving.first().map_or(0, |(index, _)| *index);
    let last = start + i64::try_from(count).unwrap_or(1) - 1;
    let mut line = vec![
        Token::Sum(variable, negative),
        Token::Index(start),
        Token::Index(last),
    ];
    line.extend(generalized(first, steps, variable, start));
    line.push(Token::EndOfSum);
    line
}

fn indices(line: &[Token]) -> impl Iterator<Item = i64> {
    line.iter().filter_map(|token| match token {
        Token::Index(index) => Some(*index),
        _ => None,
    })
}

/// The line with a variable, which is `start` here, in place of the indices that grow.
fn generalized(line: &[Token], steps: &[i64], variable: char, start: i64) -> Line {
    let mut steps = steps.iter();
    let replaced = line.iter().map(|token| match token {
        Token::Index(index) if steps.next() == Some(&1) => Token::Variable(variable, index - start),
        other => other.clone(),
    });
    replaced.collect()
}

/// The pattern with an index in place of a variable.
fn at(pattern: &[Token], variable: char, value: i64) -> Line {
    let replaced = pattern.iter().map(|token| match token {
        Token::Variable(c, offset) if *c == variable => Token::Index(value + offset),
        other => other.clone(),
    });
    replaced.collect()
}

/// The line with its sums written out; none where one is empty.
fn without_sums(line: &[Token]) -> Option<Line> {
    let Some(start) = line
        .iter()
        .rposition(|token| matches!(token, Token::Sum(..)))
    else {
        return Some(line.to_vec());
    };
    let [
        Token::Sum(variable, negative),
        Token::Index(first),
        Token::Index(last),
        rest @ ..,
    ] = &line[start..]
    else {
        return None;
    };
    let end = rest.iter().position(|token| *token == Token::EndOfSum)?;
    let mut whole = line[..start].to_vec();
    if last < first {
        return None;
    }
    for index in *first..=*last {
        if index > *first {
            whole.extend(sign(false, *negative, line));
        }
        whole.extend(at(&rest[..end], *variable, index));
    }
    whole.extend(rest[end + 1..].iter().cloned());
    without_sums(&whole)
}

/// A line, or one for several members of a family, whose indices go from the first to the last.
#[derive(Clone, Debug)]
pub(crate) struct Folded {
    pub(crate) line: Line,
    pub(crate) range: Option<(i64, i64)>,
    /// The positions of the lines that it stands for.
    pub(crate) members: Vec<usize>,
}

impl Folded {
    /// A line as it is.
    pub(crate) fn single(position: usize, line: Line) -> Self {
        Self {
            line,
            range: None,
            members: vec![position],
        }
    }

    /// The line as it is read, with the range of its index.
    pub(crate) fn written(&self, notation: Notation, letters: IndexLetters) -> String {
        let text = written(&self.line, notation, letters);
        let Some((first, last)) = self.range else {
            return text;
        };
        let [unicode, latex] =
            print_range(&letters.text('i'), &first.to_string(), &last.to_string());
        match notation {
            Notation::Unicode => format!("{text}  ({unicode})"),
            Notation::Latex => format!("{text} \\quad ({latex})"),
        }
    }
}

/// Lines with sums, and one in place of the members of each family, where it is the same for most of them.
pub(crate) fn families(lines: &[Line]) -> Vec<Folded> {
    let sums: Vec<_> = lines.iter().map(|line| with_sums_of_sides(line)).collect();
    let mut members: BTreeMap<Line, Vec<usize>> = BTreeMap::new();
    for (position, line) in lines.iter().enumerate() {
        if let Some(family) = family(line) {
            members.entry(family).or_default().push(position);
        }
    }
    let mut folded: Vec<Option<Folded>> = sums
        .iter()
        .enumerate()
        .map(|(position, line)| Some(Folded::single(position, line.clone())))
        .collect();
    for positions in members.values() {
        let Some((pattern, covered)) = pattern(lines, &sums, positions) else {
            continue;
        };
        let number = |position: &usize| indices(&lines[*position]).next().unwrap_or(0);
        let (first, last) = (number(&covered[0]), number(&covered[covered.len() - 1]));
        for position in &covered {
            folded[*position] = None;
        }
        let position = covered[0];
        folded[position] = Some(Folded {
            line: pattern,
            range: Some((first, last)),
            members: covered,
        });
    }
    folded.into_iter().flatten().collect()
}

/// Sums within the sides of an equation.
fn with_sums_of_sides(line: &[Token]) -> Line {
    let equals = [' ', '=', ' '].map(Token::Char);
    let position = line.windows(3).position(|window| window == equals);
    let side = |line: &[Token]| with_sums(line, MIN_FOLDED_TERMS);
    let folded = position.map_or_else(
        || side(line),
        |position| {
            let (left, right) = (&line[..position], &line[position + 3..]);
            [side(left), equals.to_vec(), side(right)].concat()
        },
    );
    if without_sums(&folded).is_some_and(|whole| whole == line) {
        folded
    } else {
        line.to_vec()
    }
}

/// What the members of a family have in common: the first term without the indices that are equal to its first one, and
/// of a single name only without the first.
fn family(line: &[Token]) -> Option<Line> {
    let is_space = |token: &Token| *token == Token::Char(' ');
    let is_sign = |token: &Token| matches!(token, Token::Char('+' | '−' | '-' | '='));
    let end = line
        .windows(3)
        .position(|window| is_space(&window[0]) && is_sign(&window[1]) && is_space(&window[2]));
    let term = &line[..end.unwrap_or(line.len())];
    let first = indices(term).next()?;
    let is_name = !term.iter().any(is_space);
    let mut found = false;
    let without = term.iter().map(|token| match token {
        Token::Index(index) if *index == first && !(is_name && found) => {
            found = true;
            Token::Index(-1)
        }
        other => other.clone(),
    });
    Some(without.collect())
}

/// The pattern of most members, and which they are.
fn pattern(lines: &[Line], sums: &[Line], positions: &[usize]) -> Option<(Line, Vec<usize>)> {
    if positions.len() < MIN_FOLDED_LINES {
        return None;
    }
    let middle = positions.len() / 2;
    let [one, next] = [positions[middle], positions[middle + 1]];
    let steps = difference(&sums[one], &sums[next])?;
    let start = indices(&lines[one]).next()?;
    let pattern = generalized(&sums[one], &steps, 'i', start);
    let covers = |position: &usize| {
        let Some(index) = indices(&lines[*position]).next() else {
            return false;
        };
        without_sums(&at(&pattern, 'i', index)).as_ref() == Some(&lines[*position])
    };
    let covered: Vec<_> = positions.iter().copied().filter(covers).collect();
    let numbers = covered
        .iter()
        .filter_map(|position| indices(&lines[*position]).next());
    let numbers: Vec<_> = numbers.collect();
    let consecutive = numbers.windows(2).all(|pair| pair[1] == pair[0] + 1);
    (consecutive && covered.len() >= MIN_FOLDED_LINES).then_some((pattern, covered))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::folding::token::tokens;

    /// Lines with indices in brackets, folded and written in Unicode.
    fn folded(lines: &[&str]) -> Vec<String> {
        let marked = |line: &&str| tokens(&line.replace('[', "\u{E000}").replace(']', "\u{E001}"));
        let lines: Vec<_> = lines.iter().map(marked).collect();
        let folded = families(&lines).into_iter();
        folded
            .map(|fold| fold.written(Notation::Unicode, IndexLetters::default()))
            .collect()
    }

    #[test]
    fn sums_over_an_index() {
        let found =
            folded(&["V = g (m[1] y[1] − a + m[2] y[2] + m[3] y[3] + m[4] y[4] + m[5] y[5])"]);
        assert_eq!(found, ["V = g (m₁ y₁ − a + Σⱼ₌₂⁵ mⱼ yⱼ)"]);
        let three = "T = m[1] + m[2] + m[3]";
        assert_eq!(folded(&[three]), ["T = m₁ + m₂ + m₃"]);
        // Steps of two, and a sign that differs.
        let found = folded(&["T = m[0] + m[2] + m[4] + m[6] − m[7] + m[8] + m[9] + m[10] + m[11]"]);
        assert_eq!(found, ["T = m₀ + m₂ + m₄ + m₆ − m₇ + Σⱼ₌₈¹¹ mⱼ"]);
    }

    #[test]
    fn families_with_sums_whose_length_differs() {
        let lines: Vec<String> = (0..6)
            .map(|i| {
                let terms: Vec<_> = (0..=i).map(|j| format!("l[{j}] cos θ[{j}]")).collect();
                format!("y[{i}] = −{}", terms.join(" − "))
            })
            .collect();
        let lines: Vec<_> = lines.iter().map(String::as_str).collect();
        assert_eq!(folded(&lines), ["yᵢ = −Σⱼ₌₀ⁱ lⱼ cos θⱼ  (i = 0, …, 5)"]);
    }

    #[test]
    fn a_member_that_differs_stands_alone() {
        let mut lines = [
            "a[0] = x",
            "a[1] = b[2]",
            "a[2] = b[3]",
            "a[3] = b[4]",
            "a[4] = b[5]",
        ];
        let rest = "aᵢ = bᵢ₊₁  (i = 1, …, 4)";
        assert_eq!(folded(&lines), ["a₀ = x", rest]);
        lines[3] = "a[3] = b[5]";
        assert_eq!(folded(&lines).len(), 5);
    }
}
