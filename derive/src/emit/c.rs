//! The model in C: what the clause `c` adds.
//!
//! The source is written from the programs of the methods: the same operations in the same order, one statement for each
//! (`c/body.rs`). Around them is written in C what the methods do in Rust (`c/methods.rs`, `c/derivatives.rs`), and what they call in the
//! runtime stands in `c/library/`. In all these texts `$` stands for the name of the model, `@N`, `@C` and `@K` for the
//! numbers of coordinates, of constraints, and of both together, `@M` for the number of inputs, and `@P` for the number of sweeps of the projection.

mod identifiers;
mod structs;
mod body;
mod library;
mod methods;
mod derivatives;
mod columns;
mod variation;
mod interface;
mod casadi;
mod header;

use lagrangian_symbolic::Symbol;
use proc_macro2::TokenStream;
use quote::quote;

use super::emitter::Emitter;
use crate::plan::{EmittedMethod, MethodOutputs};
use crate::syntax::names::unraw;
use identifiers::snake_case;
use structs::{Field, Parameters};

impl Emitter<'_> {
    /// The constants with the source and the header; nothing without the clause.
    pub(super) fn c_constants(&self) -> TokenStream {
        if self.declaration.clauses.c.is_none() {
            return TokenStream::new();
        }
        let visibility = &self.declaration.visibility;
        let export = Export::new(self);
        let (source, header) = (export.source(), export.header());
        let casadi = export.casadi();
        let name = format!("{}.h", export.prefix);
        let of_source = format!("The model in C99, which includes `{name}`.");
        let of_header = format!("The header of [`C_SOURCE`](Self::C_SOURCE), `{name}`.");
        quote! {
            #[doc = #of_source]
            #visibility const C_SOURCE: &'static str = #source;
            #[doc = #of_header]
            #visibility const C_HEADER: &'static str = #header;
            /// The model as external functions of `CasADi`, in C.
            #visibility const C_CASADI: &'static str = #casadi;
        }
    }
}

/// The length of a line of text.
const WIDTH: usize = 120;

/// A model that is written in C.
struct Export<'a> {
    emitter: &'a Emitter<'a>,
    /// The name of the model, with which all names begin.
    prefix: String,
    parameters: Parameters,
    outputs: Vec<Field>,
}

impl<'a> Export<'a> {
    fn new(emitter: &'a Emitter<'a>) -> Self {
        Self {
            emitter,
            prefix: snake_case(&unraw(&emitter.declaration.name)),
            parameters: Parameters::of(emitter),
            outputs: Field::of_outputs(emitter),
        }
    }

    /// A part of a text that only a model with parameters has.
    fn with_parameters<'t>(&self, text: &'t str) -> &'t str {
        if self.parameters.is_empty() { "" } else { text }
    }

    fn is_constrained(&self) -> bool {
        self.emitter.is_constrained()
    }

    /// How many values depend on parameters alone.
    fn invariants(&self) -> usize {
        match &self.emitter.methods.prepare.outputs {
            MethodOutputs::Invariants(values) => values.len(),
            _ => 0,
        }
    }

    /// Whether the model has a method.
    fn has(&self, method: EmittedMethod) -> bool {
        self.emitter.methods.get(method).is_some()
    }

    /// The parameters by which the clause `sensitivities` differentiates.
    fn sensitive_parameters(&self) -> &[Symbol] {
        let requested = &self.emitter.methods.requested;
        let sensitivities = requested.sensitivities.as_ref();
        sensitivities.map_or(&[], |found| &found.parameters)
    }

    /// A text with the names and numbers of the model.
    fn filled(&self, text: &str) -> String {
        let has_positions = self.emitter.lowered.constraints.holonomic() > 0;
        let position_sweeps = if has_positions { 3 } else { 0 };
        let numbers = [
            ("@N", self.emitter.coordinates()),
            ("@C", self.emitter.constraint_count()),
            ("@K", self.emitter.unknowns()),
            ("@M", self.emitter.model.inputs as usize),
            ("@P", position_sweeps),
        ];
        let text = text.replace('$', &self.prefix);
        numbers.into_iter().fold(text, |text, (mark, number)| {
            text.replace(mark, &number.to_string())
        })
    }

    fn source(&self) -> String {
        let header = self.functions();
        let interface: Vec<String> = header
            .iter()
            .map(|function| self.definition(function))
            .collect();
        let mut functions = interface.join("\n");
        // Each function behind those that it calls, and none that is not called.
        let mut others = vec![("$_begin".to_owned(), self.begin())];
        others.extend(library::around_methods());
        let named = |method: &EmittedMethod| {
            let function = self.method(*method)?;
            Some((format!("$_{}_at", method.row().name), function))
        };
        others.extend(Self::BEHIND_FACTORS.iter().rev().filter_map(named));
        others.push(("$_factor_at".to_owned(), self.factor_at()));
        others.extend(Self::OF_FACTORS.iter().rev().filter_map(named));
        others.push(("$_prepare".to_owned(), self.prepare()));
        for (name, text) in others {
            if body::mentions(&functions, &name) {
                functions = format!("{text}\n{functions}");
            }
        }
        let library = library::library(&functions, self.is_constrained());
        self.filled(&format!("{BEGINNING}{}{library}{functions}", self.point()))
    }

    /// The struct of the point at which functions are evaluated.
    fn point(&self) -> String {
        let parameters = self.with_parameters("    const $_parameters *p;\n");
        format!(
            "/* Where functions are evaluated: parameters, what depends on them alone, time, state and inputs. */\n\
             typedef struct {{\n{parameters}    const double *z;\n    double t;\n    const double *q;\n    const double *v;\n    \
             const double *u;\n}} $_point;\n\n"
        )
    }
}

/// What stands before the functions.
const BEGINNING: &str = "\
/* Generated from a declaration of the Rust crate `lagrangian`. Compile it with -ffp-contract=off for the bits of Rust. */
#include \"$.h\"

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* No product is fused with a sum but in $_mul_add. GCC does not know the pragma. */
#if defined(__clang__) || !defined(__GNUC__)
#pragma STDC FP_CONTRACT OFF
#endif

";
