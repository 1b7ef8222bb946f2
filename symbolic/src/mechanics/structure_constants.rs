//! Whether quasi-velocities close among themselves: d(δθᵏ) − δ(dθᵏ) = Σ γᵏₐᵦ wᵃ δθᵇ with constant γ.
//!
//! The angular velocities of a rigid body do, whatever angles they are written in, and their γ are those
//! of the rotation group: what the equations of motion then contain is ω × Iω, as in (3.5)–(3.7), and no
//! trigonometry. Decided at random points in modular arithmetic, where γ is either the same small
//! rational everywhere or not a constant.

use crate::decision::point::Point;
use crate::decision::residue;
use crate::{Expression, Graph, Rational, Symbol};

/// γᵏₐᵦ, as `constants[k][a][b]`.
pub(crate) type StructureConstants = Vec<Vec<Vec<Rational>>>;

/// Points that must agree.
const AGREEMENTS: usize = 3;
/// Points to try until as many are in the domain.
const ATTEMPTS: u64 = 64;
/// The largest numerator and denominator that are taken for those of a constant.
const LARGEST: u64 = 64;

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
    let mut agreed: Option<StructureConstants> = None;
    let points = (0..ATTEMPTS).map(Point::new);
    let values = points.filter_map(|point| Some((point, point.evaluate(graph, &roots)?)));
    for (point, values) in values.take(AGREEMENTS) {
        let found = Commutators {
            values: &values,
            size,
            p: point.p(),
        }
        .constants()?;
        if agreed.as_ref().is_some_and(|known| *known != found) {
            return None;
        }
        agreed = Some(found);
    }
    agreed
}

/// The values of E and of its derivatives by the coordinates modulo p.
struct Commutators<'a> {
    values: &'a [u64],
    size: usize,
    p: u64,
}

impl Commutators<'_> {
    fn entry(&self, k: usize, i: usize) -> u64 {
        self.values[k * self.size + i]
    }

    /// ∂Eₖᵢ/∂qⱼ − ∂Eₖⱼ/∂qᵢ.
    fn curl(&self, k: usize, i: usize, j: usize) -> u64 {
        let area = self.size * self.size;
        let slope = |i: usize, j: usize| self.values[(j + 1) * area + k * self.size + i];
        residue::add(slope(i, j), residue::negate(slope(j, i), self.p), self.p)
    }

    /// γᵏₐᵦ = Σᵢⱼ (∂Eₖᵢ/∂qⱼ − ∂Eₖⱼ/∂qᵢ) (E⁻¹)ⱼₐ (E⁻¹)ᵢᵦ, if all are small rationals.
    fn constants(&self) -> Option<StructureConstants> {
        let inverse = self.inverse()?;
        let indices = 0..self.size;
        let constant = |k: usize, a: usize, b: usize| {
            let mut total = 0;
            for i in indices.clone() {
                for j in indices.clone() {
                    let both = residue::multiply(inverse[j][a], inverse[i][b], self.p);
                    let term = residue::multiply(self.curl(k, i, j), both, self.p);
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

    /// E⁻¹ modulo p, by elimination with exchange of rows.
    fn inverse(&self) -> Option<Vec<Vec<u64>>> {
        let (n, p) = (self.size, self.p);
        let mut rows: Vec<Vec<u64>> = (0..n)
            .map(|k| {
                let unit = (0..n).map(|i| u64::from(i == k));
                (0..n).map(|i| self.entry(k, i)).chain(unit).collect()
            })
            .collect();
        for k in 0..n {
            let pivot = (k..n).find(|i| rows[*i][k] != 0)?;
            rows.swap(k, pivot);
            let scale = residue::reciprocal(rows[k][k], p)?;
            for entry in &mut rows[k] {
                *entry = residue::multiply(*entry, scale, p);
            }
            let pivot_row = rows[k].clone();
            for (i, row) in rows.iter_mut().enumerate() {
                let factor = residue::negate(row[k], p);
                if i != k {
                    for (entry, above) in row.iter_mut().zip(&pivot_row) {
                        *entry = residue::add(*entry, residue::multiply(factor, *above, p), p);
                    }
                }
            }
        }
        Some(rows.into_iter().map(|row| row[n..].to_vec()).collect())
    }
}

/// The rational with a small numerator and denominator that `value` is modulo p.
fn small_rational(value: u64, p: u64) -> Option<Rational> {
    (1..=LARGEST).find_map(|denominator| {
        let numerator = residue::multiply(value, denominator, p);
        let opposite = residue::negate(numerator, p);
        let signed = if numerator <= LARGEST {
            i64::try_from(numerator).ok()?
        } else if opposite <= LARGEST {
            -i64::try_from(opposite).ok()?
        } else {
            return None;
        };
        let inverse = Rational::integer(i64::try_from(denominator).ok()?).reciprocal()?;
        Some(&Rational::integer(signed) * &inverse)
    })
}
