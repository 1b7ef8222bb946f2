//! Quasi-velocities recovered from the mass matrix: M = Σ c Aᶜ(q), each Aᶜ the squares of a few linear forms.
//!
//! However a kinetic energy was written, its expanded mass matrix is linear in the inertias c, and the part Aᶜ
//! of one inertia is a sum of squares of its own. Symmetric elimination of Aᶜ (Lagrange's reduction of a quadratic
//! form to a sum of squares) gives the forms where the pivots are squares. The general top, expanded, gives its
//! angular velocities back, and (4.5) with I₁ = I₂ becomes (4.7), in which ψ no longer appears.

use crate::matrix::symmetric_elimination::SymmetricElimination;
use crate::mechanics::energy_forms::quasi_velocities::{QuasiVelocities, is_constant};
use crate::mechanics::expanded_energy::{is_quadratic, linear_part};
use crate::{Equations, Expression, Graph, Node, Rational, Symbol};

type Rows = Vec<Vec<Expression>>;

impl QuasiVelocities {
    /// The quasi-velocities of a mass matrix, if each inertia belongs to a sum of squares.
    pub(crate) fn recovered(graph: &mut Graph, equations: &Equations) -> Option<Self> {
        let mass = &equations.mass;
        // An L that is not quadratic in the velocities is no sum of squares of linear forms, whatever the pivots are.
        if !is_quadratic(graph, equations.lagrangian) {
            return None;
        }
        let (mut forms, mut diagonal) = (Vec::new(), Vec::new());
        for (inertia, metric) in by_constant(graph, mass)? {
            let squares = squares(graph, &metric)?;
            diagonal.extend(squares.iter().map(|_| inertia));
            forms.extend(squares);
        }
        let zero = graph.zero();
        let entry = |i: usize, j: usize| if i == j { diagonal[i] } else { zero };
        let indices = 0..forms.len();
        let inertia = indices
            .clone()
            .map(|i| indices.clone().map(|j| entry(i, j)).collect())
            .collect();
        let rest = linear_part(graph, equations.lagrangian, &equations.momenta);
        Some(Self {
            forms,
            inertia,
            rest,
        })
    }
}

/// The matrices Aᶜ by c, in the order in which the constants are found.
fn by_constant(graph: &mut Graph, mass: &Rows) -> Option<Vec<(Expression, Rows)>> {
    let zero = graph.zero();
    let mut parts: Vec<(Expression, Rows)> = Vec::new();
    for (i, row) in mass.iter().enumerate() {
        for (j, entry) in row.iter().enumerate().take(i + 1) {
            for (monomial, number) in graph.monomials(*entry)? {
                let (constant, varying) = split_constant(graph, monomial);
                let known = parts.iter().position(|(c, _)| *c == constant);
                let position = known.unwrap_or_else(|| {
                    parts.push((constant, vec![vec![zero; mass.len()]; mass.len()]));
                    parts.len() - 1
                });
                let matrix = &mut parts[position].1;
                let term = graph.scale(varying, &number);
                matrix[i][j] = graph.add(matrix[i][j], term);
                matrix[j][i] = matrix[i][j];
            }
        }
    }
    Some(parts)
}

/// A product as its constant factors times the varying ones.
fn split_constant(graph: &mut Graph, monomial: Expression) -> (Expression, Expression) {
    let factors = graph.factors(monomial).into_iter();
    let (constant, varying): (Vec<_>, Vec<_>) = factors.partition(|(x, _)| is_constant(graph, *x));
    (graph.product(constant), graph.product(varying))
}

/// Forms whose squares add up to q̇ᵀ A q̇, by elimination from the shortest pivot on, if all pivots are
/// squares.
fn squares(graph: &mut Graph, metric: &Rows) -> Option<Vec<Expression>> {
    let mut forms = Vec::new();
    let mut metric = SymmetricElimination::new(graph, metric, |i| i);
    while let Some((unknown, ..)) = metric
        .pivots()
        .min_by_key(|(i, pivot, _)| (graph.cost(&[*pivot]), *i))
    {
        let row = metric.take(graph, unknown);
        let root = graph.exact_root(row.pivot)?;
        let mut terms = Vec::new();
        for (j, entry) in row.others.iter().chain([&(unknown, row.pivot)]) {
            let velocity = graph.symbol(Symbol::Velocity(u32::try_from(*j).ok()?));
            let ratio = graph.divide(*entry, root);
            terms.push((graph.multiply(ratio, velocity), Rational::ONE));
        }
        forms.push(graph.sum(terms));
        metric.reduce(graph, &row, Graph::simplest);
    }
    metric.is_zero().then_some(forms)
}

impl Graph {
    /// The expression whose square this is, up to its sign: of a number or of even powers.
    fn exact_root(&mut self, expression: Expression) -> Option<Expression> {
        let (number, product) = match self.node(expression) {
            Node::Constant(value) => (value.clone(), self.one()),
            Node::Sum(terms) if terms.len() == 1 => (terms[0].1.clone(), terms[0].0),
            _ => (Rational::ONE, expression),
        };
        let number = number.root(2)?;
        let factors = match self.node(product) {
            Node::Product(factors) => factors.to_vec(),
            _ if product == self.one() => Vec::new(),
            _ => return None,
        };
        if !factors.iter().all(|(_, k)| k.is_even()) {
            return None;
        }
        let halves: Vec<_> = factors
            .iter()
            .map(|(x, k)| (*x, k * &Rational::HALF))
            .collect();
        let root = self.product(halves);
        Some(self.scale(root, &number))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Model;
    use crate::testing::Draft;
    use crate::testing::systems::{
        Rates, Spelling, euler_rates, general_top, node_rates, polar, top,
    };

    fn found(model: &mut Model) -> QuasiVelocities {
        let equations = Equations::derive(model).unwrap();
        QuasiVelocities::recovered(&mut model.graph, &equations).unwrap()
    }

    /// Whether each of the forms is one of these rates, up to its sign, with these inertias.
    fn assert_forms(mut model: Model, rates: fn(&Draft) -> Rates<'_>, inertias: [u32; 3]) {
        let found = found(&mut model);
        let draft = Draft::of(model.graph, 3);
        let expected = rates(&draft);
        assert_eq!(found.forms.len(), expected.len());
        assert!(found.is_diagonal(&draft.graph()));
        for (rate, inertia) in expected.into_iter().zip(inertias) {
            let inertia = draft.p(inertia);
            let matches = |(k, form): (usize, &Expression)| {
                let form = draft.quantity(*form);
                let mut signs = [form + rate, form - rate].into_iter();
                let equal = signs.any(|x| draft.graph().vanishes(&[x.into()]));
                equal && found.inertia[k][k] == inertia
            };
            assert!(found.forms.iter().enumerate().any(matches));
        }
    }

    #[test]
    fn an_expanded_top_gives_its_angular_velocities_back() {
        for spelling in [
            Spelling::Squares,
            Spelling::SecondExpanded,
            Spelling::Expanded,
        ] {
            assert_forms(general_top(spelling), euler_rates, [0, 1, 2]);
        }
    }

    #[test]
    fn equal_inertias_leave_the_line_of_nodes() {
        // (4.5) with I₁ = I₂ is (4.7): the squares of sin θ φ̇, θ̇ and ψ̇ + cos θ φ̇, and no ψ.
        assert_forms(top(euler_rates, [0, 0, 2]), node_rates, [0, 0, 2]);
        let mut model = top(euler_rates, [0, 0, 2]);
        let forms = found(&mut model).forms;
        let psi = Symbol::Coordinate(2);
        assert!(!model.graph.contains(&forms, |symbol| symbol == psi));
    }

    #[test]
    fn what_is_left_is_at_most_linear() {
        let mut model = polar();
        let found = found(&mut model);
        let velocity = |symbol| matches!(symbol, Symbol::Velocity(_));
        assert!(!model.graph.contains(&[found.rest], velocity));
        let r = model.graph.symbol(Symbol::Coordinate(0));
        assert_eq!(found.rest, model.graph.power(r, &Rational::MINUS_ONE));
    }

    #[test]
    fn mass_that_depends_on_the_velocity_gives_none() {
        // L = ẋ⁴/48, of which M = (ẋ/2)² is a square all the same.
        let draft = Draft::new(1);
        let mut model = draft.natural(draft.v(0).powi(4) / 48, draft.zero());
        let equations = Equations::derive(&mut model).unwrap();
        let found = QuasiVelocities::recovered(&mut model.graph, &equations);
        assert!(found.is_none());
    }

    #[test]
    fn pivots_that_are_no_squares_give_none() {
        // T = ½ (1 + x) ẋ², and ½ x³ ẋ², which is a square for positive x alone.
        for is_power in [false, true] {
            let draft = Draft::new(1);
            let x = draft.q(0);
            let mass = if is_power { x.powi(3) } else { x + 1 };
            let mut model = draft.natural(mass * x.dot().squared() / 2, draft.zero());
            let equations = Equations::derive(&mut model).unwrap();
            let found = QuasiVelocities::recovered(&mut model.graph, &equations);
            assert!(found.is_none());
        }
    }
}
