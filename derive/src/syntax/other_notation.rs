//! Notation of other languages that the grammar does not have: what is written here instead.
//!
//! It is looked for only where an expression could not be parsed, or goes on where it should end.

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use syn::Token;
use syn::parse::ParseStream;

/// What is written for cases.
pub(crate) const NO_CASES: &str = "there are no cases here: write one formula, with `abs`, `signum`, `min` and `max` \
                                   where it has corners, or declare a function of Rust, `function(f(x) = …)`";

/// What is written for conditions.
pub(crate) const NO_CONDITIONS: &str = "there are no conditions here: write one formula, with `abs`, `signum`, `min` \
                                        and `max` where it has corners";

/// What is written for remainders.
pub(crate) const NO_REMAINDER: &str =
    "a remainder belongs in an index, as in `q[(i + 1) % 3]`: angles need no reduction";

const SUM: &str = "a sum is written `(0..5).map(|i| m[i] * x[i]).sum()`, and a vector with `.collect()` in place of `.sum()`";
const ABSOLUTE: &str = "the absolute value is `abs(x)`, and the length of a vector `v.norm()`";
const NO_PLUS: &str = "no plus sign stands in front of an expression here: leave it out";
const POINT: &str = "a number begins with a digit: write `0.5`";
const MATRIX_PRODUCT: &str = "the product of matrices is written with `*`";

/// What should stand in place of what follows an expression.
pub(crate) fn behind(input: ParseStream<'_>) -> Option<syn::Error> {
    let word = input.fork().parse::<syn::Ident>().ok();
    let message = match word.as_ref().map(ToString::to_string).as_deref() {
        Some("and" | "or" | "xor") => NO_CONDITIONS,
        Some("then") => NO_CASES,
        _ if input.peek(Token![if]) || input.peek(Token![else]) => NO_CASES,
        _ if input.peek(Token![for]) => SUM,
        _ if input.peek(Token![@]) => MATRIX_PRODUCT,
        _ => return None,
    };
    Some(syn::Error::new(input.span(), message))
}

/// What should stand in place of a part of the expression that begins here, up to a comma.
pub(crate) fn within(input: ParseStream<'_>) -> Option<syn::Error> {
    let rest = input.fork().parse::<TokenStream>().ok()?;
    let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(p) if p.as_char() == ',');
    let tokens: Vec<TokenTree> = rest
        .into_iter()
        .take_while(|token| !is_comma(token))
        .collect();
    let (span, message) = first(&tokens, false, false)?;
    Some(syn::Error::new(span, message))
}

/// The first part that is not of this grammar. `is_argument` of a method: a closure may stand there. `is_inner`: within
/// brackets.
fn first(tokens: &[TokenTree], is_argument: bool, is_inner: bool) -> Option<(Span, &'static str)> {
    let mut behind_operand = false;
    let mut behind_method = false;
    for (place, token) in tokens.iter().enumerate() {
        let next = tokens.get(place + 1);
        let message = match token {
            TokenTree::Ident(word) => of_word(&word.to_string(), is_inner && place > 0),
            TokenTree::Punct(sign) => match sign.as_char() {
                '?' => Some(NO_CASES),
                '@' => Some(MATRIX_PRODUCT),
                '+' if !behind_operand => Some(NO_PLUS),
                '.' if is_point(place.checked_sub(1).map(|before| &tokens[before]), next) => {
                    Some(POINT)
                }
                '|' if !behind_operand && !is_argument && is_absolute(&tokens[place + 1..]) => {
                    Some(ABSOLUTE)
                }
                _ => None,
            },
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => None,
            TokenTree::Group(group) => {
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                if let Some(found) = first(&inner, behind_method, true) {
                    return Some(found);
                }
                None
            }
            TokenTree::Literal(_) => None,
        };
        if let Some(message) = message {
            return Some((token.span(), message));
        }
        behind_operand = !matches!(token, TokenTree::Punct(_));
        behind_method = matches!(token, TokenTree::Ident(_));
    }
    None
}

/// Whether a number without a digit in front of its point begins at that point.
fn is_point(before: Option<&TokenTree>, next: Option<&TokenTree>) -> bool {
    let follows_an_operator = match before {
        None => true,
        Some(TokenTree::Punct(sign)) => sign.as_char() != '.',
        Some(_) => false,
    };
    follows_an_operator && matches!(next, Some(TokenTree::Literal(_)))
}

fn of_word(word: &str, behind_others: bool) -> Option<&'static str> {
    match word {
        "if" | "else" | "where" => Some(NO_CASES),
        "mod" => Some(NO_REMAINDER),
        "for" if behind_others => Some(SUM),
        _ => None,
    }
}

/// Whether a bar opens an absolute value: behind the next one stands nothing that a closure could consist of.
fn is_absolute(behind: &[TokenTree]) -> bool {
    let is = |token: &TokenTree, signs: &str| matches!(token, TokenTree::Punct(p) if signs.contains(p.as_char()));
    let closing = behind.iter().position(|token| is(token, "|"));
    closing.is_some_and(|closing| match behind.get(closing + 1) {
        None => true,
        Some(token) => is(token, "+*/.,;|^"),
    })
}
