//! Routh's reduction (Routh, A Treatise on the Stability of a Given State of Motion, 1877; Goldstein, Poole and Safko,
//! Classical Mechanics, 3rd edition 2002, section 8.3): the model over the coordinates that are not ignorable.
//!
//! With the momenta pₐ = ∂L/∂q̇ₐ = Cₐ of the ignorable coordinates as constants, their velocities u are eliminated exactly.
//! The other coordinates have Lagrange's equations of `L_R` = L − Σ Cₐ uₐ, which is −R with the Routhian R of (4.9). For
//! L = T₂ + b·q̇ − V of degree two in all velocities, and p = A u + B q̇ + b of the ignorable ones,
//!
//! - u = A⁻¹ (C − b) − A⁻¹ B q̇ = `u_C` + `u_B`,
//! - T of the reduced model is T₂ at `u_B`: the squares that T was declared as remain squares of one sign,
//! - `V_eff` = V + ½ (C − b)ᵀ A⁻¹ (C − b) (4.10), and the gyroscopic terms (C − b)·`u_B` − b·q̇ stand beside it.
//!
//! Constraints that contain neither ignorable coordinates nor their velocities remain as they are, with their multipliers.
//!
//! Where L is quadratic in u alone, `L_R` is L at u = 0 less ½ (C − β)ᵀ A⁻¹ (C − β), with β = p at u = 0.

mod elimination;
mod ignorability;
mod observations;
mod system;

use std::collections::BTreeMap;

use crate::algebra::half_angles::HalfAngleForm;
use crate::matrix::rows::agree;
use crate::mechanics::conservation::independent_of;
use crate::{Constraint, Energies, Equations, Expression, Graph, Model, Symbol};
use elimination::Elimination;
use ignorability::{Influences, spoilers};
pub use ignorability::{Obstacle, Spoiler};
use system::{Reduced, System};

/// A model reduced by its ignorable coordinates.
#[derive(Clone, Debug)]
pub struct Reduction {
    /// The reduced model: the other coordinates in their order, and the parameters with the constants Cₐ behind them. Its
    /// outputs are those that [`retain_outputs`](Self::retain_outputs) chooses; none at first.
    pub model: Model,
    /// The outputs of the full model in terms of the reduced one; or the position of an ignorable coordinate on which one
    /// depends, so that the state of the reduced model does not determine it.
    pub outputs: Vec<Result<Expression, usize>>,
    /// The positions of the ignorable coordinates in the full model.
    pub ignorable: Vec<usize>,
    /// The positions of the others.
    pub remaining: Vec<usize>,
    /// `V_eff`, the Routhian R at rest (4.10).
    pub effective_potential: Expression,
    /// The velocities u of the ignorable coordinates.
    pub ignorable_velocities: Vec<Expression>,
    /// The positions, in the reduced model, of angles at whose poles sin q = 0 its equations have no value as they are written,
    /// though they have a limit for some constants. None in half angles.
    pub poles: Vec<u32>,
}

/// Why a model has no reduction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoReduction {
    /// No coordinate is ignorable: what spoils each of them.
    NoneIgnorable(Vec<Spoiler>),
    /// All coordinates are ignorable, so that none remains.
    NoneRemains,
    /// The force on the first coordinate depends on the second one, which is otherwise ignorable.
    ForceDependsOn(usize, usize),
    /// This component of the constraints depends on this coordinate, which is otherwise ignorable.
    ConstraintDependsOn {
        /// The component, as it is counted in the model.
        constraint: usize,
        /// The coordinate.
        coordinate: usize,
    },
    /// L is not quadratic in the velocity of this ignorable coordinate, or A is singular.
    NotQuadratic(usize),
}

/// How quotients by squares of sines are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PoleForm {
    /// As they come: with fewest operations, and without a value at the poles.
    Direct,
    /// In partial fractions of half angles, which have values at the poles for the constants with which they are reached.
    HalfAngles,
}

impl Reduction {
    /// The reduction of `model`, which has so many `parameters`.
    ///
    /// # Errors
    ///
    /// Why there is none.
    pub fn of(
        model: &Model,
        equations: &Equations,
        parameters: u32,
        form: PoleForm,
    ) -> Result<Self, NoReduction> {
        let split = Split::of(model, equations)?;
        let mut graph = model.graph.clone();
        let mut system = split.system(model, equations, &mut graph, parameters)?;
        let mut reduced = match system.of_degree_two(&mut graph) {
            Some(reduced) => reduced,
            None => system.quadratic_in_ignorable_velocities(&mut graph),
        };
        let mut outputs = split.outputs(model, &mut graph, &reduced.velocities);
        let mut constraints = split.constraints(model, &mut graph);
        let constrained = (&mut *constraints, &mut *outputs);
        split.renumber(&mut graph, &mut reduced, &mut system.forces, constrained);
        let direct = reduced.effective_potential;
        let (written, mut poles) = in_half_angles(&mut graph, &[direct], HalfAngleForm::Squares);
        reduced.effective_potential = written[0];
        let mut evaluated = None;
        if form == PoleForm::HalfAngles {
            poles.clear();
            evaluated = Some(reduced.energies.evaluated(&mut graph, direct, written[0]));
            // Partial fractions have the shortest derivatives.
            let form = HalfAngleForm::PartialFractions;
            let differentiated =
                |energies: &[Expression]| in_half_angles(&mut graph, energies, form).0;
            reduced.energies = reduced.energies.written(differentiated);
            let evaluate = |graph: &mut Graph, expressions: &[Expression]| {
                in_half_angles(graph, expressions, HalfAngleForm::Squares).0
            };
            for velocity in &mut reduced.velocities {
                *velocity = evaluate(&mut graph, &[*velocity])[0];
            }
            // Forces are differentiated, too.
            system.forces = in_half_angles(&mut graph, &system.forces, form).0;
            for output in outputs.iter_mut().flatten() {
                *output = evaluate(&mut graph, &[*output])[0];
            }
        }
        let model = Model {
            coordinates: count(split.remaining.len()),
            inputs: model.inputs,
            energies: reduced.energies,
            evaluated,
            dissipation: graph.zero(),
            forces: system.forces,
            constraints,
            outputs: Vec::new(),
            declaration: None,
            graph,
        };
        Ok(Self {
            model,
            outputs,
            ignorable: split.ignorable,
            remaining: split.remaining,
            effective_potential: reduced.effective_potential,
            ignorable_velocities: reduced.velocities,
            poles,
        })
    }

    /// Gives the reduced model the outputs at these positions, as far as it determines them.
    pub fn retain_outputs(&mut self, positions: &[usize]) {
        let outputs = positions.iter().filter_map(|i| self.outputs.get(*i));
        self.model.outputs = outputs.filter_map(|output| output.ok()).collect();
    }
}

/// Expressions in half angles of each coordinate, where poles make that worth it, and the coordinates that have such poles.
fn in_half_angles(
    graph: &mut Graph,
    expressions: &[Expression],
    form: HalfAngleForm,
) -> (Vec<Expression>, Vec<u32>) {
    let angles = graph.symbols(expressions);
    let (mut written, mut poles) = (expressions.to_vec(), Vec::new());
    for angle in angles {
        if let Symbol::Coordinate(i) = angle
            && graph.write_in_half_angles(&mut written, angle, form)
        {
            poles.push(i);
        }
    }
    (written, poles)
}

impl Energies {
    /// The energies with what `write` returns in place of T and V, or of L.
    fn written(self, write: impl FnOnce(&[Expression]) -> Vec<Expression>) -> Self {
        match self {
            Self::Natural { kinetic, potential } => {
                let written = write(&[kinetic, potential]);
                Self::Natural {
                    kinetic: written[0],
                    potential: written[1],
                }
            }
            Self::General(lagrangian) => Self::General(write(&[lagrangian])[0]),
        }
    }

    /// In squares, where `effective_potential` is `written`.
    fn evaluated(
        self,
        graph: &mut Graph,
        effective_potential: Expression,
        written: Expression,
    ) -> Self {
        let form = HalfAngleForm::Squares;
        match self {
            Self::Natural { kinetic, potential } => {
                let gyroscopic = graph.subtract(potential, effective_potential);
                let kinetic = in_half_angles(graph, &[kinetic], form).0[0];
                let gyroscopic = in_half_angles(graph, &[gyroscopic], form).0[0];
                Self::Natural {
                    kinetic,
                    potential: graph.add(written, gyroscopic),
                }
            }
            general @ Self::General(_) => {
                general.written(|lagrangian| in_half_angles(graph, lagrangian, form).0)
            }
        }
    }
}

/// Which coordinates are ignorable.
struct Split {
    ignorable: Vec<usize>,
    remaining: Vec<usize>,
}

impl Split {
    fn of(model: &Model, equations: &Equations) -> Result<Self, NoReduction> {
        let ignorable: Vec<usize> = equations.conservation.ignorable().collect();
        let all = 0..model.coordinates as usize;
        let remaining: Vec<usize> = all.filter(|i| !ignorable.contains(i)).collect();
        if ignorable.is_empty() {
            let influences = Influences::of(model, equations);
            return Err(NoReduction::NoneIgnorable(spoilers(model, &influences)));
        }
        if remaining.is_empty() {
            return Err(NoReduction::NoneRemains);
        }
        let symbols: Vec<Symbol> = ignorable.iter().map(|i| coordinate(*i)).collect();
        for i in &remaining {
            let force = equations.generalized_forces[*i];
            let absent = independent_of(model, force, &symbols);
            if let Some(position) = absent.iter().position(|absent| !absent) {
                return Err(NoReduction::ForceDependsOn(*i, ignorable[position]));
            }
        }
        let constraints = &equations.constraints;
        for (velocity, constraint) in constraints.velocities.iter().zip(&constraints.declared) {
            let absent = independent_of(model, *velocity, &symbols);
            if let Some(position) = absent.iter().position(|absent| !absent) {
                return Err(NoReduction::ConstraintDependsOn {
                    constraint: *constraint,
                    coordinate: ignorable[position],
                });
            }
        }
        Ok(Self {
            ignorable,
            remaining,
        })
    }

    /// The model at fixed values of its ignorable coordinates, on which nothing depends.
    fn system(
        &self,
        model: &Model,
        equations: &Equations,
        graph: &mut Graph,
        parameters: u32,
    ) -> Result<System, NoReduction> {
        let mut roots: Vec<Expression> = self
            .remaining
            .iter()
            .map(|i| equations.generalized_forces[*i])
            .collect();
        let forces = roots.len();
        roots.push(equations.lagrangian);
        if let Energies::Natural { kinetic, potential } = model.energies {
            roots.extend([kinetic, potential]);
        }
        let fixed = self.fixed(graph, &roots);
        let lagrangian = fixed[forces];
        let mut system = System {
            kinetic_and_potential: fixed
                .get(forces + 1..forces + 3)
                .map(|parts| [parts[0], parts[1]]),
            lagrangian,
            forces: fixed[..forces].to_vec(),
            velocities: model.velocity_symbols(),
            ignorable: self.ignorable.iter().map(|i| velocity(*i)).collect(),
            offsets: Vec::new(),
            elimination: Elimination::default(),
            constants: Vec::new(),
        };
        system.constants = (0..count(self.ignorable.len()))
            .map(|k| graph.symbol(Symbol::Parameter(parameters + k)))
            .collect();
        let refuse = |position: usize| NoReduction::NotQuadratic(self.ignorable[position]);
        system.eliminate(graph).map_err(refuse)?;
        Ok(system)
    }

    /// The roots with ignorable coordinates replaced by numbers at which nothing changes, zeros if possible; T and V, which
    /// may depend on what cancels in L, keep their difference.
    fn fixed(&self, graph: &mut Graph, roots: &[Expression]) -> Vec<Expression> {
        self.fixed_with(graph, roots, self.remaining.len() + 1)
    }

    /// The same where so many of the first roots have to keep their values.
    fn fixed_with(
        &self,
        graph: &mut Graph,
        roots: &[Expression],
        compared: usize,
    ) -> Vec<Expression> {
        for number in [0, 1, 2, 3] {
            let value = graph.integer(number);
            let values = self.ignorable.iter().map(|i| (coordinate(*i), value));
            let fixed = graph.substitute(roots, &values.collect());
            if agree(graph, &roots[..compared], &fixed) {
                return fixed;
            }
        }
        roots.to_vec()
    }

    /// The constraints, at fixed values of the ignorable coordinates and their velocities, of which they may contain what cancels.
    fn constraints(&self, model: &Model, graph: &mut Graph) -> Vec<Constraint> {
        let expressions = model.constraints.iter();
        let expressions: Vec<_> = expressions.map(|one| one.expression()).collect();
        let fixed = self.fixed_with(graph, &expressions, expressions.len());
        let velocities: Vec<_> = self.ignorable.iter().map(|i| velocity(*i)).collect();
        let fixed = graph.at_zero(&fixed, &velocities);
        let pairs = model.constraints.iter().zip(fixed);
        pairs
            .map(|(one, expression)| one.with_expression(expression))
            .collect()
    }

    /// Numbers the coordinates that remain, and the multipliers behind their accelerations.
    fn renumber(
        &self,
        graph: &mut Graph,
        reduced: &mut Reduced,
        forces: &mut Vec<Expression>,
        (constraints, outputs): (&mut [Constraint], &mut [Result<Expression, usize>]),
    ) {
        let mut values = BTreeMap::new();
        let all = self.remaining.len() + self.ignorable.len();
        for i in 0..constraints.len() {
            let multiplier = graph.symbol(acceleration(self.remaining.len() + i));
            values.insert(acceleration(all + i), multiplier);
        }
        for (k, i) in self.remaining.iter().enumerate() {
            for symbol in [coordinate, velocity, acceleration] {
                values.insert(symbol(*i), graph.symbol(symbol(k)));
            }
        }
        for output in outputs.iter_mut().flatten() {
            *output = graph.substitute(&[*output], &values)[0];
        }
        for constraint in constraints {
            let expression = graph.substitute(&[constraint.expression()], &values)[0];
            *constraint = constraint.with_expression(expression);
        }
        *forces = {
            // The forces may depend on the velocities of ignorable coordinates.
            let ignorable = self.ignorable.iter().map(|i| velocity(*i));
            let rates = ignorable.zip(reduced.velocities.iter().copied()).collect();
            let eliminated = graph.substitute(forces, &rates);
            graph.substitute(&eliminated, &values)
        };
        reduced.velocities = graph.substitute(&reduced.velocities, &values);
        reduced.effective_potential = graph.substitute(&[reduced.effective_potential], &values)[0];
        let renumbered = |energies: &[Expression]| graph.substitute(energies, &values);
        reduced.energies = reduced.energies.written(renumbered);
    }
}

fn coordinate(index: usize) -> Symbol {
    Symbol::Coordinate(count(index))
}

fn velocity(index: usize) -> Symbol {
    Symbol::Velocity(count(index))
}

fn acceleration(index: usize) -> Symbol {
    Symbol::Acceleration(count(index))
}

/// Four billion names do not fit into a source file.
fn count(length: usize) -> u32 {
    u32::try_from(length).unwrap_or(u32::MAX)
}
