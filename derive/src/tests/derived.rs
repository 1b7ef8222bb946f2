//! A model that has been derived from a declaration, before it is emitted.

use lagrangian_symbolic::{Equations, Model, Validator};
use proc_macro2::TokenStream;

use crate::check::check;
use crate::diagnostics::Diagnostics;
use crate::limits::MethodLimits;
use crate::lower::lower;
use crate::plan::{Methods, Requested};
use crate::syntax::declaration::Declaration;
use crate::syntax::shape::Shape;

/// A model, what validates it, and its methods.
pub(super) struct Derived {
    pub(super) model: Model,
    pub(super) equations: Equations,
    pub(super) validator: Validator,
    pub(super) methods: Methods,
    /// The shapes of the outputs.
    pub(super) shapes: Vec<Shape>,
    /// What clauses ask for.
    pub(super) requested: Requested,
}

pub(super) fn derive(declaration: TokenStream) -> Derived {
    derive_within(declaration, MethodLimits::OF_EXPANSIONS)
}

/// The same within other limits on the form of methods.
pub(super) fn derive_within(declaration: TokenStream, limits: MethodLimits) -> Derived {
    let mut diagnostics = Diagnostics::default();
    let input = syn::parse2(declaration).unwrap();
    let declaration = Declaration::parse(input, &mut diagnostics);
    check(&declaration, &mut diagnostics);
    let mut lowered = lower(&declaration, &mut diagnostics);
    assert!(
        diagnostics.is_empty(),
        "{}",
        diagnostics.to_compile_errors()
    );
    let mut model = lowered.model.take().unwrap();
    let validator = Validator::new(&model);
    let equations = Equations::derive(&mut model).unwrap();
    let shapes = lowered.outputs.clone();
    let requested = Requested::derive(&declaration, &lowered, &mut model, limits).unwrap();
    let methods = Methods::schedule(&mut model, &equations, &shapes, &requested);
    Derived {
        model,
        equations,
        validator,
        methods,
        shapes,
        requested,
    }
}
