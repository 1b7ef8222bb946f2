//! The regressor of a model: M q̈ − f = Y π + r, with base parameters π that are linear in what is unknown, a matrix
//! Y(q, q̇, q̈, t) whose columns are linearly independent functions of the motion, and r, the part that is known
//! (Khosla and Kanade, Parameter identification of robot dynamics, 1985; Atkeson, An and Hollerbach, Estimation of
//! inertial parameters of manipulator loads and links, 1986).
//!
//! L, D and the forces are polynomials in the unknown parameters. Lagrange's operator is linear, so that each of their
//! monomials has a column of its own: what Lagrange's formula makes of its coefficients. `base_parameters.rs` finds
//! which columns are independent, and what is regrouped.

pub(crate) mod parameter_polynomial;
mod base_parameters;
mod regrouping;

use std::collections::{BTreeMap, BTreeSet};

use crate::mechanics::regressor::base_parameters::BaseParameters;
use crate::mechanics::regressor::parameter_polynomial::{
    Indeterminates, Monomial, NoPolynomial, ParameterPolynomial,
};
use crate::{Expression, Graph, Model, Rational, Symbol};

/// M q̈ − f = Y π + r, as expressions of the model's graph.
#[derive(Clone, Debug)]
pub struct Regressor {
    /// The base parameters π, as functions of the parameters.
    pub base_parameters: Vec<Expression>,
    /// The columns of Y, one for each base parameter.
    pub columns: Vec<Vec<Expression>>,
    /// r, what the known parameters and the inputs contribute.
    pub known: Vec<Expression>,
    /// The unknown parameters that no equation of motion depends on.
    pub without_effect: Vec<Symbol>,
}

/// Which parameters are unknown.
#[derive(Clone, Copy, Debug)]
pub enum UnknownParameters<'a> {
    /// These, in the order in which they are preferred as base parameters.
    Named(&'a [Symbol]),
    /// All in which the equations of motion are polynomials.
    Every,
}

/// Why there is no regressor.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum NoRegressor {
    /// The energies or forces are no polynomials in these parameters, because of this term, or they are within this constraint.
    NotPolynomial(BTreeSet<Symbol>, Expression),
    /// No equation of motion depends on an unknown parameter.
    NothingUnknown,
    /// The energies or forces have too many monomials.
    TooManyMonomials,
    /// The columns depend on each other by functions of known parameters which are not found: those are within
    /// functions of the motion.
    UnknownRegrouping,
}

impl Regressor {
    /// The regressor of `model`.
    ///
    /// # Errors
    ///
    /// The reason why there is none.
    pub fn derive(model: &mut Model, unknown: UnknownParameters<'_>) -> Result<Self, NoRegressor> {
        let lagrangian = model.lagrangian();
        let mut roots = vec![lagrangian, model.dissipation];
        roots.extend(&model.forces);
        let constraints = model.constraints.iter();
        let constraints: Vec<_> = constraints
            .map(|constraint| constraint.expression())
            .collect();
        let (unknown, polynomials) =
            polynomials(&mut model.graph, (&roots, &constraints), unknown)?;
        let mut columns = columns(model, &polynomials);
        let known = columns.remove(&Monomial::new());
        let zero = model.graph.zero();
        let known = known.unwrap_or_else(|| vec![zero; model.coordinates as usize]);
        let graph = &mut model.graph;
        columns.retain(|_, column| !graph.vanishes(column));
        let columns = in_order(graph, columns, &unknown);
        let occurring: Vec<_> = columns
            .iter()
            .map(|(monomial, _)| monomial.clone())
            .collect();
        let BaseParameters { positions, values } = BaseParameters::of(graph, &columns)?;
        if positions.is_empty() {
            return Err(NoRegressor::NothingUnknown);
        }
        // As they are read: in the order in which the parameters are named, which is that of the links.
        let mut base: Vec<_> = positions.into_iter().zip(values).collect();
        base.sort_by_key(|(i, _)| named_powers(graph, &columns[*i].0, &unknown));
        let (positions, values): (Vec<_>, Vec<_>) = base.into_iter().unzip();
        let occurs = |symbol: &Symbol| {
            let mut powers = occurring.iter().flatten();
            powers.any(|(x, _)| graph.symbols(&[*x]).contains(symbol))
        };
        Ok(Self {
            without_effect: unknown.iter().copied().filter(|x| !occurs(x)).collect(),
            columns: positions.iter().map(|i| columns[*i].1.clone()).collect(),
            base_parameters: values,
            known,
        })
    }
}

/// The unknown parameters in order, and the polynomials of some roots in them. Parameters within constraints are known: the directions
/// along which reactions do no work depend on them.
fn polynomials(
    graph: &mut Graph,
    (roots, constraints): (&[Expression], &[Expression]),
    unknown: UnknownParameters<'_>,
) -> Result<(Vec<Symbol>, Vec<ParameterPolynomial>), NoRegressor> {
    let mut symbols: Vec<Symbol> = match unknown {
        UnknownParameters::Named(symbols) => symbols.to_vec(),
        UnknownParameters::Every => {
            let symbols = graph.symbols(roots).into_iter();
            symbols
                .filter(|symbol| matches!(symbol, Symbol::Parameter(_)))
                .collect()
        }
    };
    for constraint in constraints {
        let within = graph.symbols(&[*constraint]);
        let within: BTreeSet<_> = symbols
            .iter()
            .copied()
            .filter(|x| within.contains(x))
            .collect();
        match unknown {
            UnknownParameters::Named(_) if !within.is_empty() => {
                return Err(NoRegressor::NotPolynomial(within, *constraint));
            }
            _ => symbols.retain(|symbol| !within.contains(symbol)),
        }
    }
    loop {
        let set = symbols.iter().copied().collect();
        match graph.parameter_polynomials(roots, Indeterminates::Unknown(&set)) {
            Ok(polynomials) => return Ok((symbols, polynomials)),
            Err(NoPolynomial::TooLong) => return Err(NoRegressor::TooManyMonomials),
            Err(NoPolynomial::Within(within, term)) => match unknown {
                UnknownParameters::Named(_) => {
                    return Err(NoRegressor::NotPolynomial(within, term));
                }
                UnknownParameters::Every => symbols.retain(|symbol| !within.contains(symbol)),
            },
        }
    }
}

/// What Lagrange's equations d/dt ∂L/∂q̇ − ∂L/∂q + ∂D/∂q̇ − F make of the coefficients of each monomial.
fn columns(
    model: &mut Model,
    polynomials: &[ParameterPolynomial],
) -> BTreeMap<Monomial, Vec<Expression>> {
    let monomials: BTreeSet<_> = polynomials
        .iter()
        .flat_map(BTreeMap::keys)
        .cloned()
        .collect();
    let zero = model.graph.zero();
    let coefficients = |root: usize| -> Vec<Expression> {
        let of = |monomial| polynomials[root].get(monomial).copied().unwrap_or(zero);
        monomials.iter().map(of).collect()
    };
    let (lagrangians, dissipations) = (coefficients(0), coefficients(1));
    let forces: Vec<_> = (0..model.coordinates as usize)
        .map(|i| coefficients(2 + i))
        .collect();
    let (velocities, coordinates) = (model.velocity_symbols(), model.coordinate_symbols());
    let graph = &mut model.graph;
    let momenta = graph.jacobian(&lagrangians, &velocities);
    let slopes = graph.jacobian(&lagrangians, &coordinates);
    let drags = graph.jacobian(&dissipations, &velocities);
    let mut columns = BTreeMap::new();
    for (m, monomial) in monomials.into_iter().enumerate() {
        let of_monomial: Vec<_> = momenta.iter().map(|momenta| momenta[m]).collect();
        let rates = graph.time_derivatives(&of_monomial, model.coordinates);
        let mut column = Vec::with_capacity(rates.len());
        for (i, rate) in rates.into_iter().enumerate() {
            let terms = [
                (rate, Rational::ONE),
                (slopes[i][m], Rational::MINUS_ONE),
                (drags[i][m], Rational::ONE),
                (forces[i][m], Rational::MINUS_ONE),
            ];
            let sum = graph.sum(terms);
            column.push(graph.simplest(sum));
        }
        columns.insert(monomial, column);
    }
    columns
}

/// Columns with their monomials, those of low degree first, then in the order of the unknown parameters.
fn in_order(
    graph: &Graph,
    columns: BTreeMap<Monomial, Vec<Expression>>,
    unknown: &[Symbol],
) -> Vec<(Monomial, Vec<Expression>)> {
    let key = |monomial: &Monomial| {
        let degree: u64 = monomial.iter().map(|(_, k)| k.unsigned_abs()).sum();
        (degree, named_powers(graph, monomial, unknown))
    };
    let mut columns: Vec<_> = columns.into_iter().collect();
    columns.sort_by_key(|(monomial, _)| key(monomial));
    columns
}

/// The parameters of a monomial by their positions among the unknown ones, with their powers, high ones first.
fn named_powers(
    graph: &Graph,
    monomial: &Monomial,
    unknown: &[Symbol],
) -> Vec<(Option<usize>, i64)> {
    let position = |x: Expression| {
        let symbols = graph.symbols(&[x]);
        unknown.iter().position(|symbol| symbols.contains(symbol))
    };
    let powers = monomial.iter().map(|(x, k)| (position(*x), -k));
    let mut powers: Vec<_> = powers.collect();
    powers.sort_unstable();
    powers
}
