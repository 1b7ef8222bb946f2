//! Vectors, matrices and rotations, with their frames, above the expressions of their components.

use crate::frames::vector_in_frames::{KnownFrames, UnresolvedVectors};
use crate::{Expression, Graph};

/// An arena of expressions, and what is known of vectors and matrices of them besides their components: the frames in
/// which they are constant, the rotations of which they are products.
///
/// A declaration is translated in one. The derivation of its equations needs only the [graph](Self::graph).
#[derive(Clone, Debug, Default)]
pub struct Geometry {
    /// The arena of the components.
    pub graph: Graph,
    /// The frames, and what is known of vectors and matrices besides their elements.
    pub(crate) frames: KnownFrames,
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
        self.frames.unresolved = Some(UnresolvedVectors::new(coordinates));
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
            frames: KnownFrames::default(),
        }
    }
}
