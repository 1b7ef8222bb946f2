//! Formulas as in a book, in Unicode or in LaTeX.

use core::fmt;
use std::borrow::Cow;

use crate::limits::MAX_FORMULA_LENGTH;
use crate::print::layout::Layout;
use crate::print::notation::{ELLIPSIS, Notation};
use crate::print::piece::Piece;
use crate::print::writer::Writer;
use crate::{Expression, Graph, Letters, Names};

/// An expression with the names of its symbols, ready to be printed.
#[derive(Clone, Debug)]
pub struct Formula<'a> {
    graph: &'a Graph,
    letters: Cow<'a, Letters>,
    root: Expression,
    notation: Notation,
    limit: usize,
}

impl Graph {
    /// The expression as a line of Unicode, such as `½ m (ṙ² + r² φ̇²) + k/r`.
    ///
    /// The expression itself is written out even if it has a name; what it is made of is called by name.
    #[must_use]
    pub fn display(&self, expression: Expression, names: &Names) -> Formula<'_> {
        self.formula(expression, Cow::Owned(Letters::new(names)))
    }

    /// The same line in letters that several formulas share, so that they are found only once.
    #[must_use]
    pub fn display_in<'a>(&'a self, expression: Expression, letters: &'a Letters) -> Formula<'a> {
        self.formula(expression, Cow::Borrowed(letters))
    }

    /// The expression as LaTeX, for a place in mathematics mode.
    #[must_use]
    pub fn latex(&self, expression: Expression, names: &Names) -> Formula<'_> {
        self.display(expression, names).in_latex()
    }

    const fn formula<'a>(&'a self, root: Expression, letters: Cow<'a, Letters>) -> Formula<'a> {
        Formula {
            graph: self,
            letters,
            root,
            notation: Notation::Unicode,
            limit: MAX_FORMULA_LENGTH,
        }
    }
}

impl Formula<'_> {
    /// The same formula, broken off with `…` after about `characters` characters. Brackets that are
    /// open then are still closed.
    #[must_use]
    pub const fn limit(mut self, characters: usize) -> Self {
        self.limit = characters;
        self
    }

    /// The same formula in LaTeX.
    #[must_use]
    pub const fn in_latex(mut self) -> Self {
        self.notation = Notation::Latex;
        self
    }

    /// How [long](crate::print::printed::Printed::length) it is to read, or one more than `most` if it is longer.
    pub(crate) fn length(&self, most: usize) -> usize {
        self.writer().length(most)
    }

    fn writer(&self) -> Writer<'_> {
        let layout = Layout {
            graph: self.graph,
            letters: &self.letters,
        };
        let root = layout.body(self.root);
        Writer::new(self.notation, Some(layout), root)
    }
}

impl fmt::Display for Formula<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut writer = self.writer();
        let mut room = Room {
            left: self.limit,
            unopened: None,
        };
        let mut complete = true;
        while let Some(piece) = writer.next_piece() {
            let Some(text) = piece.text() else {
                if room.unopened.is_none() {
                    writer.expand(piece);
                }
                continue;
            };
            if room.admits(&piece, text) {
                formatter.write_str(text)?;
            } else if core::mem::take(&mut complete) {
                formatter.write_str(self.notation.of(ELLIPSIS))?;
            }
        }
        Ok(())
    }
}

/// How much more may be printed.
struct Room {
    left: usize,
    /// Once something was left out, the number of brackets that were not opened and are not closed yet.
    unopened: Option<usize>,
}

impl Room {
    fn admits(&mut self, piece: &Piece, text: &str) -> bool {
        if self.unopened.is_none() {
            let length = text.chars().count();
            if length <= self.left || matches!(piece, Piece::Close(_) | Piece::Middle(_)) {
                self.left = self.left.saturating_sub(length);
                return true;
            }
            self.unopened = Some(0);
        }
        let depth = self.unopened.get_or_insert(0);
        match piece {
            Piece::Open(_) => {
                *depth += 1;
                false
            }
            Piece::Middle(_) => *depth == 0,
            Piece::Close(_) if *depth == 0 => true,
            Piece::Close(_) => {
                *depth -= 1;
                false
            }
            _ => false,
        }
    }
}
