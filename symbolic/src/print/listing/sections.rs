//! All sections of the equations of a model, in their order.

use crate::mechanics::solvers::form::SolvedForm;
use crate::print::listing::composer::Composer;
use crate::print::listing::printed_model::PrintedModel;
use crate::print::listing::section::Section;
use crate::print::listing::{Declared, Listing};
use crate::print::names::Letters;
use crate::{Equations, Model};

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
