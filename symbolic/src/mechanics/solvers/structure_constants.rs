//! The structure constants (Hamel coefficients) of quasi-velocities: d(δθᵏ) − δ(dθᵏ) = Σ γᵏₐᵦ wᵃ δθᵇ with constant γ
//! (Hamel, Die Lagrange-Eulerschen Gleichungen der Mechanik, 1904).
//!
//! The angular velocities of a rigid body have them, in whatever angles they are written, and their γ are those of
//! the rotation group: the equations of motion then contain ω × Iω, as in (3.5)–(3.7), and no trigonometry. Decided
//! at random points in modular arithmetic, where γ is either the same small rational everywhere, recovered by
//! rational reconstruction (Wang, Guy and Davenport, p-adic reconstruction of rational numbers, 1982), or not a
//! constant.

use crate::identity::identity_testing::IdentityTest;
use crate::identity::{modular_matrix, residue};
use crate::limits::MAX_STRUCTURE_CONSTANT;
use crate::{Expression, Graph, Rational, Symbol};

/// γᵏₐᵦ, as `constants[k][a][b]`.
pub(crate) type StructureConstants = Vec<Vec<Vec<Rational>>>;

/// γ of w = E q̇, if it is constant; `kinematics` is the square matrix E.
pub(crate) fn structure_constants(
    graph: &mut Graph,
    kinematics: &[Vec<Expression>],
) -> Option<StructureConstants> {
    let size = kinematics.len();
    let entries = kinematics.concat();
    let mut roots = entries.clone();
    let coordinates: Vec<_> = (0..).map(Symbol::Coordinate).take(size).collect();
    roots.extend(graph.jacobian(&entries, &coordinates).concat());
    IdentityTest::of(graph, &roots).constant(|point| {
        let values = point.evaluate(graph, &roots)?;
        let commutators = Commutators {
            values: &values,
            size,
            p: point.p(),
        };
        Some(commutators.constants())
    })
}

/// The values of E and of its derivatives by the coordinates modulo p.
struct Commutators<'a> {
    values: &'a [u64],
    size: usize,
    p: u64,
}

impl Commutators<'_> {
    /// ∂Eₖᵢ/∂qⱼ − ∂Eₖⱼ/∂qᵢ.
    fn exterior_derivative(&self, k: usize, i: usize, j: usize) -> u64 {
        let area = self.size * self.size;
        let slope = |i: usize, j: usize| self.values[(j + 1) * area + k * self.size + i];
        residue::add(slope(i, j), residue::negate(slope(j, i), self.p), self.p)
    }

    /// γᵏₐᵦ = Σᵢⱼ (∂Eₖᵢ/∂qⱼ − ∂Eₖⱼ/∂qᵢ) (E⁻¹)ⱼₐ (E⁻¹)ᵢᵦ, if all are small rationals.
    fn constants(&self) -> Option<StructureConstants> {
        let matrix = self.values[..self.size * self.size].chunks(self.size);
        let inverse = modular_matrix::inverse(matrix.map(<[u64]>::to_vec).collect(), self.p)?;
        let indices = 0..self.size;
        let constant = |k: usize, a: usize, b: usize| {
            let mut total = 0;
            for i in indices.clone() {
                for j in indices.clone() {
                    let both = residue::multiply(inverse[j][a], inverse[i][b], self.p);
                    let term = residue::multiply(self.exterior_derivative(k, i, j), both, self.p);
                    total = residue::add(total, term, self.p);
                }
            }
            small_rational(total, self.p)
        };
        indices
            .clone()
            .map(|k| {
                indices
                    .clone()
                    .map(|a| indices.clone().map(|b| constant(k, a, b)).collect())
                    .collect()
            })
            .collect()
    }
}

/// The rational with a small numerator and denominator whose residue modulo p is `value`.
fn small_rational(value: u64, p: u64) -> Option<Rational> {
    (1..=MAX_STRUCTURE_CONSTANT).find_map(|denominator| {
        let numerator = residue::multiply(value, denominator, p);
        let opposite = residue::negate(numerator, p);
        let signed = if numerator <= MAX_STRUCTURE_CONSTANT {
            i64::try_from(numerator).ok()?
        } else if opposite <= MAX_STRUCTURE_CONSTANT {
            -i64::try_from(opposite).ok()?
        } else {
            return None;
        };
        let inverse = Rational::integer(i64::try_from(denominator).ok()?).reciprocal()?;
        Some(&Rational::integer(signed) * &inverse)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::systems::{Rates, cardan_rates, euler_rates, node_rates};
    use crate::testing::{Draft, Quantity};

    /// γ of three forms in three velocities.
    fn constants(rates: fn(&Draft) -> Rates<'_>) -> Option<StructureConstants> {
        let draft = Draft::new(3);
        let forms = rates(&draft).map(Quantity::expression);
        let velocities = [0, 1, 2].map(Symbol::Velocity);
        let columns = draft.graph().jacobian(&forms, &velocities);
        let rows: Vec<Vec<_>> = (0..3)
            .map(|k| columns.iter().map(|column| column[k]).collect())
            .collect();
        structure_constants(&mut draft.graph(), &rows)
    }

    #[test]
    fn body_rates_have_those_of_the_rotation_group() {
        for rates in [euler_rates, cardan_rates] {
            let found = constants(rates).unwrap();
            for (k, a, b) in (0..27).map(|n| (n / 9, n / 3 % 3, n % 3)) {
                // ±1 by the order of k, a, b, and 0 where two of them are equal.
                let [x, y, z] = [k, a, b].map(|n| i64::try_from(n).unwrap());
                let expected = (x - y) * (y - z) * (z - x) / 2;
                // d(δθ₁) − δ(dθ₁) = w₃ δθ₂ − w₂ δθ₃ in a frame that turns with the body.
                assert_eq!(found[k][a][b], Rational::integer(-expected), "{k} {a} {b}");
            }
        }
    }

    #[test]
    fn rates_about_the_line_of_nodes_have_none() {
        assert_eq!(constants(node_rates), None);
    }

    #[test]
    fn those_of_velocities_are_zero() {
        let zero = vec![vec![vec![Rational::ZERO; 3]; 3]; 3];
        assert_eq!(constants(Draft::vs), Some(zero.clone()));
        // Of a point in cylindrical coordinates: ẋ, ẏ, ż.
        let of_a_point = constants(|draft| {
            let [r, phi, z] = draft.qs();
            [r * phi.cos(), r * phi.sin(), z].map(Quantity::dot)
        });
        assert_eq!(of_a_point, Some(zero));
    }

    #[test]
    fn a_multiple_of_a_form_scales_them() {
        // 2 w₁: γ¹ doubles, and what w₁ enters is halved.
        let doubled = constants(|draft| {
            let [w1, w2, w3] = euler_rates(draft);
            [2 * w1, w2, w3]
        });
        let found = doubled.unwrap();
        assert_eq!(found[0][1][2].abs(), Rational::integer(2));
        assert_eq!(found[1][0][2].abs(), Rational::HALF);
        assert_eq!(found[2][0][1].abs(), Rational::HALF);
    }
}
