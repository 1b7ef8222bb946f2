//! What clauses ask for besides the equations of motion: the Hamiltonian form, the balance of energy, the derivatives of
//! the accelerations by parameters, and the regressor.

use lagrangian_symbolic::{
    Equations, Expression, Kinetics, Model, NoRegressor, Rational, Regressor, Symbol,
    UnknownParameters,
};

use super::derivatives::Derivatives;
use super::method::Method;
use super::outputs::{MethodOutputs, ProgramLayout};
use crate::limits::MethodLimits;
use crate::lower::Lowered;
use crate::syntax::declaration::Declaration;
use crate::syntax::parameter_list::ParameterList;
use crate::syntax::scalar::Scalar;

/// What the clauses of a declaration ask for.
pub(crate) struct Requested {
    hamiltonian: bool,
    energy_balance: bool,
    /// The parameters by which is differentiated.
    sensitivities: Option<Vec<Symbol>>,
    regressor: Option<Regressor>,
    pub(super) languages: Languages,
    /// The compliances of the constraints, component by component.
    pub(super) compliances: Option<Vec<Expression>>,
    /// Whether the model is one on every scalar, so also on dual numbers.
    pub(super) is_on_every_scalar: bool,
    pub(super) limits: MethodLimits,
}

/// The languages that a model is written in.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Languages {
    Rust,
    RustAndC,
}

impl Requested {
    /// Derives the regressor, if there is to be one.
    pub(crate) fn derive(
        declaration: &Declaration,
        lowered: &Lowered,
        model: &mut Model,
        limits: MethodLimits,
    ) -> Result<Self, NoRegressor> {
        let clauses = &declaration.clauses;
        let quantities = &lowered.quantities;
        let named = |list: &ParameterList| {
            let fields = list.fields.as_ref();
            fields.map(|fields| quantities.symbols_of(fields))
        };
        let regressor = clauses.regressor.as_ref().map(|list| {
            let named = named(list);
            let unknown = match &named {
                Some(symbols) => UnknownParameters::Named(symbols),
                None => UnknownParameters::Every,
            };
            Regressor::derive(model, unknown)
        });
        let sensitivities = clauses.sensitivities.as_ref();
        Ok(Self {
            hamiltonian: clauses.hamiltonian.is_some(),
            energy_balance: clauses.energy_balance.is_some(),
            sensitivities: sensitivities
                .map(|list| named(list).unwrap_or_else(|| quantities.parameter_symbols())),
            regressor: regressor.transpose()?,
            languages: match clauses.c {
                Some(_) => Languages::RustAndC,
                None => Languages::Rust,
            },
            compliances: lowered.constraints.compliances.clone(),
            is_on_every_scalar: Scalar::of(declaration).is_generic(),
            limits,
        })
    }
}

/// The programs of what is asked for.
pub(crate) struct RequestedMethods {
    /// ∂L/∂q + Q.
    pub(crate) momentum_rates: Option<Method>,
    /// q̇ from the momenta; none where they are solved for numerically.
    pub(crate) solved_velocities: Option<Method>,
    /// Q·q̇ − ∂L/∂t − λᵀ a.
    pub(crate) energy_rate: Option<Method>,
    pub(crate) sensitivities: Option<Sensitivities>,
    pub(crate) regressor: Option<RegressorMethods>,
}

/// The derivatives of the accelerations by parameters.
pub(crate) struct Sensitivities {
    pub(crate) parameters: Vec<Symbol>,
    pub(crate) method: Method,
}

/// M q̈ − f = Y π + r.
pub(crate) struct RegressorMethods {
    /// The base parameters π as expressions.
    pub(crate) values: Vec<Expression>,
    /// The unknown parameters that no equation depends on.
    pub(crate) without_effect: Vec<Symbol>,
    /// Y, column by column.
    pub(crate) regressor: Method,
    /// r.
    pub(crate) known_terms: Method,
    /// π.
    pub(crate) base_parameters: Method,
}

impl RequestedMethods {
    pub(super) fn schedule(
        model: &mut Model,
        equations: &Equations,
        kinetics: &Kinetics,
        requested: &Requested,
    ) -> Self {
        let lagrangian = kinetics.energies.lagrangian;
        let forces = &equations.generalized_forces;
        let momentum_rates = requested.hamiltonian.then(|| {
            let rates = momentum_rates(model, lagrangian, forces);
            Method::single(model, &rates, MethodOutputs::Vector)
        });
        let solved_velocities = requested
            .hamiltonian
            .then(|| solved_velocities(model, kinetics))
            .flatten();
        let energy_rate = requested.energy_balance.then(|| {
            let rate = energy_rate(model, lagrangian, forces);
            let power = power_of_constraints(model, equations);
            let rate = model.graph.subtract(rate, power);
            Method::single(model, &[rate], MethodOutputs::Scalar)
        });
        let sensitivities = requested.sensitivities.as_ref().map(|parameters| {
            let derivatives = Derivatives::of_parameters(model, kinetics, parameters);
            Sensitivities {
                parameters: parameters.clone(),
                method: derivatives.schedule(model),
            }
        });
        let regressor = requested.regressor.as_ref();
        Self {
            momentum_rates,
            solved_velocities,
            energy_rate,
            sensitivities,
            regressor: regressor.map(|regressor| RegressorMethods::schedule(model, regressor)),
        }
    }
}

impl RegressorMethods {
    fn schedule(model: &Model, regressor: &Regressor) -> Self {
        let columns = regressor.columns.concat();
        let values = &regressor.base_parameters;
        Self {
            values: values.clone(),
            without_effect: regressor.without_effect.clone(),
            regressor: Method::single(model, &columns, MethodOutputs::SquareMatrix),
            known_terms: Method::single(model, &regressor.known, MethodOutputs::Vector),
            base_parameters: Method::single(model, values, MethodOutputs::Vector),
        }
    }
}

/// The velocities that have given momenta, by the factors that q̈ is solved for with.
fn solved_velocities(model: &mut Model, kinetics: &Kinetics) -> Option<Method> {
    let velocities = kinetics.velocities(model)?;
    let mut layout = ProgramLayout::new();
    let outputs = MethodOutputs::Velocities {
        pivots: layout.add(&kinetics.solution.as_ref()?.pivots),
        velocities: layout.add(&velocities),
    };
    Some(Method::schedule(model, &layout, outputs))
}

/// ∂L/∂q + Q.
fn momentum_rates(
    model: &mut Model,
    lagrangian: Expression,
    forces: &[Expression],
) -> Vec<Expression> {
    let coordinates = model.coordinate_symbols();
    let slopes = model.graph.jacobian(&[lagrangian], &coordinates).concat();
    let pairs = slopes.into_iter().zip(forces);
    pairs
        .map(|(slope, force)| model.graph.add(slope, *force))
        .collect()
}

/// λᵀ a, which is lost to constraints that are not scleronomic: their power is λᵀ G q̇ = −λᵀ a.
fn power_of_constraints(model: &mut Model, equations: &Equations) -> Expression {
    let constraints = &equations.constraints;
    let rheonomic = constraints.rheonomic(model);
    let graph = &mut model.graph;
    let mut terms = Vec::with_capacity(rheonomic.len());
    for (multiplier, rate) in constraints.multipliers().zip(rheonomic) {
        let multiplier = graph.symbol(multiplier);
        terms.push((graph.multiply(multiplier, rate), Rational::ONE));
    }
    graph.sum(terms)
}

/// Q·q̇ − ∂L/∂t.
fn energy_rate(model: &mut Model, lagrangian: Expression, forces: &[Expression]) -> Expression {
    let velocities = model.velocity_symbols();
    let graph = &mut model.graph;
    let rate = graph.derivative(lagrangian, Symbol::Time);
    let mut terms = vec![(rate, Rational::MINUS_ONE)];
    for (velocity, force) in velocities.into_iter().zip(forces) {
        let velocity = graph.symbol(velocity);
        terms.push((graph.multiply(velocity, *force), Rational::ONE));
    }
    graph.sum(terms)
}
