//! The equations of motion in quasi-velocities (Boltzmann, Über die Form der Lagrangeschen Gleichungen für
//! nichtholonome, generalisierte Koordinaten, 1902; Hamel, Die Lagrange-Eulerschen Gleichungen der Mechanik, 1904).
//!
//! With L = ½ wᵀ W w + L₀ and w = E q̇ + b, Lagrange's equations are
//!
//! Eᵀ W ẇ = Q − 𝓛(L₀) − Σ (W w)ₖ 𝓛(wₖ),   ẇ = E q̈ + D w,
//!
//! where 𝓛ᵢ = D ∂/∂q̇ᵢ − ∂/∂qᵢ and D is the time derivative at constant velocities. Where E is square,
//! q̈ follows through its factors, and M = Eᵀ W E is never formed: for a rigid body these are Euler's
//! equations (3.5)–(3.7) and the kinematics of its angles, with an error that does not grow as the
//! condition of M does.

use crate::limits::MAX_QUASI_VELOCITIES;
use crate::matrix::block_triangular::BlockTriangular;
use crate::matrix::ldlt::Ldlt;
use crate::matrix::rows::{differences, product, transposed};
use crate::mechanics::energy_forms::quasi_velocities::QuasiVelocities;
use crate::mechanics::solvers::pivots::Pivot;
use crate::mechanics::solvers::quasi_velocity_equations::QuasiVelocityEquations;
use crate::mechanics::solvers::structure_constants::structure_constants;
use crate::{Expression, Graph, Model, Pass, Rational, Symbol};

/// Accelerations through quasi-velocities.
#[derive(Clone)]
pub(crate) struct BoltzmannHamel {
    quasi_velocities: QuasiVelocities,
    kinematics: BlockTriangular,
    transposed: BlockTriangular,
    /// The factorization of W, where it has products of inertia.
    inertia: Option<Ldlt>,
    /// E q̈: the rates of the quasi-velocities less their velocity-product accelerations.
    rates: Vec<Expression>,
}

impl BoltzmannHamel {
    /// The solution through `quasi_velocities` under the generalized forces Q, if there are as many of
    /// them as coordinates.
    pub(crate) fn new(
        model: &mut Model,
        quasi_velocities: QuasiVelocities,
        forces: &[Expression],
    ) -> Option<Self> {
        let coordinates = model.coordinates;
        let graph = &mut model.graph;
        let size = quasi_velocities.forms.len();
        if size != coordinates as usize || size > MAX_QUASI_VELOCITIES {
            return None;
        }
        let matrix = quasi_velocities.kinematics(graph, coordinates);
        let transposed = BlockTriangular::new(graph, transposed(&matrix))?;
        let kinematics = BlockTriangular::new(graph, matrix)?;
        let inertia = if quasi_velocities.is_diagonal(graph) {
            None
        } else {
            Some(Ldlt::factor(
                graph,
                &quasi_velocities.inertia,
                MAX_QUASI_VELOCITIES,
            )?)
        };
        let mut found = Self {
            quasi_velocities,
            kinematics,
            transposed,
            inertia,
            rates: Vec::new(),
        };
        found.rates = found.rates(graph, coordinates, forces);
        Some(found)
    }

    /// The pivots of W, which must be positive.
    pub(crate) fn pivots(&self) -> Vec<Expression> {
        self.inertia
            .as_ref()
            .map_or_else(Vec::new, |inertia| inertia.pivots.clone())
    }

    /// What q̈ is divided by: the determinants of the diagonal blocks of E, and the pivots of W.
    pub(crate) fn divisors(&self) -> Vec<Pivot> {
        let mut divisors = Vec::new();
        for (determinant, rows, columns) in self.kinematics.determinants() {
            let mut of_block = vec![determinant];
            of_block.extend(rows.iter().map(|row| match &self.inertia {
                Some(inertia) => inertia.pivots[*row],
                None => self.quasi_velocities.inertia[*row][*row],
            }));
            divisors.extend(of_block.into_iter().map(|value| Pivot {
                value,
                coordinates: columns.to_vec(),
            }));
        }
        divisors
    }

    /// The accelerations.
    pub(crate) fn accelerations(&self, graph: &mut Graph) -> Vec<Expression> {
        self.kinematics.solve(graph, &self.rates)
    }

    /// x in M x = Eᵀ W E x = r.
    pub(crate) fn solution(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        let mut torques = self.transposed.solve(graph, right);
        for torque in &mut torques {
            *torque = graph.simplest(*torque);
        }
        let rates = self.divided_by_inertia(graph, &torques);
        self.kinematics.solve(graph, &rates)
    }

    /// ∂q̈/∂x column by column, with the accelerations as symbols.
    pub(crate) fn derivatives(&self, graph: &mut Graph, symbols: &[Symbol]) -> Vec<Expression> {
        let roots = [&*self.rates, &self.kinematics.matrix().concat()].concat();
        let occurring = graph.symbols(&roots);
        let mut columns = Vec::with_capacity(symbols.len() * self.rates.len());
        for symbol in symbols {
            if occurring.contains(symbol) {
                columns.extend(self.derivative(graph, *symbol));
            } else {
                columns.extend(self.rates.iter().map(|_| graph.zero()));
            }
        }
        columns
    }

    /// ∂q̈/∂x for one symbol: E ∂q̈/∂x = ∂(E q̈)/∂x − ∂E/∂x q̈.
    fn derivative(&self, graph: &mut Graph, symbol: Symbol) -> Vec<Expression> {
        let slopes = graph.derivatives(&self.rates, symbol);
        let mut right = Vec::with_capacity(slopes.len());
        for (slope, row) in slopes.into_iter().zip(self.kinematics.matrix()) {
            let mut terms = vec![(slope, Rational::ONE)];
            let changes = graph.derivatives(row, symbol);
            for (i, change) in (0..).zip(changes) {
                let acceleration = graph.symbol(Symbol::Acceleration(i));
                terms.push((graph.multiply(change, acceleration), Rational::MINUS_ONE));
            }
            right.push(graph.sum(terms));
        }
        self.kinematics.solve(graph, &right)
    }

    /// The equations of motion in q and w: q̇ = E⁻¹ (w − b) and ẇ = W⁻¹ E⁻ᵀ (Q − 𝓛(L₀) − …), with w as symbols.
    pub(crate) fn equations(
        &self,
        graph: &mut Graph,
        forces: &[Expression],
    ) -> QuasiVelocityEquations {
        let forms = &self.quasi_velocities.forms;
        let coordinates = u32::try_from(forms.len()).unwrap_or(u32::MAX);
        let symbols: Vec<_> = (0..coordinates)
            .map(|i| graph.symbol(Symbol::QuasiVelocity(i)))
            .collect();
        let offsets = self.quasi_velocities.offsets(graph, coordinates);
        let homogeneous = differences(graph, &symbols, &offsets);
        let velocities = self.kinematics.solve(graph, &homogeneous);
        let values = (0..).map(Symbol::Velocity).zip(velocities.iter().copied());
        let values = values.collect();
        let torques = self.torques(graph, coordinates, forces, &symbols);
        let mut torques = graph.substitute(&torques, &values);
        for torque in &mut torques {
            let simplest = graph.simplest(*torque);
            *torque = graph.factored(simplest);
        }
        QuasiVelocityEquations {
            quasi_velocities: forms.clone(),
            rates: self.divided_by_inertia(graph, &torques),
            inertia: self.quasi_velocities.inertia.clone(),
            torques,
            velocities,
        }
    }

    /// W⁻¹ x.
    fn divided_by_inertia(&self, graph: &mut Graph, torques: &[Expression]) -> Vec<Expression> {
        if let Some(inertia) = &self.inertia {
            return inertia.solve(graph, torques);
        }
        let inertia = &self.quasi_velocities.inertia;
        let torques = torques.iter().enumerate();
        torques
            .map(|(i, x)| graph.divide(*x, inertia[i][i]))
            .collect()
    }

    /// W⁻¹ E⁻ᵀ (Q − 𝓛(L₀) − …) − D w.
    fn rates(&self, graph: &mut Graph, coordinates: u32, forces: &[Expression]) -> Vec<Expression> {
        let torques = self.torques(graph, coordinates, forces, &self.quasi_velocities.forms);
        let rates = self.divided_by_inertia(graph, &torques);
        let direction = graph.constant_velocity_direction(coordinates);
        let velocity_products =
            graph.directional_derivatives(&self.quasi_velocities.forms, &direction);
        differences(graph, &rates, &velocity_products)
    }

    /// W ẇ, where the quasi-velocities in products with momenta are written as `forms`.
    fn torques(
        &self,
        graph: &mut Graph,
        coordinates: u32,
        forces: &[Expression],
        forms: &[Expression],
    ) -> Vec<Expression> {
        let gyroscopic = self.gyroscopic(graph, coordinates, forms);
        let rest = graph.lagrange_derivatives(&[self.quasi_velocities.rest], coordinates);
        let mut right = Vec::with_capacity(forces.len());
        for (i, force) in forces.iter().enumerate() {
            let mut terms = vec![(*force, Rational::ONE), (rest[0][i], Rational::MINUS_ONE)];
            if let Gyroscopic::ByCoordinate(values) = &gyroscopic {
                terms.push((values[i], Rational::MINUS_ONE));
            }
            let sum = graph.sum(terms);
            right.push(graph.factored(sum));
        }
        let mut torques = self.transposed.solve(graph, &right);
        for torque in &mut torques {
            *torque = graph.simplest(*torque);
        }
        match gyroscopic {
            Gyroscopic::ByForm(values) => differences(graph, &torques, &values),
            Gyroscopic::ByCoordinate(_) => torques,
        }
    }

    /// Σₖ (W w)ₖ 𝓛(wₖ): by quasi-velocity where their structure constants are constant.
    fn gyroscopic(&self, graph: &mut Graph, coordinates: u32, forms: &[Expression]) -> Gyroscopic {
        let declared = &self.quasi_velocities.forms;
        let momenta = product(graph, &self.quasi_velocities.inertia, forms);
        let homogeneous = graph.passes.has(Pass::StructureConstants)
            && !graph.contains(declared, |symbol| symbol == Symbol::Time)
            && self.quasi_velocities.is_homogeneous(graph, coordinates);
        let matrix = self.kinematics.matrix();
        if let Some(constants) = homogeneous
            .then(|| structure_constants(graph, matrix))
            .flatten()
        {
            let values = (0..forms.len()).map(|b| {
                let mut terms = Vec::new();
                for (k, momentum) in momenta.iter().enumerate() {
                    for (a, form) in forms.iter().enumerate() {
                        let product = graph.multiply(*momentum, *form);
                        terms.push((product, constants[k][a][b].clone()));
                    }
                }
                let sum = graph.sum(terms);
                let sum = graph.simplest(sum);
                graph.factored(sum)
            });
            return Gyroscopic::ByForm(values.collect());
        }
        let derivatives = graph.lagrange_derivatives(declared, coordinates);
        let values = (0..coordinates as usize).map(|i| {
            let terms: Vec<_> = momenta
                .iter()
                .zip(&derivatives)
                .map(|(momentum, row)| (graph.multiply(*momentum, row[i]), Rational::ONE))
                .collect();
            graph.sum(terms)
        });
        Gyroscopic::ByCoordinate(values.collect())
    }
}

/// The terms quadratic in the velocities that no ẇ contains.
enum Gyroscopic {
    /// In the equations of the quasi-velocities.
    ByForm(Vec<Expression>),
    /// In the equations of the coordinates.
    ByCoordinate(Vec<Expression>),
}
