//! Quasi-velocities read off the declaration: the squares whose sum the kinetic energy was declared as.
//!
//! The expression is not expanded: what is squared is a linear form, its coefficient is an inertia. Squared factors
//! that depend on the coordinates belong to the form: r²φ̇² is the square of rφ̇. Products of two forms, as in
//! ½ wᵀ W w with products of inertia, are read, too.

use crate::algebra::velocity_degree::Degrees;
use crate::mechanics::energy_forms::quasi_velocities::{QuasiVelocities, is_constant};
use crate::{Expression, Graph, Node, Rational};

/// One term of L: coefficient · first · second, both linear in the velocities.
struct Term {
    coefficient: Expression,
    factors: [Expression; 2],
}

impl QuasiVelocities {
    /// Finds the squares in `lagrangian`, unless it is no such sum or an inertia varies.
    pub(crate) fn declared(graph: &mut Graph, lagrangian: Expression) -> Option<Self> {
        let degrees = Degrees::of(graph, lagrangian);
        let mut quadratic = Vec::new();
        let mut rest = Vec::new();
        let mut waiting = vec![(graph.one(), lagrangian)];
        while let Some((coefficient, expression)) = waiting.pop() {
            let degree = degrees.of_expression(expression)?;
            if degree < 2 {
                let term = graph.multiply(coefficient, expression);
                rest.push((term, Rational::ONE));
                continue;
            }
            match graph.node(expression).clone() {
                Node::Sum(terms) => {
                    for (x, c) in terms {
                        waiting.push((graph.scale(coefficient, &c), x));
                    }
                }
                Node::Product(factors) if degree == 2 => {
                    match degrees.split(graph, coefficient, &factors)? {
                        Split::Quadratic(term) => quadratic.extend(distributed(graph, term)),
                        Split::Nested(coefficient, inner) => waiting.push((coefficient, inner)),
                    }
                }
                _ => return None,
            }
        }
        let rest = graph.sum(rest);
        Self::collect(graph, quadratic, rest)
    }

    /// Adds up the coefficients of equal products.
    fn collect(graph: &mut Graph, terms: Vec<Term>, rest: Expression) -> Option<Self> {
        let mut forms = Vec::new();
        let mut entries = Vec::new();
        // The terms were found from the last to the first.
        for term in terms.into_iter().rev() {
            let (inertia, [first, second]) = absorb_squares(graph, &term)?;
            let indices = [first, second].map(|form| {
                forms
                    .iter()
                    .position(|known| *known == form)
                    .unwrap_or_else(|| {
                        forms.push(form);
                        forms.len() - 1
                    })
            });
            entries.push((indices, inertia));
        }
        let mut inertia = vec![vec![graph.zero(); forms.len()]; forms.len()];
        for ([i, j], coefficient) in entries {
            // c·wᵢ·wⱼ is ½ (Wᵢⱼ + Wⱼᵢ) wᵢ wⱼ.
            let coefficient = if i == j {
                graph.scale(coefficient, &Rational::integer(2))
            } else {
                coefficient
            };
            inertia[i][j] = graph.add(inertia[i][j], coefficient);
            inertia[j][i] = inertia[i][j];
        }
        for entry in inertia.iter_mut().flatten() {
            *entry = opaque_mean(graph, *entry);
        }
        Some(Self {
            forms,
            inertia,
            rest,
        })
    }
}

/// An inertia, opaque if it is a mean of others: it is then hoisted together with its number, which does not spread
/// into the products that contain the inertia.
pub(crate) fn opaque_mean(graph: &mut Graph, inertia: Expression) -> Expression {
    let Node::Sum(terms) = graph.node(inertia) else {
        return inertia;
    };
    let is_sum = |x: Expression| matches!(graph.node(x), Node::Sum(_));
    let is_mean = terms.iter().any(|(_, c)| !c.is_integer())
        && (terms.len() > 1 || terms.iter().any(|(x, _)| is_sum(*x)));
    if is_mean {
        graph.opaque(inertia)
    } else {
        inertia
    }
}

/// What a product of degree two is.
enum Split {
    Quadratic(Term),
    /// A coefficient and a sum that is quadratic itself.
    Nested(Expression, Expression),
}

impl Degrees {
    /// Separates the velocities from the coefficient in a product of degree two.
    fn split(
        &self,
        graph: &mut Graph,
        coefficient: Expression,
        factors: &[(Expression, Rational)],
    ) -> Option<Split> {
        let moves = |(x, _): &&(Expression, Rational)| self.of_expression(*x) != Some(0);
        let moving: Vec<_> = factors.iter().filter(moves).collect();
        let mut still: Vec<_> = factors
            .iter()
            .filter(|factor| !moves(factor))
            .cloned()
            .collect();
        still.push((coefficient, Rational::ONE));
        let coefficient = graph.product(still);
        let term = |factors| {
            Some(Split::Quadratic(Term {
                coefficient,
                factors,
            }))
        };
        match *moving {
            [(x, k)] if k.is_one() => Some(Split::Nested(coefficient, *x)),
            [(x, _)] => term([*x, *x]),
            [(x, _), (y, _)] => term([*x, *y]),
            _ => None,
        }
    }
}

/// The product of a form and of a combination of forms, form by form: wₖ Σ Iₖₗ wₗ.
fn distributed(graph: &mut Graph, term: Term) -> Vec<Term> {
    let [first, second] = term.factors;
    if first != second {
        for (form, sum) in [(first, second), (second, first)] {
            if let Some(parts) = combination(graph, sum) {
                let parts = parts.into_iter().map(|(constant, other)| Term {
                    coefficient: graph.multiply(term.coefficient, constant),
                    factors: [form, other],
                });
                return parts.collect();
            }
        }
    }
    vec![term]
}

/// A sum Σ c·w with constant c, if every term is one.
pub(crate) fn combination(
    graph: &mut Graph,
    sum: Expression,
) -> Option<Vec<(Expression, Expression)>> {
    let Node::Sum(terms) = graph.node(sum) else {
        return None;
    };
    let mut parts = Vec::new();
    for (term, number) in terms.clone() {
        let factors = graph.factors(term).into_iter();
        let (constant, moving): (Vec<_>, Vec<_>) =
            factors.partition(|(x, _)| is_constant(graph, *x));
        let [(form, exponent)] = &*moving else {
            return None;
        };
        if !exponent.is_one() {
            return None;
        }
        let constant = graph.product(constant);
        parts.push((graph.scale(constant, &number), *form));
    }
    Some(parts)
}

/// The inertia and the forms of a term, with what varies and stands squared moved into the forms.
fn absorb_squares(graph: &mut Graph, term: &Term) -> Option<(Expression, [Expression; 2])> {
    let Term {
        coefficient,
        factors,
    } = *term;
    if is_constant(graph, coefficient) {
        return Some((coefficient, factors));
    }
    if factors[0] != factors[1] {
        return None;
    }
    // c·Π x^k, as a product with a number in front.
    let (number, product) = match graph.node(coefficient) {
        Node::Sum(terms) if terms.len() == 1 => (terms[0].1.clone(), terms[0].0),
        _ => (Rational::ONE, coefficient),
    };
    let parts = match graph.node(product) {
        Node::Product(parts) => parts.to_vec(),
        _ => return None,
    };
    let (mut inertia, mut form) = (Vec::new(), vec![(factors[0], Rational::ONE)]);
    for (x, k) in parts {
        if is_constant(graph, x) {
            inertia.push((x, k));
        } else if k.is_even() {
            form.push((x, &k * &Rational::HALF));
        } else {
            return None;
        }
    }
    let inertia = graph.product(inertia);
    let inertia = graph.scale(inertia, &number);
    let form = graph.product(form);
    Some((inertia, [form, form]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::systems::{Chain, euler_rates, kinetic};
    use crate::testing::{Draft, Quantity};
    use crate::{Energies, Model};

    fn declared(draft: &Draft, lagrangian: Quantity<'_>) -> Option<QuasiVelocities> {
        QuasiVelocities::declared(&mut draft.graph(), lagrangian.into())
    }

    /// The forms of ½ Σ Iₖ wₖ² + rest, whose inertias are the parameters in order.
    fn assert_diagonal(draft: &Draft, found: &QuasiVelocities, inertias: &[u32]) {
        assert!(found.is_diagonal(&draft.graph()));
        for (k, inertia) in inertias.iter().enumerate() {
            assert_eq!(found.inertia[k][k], draft.p(*inertia));
        }
    }

    #[test]
    fn the_squares_of_a_top_are_its_angular_velocities() {
        let draft = Draft::new(3);
        let w = euler_rates(&draft);
        let potential = draft.q(1).cos();
        let found = declared(&draft, kinetic(&draft, &w, &[0, 1, 2]) - potential).unwrap();
        assert_eq!(found.forms, w);
        assert_diagonal(&draft, &found, &[0, 1, 2]);
        assert_eq!(found.rest, -potential);
    }

    #[test]
    fn products_of_inertia_stand_beside_the_diagonal() {
        // ½ wᵀ W w with W₁₂ in scalars, whether as P₃ w₁ w₂ or as w₁ (I₁ w₁ + P₃ w₂) + ….
        let draft = Draft::new(3);
        let w @ [w1, w2, w3] = euler_rates(&draft);
        let [i1, i2, i3, product] = draft.ps();
        let in_scalars = kinetic(&draft, &w, &[0, 1, 2]) + product * w1 * w2;
        let momenta = [i1 * w1 + product * w2, product * w1 + i2 * w2, i3 * w3];
        let in_momenta = draft.sum(w.into_iter().zip(momenta).map(|(w, p)| w * p)) / 2;
        for lagrangian in [in_scalars, in_momenta] {
            let found = declared(&draft, lagrangian).unwrap();
            assert_eq!(found.forms.len(), 3);
            let place = |form| found.forms.iter().position(|known| *known == form).unwrap();
            let [i, j, k] = w.map(place);
            assert_eq!(found.inertia[i][j], product);
            assert_eq!(found.inertia[j][i], product);
            assert_eq!(found.inertia[i][i], i1);
            assert_eq!(found.inertia[j][j], i2);
            assert_eq!(found.inertia[k][k], i3);
            assert_eq!(found.inertia[i][k], draft.zero());
            assert!(!found.is_diagonal(&draft.graph()));
        }
    }

    #[test]
    fn the_velocities_of_a_chain_are_found_with_its_masses() {
        let Model {
            mut graph,
            energies,
            ..
        } = Chain::of(3).model();
        let Energies::Natural { kinetic, .. } = energies else {
            unreachable!()
        };
        let found = QuasiVelocities::declared(&mut graph, kinetic).unwrap();
        // The squares of the first body's two velocities are one, (l φ̇)².
        assert_eq!(found.forms.len(), 5);
        assert!(found.is_diagonal(&graph));
        assert!(graph.is_zero(found.rest));
        assert!(found.is_homogeneous(&mut graph, 3));
    }

    #[test]
    fn even_powers_of_coordinates_belong_to_the_form() {
        // ½ m r² φ̇² is the square of r φ̇; r φ̇² and sin θ φ̇² are no squares.
        let draft = Draft::new(2);
        let (m, r, v) = (draft.p(0), draft.q(0), draft.v(1));
        let found = declared(&draft, m * r.squared() * v.squared() / 2).unwrap();
        assert_eq!(found.forms, [r * v]);
        assert_diagonal(&draft, &found, &[0]);
        for factor in [r, r.sin()] {
            assert!(declared(&draft, m * factor * v.squared()).is_none());
        }
    }

    #[test]
    fn what_is_no_sum_of_squares_has_no_forms() {
        let draft = Draft::new(1);
        let v = draft.v(0);
        // Relativistic, of the third and fourth degree, and with a velocity under a function.
        let relativistic = (1 - v.squared()).sqrt();
        for other in [relativistic, v.powi(3), v.powi(4), v.sin()] {
            assert!(declared(&draft, v.squared() + other).is_none());
        }
    }

    #[test]
    fn what_is_linear_in_the_velocities_is_left() {
        let draft = Draft::new(2);
        let (x, [vx, vy]) = (draft.q(0), draft.vs());
        let found = declared(&draft, vx.squared() + vy.squared() + x * vy).unwrap();
        assert_eq!(found.forms, [vx, vy]);
        assert_eq!(found.rest, x * vy);
        // W is twice the coefficient: L = ½ wᵀ W w.
        assert_eq!(found.inertia[0][0], draft.number(2));
    }
}
