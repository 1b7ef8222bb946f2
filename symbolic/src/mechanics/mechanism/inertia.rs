//! What a link carries: mass, first moment and second moments about its origin.

use crate::frames::axis::Axis;
use crate::mechanics::mechanism::{Vector, kept};
use crate::{Expression, Graph, Rational};

/// Mass, first moment Σ m r and second moments Σ m r rᵀ. The inertia tensor is tr(S) 1 − S.
#[derive(Clone, Debug)]
pub(crate) struct Inertia {
    pub(crate) mass: Expression,
    pub(crate) first: Vector,
    pub(crate) second: [Vector; 3],
}

impl Inertia {
    /// Nothing.
    pub(crate) const fn none(graph: &Graph) -> Self {
        let zero = graph.zero();
        Self {
            mass: zero,
            first: [zero; 3],
            second: [[zero; 3]; 3],
        }
    }

    /// A mass at a point.
    pub(crate) fn point(graph: &mut Graph, mass: Expression, place: Vector) -> Self {
        let point = Self {
            mass,
            ..Self::none(graph)
        };
        point.moved(graph, place)
    }

    /// A body that has this inertia tensor about the origin, and no mass.
    pub(crate) fn of_tensor(graph: &mut Graph, tensor: &[Vector; 3]) -> Self {
        let mut inertia = Self::none(graph);
        for i in 0..3 {
            for j in 0..3 {
                inertia.second[i][j] = if i == j {
                    let (k, l) = ((i + 1) % 3, (i + 2) % 3);
                    graph.sum([
                        (tensor[k][k], Rational::HALF),
                        (tensor[l][l], Rational::HALF),
                        (tensor[i][i], -&Rational::HALF),
                    ])
                } else {
                    graph.negate(tensor[i][j])
                };
            }
        }
        inertia
    }

    /// The inertia tensor about the origin.
    pub(crate) fn tensor(&self, graph: &mut Graph) -> [Vector; 3] {
        let second = self.second;
        [0, 1, 2].map(|i: usize| {
            [0, 1, 2].map(|j: usize| {
                if i == j {
                    let (k, l) = ((i + 1) % 3, (i + 2) % 3);
                    let sum = graph.add(second[k][k], second[l][l]);
                    kept(graph, sum)
                } else {
                    graph.negate(second[i][j])
                }
            })
        })
    }

    /// Adds another one about the same origin.
    pub(crate) fn add(&mut self, graph: &mut Graph, other: &Self) {
        self.mass = graph.add(self.mass, other.mass);
        for i in 0..3 {
            self.first[i] = graph.add(self.first[i], other.first[i]);
            for j in 0..3 {
                self.second[i][j] = graph.add(self.second[i][j], other.second[i][j]);
            }
        }
    }

    /// The same about an origin from which this one is at `place`.
    pub(crate) fn moved(&self, graph: &mut Graph, place: Vector) -> Self {
        let mut moved = self.clone();
        for i in 0..3 {
            let own = graph.multiply(self.mass, place[i]);
            moved.first[i] = graph.add(self.first[i], own);
            for j in 0..3 {
                let terms = [
                    graph.multiply(own, place[j]),
                    graph.multiply(self.first[i], place[j]),
                    graph.multiply(place[i], self.first[j]),
                    self.second[i][j],
                ];
                moved.second[i][j] = graph.sum(terms.map(|x| (x, Rational::ONE)));
            }
        }
        moved
    }

    /// Whether there is nothing.
    pub(crate) fn vanishes(&self, graph: &Graph) -> bool {
        let second = self.second.iter().flatten();
        let mut all = self.first.iter().chain(second).chain([&self.mass]);
        all.all(|x| graph.is_zero(*x))
    }

    /// Whether this is the same after any turn about an axis.
    pub(crate) fn is_symmetric_about(&self, graph: &Graph, axis: Axis) -> bool {
        let [k, a, b] = axis.cycle();
        let across = [self.first[a], self.first[b]];
        let products = [(a, b), (a, k), (b, k)].map(|(i, j)| self.second[i][j]);
        let mut vanishing = across.iter().chain(&products);
        self.second[a][a] == self.second[b][b] && vanishing.all(|x| graph.is_zero(*x))
    }

    /// Takes out what lies on an axis: the mass, the first moment and the second moment along it.
    pub(crate) fn take_axis(&mut self, graph: &Graph, axis: usize) -> Self {
        let zero = graph.zero();
        let mut taken = Self::none(graph);
        taken.mass = core::mem::replace(&mut self.mass, zero);
        taken.first[axis] = core::mem::replace(&mut self.first[axis], zero);
        taken.second[axis][axis] = core::mem::replace(&mut self.second[axis][axis], zero);
        taken
    }

    /// Makes each number an intermediate result, which is computed once.
    pub(crate) fn keep(&mut self, graph: &mut Graph) {
        let second = self.second.iter_mut().flatten();
        let all = self.first.iter_mut().chain(second).chain([&mut self.mass]);
        for value in all {
            *value = kept(graph, *value);
        }
    }
}
