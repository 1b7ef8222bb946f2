//! Patterns of families in Unicode and in LaTeX.

use crate::print::folding::token::{MARKS, lowered};
use crate::print::listing::as_declared::print_sum_sign;
use crate::print::listing::index_letters::IndexLetters;
use crate::print::listing::index_pattern::{Argument, Bound, IndexPattern};
use crate::print::names::Letters;
use crate::{Expression, Graph, Node, Rational, Symbol};

/// The usual letters of the indices.
const INDICES: [char; 2] = ['i', 'j'];
/// What an argument is called until it is printed.
const FIRST_SIGN: u32 = 0xE010;

/// A pattern in print.
#[derive(Clone, Debug)]
pub(crate) struct PatternText {
    /// In Unicode and in LaTeX.
    pub(crate) texts: [String; 2],
    is_sum: bool,
}

impl PatternText {
    /// That of a pattern.
    pub(crate) fn of(pattern: &IndexPattern, graph: &mut Graph, letters: &Letters) -> Self {
        let count = u32::try_from(pattern.arguments.len()).unwrap_or(u32::MAX);
        let mut letters = letters.clone();
        for (k, sign) in (0..=count).zip(FIRST_SIGN..) {
            let argument = graph.symbol(Symbol::Argument(k));
            letters = letters.with_sign(argument, char::from_u32(sign).unwrap_or('Σ'));
        }
        let whole = multiplied(pattern, graph, &letters, count);
        let formula = graph.display_in(whole, &letters);
        let mut texts = [formula.to_string(), formula.in_latex().to_string()];
        let arguments = pattern.arguments.iter();
        let arguments = arguments.map(|argument| argument_texts(argument, &letters));
        let indices = letters.index_letters();
        let index = of_bound(pattern.factor.of, indices);
        let latex = index.replace('m', "\\m");
        for (argument, sign) in arguments.chain([[index, latex]]).zip(FIRST_SIGN..) {
            let sign = char::from_u32(sign).unwrap_or('Σ');
            for (text, argument) in texts.iter_mut().zip(argument) {
                *text = text.replace(sign, &argument);
            }
        }
        Self {
            texts: with_indices(texts, &pattern.sample, indices),
            is_sum: matches!(graph.node(whole), Node::Sum(terms) if terms.len() > 1),
        }
    }

    /// A name with an index i in place of a number.
    pub(crate) fn of_name(name: [String; 2], number: i64, indices: IndexLetters) -> [String; 2] {
        with_indices(name, &[number], indices)
    }

    /// The sum of several; of none, 0.
    pub(crate) fn total(terms: impl Iterator<Item = Self>) -> Self {
        let sum = terms.reduce(|sum, term| {
            let signs = [["−", " − "], ["-", " - "]];
            let texts = [0, 1].map(|notation| {
                let (before, text) = (&sum.texts[notation], &term.texts[notation]);
                let [minus, between] = signs[notation];
                match text.strip_prefix(minus) {
                    Some(rest) => format!("{before}{between}{rest}"),
                    None => format!("{before} + {text}"),
                }
            });
            Self {
                texts,
                is_sum: true,
            }
        });
        sum.unwrap_or_else(|| Self {
            texts: ["0", "0"].map(String::from),
            is_sum: false,
        })
    }
}

/// The sum over the second index.
pub(crate) fn sum_over(
    [first, last]: [i64; 2],
    term: &PatternText,
    indices: IndexLetters,
) -> PatternText {
    let [first, last] = [first, last].map(|index| index.to_string());
    let signs = print_sum_sign(&indices.text(INDICES[1]), &first, &last);
    let brackets = [["(", ")"], ["\\left(", "\\right)"]];
    let texts = [0, 1].map(|notation| {
        let text = &term.texts[notation];
        let encloses = term.is_sum || text.starts_with(['−', '-']);
        let [open, close] = if encloses {
            brackets[notation]
        } else {
            [""; 2]
        };
        format!("{}{open}{text}{close}", signs[notation])
    });
    PatternText {
        texts,
        is_sum: false,
    }
}

/// A pattern times its factor, in which the last argument is the index.
fn multiplied(
    pattern: &IndexPattern,
    graph: &mut Graph,
    letters: &Letters,
    last: u32,
) -> Expression {
    let factor = &pattern.factor;
    if factor.slope.is_zero() {
        return graph.scale(pattern.sample_with_arguments, &factor.constant);
    }
    let index = graph.symbol(Symbol::Argument(last));
    let factor = graph.sum([
        (graph.one(), factor.constant.clone()),
        (index, factor.slope.clone()),
    ]);
    let product = graph.product([
        (factor, Rational::ONE),
        (pattern.sample_with_arguments, Rational::ONE),
    ]);
    graph.arranged(product, letters)
}

/// What an argument is in print: `(Σₖ₌ᵢ⁵ mₖ)`, or `m_max(i,j)`.
fn argument_texts(argument: &Argument, letters: &Letters) -> [String; 2] {
    let indices = letters.index_letters();
    let mut member = letters.print_both(argument.member);
    let index = format!("{}{}{}", MARKS[0], argument.index, MARKS[1]);
    let [first, last] = argument.bounds.map(|bound| of_bound(bound, indices));
    if !argument.is_sum {
        let below = [format!("_{first}"), first.replace('m', "\\m")];
        for (text, below) in member.iter_mut().zip(below) {
            *text = text.replace(&index, &below);
        }
        return member;
    }
    let [unicode, latex] = print_sum_sign(&indices.text('k'), &first, &last);
    let signs = [
        unicode,
        latex.replace("max", "\\max").replace("min", "\\min"),
    ];
    let brackets = [["(", ")"], ["\\left(", "\\right)"]];
    let below = [lowered(&indices.text('k')), indices.text('k')];
    [0, 1].map(|notation| {
        let member = member[notation].replace(&index, &below[notation]);
        let [open, close] = brackets[notation];
        format!("{open}{}{member}{close}", signs[notation])
    })
}

/// The numbers of a sample as indices.
fn with_indices(mut texts: [String; 2], sample: &[i64], indices: IndexLetters) -> [String; 2] {
    for (number, name) in sample.iter().zip(INDICES) {
        let name = indices.text(name);
        let marked = format!("{}{number}{}", MARKS[0], MARKS[1]);
        texts[0] = texts[0].replace(&marked, &lowered(&name));
        texts[1] = texts[1].replace(&marked, &name);
    }
    texts
}

/// An index as it is printed.
fn of_bound(bound: Bound, indices: IndexLetters) -> String {
    let [i, j] = INDICES.map(|letter| indices.text(letter));
    match bound {
        Bound::Fixed(number) => number.to_string(),
        Bound::Index(k) => indices.text(INDICES[k]),
        Bound::Greater => format!("max({i},{j})"),
        Bound::Lesser => format!("min({i},{j})"),
    }
}
