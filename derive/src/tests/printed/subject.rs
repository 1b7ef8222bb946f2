//! A derived model with its page, and the values that its equations have.

use lagrangian_symbolic::{
    Declared, Energies, Equations, Expression, Graph, Kinetics, Listing, Model, Program, Symbol,
};
use proc_macro2::TokenStream;
use syn::DeriveInput;

use super::meanings::linear_solution;
use super::notation::Spelled;
use super::random::Random;
use crate::check::{check, check_whole};
use crate::diagnostics::Diagnostics;
use crate::emit::{declared, listing};
use crate::lower::{Lowered, lower};
use crate::reduce::{ReducedDeclaration, Split, reduce, without_half_angles};
use crate::syntax::declaration::Declaration;

/// A model with its page.
pub(super) struct Subject {
    pub(super) name: String,
    pub(super) listing: Listing,
    pub(super) declared: Declared,
    pub(super) spelled: Spelled,
    pub(super) functions: Vec<String>,
    pub(super) coordinates: usize,
    energies: usize,
    program: Program,
}

/// The numbers of a state.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub(super) time: f64,
    pub(super) positions: Vec<f64>,
    pub(super) velocities: Vec<f64>,
    pub(super) accelerations: Vec<f64>,
    pub(super) parameters: Vec<f64>,
    pub(super) inputs: Vec<f64>,
    /// The multipliers of constraints.
    pub(super) multipliers: Vec<f64>,
}

/// What the equations are worth at a state.
#[derive(Clone, Debug)]
pub(super) struct Values {
    pub(super) energy: f64,
    pub(super) momenta: Vec<f64>,
    pub(super) mass: Vec<f64>,
    pub(super) forcing: Vec<f64>,
    /// With the reactions of constraints.
    pub(super) forces: Vec<f64>,
    /// M q̈ − f − Gᵀ λ.
    pub(super) inverse_dynamics: Vec<f64>,
    /// T and V, or L.
    pub(super) energies: Vec<f64>,
    pub(super) events: Vec<f64>,
    pub(super) definitions: Vec<f64>,
    /// g of the holonomic constraints, and w of the others.
    pub(super) constraints: Vec<f64>,
    /// w of all constraints.
    constraint_velocities: Vec<f64>,
    /// G, row by row.
    jacobian: Vec<f64>,
    /// γ in G q̈ + γ = 0.
    rates: Vec<f64>,
}

impl Values {
    /// G x.
    fn along_gradients(&self, x: &[f64]) -> Vec<f64> {
        let rows = self.jacobian.chunks(x.len().max(1));
        rows.map(|row| row.iter().zip(x).map(|(g, x)| g * x).sum())
            .collect()
    }

    /// The reactions Gᵀ λ.
    fn reactions(&self, multipliers: &[f64], coordinates: usize) -> Vec<f64> {
        let mut reactions = vec![0.0; coordinates];
        for (row, multiplier) in self.jacobian.chunks(coordinates.max(1)).zip(multipliers) {
            for (reaction, slope) in reactions.iter_mut().zip(row) {
                *reaction += slope * multiplier;
            }
        }
        reactions
    }

    /// The accelerations and the multipliers of a motion; none where the equations are singular.
    pub(super) fn solution(&self) -> Option<(Vec<f64>, Vec<f64>)> {
        let (n, c) = (self.forcing.len(), self.rates.len());
        let entry = |i: usize, j: usize| match (i < n, j < n) {
            (true, true) => self.mass[i * n + j],
            (true, false) => -self.jacobian[(j - n) * n + i],
            (false, true) => -self.jacobian[(i - n) * n + j],
            (false, false) => 0.0,
        };
        let matrix: Vec<f64> = (0..n + c)
            .flat_map(|i| (0..n + c).map(move |j| entry(i, j)))
            .collect();
        let right = [&*self.forcing, &self.rates].concat();
        let mut accelerations = linear_solution(&matrix, &right)?;
        let multipliers = accelerations.split_off(n);
        Some((accelerations, multipliers))
    }

    /// The velocities nearest to these that the constraints allow. Printed constants of motion hold only at such velocities. `None`
    /// if gradients depend on each other.
    fn allowed(&self, velocities: &[f64]) -> Option<Vec<f64>> {
        let n = velocities.len();
        let gradients: Vec<&[f64]> = self.jacobian.chunks(n.max(1)).collect();
        let products = gradients.iter().flat_map(|row| self.along_gradients(row));
        let products: Vec<f64> = products.collect();
        let parts = linear_solution(&products, &self.constraint_velocities)?;
        let changes = self.reactions(&parts, n);
        Some(velocities.iter().zip(changes).map(|(v, x)| v - x).collect())
    }
}

impl Subject {
    /// The models of a declaration: itself and what it is reduced to; none if there are errors.
    pub(super) fn all(declaration: TokenStream) -> Vec<Self> {
        let Ok(input) = syn::parse2::<DeriveInput>(declaration) else {
            return Vec::new();
        };
        let mut diagnostics = Diagnostics::default();
        let declaration = Declaration::parse(input, &mut diagnostics);
        check(&declaration, &mut diagnostics);
        let mut lowered = lower(&declaration, &mut diagnostics);
        let unknown = lowered.scope.unknown().next().is_some();
        if diagnostics.is_empty() && !unknown {
            check_whole(&declaration, &mut diagnostics);
        }
        if !diagnostics.is_empty() || unknown {
            return Vec::new();
        }
        let Some(mut model) = lowered.model.take() else {
            return Vec::new();
        };
        let Ok(equations) = Equations::derive(&mut model) else {
            return Vec::new();
        };
        // Of those that expansions refuse.
        let mut functions = model.graph.functions();
        if functions.any(|function| model.graph.undeclared(function).is_some()) {
            return Vec::new();
        }
        let full = Self::of(&mut model, &equations, (&declaration, &lowered));
        let reduced = Self::reduced((&declaration, &lowered), (&model, &equations));
        [full].into_iter().chain(reduced).collect()
    }

    fn reduced(
        (declaration, lowered): (&Declaration, &Lowered),
        (model, equations): (&Model, &Equations),
    ) -> Option<Self> {
        let clause = declaration.clauses.routhian.as_ref()?;
        let split = Split::of(equations, model.coordinates as usize);
        let reduced = ReducedDeclaration::of(declaration, lowered, split, clause);
        let mut diagnostics = Diagnostics::default();
        let declared = (declaration, lowered);
        let found = reduce(
            declared,
            (model, equations),
            clause,
            &reduced,
            &mut diagnostics,
        )?;
        let mut model = if clause.half_angles {
            without_half_angles(declared, (model, equations), clause)?
        } else {
            found.model
        };
        let equations = Equations::derive(&mut model).ok()?;
        let declared = (&reduced.declaration, &reduced.lowered);
        Some(Self::of(&mut model, &equations, declared))
    }

    fn of(
        model: &mut Model,
        equations: &Equations,
        (declaration, lowered): (&Declaration, &Lowered),
    ) -> Self {
        let kinetics = Kinetics::cheapest(model, equations);
        let solved = kinetics.solved_form(model, equations);
        let given = (declaration, lowered);
        let listing = listing(model, equations, given, (&solved, 1));
        let declared = declared(model, given, 1);
        let energies = match model.energies {
            Energies::Natural { kinetic, potential } => vec![kinetic, potential],
            Energies::General(lagrangian) => vec![lagrangian],
        };
        let functions = model.graph.functions();
        let functions = functions.map(|function| model.graph.function_name(function).to_owned());
        Self {
            name: declaration.name.to_string(),
            functions: functions.collect(),
            spelled: Spelled::of(&listing.unicode),
            listing,
            coordinates: model.coordinates as usize,
            energies: energies.len(),
            program: program(&model.graph, equations, &energies, &declared),
            declared,
        }
    }

    /// The values at a state.
    pub(super) fn values(&self, state: &State) -> Values {
        let external = |function: lagrangian_symbolic::ExternalFunction, arguments: &[f64]| {
            external(&self.functions[function.index()], arguments)
        };
        let found = self
            .program
            .evaluate_with(|symbol| state.value(symbol), external);
        let mut groups = found.into_iter();
        let mut next = || groups.next().unwrap_or_default();
        let scalars = next();
        let mut values = Values {
            energy: scalars[0],
            energies: scalars[1..=self.energies].to_vec(),
            momenta: next(),
            mass: next(),
            forcing: next(),
            forces: next(),
            inverse_dynamics: next(),
            events: next(),
            definitions: next(),
            constraints: next(),
            constraint_velocities: next(),
            jacobian: next(),
            rates: next(),
        };
        let reactions = values.reactions(&state.multipliers, self.coordinates);
        for (i, reaction) in reactions.into_iter().enumerate() {
            values.forces[i] += reaction;
            values.inverse_dynamics[i] -= reaction;
        }
        values
    }

    /// A state at which everything has a value, with accelerations at random.
    pub(super) fn state(&self, random: &mut Random) -> Option<State> {
        let names = &self.declared.names;
        for attempt in 0..200 {
            let spread = if attempt < 100 { 0.6 } else { 0.15 };
            let mut numbers = |count: usize, middle: f64| -> Vec<f64> {
                (0..count)
                    .map(|_| middle + spread * random.next())
                    .collect()
            };
            let n = self.coordinates;
            let mut state = State {
                time: numbers(1, 0.7)[0],
                positions: numbers(n, if attempt % 2 == 0 { 0.4 } else { 0.8 }),
                velocities: numbers(n, 0.2),
                accelerations: numbers(n, 0.1),
                parameters: numbers(names.parameters.len(), 0.9),
                inputs: numbers(names.inputs.len(), 0.3),
                multipliers: numbers(names.multipliers.len(), 0.2),
            };
            let Some(allowed) = self.values(&state).allowed(&state.velocities) else {
                continue;
            };
            state.velocities = allowed;
            let values = self.values(&state);
            let all = [
                &values.momenta,
                &values.inverse_dynamics,
                &values.energies,
                &values.events,
                &values.definitions,
                &values.constraints,
            ];
            let mut all = all.into_iter().flatten();
            if values.energy.is_finite() && all.all(|x| x.is_finite() && x.abs() < 1e4) {
                return Some(state);
            }
        }
        None
    }
}

/// Everything of which the page speaks.
fn program(
    graph: &Graph,
    equations: &Equations,
    energies: &[Expression],
    declared: &Declared,
) -> Program {
    let mass = equations.mass.concat();
    let scalars = [&[equations.energy], energies].concat();
    let [events, definitions] = [&declared.events, &declared.definitions]
        .map(|named| named.iter().map(|(_, x)| *x).collect::<Vec<_>>());
    let constraints = &equations.constraints;
    let holonomic = constraints.positions.len();
    let printed = constraints.positions.iter();
    let printed = printed.chain(constraints.velocities.iter().skip(holonomic));
    let printed: Vec<_> = printed.copied().collect();
    Program::schedule(
        graph,
        &[
            &scalars,
            &equations.momenta,
            &mass,
            &equations.forcing,
            &equations.generalized_forces,
            &equations.inverse_dynamics,
            &events,
            &definitions,
            &printed,
            &constraints.velocities,
            &constraints.jacobian.concat(),
            &constraints.rates,
        ],
    )
}

impl State {
    fn value(&self, symbol: Symbol) -> f64 {
        match symbol {
            Symbol::Time => self.time,
            Symbol::Coordinate(i) => self.positions[i as usize],
            Symbol::Velocity(i) => self.velocities[i as usize],
            Symbol::Acceleration(i) => {
                let both = self.accelerations.iter().chain(&self.multipliers);
                both.copied().nth(i as usize).unwrap_or(f64::NAN)
            }
            Symbol::Parameter(i) => self.parameters[i as usize],
            Symbol::Input(i) => self.inputs[i as usize],
            _ => f64::NAN,
        }
    }
}

/// Some function of that name.
pub(super) fn external(name: &str, arguments: &[f64]) -> f64 {
    let seed: u32 = name.bytes().fold(7, |seed, byte| {
        seed.wrapping_mul(31).wrapping_add(u32::from(byte))
    });
    let phase = f64::from(seed % 97) / 10.0;
    let weights = (1..).map(|k| 0.4 + f64::from(k) / 7.0);
    let total: f64 = arguments.iter().zip(weights).map(|(x, w)| x * w).sum();
    1.3 + 0.5 * (total + phase).sin()
}
