//! Formulas written from left to right.
//!
//! What is still to be written lies on a stack, so that depth costs no recursion: a formula is taken off and its own pieces
//! are put in its place.

use std::borrow::Cow;

use crate::print::layout::Layout;
use crate::print::line::Line;
use crate::print::notation::Notation;
use crate::print::piece::Piece::{self, BeforeBar, Close, Formula, Middle, Open, Term, Text};
use crate::print::printed::{Part, Precedence, Printed};

/// A formula of which the rest is still to be written.
pub(crate) struct Writer<'a> {
    /// What lays out expressions, if there are any.
    layout: Option<Layout<'a>>,
    stack: Vec<Piece>,
    line: Line,
}

/// The texts of a formula.
impl Iterator for Writer<'_> {
    type Item = Cow<'static, str>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            match self.next_piece()? {
                Text(text) | Open(text) | Close(text) => return Some(text),
                Middle(text) => return Some(text.into()),
                piece => self.expand(piece),
            }
        }
    }
}

impl<'a> Writer<'a> {
    pub(crate) fn new(notation: Notation, layout: Option<Layout<'a>>, formula: Printed) -> Self {
        Self {
            layout,
            stack: vec![Formula(formula)],
            line: Line::new(notation),
        }
    }

    /// How long the rest is to read: its characters, and more for the indices of families; one more than `most` if it is longer.
    pub(crate) fn length(mut self, most: usize) -> usize {
        let mut length = 0;
        while length <= most
            && let Some(piece) = self.next_piece()
        {
            if let Formula(Printed(Part::Name(name))) | BeforeBar(Printed(Part::Name(name))) =
                &piece
            {
                length += name.reading_of_indices();
            }
            match piece.text() {
                Some(text) => length += text.chars().count(),
                None => self.expand(piece),
            }
        }
        length.min(most.saturating_add(1))
    }

    /// Takes off what is to be written next.
    pub(crate) fn next_piece(&mut self) -> Option<Piece> {
        self.stack.pop()
    }

    /// Puts the pieces of `piece` in its place.
    pub(crate) fn expand(&mut self, piece: Piece) {
        let line = &mut self.line;
        match (piece, &self.layout) {
            (Formula(Printed(Part::Unfolded(x, scale, _))), Some(layout)) => {
                line.pieces.push(Formula(layout.multiple(x, &scale)));
            }
            (BeforeBar(Printed(Part::Unfolded(x, scale, _))), Some(layout)) => {
                line.pieces.push(BeforeBar(layout.multiple(x, &scale)));
            }
            (
                Term(false, Printed(Part::Unfolded(x, scale, Precedence::Sum)), first),
                Some(layout),
            ) => {
                line.continued(layout.multiple(x, &scale), first);
            }
            (Term(negative, term, first), _) => line.term(negative, term, first),
            (Formula(formula), _) => line.formula(formula, false),
            (BeforeBar(formula), _) => line.formula(formula, true),
            (piece, _) => line.pieces.push(piece),
        }
        self.stack.extend(line.pieces.drain(..).rev());
    }
}

impl Printed {
    /// The formula as it is read, in both notations.
    #[must_use]
    pub fn both(&self) -> [String; 2] {
        [Notation::Unicode, Notation::Latex].map(|notation| self.written(notation))
    }

    /// How long it is to read: its characters in Unicode, and more for the indices of families.
    pub(crate) fn length(&self) -> usize {
        Writer::new(Notation::Unicode, None, self.clone()).length(usize::MAX)
    }

    /// The formula as it is read.
    pub(crate) fn written(&self, notation: Notation) -> String {
        Writer::new(notation, None, self.clone()).collect()
    }
}
