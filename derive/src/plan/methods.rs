//! The programs of a model's methods.

use lagrangian_symbolic::{Equations, Expression, Kinetics, Model, Rational, SolvedForm, Symbol};

use super::by_columns::ByColumns;
use super::constraint_methods::ConstraintMethods;
use super::derivatives::Derivatives;
use super::method::Method;
use super::outputs::{MethodOutputs, PivotOutputs, ProgramLayout};
use super::requested::{Languages, Requested, RequestedMethods};
use super::table::EmittedMethod;
use super::variation::VariationMethods;
use crate::limits::{MAX_PIVOTS, in_range};
use crate::syntax::shape::Shape;

/// The programs of everything that is emitted for a model.
pub(crate) struct Methods {
    pub(crate) lagrangian: Method,
    pub(crate) energy: Method,
    pub(crate) momenta: Method,
    pub(crate) mass_matrix: Method,
    pub(crate) forcing: Method,
    pub(crate) generalized_forces: Method,
    /// The invariants that are hoisted out of other methods.
    pub(crate) prepare: Method,
    pub(crate) accelerations: Method,
    pub(crate) inverse_dynamics: Method,
    /// Without constraints.
    pub(crate) linearize: Option<Method>,
    /// With constraints.
    pub(crate) constraints: Option<ConstraintMethods>,
    /// Where q̈ is solved for symbolically.
    pub(crate) relative_pivots: Option<Method>,
    /// Whether no pivot can come to vanish in the course of a motion.
    pub(crate) stays_regular: bool,
    /// T and V, where they were declared.
    pub(crate) energies: Option<[Method; 2]>,
    pub(crate) input_jacobian: Method,
    pub(crate) outputs: Method,
    /// Where events are declared.
    pub(crate) event_functions: Option<Method>,
    /// Where constraints are declared beside them.
    pub(crate) event_gradients: Option<Method>,
    /// The declared derivatives of external functions.
    pub(crate) functions: Vec<FunctionDerivative>,
    /// What clauses ask for.
    pub(crate) requested: RequestedMethods,
    /// For the model in C, where the model in Rust differentiates the accelerations on dual numbers.
    pub(crate) variation: Option<VariationMethods>,
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
        let requested = &self.requested;
        let regressor = requested.regressor.as_ref();
        let constraints = self.constraints.as_ref();
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
            EmittedMethod::Linearize => self.linearize.as_ref(),
            EmittedMethod::AccelerationsAndMultipliers => constraints.map(|_| &self.accelerations),
            EmittedMethod::ConstraintPositions => constraints.map(|methods| &methods.positions),
            EmittedMethod::ConstraintVelocities => constraints.map(|methods| &methods.velocities),
            EmittedMethod::ConstraintJacobian => constraints.map(|methods| &methods.jacobian),
            EmittedMethod::Compliances => constraints?.compliances.as_ref(),
            EmittedMethod::ConstraintRates => constraints.map(|methods| &methods.rates),
            EmittedMethod::RelativePivots => self.relative_pivots.as_ref(),
            EmittedMethod::KineticEnergy => energies.map(|[kinetic, _]| kinetic),
            EmittedMethod::PotentialEnergy => energies.map(|[_, potential]| potential),
            EmittedMethod::InputJacobian => Some(&self.input_jacobian),
            EmittedMethod::Outputs => Some(&self.outputs),
            EmittedMethod::EventFunctions => self.event_functions.as_ref(),
            EmittedMethod::EventGradient => self.event_gradients.as_ref(),
            EmittedMethod::MomentumRates => requested.momentum_rates.as_ref(),
            EmittedMethod::SolvedVelocities => requested.solved_velocities.as_ref(),
            EmittedMethod::EnergyRate => requested.energy_rate.as_ref(),
            EmittedMethod::Sensitivities => {
                let sensitivities = requested.sensitivities.as_ref();
                sensitivities.map(|sensitivities| &sensitivities.method)
            }
            EmittedMethod::SensitivitiesAndMultipliers => {
                constraints.and_then(|_| self.get(EmittedMethod::Sensitivities))
            }
            EmittedMethod::Regressor => regressor.map(|methods| &methods.regressor),
            EmittedMethod::KnownTerms => regressor.map(|methods| &methods.known_terms),
            EmittedMethod::BaseParameters => regressor.map(|methods| &methods.base_parameters),
        }
    }

    /// The methods that the model has.
    pub(crate) fn all(&self) -> impl Iterator<Item = (EmittedMethod, &Method)> {
        let all = EmittedMethod::ALL.iter();
        all.filter_map(|method| Some((*method, self.get(*method)?)))
    }

    /// The names of the methods that are counted, each with its program, where the model has it.
    pub(crate) fn counted(&self) -> impl Iterator<Item = (&'static str, Option<&Method>)> {
        let counted = EmittedMethod::ALL.iter();
        let counted = counted.filter(|method| method.row().is_counted);
        counted.map(|method| (method.row().name, self.get(*method)))
    }

    /// Differentiates what is still to be differentiated, and schedules each method. The declared outputs have
    /// these `shapes`.
    pub(crate) fn schedule(
        model: &mut Model,
        equations: &Equations,
        shapes: &[Shape],
        requested: &Requested,
    ) -> Self {
        let kinetics = Kinetics::cheapest(model, equations);
        let by_columns = ByColumns::of(model, &kinetics, requested);
        let is_free = equations.constraints.is_empty();
        let derivatives = (!by_columns.derivatives).then(|| {
            let linearize = is_free.then(|| Derivatives::of_state(model, &kinetics));
            (linearize, Derivatives::of_inputs(model, &kinetics))
        });
        let pivots = is_free
            .then(|| PivotExpressions::of(model, equations, &kinetics))
            .flatten();
        let stays_regular = stays_regular(model, &kinetics);
        let compliances = requested.compliances.as_deref();
        let by_duals_in_c =
            requested.languages == Languages::RustAndC && (by_columns.derivatives || !is_free);
        let variation = by_duals_in_c.then(|| VariationMethods::schedule(model, &kinetics));
        let requested = RequestedMethods::schedule(model, equations, &kinetics, requested);
        let energies = kinetics.energies.evaluated(model);
        let event_gradients = Method::event_gradients(model, shapes);
        let model = &*model;
        let scalar = |expression| Method::single(model, &[expression], MethodOutputs::Scalar);
        let vector = |components: &[_]| Method::single(model, components, MethodOutputs::Vector);
        let momenta = vector(&energies.momenta);
        let mass_matrix = if by_columns.mass {
            Method::mass_matrix_by_columns(model, &momenta)
        } else {
            Method::single(model, &kinetics.mass.concat(), MethodOutputs::SquareMatrix)
        };
        let [mut prepare, accelerations] = Method::accelerations(model, &kinetics);
        let inverse_dynamics = prepare.inverse_dynamics(model, &kinetics);
        let (linearize, input_jacobian) = if let Some((linearize, inputs)) = derivatives {
            let linearize = linearize.map(|derivatives| derivatives.schedule(model));
            (linearize, inputs.schedule(model))
        } else {
            let methods = [&prepare, &accelerations, &mass_matrix];
            let [linearize, inputs] =
                Method::derivatives_by_columns(model, &inverse_dynamics, methods);
            (Some(linearize), inputs)
        };
        Self {
            lagrangian: scalar(energies.lagrangian),
            energy: scalar(energies.energy),
            momenta,
            mass_matrix,
            forcing: vector(&kinetics.forcing),
            generalized_forces: vector(&equations.generalized_forces),
            prepare,
            accelerations,
            inverse_dynamics,
            linearize,
            constraints: ConstraintMethods::schedule(
                model,
                &equations.constraints,
                compliances,
                kinetics.solution.as_ref(),
            ),
            relative_pivots: pivots.map(|pivots| pivots.schedule(model)),
            stays_regular,
            energies: energies.natural.map(|energies| energies.map(scalar)),
            input_jacobian,
            outputs: Method::declared_outputs(model, shapes),
            event_functions: Method::event_functions(model, shapes),
            event_gradients,
            functions: function_derivatives(model),
            requested,
            variation,
            kinetics,
        }
    }

    /// The form in which the accelerations are found.
    pub(crate) fn solved_form(&self, model: &mut Model, equations: &Equations) -> SolvedForm {
        self.kinetics.solved_form(model, equations)
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

/// Whether no divisor of the accelerations can come to vanish while parameters keep their values.
fn stays_regular(model: &mut Model, kinetics: &Kinetics) -> bool {
    let graph = &mut model.graph;
    if let Some(solution) = &kinetics.solution {
        let divisors = solution.divisors(graph);
        let mut divisors = divisors.iter();
        return divisors.all(|pivot| graph.never_comes_to_vanish(pivot.value));
    }
    let mut entries = kinetics.system.mass.iter().flatten();
    entries.all(|entry| !graph.contents(*entry).varies())
}

/// What the relative pivots are computed from, where q̈ is solved for symbolically.
struct PivotExpressions {
    positive: Vec<Expression>,
    pivots: Vec<Expression>,
    magnitudes: Vec<Expression>,
    diagonal: Vec<Expression>,
    by_coordinate: Vec<Vec<usize>>,
}

impl PivotExpressions {
    fn of(model: &mut Model, equations: &Equations, kinetics: &Kinetics) -> Option<Self> {
        let size = kinetics.mass.len();
        if size > MAX_PIVOTS {
            return None;
        }
        let solution = kinetics.solution.as_ref()?;
        let divisors = solution.divisors(&model.graph);
        let angles = &equations.coordinate_properties.angles;
        let magnitudes = divisors
            .iter()
            .map(|pivot| pivot.magnitude(&mut model.graph, angles));
        let rows = kinetics.mass.iter().enumerate();
        let diagonal = rows.map(|(i, row)| row[i]);
        let of_coordinate = |i: usize| {
            let with_it = divisors.iter().enumerate();
            let with_it = with_it.filter(|(_, pivot)| pivot.coordinates.contains(&i));
            with_it.map(|(position, _)| position).collect()
        };
        Some(Self {
            positive: solution.pivots.clone(),
            magnitudes: magnitudes.collect(),
            diagonal: diagonal
                .filter(|_| solution.eliminates_mass_matrix())
                .collect(),
            by_coordinate: (0..size).map(of_coordinate).collect(),
            pivots: divisors.iter().map(|pivot| pivot.value).collect(),
        })
    }

    fn schedule(&self, model: &Model) -> Method {
        let mut layout = ProgramLayout::new();
        let outputs = PivotOutputs {
            positive: layout.add(&self.positive),
            pivots: layout.add(&self.pivots),
            magnitudes: layout.add(&self.magnitudes),
            diagonal: layout.add(&self.diagonal),
            by_coordinate: self.by_coordinate.clone(),
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

    /// The derivatives of the event functions by coordinates and time, unless they need one of an external function that is not
    /// declared.
    fn event_gradients(model: &mut Model, shapes: &[Shape]) -> Option<Self> {
        let before = shapes.iter().map(|shape| shape.count()).sum();
        let events = model.outputs.get(before..)?.to_vec();
        let mut symbols = model.coordinate_symbols();
        symbols.push(Symbol::Time);
        let columns = model.graph.jacobian(&events, &symbols);
        let gradients = (0..events.len()).flat_map(|i| columns.iter().map(move |column| column[i]));
        let gradients: Vec<_> = gradients.collect();
        let gradients = Self::single(model, &gradients, MethodOutputs::EventGradients);
        let functions = gradients.program.functions();
        let is_known = functions
            .into_iter()
            .all(|function| model.graph.undeclared(function).is_none());
        (!events.is_empty() && is_known).then_some(gradients)
    }

    /// What is behind the outputs of these shapes.
    fn event_functions(model: &Model, shapes: &[Shape]) -> Option<Self> {
        let before = shapes.iter().map(|shape| shape.count()).sum();
        let events = model.outputs.get(before..)?;
        (!events.is_empty()).then(|| Self::single(model, events, MethodOutputs::Events))
    }
}
