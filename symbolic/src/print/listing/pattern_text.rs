//! Patterns of families in print.

use crate::print::index::{Index, Range};
use crate::print::listing::index_letters::IndexLetters;
use crate::print::listing::index_pattern::{Argument, Bound, IndexPattern};
use crate::print::names::Letters;
use crate::print::printed::{Part, Printed};
use crate::{Expression, Graph, Rational, Symbol};

/// The usual letters of the indices.
const INDICES: [char; 2] = ['i', 'j'];

impl IndexPattern {
    /// The pattern with indices in place of the numbers of its sample; none where it is too long.
    pub(crate) fn printed(&self, graph: &mut Graph, letters: &Letters) -> Option<Printed> {
        let indices = letters.index_letters();
        let mut letters = letters.clone();
        for (k, argument) in (0..).zip(&self.arguments) {
            let name = argument.printed(&letters);
            letters.call(graph.symbol(Symbol::Argument(k)), name);
        }
        let index = self.factor.of.index(indices);
        let index = Printed::text([&index.text(), &index.latex()]);
        let last = u32::try_from(self.arguments.len()).ok()?;
        letters.call(graph.symbol(Symbol::Argument(last)), index);
        let whole = self.multiplied(graph, &letters, last);
        let formula = graph.printed(whole, &letters)?;
        Some(of_indices(formula, &self.sample, indices))
    }

    /// The sample times its factor, in which the last argument is the index.
    fn multiplied(&self, graph: &mut Graph, letters: &Letters, last: u32) -> Expression {
        let factor = &self.factor;
        if factor.slope.is_zero() {
            return graph.scale(self.sample_with_arguments, &factor.constant);
        }
        let index = graph.symbol(Symbol::Argument(last));
        let factor = graph.sum([
            (graph.one(), factor.constant.clone()),
            (index, factor.slope.clone()),
        ]);
        let product = graph.product([
            (factor, Rational::ONE),
            (self.sample_with_arguments, Rational::ONE),
        ]);
        graph.arranged(product, letters)
    }
}

impl Argument {
    /// What is written of it: `(Σₖ₌ᵢ⁵ mₖ)`, or `m_max(i,j)`.
    fn printed(&self, letters: &Letters) -> Printed {
        let indices = letters.index_letters();
        let [first, last] = self.bounds.map(|bound| bound.index(indices));
        let variable = indices.text('k');
        let index = if self.is_sum {
            Index::Variable(variable.clone(), 0)
        } else {
            first.clone()
        };
        let mut member = letters.symbol(self.member);
        for below in &mut member.indices {
            if *below == Index::Number(self.index) {
                *below = index.clone();
            }
        }
        let member = Printed(Part::Name(member));
        if !self.is_sum {
            return member;
        }
        let sum = member.summed(Range {
            variable,
            first,
            last,
        });
        Printed::list(vec![sum])
    }
}

impl Bound {
    /// The index as it is printed.
    fn index(self, letters: IndexLetters) -> Index {
        let [i, j] = INDICES.map(|letter| letters.text(letter));
        match self {
            // It is no index of a sample.
            Self::Fixed(number) => Index::Word(number.to_string()),
            Self::Index(k) => Index::Variable(letters.text(INDICES[k]), 0),
            Self::Greater => Index::Extreme("max", format!("{i},{j}")),
            Self::Lesser => Index::Extreme("min", format!("{i},{j}")),
        }
    }
}

/// A formula with indices in place of the numbers of a sample.
pub(crate) fn of_indices(mut formula: Printed, sample: &[i64], letters: IndexLetters) -> Printed {
    formula.visit_indices(&mut |index| {
        let mut sample = sample.iter().zip(INDICES);
        let known = sample.find(|(number, _)| *index == Index::Number(**number));
        if let Some((_, letter)) = known {
            *index = Index::Variable(letters.text(letter), 0);
        }
    });
    formula
}
