//! Whether a triangle mesh is a closed surface that has one outside.

use alloc::vec::Vec;

use super::TriangleMesh;
use super::error::MeshError;
use crate::scalar::Scalar;

/// An edge of a triangle.
struct Edge {
    /// Its vertices, the lower index first.
    between: [usize; 2],
    /// Whether the triangle goes from the lower index to the higher one.
    ascends: bool,
}

impl<S: Scalar> TriangleMesh<S> {
    /// Fails unless as many triangles go along each edge in one direction as in the other.
    pub(super) fn check_closed(&self) -> Result<(), MeshError> {
        let mut edges = self.edges();
        edges.sort_unstable_by_key(|edge| edge.between);
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
        Ok(())
    }

    /// The edges of all triangles, without those that are points.
    fn edges(&self) -> Vec<Edge> {
        let of_triangle = |[a, b, c]: &[usize; 3]| [[*a, *b], [*b, *c], [*c, *a]];
        let edges = self.triangles.iter().flat_map(of_triangle);
        let edges = edges.filter(|[from, to]| from != to);
        edges
            .map(|[from, to]| Edge {
                between: [from.min(to), from.max(to)],
                ascends: from < to,
            })
            .collect()
    }
}
