//! Base parameters: the smallest set of combinations of parameters that determines the equations of motion (Gautier and
//! Khalil, Direct calculation of minimum set of inertial parameters of serial robots, 1990; Khalil and Dombre, Modeling,
//! Identification and Control of Robots, 2002, chapter 9).
//!
//! Columns are dependent if Σ cⱼ Yⱼ(q, q̇, q̈, t) = 0 for all motions, with coefficients that are functions of known
//! parameters. Each column is written as Σ κₖ yₖ with functions κ that are free of the motion, and functions y that are
//! free of parameters. Of these, those that are independent over the rationals are found in modular arithmetic at random
//! motions, and with them the coordinates of each column, which are elements of the field of the known parameters.
//! There, the columns are eliminated (`regrouping.rs`), those with factors κ of the lowest degree first: m₂, which moves with
//! l₁² and l₁, is regrouped with the inertia and the moment of mass of the link before it, as in the text, and nothing is
//! divided by a length. All relations are then proved by the identity test, and the rank is compared with that of the columns at
//! random values of the known parameters.

use std::collections::BTreeMap;

use crate::identity::rational_reconstruction::rational;
use crate::identity::row_echelon::RowEchelon;
use crate::limits::{MAX_MOTION_FUNCTIONS, MODULAR_ATTEMPTS, MOTIONS_WITHOUT_GAIN};
use crate::mechanics::regressor::NoRegressor;
use crate::mechanics::regressor::parameter_polynomial::{Indeterminates, Monomial};
use crate::mechanics::regressor::regrouping::regroup;
use crate::{Expression, Graph, ModularPoint, Rational};

/// Which columns belong to base parameters, and what these are.
pub(crate) struct BaseParameters {
    pub(crate) positions: Vec<usize>,
    pub(crate) values: Vec<Expression>,
}

/// The rows of a reduced row echelon form, each with the column of its pivot.
type Rows = Vec<(usize, Vec<u64>)>;

/// Functions of the motion, one for each coordinate.
type Column = Vec<Expression>;

impl BaseParameters {
    /// Those of columns in the order of the degrees of their factors, and then in their own: as many of the first ones as are
    /// independent.
    pub(crate) fn of(
        graph: &mut Graph,
        columns: &[(Monomial, Column)],
    ) -> Result<Self, NoRegressor> {
        let mut parts = Parts::of(graph, columns)?;
        let order = parts.by_degree(columns.len());
        let columns: Vec<_> = order.iter().map(|j| columns[*j].clone()).collect();
        parts.renumber(&order);
        let functions: Vec<Column> = parts.functions.iter().map(|(y, _)| y.clone()).collect();
        let coordinates = coordinates(graph, &functions).ok_or(NoRegressor::UnknownRegrouping)?;
        let matrix = parts.matrix(graph, &coordinates, columns.len());
        let regrouped = regroup(graph, &matrix).ok_or(NoRegressor::UnknownRegrouping)?;
        let all: Vec<Column> = columns.iter().map(|(_, column)| column.clone()).collect();
        if reduced(graph, &all, ModularPoint::new(0)).map(|(rows, _)| rows.len())
            != Some(regrouped.len())
        {
            return Err(NoRegressor::UnknownRegrouping);
        }
        let monomials: Vec<_> = columns.iter().map(|(x, _)| graph.monomial(x)).collect();
        let (mut positions, mut values) = (Vec::new(), Vec::new());
        for (pivot, row) in &regrouped {
            let mut terms = Vec::new();
            for (j, factor) in row.iter().enumerate().skip(*pivot) {
                terms.push((graph.multiply(*factor, monomials[j]), Rational::ONE));
            }
            let sum = graph.sum(terms);
            positions.push(order[*pivot]);
            values.push(graph.simplest(sum));
        }
        let relations = relations(graph, &all, &regrouped);
        if !graph.vanishes(&relations) {
            return Err(NoRegressor::UnknownRegrouping);
        }
        Ok(Self { positions, values })
    }
}

/// Yⱼ − Σ Rᵦⱼ Yᵦ, which vanish, for all columns that are no base columns.
fn relations(
    graph: &mut Graph,
    columns: &[Column],
    regrouped: &[(usize, Vec<Expression>)],
) -> Vec<Expression> {
    let mut relations = Vec::new();
    for (j, column) in columns.iter().enumerate() {
        if regrouped.iter().any(|(pivot, _)| *pivot == j) {
            continue;
        }
        for (i, entry) in column.iter().enumerate() {
            let mut terms = vec![(*entry, Rational::MINUS_ONE)];
            for (pivot, row) in regrouped {
                let term = graph.multiply(row[j], columns[*pivot][i]);
                terms.push((term, Rational::ONE));
            }
            relations.push(graph.sum(terms));
        }
    }
    relations
}

/// Columns as Σ κ·y, with factors κ that are free of the motion.
struct Parts {
    /// The functions y, each with the columns in which it occurs, and its factor there.
    functions: Vec<(Column, Vec<(usize, Monomial)>)>,
}

impl Parts {
    fn of(graph: &mut Graph, columns: &[(Monomial, Column)]) -> Result<Self, NoRegressor> {
        let entries: Vec<_> = columns
            .iter()
            .flat_map(|(_, column)| column.clone())
            .collect();
        let polynomials = graph
            .parameter_polynomials(&entries, Indeterminates::FreeOfMotion)
            .map_err(|_| NoRegressor::TooManyMonomials)?;
        let n = columns.first().map_or(1, |(_, column)| column.len().max(1));
        let mut functions: BTreeMap<Column, Vec<(usize, Monomial)>> = BTreeMap::new();
        let zero = graph.zero();
        for (j, polynomials) in polynomials.chunks(n).enumerate() {
            let mut parts: BTreeMap<&Monomial, Column> = BTreeMap::new();
            for (i, polynomial) in polynomials.iter().enumerate() {
                for (factor, coefficient) in polynomial {
                    parts.entry(factor).or_insert_with(|| vec![zero; n])[i] = *coefficient;
                }
            }
            for (factor, part) in parts {
                functions.entry(part).or_default().push((j, factor.clone()));
            }
        }
        if functions.len() > MAX_MOTION_FUNCTIONS {
            return Err(NoRegressor::TooManyMonomials);
        }
        Ok(Self {
            functions: functions.into_iter().collect(),
        })
    }

    /// The positions of the columns in the order of the highest degrees of their factors.
    fn by_degree(&self, columns: usize) -> Vec<usize> {
        let mut degrees = vec![0; columns];
        for (j, factor) in self
            .functions
            .iter()
            .flat_map(|(_, occurrences)| occurrences)
        {
            let degree: u64 = factor.iter().map(|(_, k)| k.unsigned_abs()).sum();
            degrees[*j] = degree.max(degrees[*j]);
        }
        let mut order: Vec<usize> = (0..columns).collect();
        order.sort_by_key(|j| degrees[*j]);
        order
    }

    /// Numbers the columns as they stand in an order.
    fn renumber(&mut self, order: &[usize]) {
        let mut ranks = vec![0; order.len()];
        for (rank, j) in order.iter().enumerate() {
            ranks[*j] = rank;
        }
        for (_, occurrences) in &mut self.functions {
            for (j, _) in occurrences {
                *j = ranks[*j];
            }
        }
    }

    /// The coordinates of the columns in terms of independent functions.
    fn matrix(
        &self,
        graph: &mut Graph,
        coordinates: &[Vec<Rational>],
        columns: usize,
    ) -> Vec<Vec<Expression>> {
        let mut matrix = Vec::with_capacity(coordinates.len());
        for coordinates in coordinates {
            let mut sums = vec![Vec::new(); columns];
            for ((_, occurrences), number) in self.functions.iter().zip(coordinates) {
                for (j, factor) in occurrences.iter().filter(|_| !number.is_zero()) {
                    sums[*j].push((graph.monomial(factor), number.clone()));
                }
            }
            matrix.push(sums.into_iter().map(|terms| graph.sum(terms)).collect());
        }
        matrix
    }
}

/// The coordinates of functions in terms of the first ones that are independent over the rationals: a row for each of
/// those. None where a coordinate is not found.
fn coordinates(graph: &mut Graph, functions: &[Column]) -> Option<Vec<Vec<Rational>>> {
    // Functions with branches are taken at a branch, or uninterpreted: what holds for one may not for the other.
    [ModularPoint::new(0), ModularPoint::new(0).uninterpreted()]
        .into_iter()
        .find_map(|point| {
            let (rows, p) = reduced(graph, functions, point)?;
            let mut coordinates = Vec::with_capacity(rows.len());
            let mut symbolic = Vec::with_capacity(rows.len());
            for (pivot, row) in rows {
                let row: Option<Vec<_>> = row.into_iter().map(|x| rational(x, p)).collect();
                let row = row?;
                symbolic.push((pivot, row.iter().map(|x| graph.constant(x)).collect()));
                coordinates.push(row);
            }
            let relations = relations(graph, functions, &symbolic);
            graph.vanishes(&relations).then_some(coordinates)
        })
}

/// The reduced row echelon form of the values of some columns at random motions, with its modulus. A motion at which
/// the rank does not grow shows that it is complete, up to an accident of probability 10⁻¹².
fn reduced(graph: &Graph, columns: &[Column], point: ModularPoint) -> Option<(Rows, u64)> {
    let entries = columns.concat();
    let n = columns.first().map_or(1, |column| column.len().max(1));
    let mut echelon = RowEchelon::new(point.p());
    let mut without_gain = 0;
    let mut outside = 0;
    for motion in 1.. {
        let Some(values) = point.in_motion(motion).evaluate(graph, &entries) else {
            outside += 1;
            if outside > MODULAR_ATTEMPTS {
                return None;
            }
            continue;
        };
        outside = 0;
        let rank = echelon.rank();
        for i in 0..n {
            echelon.add(values.iter().skip(i).step_by(n).copied().collect());
        }
        without_gain = if echelon.rank() == rank {
            without_gain + 1
        } else {
            0
        };
        if without_gain == MOTIONS_WITHOUT_GAIN || echelon.rank() == columns.len() {
            break;
        }
    }
    Some((echelon.reduced(), point.p()))
}
