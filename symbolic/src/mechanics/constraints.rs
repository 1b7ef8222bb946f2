//! Constraints, and the equations that they add to Lagrange's: with multipliers λ, M q̈ = f + Gᵀ λ and G q̈ + γ = 0.
//!
//! A holonomic constraint g(q, t) = 0 holds for the velocities as w = ġ = G q̇ + ∂g/∂t = 0, a nonholonomic one,
//! w = A(q, t) q̇ + a(q, t) = 0, as it is declared, with G = A. From either follows G q̈ + γ = 0 with
//! γ = (∂w/∂q) q̇ + ∂w/∂t (Whittaker, Analytical Dynamics, 1937, sections 25 and 87).
//!
//! What is wrong in every motion is decided exactly, by identity tests: relations that are not linear in the velocities, that
//! restrict none, or that follow from others for all q, t and parameters. Rows that depend on each other only where the
//! constraints hold, or for some parameters, are regular here.

use crate::identity::identity_testing::IdentityTest;
use crate::identity::modular_point::ModularPoint;
use crate::identity::residue;
use crate::identity::row_echelon::RowEchelon;
use crate::mechanics::dependence::Rows;
use crate::{Constraint, Expression, Graph, Model, Rational, Symbol};

/// The equations of the constraints of a model, the holonomic ones first.
#[derive(Clone, Debug, Default)]
pub struct ConstraintEquations {
    /// The index of each in the model.
    pub declared: Vec<usize>,
    /// g of the holonomic constraints.
    pub positions: Vec<Expression>,
    /// w = G q̇ + a.
    pub velocities: Vec<Expression>,
    /// G, row by row.
    pub jacobian: Vec<Vec<Expression>>,
    /// γ in G q̈ + γ = 0.
    pub rates: Vec<Expression>,
    /// The constraints, as they are counted in the model, that are declared as nonholonomic and can be integrated, together with
    /// the holonomic ones: they restrict the coordinates, and not the velocities alone. Where the coefficients of one are
    /// constant, the second entry is the function of coordinates and time whose rate the constraint is.
    pub integrable: Vec<(usize, Option<Expression>)>,
    /// Constraints, as they are ordered here, whose gradients depend on those before at almost all configurations, with
    /// coefficients that change with the configuration, as of a door on three hinges. Which constraints are redundant is decided at
    /// run time, at a configuration that they allow.
    pub surplus: Vec<usize>,
}

/// Why a model has no equations for its constraints. Constraints are counted as they are declared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ConstraintDefect {
    /// A holonomic constraint contains velocities.
    Velocity(usize),
    /// A constraint contains an input.
    Input(usize),
    /// A nonholonomic constraint is not linear in the velocities.
    Nonlinear(usize),
    /// A constraint restricts no velocity: it is no relation between coordinates, or none between velocities.
    NoVelocity {
        /// The constraint.
        constraint: usize,
        /// Whether it is zero in every motion.
        holds: bool,
    },
    /// A constraint restricts only velocities that earlier constraints restrict already, for all values of coordinates, time
    /// and parameters, and is not [surplus](ConstraintEquations::surplus).
    Dependent {
        /// The constraint.
        constraint: usize,
        /// The constraints from which it follows.
        others: Vec<usize>,
        /// Whether it contradicts them: then no motion fulfils all.
        contradicts: bool,
    },
}

impl ConstraintEquations {
    /// Derives the equations of the constraints of `model`.
    ///
    /// # Errors
    ///
    /// The first [`ConstraintDefect`].
    pub fn derive(model: &mut Model) -> Result<Self, ConstraintDefect> {
        let constraints = model.constraints.clone();
        for (position, constraint) in constraints.iter().enumerate() {
            check_symbols(&model.graph, position, *constraint)?;
        }
        let declared = model.holonomic_first();
        let ordered: Vec<_> = declared.iter().map(|i| constraints[*i]).collect();
        let (positions, others) = ordered.split_at(model.holonomic());
        let [positions, others] = [positions, others].map(|kind| {
            kind.iter()
                .map(|constraint| constraint.expression())
                .collect::<Vec<_>>()
        });
        let graph = &mut model.graph;
        let direction = graph.constant_velocity_direction(model.coordinates);
        let mut velocities = graph.directional_derivatives(&positions, &direction);
        velocities.extend(others);
        let symbols: Vec<_> = (0..model.coordinates).map(Symbol::Velocity).collect();
        let columns = graph.jacobian(&velocities, &symbols);
        let rows = 0..velocities.len();
        let jacobian = rows.map(|i| columns.iter().map(|column| column[i]).collect());
        let mut equations = Self {
            rates: graph.directional_derivatives(&velocities, &direction),
            jacobian: jacobian.collect(),
            declared,
            positions,
            velocities,
            integrable: Vec::new(),
            surplus: Vec::new(),
        };
        equations.surplus = equations.check(model)?;
        equations.integrable = equations.find_integrable(model);
        Ok(equations)
    }

    /// The column of G of a coordinate.
    #[must_use]
    pub fn column(&self, coordinate: usize) -> Vec<Expression> {
        self.jacobian.iter().map(|row| row[coordinate]).collect()
    }

    /// For each coordinate, whether its column of G contains neither coordinates nor the time, as it is written.
    #[must_use]
    pub fn constant_columns(&self, model: &Model) -> Vec<bool> {
        let changes = |symbol: &Symbol| matches!(symbol, Symbol::Coordinate(_) | Symbol::Time);
        let columns = (0..model.coordinates as usize).map(|i| self.column(i));
        columns
            .map(|column| !model.graph.symbols(&column).iter().any(changes))
            .collect()
    }

    /// a in w = G q̇ + a.
    pub fn rheonomic(&self, model: &mut Model) -> Vec<Expression> {
        let velocities = model.velocity_symbols();
        model.graph.at_zero(&self.velocities, &velocities)
    }

    /// Whether a constraint, as they are ordered here, restricts the coordinates: it is holonomic, or in disguise.
    #[must_use]
    pub fn restricts_coordinates(&self, row: usize) -> bool {
        let mut integrable = self.integrable.iter();
        row < self.positions.len() || integrable.any(|(i, _)| *i == self.declared[row])
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.velocities.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.velocities.is_empty()
    }

    /// The nonholonomic constraints that can be integrated: those of the largest set of declared relations
    /// ωⱼ = Aⱼ dq + aⱼ dt with dωⱼ = 0 for all displacements that the set allows (the theorem of Frobenius: Bryant et al.,
    /// Exterior Differential Systems, 1991, chapter II.1).
    fn find_integrable(&self, model: &mut Model) -> Vec<(usize, Option<Expression>)> {
        let holonomic = self.positions.len();
        if holonomic == self.len() {
            return Vec::new();
        }
        let forms = self.forms(model);
        let mut set: Vec<_> = (0..self.len()).collect();
        loop {
            let is_kept =
                |row: &usize| *row < holonomic || forms.is_closed_on(&model.graph, *row, &set);
            let kept: Vec<_> = set.iter().copied().filter(is_kept).collect();
            if kept.len() == set.len() {
                let kept = kept.into_iter().filter(|row| *row >= holonomic);
                let kept =
                    kept.map(|row| (self.declared[row], forms.integral(&mut model.graph, row)));
                return kept.collect();
            }
            set = kept;
        }
    }

    /// The relations as differential forms in (q, t), with their derivatives.
    fn forms(&self, model: &mut Model) -> Forms {
        let constant = self.rheonomic(model);
        let graph = &mut model.graph;
        let rows = self.jacobian.iter().zip(constant);
        let coefficients: Vec<Vec<_>> = rows
            .map(|(row, constant)| row.iter().copied().chain([constant]).collect())
            .collect();
        let mut symbols: Vec<_> = (0..model.coordinates).map(Symbol::Coordinate).collect();
        symbols.push(Symbol::Time);
        let derivatives = coefficients
            .iter()
            .map(|row| graph.jacobian(row, &symbols))
            .collect();
        Forms {
            coefficients,
            derivatives,
        }
    }

    /// Finds the surplus constraints.
    fn check(&self, model: &Model) -> Result<Vec<usize>, ConstraintDefect> {
        let graph = &model.graph;
        for (row, declared) in self.jacobian.iter().zip(&self.declared) {
            if (0..model.coordinates).any(|i| graph.depends_on(row, Symbol::Velocity(i))) {
                return Err(ConstraintDefect::Nonlinear(*declared));
            }
            if graph.vanishes(row) {
                let expression = model.constraints[*declared].expression();
                return Err(ConstraintDefect::NoVelocity {
                    constraint: *declared,
                    holds: graph.vanishes(&[expression]),
                });
            }
        }
        let rows = Rows::new(graph, &self.jacobian);
        let mut surplus = Vec::new();
        if rows.are_independent() {
            return Ok(surplus);
        }
        for row in 1..self.len() {
            let before: Vec<_> = (0..row).collect();
            if !rows.depends(row, &before) {
                continue;
            }
            let Some(others) = self.origin(graph, &rows, row) else {
                surplus.push(row);
                continue;
            };
            return Err(ConstraintDefect::Dependent {
                constraint: self.declared[row],
                others: others.iter().map(|i| self.declared[*i]).collect(),
                contradicts: !self
                    .rows_with(graph, &self.velocities)
                    .depends(row, &others),
            });
        }
        Ok(surplus)
    }

    /// G without the rows of surplus constraints.
    pub(crate) fn regular_rows(&self) -> Vec<Vec<Expression>> {
        let rows = self.jacobian.iter().enumerate();
        let regular = rows.filter(|(i, _)| !self.surplus.contains(i));
        regular.map(|(_, row)| row.clone()).collect()
    }
}

/// What a constraint may contain.
fn check_symbols(
    graph: &Graph,
    position: usize,
    constraint: Constraint,
) -> Result<(), ConstraintDefect> {
    let symbols = graph.symbols(&[constraint.expression()]);
    let contains = |kind: fn(&Symbol) -> bool| symbols.iter().any(kind);
    if contains(|symbol| matches!(symbol, Symbol::Input(_))) {
        return Err(ConstraintDefect::Input(position));
    }
    let has_velocity = contains(|symbol| matches!(symbol, Symbol::Velocity(_)));
    if has_velocity && constraint.is_holonomic() {
        return Err(ConstraintDefect::Velocity(position));
    }
    Ok(())
}

/// Differential forms ωⱼ = Σ cⱼᵢ dxᵢ in x = (q, t).
struct Forms {
    /// cⱼᵢ, form by form.
    coefficients: Vec<Vec<Expression>>,
    /// ∂cⱼᵢ/∂xₖ, for each form by columns k.
    derivatives: Vec<Vec<Vec<Expression>>>,
}

impl Forms {
    /// Σ cᵢ xᵢ, if the coefficients are constant.
    fn integral(&self, graph: &mut Graph, form: usize) -> Option<Expression> {
        let slopes = self.derivatives[form].concat();
        let zero = graph.zero();
        if slopes.iter().any(|slope| *slope != zero) {
            return None;
        }
        let coefficients = &self.coefficients[form];
        let coordinates = (0..).map(Symbol::Coordinate).take(coefficients.len() - 1);
        let mut terms = Vec::with_capacity(coefficients.len());
        for (coefficient, symbol) in coefficients.iter().zip(coordinates.chain([Symbol::Time])) {
            let symbol = graph.symbol(symbol);
            terms.push((graph.multiply(*coefficient, symbol), Rational::ONE));
        }
        Some(graph.sum(terms))
    }

    /// Whether dω(u, v) = Σ ∂cᵢ/∂xₖ (uₖ vᵢ − vₖ uᵢ) vanishes for all u and v on which the forms of a set vanish.
    fn is_closed_on(&self, graph: &Graph, form: usize, set: &[usize]) -> bool {
        let width = self.coefficients.first().map_or(0, Vec::len);
        let rows: Vec<_> = set.iter().map(|i| self.coefficients[*i].clone()).collect();
        let columns = self.derivatives[form].concat();
        let roots = [rows.concat(), columns].concat();
        let test = IdentityTest::of(graph, &roots);
        test.holds(|point: ModularPoint| {
            let values = point.evaluate(graph, &roots)?;
            let (rows, columns) = values.split_at(set.len() * width);
            let p = point.p();
            let basis = null_space(rows.chunks(width), width, p);
            // (∂cᵢ/∂xₖ) stands in column k, row i.
            let slope = |u: &[u64], v: &[u64]| {
                let mut sum = 0;
                for (column, u) in columns.chunks(width).zip(u) {
                    for (entry, v) in column.iter().zip(v) {
                        let product = residue::multiply(*entry, residue::multiply(*u, *v, p), p);
                        sum = residue::add(sum, product, p);
                    }
                }
                sum
            };
            let mut pairs = basis.iter().enumerate();
            Some(pairs.all(|(i, u)| basis[..i].iter().all(|v| slope(u, v) == slope(v, u))))
        })
    }
}

/// A basis of the vectors on which rows vanish, modulo the prime p.
fn null_space<'a>(rows: impl Iterator<Item = &'a [u64]>, width: usize, p: u64) -> Vec<Vec<u64>> {
    let mut echelon = RowEchelon::new(p);
    for row in rows {
        echelon.add(row.to_vec());
    }
    let reduced = echelon.reduced();
    let is_free = |column: &usize| reduced.iter().all(|(pivot, _)| pivot != column);
    let free = (0..width).filter(is_free);
    let vector = |column: usize| {
        let mut vector = vec![0; width];
        vector[column] = 1;
        for (pivot, row) in &reduced {
            vector[*pivot] = residue::negate(row[column], p);
        }
        vector
    };
    free.map(vector).collect()
}
