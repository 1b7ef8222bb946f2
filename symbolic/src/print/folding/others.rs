//! The line of one member of a family as one of any member i, with sums over all others.

use crate::print::folding::token::{Line, Token};
use crate::print::folding::{closing, content, sign, terms, with_sums, without_sums};

/// A sum over the others is written for so many terms.
const MIN_OTHERS: usize = 2;

/// A term, and whether it has a minus sign.
type Term = (bool, Line);

/// The line of the member `own` of a family as one of any member i, where all of its sums are over the other members or over
/// all, and no other index occurs. Whether it is the line of the other members, their values decide.
pub(crate) fn of_any_member(line: &[Token], own: i64, [first, last]: [i64; 2]) -> Option<Line> {
    let line = sorted(line, own);
    let folded = with_sums(&line, MIN_OTHERS);
    if without_sums(&folded)? != line {
        return None;
    }
    let mut rest = folded.as_slice();
    let mut any = Line::new();
    while let [token, after @ ..] = rest {
        rest = after;
        let general = match token {
            Token::Sum(variable, _) => {
                let [Token::Index(begin), Token::Index(end), after @ ..] = rest else {
                    return None;
                };
                rest = after;
                let is_of_others = (own == first && [first + 1, last] == [*begin, *end])
                    || (own == last && [first, last - 1] == [*begin, *end]);
                if [first, last] == [*begin, *end] {
                    let [begin, end] = [*begin, *end].map(Token::Index);
                    any.extend([token.clone(), begin]);
                    end
                } else if is_of_others {
                    Token::SumOfOthers(*variable)
                } else {
                    return None;
                }
            }
            Token::Index(index) if *index == own => Token::Variable('i', 0),
            Token::Index(_) => return None,
            Token::Variable(_, offset) if *offset != 0 => return None,
            other => other.clone(),
        };
        any.push(general);
    }
    Some(any)
}

/// The line with the terms of each sum in an order in which those that differ in the indices of other members only stand one
/// behind the other.
fn sorted(line: &[Token], own: i64) -> Line {
    let mut inner = Line::new();
    let mut position = 0;
    // What is between commas or bars is no term.
    let mut is_sum = true;
    while position < line.len() {
        let end = closing(line, position);
        inner.push(line[position].clone());
        is_sum &= !matches!(line[position], Token::Char(',' | '|'));
        if end > position {
            let (content, close) = content(&line[position + 1..end]);
            inner.extend(sorted(content, own));
            inner.extend(close.iter().cloned());
            inner.push(line[end].clone());
        }
        position = end + 1;
    }
    if !is_sum {
        return inner;
    }
    let shape = |(negative, term): &Term| {
        let without = term.iter().map(|token| match token {
            Token::Index(index) if *index != own => Token::Index(-1),
            other => other.clone(),
        });
        (*negative, without.collect::<Line>())
    };
    let mut groups: Vec<(Term, Vec<Term>)> = Vec::new();
    for term in terms(&inner) {
        let shape = shape(&term);
        match groups.iter_mut().find(|(known, _)| *known == shape) {
            Some((_, group)) => group.push(term),
            None => groups.push((shape, vec![term])),
        }
    }
    if let Some(positive) = groups.iter().position(|((negative, _), _)| !negative) {
        groups[..=positive].rotate_right(1);
    }
    let mut ordered = Line::new();
    for (_, mut group) in groups {
        group.sort();
        for (negative, term) in group {
            ordered.extend(sign(ordered.is_empty(), negative, &inner));
            ordered.extend(term);
        }
    }
    ordered
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::folding::token::{tokens, written};
    use crate::print::listing::index_letters::IndexLetters;
    use crate::print::notation::Notation;

    fn of_member(line: &str, own: i64, last: i64) -> Option<String> {
        let line = tokens(&line.replace('[', "\u{E000}").replace(']', "\u{E001}"));
        let any = of_any_member(&line, own, [0, last])?;
        Some(written(&any, Notation::Unicode, IndexLetters::default()))
    }

    #[test]
    fn sums_are_over_all_others() {
        let first = of_member("m[0] (x[1] − x[0] + x[2] − x[0])", 0, 2);
        assert_eq!(first.as_deref(), Some("mᵢ (Σ_(j≠i) xⱼ − xᵢ − xᵢ)"));
        let first = of_member("m[0] x[0] − k (m[1] x[1] + m[2] x[2])", 0, 2);
        let any = "mᵢ xᵢ − k (Σ_(j≠i) mⱼ xⱼ)";
        assert_eq!(first.as_deref(), Some(any));
        let last = of_member("m[2] x[2] − k (m[0] x[0] + m[1] x[1])", 2, 2);
        assert_eq!(last.as_deref(), Some(any));
        let apart = of_member("k (x[1] − 2 x[0] + x[2])", 0, 2);
        assert_eq!(apart.as_deref(), Some("k (Σ_(j≠i) xⱼ − 2 xᵢ)"));
        let bars = of_member("|x[1] − x[0] + x[2]|", 0, 2);
        assert_eq!(bars, None);
        let all = of_member("x[0] + k (m[0] + m[1] + m[2])", 0, 2);
        assert_eq!(all.as_deref(), Some("xᵢ + k (Σⱼ₌₀² mⱼ)"));
    }

    #[test]
    fn sums_over_some_and_single_members_are_not_folded() {
        assert_eq!(of_member("x[0] + m[1] + m[2]", 0, 3), None);
        assert_eq!(of_member("x[0] + m[1] + m[2] + x[2]", 0, 2), None);
    }
}
