//! Errors of the equations of motion, reported where the declaration can be corrected.

mod constraints;

use std::collections::{BTreeMap, BTreeSet};

use lagrangian_symbolic::{
    Defect, Energies, Expression, ExternalFunction, Letters, Model, NoRegressor, NoSeries, Symbol,
};
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::ToTokens;

use crate::diagnostics::Diagnostics;
use crate::emit::printed_names;
use crate::limits::MAX_TERM_LENGTH;
use crate::lower::Lowered;
use crate::plan::NoTaylorSeries;
use crate::syntax::clauses::Clause;
use crate::syntax::coordinate::{Coordinate, indices};
use crate::syntax::declaration::Declaration;
use crate::syntax::names::unraw;
use crate::syntax::parameter_list::ParameterList;

/// Says which derivatives of external functions are missing.
pub(crate) fn report_undeclared(
    undeclared: &BTreeMap<(usize, usize), &'static str>,
    declaration: &Declaration,
    diagnostics: &mut Diagnostics,
) {
    for ((function, argument), needs) in undeclared {
        let function = &declaration.clauses.functions[*function];
        let (name, argument) = (&function.name, &function.arguments[*argument]);
        let message = format!(
            "{needs} ∂{name}/∂{argument}: add `derivative({argument}) = …` behind the value, or `derivative({argument}) \
             = 0.0` where that is constant piece by piece"
        );
        diagnostics.error(name, message);
    }
}

/// Says why there is no Taylor series, at the clause that asks for it or at the function that has none.
pub(crate) fn report_no_series(
    reason: NoTaylorSeries,
    clause: &Ident,
    declaration: &Declaration,
    diagnostics: &mut Diagnostics,
) {
    match reason {
        NoTaylorSeries::ExternalFunction(reason) => {
            report_function_without_series(reason, clause, declaration, diagnostics);
        }
        NoTaylorSeries::Wrong => {
            let message = "the recurrence for the Taylor series does not give the derivatives of the accelerations; this \
                           is a defect of `lagrangian`: please report the declaration, and leave `taylor` out";
            diagnostics.error(clause, message);
        }
    }
}

/// Says which derivative of an external function the Taylor series of the accelerations lacks.
fn report_function_without_series(
    reason: NoSeries,
    clause: &Ident,
    declaration: &Declaration,
    diagnostics: &mut Diagnostics,
) {
    let functions = &declaration.clauses.functions;
    let declared = |function: ExternalFunction| functions.get(function.index());
    let Some(applied) = declared(reason.function) else {
        return diagnostics.error(clause, OTHERWISE);
    };
    let name = &applied.name;
    let missing = reason.undeclared.and_then(|(function, argument)| {
        let function = declared(function)?;
        Some((function, function.arguments.get(argument)?))
    });
    let Some((function, argument)) = missing else {
        let message = format!(
            "the Taylor series of the accelerations needs all derivatives of `{name}`, which apply functions at ever further \
             arguments: write its derivatives in terms of functions at its own arguments, or {OTHERWISE}"
        );
        return diagnostics.error(name, message);
    };
    let message = format!(
        "the Taylor series of the accelerations needs all derivatives of `{name}`, and ∂{of}/∂{argument} is not declared: add \
         `derivative({argument}) = …` behind the value, in terms of functions whose derivatives are declared, or {OTHERWISE}",
        of = function.name
    );
    diagnostics.error(&function.name, message);
}

/// What remains where a function has no Taylor series.
const OTHERWISE: &str = "leave `taylor` out and integrate by `Dop853`";

/// Says why there is no regressor, at the parameter that is the reason or at the clause.
pub(crate) fn report_no_regressor(
    reason: &NoRegressor,
    declaration: &Declaration,
    lowered: &Lowered,
    model: &Model,
    diagnostics: &mut Diagnostics,
) {
    let Some(clause) = &declaration.clauses.regressor else {
        return;
    };
    let message = match reason {
        NoRegressor::NotPolynomial(parameters, term) => {
            let term = printed(model, lowered, *term);
            return report_not_polynomial((parameters, &term), clause, lowered, diagnostics);
        }
        NoRegressor::NothingUnknown => {
            "no equation of motion depends on these parameters: name others, or leave `regressor` out"
        }
        NoRegressor::TooManyMonomials => {
            "the energies and forces are sums of too many products of these parameters: name fewer of them, as in \
             `regressor(m, inertia)`, and the others are known"
        }
        NoRegressor::UnknownRegrouping => {
            "the equations depend on some of these parameters in combinations that are not found, by known parameters \
             within functions of the motion: name fewer parameters, one of each combination"
        }
    };
    diagnostics.error(&clause.keyword, message);
}

/// Names the parameters in which the equations are no polynomials.
fn report_not_polynomial(
    (parameters, term): (&BTreeSet<Symbol>, &str),
    clause: &ParameterList,
    lowered: &Lowered,
    diagnostics: &mut Diagnostics,
) {
    let mut seen = BTreeSet::new();
    for symbol in parameters {
        let Symbol::Parameter(i) = symbol else {
            continue;
        };
        let Some(component) = lowered.quantities.parameters.get(*i as usize) else {
            continue;
        };
        let name = unraw(&component.field);
        if !seen.insert(name.clone()) {
            continue;
        }
        let message = format!(
            "the equations of motion are not linear in `{label}` and its powers and products: it stands within \
             {term}; leave `{name}` out of this list, and it is known",
            label = component.label
        );
        let mut fields = clause.fields.iter().flatten();
        let field = fields.find(|field| unraw(field) == name);
        diagnostics.error(field.unwrap_or(&clause.keyword), message);
    }
}

/// A term as it is printed; a long one is only described.
fn printed(model: &Model, lowered: &Lowered, term: Expression) -> String {
    let letters = Letters::new(&printed_names(lowered));
    let text = model.graph.display_in(term, &letters).to_string();
    if text.chars().count() <= MAX_TERM_LENGTH {
        format!("`{text}`")
    } else {
        "a function, a root or a sum that is divided by".to_owned()
    }
}

/// The first clause of the energies.
fn energy(declaration: &Declaration) -> Option<&Clause> {
    let clauses = &declaration.clauses;
    clauses.kinetic.first().or(clauses.lagrangian.first())
}

/// Reports an error of the energies.
pub(crate) fn report_at_energy(
    declaration: &Declaration,
    message: &str,
    diagnostics: &mut Diagnostics,
) {
    if let Some(clause) = energy(declaration) {
        diagnostics.error(&clause.expression, message);
    }
}

/// Says why there are no equations of motion.
pub(crate) fn report(
    defect: &Defect,
    declaration: &Declaration,
    lowered: &Lowered,
    model: &Model,
    diagnostics: &mut Diagnostics,
) {
    match defect {
        Defect::NoInertia(coordinates) => {
            for (coordinate, missing) in by_name(coordinates, declaration) {
                let velocities = velocities(coordinate, &missing, lowered);
                let occur = missing.iter().any(|i| occurs(model, *i));
                let mention = mention(declaration, &coordinate.name, &velocities);
                let message = without_inertia(&velocities, occur, !model.constraints.is_empty());
                match mention.filter(|_| occur) {
                    Some(velocity) => diagnostics.error(velocity, message),
                    None => diagnostics.error(&coordinate.name, message),
                }
            }
        }
        Defect::NothingResists(coordinates) => {
            for (coordinate, missing) in by_name(coordinates, declaration) {
                let velocities = velocities(coordinate, &missing, lowered).join("` or `");
                let message = format!(
                    "nothing resists `{velocities}`: the kinetic energy contains it, and yet does not depend on it; give what is \
                     behind this joint a moment of inertia about its axis or a mass beside it, or remove the coordinate"
                );
                diagnostics.error(&coordinate.name, message);
            }
        }
        Defect::SingularMass(coordinates) => {
            let names = coordinates.iter();
            let names = names.map(|i| format!("`{}`", lowered.quantities.coordinates[*i as usize]));
            let names = names.collect::<Vec<_>>().join(", ");
            let message = if model.constraints.is_empty() {
                format!(
                    "the mass matrix is singular everywhere: the velocities of {names} occur only in combinations of which there \
                     are fewer; add the kinetic energy that is missing, or remove a coordinate"
                )
            } else {
                format!(
                    "the constraints allow motions of {names} in which nothing has inertia, so that their accelerations are not \
                     determined; add the kinetic energy that is missing, or the constraint that determines such a motion"
                )
            };
            report_at_energy(declaration, &message, diagnostics);
        }
        Defect::Constraint(defect) => constraints::report(defect, lowered, model, diagnostics),
        Defect::MomentumOfInput(inputs) => {
            for i in inputs {
                let name = &lowered.quantities.inputs[*i as usize].field;
                diagnostics.error(
                    lowered.scope.first_use(name).unwrap_or(name),
                    format!(
                        "the momenta ∂L/∂q̇ contain the input `{name}`, whose rate of change is unknown: \
                         make it a coordinate or a function of `t`, or write what it does under `force`"
                    ),
                );
            }
        }
    }
}

/// The declared coordinates of which some are among these, and which.
fn by_name<'a>(
    coordinates: &[u32],
    declaration: &'a Declaration,
) -> Vec<(&'a Coordinate, Vec<usize>)> {
    let is_among = |i: &usize| coordinates.iter().any(|other| *other as usize == *i);
    let declared = indices(&declaration.clauses.coordinates);
    let found = declared.map(|(coordinate, range)| (coordinate, range.filter(is_among).collect()));
    let found = found.filter(|(_, indices): &(_, Vec<usize>)| !indices.is_empty());
    found.collect()
}

/// The velocities of the coordinates of one name that are `missing`, as they are written.
fn velocities(coordinate: &Coordinate, missing: &[usize], lowered: &Lowered) -> Vec<String> {
    let is_one = coordinate.lengths.is_empty();
    if is_one && missing.len() == coordinate.count() {
        return vec![format!("dot({})", coordinate.name)];
    }
    let labels = missing.iter().map(|i| &lowered.quantities.coordinates[*i]);
    labels.map(|label| format!("dot({label})")).collect()
}

/// Whether the energies contain the velocity of a coordinate.
fn occurs(model: &Model, coordinate: usize) -> bool {
    let energies = match model.energies {
        Energies::Natural { kinetic, potential } => vec![kinetic, potential],
        Energies::General(lagrangian) => vec![lagrangian],
    };
    let is_velocity = |symbol| matches!(symbol, Symbol::Velocity(i) if i as usize == coordinate);
    model.graph.contains(&energies, is_velocity)
}

/// The first mention of some velocities in the energies, written like this or as that of all coordinates of the name.
fn mention(declaration: &Declaration, name: &Ident, velocities: &[String]) -> Option<TokenStream> {
    let whole = format!("dot({name})");
    let is_wanted = |written: &str| written == whole || velocities.iter().any(|one| one == written);
    let clauses = &declaration.clauses;
    let mut energies = clauses.kinetic.iter().chain(&clauses.lagrangian);
    energies.find_map(|clause| velocity(clause.expression.to_token_stream(), &is_wanted))
}

/// The first wanted call of `dot` in an expression.
fn velocity(tokens: TokenStream, is_wanted: &dyn Fn(&str) -> bool) -> Option<TokenStream> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    tokens.iter().enumerate().find_map(|(i, token)| {
        let TokenTree::Group(group) = token else {
            return None;
        };
        let call = i.checked_sub(1).map(|before| &tokens[before..=i]);
        let call: TokenStream = call.into_iter().flatten().cloned().collect();
        let written = call.to_string().replace(' ', "");
        if is_wanted(&written) {
            Some(call)
        } else {
            velocity(group.stream(), is_wanted)
        }
    })
}

/// The message for velocities in which the energies are not quadratic.
fn without_inertia(velocities: &[String], occur: bool, has_constraints: bool) -> String {
    let all = match velocities {
        [first, _, .., last] => format!("`{first}` to `{last}`"),
        few => format!("`{}`", few.join("` or `")),
    };
    if occur {
        format!(
            "the energies contain {all} only linearly, so the equation of motion has no acceleration: a kinetic \
             energy contains the square, as in `0.5 * m * dot(x).powi(2)` or `0.5 * m * dot(p).norm_squared()`"
        )
    } else if has_constraints {
        format!(
            "neither an energy nor a constraint contains {all}, so that nothing determines its acceleration: add the kinetic energy \
             of this coordinate or the constraint that moves it, or remove it"
        )
    } else {
        format!(
            "no energy contains {all}, so its equation of motion has no acceleration: add the kinetic \
             energy of this coordinate, or remove it"
        )
    }
}
