//! The form in which the equations of motion are solved.

use std::collections::BTreeMap;

use crate::limits::{MAX_ACCELERATION_LENGTH, MAX_LISTED_ACCELERATIONS};
use crate::mechanics::solvers::form::SolvedForm;
use crate::print::listing::composer::Composer;
use crate::print::listing::section::Section;
use crate::{Expression, Node, QuasiVelocityEquations, Rational, Symbol};

impl Composer<'_> {
    /// Euler's equations and the kinematics of a rigid body, and the like; else the name of the method.
    pub(crate) fn solved(&mut self, form: &SolvedForm, mass: &[Vec<Expression>]) -> Vec<Section> {
        let operations = self.declared.operations;
        let by = match form {
            SolvedForm::QuasiVelocities(equations) => {
                if let Some(sections) = self.in_quasi_velocities(equations) {
                    return sections;
                }
                if let Some(section) = self.through_constant_mass(equations) {
                    return vec![section];
                }
                "through quasi-velocities (Boltzmann and Hamel)"
            }
            SolvedForm::Accelerations(accelerations) => {
                if let Some(section) = self.accelerations(accelerations) {
                    return vec![section];
                }
                "by a symbolic factorization of the mass matrix (L D Lᵀ)"
            }
            SolvedForm::ArticulatedBodies => {
                "by articulated-body elimination, leaves first (Vereshchagin, Featherstone)"
            }
            SolvedForm::Numerical => "by a numerical factorization of the mass matrix (L D Lᵀ)",
        };
        let is_free = self.declared.names.multipliers.is_empty();
        let by = if is_free {
            by.to_owned()
        } else {
            by.replace("the mass matrix", "the matrix of M and G")
        };
        let heading = ["Solution for the accelerations:"; 2].map(String::from);
        let mut section = Section::new(Some(heading), "");
        if is_free && self.is_diagonal(mass) {
            let sentence = "The mass matrix is diagonal: each equation has one acceleration.";
            section.sentence = [sentence; 2].map(String::from);
            return vec![section];
        }
        let sentence = match form {
            SolvedForm::Numerical => format!("They are found {by}."),
            _ => format!("They are found {by}, in {operations} operations."),
        };
        let latex = sentence.replace("L D Lᵀ", "$L D L^T$");
        section.sentence = [sentence, latex];
        vec![section]
    }

    fn is_diagonal(&self, mass: &[Vec<Expression>]) -> bool {
        let mut rows = mass.iter().enumerate();
        rows.all(|(i, row)| {
            let mut entries = row.iter().enumerate();
            entries.all(|(j, entry)| i == j || self.model.graph.is_zero(*entry))
        })
    }

    /// q̈ where the quasi-velocities are the velocities and q̈ is short.
    fn through_constant_mass(&mut self, equations: &QuasiVelocityEquations) -> Option<Section> {
        let mut accelerations = vec![None; equations.quasi_velocities.len()];
        let mut values = BTreeMap::new();
        let forms = equations.quasi_velocities.iter();
        for (k, form) in (0..).zip(forms) {
            let Node::Symbol(Symbol::Velocity(j)) = self.model.graph.node(*form) else {
                return None;
            };
            *accelerations.get_mut(*j as usize)? = Some(equations.rates[k as usize]);
            values.insert(Symbol::QuasiVelocity(k), *form);
        }
        let accelerations: Option<Vec<_>> = accelerations.into_iter().collect();
        let accelerations = self.model.graph.substitute(&accelerations?, &values);
        self.accelerations(&accelerations)
    }

    /// q̈ itself where it is short.
    fn accelerations(&mut self, accelerations: &[Expression]) -> Option<Section> {
        let graph = &self.model.graph;
        let is_short =
            |x: &Expression| graph.written_symbols(&[*x], &self.letters) <= MAX_ACCELERATION_LENGTH;
        let few = accelerations.len() <= MAX_LISTED_ACCELERATIONS;
        if !few || !accelerations.iter().all(is_short) {
            return None;
        }
        let heading = if accelerations.len() > self.model.coordinates as usize {
            "Solved for the accelerations and the multipliers:"
        } else {
            "Solved for the accelerations:"
        };
        let heading = [heading; 2].map(String::from);
        let mut section = Section::new(Some(heading), "");
        for (i, acceleration) in (0..).zip(accelerations) {
            let left = self.letters.printed(Symbol::Acceleration(i));
            let right = self.arranged(*acceleration);
            self.push_arranged(&mut section, left, right);
        }
        Some(self.mention(section))
    }

    /// W ẇ = … and q̇ = E⁻¹ (w − b); none where the quasi-velocities are the velocities themselves, or where an
    /// equation is too long.
    fn in_quasi_velocities(&mut self, equations: &QuasiVelocityEquations) -> Option<Vec<Section>> {
        let forms = &equations.quasi_velocities;
        let velocity = |x: Expression| match self.model.graph.node(x) {
            Node::Symbol(Symbol::Velocity(j)) => Some(*j),
            _ => None,
        };
        let velocities: Vec<_> = forms.iter().map(|form| velocity(*form)).collect();
        if velocities.iter().all(Option::is_some) {
            return None;
        }
        let mut values = BTreeMap::new();
        let mut rates = Vec::new();
        for (k, velocity) in (0..).zip(&velocities) {
            let graph = &mut self.model.graph;
            rates.push(match velocity {
                Some(j) => {
                    values.insert(Symbol::QuasiVelocity(k), graph.symbol(Symbol::Velocity(*j)));
                    graph.symbol(Symbol::Acceleration(*j))
                }
                None => graph.symbol(Symbol::QuasiVelocityRate(k)),
            });
        }
        let heading = [
            "Boltzmann–Hamel equations, Euler's (3.5)–(3.7) for a rigid body, and kinematics:",
            "Boltzmann--Hamel equations, Euler's (3.5)--(3.7) for a rigid body, and kinematics:",
        ]
        .map(String::from);
        let mut dynamics = Section::new(Some(heading), "the method `accelerations`");
        self.unnamed(&mut dynamics, equations, &velocities);
        for (row, torque) in equations.inertia.iter().zip(&equations.torques) {
            let graph = &mut self.model.graph;
            let mut terms = Vec::new();
            for (entry, rate) in row.iter().zip(&rates) {
                terms.push((graph.multiply(*entry, *rate), Rational::ONE));
            }
            let left = graph.sum(terms);
            let torque = graph.substitute(&[*torque], &values)[0];
            let right = graph.arranged_by_velocities(torque, &self.letters);
            self.push_arranged(&mut dynamics, left, right);
        }
        for (j, velocity) in (0..).zip(&equations.velocities) {
            if velocities.contains(&Some(j)) {
                continue;
            }
            let velocity = self.model.graph.substitute(&[*velocity], &values)[0];
            let left = self.letters.printed(Symbol::Velocity(j));
            let right = self.arranged(velocity);
            self.push_arranged(&mut dynamics, left, right);
        }
        self.mention_all(forms);
        Some(vec![self.mention(dynamics)])
    }

    /// The quasi-velocities that have no name in the declaration.
    fn unnamed(
        &mut self,
        section: &mut Section,
        equations: &QuasiVelocityEquations,
        velocities: &[Option<u32>],
    ) {
        let forms = equations.quasi_velocities.iter().zip(velocities);
        for (k, (form, velocity)) in (0..).zip(forms) {
            if velocity.is_none() && self.letters.definition(*form).is_none() {
                let left = self.letters.printed(Symbol::QuasiVelocity(k));
                let right = self.arranged(*form);
                self.push_arranged(section, left, right);
            }
        }
    }
}
