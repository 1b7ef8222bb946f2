//! Which passes are applied: all, except in the ablation study of the benchmark.
//!
//! With the feature `ablation` the environment variable `LAGRANGIAN_WITHOUT`, read when a model is expanded,
//! names the passes to switch off, separated by commas. Without the feature nothing is read, so that what
//! users build depends on their declaration alone. Cargo does not see the variable: whoever changes it has
//! to change the crate too.

use lagrangian_symbolic::{Pass, Passes};
use proc_macro2::Span;

use crate::diagnostics::Diagnostics;

/// The passes for a model that is expanded now.
pub(crate) fn passes(diagnostics: &mut Diagnostics) -> Passes {
    let names = if cfg!(feature = "ablation") {
        std::env::var("LAGRANGIAN_WITHOUT").unwrap_or_default()
    } else {
        String::new()
    };
    without(&names, diagnostics)
}

fn without(names: &str, diagnostics: &mut Diagnostics) -> Passes {
    let mut passes = Passes::default();
    for name in names.split(',').filter(|name| !name.is_empty()) {
        match name.parse::<Pass>() {
            Ok(pass) => passes = passes.without(pass),
            Err(_) => diagnostics.error_at(
                Span::call_site(),
                format!("`LAGRANGIAN_WITHOUT` names a pass that there is not: `{name}`"),
            ),
        }
    }
    passes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_are_switched_off_by_name() {
        let mut diagnostics = Diagnostics::default();
        let passes = without("articulated-bodies,factoring", &mut diagnostics);
        assert!(diagnostics.is_empty());
        let expected = Passes::default().without(Pass::ArticulatedBodies);
        assert_eq!(passes, expected.without(Pass::Factoring));
    }

    #[test]
    fn a_name_that_no_pass_has_is_an_error() {
        let mut diagnostics = Diagnostics::default();
        let passes = without("tres", &mut diagnostics);
        assert_eq!(passes, Passes::default());
        assert!(!diagnostics.is_empty());
    }
}
