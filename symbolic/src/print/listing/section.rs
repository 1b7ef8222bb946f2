//! Equations under one heading, as many as there is room for.

use std::fmt::Write as _;

use crate::limits::{
    MAX_LINE_LENGTH, MAX_SECTION_LENGTH, MAX_SKIMMED_LENGTH, MAX_UNFOLDED_LINE_LENGTH,
    MAX_UNFOLDED_SECTION_LENGTH, MIN_LINE,
};
use crate::print::folding::token::{Line, MARKS, tokens, written};
use crate::print::folding::{Folded, families};
use crate::print::listing::Listing;
use crate::print::listing::row_breaks::rows;
use crate::print::names::Letters;
use crate::print::notation::Notation;
use crate::{Expression, Graph};

/// One side of an equation.
#[derive(Clone, Debug)]
pub(crate) enum Side {
    /// The same text in Unicode and in LaTeX.
    Text(String, String),
    /// An expression.
    Expression(Expression),
}

/// Equations under one heading.
#[derive(Clone, Debug)]
pub(crate) struct Section {
    /// In Unicode and in LaTeX.
    heading: Option<[String; 2]>,
    /// What has the equations that are left out.
    pub(crate) method: &'static str,
    pub(crate) lines: Vec<(Side, Side)>,
    /// The lines in Unicode, before they are folded.
    texts: Vec<String>,
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
            texts: Vec::new(),
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
    pub(crate) fn push(&mut self, graph: &Graph, letters: &Letters, left: Side, right: Side) {
        let sides = [&left, &right];
        let [before, after] = sides.map(|side| side.unicode(graph, letters));
        let text = format!("{before} = {after}");
        let length = text.chars().count() + 1;
        if length > self.room.min(MAX_UNFOLDED_LINE_LENGTH) {
            let symbols = sides.map(|side| side.symbols(graph, letters));
            self.leave_out(u64::saturating_add(symbols[0], symbols[1]));
        } else {
            self.room -= length;
            self.lines.push((left, right));
            self.texts.push(text);
        }
    }

    /// The expressions that stand in its equations.
    pub(crate) fn expressions(&self) -> impl Iterator<Item = Expression> {
        let sides = self.lines.iter().flat_map(|(left, right)| [left, right]);
        sides.filter_map(|side| match side {
            Side::Expression(x) => Some(*x),
            Side::Text(..) => None,
        })
    }

    /// The equations of families folded to one, in both notations.
    fn folded(&self, graph: &Graph, letters: &Letters) -> [Vec<Folded>; 2] {
        let unicode = self.texts.iter().map(|text| tokens(text)).collect();
        let latex = self.lines.iter().map(|(left, right)| {
            let [left, right] = [left, right].map(|side| side.latex(graph, letters));
            tokens(&format!("{left} = {right}"))
        });
        let lines: [Vec<_>; 2] = [unicode, latex.collect()];
        if !self.texts.iter().any(|text| text.contains(MARKS[0])) {
            return singles(lines);
        }
        let folded = [&lines[0], &lines[1]].map(|lines| families(lines));
        let [unicode, latex] =
            [&folded[0], &folded[1]].map(|list| list.iter().map(|fold| &fold.members));
        if unicode.eq(latex) {
            return folded;
        }
        singles(lines)
    }

    /// The equations that there is room for, in both notations, and the sizes of the others.
    fn fitting(&self, graph: &Graph, letters: &Letters) -> ([Vec<String>; 2], Vec<u64>) {
        let mut left_out = self.left_out.clone();
        let mut room = MAX_SECTION_LENGTH;
        let indices = letters.index_letters();
        let [unicode, latex] = self.folded(graph, letters);
        let (mut displayed, mut displays) = (Vec::new(), Vec::new());
        let size = |position: &usize| {
            let (left, right) = &self.lines[*position];
            u64::saturating_add(left.symbols(graph, letters), right.symbols(graph, letters))
        };
        for (unicode, latex) in unicode.iter().zip(&latex) {
            let text = unicode.written(Notation::Unicode, indices);
            let length = text.chars().count();
            if length > room.min(MAX_LINE_LENGTH) {
                left_out.extend(unicode.members.iter().map(size));
                continue;
            }
            room -= length;
            displayed.push(text);
            displays.push(latex.written(Notation::Latex, indices));
        }
        ([displayed, rows(&displays)], left_out)
    }

    /// How long the lines are that were pushed, in characters of Unicode; none for those that are left out. Nothing is folded
    /// across them.
    pub(crate) fn lengths(&self, graph: &Graph, letters: &Letters) -> Vec<Option<usize>> {
        if !self.left_out.is_empty() {
            return vec![None; self.left_out.len() + self.lines.len()];
        }
        let lengths = self.texts.iter().map(|text| text.chars().count());
        if lengths.clone().all(|length| length <= MAX_SKIMMED_LENGTH) {
            return lengths.map(Some).collect();
        }
        let ([lines, _], left_out) = self.fitting(graph, letters);
        if !left_out.is_empty() {
            return vec![None; self.lines.len()];
        }
        let lengths = lines.iter().map(|line| Some(line.chars().count()));
        lengths.collect()
    }

    /// Whether no line is left out.
    pub(crate) fn has_room_for_all(&self, graph: &Graph, letters: &Letters) -> bool {
        self.fitting(graph, letters).1.is_empty()
    }

    /// How long its lines are, as they are written, in characters; of lines that are left out, as long as there would be room.
    pub(crate) fn written_length(&self, graph: &Graph, letters: &Letters) -> usize {
        let ([lines, _], left_out) = self.fitting(graph, letters);
        let lines = lines.iter().map(|line| line.chars().count());
        lines.sum::<usize>() + left_out.len() * MAX_LINE_LENGTH
    }

    pub(crate) fn write(&self, graph: &Graph, letters: &Letters, listing: &mut Listing) {
        let ([lines, displays], sizes) = self.fitting(graph, letters);
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
        let indices = letters.index_letters();
        let in_latex = left_out.replace('`', "").replace('_', "\\_");
        for [unicode, latex] in [&[left_out, in_latex], &self.sentence] {
            if !unicode.is_empty() {
                let unicode = written(&tokens(unicode), Notation::Unicode, indices);
                let latex = written(&tokens(latex), Notation::Latex, indices);
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

impl Side {
    /// A letter in Unicode and in LaTeX.
    pub(crate) fn letter([unicode, latex]: [&str; 2]) -> Self {
        Self::Text(unicode.into(), latex.into())
    }

    /// A text in Unicode and in LaTeX.
    pub(crate) fn texts(texts: &[String; 2]) -> Self {
        let [unicode, latex] = texts.clone();
        Self::Text(unicode, latex)
    }

    fn unicode(&self, graph: &Graph, letters: &Letters) -> String {
        match self {
            Self::Text(text, _) => text.clone(),
            Self::Expression(x) => {
                let formula = graph.display_in(*x, letters);
                formula.limit(MAX_UNFOLDED_LINE_LENGTH + 1).to_string()
            }
        }
    }

    fn latex(&self, graph: &Graph, letters: &Letters) -> String {
        match self {
            Self::Text(_, text) => text.clone(),
            Self::Expression(x) => graph.display_in(*x, letters).in_latex().to_string(),
        }
    }

    fn symbols(&self, graph: &Graph, letters: &Letters) -> u64 {
        match self {
            Self::Text(..) => 0,
            Self::Expression(x) => graph.written_symbols(&[*x], letters),
        }
    }
}

/// Lines that are not folded, in both notations.
fn singles(lines: [Vec<Line>; 2]) -> [Vec<Folded>; 2] {
    lines.map(|lines| {
        let singles = lines.into_iter().enumerate();
        singles
            .map(|(position, line)| Folded::single(position, line))
            .collect()
    })
}
