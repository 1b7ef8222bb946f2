//! What is known of a system before any number is: where its mass matrix can be singular, and which
//! of its coordinates are angles.
//!
//! All decisions are exact, taken at random points in modular arithmetic.

use crate::decision::point::Point;
use crate::decision::residue::{self, P};
use crate::mechanics::equations::Defect;
use crate::{Expression, Graph, Model, Node, Symbol, Unary};

/// Facts about a system that the runtime uses.
#[derive(Clone, Debug)]
pub struct Structure {
    /// Which coordinates are angles: they occur only in sums under sine, cosine and tangent, or not at
    /// all, so that their size means nothing.
    pub angles: Vec<bool>,
    /// For each coordinate, the coordinates on which the determinant of its block of M depends.
    pub singularities: Vec<Vec<u32>>,
}

/// Points to try until enough of them are in the domain: each square root halves their number.
const ATTEMPTS: u64 = 256;
/// Points at which an expression must vanish to be taken for zero.
const AGREEMENTS: usize = 3;

pub(crate) fn analyze(
    model: &Model,
    lagrangian: Expression,
    mass: &[Vec<Expression>],
    generalized_forces: &[Expression],
) -> Result<Structure, Defect> {
    let graph = &model.graph;
    let mut singularities = vec![Vec::new(); mass.len()];
    let mut singular = Vec::new();
    for block in blocks(graph, mass) {
        let determinant = |point: Point| block_determinant(graph, mass, &block, point);
        if usable(determinant).all(|(_, value)| value == 0) && usable(determinant).next().is_some()
        {
            singular.extend(block.iter().filter_map(|i| u32::try_from(*i).ok()));
            continue;
        }
        let depends: Vec<u32> = (0..model.coordinates)
            .filter(|i| moves(determinant, Symbol::Coordinate(*i)))
            .collect();
        for i in block {
            singularities[i].clone_from(&depends);
        }
    }
    if !singular.is_empty() {
        return Err(Defect::SingularMass(singular));
    }
    let mut roots = vec![lagrangian];
    roots.extend(generalized_forces);
    Ok(Structure {
        angles: angles(graph, &roots, model.coordinates),
        singularities,
    })
}

/// Whether `expression` vanishes identically, as far as random points tell.
pub(crate) fn vanishes(graph: &Graph, expression: Expression) -> bool {
    let value = |point: Point| Some(point.evaluate(graph, &[expression])?[0]);
    usable(value).next().is_some() && usable(value).all(|(_, value)| value == 0)
}

/// Whether one of `roots` depends on `symbol`, and not only in its spelling.
pub(crate) fn depends(graph: &Graph, roots: &[Expression], symbol: Symbol) -> bool {
    graph.contains(roots, |occurring| occurring == symbol)
        && roots
            .iter()
            .any(|root| moves(|point| Some(point.evaluate(graph, &[*root])?[0]), symbol))
}

/// The first few points in the domain of `value`, with the values there.
fn usable(value: impl Fn(Point) -> Option<u64>) -> impl Iterator<Item = (Point, u64)> {
    (0..ATTEMPTS)
        .map(Point::new)
        .filter_map(move |point| value(point).map(|value| (point, value)))
        .take(AGREEMENTS)
}

/// Whether `value` changes when one symbol does.
fn moves(value: impl Fn(Point) -> Option<u64> + Copy, symbol: Symbol) -> bool {
    (0..ATTEMPTS)
        .map(Point::new)
        .filter_map(|point| Some(value(point)? != value(point.moving(symbol))?))
        .take(AGREEMENTS)
        .any(|moved| moved)
}

/// The index sets of the diagonal blocks of M, each in ascending order.
fn blocks(graph: &Graph, mass: &[Vec<Expression>]) -> Vec<Vec<usize>> {
    let mut seen = vec![false; mass.len()];
    let mut blocks = Vec::new();
    for start in 0..mass.len() {
        if seen[start] {
            continue;
        }
        seen[start] = true;
        let mut block = vec![start];
        let mut next = 0;
        while let Some(row) = block.get(next).copied() {
            for (j, entry) in mass[row].iter().enumerate() {
                if !seen[j] && !graph.is_zero(*entry) {
                    seen[j] = true;
                    block.push(j);
                }
            }
            next += 1;
        }
        block.sort_unstable();
        blocks.push(block);
    }
    blocks
}

fn block_determinant(
    graph: &Graph,
    mass: &[Vec<Expression>],
    block: &[usize],
    point: Point,
) -> Option<u64> {
    let entries: Vec<Expression> = block
        .iter()
        .flat_map(|i| block.iter().map(|j| mass[*i][*j]))
        .collect();
    let values = point.evaluate(graph, &entries)?;
    determinant(values.chunks(block.len()).map(<[u64]>::to_vec).collect())
}

/// The determinant modulo p, by elimination with exchange of rows.
fn determinant(mut rows: Vec<Vec<u64>>) -> Option<u64> {
    let mut determinant = 1;
    for k in 0..rows.len() {
        let Some(pivot) = (k..rows.len()).find(|i| rows[*i][k] != 0) else {
            return Some(0);
        };
        if pivot != k {
            rows.swap(pivot, k);
            determinant = residue::negate(determinant, P);
        }
        determinant = residue::multiply(determinant, rows[k][k], P);
        let inverse = residue::reciprocal(rows[k][k], P)?;
        let (upper, lower) = rows.split_at_mut(k + 1);
        for row in lower {
            let factor = residue::negate(residue::multiply(row[k], inverse, P), P);
            for (entry, above) in row.iter_mut().zip(&upper[k]).skip(k) {
                *entry = residue::add(*entry, residue::multiply(factor, *above, P), P);
            }
        }
    }
    Some(determinant)
}

/// Which coordinates occur only in sums under sine, cosine and tangent, or not at all.
fn angles(graph: &Graph, roots: &[Expression], coordinates: u32) -> Vec<bool> {
    let descendants = graph.descendants(roots);
    let length = descendants.last().map_or(0, |last| last.index() + 1);
    // Whether the value of an expression matters by itself and not only modulo a whole turn.
    let mut matters = vec![false; length];
    for root in roots {
        matters[root.index()] = true;
    }
    let mut angles = vec![true; coordinates as usize];
    for expression in descendants.into_iter().rev() {
        let here = matters[expression.index()];
        match graph.node(expression) {
            Node::Symbol(Symbol::Coordinate(i)) => angles[*i as usize] = !here,
            Node::Sum(terms) => {
                for (x, _) in terms {
                    matters[x.index()] |= here;
                }
            }
            Node::Unary(Unary::Sin | Unary::Cos | Unary::Tan, _) => {}
            node => node.for_each_operand(|operand| matters[operand.index()] = true),
        }
    }
    angles
}
