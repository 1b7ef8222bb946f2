//! Where the emitted code finds the crate `lagrangian`.
//!
//! That is `::lagrangian`, unless the declaration says `crate = "path"`: a crate that re-exports the derive
//! may have renamed `lagrangian`, and its users may not depend on it. Every path that is emitted begins
//! with the root, so that no other one is absolute but `::core`.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{LitStr, Path};

use crate::syntax::grammar::{ends, equals};

/// The path of the crate `lagrangian`.
#[derive(Clone)]
pub(crate) struct Root(TokenStream);

impl Default for Root {
    fn default() -> Self {
        Self(quote!(::lagrangian))
    }
}

impl ToTokens for Root {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.extend(self.0.clone());
    }
}

impl Root {
    /// Parses `crate = "path"` or `crate = path`; returns the keyword `crate`, too.
    pub(crate) fn read(input: ParseStream<'_>) -> syn::Result<(Ident, Self)> {
        let keyword = input.call(Ident::parse_any)?;
        equals(&keyword, HOW_TO_NAME, input)?;
        let path = if input.peek(LitStr) {
            let path = input.parse::<LitStr>()?;
            path.parse_with(Path::parse_mod_style)
                .map_err(|_| syn::Error::new_spanned(path, HOW_TO_NAME))?
        } else {
            Path::parse_mod_style(input)
                .map_err(|error| syn::Error::new(error.span(), HOW_TO_NAME))?
        };
        if !ends(input) {
            return Err(input.error(HOW_TO_NAME));
        }
        Ok((keyword, Self(path.into_token_stream())))
    }
}

const HOW_TO_NAME: &str =
    "write `crate = \"path\"`, with the path at which this module finds the crate `lagrangian`";
