//! Equations under one heading, as many as there is room for.

use std::fmt::Write as _;

use crate::limits::{
    MAX_LINE_LENGTH, MAX_SECTION_LENGTH, MAX_SKIMMED_LENGTH, MAX_UNFOLDED_LINE_LENGTH,
    MAX_UNFOLDED_SECTION_LENGTH, MIN_LINE,
};
use crate::print::folding::{Folded, folded};
use crate::print::listing::Listing;
use crate::print::listing::row_breaks::rows;
use crate::print::names::Letters;
use crate::print::notation::Notation;
use crate::print::printed::Printed;
use crate::{Expression, Graph};

/// One side of an equation.
#[derive(Clone, Debug)]
pub(crate) enum Side {
    Printed(Printed),
    /// An expression that is written out.
    Expression(Expression),
}

impl From<Printed> for Side {
    fn from(printed: Printed) -> Self {
        Self::Printed(printed)
    }
}

impl From<Expression> for Side {
    fn from(x: Expression) -> Self {
        Self::Expression(x)
    }
}

/// An equation before it is folded.
#[derive(Clone, Debug)]
struct Line {
    equation: Printed,
    length: usize,
    /// How many symbols its expressions have.
    symbols: u64,
}

/// Equations under one heading.
#[derive(Clone, Debug)]
pub(crate) struct Section {
    /// In Unicode and in LaTeX.
    heading: Option<[String; 2]>,
    /// What has the equations that are left out.
    pub(crate) method: &'static str,
    lines: Vec<Line>,
    /// The expressions that stand in its equations.
    pub(crate) expressions: Vec<Expression>,
    /// The numbers of symbols of the equations that are left out.
    left_out: Vec<u64>,
    /// How many equations are said by others than lines of their own.
    said_otherwise: usize,
    /// A sentence behind the equations, in Unicode and in LaTeX.
    pub(crate) sentence: [String; 2],
    /// How many characters may be added before lines are folded.
    room: usize,
}

impl Section {
    pub(crate) fn new(heading: Option<[String; 2]>, method: &'static str) -> Self {
        Self {
            heading,
            method,
            lines: Vec::new(),
            expressions: Vec::new(),
            left_out: Vec::new(),
            said_otherwise: 0,
            sentence: [String::new(), String::new()],
            room: MAX_UNFOLDED_SECTION_LENGTH,
        }
    }

    /// Whether a short equation may have room.
    pub(crate) const fn has_room(&self) -> bool {
        self.room > MIN_LINE
    }

    /// Says that a line stands for so many equations more.
    pub(crate) const fn stands_for_more(&mut self, count: usize) {
        self.said_otherwise += count;
    }

    /// Leaves out an equation of so many symbols.
    pub(crate) fn leave_out(&mut self, symbols: u64) {
        self.left_out.push(symbols);
    }

    /// Adds an equation if there is room.
    pub(crate) fn push(&mut self, graph: &Graph, letters: &Letters, sides: [Side; 2]) {
        let expressions = sides.iter().filter_map(|side| match side {
            Side::Expression(x) => Some(*x),
            Side::Printed(_) => None,
        });
        let expressions: Vec<_> = expressions.collect();
        let symbols = expressions.iter();
        let symbols = symbols.map(|x| graph.written_symbols(&[*x], letters));
        let symbols = symbols.fold(0, u64::saturating_add);
        let printed = sides.map(|side| match side {
            Side::Printed(printed) => Some(printed),
            Side::Expression(x) => graph.written_out(x, letters),
        });
        let room = self.room.min(MAX_UNFOLDED_LINE_LENGTH);
        if let [Some(left), Some(right)] = printed
            && let equation = left.equals(right)
            && let length = equation.length()
            && length < room
        {
            self.room -= length + 1;
            self.expressions.extend(expressions);
            self.lines.push(Line {
                equation,
                length,
                symbols,
            });
        } else {
            self.leave_out(symbols);
        }
    }

    /// The equations that there is room for, in both notations, and the sizes of the others.
    fn fitting(&self, letters: &Letters) -> ([Vec<String>; 2], Vec<u64>) {
        let mut left_out = self.left_out.clone();
        let mut room = MAX_SECTION_LENGTH;
        let (mut displayed, mut displays) = (Vec::new(), Vec::new());
        let equations: Vec<_> = self.lines.iter().map(|line| &line.equation).collect();
        for Folded { equation, members } in folded(&equations, letters.index_letters()) {
            let text = equation.written(Notation::Unicode);
            let length = text.chars().count();
            if length > room.min(MAX_LINE_LENGTH) {
                left_out.extend(members.iter().map(|member| self.lines[*member].symbols));
                continue;
            }
            room -= length;
            displayed.push(text);
            displays.push(equation);
        }
        ([displayed, rows(displays)], left_out)
    }

    /// How long the lines are that were pushed, in characters of Unicode; none for those that are left out. Nothing is folded
    /// across them.
    pub(crate) fn lengths(&self, letters: &Letters) -> Vec<Option<usize>> {
        if !self.left_out.is_empty() {
            return vec![None; self.left_out.len() + self.lines.len()];
        }
        let lengths = self.lines.iter().map(|line| line.length);
        if lengths.clone().all(|length| length <= MAX_SKIMMED_LENGTH) {
            return lengths.map(Some).collect();
        }
        let ([lines, _], left_out) = self.fitting(letters);
        if !left_out.is_empty() {
            return vec![None; self.lines.len()];
        }
        let lengths = lines.iter().map(|line| Some(line.chars().count()));
        lengths.collect()
    }

    /// Whether no line is left out.
    pub(crate) fn has_room_for_all(&self, letters: &Letters) -> bool {
        self.fitting(letters).1.is_empty()
    }

    /// How long its lines are, as they are written, in characters; of lines that are left out, as long as there would be room.
    pub(crate) fn written_length(&self, letters: &Letters) -> usize {
        let ([lines, _], left_out) = self.fitting(letters);
        let lines = lines.iter().map(|line| line.chars().count());
        lines.sum::<usize>() + left_out.len() * MAX_LINE_LENGTH
    }

    pub(crate) fn write(&self, letters: &Letters, listing: &mut Listing) {
        let ([lines, displays], sizes) = self.fitting(letters);
        let left_out = self.what_is_left_out(&sizes);
        if lines.is_empty() && left_out.is_empty() && self.sentence[0].is_empty() {
            return;
        }
        // Writing to a `String` does not fail.
        if let Some([unicode, latex]) = &self.heading {
            let _ = writeln!(listing.unicode, "\n{unicode}");
            let _ = writeln!(listing.latex, "{latex}");
        }
        for line in lines {
            let _ = writeln!(listing.unicode, "{line}");
        }
        if !displays.is_empty() {
            let displays = displays.join(" \\\\\n");
            let _ = writeln!(
                listing.latex,
                "\\begin{{align*}}\n{displays}\n\\end{{align*}}"
            );
        }
        let in_latex = left_out.replace('`', "").replace('_', "\\_");
        for [unicode, latex] in [&[left_out, in_latex], &self.sentence] {
            if !unicode.is_empty() {
                let _ = writeln!(listing.unicode, "{unicode}");
                let _ = writeln!(listing.latex, "{latex}");
            }
        }
    }

    /// What is said of equations that are left out.
    fn what_is_left_out(&self, sizes: &[u64]) -> String {
        let (Some(least), Some(most)) = (sizes.iter().min(), sizes.iter().max()) else {
            return String::new();
        };
        let all = self.left_out.len() + self.lines.len() + self.said_otherwise;
        let left_out = sizes.len();
        let which = match left_out {
            1 if all == 1 => "The equation is".to_owned(),
            1 => format!("One of {all} equations is"),
            _ if left_out == all => format!("The {all} equations are"),
            _ => format!("{left_out} of {all} equations are"),
        };
        let size = if least == most {
            format!("{least}")
        } else {
            format!("{least} to {most}")
        };
        let (verb, pronoun) = match left_out {
            1 => ("has", "it"),
            _ => ("have", "they"),
        };
        format!(
            "{which} too long to be written out: {pronoun} {verb} {size} symbols. See {}.",
            self.method
        )
    }
}
