//! The equations of a model, one below the other: definitions, energies, momenta, Lagrange's equations, and the form
//! in which they are solved.
//!
//! What would be too long to read is left out, with a sentence that says how long it is. Definitions stand before
//! what is made of them, and only those that the equations mention.

pub(crate) mod section;
pub(crate) mod as_declared;
pub(crate) mod composer;
pub(crate) mod page_letters;
pub(crate) mod row_breaks;
pub(crate) mod constraints;
pub(crate) mod coordinates;
pub(crate) mod energy;
pub(crate) mod sampling;
pub(crate) mod families;
pub(crate) mod printed_model;
pub(crate) mod index_families;
pub(crate) mod index_letters;
pub(crate) mod index_pattern;
pub(crate) mod pair_sums;
pub(crate) mod pattern_text;
pub(crate) mod vector_text;
pub(crate) mod recursion_text;
pub(crate) mod recursion;
pub(crate) mod solved;

use crate::mechanics::solvers::form::SolvedForm;
use crate::print::listing::as_declared::AsDeclared;
use crate::print::listing::composer::Composer;
use crate::print::listing::printed_model::PrintedModel;
use crate::print::listing::section::Section;
use crate::print::names::{Letters, Names};
use crate::{Equations, Expression, Model};

/// The names of a model, in the order of the declaration.
#[derive(Clone, Debug, Default)]
pub struct Declared {
    /// The names of symbols; its definitions are not used.
    pub names: Names,
    /// The definitions.
    pub definitions: Vec<(String, Expression)>,
    /// The functions of events.
    pub events: Vec<(String, Expression)>,
    /// The energies and the definitions as they were declared.
    pub as_declared: AsDeclared,
    /// How many operations the accelerations take.
    pub operations: usize,
}

/// The equations of a model in print.
#[derive(Clone, Debug)]
pub struct Listing {
    /// Lines of Unicode.
    pub unicode: String,
    /// Displays of LaTeX, which `amsmath` typesets.
    pub latex: String,
}

impl Listing {
    /// The equations of `model`, which are solved in the form `solved`.
    #[must_use]
    pub fn of(
        model: &mut Model,
        equations: &Equations,
        solved: &SolvedForm,
        declared: &Declared,
    ) -> Self {
        let preferred: Vec<_> = declared.definitions.iter().map(|(_, x)| *x).collect();
        let solved = match solved {
            SolvedForm::QuasiVelocities(equations) => {
                SolvedForm::QuasiVelocities(equations.in_terms_of(&mut model.graph, &preferred))
            }
            other => other.clone(),
        };
        let printed = PrintedModel {
            energies: model.energies,
            equations: equations.with_reactions(&mut model.graph),
            solved,
            declared: declared.clone(),
        };
        model.graph.leaves_exponentials = true;
        let printed = printed.without_guards(&mut model.graph);
        let PrintedModel {
            energies,
            ref equations,
            ref solved,
            ref declared,
        } = printed.by_exponentials(&mut model.graph);
        let mut composer = Composer::new(model, energies, declared, solved);
        let energies = composer.energies();
        let events = composer.events();
        let momenta = composer.momenta(equations);
        let energy = composer.energy_function(equations);
        let lagrange = composer.lagrange(equations);
        let constraints = composer.constraints(equations);
        let recursion = composer.recursion(equations, &lagrange);
        let solved = composer.solved(solved, &equations.mass);
        let coordinates = composer.coordinates();
        let definitions = composer.definitions();
        let mut sections = vec![
            coordinates,
            definitions,
            energies,
            events,
            momenta,
            energy,
            lagrange,
            constraints,
        ];
        sections.extend(recursion);
        sections.extend(solved);
        let listing = Self::written(&composer.letters, &sections);
        composer.model.graph.leaves_exponentials = false;
        listing
    }

    /// The sections as they are written.
    fn written(letters: &Letters, sections: &[Section]) -> Self {
        let mut listing = Self {
            unicode: String::new(),
            latex: String::new(),
        };
        for section in sections {
            section.write(letters, &mut listing);
        }
        listing
    }
}
