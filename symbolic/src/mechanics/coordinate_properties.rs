//! Properties of the coordinates: which are angles, which are ignorable (cyclic), and on which the determinant of the
//! mass matrix depends.
//!
//! All decisions are exact, by polynomial identity testing.

use crate::identity::identity_testing::IdentityTest;
use crate::identity::modular_matrix;
use crate::identity::modular_point::ModularPoint;
use crate::mechanics::defects::Defect;
use crate::{Expression, Graph, Model, Node, Symbol, Unary};

/// Properties of the coordinates that the runtime uses.
#[derive(Clone, Debug)]
pub struct CoordinateProperties {
    /// Which coordinates are angles: they occur, and only in sums under sine, cosine and tangent.
    pub angles: Vec<bool>,
    /// Which coordinates are ignorable: they occur neither in the Lagrangian nor in a force.
    pub ignorable: Vec<bool>,
    /// For each coordinate, the coordinates on which the determinant of its block of M depends.
    pub singularities: Vec<Vec<u32>>,
}

pub(crate) fn analyze(
    model: &Model,
    lagrangian: Expression,
    mass: &[Vec<Expression>],
    generalized_forces: &[Expression],
) -> Result<CoordinateProperties, Defect> {
    let graph = &model.graph;
    let mut singularities = vec![Vec::new(); mass.len()];
    let mut singular = Vec::new();
    let coordinates = model.coordinate_symbols();
    for block in blocks(graph, mass) {
        let entries: Vec<Expression> = block
            .iter()
            .flat_map(|i| block.iter().map(|j| mass[*i][*j]))
            .collect();
        let determinant = |values: &[u64], point: ModularPoint| {
            let rows = values.chunks(block.len()).map(<[u64]>::to_vec);
            modular_matrix::determinant(rows.collect(), point.p())
        };
        let test = IdentityTest::of(graph, &mass.concat());
        let vanishes =
            |point: ModularPoint| Some(determinant(&point.evaluate(graph, &entries)?, point)? == 0);
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
    if !singular.is_empty() {
        return Err(Defect::SingularMass(singular));
    }
    let mut roots = vec![lagrangian];
    roots.extend(generalized_forces);
    let occurring = graph.symbols(&roots);
    let ignorable: Vec<bool> = coordinates
        .iter()
        .map(|coordinate| !occurring.contains(coordinate))
        .collect();
    let mut angles = angles(graph, &roots, model.coordinates);
    for (is_angle, is_ignorable) in angles.iter_mut().zip(&ignorable) {
        *is_angle &= !is_ignorable;
    }
    Ok(CoordinateProperties {
        angles,
        ignorable,
        singularities,
    })
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

/// Which coordinates occur only in sums under sine, cosine and tangent, or not at all.
fn angles(graph: &Graph, roots: &[Expression], coordinates: u32) -> Vec<bool> {
    let descendants = graph.descendants(roots);
    let length = descendants.last().map_or(0, |last| last.index() + 1);
    // Whether the value of an expression matters by itself and not only modulo a full turn.
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
