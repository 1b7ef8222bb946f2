//! The programs of a model's methods.

use lagrangian_symbolic::{Equations, Expression, Kinetics, Model, Rational};

use super::derivatives::Derivatives;
use super::method::Method;
use super::outputs::{MethodOutputs, PivotOutputs, ProgramLayout};
use super::table::EmittedMethod;
use crate::limits::{MOST_PIVOTS, in_range};
use crate::syntax::shape::Shape;

/// The programs of everything that is emitted for a model.
pub(crate) struct Methods {
    pub(crate) lagrangian: Method,
    pub(crate) energy: Method,
    pub(crate) momenta: Method,
    pub(crate) mass_matrix: Method,
    pub(crate) forcing: Method,
    pub(crate) generalized_forces: Method,
    /// The invariants that are hoisted out of `accelerations`.
    pub(crate) prepare: Method,
    pub(crate) accelerations: Method,
    pub(crate) inverse_dynamics: Method,
    pub(crate) linearize: Method,
    /// Where M is eliminated symbolically.
    pub(crate) relative_pivots: Option<Method>,
    /// T and V, where they were declared.
    pub(crate) energies: Option<[Method; 2]>,
    pub(crate) input_jacobian: Method,
    pub(crate) outputs: Method,
    /// Where events are declared.
    pub(crate) event_functions: Option<Method>,
    /// The declared derivatives of external functions.
    pub(crate) functions: Vec<FunctionDerivative>,
    /// From which they were made.
    pub(super) kinetics: Kinetics,
}

/// A declared derivative of an external function.
pub(crate) struct FunctionDerivative {
    /// The position of the function.
    pub(crate) function: usize,
    /// The position of the argument.
    pub(crate) argument: usize,
    pub(crate) method: Method,
}

impl Methods {
    /// The program of a method, where the model has it.
    pub(crate) fn get(&self, method: EmittedMethod) -> Option<&Method> {
        let energies = self.energies.as_ref();
        match method {
            EmittedMethod::Lagrangian => Some(&self.lagrangian),
            EmittedMethod::Energy => Some(&self.energy),
            EmittedMethod::Momenta => Some(&self.momenta),
            EmittedMethod::MassMatrix => Some(&self.mass_matrix),
            EmittedMethod::Forcing => Some(&self.forcing),
            EmittedMethod::GeneralizedForces => Some(&self.generalized_forces),
            EmittedMethod::Prepare => Some(&self.prepare),
            EmittedMethod::Accelerations => Some(&self.accelerations),
            EmittedMethod::InverseDynamics => Some(&self.inverse_dynamics),
            EmittedMethod::Linearize => Some(&self.linearize),
            EmittedMethod::RelativePivots => self.relative_pivots.as_ref(),
            EmittedMethod::KineticEnergy => energies.map(|[kinetic, _]| kinetic),
            EmittedMethod::PotentialEnergy => energies.map(|[_, potential]| potential),
            EmittedMethod::InputJacobian => Some(&self.input_jacobian),
            EmittedMethod::Outputs => Some(&self.outputs),
            EmittedMethod::EventFunctions => self.event_functions.as_ref(),
        }
    }

    /// The methods that the model has.
    pub(crate) fn all(&self) -> impl Iterator<Item = (EmittedMethod, &Method)> {
        let all = EmittedMethod::ALL.iter();
        all.filter_map(|method| Some((*method, self.get(*method)?)))
    }

    /// The methods that are counted, with their names.
    pub(crate) fn counted(&self) -> impl Iterator<Item = (&'static str, &Method)> {
        let rows = self.all().map(|(emitted, method)| (emitted.row(), method));
        let counted = rows.filter(|(row, _)| row.is_counted);
        counted.map(|(row, method)| (row.name, method))
    }

    /// Differentiates what is still to be differentiated, and schedules each method. The declared outputs have
    /// these `shapes`.
    pub(crate) fn schedule(model: &mut Model, equations: &Equations, shapes: &[Shape]) -> Self {
        let kinetics = Kinetics::cheapest(model, equations);
        let linearize = Derivatives::of_state(model, &kinetics);
        let input_jacobian = Derivatives::of_inputs(model, &kinetics);
        let pivots = PivotExpressions::of(model, equations, &kinetics);
        let energies = kinetics.energies.clone();
        let model = &*model;
        let scalar = |expression| Method::single(model, &[expression], MethodOutputs::Scalar);
        let vector = |components: &[_]| Method::single(model, components, MethodOutputs::Vector);
        let mass = kinetics.mass.concat();
        let [prepare, accelerations] = Method::accelerations(model, &kinetics);
        Self {
            lagrangian: scalar(energies.lagrangian),
            energy: scalar(energies.energy),
            momenta: vector(&energies.momenta),
            mass_matrix: Method::single(model, &mass, MethodOutputs::SquareMatrix),
            forcing: vector(&kinetics.forcing),
            generalized_forces: vector(&equations.generalized_forces),
            prepare,
            accelerations,
            inverse_dynamics: vector(&kinetics.inverse_dynamics),
            linearize: linearize.schedule(model),
            relative_pivots: pivots.map(|pivots| pivots.schedule(model)),
            energies: energies.natural.map(|energies| energies.map(scalar)),
            input_jacobian: input_jacobian.schedule(model),
            outputs: Method::declared_outputs(model, shapes),
            event_functions: Method::event_functions(model, shapes),
            functions: function_derivatives(model),
            kinetics,
        }
    }

    /// A constant that `f64` cannot hold, if there is one: beyond its range, or lost below it.
    pub(crate) fn unrepresentable(&self) -> Option<&Rational> {
        let derivatives = self.functions.iter().map(|derivative| &derivative.method);
        let methods = self.all().map(|(_, method)| method).chain(derivatives);
        methods
            .flat_map(|method| method.program.constants())
            .find(|number| !in_range(number))
    }
}

/// The declared derivatives of all external functions.
fn function_derivatives(model: &Model) -> Vec<FunctionDerivative> {
    let mut derivatives = Vec::new();
    for function in model.graph.functions() {
        for argument in 0..model.graph.function_arguments(function).len() {
            if let Some(derivative) = model.graph.declared_derivative(function, argument) {
                derivatives.push(FunctionDerivative {
                    function: function.index(),
                    argument,
                    method: Method::single(model, &[derivative], MethodOutputs::Scalar),
                });
            }
        }
    }
    derivatives
}

/// What the relative pivots are computed from, where M is eliminated symbolically.
struct PivotExpressions {
    pivots: Vec<Expression>,
    magnitudes: Vec<Expression>,
    diagonal: Vec<Expression>,
}

impl PivotExpressions {
    fn of(model: &mut Model, equations: &Equations, kinetics: &Kinetics) -> Option<Self> {
        if kinetics.mass.len() > MOST_PIVOTS {
            return None;
        }
        let elimination = kinetics.ldlt.as_ref()?;
        let angles = &equations.coordinate_properties.angles;
        let rows = kinetics.mass.iter().enumerate();
        Some(Self {
            magnitudes: elimination.magnitudes(&mut model.graph, angles),
            pivots: elimination.pivots.clone(),
            diagonal: rows.map(|(i, row)| row[i]).collect(),
        })
    }

    fn schedule(&self, model: &Model) -> Method {
        let mut layout = ProgramLayout::new();
        let outputs = PivotOutputs {
            pivots: layout.add(&self.pivots),
            magnitudes: layout.add(&self.magnitudes),
            diagonal: layout.add(&self.diagonal),
        };
        Method::schedule(model, &layout, MethodOutputs::RelativePivots(outputs))
    }
}

impl Method {
    fn declared_outputs(model: &Model, shapes: &[Shape]) -> Self {
        let mut layout = ProgramLayout::new();
        let mut rest = model.outputs.as_slice();
        let mut outputs = Vec::with_capacity(shapes.len());
        for shape in shapes {
            let (components, others) = rest.split_at(shape.count());
            outputs.push((*shape, layout.add(components)));
            rest = others;
        }
        Self::schedule(model, &layout, MethodOutputs::Declared(outputs))
    }

    /// What is behind the outputs of these shapes.
    fn event_functions(model: &Model, shapes: &[Shape]) -> Option<Self> {
        let before = shapes.iter().map(|shape| shape.count()).sum();
        let events = model.outputs.get(before..)?;
        (!events.is_empty()).then(|| Self::single(model, events, MethodOutputs::Events))
    }
}
