//! The derivatives of the accelerations, and what has to be computed before them.

use lagrangian_symbolic::{Expression, Kinetics, Model, Solution, Symbol};

use super::method::Method;
use super::outputs::{DerivativeOutputs, MethodOutputs, ProgramLayout, Residuals};

/// The derivatives of the accelerations, before they are scheduled.
pub(super) struct Derivatives {
    layout: ProgramLayout,
    outputs: MethodOutputs,
    /// How many right-hand sides are solved for numerically, if they are.
    right_hand_sides: Option<usize>,
    /// How many unknowns there are: the accelerations and the multipliers.
    unknowns: usize,
}

impl Derivatives {
    /// By q, q̇ and t.
    pub(super) fn of_state(model: &mut Model, kinetics: &Kinetics) -> Self {
        let symbols = state_symbols(model);
        let n = model.coordinates as usize;
        let add = |layout: &mut ProgramLayout, columns: &[Expression]| {
            layout.add_state_jacobian(columns, n)
        };
        let outputs = MethodOutputs::Linearization;
        Self::of(model, kinetics, (&symbols, true), add, outputs)
    }

    /// By parameters, on which M depends, too.
    pub(super) fn of_parameters(
        model: &mut Model,
        kinetics: &Kinetics,
        symbols: &[Symbol],
    ) -> Self {
        let outputs = MethodOutputs::Sensitivities;
        Self::of(
            model,
            kinetics,
            (symbols, true),
            ProgramLayout::add,
            outputs,
        )
    }

    /// By the inputs: the momenta are free of them, so that no input acts on M q̈, however it is written.
    pub(super) fn of_inputs(model: &mut Model, kinetics: &Kinetics) -> Self {
        let symbols = model.input_symbols();
        let outputs = MethodOutputs::InputJacobian;
        Self::of(
            model,
            kinetics,
            (&symbols, false),
            ProgramLayout::add,
            outputs,
        )
    }

    /// By some symbols, where columns are added so, and may contain accelerations or do not.
    fn of<C>(
        model: &mut Model,
        kinetics: &Kinetics,
        (symbols, contain_accelerations): (&[Symbol], bool),
        add: impl Fn(&mut ProgramLayout, &[Expression]) -> C,
        outputs: fn(DerivativeOutputs<C>) -> MethodOutputs,
    ) -> Self {
        let cleared = |model: &mut Model, columns: Vec<Expression>| {
            if contain_accelerations {
                columns
            } else {
                without_accelerations(model, &columns)
            }
        };
        let unknowns = kinetics.system.forcing.len();
        let mut layout = ProgramLayout::new();
        if let Some((solution, derivatives)) = solved(model, kinetics, symbols) {
            let derivatives = cleared(model, derivatives);
            let of_state = symbols.contains(&Symbol::Time) && !solution.pivots.is_empty();
            let variation = of_state.then(|| kinetics.residual_variation(&mut model.graph));
            let variation = variation.flatten();
            let residuals = if variation.is_some() {
                None
            } else {
                residuals_beside(model, kinetics, solution, symbols)
            };
            let residuals = residuals.map(|columns| cleared(model, columns));
            let pivots = layout.add(&solution.pivots);
            let accelerations = contain_accelerations.then(|| layout.add(&solution.accelerations));
            layout.begin_group();
            let derivatives = add(&mut layout, &derivatives);
            layout.begin_group();
            let residuals = match variation {
                Some(variation) => Some(Residuals::AlongVariation(layout.add(&variation))),
                None => residuals.map(|columns| Residuals::Columns(add(&mut layout, &columns))),
            };
            return Self {
                layout,
                outputs: outputs(DerivativeOutputs::Symbolic {
                    pivots,
                    accelerations,
                    derivatives,
                    residuals,
                }),
                right_hand_sides: None,
                unknowns,
            };
        }
        let residuals = kinetics.system_derivatives(&mut model.graph, symbols);
        let residuals = cleared(model, residuals);
        let system = &kinetics.system;
        let mass = layout.add_mass(system);
        let forcing = contain_accelerations.then(|| layout.add(&system.forcing));
        layout.begin_group();
        let residuals = add(&mut layout, &residuals);
        Self {
            layout,
            outputs: outputs(DerivativeOutputs::Numerical {
                mass,
                forcing,
                residuals,
            }),
            right_hand_sides: Some(symbols.len() + usize::from(contain_accelerations)),
            unknowns,
        }
    }

    pub(super) fn schedule(self, model: &Model) -> Method {
        let method = Method::schedule(model, &self.layout, self.outputs);
        match self.right_hand_sides {
            Some(count) => method.with_solution(self.unknowns, count),
            None => method,
        }
    }
}

/// The columns of ∂q̈/∂x, where they are solved for symbolically, with the solution that they belong to.
fn solved<'a>(
    model: &mut Model,
    kinetics: &'a Kinetics,
    symbols: &[Symbol],
) -> Option<(&'a Solution, Vec<Expression>)> {
    let solution = kinetics.solution.as_ref()?;
    let columns = kinetics.acceleration_derivatives(&mut model.graph, symbols)?;
    Some((solution, columns))
}

/// The columns of ∂(M q̈ − f)/∂x beside those of ∂q̈/∂x, to be solved for numerically where a pivot is not
/// positive; nothing where no pivot can fail.
fn residuals_beside(
    model: &mut Model,
    kinetics: &Kinetics,
    solution: &Solution,
    symbols: &[Symbol],
) -> Option<Vec<Expression>> {
    let can_fail = !solution.pivots.is_empty();
    let beside = [&*solution.pivots, &solution.accelerations].concat();
    can_fail.then(|| kinetics.residual_derivatives(&mut model.graph, symbols, &beside))
}

/// Expressions with zero accelerations and multipliers.
fn without_accelerations(model: &mut Model, roots: &[Expression]) -> Vec<Expression> {
    let zero = model.graph.zero();
    let unknowns = model.coordinates + u32::try_from(model.constraints.len()).unwrap_or(u32::MAX);
    let rest = (0..unknowns).map(|i| (Symbol::Acceleration(i), zero));
    model.graph.substitute(roots, &rest.collect())
}

/// q, q̇ and t.
pub(super) fn state_symbols(model: &Model) -> Vec<Symbol> {
    let mut symbols = model.coordinate_symbols();
    symbols.extend(model.velocity_symbols());
    symbols.push(Symbol::Time);
    symbols
}
