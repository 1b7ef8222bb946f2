//! What is derived from a model.

use std::collections::BTreeSet;

use lagrangian_symbolic::{Equations, Listing, Method, Model, Validator};

use crate::defects;
use crate::diagnostics::Diagnostics;
use crate::emit::{Emitter, listing};
use crate::limits::MethodLimits;
use crate::lower::Lowered;
use crate::plan::{Methods, Requested, SeriesMethods, branches_of_events};
use crate::syntax::declaration::Declaration;

/// The equations of motion of a model, its methods and what is printed of it.
pub(crate) struct Derived {
    model: Model,
    pub(crate) equations: Equations,
    pub(crate) methods: Methods,
    pub(crate) series: Option<SeriesMethods>,
    pub(crate) listing: Listing,
    /// The methods that had to be derived again.
    pub(crate) disagreements: BTreeSet<Method>,
}

impl Derived {
    /// Derives the equations and schedules the methods, unless there is an error.
    pub(crate) fn of(
        declaration: &Declaration,
        lowered: &Lowered,
        mut model: Model,
        limits: MethodLimits,
        diagnostics: &mut Diagnostics,
    ) -> Option<Self> {
        let has_series = declaration.clauses.taylor.is_some();
        let branches = has_series.then(|| branches_of_events(&mut model, &lowered.outputs));
        let validator = Validator::new(&model);
        let mut equations = Equations::derive(&mut model)
            .map_err(|defect| defects::report(&defect, declaration, lowered, &model, diagnostics))
            .ok()?;
        let requested = Requested::derive(declaration, lowered, &mut model, limits)
            .map_err(|reason| {
                defects::report_no_regressor(&reason, declaration, lowered, &model, diagnostics);
            })
            .ok()?;
        let shapes = &lowered.outputs;
        let mut methods = Methods::schedule(&mut model, &equations, shapes, &requested);
        // What applies them cannot be validated.
        let undeclared = methods.undeclared(&model.graph);
        if !undeclared.is_empty() {
            defects::report_undeclared(&undeclared, declaration, diagnostics);
            return None;
        }
        let disagreements =
            methods.validate(&validator, &mut model, &mut equations, (shapes, &requested));
        if methods.unrepresentable().is_some() {
            defects::report_at_energy(declaration, UNREPRESENTABLE, diagnostics);
            return None;
        }
        let series = match (&declaration.clauses.taylor, branches) {
            (Some(clause), Some(branches)) => {
                let series = SeriesMethods::derive(&mut methods, &mut model, &equations, branches)
                    .map_err(|reason| {
                        defects::report_no_series(reason, clause, declaration, diagnostics);
                    });
                Some(series.ok()?)
            }
            _ => None,
        };
        let solved = methods.solved_form(&mut model, &equations);
        let operations = methods.accelerations.count.total();
        let solved = (&solved, operations);
        let listing = listing(&mut model, &equations, (declaration, lowered), solved);
        Some(Self {
            model,
            equations,
            methods,
            series,
            listing,
            disagreements,
        })
    }

    /// What the emitted code depends on.
    pub(crate) fn emitter<'a>(
        &'a self,
        declaration: &'a Declaration,
        lowered: &'a Lowered,
        limits: MethodLimits,
    ) -> Emitter<'a> {
        Emitter::new(
            declaration,
            lowered,
            &self.model,
            (&self.equations, &self.listing),
            &self.methods,
            self.series.as_ref(),
            limits,
        )
    }
}

const UNREPRESENTABLE: &str = "a constant of the equations of motion is outside of the range of `f64`, though those written here \
                               are not: choose units in which numbers are nearer to 1";
