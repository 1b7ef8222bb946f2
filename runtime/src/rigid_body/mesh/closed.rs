//! The test that a triangle mesh is a closed surface.

use alloc::vec::Vec;

use super::TriangleMesh;
use super::error::MeshError;
use crate::scalar::Scalar;

/// An edge of a triangle.
pub(super) struct Edge {
    /// Its vertices, the lower index first.
    pub(super) between: [usize; 2],
    /// Whether the triangle traverses the edge from the lower index to the higher one.
    pub(super) ascends: bool,
    /// The index of the triangle.
    pub(super) triangle: usize,
}

impl<S: Scalar> TriangleMesh<S> {
    /// Returns the edges of all triangles, grouped by their vertices. Fails unless each edge is traversed equally often
    /// in both directions.
    pub(super) fn closed_edges(&self) -> Result<Vec<Edge>, MeshError> {
        let mut edges = self.edges();
        edges.sort_unstable_by_key(|edge| (edge.between, edge.triangle));
        for group in edges.chunk_by(|a, b| a.between == b.between) {
            let ascending = group.iter().filter(|edge| edge.ascends).count();
            if 2 * ascending == group.len() {
                continue;
            }
            let Some(edge) = group.first() else { continue };
            let [from, to] = edge.between;
            return Err(if group.len() % 2 == 0 {
                MeshError::InconsistentOrientation { from, to }
            } else {
                MeshError::Open { from, to }
            });
        }
        Ok(edges)
    }

    /// Returns the edges of all triangles, without degenerate edges.
    fn edges(&self) -> Vec<Edge> {
        let of_triangle = |(triangle, [a, b, c]): (usize, &[usize; 3])| {
            [[*a, *b], [*b, *c], [*c, *a]].map(|[from, to]| Edge {
                between: [from.min(to), from.max(to)],
                ascends: from < to,
                triangle,
            })
        };
        let edges = self.triangles.iter().enumerate().flat_map(of_triangle);
        edges
            .filter(|edge| edge.between[0] != edge.between[1])
            .collect()
    }
}
