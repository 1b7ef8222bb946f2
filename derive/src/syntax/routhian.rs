//! The clause `routhian(Name)`, which asks for the model without its ignorable coordinates.

use proc_macro2::Ident;
use syn::Token;
use syn::parse::ParseStream;

use crate::syntax::grammar::{in_parentheses, word};

/// `routhian(Name)`, `routhian(Name, half_angles)` or `routhian(Name, without(output, regressor))`.
pub(crate) struct RouthianClause {
    pub(crate) keyword: Ident,
    /// The name of the reduced model.
    pub(crate) name: Ident,
    /// Whether quotients by sin² are written in half angles.
    pub(crate) half_angles: bool,
    /// Outputs, events and clauses that the reduced model does not have.
    pub(crate) without: Vec<Ident>,
}

impl RouthianClause {
    /// Parses what follows the keyword.
    pub(crate) fn read(keyword: Ident, input: ParseStream<'_>) -> syn::Result<Self> {
        let (content, span) = in_parentheses(&keyword, HOW_TO_WRITE, input)?;
        if content.is_empty() {
            return Err(syn::Error::new(span, HOW_TO_WRITE));
        }
        let mut clause = Self {
            keyword,
            name: word(&content, HOW_TO_WRITE)?,
            half_angles: false,
            without: Vec::new(),
        };
        while content.parse::<Option<Token![,]>>()?.is_some() && !content.is_empty() {
            clause.read_option(&content)?;
        }
        if !content.is_empty() {
            return Err(content.error(HOW_TO_WRITE));
        }
        Ok(clause)
    }

    fn read_option(&mut self, input: ParseStream<'_>) -> syn::Result<()> {
        let option = word(input, OPTION)?;
        if option == "half_angles" && !self.half_angles {
            self.half_angles = true;
            return Ok(());
        }
        if option != "without" || !self.without.is_empty() {
            return Err(syn::Error::new(option.span(), OPTION));
        }
        let (content, span) = in_parentheses(&option, WITHOUT, input)?;
        while !content.is_empty() {
            self.without.push(word(&content, WITHOUT)?);
            if content.parse::<Option<Token![,]>>()?.is_none() && !content.is_empty() {
                return Err(content.error(WITHOUT));
            }
        }
        if self.without.is_empty() {
            return Err(syn::Error::new(span, WITHOUT));
        }
        Ok(())
    }
}

const HOW_TO_WRITE: &str =
    "write `routhian(ReducedTop)`, with a name for the model without its ignorable coordinates";
const OPTION: &str = "write `half_angles` behind the name, so that the reduced model has values at the poles of angles, \
                      `without(…)` with the outputs, events and clauses that it shall not have, each once, or the name \
                      alone";
const WITHOUT: &str = "write `without(x, regressor)`, with the names of outputs, of events and of clauses that the reduced \
                       model shall not have";
