//! Rotations that were written out element by element.
//!
//! A rotation A that depends on one coordinate s turns about a fixed axis if vee(A′ Aᵀ) is constant: along a coordinate
//! axis k with the magnitude c it is R(c s) A₀ of the elementary rotation R about k and the constant A₀ at s = 0. If
//! vee(Aᵀ A′) is, it is A₀ R(c s). The matrices of Denavit and Hartenberg (A kinematic notation for lower-pair mechanisms
//! based on matrices, 1955) are of this kind.

use std::collections::BTreeMap;

use crate::frames::axis::Axis;
use crate::frames::factor::{ElementaryRotation, MatrixFactor};
use crate::{Expression, Graph, Node, Symbol, Unary};

impl Graph {
    /// The factors of a rotation that was written out: elementary rotations and constant ones, where it is a product of
    /// them.
    pub(crate) fn recognized_factors(&mut self, elements: [Expression; 9]) -> Vec<MatrixFactor> {
        if let Some(rotation) = self.elementary(&elements) {
            return vec![MatrixFactor::Elementary(rotation)];
        }
        let symbols = self.symbols(&elements).into_iter();
        let varying: Vec<Symbol> = symbols
            .filter(|symbol| !matches!(symbol, Symbol::Parameter(_)))
            .collect();
        let [symbol @ Symbol::Coordinate(_)] = *varying else {
            return vec![MatrixFactor::Rotation(elements)];
        };
        let factors = self.turn_and_constant(elements, symbol);
        factors.unwrap_or_else(|| vec![MatrixFactor::Rotation(elements)])
    }

    /// The elementary rotation that has these elements, if its sine and cosine are written out.
    fn elementary(&mut self, elements: &[Expression; 9]) -> Option<ElementaryRotation> {
        for axis in Axis::ALL {
            let [_, j, _] = axis.cycle();
            let Node::Unary(Unary::Cos, angle) = *self.node(elements[4 * j]) else {
                continue;
            };
            for reversed in [false, true] {
                let rotation = ElementaryRotation {
                    axis,
                    angle,
                    reversed,
                };
                if MatrixFactor::Elementary(rotation).elements(self) == *elements {
                    return Some(rotation);
                }
            }
        }
        None
    }

    /// R A₀ or A₀ R.
    fn turn_and_constant(
        &mut self,
        elements: [Expression; 9],
        symbol: Symbol,
    ) -> Option<Vec<MatrixFactor>> {
        let variable = self.symbol(symbol);
        let origin = BTreeMap::from([(symbol, self.zero())]);
        let constant = self.substitute(&elements, &origin).try_into().ok()?;
        let constant = match self.elementary(&constant) {
            Some(rotation) => MatrixFactor::Elementary(rotation),
            None => MatrixFactor::Rotation(constant),
        };
        let matrix = MatrixFactor::Rotation(elements);
        for is_first in [true, false] {
            let factor = if is_first { matrix.transpose() } else { matrix };
            let turned = factor.elements(self);
            let rate = self.partial(&turned, symbol);
            let mut along = Axis::ALL.into_iter().filter(|axis| {
                let [k, i, j] = axis.cycle();
                let is_along = self.is_zero(rate[i]) && self.is_zero(rate[j]);
                is_along && !self.contents(rate[k]).varies()
            });
            let Some(axis) = along.next() else {
                continue;
            };
            let [k, ..] = axis.cycle();
            let angle = self.multiply(rate[k], variable);
            // The transpose turns the other way.
            let angle = if is_first { self.negate(angle) } else { angle };
            let rotation = MatrixFactor::Elementary(ElementaryRotation {
                axis,
                angle,
                reversed: false,
            });
            return Some(if is_first {
                vec![rotation, constant]
            } else {
                vec![constant, rotation]
            });
        }
        None
    }
}
