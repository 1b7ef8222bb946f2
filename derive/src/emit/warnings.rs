//! Warnings, by the use of something deprecated, since macros on stable Rust cannot emit others. `#[allow(deprecated)]` on
//! the struct silences them.

use std::collections::BTreeSet;

use lagrangian_symbolic as symbolic;
use lagrangian_symbolic::Expression;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote_spanned};

use super::emitter::Emitter;
use super::printed_names::printed_names;
use crate::limits::MAX_SWITCHING_FUNCTION_LENGTH;
use crate::syntax::declaration::Declaration;

/// Warns in a debug build of the macro that methods had to be replaced, because validation found a bug of this crate.
pub(crate) fn warning(
    disagreements: &BTreeSet<symbolic::Method>,
    declaration: &Declaration,
) -> Option<TokenStream> {
    if !cfg!(debug_assertions) || disagreements.is_empty() {
        return None;
    }
    let methods: Vec<String> = disagreements
        .iter()
        .map(|method| format!("{method:?}"))
        .collect();
    let note = format!(
        "the simplified code for {} does not compute what Lagrange's equations say, so that the plain code is used, \
         which is right and slower; this is a defect of `lagrangian`: please report the declaration",
        methods.join(", ")
    );
    let name = format_ident!("DEFECT_OF_LAGRANGIAN", span = declaration.name.span());
    Some(warn(&name, &note, declaration))
}

impl Emitter<'_> {
    /// Warns of constraints that are declared as nonholonomic and can be integrated.
    pub(crate) fn disguise_warnings(&self) -> TokenStream {
        let constraints = &self.lowered.constraints;
        let labels = constraints.labels();
        let mut warnings = TokenStream::new();
        for (name, components, _) in constraints.names() {
            let integrated = self.equations.constraints.integrable.iter();
            let integrated: Vec<_> = integrated.filter(|(i, _)| components.contains(i)).collect();
            if integrated.is_empty() {
                continue;
            }
            let labels = integrated.iter().filter_map(|(i, _)| labels.get(*i));
            let labels: Vec<_> = labels.map(|label| format!("`{label}`")).collect();
            let integrals = integrated.iter().map(|(_, integral)| *integral);
            let which = if components.len() == 1 {
                "this is".to_owned()
            } else if let [one] = labels.as_slice() {
                format!("{one} is")
            } else {
                format!("{} are", labels.join(", "))
            };
            let reason = self.as_rates(integrals.collect());
            let note = format!(
                "{which} holonomic in disguise: {reason}; declare it as `constraint(…)`, so that it holds for positions, too, or \
                 keep it under `#[allow(deprecated)]`"
            );
            let name = format_ident!("HOLONOMIC_IN_DISGUISE", span = name.span());
            warnings.extend(warn(&name, &note, self.declaration));
        }
        warnings
    }

    /// Says which functions of the coordinates and the time are constant, as far as they are known.
    fn as_rates(&self, integrals: Option<Vec<Expression>>) -> String {
        let Some(integrals) = integrals else {
            return "a relation of coordinates follows by integration".to_owned();
        };
        let names = printed_names(self.lowered);
        let printed = integrals.into_iter().map(|integral| {
            let formula = self.model.graph.display(integral, &names);
            formula.limit(MAX_SWITCHING_FUNCTION_LENGTH).to_string()
        });
        let printed: Vec<_> = printed.collect();
        format!("{} is constant in every motion", printed.join(", and "))
    }
}

/// Warns with a note at the span of a name.
fn warn(name: &Ident, note: &str, declaration: &Declaration) -> TokenStream {
    let allowed = &declaration.allowed;
    quote_spanned! {name.span()=>
        #(#allowed)*
        const _: () = {
            #[deprecated(note = #note)]
            const #name: () = ();
            #name
        };
    }
}
