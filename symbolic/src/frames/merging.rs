//! Products of rotations with fewer factors.

use crate::frames::factor::MatrixFactor;
use crate::{Geometry, Graph};

impl Geometry {
    /// The factors of a product, [combined](Self::combined); where vectors are resolved last, rotations about one axis that both
    /// vary stay two, since they are two joints.
    pub(crate) fn merged(
        &mut self,
        factors: impl IntoIterator<Item = MatrixFactor>,
    ) -> Vec<MatrixFactor> {
        let keeps_joints = self.unresolved.is_some();
        self.combined_where(factors, |graph, both| {
            !keeps_joints || both.is_constant(graph)
        })
    }

    /// Combines the factors of a product: adjacent rotations about one axis become one, rotations next to their transposes cancel,
    /// and identities are left out.
    pub(crate) fn combined(
        &mut self,
        factors: impl IntoIterator<Item = MatrixFactor>,
    ) -> Vec<MatrixFactor> {
        self.combined_where(factors, |_, _| true)
    }

    /// [Combines](Self::combined) two factors if `is_one` holds for their product.
    fn combined_where(
        &mut self,
        factors: impl IntoIterator<Item = MatrixFactor>,
        is_one: impl Fn(&Graph, MatrixFactor) -> bool,
    ) -> Vec<MatrixFactor> {
        let mut merged: Vec<MatrixFactor> = Vec::new();
        for mut factor in factors {
            // Where vectors are resolved last, a turn back is one by the opposite angle: each frame has one path.
            if self.unresolved.is_some()
                && let MatrixFactor::Elementary(rotation) = &mut factor
                && core::mem::take(&mut rotation.reversed)
            {
                rotation.angle = self.graph.negate(rotation.angle);
            }
            if let Some(last) = merged.last()
                && let Some(both) = last.then(factor, &mut self.graph)
                && is_one(&self.graph, both)
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
