//! L, the energy function, T and the momenta, along the links of a mechanism where that costs less.

use std::mem;

use crate::matrix::rows::agree;
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::{Energies, Equations, Expression, Graph, Model, Rational};

/// The functions of the state that energies define.
#[derive(Clone, Debug)]
pub struct EnergyFunctions {
    /// The Lagrangian function L.
    pub lagrangian: Expression,
    /// The energy function h = Σ pᵢ q̇ᵢ − L.
    pub energy: Expression,
    /// T and V, where they were declared.
    pub natural: Option<[Expression; 2]>,
    /// The momenta p = ∂L/∂q̇.
    pub momenta: Vec<Expression>,
}

impl EnergyFunctions {
    /// The cheapest of those of the equations and those along links.
    pub(crate) fn cheapest(
        model: &mut Model,
        equations: &Equations,
        links: Option<&LinkEquations>,
    ) -> Self {
        let mut functions = Self {
            lagrangian: equations.lagrangian,
            energy: equations.energy,
            natural: match model.energies {
                Energies::Natural { kinetic, potential } => Some([kinetic, potential]),
                Energies::General(_) => None,
            },
            momenta: equations.momenta.clone(),
        };
        if let Some(links) = links {
            functions.along(&mut model.graph, links);
        }
        functions
    }

    /// The same as they are evaluated, where the model has another form of its energies for that.
    #[must_use]
    pub fn evaluated(&self, model: &mut Model) -> Self {
        let mut functions = self.clone();
        let Some(evaluated) = model.evaluated else {
            return functions;
        };
        let differentiated = mem::replace(&mut model.energies, evaluated);
        functions.lagrangian = model.lagrangian();
        functions.energy = model.energy(functions.lagrangian, &self.momenta);
        model.energies = differentiated;
        if let Energies::Natural { kinetic, potential } = evaluated {
            functions.natural = Some([kinetic, potential]);
        }
        functions
    }

    fn along(&mut self, graph: &mut Graph, links: &LinkEquations) {
        let (energy, momenta) = links.energy_and_momenta(graph);
        if graph.costs_less(&momenta, &self.momenta) && agree(graph, &momenta, &self.momenta) {
            self.momenta = momenta;
        }
        let Some([kinetic, potential]) = self.natural else {
            return;
        };
        if !graph.costs_less(&[energy], &[kinetic]) || !agree(graph, &[energy], &[kinetic]) {
            return;
        }
        self.natural = Some([energy, potential]);
        self.lagrangian = graph.subtract(energy, potential);
        if self.energy == graph.sum([(kinetic, Rational::ONE), (potential, Rational::ONE)]) {
            self.energy = graph.add(energy, potential);
        }
    }
}
