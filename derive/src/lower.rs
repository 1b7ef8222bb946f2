//! From a checked declaration to a model: every name resolved, every number exact.

pub(crate) mod quantities;
pub(crate) mod value;
pub(crate) mod body;
pub(crate) mod scope;
pub(crate) mod builtins;
mod unknown_function;
mod hints;
mod expression;
mod energies;
mod events;
pub(crate) mod constraints;
mod constraint_clauses;
mod compliances;
mod forces;
mod ablation;

use core::mem;

use lagrangian_symbolic::{Energies, Expression, Graph, Model, TypedGraph, Value};
use proc_macro2::Ident;
use syn::Expr;

use crate::diagnostics::Diagnostics;
use crate::lower::ablation::passes;
use crate::lower::constraints::Constraints;
use crate::lower::expression::Lowerer;
use crate::lower::quantities::Quantities;
use crate::lower::scope::Scope;
use crate::syntax::declaration::Declaration;
use crate::syntax::named::{ForClause, NamedExpression};
use crate::syntax::shape::Shape;

/// A declaration with its names resolved, as far as it is free of errors.
pub(crate) struct Lowered {
    /// Present unless errors were reported or names are unresolved.
    pub(crate) model: Option<Model>,
    pub(crate) scope: Scope,
    pub(crate) quantities: Quantities,
    /// The shapes of the outputs, in their order; of those with errors, that of a scalar.
    pub(crate) outputs: Vec<Shape>,
    /// The same of the events, which are outputs behind the others.
    pub(crate) events: Vec<Shape>,
    /// The constraints, as far as they are free of errors.
    pub(crate) constraints: Constraints,
    /// The bodies of kinetic energies, as their masses, with the components of their angular velocities.
    pub(crate) turning: Vec<(Expression, Vec<Expression>)>,
}

/// Resolves a declaration.
pub(crate) fn lower(declaration: &Declaration, diagnostics: &mut Diagnostics) -> Lowered {
    let mut graph = Graph::new();
    graph.passes = passes(diagnostics);
    let quantities = Quantities::new(declaration);
    let coordinates = count(quantities.coordinates.len());
    let mut typed = TypedGraph::new(graph, coordinates);
    let mut lowerer = Lowerer {
        scope: Scope::new(declaration, &mut typed),
        typed,
        coordinates,
        diagnostics,
        repetitions: 0,
        admits_accelerations: false,
        within_index: false,
        within_derivative: false,
        rotations: 0,
        definitions: &declaration.clauses.definitions,
        defining: None,
        turning: Vec::new(),
        known_constraints: None,
    };
    let parts = lowerer.parts(declaration);
    let complete = lowerer.diagnostics.is_empty() && lowerer.scope.unknown().next().is_none();
    let shape = |output: &Option<Value>| output.map_or(Shape::Scalar, |value| lowerer.shape(value));
    let outputs = parts.outputs.iter().map(shape).collect();
    let events = parts.events.iter().map(shape).collect();
    let turning = mem::take(&mut lowerer.turning);
    let constraints = lowerer.known_constraints.take().unwrap_or_default();
    let typed = lowerer.typed;
    let model = if complete {
        parts.model(typed, &quantities, &constraints)
    } else {
        None
    };
    Lowered {
        model,
        scope: lowerer.scope,
        quantities,
        outputs,
        events,
        constraints,
        turning,
    }
}

/// The components of values one after the other; a sum without terms is 0.
fn components(typed: &TypedGraph, values: &[Value]) -> Vec<Expression> {
    let components = |value: &Value| match typed.components(*value).elements() {
        [] => vec![typed.expression(*value)],
        elements => elements.to_vec(),
    };
    values.iter().flat_map(components).collect()
}

/// The parts of a model, each `None` if it has errors.
struct Parts {
    energies: Option<Energies>,
    /// T and V, where something turns.
    of_rotations: Option<[Value; 2]>,
    dissipation: Option<Expression>,
    forces: Option<Vec<Expression>>,
    outputs: Vec<Option<Value>>,
    events: Vec<Option<Value>>,
}

impl Parts {
    fn model(
        self,
        typed: TypedGraph,
        quantities: &Quantities,
        constraints: &Constraints,
    ) -> Option<Model> {
        let observed = self.outputs.into_iter().chain(self.events);
        let outputs = components(&typed, &observed.collect::<Option<Vec<_>>>()?);
        let (graph, declaration) = match self.of_rotations {
            Some(energies) => {
                let (graph, system) = typed.into_system(energies, constraints.values());
                (graph, Some(system))
            }
            None => (typed.geometry.graph, None),
        };
        Some(Model {
            graph,
            coordinates: count(quantities.coordinates.len()),
            inputs: count(quantities.inputs.len()),
            energies: self.energies?,
            evaluated: None,
            dissipation: self.dissipation?,
            forces: self.forces?,
            constraints: constraints.components.clone(),
            outputs,
            declaration,
        })
    }
}

impl Lowerer<'_> {
    fn parts(&mut self, declaration: &Declaration) -> Parts {
        let clauses = &declaration.clauses;
        self.declare_functions(&clauses.functions);
        self.typed.begin_definitions();
        for definition in &clauses.definitions {
            self.define(definition);
        }
        let kinetic = self.total(&clauses.kinetic);
        let potential = self.total(&clauses.potential);
        let lagrangian = self.total(&clauses.lagrangian);
        let dissipation = self.dissipation(&clauses.dissipation);
        let forces = self.forces(declaration);
        self.known_constraints = self.constraints(clauses);
        self.compliances(&clauses.compliances);
        let outputs = self.with_accelerations(|lowerer| lowerer.observed(&clauses.outputs));
        let events = self.observed(&clauses.events);
        self.check_events(&clauses.events, &events);
        let natural = kinetic
            .zip(potential)
            .filter(|_| clauses.lagrangian.is_empty());
        let energies = match natural {
            Some((kinetic, potential)) => Some(self.natural(&clauses.kinetic, kinetic, potential)),
            None => lagrangian
                .filter(|_| !clauses.lagrangian.is_empty())
                .map(|lagrangian| self.general(&clauses.lagrangian, lagrangian)),
        };
        let turns = self.rotations > 0;
        Parts {
            energies,
            of_rotations: natural.filter(|_| turns).map(<[Value; 2]>::from),
            dissipation,
            forces,
            outputs,
            events,
        }
    }

    /// The values of outputs or events. One with indices has been refused.
    fn observed(&mut self, named: &[NamedExpression]) -> Vec<Option<Value>> {
        let values = named.iter().map(|named| {
            let whole = named.indices.is_empty() && named.iterations.is_empty();
            let expression = whole.then_some(&named.expression)?;
            self.lower(expression)
        });
        values.collect()
    }

    /// Gives a name its binding, or the members of a family theirs.
    fn define(&mut self, definition: &NamedExpression) {
        #[cfg(test)]
        definitions_lowered::add_one();
        if definition.indices.is_empty() {
            if let Some(iteration) = definition.iterations.first() {
                let name = &definition.name;
                let message = format!(
                    "what is defined for every index has the index behind its name: write \
                     `{name}[{}] = …`",
                    iteration.index
                );
                self.diagnostics.error(name, message);
                return self.scope.poison_definition(name);
            }
            self.defining = Some((definition.name.clone(), Vec::new()));
            let value = self.lower_with_accelerations(&definition.expression);
            self.defining = None;
            return match value {
                Some(value) => self.scope.define(&self.typed, &definition.name, value),
                None => self.scope.poison_definition(&definition.name),
            };
        }
        let defined = self.for_each(&definition.iterations, &mut |lowerer| {
            lowerer.define_member(definition)
        });
        if defined.is_none() {
            self.scope.poison_definition(&definition.name);
        }
    }

    /// Defines one member of a family.
    fn define_member(&mut self, definition: &NamedExpression) -> Option<()> {
        #[cfg(test)]
        definitions_lowered::add_one();
        let name = &definition.name;
        self.check_not_bound(name, &definition.iterations)?;
        let indices = self.member(&definition.indices)?;
        if let Some(rank) = self.scope.rank_of_definition(name)
            && rank != indices.len()
        {
            let message = format!(
                "`{name}` has {rank} before: all of a family have the same number of indices",
                rank = if rank == 1 {
                    "one index".to_owned()
                } else {
                    format!("{rank} indices")
                }
            );
            return self.reject(name, message);
        }
        self.defining = Some((name.clone(), indices.clone()));
        let value = self.lower_with_accelerations(&definition.expression);
        self.defining = None;
        let value = value?;
        if let Shape::Array {
            rows: 3..,
            columns: 3..,
        } = self.shape(value)
        {
            self.count_rotation(name)?;
        }
        if self.scope.define_member(&self.typed, name, &indices, value) {
            return Some(());
        }
        let written = hints::member(name, &indices);
        let message = format!("`{written}` is defined twice: leave one of them out");
        self.reject(&definition.indices[0], message)
    }

    /// Rejects a variable that shadows the name whose members it enumerates.
    pub(super) fn check_not_bound(&mut self, name: &Ident, iterations: &[ForClause]) -> Option<()> {
        let hiding = iterations.iter().find(|iteration| iteration.index == *name);
        match hiding {
            None => Some(()),
            Some(iteration) => {
                let message = format!(
                    "here `{name}` is the variable: give it another name, as in `for i in 0..5`"
                );
                self.reject(&iteration.index, message)
            }
        }
    }

    /// The indices of a member of a family, as they follow its name.
    pub(super) fn member(&mut self, indices: &[Expr]) -> Option<Vec<usize>> {
        let indices = indices.iter();
        let indices = indices.map(|written| self.natural_number(written, "an index"));
        indices.collect()
    }

    /// The value of an expression that is an integer known at compile time and not negative.
    pub(super) fn natural_number(&mut self, written: &Expr, what: &str) -> Option<usize> {
        let number = self.integer(written)?;
        usize::try_from(number).ok().or_else(|| {
            let message = format!("{what} is not negative: here it is {number}");
            self.reject(written, message)
        })
    }
}

/// Four billion names do not fit into a source file.
pub(crate) fn count(length: usize) -> u32 {
    u32::try_from(length).unwrap_or(u32::MAX)
}

/// How many definitions, and members of families of them, were lowered on this thread.
#[cfg(test)]
pub(crate) mod definitions_lowered {
    use core::cell::Cell;

    std::thread_local! {
        static COUNT: Cell<usize> = const { Cell::new(0) };
    }

    pub(super) fn add_one() {
        COUNT.set(COUNT.get() + 1);
    }

    pub(crate) fn take() -> usize {
        COUNT.take()
    }
}
