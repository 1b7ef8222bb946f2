//! Long rows of LaTeX broken before + and − (American Mathematical Society, User's Guide for the amsmath Package, 2020,
//! section 3.3).
//!
//! `\left` and `\right` have to stand in one row, so that brackets within which a row ends are written with `\bigl` and `\bigr`.
//! Nothing is broken within braces, where there are numerators, denominators and arguments of roots, nor within the brackets
//! around the arguments of a function.

use crate::limits::MAX_ROW_LENGTH;
use crate::print::notation::Notation;
use crate::print::piece::Piece;
use crate::print::printed::Printed;
use crate::print::writer::Writer;

/// What begins a row that continues another one.
const CONTINUED: &str = " \\\\\n&\\quad";

/// The equations as rows of a display: aligned at the equals signs, or all at their beginnings if the left side of one is
/// long, beside which the others would stand far to the right.
pub(crate) fn rows(equations: Vec<Printed>) -> Vec<String> {
    let rows = equations.into_iter();
    let rows = rows.map(|equation| Row::of(equation).written());
    let mut rows: Vec<_> = rows.collect();
    if rows.iter().any(|row| row.starts_with('&')) {
        for row in rows.iter_mut().filter(|row| !row.starts_with('&')) {
            *row = format!("&{}", row.replacen("&= ", "= ", 1));
        }
    }
    rows
}

/// An equation in pieces, some of which are signs before which a row may begin.
#[derive(Default)]
struct Row {
    pieces: Vec<String>,
    /// The place of the equals sign.
    equals: usize,
    /// The places of signs, each with how many brackets it is in.
    signs: Vec<(usize, usize)>,
    /// Where brackets that may hold the end of a row open and close.
    brackets: Vec<[usize; 2]>,
}

impl Row {
    fn of(equation: Printed) -> Self {
        let mut row = Self::default();
        let mut open = Vec::new();
        // Brackets within which nothing is broken.
        let mut closed = 0_usize;
        let mut is_after_name = false;
        let mut writer = Writer::new(Notation::Latex, None, equation);
        while let Some(piece) = writer.next_piece() {
            let Some(text) = piece.text() else {
                writer.expand(piece);
                continue;
            };
            let place = row.pieces.len();
            match (&piece, text) {
                (Piece::Open(_), "\\left(") if closed == 0 && !is_after_name => open.push(place),
                (Piece::Open(_), _) => closed += 1,
                (Piece::Close(_), _) if closed > 0 => closed -= 1,
                (Piece::Close(_), _) => row.brackets.extend(open.pop().map(|open| [open, place])),
                (_, " = ") if row.equals == 0 => row.equals = place,
                (_, " + " | " - ") if closed == 0 => row.signs.push((place, open.len())),
                _ => {}
            }
            if let Some(last) = text.chars().last() {
                // Before a bracket that is not around arguments there is a space.
                is_after_name = last.is_alphanumeric() || last == '}';
            }
            row.pieces.push(text.to_owned());
        }
        row
    }

    /// The row, aligned at the equals sign, or at its beginning where the left side is long.
    fn written(mut self) -> String {
        let count = self.pieces.len();
        let (left, right) = (
            self.length(0, self.equals),
            self.length(self.equals + 1, count),
        );
        if 2 * left > MAX_ROW_LENGTH && left + right > MAX_ROW_LENGTH {
            self.end_rows((0, count), 0);
            return format!("&{}", self.pieces.concat());
        }
        if left + right > MAX_ROW_LENGTH {
            self.end_rows((self.equals + 1, count), left);
        }
        " &= ".clone_into(&mut self.pieces[self.equals]);
        self.pieces.concat()
    }

    fn length(&self, start: usize, end: usize) -> usize {
        let pieces = self.pieces[start..end].iter();
        pieces.map(|piece| visible(piece)).sum()
    }

    /// Ends rows in a part of the equation, of whose first row so much is used.
    fn end_rows(&mut self, part: (usize, usize), mut used: usize) {
        let mut ends = Vec::new();
        self.find_ends(part, 0, &mut used, &mut ends);
        for [open, close] in &self.brackets {
            if ends.iter().any(|end| (open..close).contains(&end)) {
                for (place, from, to) in
                    [(*open, "\\left", "\\bigl"), (*close, "\\right", "\\bigr")]
                {
                    self.pieces[place] = self.pieces[place].replace(from, to);
                }
            }
        }
        for end in ends {
            self.pieces[end].insert_str(0, CONTINUED);
        }
    }

    /// Finds ends of rows: before signs in so many brackets, or in more where a term is too long.
    fn find_ends(
        &self,
        (start, end): (usize, usize),
        depth: usize,
        used: &mut usize,
        ends: &mut Vec<usize>,
    ) {
        let signs = self.signs.iter();
        let own = signs.filter(|(place, of)| *of == depth && (start..end).contains(place));
        let places: Vec<_> = own.map(|(place, _)| *place).collect();
        let starts = [start].into_iter().chain(places.iter().copied());
        let stops = places.iter().copied().chain([end]);
        for (number, (from, to)) in starts.zip(stops).enumerate() {
            let length = self.length(from, to);
            if number > 0 && *used + length > MAX_ROW_LENGTH && *used > 0 {
                ends.push(from);
                *used = 0;
            }
            let mut signs = self.signs.iter();
            let has_more = signs.any(|(place, of)| *of > depth && (from..to).contains(place));
            if *used + length > MAX_ROW_LENGTH && has_more {
                self.find_ends((from, to), depth + 1, used, ends);
            } else {
                *used += length;
            }
        }
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Unary;
    use crate::print::printed::Part;

    const NEXT: &str = " \\\\\n&\\quad ";

    fn name(text: &str) -> Printed {
        Printed::text([text, text])
    }

    fn product(factors: &[&str]) -> Printed {
        Printed::of_factors(factors.iter().map(|factor| name(factor)).collect())
    }

    /// So many times the same term.
    fn repeated(term: &Printed, count: usize) -> Printed {
        Printed::sum(vec![term.clone(); count])
    }

    fn row(left: Printed, right: Printed) -> String {
        Row::of(left.equals(right)).written()
    }

    #[test]
    fn short_rows_are_aligned_at_the_equals_sign() {
        let sum = Printed::sum(["a", "b"].map(name));
        assert_eq!(row(sum, name("c")), "a + b &= c");
    }

    #[test]
    fn rows_begin_together_beside_a_long_left_side() {
        let sum = Printed::sum(["d", "e"].map(name));
        let mut equations = vec![name("a").equals(name("b")), name("c").equals(sum)];
        assert_eq!(rows(equations.clone()), ["a &= b", "c &= d + e"]);
        let long = repeated(&product(&["l_{1}", "\\theta"]), 60);
        equations.push(long.equals(Printed::zero()));
        let rows = rows(equations);
        assert_eq!(rows[..2], ["&a = b", "&c = d + e"]);
        assert!(rows[2].starts_with("&l_{1} \\theta + "));
    }

    #[test]
    fn long_rows_end_before_signs() {
        let angle = name("\\theta_{1}").plus(name("\\theta_{2}"), true);
        let sine = Printed(Part::Function(Unary::Sin, Box::new(angle)));
        let right = repeated(&product(&["m_{1}", "l_{1}", "g"]).times(sine), 12);
        let row = row(name("p"), right.clone());
        let rows: Vec<_> = row.split(NEXT).collect();
        assert!(rows.len() > 1);
        assert!(rows[1..].iter().all(|row| row.starts_with("+ ")));
        assert!(rows.iter().all(|row| visible(row) <= MAX_ROW_LENGTH + 2));
        assert_eq!(
            rows.join(" "),
            format!("p &= {}", right.written(Notation::Latex))
        );
    }

    #[test]
    fn brackets_within_which_a_row_ends_are_no_pairs() {
        let velocity = name("\\dot{x}_{1}").plus(product(&["l_{1}", "\\dot{\\theta}_{1}"]), false);
        let sum = repeated(&name("m_{1}").times(velocity), 12);
        let row = row(name("k").times(sum), Printed::zero());
        assert!(row.starts_with("&k \\bigl("), "{row}");
        assert!(row.ends_with("\\bigr) = 0"), "{row}");
        for row in row.split(NEXT) {
            let [left, right] = ["\\left", "\\right"].map(|word| row.matches(word).count());
            assert_eq!(left, right, "{row}");
        }
    }

    #[test]
    fn arguments_are_whole() {
        let inner = Printed::list(vec![Printed::sum(["q_{1}", "l"].map(name))]);
        let argument = inner.plus(name("q_{2}"), false);
        let sine = Printed(Part::Function(Unary::Sin, Box::new(argument.clone())));
        let square = sine
            .clone()
            .power(Printed::number(&crate::Rational::integer(2)));
        let external = Printed::call(["f", "\\operatorname{f}"], vec![argument]);
        for call in [sine, square, external] {
            for length in 80..140 {
                let first = name(&"k".repeat(length)).times(call.clone());
                let right = Printed::sum([first, name("m"), name("l")]);
                let row = row(name("x"), right);
                assert!(row.contains(&call.written(Notation::Latex)), "{row}");
            }
        }
    }

    #[test]
    fn numerators_are_whole() {
        let sum = repeated(&product(&["m_{1}", "l_{1}", "\\dot{\\theta}_{1}"]), 40);
        let row = row(name("x"), sum.over(name("2")));
        assert!(!row.contains('\n'), "{row}");
    }
}
