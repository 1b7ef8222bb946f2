//! Properties of the coordinates: which are angles, in which the motion is periodic, which are ignorable (cyclic), and
//! on which the determinant of the mass matrix depends.
//!
//! All decisions are exact, by polynomial identity testing.

use crate::identity::identity_testing::IdentityTest;
use crate::identity::modular_point::ModularPoint;
use crate::identity::tested_value::TestedValue;
use crate::limits::MAX_PERIOD;
use crate::matrix::components::components;
use crate::mechanics::defects::Defect;
use crate::{Expression, Graph, Model, Node, Rational, Symbol, Unary};

/// Properties of the coordinates that the runtime uses.
#[derive(Clone, Debug)]
pub struct CoordinateProperties {
    /// Which coordinates are angles: they occur, and only in sums under sine, cosine and tangent.
    pub angles: Vec<bool>,
    /// For each coordinate, a number of full turns after which the equations of motion are the same: the smallest by
    /// which all factors of an angle are integers; 1 if the coordinate is ignorable; 0 if none is known.
    pub periods: Vec<u32>,
    /// Which coordinates are ignorable: neither the Lagrangian nor a force depends on them, though they may be written
    /// there.
    pub ignorable: Vec<bool>,
    /// For each coordinate, the coordinates on which the determinant of its block of M depends.
    pub singularities: Vec<Vec<u32>>,
}

impl CoordinateProperties {
    /// Whether an ignorable coordinate is written in expressions, though their values do not depend on it.
    pub(crate) fn has_ignorable(&self, graph: &Graph, expressions: &[Expression]) -> bool {
        let is_ignorable = |symbol| match symbol {
            Symbol::Coordinate(i) => self.ignorable[i as usize],
            _ => false,
        };
        graph.contains(expressions, is_ignorable)
    }
}

/// Analyzes what the equations are made of, L and forces and constraints, and M or the matrix of the saddle point problem.
pub(crate) fn analyze(
    model: &Model,
    roots: &[Expression],
    mass: &[Vec<Expression>],
    ignorable: Vec<bool>,
) -> Result<CoordinateProperties, Defect> {
    let graph = &model.graph;
    let mut singularities = vec![Vec::new(); mass.len()];
    let mut singular = Vec::new();
    let coordinates = model.coordinate_symbols();
    // The diagonal blocks of M.
    for block in components(mass.len(), |i, j| !graph.is_zero(mass[i][j])) {
        let entries: Vec<Expression> = block
            .iter()
            .flat_map(|i| block.iter().map(|j| mass[*i][*j]))
            .collect();
        let determinant = TestedValue::Determinant;
        let test = IdentityTest::of(graph, &mass.concat());
        let vanishes = |point: ModularPoint| {
            let values = point.evaluate(graph, &entries)?;
            Some(determinant.of(&values, point.p())? == 0)
        };
        if test.holds(vanishes) {
            singular.extend(block.iter().filter_map(|i| u32::try_from(*i).ok()));
            continue;
        }
        let fixed = test.independent(graph, &entries, &coordinates, determinant);
        let depends: Vec<u32> = (0..).zip(fixed).filter(|x| !x.1).map(|x| x.0).collect();
        for i in block {
            singularities[i].clone_from(&depends);
        }
    }
    singular.retain(|i| *i < model.coordinates);
    singularities.truncate(coordinates.len());
    let is_still = |i: &u32| graph.vanishes(&mass[*i as usize]);
    let still: Vec<u32> = singular.iter().copied().filter(is_still).collect();
    if !still.is_empty() {
        return Err(Defect::NothingResists(still));
    }
    if !singular.is_empty() {
        return Err(Defect::SingularMass(singular));
    }
    let mut uses = uses(graph, roots, model.coordinates);
    for (x, is_ignorable) in uses.iter_mut().zip(&ignorable) {
        if *is_ignorable {
            *x = Use::NONE;
        }
    }
    let angles = uses.iter().zip(&ignorable);
    let angles = angles.map(|(x, is_ignorable)| !x.by_value && !is_ignorable);
    Ok(CoordinateProperties {
        angles: angles.collect(),
        periods: uses.iter().map(Use::period).collect(),
        ignorable,
        singularities,
    })
}

/// How the roots depend on the value of an expression.
#[derive(Clone)]
struct Use {
    /// Whether on the value itself, and not only modulo full turns.
    by_value: bool,
    /// The largest number of which all its factors under sine, cosine and tangent are integer multiples; 0 if it occurs
    /// under none.
    factor: Rational,
}

impl Use {
    const NONE: Self = Self {
        by_value: false,
        factor: Rational::ZERO,
    };

    /// Adds that it occurs with a factor under a sine.
    fn add_factor(&mut self, factor: &Rational) {
        self.factor = self.factor.common_divisor(factor);
    }

    /// The least number of full turns by which all factors are integers, or 0.
    fn period(&self) -> u32 {
        let turns = self.factor.to_fraction().map_or(0, |fraction| fraction.1);
        let turns = u32::try_from(turns).unwrap_or(0);
        if self.by_value || turns > MAX_PERIOD {
            0
        } else {
            turns
        }
    }
}

/// How the roots depend on the value of each coordinate.
fn uses(graph: &Graph, roots: &[Expression], coordinates: u32) -> Vec<Use> {
    let descendants = graph.descendants(roots);
    let length = descendants.last().map_or(0, |last| last.index() + 1);
    let mut uses = vec![Use::NONE; length];
    for root in roots {
        uses[root.index()].by_value = true;
    }
    let mut found = vec![Use::NONE; coordinates as usize];
    for expression in descendants.into_iter().rev() {
        let here = uses[expression.index()].clone();
        match graph.node(expression) {
            Node::Symbol(Symbol::Coordinate(i)) => found[*i as usize] = here,
            Node::Sum(terms) => {
                for (x, coefficient) in terms {
                    let term = &mut uses[x.index()];
                    term.by_value |= here.by_value;
                    if !here.factor.is_zero() {
                        term.add_factor(&(&here.factor * coefficient));
                    }
                }
            }
            Node::Unary(Unary::Sin | Unary::Cos | Unary::Tan, x) => {
                uses[x.index()].add_factor(&Rational::ONE);
            }
            node => node.for_each_operand(|operand| uses[operand.index()].by_value = true),
        }
    }
    found
}
