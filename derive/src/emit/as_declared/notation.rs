//! Formulas in Unicode and in LaTeX that remember how tightly they bind.

/// How tightly a formula binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Precedence {
    /// A sum, or anything with a minus sign in front.
    Sum,
    /// An inner product of vectors, perhaps with a minus sign in front: with a factor beside it, it would look like a product
    /// of three numbers.
    InnerProduct,
    /// A product or quotient, or a sum over an index.
    Product,
    /// A function of something.
    Function,
    /// A letter, or something within its own brackets.
    Atom,
}

/// A formula in Unicode and in LaTeX.
#[derive(Clone, Debug)]
pub(super) struct Notation {
    pub(super) texts: [String; 2],
    pub(super) precedence: Precedence,
}

/// Texts one behind the other, in both notations.
pub(super) fn join(parts: &[&[String; 2]], separator: &str) -> [String; 2] {
    [0, 1].map(|notation| {
        let parts: Vec<_> = parts.iter().map(|part| &*part[notation]).collect();
        parts.join(separator)
    })
}

impl Notation {
    pub(super) const fn new(texts: [String; 2], precedence: Precedence) -> Self {
        Self { texts, precedence }
    }

    pub(super) fn atom(unicode: impl Into<String>, latex: impl Into<String>) -> Self {
        Self::new([unicode.into(), latex.into()], Precedence::Atom)
    }

    /// In parentheses unless it binds at least so tightly.
    pub(super) fn at_least(self, precedence: Precedence) -> Self {
        if self.precedence >= precedence {
            self
        } else {
            self.within(["(", ")"], ["\\left(", "\\right)"])
        }
    }

    /// Within brackets, in Unicode and in LaTeX.
    pub(super) fn within(self, unicode: [&str; 2], latex: [&str; 2]) -> Self {
        let [inner, inner_latex] = self.texts;
        Self::atom(
            format!("{}{inner}{}", unicode[0], unicode[1]),
            format!("{}{inner_latex}{}", latex[0], latex[1]),
        )
    }

    /// With something behind it, in Unicode and in LaTeX.
    pub(super) fn followed_by(mut self, unicode: &str, latex: &str) -> Self {
        self.texts[0].push_str(unicode);
        self.texts[1].push_str(latex);
        self
    }

    pub(super) fn zero() -> Self {
        Self::atom("0", "0")
    }

    pub(super) fn is_zero(&self) -> bool {
        self.texts[0] == "0"
    }

    /// Terms in a row; of none, 0.
    pub(super) fn sum(terms: Vec<Self>) -> Self {
        let mut terms = terms.into_iter().filter(|term| !term.is_zero());
        let Some(first) = terms.next() else {
            return Self::zero();
        };
        terms.fold(first, |sum, term| sum.plus(term, false))
    }

    /// A term more, or one less.
    pub(super) fn plus(self, term: Self, minus: bool) -> Self {
        let negative = term.texts[0].starts_with('−');
        let is_signed = negative || term.precedence == Precedence::Sum;
        let term = if minus && is_signed {
            term.at_least(Precedence::Product)
        } else {
            term
        };
        let [term, in_latex] = term.texts;
        let (signs, term, in_latex) = match (minus, negative) {
            // A sum continues the one before it, with the sign of its first term.
            (false, true) => {
                let in_latex = in_latex.trim_start_matches('-');
                ([" − ", " - "], term.trim_start_matches('−'), in_latex)
            }
            (false, false) => ([" + "; 2], &*term, &*in_latex),
            (true, _) => ([" − ", " - "], &*term, &*in_latex),
        };
        let [mut unicode, mut latex] = self.texts;
        unicode.extend([signs[0], term]);
        latex.extend([signs[1], in_latex]);
        Self::new([unicode, latex], Precedence::Sum)
    }

    pub(super) fn negated(self) -> Self {
        let is_inner =
            self.precedence == Precedence::InnerProduct && !self.texts[0].starts_with('−');
        let (least, precedence) = if is_inner {
            (Precedence::InnerProduct, Precedence::InnerProduct)
        } else {
            (Precedence::Product, Precedence::Sum)
        };
        let [unicode, latex] = self.at_least(least).texts;
        Self::new([format!("−{unicode}"), format!("-{latex}")], precedence)
    }

    /// A product, with a dot where a word or a number would run into its neighbour.
    pub(super) fn times(self, other: Self) -> Self {
        let negative = self.texts[0].starts_with('−') && self.precedence == Precedence::Sum;
        let left = if negative {
            self
        } else {
            self.at_least(Precedence::Product)
        };
        let half_of_inner = is_number(&left.texts[0])
            && other.precedence == Precedence::InnerProduct
            && !other.texts[0].starts_with('−');
        let right = if half_of_inner {
            other
        } else {
            other.at_least(Precedence::Product)
        };
        // What a sum over an index or a function's argument comprises ends there.
        let left = if left.texts[0].starts_with('Σ') {
            let open = left.precedence;
            Self::new(left.texts, Precedence::Sum.min(open)).at_least(Precedence::Product)
        } else {
            left
        };
        let number =
            right.texts[0].starts_with(|c: char| c.is_ascii_digit() || "½⅓¼⅙⅛".contains(c));
        let separator = match () {
            () if number => ["·", " \\cdot "],
            () if is_number(&left.texts[0]) => [" ", "\\,"],
            () if ends_with_word(&left.texts[0]) || starts_with_word(&right.texts[0]) => {
                ["·", "\\,"]
            }
            () => [" ", " "],
        };
        let precedence = if negative {
            Precedence::Sum
        } else {
            Precedence::Product
        };
        let both = [0, 1].map(|i| format!("{}{}{}", left.texts[i], separator[i], right.texts[i]));
        Self::new(both, precedence)
    }

    pub(super) fn over(self, other: Self) -> Self {
        let [above, below] = [&self, &other].map(|side| side.texts[1].clone());
        let negative = self.texts[0].starts_with('−') && self.precedence == Precedence::Sum;
        let above_line = if negative {
            self
        } else {
            self.at_least(Precedence::Product)
        };
        let below_line = other.at_least(Precedence::Atom);
        let unicode = format!("{}/{}", above_line.texts[0], below_line.texts[0]);
        let precedence = if negative {
            Precedence::Sum
        } else {
            Precedence::Product
        };
        Self::new(
            [unicode, format!("\\frac{{{above}}}{{{below}}}")],
            precedence,
        )
    }
}

fn is_number(text: &str) -> bool {
    let mut digits = text.chars();
    digits.all(|c| c.is_numeric() || c == '.')
}

/// Whether the last name of a formula is longer than a letter.
pub(super) fn ends_with_word(text: &str) -> bool {
    let is_above = |c: char| ('\u{300}'..='\u{36f}').contains(&c) || "˙¨′".contains(c);
    let name: Vec<char> = text
        .chars()
        .rev()
        .take_while(|c| c.is_alphanumeric() || *c == '_' || *c == ',' || is_above(*c))
        .collect();
    is_word(name.into_iter().rev())
}

fn starts_with_word(text: &str) -> bool {
    let functions = ["sin", "cos", "tan", "exp", "ln", "sinh", "cosh", "tanh"];
    let name: String = text
        .chars()
        .take_while(|c| c.is_alphanumeric() || *c == '_')
        .collect();
    let before_bracket = text[name.len()..].starts_with('(');
    !functions.contains(&&*name) && !before_bracket && is_word(name.chars())
}

/// Whether there are two letters before any subscript, or a word below the line.
fn is_word(name: impl Iterator<Item = char>) -> bool {
    let letters = name.filter(|c| c.is_alphabetic() && !is_below_the_line(*c) || *c == '_');
    letters
        .collect::<String>()
        .split('_')
        .any(|part| part.chars().count() > 1)
}

fn is_below_the_line(c: char) -> bool {
    ('ₐ'..='ₜ').contains(&c) || ('ᵢ'..='ᵪ').contains(&c) || c == 'ⱼ'
}
