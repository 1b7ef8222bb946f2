//! The kinetic energy as it was declared: ½ wᵀ W w in quasi-velocities w = E(q, t) q̇ + b(q, t).
//!
//! Whoever writes ½ (I₁ω₁² + I₂ω₂² + I₃ω₃²) says more than the mass matrix does: M = Eᵀ W E can be
//! solved factor by factor, which costs less and squares no condition number. Comes in: a Lagrangian.
//! Goes out: the forms that are squared in it, their inertia W, and what is left. Factors that depend
//! on the coordinates and stand squared belong to the form: r²φ̇² is the square of rφ̇.

use crate::{Expression, Graph, Node, Rational, Symbol};

/// A Lagrangian L = ½ Σ Wₖₗ wₖ wₗ + rest.
#[derive(Clone, Debug)]
pub(crate) struct QuasiVelocities {
    /// The quasi-velocities w, each at most linear in the velocities.
    pub(crate) forms: Vec<Expression>,
    /// W, symmetric; constant in the state and in time.
    pub(crate) inertia: Vec<Vec<Expression>>,
    /// What is left of L, at most linear in the velocities.
    pub(crate) rest: Expression,
}

/// One term of L: coefficient · first · second, both linear in the velocities.
struct Term {
    coefficient: Expression,
    factors: [Expression; 2],
}

impl QuasiVelocities {
    /// Finds the squares in `lagrangian`, unless it is no such sum or an inertia varies.
    pub(crate) fn find(graph: &mut Graph, lagrangian: Expression) -> Option<Self> {
        let degrees = Degrees::of(graph, lagrangian);
        let mut quadratic = Vec::new();
        let mut rest = Vec::new();
        let mut waiting = vec![(graph.one(), lagrangian)];
        while let Some((coefficient, expression)) = waiting.pop() {
            if degrees.of_expression(expression)? < 2 {
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
                Node::Product(factors) => match degrees.split(graph, coefficient, &factors)? {
                    Split::Quadratic(term) => quadratic.push(term),
                    Split::Opens(coefficient, inner) => waiting.push((coefficient, inner)),
                },
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
            let (inertia, [first, second]) = absorb_squares(graph, term)?;
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
        Some(Self {
            forms,
            inertia,
            rest,
        })
    }

    /// The same energy in other quasi-velocities: where several have one inertia, the sum of their squares
    /// is eliminated like a mass matrix, and its pivots are squares themselves. Then (4.5) with I₁ = I₂
    /// becomes (4.7), in which ψ no longer appears.
    pub(crate) fn regrouped(&self, graph: &mut Graph, coordinates: u32) -> Option<Self> {
        if !self.is_homogeneous(graph, coordinates) {
            return None;
        }
        let matrix = self.kinematics(graph, coordinates);
        let mut grouped = Self {
            forms: Vec::new(),
            inertia: Vec::new(),
            rest: self.rest,
        };
        let mut diagonal = Vec::new();
        let mut changed = false;
        for group in self.groups(graph)? {
            let rows: Vec<_> = group.iter().map(|k| matrix[*k].clone()).collect();
            let squares = (rows.len() > 1)
                .then(|| squares(graph, &rows, coordinates))
                .flatten();
            changed |= squares.is_some();
            let forms = squares.unwrap_or_else(|| group.iter().map(|k| self.forms[*k]).collect());
            diagonal.extend(forms.iter().map(|_| self.inertia[group[0]][group[0]]));
            grouped.forms.extend(forms);
        }
        let zero = graph.zero();
        let entry = |i, j| if i == j { diagonal[i] } else { zero };
        let indices = 0..diagonal.len();
        grouped.inertia = indices
            .clone()
            .map(|i| indices.clone().map(|j| entry(i, j)).collect())
            .collect();
        changed.then_some(grouped)
    }

    /// Whether the quasi-velocities vanish with the velocities.
    pub(crate) fn is_homogeneous(&self, graph: &mut Graph, coordinates: u32) -> bool {
        let offsets = self.offsets(graph, coordinates);
        offsets.iter().all(|offset| graph.is_zero(*offset))
    }

    /// What the quasi-velocities are where all velocities vanish.
    pub(crate) fn offsets(&self, graph: &mut Graph, coordinates: u32) -> Vec<Expression> {
        let zero = graph.zero();
        let still = (0..coordinates)
            .map(|i| (Symbol::Velocity(i), zero))
            .collect();
        graph.substitute(&self.forms, &still)
    }

    /// The same energy with each form primitive, what is constant in it moved into the inertia, and the
    /// forms of fewer velocities first.
    pub(crate) fn sorted(&self, graph: &mut Graph, coordinates: u32) -> Self {
        let matrix = self.kinematics(graph, coordinates);
        let offsets = self.offsets(graph, coordinates);
        let mut forms = Vec::with_capacity(matrix.len());
        for ((k, row), offset) in matrix.iter().enumerate().zip(offsets) {
            let length = row.iter().filter(|entry| !graph.is_zero(**entry)).count();
            let (factor, form) = primitive(graph, row, offset);
            forms.push((length, k, factor, form));
        }
        forms.sort_by_key(|(length, k, ..)| (*length, *k));
        let entry = |graph: &mut Graph, i: usize, j: usize| {
            let (_, k, factor, _) = forms[i];
            let (_, l, other, _) = forms[j];
            graph.product([
                (self.inertia[k][l], Rational::ONE),
                (factor, Rational::ONE),
                (other, Rational::ONE),
            ])
        };
        let indices = 0..forms.len();
        let inertia = indices
            .clone()
            .map(|i| indices.clone().map(|j| entry(graph, i, j)).collect())
            .collect();
        Self {
            inertia,
            rest: self.rest,
            forms: forms.into_iter().map(|(.., form)| form).collect(),
        }
    }

    /// The quasi-velocities of equal inertia, if W is diagonal.
    fn groups(&self, graph: &Graph) -> Option<Vec<Vec<usize>>> {
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for (i, row) in self.inertia.iter().enumerate() {
            if row
                .iter()
                .enumerate()
                .any(|(j, entry)| i != j && !graph.is_zero(*entry))
            {
                return None;
            }
            match groups
                .iter_mut()
                .find(|group| self.inertia[group[0]][group[0]] == row[i])
            {
                Some(group) => group.push(i),
                None => groups.push(vec![i]),
            }
        }
        Some(groups)
    }

    /// The matrix E = ∂w/∂q̇, row by row.
    pub(crate) fn kinematics(&self, graph: &mut Graph, coordinates: u32) -> Vec<Vec<Expression>> {
        let columns: Vec<_> = (0..coordinates)
            .map(|j| graph.derivatives(&self.forms, Symbol::Velocity(j)))
            .collect();
        (0..self.forms.len())
            .map(|k| columns.iter().map(|column| column[k]).collect())
            .collect()
    }

    /// The momenta W w that belong to the quasi-velocities.
    pub(crate) fn momenta(&self, graph: &mut Graph) -> Vec<Expression> {
        let mut momenta = Vec::with_capacity(self.forms.len());
        for row in &self.inertia {
            let terms: Vec<_> = row
                .iter()
                .zip(&self.forms)
                .map(|(inertia, form)| (graph.multiply(*inertia, *form), Rational::ONE))
                .collect();
            momenta.push(graph.sum(terms));
        }
        momenta
    }
}

/// The form Σ e q̇ + offset as a constant factor and a form without one.
fn primitive(
    graph: &mut Graph,
    row: &[Expression],
    offset: Expression,
) -> (Expression, Expression) {
    let mut terms = vec![(offset, Rational::ONE)];
    for (i, coefficient) in (0..).zip(row) {
        let velocity = graph.symbol(Symbol::Velocity(i));
        terms.push((graph.multiply(*coefficient, velocity), Rational::ONE));
    }
    let sum = graph.sum(terms);
    let Some(split) = graph.split(sum) else {
        return (graph.one(), sum);
    };
    let (mut constant, mut varying) = (Vec::new(), vec![(split.rest, Rational::ONE)]);
    for (x, k) in split.common {
        if is_constant(graph, x) {
            constant.push((x, k));
        } else {
            varying.push((x, k));
        }
    }
    let factor = graph.product(constant);
    let factor = graph.scale(factor, &split.number);
    (factor, graph.product(varying))
}

/// Whether an expression is made of parameters alone.
fn is_constant(graph: &Graph, expression: Expression) -> bool {
    !graph.contains(&[expression], |symbol| {
        !matches!(symbol, Symbol::Parameter(_))
    })
}

/// Quasi-velocities whose squares add up to those of the rows' E q̇, fewer or sparser than the rows.
fn squares(
    graph: &mut Graph,
    rows: &[Vec<Expression>],
    coordinates: u32,
) -> Option<Vec<Expression>> {
    let size = coordinates as usize;
    let mut metric = vec![vec![graph.zero(); size]; size];
    for i in 0..size {
        for j in 0..=i {
            let terms: Vec<_> = rows
                .iter()
                .map(|row| (graph.multiply(row[i], row[j]), Rational::ONE))
                .collect();
            let entry = graph.sum(terms);
            metric[i][j] = graph.simplest(entry);
            metric[j][i] = metric[i][j];
        }
    }
    let mut forms = Vec::new();
    let mut waiting: Vec<usize> = (0..size).collect();
    // From constants to what varies, so that pivots stay short.
    while let Some(pivot) = waiting
        .iter()
        .copied()
        .filter(|i| !graph.is_zero(metric[*i][*i]))
        .min_by_key(|i| (graph.cost(&[metric[*i][*i]]), *i))
    {
        let root = graph.exact_root(metric[pivot][pivot])?;
        waiting.retain(|i| *i != pivot);
        let mut terms = Vec::new();
        for j in waiting.iter().copied().chain([pivot]) {
            let velocity = graph.symbol(Symbol::Velocity(u32::try_from(j).ok()?));
            let ratio = graph.divide(metric[pivot][j], root);
            terms.push((graph.multiply(ratio, velocity), Rational::ONE));
        }
        forms.push(graph.sum(terms));
        for i in waiting.iter().copied() {
            for j in waiting.iter().copied() {
                let product = graph.multiply(metric[i][pivot], metric[j][pivot]);
                let change = graph.divide(product, metric[pivot][pivot]);
                let entry = graph.subtract(metric[i][j], change);
                metric[i][j] = graph.simplest(entry);
            }
        }
    }
    let complete = waiting
        .iter()
        .all(|i| waiting.iter().all(|j| graph.is_zero(metric[*i][*j])));
    (complete && forms.len() <= rows.len()).then_some(forms)
}

/// What a product of degree two is.
enum Split {
    Quadratic(Term),
    /// A coefficient and a sum that is quadratic itself.
    Opens(Expression, Expression),
}

/// The degrees of expressions as polynomials in the velocities; none for what is not a polynomial.
struct Degrees(Vec<Option<u8>>);

impl Degrees {
    fn of(graph: &Graph, root: Expression) -> Self {
        let mut degrees = Self(vec![Some(0); root.index() + 1]);
        for expression in graph.descendants(&[root]) {
            degrees.0[expression.index()] = degrees.degree(graph.node(expression));
        }
        degrees
    }

    fn of_expression(&self, expression: Expression) -> Option<u8> {
        self.0[expression.index()]
    }

    fn degree(&self, node: &Node) -> Option<u8> {
        match node {
            Node::Symbol(Symbol::Velocity(_)) => Some(1),
            Node::Constant(_) | Node::Pi | Node::Symbol(_) => Some(0),
            Node::Sum(terms) => terms
                .iter()
                .try_fold(0, |most, (x, _)| Some(self.of_expression(*x)?.max(most))),
            Node::Product(factors) => factors.iter().try_fold(0, |total: u8, (x, k)| {
                match (self.of_expression(*x)?, k.to_integer()) {
                    (0, _) => Some(total),
                    (degree, Some(k)) => {
                        total.checked_add(degree.checked_mul(u8::try_from(k).ok()?)?)
                    }
                    (_, None) => None,
                }
            }),
            Node::Whole(x) => self.of_expression(*x),
            Node::Unary(_, x) => (self.of_expression(*x)? == 0).then_some(0),
            Node::Binary(_, x, y) => {
                let still = self.of_expression(*x)? == 0 && self.of_expression(*y)? == 0;
                still.then_some(0)
            }
        }
    }

    /// Parts what moves from what does not in a product of degree two.
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
            [(x, k)] if k.is_one() => Some(Split::Opens(coefficient, *x)),
            [(x, _)] => term([*x, *x]),
            [(x, _), (y, _)] => term([*x, *y]),
            _ => None,
        }
    }
}

/// The inertia and the forms of a term, with what varies and stands squared moved into the forms.
fn absorb_squares(graph: &mut Graph, term: Term) -> Option<(Expression, [Expression; 2])> {
    let Term {
        coefficient,
        factors,
    } = term;
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
