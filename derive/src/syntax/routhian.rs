//! The clause `routhian(Name)`, which asks for the model without its ignorable coordinates.

use proc_macro2::Ident;
use syn::parse::ParseStream;
use syn::{Token, token};

use crate::syntax::grammar::{position, word};

/// `routhian(Name)` or `routhian(Name, half_angles)`.
pub(crate) struct RouthianClause {
    pub(crate) keyword: Ident,
    /// The name of the reduced model.
    pub(crate) name: Ident,
    /// Whether quotients by sin² are written in half angles.
    pub(crate) half_angles: bool,
}

impl RouthianClause {
    /// Parses what follows the keyword.
    pub(crate) fn read(keyword: Ident, input: ParseStream<'_>) -> syn::Result<Self> {
        if !input.peek(token::Paren) {
            return Err(syn::Error::new(position(&keyword, input), HOW_TO_WRITE));
        }
        let content;
        let parentheses = syn::parenthesized!(content in input);
        if content.is_empty() {
            return Err(syn::Error::new(parentheses.span.join(), HOW_TO_WRITE));
        }
        let name = word(&content, HOW_TO_WRITE)?;
        let mut half_angles = false;
        if content.parse::<Option<Token![,]>>()?.is_some() && !content.is_empty() {
            let form = word(&content, OPTION)?;
            if form != "half_angles" {
                return Err(syn::Error::new(form.span(), OPTION));
            }
            half_angles = true;
            content.parse::<Option<Token![,]>>()?;
        }
        if !content.is_empty() {
            return Err(content.error(HOW_TO_WRITE));
        }
        Ok(Self {
            keyword,
            name,
            half_angles,
        })
    }
}

const HOW_TO_WRITE: &str =
    "write `routhian(ReducedTop)`, with a name for the model without its ignorable coordinates";
const OPTION: &str = "write `half_angles` behind the name, so that the reduced model has values at the poles of angles, or \
                      the name alone";
