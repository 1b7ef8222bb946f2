//! The tokens of a value, and their precedence, which decides on parentheses.

use proc_macro2::{Delimiter, Group, Punct, Spacing, TokenStream, TokenTree};
use quote::{ToTokens, quote};

/// The precedence of an expression, from the loosest to the tightest.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Precedence {
    Sum,
    Product,
    Sign,
    Atom,
}

/// The tokens of a value.
#[derive(Clone)]
pub(super) struct Fragment {
    pub(super) tokens: TokenStream,
    pub(super) precedence: Precedence,
    /// The factors, if this is a product that may be fused with a sum.
    pub(super) factors: Option<Box<[Self; 2]>>,
}

impl Fragment {
    pub(super) fn atom(tokens: impl ToTokens) -> Self {
        Self {
            tokens: tokens.into_token_stream(),
            precedence: Precedence::Atom,
            factors: None,
        }
    }

    /// −x, which is not fused with anything.
    pub(super) fn negated(self) -> Self {
        Self {
            precedence: Precedence::Sign,
            factors: None,
            tokens: self.negated_tokens(),
        }
    }

    /// −x.
    pub(super) fn negated_tokens(self) -> TokenStream {
        let x = self.in_parentheses_below(Precedence::Atom);
        quote!(-#x)
    }

    /// The tokens, in parentheses where they bind less tightly than `precedence`.
    pub(super) fn in_parentheses_below(self, precedence: Precedence) -> TokenStream {
        if self.precedence >= precedence {
            self.tokens
        } else {
            TokenTree::Group(Group::new(Delimiter::Parenthesis, self.tokens)).into()
        }
    }
}

/// `left operator right`, of this precedence.
pub(super) fn infix(
    left: Fragment,
    operator: char,
    right: Fragment,
    precedence: Precedence,
) -> TokenStream {
    let mut tokens = left.in_parentheses_below(precedence);
    tokens.extend([TokenTree::Punct(Punct::new(operator, Spacing::Alone))]);
    // The operand on the right keeps its parentheses at the same precedence: the order of operations is
    // part of what was scheduled.
    let tighter = if precedence == Precedence::Sum {
        Precedence::Product
    } else {
        Precedence::Sign
    };
    tokens.extend(right.in_parentheses_below(tighter));
    tokens
}
