//! The text of a value, with the parentheses that it wants where it stands.

use proc_macro2::{Delimiter, Group, Punct, Spacing, TokenStream, TokenTree};
use quote::{ToTokens, quote};

/// How tightly an expression holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Level {
    Sum,
    Product,
    Sign,
    Atom,
}

/// The text of a value.
#[derive(Clone)]
pub(super) struct Text {
    pub(super) tokens: TokenStream,
    pub(super) level: Level,
    /// The factors, if this is a product that may be fused with a sum.
    pub(super) factors: Option<Box<[Self; 2]>>,
}

impl Text {
    pub(super) fn atom(tokens: impl ToTokens) -> Self {
        Self {
            tokens: tokens.into_token_stream(),
            level: Level::Atom,
            factors: None,
        }
    }

    /// −x, which is not fused with anything.
    pub(super) fn opposite(self) -> Self {
        Self {
            level: Level::Sign,
            factors: None,
            tokens: self.negative(),
        }
    }

    /// −x.
    pub(super) fn negative(self) -> TokenStream {
        let x = self.at(Level::Atom);
        quote!(-#x)
    }

    /// The tokens, in parentheses unless they hold together at `level`.
    pub(super) fn at(self, level: Level) -> TokenStream {
        if self.level >= level {
            self.tokens
        } else {
            TokenTree::Group(Group::new(Delimiter::Parenthesis, self.tokens)).into()
        }
    }
}

/// `left operator right`, which holds together at `level`.
pub(super) fn infix(left: Text, operator: char, right: Text, level: Level) -> TokenStream {
    let mut tokens = left.at(level);
    tokens.extend([TokenTree::Punct(Punct::new(operator, Spacing::Alone))]);
    // The operand on the right keeps its parentheses at the same level: the order of operations is
    // part of what was scheduled.
    let tighter = if level == Level::Sum {
        Level::Product
    } else {
        Level::Sign
    };
    tokens.extend(right.at(tighter));
    tokens
}
