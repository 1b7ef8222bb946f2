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
    precedence: Precedence,
    form: Form,
}

#[derive(Clone)]
enum Form {
    Tokens(TokenStream),
    /// A product that may be fused with a sum, which is written where it is not.
    Product(Box<[Fragment; 2]>),
}

impl Fragment {
    pub(super) fn new(tokens: TokenStream, precedence: Precedence) -> Self {
        Self {
            precedence,
            form: Form::Tokens(tokens),
        }
    }

    pub(super) fn atom(tokens: impl ToTokens) -> Self {
        Self::new(tokens.into_token_stream(), Precedence::Atom)
    }

    /// The product of two factors, which may be fused with a sum.
    pub(super) fn product(x: Self, y: Self) -> Self {
        Self {
            precedence: Precedence::Product,
            form: Form::Product(Box::new([x, y])),
        }
    }

    /// The factors of a product that may be fused with a sum.
    pub(super) fn into_factors(self) -> Result<[Self; 2], Self> {
        match self.form {
            Form::Product(factors) => Ok(*factors),
            Form::Tokens(_) => Err(self),
        }
    }

    pub(super) fn into_tokens(self) -> TokenStream {
        match self.form {
            Form::Tokens(tokens) => tokens,
            Form::Product(factors) => {
                let [x, y] = *factors;
                infix(x, '*', y, Precedence::Product)
            }
        }
    }

    /// −x, which is not fused with anything.
    pub(super) fn negated(self) -> Self {
        let x = self.in_parentheses_below(Precedence::Atom);
        let mut tokens = quote!(-);
        tokens.extend(x);
        Self::new(tokens, Precedence::Sign)
    }

    /// The tokens, in parentheses where they bind less tightly than `precedence`.
    pub(super) fn in_parentheses_below(self, precedence: Precedence) -> TokenStream {
        let binds = self.precedence >= precedence;
        let tokens = self.into_tokens();
        if binds {
            tokens
        } else {
            TokenTree::Group(Group::new(Delimiter::Parenthesis, tokens)).into()
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
