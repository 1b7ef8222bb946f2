//! Quasi-velocities that are linear combinations of others, expressed by those.
//!
//! A body whose centre of mass is at c from what does not move has ½ m |ω × c|² + ½ ωᵀ I ω: six squares of
//! three quasi-velocities (the parallel-axis theorem). A constant linear combination of other forms is no
//! quasi-velocity of its own, but a part of their inertia.

use std::collections::BTreeMap;

use crate::mechanics::energy_forms::declared::{combination, opaque_mean};
use crate::mechanics::energy_forms::quasi_velocities::QuasiVelocities;
use crate::{Expression, Graph, Rational};

/// A sum of forms, each by its position, with constant coefficients.
type Combination = Vec<(Expression, usize)>;

impl QuasiVelocities {
    /// The same energy in the forms that are no combinations of others, if others are.
    pub(crate) fn combined(&self, graph: &mut Graph) -> Option<Self> {
        let combinations = self.combinations(graph);
        let independent: Vec<usize> = (0..self.forms.len())
            .filter(|k| combinations[*k].is_none())
            .collect();
        if independent.len() == self.forms.len() {
            return None;
        }
        let mut rows = Vec::with_capacity(combinations.len());
        for (k, combination) in combinations.into_iter().enumerate() {
            let combination = combination.unwrap_or_else(|| vec![(graph.one(), k)]);
            rows.push(coefficients(graph, &combination, &independent));
        }
        Some(Self {
            inertia: self.combined_inertia(graph, &rows, independent.len()),
            forms: independent.into_iter().map(|k| self.forms[k]).collect(),
            rest: self.rest,
        })
    }

    /// Cᵀ W C of the independent forms, where the rows of C are those of the forms. Most entries of W and
    /// of C are 0, and only the others are looked at.
    fn combined_inertia(
        &self,
        graph: &mut Graph,
        rows: &[Vec<(usize, Expression)>],
        independent: usize,
    ) -> Vec<Vec<Expression>> {
        let mut terms = vec![vec![Vec::new(); independent]; independent];
        for (first, row) in rows.iter().zip(&self.inertia) {
            for (second, inertia) in rows.iter().zip(row) {
                if graph.is_zero(*inertia) {
                    continue;
                }
                for (i, x) in first {
                    for (j, y) in second {
                        let factors = [*x, *inertia, *y];
                        let term = graph.product(factors.map(|x| (x, Rational::ONE)));
                        terms[*i][*j].push((term, Rational::ONE));
                    }
                }
            }
        }
        let mut entry = |terms: Vec<_>| {
            let sum = graph.sum(terms);
            opaque_mean(graph, sum)
        };
        let rows = terms.into_iter();
        rows.map(|row| row.into_iter().map(&mut entry).collect())
            .collect()
    }

    /// For each form what it is a constant combination of, if that is of forms which are none.
    fn combinations(&self, graph: &mut Graph) -> Vec<Option<Combination>> {
        let forms = self.forms.iter();
        let mut combinations: Vec<Option<Combination>> = forms
            .map(|form| {
                let parts = combination(graph, *form)?.into_iter();
                let position = |form| self.forms.iter().position(|known| *known == form);
                parts.map(|(c, form)| Some((c, position(form)?))).collect()
            })
            .collect();
        let is_none: Vec<bool> = combinations.iter().map(Option::is_none).collect();
        for combination in &mut combinations {
            let is_of_others = |parts: &Combination| parts.iter().all(|(_, k)| is_none[*k]);
            *combination = combination.take().filter(is_of_others);
        }
        combinations
    }
}

/// The coefficients other than 0 of the independent forms, with their positions among them.
fn coefficients(
    graph: &mut Graph,
    parts: &Combination,
    independent: &[usize],
) -> Vec<(usize, Expression)> {
    let mut terms: BTreeMap<usize, Vec<(Expression, Rational)>> = BTreeMap::new();
    for (coefficient, form) in parts {
        if let Ok(position) = independent.binary_search(form) {
            let known = terms.entry(position).or_default();
            known.push((*coefficient, Rational::ONE));
        }
    }
    let sums = terms.into_iter().map(|(i, terms)| (i, graph.sum(terms)));
    let mut row: Vec<_> = sums.collect();
    row.retain(|(_, coefficient)| !graph.is_zero(*coefficient));
    row
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Draft;
    use crate::testing::systems::{euler_rates, kinetic};

    #[test]
    fn a_mass_beside_the_point_of_rest_adds_to_the_inertia() {
        // ½ I₁ w₁² + ½ I₂ w₂² + ½ I₃ w₃² + ½ m (x w₂ − y w₁)².
        let draft = Draft::new(3);
        let w = euler_rates(&draft);
        let [_, i2, i3, m, x, y] = draft.ps();
        let point = m * (x * w[1] - y * w[0]).squared() / 2;
        let lagrangian = kinetic(&draft, &w, &[0, 1, 2]) + point;

        let declared = QuasiVelocities::declared(&mut draft.graph(), lagrangian.into()).unwrap();
        assert_eq!(declared.forms.len(), 4);
        let found = declared.combined(&mut draft.graph()).unwrap();
        let place = |form| found.forms.iter().position(|known| *known == form).unwrap();
        let [i, j, k] = w.map(place);
        assert_eq!(found.forms.len(), 3);
        assert_eq!(found.inertia[j][j], i2 + m * x * x);
        assert_eq!(found.inertia[i][j], -(m * x * y));
        assert_eq!(found.inertia[j][i], found.inertia[i][j]);
        assert_eq!(found.inertia[k][k], i3);
        assert_eq!(found.inertia[i][k], draft.zero());
        assert!(found.combined(&mut draft.graph()).is_none());
    }

    #[test]
    fn forms_of_their_own_stay() {
        // ½ m (x w₂ − y w₁)² + ½ I₁ w₁²: nothing else says what w₂ is.
        let draft = Draft::new(3);
        let w = euler_rates(&draft);
        let [x, y] = [4, 5].map(|i| draft.p(i));
        let speed = x * w[1] - y * w[0];
        let lagrangian = kinetic(&draft, &[speed, w[0]], &[3, 0]).expression();
        let declared = QuasiVelocities::declared(&mut draft.graph(), lagrangian).unwrap();
        assert!(declared.combined(&mut draft.graph()).is_none());
    }
}
