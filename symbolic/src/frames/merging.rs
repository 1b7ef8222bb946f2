//! Products of rotations with fewer factors.

use crate::Geometry;
use crate::matrix::factor::MatrixFactor;

impl Geometry {
    /// The same product with fewer factors, as [combined](Self::combined); where vectors are resolved last, parallel
    /// joints stay two.
    pub(crate) fn merged(
        &mut self,
        factors: impl IntoIterator<Item = MatrixFactor>,
    ) -> Vec<MatrixFactor> {
        let keeps_joints = self.frames.unresolved.is_some();
        self.combined_where(factors, |graph, both| {
            !keeps_joints || both.is_constant(&graph.graph)
        })
    }

    /// The same product with fewer factors: adjacent rotations about one axis are combined, and rotations next to
    /// their transposes cancel, as identities do.
    pub(crate) fn combined(
        &mut self,
        factors: impl IntoIterator<Item = MatrixFactor>,
    ) -> Vec<MatrixFactor> {
        self.combined_where(factors, |_, _| true)
    }

    fn combined_where(
        &mut self,
        factors: impl IntoIterator<Item = MatrixFactor>,
        is_one: impl Fn(&Self, MatrixFactor) -> bool,
    ) -> Vec<MatrixFactor> {
        let mut merged: Vec<MatrixFactor> = Vec::new();
        for mut factor in factors {
            // Where vectors are resolved last, a turn back is one by the opposite angle: each frame has one path.
            if self.frames.unresolved.is_some()
                && let MatrixFactor::Elementary(rotation) = &mut factor
                && core::mem::take(&mut rotation.reversed)
            {
                rotation.angle = self.graph.negate(rotation.angle);
            }
            if let Some(last) = merged.last()
                && let Some(both) = last.then(factor, &mut self.graph)
                && is_one(self, both)
            {
                merged.pop();
                factor = both;
            }
            if !factor.is_identity(&self.graph) {
                merged.push(factor);
            }
        }
        merged
    }
}
