//! Tensors along the axes of the link before: a turn about a coordinate axis takes four products for each block of two
//! rows, by the double angle.

use crate::mechanics::mechanism::{Inertia, Turn, Vector, difference, inner, kept, total};
use crate::{Expression, Graph, Rational};

impl Turn {
    /// R B Rᵀ.
    pub(crate) fn outward_block(
        &self,
        graph: &mut Graph,
        block: [Vector; 3],
        is_symmetric: bool,
    ) -> [Vector; 3] {
        match self {
            Self::Identity | Self::Spin(_) => block,
            Self::Elementary(rotation) => {
                let [cosine, sine] = Self::cosine_and_sine(graph, *rotation);
                let [k, a, b] = rotation.axis.cycle();
                let mut turned = block;
                for (i, j) in [(a, b), (b, a)] {
                    let [x, y] = [block[i][k], block[j][k]];
                    let sign = if i == a {
                        Rational::MINUS_ONE
                    } else {
                        Rational::ONE
                    };
                    let across = graph.scale(sine, &sign);
                    turned[i][k] = inner(graph, [(cosine, x), (across, y)]);
                    turned[k][i] = inner(graph, [(cosine, block[k][i]), (across, block[k][j])]);
                }
                let plane = [[block[a][a], block[a][b]], [block[b][a], block[b][b]]];
                let plane = if is_symmetric {
                    symmetric_plane(graph, cosine, sine, plane)
                } else {
                    plane_turned(graph, cosine, sine, plane)
                };
                [turned[a][a], turned[a][b]] = plane[0];
                [turned[b][a], turned[b][b]] = plane[1];
                turned
            }
            Self::General(_) => {
                let columns = [0, 1, 2].map(|j| [block[0][j], block[1][j], block[2][j]]);
                let columns = columns.map(|column| self.outward(graph, column));
                let rows = [0, 1, 2].map(|i| [columns[0][i], columns[1][i], columns[2][i]]);
                rows.map(|row| self.outward(graph, row))
            }
        }
    }
}

type Plane = [[Expression; 2]; 2];

/// cos² and sin cos, each computed once.
fn products(graph: &mut Graph, cosine: Expression, sine: Expression) -> [Expression; 2] {
    [cosine, sine].map(|x| inner(graph, [(cosine, x)]))
}

/// R B Rᵀ of a symmetric block of two rows.
fn symmetric_plane(
    graph: &mut Graph,
    cosine: Expression,
    sine: Expression,
    [[x, y], [_, z]]: Plane,
) -> Plane {
    let [square, product] = products(graph, cosine, sine);
    let twice = graph.scale(product, &Rational::integer(2));
    let double_sine = kept(graph, twice);
    let twice = graph.scale(square, &Rational::integer(2));
    let double_cosine = graph.add_constant(twice, &Rational::MINUS_ONE);
    let double_cosine = kept(graph, double_cosine);
    let stretch = difference(graph, x, z);
    let minus = graph.negate(double_sine);
    let change = inner(graph, [(square, stretch), (minus, y)]);
    let across = inner(graph, [(product, stretch), (double_cosine, y)]);
    let minus = graph.negate(change);
    [
        [total(graph, &[z, change]), across],
        [across, total(graph, &[x, minus])],
    ]
}

/// R B Rᵀ of a block of two rows.
fn plane_turned(
    graph: &mut Graph,
    cosine: Expression,
    sine: Expression,
    [[e, f], [g, h]]: Plane,
) -> Plane {
    let [square, product] = products(graph, cosine, sine);
    let stretch = difference(graph, e, h);
    let sum = total(graph, &[f, g]);
    let minus = graph.negate(product);
    let change = inner(graph, [(square, stretch), (minus, sum)]);
    let across = inner(graph, [(product, stretch), (square, sum)]);
    let [minus, minus_f, minus_g] = [change, f, g].map(|x| graph.negate(x));
    [
        [total(graph, &[h, change]), total(graph, &[across, minus_g])],
        [total(graph, &[across, minus_f]), total(graph, &[e, minus])],
    ]
}

impl Inertia {
    /// The same along the axes of the link before.
    pub(crate) fn turned(&self, graph: &mut Graph, turn: &Turn) -> Self {
        Self {
            mass: self.mass,
            first: turn.outward(graph, self.first),
            second: turn.outward_block(graph, self.second, true),
        }
    }
}
