//! Why constraints have no equations, reported at the constraint.

use lagrangian_symbolic::{Constraint, ConstraintDefect, Model, Symbol};
use syn::Expr;

use crate::diagnostics::Diagnostics;
use crate::lower::Lowered;

/// Says at a constraint why it has no equations.
pub(super) fn report(
    defect: &ConstraintDefect,
    lowered: &Lowered,
    model: &Model,
    diagnostics: &mut Diagnostics,
) {
    let (component, message) = match defect {
        ConstraintDefect::Velocity(i) => (
            *i,
            "a holonomic constraint is a relation of coordinates and the time, and this one contains velocities: write \
             `nonholonomic(name = …)`"
                .to_owned(),
        ),
        ConstraintDefect::Input(i) => (*i, of_input(*i, lowered, model)),
        ConstraintDefect::Nonlinear(i) => (
            *i,
            "this is not linear in the velocities, and only constraints that are linear in them have reactions without work: \
             write a relation A q̇ + a = 0, as `dot(x) - r * dot(theta)`"
                .to_owned(),
        ),
        ConstraintDefect::NoVelocity { constraint, holds } => {
            (*constraint, of_no_velocity(*constraint, *holds, model).to_owned())
        }
        ConstraintDefect::Dependent {
            constraint,
            others,
            contradicts,
        } => (*constraint, dependent(others, *contradicts, lowered)),
    };
    if let Some(expression) = expression(component, lowered) {
        diagnostics.error(expression, message);
    }
}

fn expression(component: usize, lowered: &Lowered) -> Option<&Expr> {
    let constraint = lowered.constraints.of_component(component)?;
    Some(&constraint.expression)
}

fn of_input(component: usize, lowered: &Lowered, model: &Model) -> String {
    let roots = [model.constraints[component].expression()];
    let symbols = model.graph.symbols(&roots);
    let input = symbols.iter().find_map(|symbol| match symbol {
        Symbol::Input(i) => lowered.quantities.inputs.get(*i as usize),
        _ => None,
    });
    let name = input.map_or_else(String::new, |input| input.label.to_string());
    format!(
        "this contains the input `{name}`, whose rates of change are unknown: make it a function of `t`, or a coordinate that a \
         force moves"
    )
}

fn of_no_velocity(component: usize, holds: bool, model: &Model) -> &'static str {
    let constraint = model.constraints[component];
    let symbols = model.graph.symbols(&[constraint.expression()]);
    let is_coordinate = |symbol: &Symbol| matches!(symbol, Symbol::Coordinate(_));
    let is_nonholonomic = matches!(constraint, Constraint::Nonholonomic(_));
    if !holds && is_nonholonomic && symbols.iter().any(is_coordinate) {
        "this contains no velocity: a relation of coordinates is written as `constraint(name = …)`"
    } else if holds {
        "this is zero in every motion, so that it restricts nothing: remove the constraint"
    } else {
        "this depends on no coordinate, so that no motion can make it zero: write a relation of coordinates, or of velocities \
         in `nonholonomic(name = …)`"
    }
}

fn dependent(others: &[usize], contradicts: bool, lowered: &Lowered) -> String {
    let labels = lowered.constraints.labels();
    let names = others.iter().filter_map(|i| labels.get(*i));
    let names: Vec<_> = names.map(|label| format!("`{label}`")).collect();
    let names = match names.as_slice() {
        [] => "nothing".to_owned(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    };
    if contradicts {
        format!(
            "this contradicts {names}, so that no motion meets all of them: remove one, or give them the same dependence on \
             the time"
        )
    } else {
        format!(
            "this restricts no velocity that {names} would leave free: remove it, since its reaction would not be unique"
        )
    }
}
