//! Long rows of LaTeX broken before + and − (American Mathematical Society, User's Guide for the amsmath Package, 2020,
//! section 3.3).
//!
//! `\left` and `\right` have to stand in one row, so that brackets within which a row ends are written with `\bigl` and `\bigr`.
//! Nothing is broken within braces, where there are numerators, denominators and arguments of roots, nor within the brackets
//! around the arguments of a function.

use crate::limits::MAX_ROW_LENGTH;

/// What begins a row that continues another one.
const CONTINUED: &str = " \\\\\n&\\quad ";

/// A bracket that may hold the end of a row, or what may not.
struct Bracket {
    open: usize,
    close: usize,
}

/// The equations as rows of a display: aligned at the equals signs, or all at their beginnings if the left side of one is
/// long, beside which the others would stand far to the right.
pub(crate) fn rows(equations: &[String]) -> Vec<String> {
    let mut rows: Vec<_> = equations.iter().map(|equation| row(equation)).collect();
    if rows.iter().any(|row| row.starts_with('&')) {
        for row in rows.iter_mut().filter(|row| !row.starts_with('&')) {
            *row = format!("&{}", row.replacen("&= ", "= ", 1));
        }
    }
    rows
}

/// The equation of two sides as a row of a display, aligned at the equals sign, or at its beginning where the left side
/// is long.
fn row(equation: &str) -> String {
    let (left, right) = equation.split_once(" = ").unwrap_or((equation, ""));
    if visible(left) + visible(right) <= MAX_ROW_LENGTH {
        return format!("{left} &= {right}");
    }
    if 2 * visible(left) <= MAX_ROW_LENGTH {
        return format!(
            "{left} &= {}",
            broken(right, MAX_ROW_LENGTH - visible(left))
        );
    }
    format!("&{}", broken(equation, MAX_ROW_LENGTH))
}

/// How many characters are seen, about: braces and names of commands are not.
fn visible(text: &str) -> usize {
    let mut count = 0;
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        match c {
            '\\' => {
                let mut command = String::new();
                while let Some(letter) = rest.next_if(char::is_ascii_alphabetic) {
                    command.push(letter);
                }
                count += match &*command {
                    "left" | "right" | "frac" | "mathrm" | "operatorname" | "dot" | "ddot" => 0,
                    "sin" | "cos" | "tan" | "exp" => 3,
                    _ => 1,
                };
            }
            '{' | '}' | '^' | '_' | ' ' => {}
            '+' | '-' => count += 3,
            _ => count += 1,
        }
    }
    count
}

/// The text with ends of rows.
fn broken(text: &str, first: usize) -> String {
    let (signs, brackets) = scan(text);
    let mut ends = Vec::new();
    let mut used = first;
    used = MAX_ROW_LENGTH.saturating_sub(used);
    ends_within(text, (0, text.len()), (&signs, 0), &mut used, &mut ends);
    ends.sort_unstable();
    let mut changes: Vec<(usize, &str, &str)> =
        ends.iter().map(|end| (*end, " ", CONTINUED)).collect();
    for bracket in &brackets {
        if ends
            .iter()
            .any(|end| (bracket.open..bracket.close).contains(end))
        {
            changes.push((bracket.open, "\\left", "\\bigl"));
            changes.push((bracket.close, "\\right", "\\bigr"));
        }
    }
    changes.sort_unstable();
    let mut written = String::with_capacity(text.len());
    let mut position = 0;
    for (place, from, to) in changes {
        written.extend([&text[position..place], to]);
        position = place + from.len();
    }
    written.push_str(&text[position..]);
    written
}

/// The places before signs outside of braces and of arguments, each with how many brackets it is in, and the brackets.
fn scan(text: &str) -> (Vec<(usize, usize)>, Vec<Bracket>) {
    let (mut signs, mut brackets, mut open) = (Vec::new(), Vec::new(), Vec::new());
    let mut braces = 0_usize;
    // Brackets around arguments, and within these.
    let mut of_arguments = 0_usize;
    for (position, c) in text.char_indices() {
        let (before, rest) = text.split_at(position);
        match c {
            '\\' if of_arguments > 0 && rest.starts_with("\\left") => of_arguments += 1,
            '\\' if of_arguments > 0 && rest.starts_with("\\right") => of_arguments -= 1,
            '\\' if rest.starts_with("\\left(") && ends_with_name(before) => of_arguments = 1,
            _ if of_arguments > 0 => {}
            '{' => braces += 1,
            '}' => braces = braces.saturating_sub(1),
            '\\' if rest.starts_with("\\left|") => braces += 1,
            '\\' if rest.starts_with("\\right|") => braces = braces.saturating_sub(1),
            '\\' if braces == 0 && rest.starts_with("\\left") => open.push(position),
            '\\' if braces == 0 && rest.starts_with("\\right") => {
                if let Some(start) = open.pop() {
                    brackets.push(Bracket {
                        open: start,
                        close: position,
                    });
                }
            }
            ' ' if braces == 0 && [" + ", " - "].iter().any(|sign| rest.starts_with(sign)) => {
                signs.push((position, open.len()));
            }
            _ => {}
        }
    }
    (signs, brackets)
}

/// Whether a bracket that follows is one around the arguments of a function: before others there is a space.
fn ends_with_name(text: &str) -> bool {
    text.ends_with(|c: char| c.is_alphanumeric() || c == '}')
}

/// Finds ends of rows in a part of a text: before signs in so many brackets, or in more where a term is too long.
fn ends_within(
    text: &str,
    (start, end): (usize, usize),
    (signs, depth): (&[(usize, usize)], usize),
    used: &mut usize,
    ends: &mut Vec<usize>,
) {
    let own = signs
        .iter()
        .filter(|(place, of)| *of == depth && (start..end).contains(place));
    let places: Vec<_> = own.map(|(place, _)| *place).collect();
    let starts = [start].into_iter().chain(places.iter().copied());
    let stops = places.iter().copied().chain([end]);
    for (number, (from, to)) in starts.zip(stops).enumerate() {
        let length = visible(&text[from..to]);
        if number > 0 && *used + length > MAX_ROW_LENGTH && *used > 0 {
            ends.push(from);
            *used = 0;
        }
        let has_more = signs
            .iter()
            .any(|(place, of)| *of > depth && (from..to).contains(place));
        if *used + length > MAX_ROW_LENGTH && has_more {
            ends_within(text, (from, to), (signs, depth + 1), used, ends);
        } else {
            *used += length;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_rows_are_aligned_at_the_equals_sign() {
        assert_eq!(row("a + b = c"), "a + b &= c");
    }

    #[test]
    fn rows_begin_together_beside_a_long_left_side() {
        let equations = ["a = b".to_owned(), "c = d + e".to_owned()];
        assert_eq!(rows(&equations), ["a &= b", "c &= d + e"]);
        let long = format!("{} = 0", ["l_{1} \\theta"; 60].join(" + "));
        let rows = rows(&[equations.as_slice(), &[long]].concat());
        assert_eq!(rows[..2], ["&a = b", "&c = d + e"]);
        assert!(rows[2].starts_with("&l_{1} \\theta + "));
    }

    #[test]
    fn long_rows_end_before_signs() {
        let term = "m_{1} l_{1} g \\sin\\left(\\theta_{1} - \\theta_{2}\\right)";
        let right = [term; 12].join(" + ");
        let row = row(&format!("p = {right}"));
        let rows: Vec<_> = row.split(CONTINUED).collect();
        assert!(rows.len() > 1);
        assert!(rows[1..].iter().all(|row| row.starts_with("+ ")));
        assert!(rows.iter().all(|row| visible(row) <= MAX_ROW_LENGTH + 2));
        assert_eq!(rows.join(" "), format!("p &= {right}"));
    }

    #[test]
    fn brackets_within_which_a_row_ends_are_no_pairs() {
        let term = "m_{1} \\left(\\dot{x}_{1} + l_{1} \\dot{\\theta}_{1}\\right)";
        let sum = [term; 12].join(" + ");
        let row = row(&format!("k \\left({sum}\\right) = 0"));
        assert!(row.starts_with("&k \\bigl("), "{row}");
        assert!(row.ends_with("\\bigr) = 0"), "{row}");
        for row in row.split(CONTINUED) {
            let [left, right] = ["\\left", "\\right"].map(|word| row.matches(word).count());
            assert_eq!(left, right, "{row}");
        }
    }

    #[test]
    fn arguments_are_whole() {
        for function in ["\\sin", "\\sin^{2}", "\\operatorname{f}"] {
            for length in 80..140 {
                let stiffness = "k".repeat(length);
                let call = format!("{function}\\left(\\left(q_{{1}} + l\\right) + q_{{2}}\\right)");
                let row = row(&format!("x = {stiffness} {call} + m + l"));
                assert!(row.contains(&call), "{row}");
            }
        }
    }

    #[test]
    fn numerators_are_whole() {
        let term = "m_{1} l_{1} \\dot{\\theta}_{1}";
        let sum = vec![term; 40].join(" + ");
        let row = row(&format!("x = \\frac{{{sum}}}{{2}}"));
        assert!(!row.contains('\n'), "{row}");
    }
}
