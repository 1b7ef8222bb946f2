//! Vectors, matrices and rotations, with their frames, above the expressions of their components.

use crate::frames::frame_tree::FrameTree;
use crate::frames::vector_in_frames::UnresolvedVectors;
use crate::{Expression, Graph};

/// An arena of expressions, and the frames in which [vectors and matrices](crate::Matrix) of them are known.
///
/// A declaration is translated in one. The derivation of its equations needs only the [graph](Self::graph).
#[derive(Clone, Debug, Default)]
pub struct Geometry {
    /// The arena of the components.
    pub graph: Graph,
    pub(crate) frames: FrameTree,
    /// The vectors that are resolved last, where they are.
    pub(crate) unresolved: Option<UnresolvedVectors>,
}

impl Geometry {
    /// An arena that holds 0 and 1.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// An arena in which vectors in frames are resolved last, for a system with so many coordinates.
    #[must_use]
    pub fn with_unresolved_vectors(mut self, coordinates: u32) -> Self {
        self.unresolved = Some(UnresolvedVectors::new(coordinates));
        self
    }

    /// The [total time derivatives](Graph::time_derivatives) of expressions, which may contain components of vectors that are
    /// resolved last.
    pub fn time_derivatives(&mut self, roots: &[Expression], coordinates: u32) -> Vec<Expression> {
        let roots = self.resolved(roots);
        self.graph.time_derivatives(&roots, coordinates)
    }
}

impl From<Graph> for Geometry {
    fn from(graph: Graph) -> Self {
        Self {
            graph,
            ..Self::default()
        }
    }
}
