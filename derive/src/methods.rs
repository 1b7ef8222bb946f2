//! Which programs a model's methods are.

use lagrangian_symbolic::{
    Elimination, Equations, Expression, Fault, Model, OperationCount, Program, Rational, Solution,
    Symbol,
};

/// A method whose body is one program.
pub(crate) struct Method {
    pub(crate) program: Program,
    pub(crate) count: OperationCount,
    /// Whether the program computes what it was made from, so far as debug builds look.
    pub(crate) verified: bool,
}

/// The programs of everything that is emitted for a model.
pub(crate) struct Methods {
    pub(crate) lagrangian: Method,
    pub(crate) energy: Method,
    pub(crate) momenta: Method,
    pub(crate) mass_matrix: Method,
    pub(crate) forcing: Method,
    pub(crate) generalized_forces: Method,
    /// Either q̈ after the pivots on which it depends, or the lower triangle of M and then f.
    pub(crate) accelerations: Method,
    /// The number of pivots before q̈, where q̈ is solved for before any number is known.
    pub(crate) solved: Option<usize>,
    /// Whether q̈ was found to solve M q̈ = f, so far as debug builds look.
    pub(crate) solves: bool,
    /// The pivots, their magnitudes and the diagonal of M, where M is eliminated before any number is known.
    pub(crate) relative_pivots: Option<Method>,
    pub(crate) inverse_dynamics: Method,
    /// The lower triangle of M, then f; and in a second phase, with the accelerations known, the columns
    /// of ∂(M q̈ − f)/∂q, ∂/∂q̇ and ∂/∂t.
    pub(crate) linearize: Method,
    /// The lower triangle of M, then the columns of ∂(M q̈ − f)/∂u.
    pub(crate) input_jacobian: Method,
    /// T and V, where they were declared.
    pub(crate) energies: Option<[Method; 2]>,
    pub(crate) outputs: Method,
}

impl Methods {
    /// The methods that are counted, with their names.
    pub(crate) const fn all(&self) -> [(&'static str, &Method); 9] {
        [
            ("lagrangian", &self.lagrangian),
            ("energy", &self.energy),
            ("momenta", &self.momenta),
            ("mass_matrix", &self.mass_matrix),
            ("forcing", &self.forcing),
            ("generalized_forces", &self.generalized_forces),
            ("accelerations", &self.accelerations),
            ("inverse_dynamics", &self.inverse_dynamics),
            ("linearize", &self.linearize),
        ]
    }

    /// Differentiates what is still to be differentiated, and schedules each method.
    pub(crate) fn schedule(model: &mut Model, equations: &Equations) -> Self {
        let n = model.coordinates as usize;
        let system: Vec<_> = equations
            .mass_lower()
            .chain(equations.forcing.iter().copied())
            .collect();
        let derivatives = columns(model, equations, &state_symbols(model));
        // The momenta are free of inputs, so that no input acts on M q̈, however the terms are spelt.
        let by_inputs = columns(model, equations, &model.input_symbols());
        let by_inputs = without_accelerations(model, &by_inputs);
        let jacobian: Vec<_> = equations
            .mass_lower()
            .chain(by_inputs.iter().copied())
            .collect();
        let elimination = Elimination::solve(
            &mut model.graph,
            &equations.mass,
            &equations.forcing,
            &equations.structure.angles,
        );
        let solution = Solution::cheapest(model, equations, elimination.as_ref());
        let solves = !cfg!(debug_assertions)
            || solution
                .as_ref()
                .is_none_or(|found| found.holds(&model.graph, equations));
        let energies = match model.energies {
            lagrangian_symbolic::Energies::Natural { kinetic, potential } => {
                Some([kinetic, potential])
            }
            lagrangian_symbolic::Energies::General(_) => None,
        };
        let method = |groups: &[&[Expression]]| Method::schedule(model, groups);
        let full: Vec<_> = equations.mass.concat();
        let diagonal: Vec<_> = (0..n).map(|i| equations.mass[i][i]).collect();
        let pivots = elimination
            .as_ref()
            .map(|solved| [&*solved.pivots, &solved.magnitudes, &diagonal].concat());
        Self {
            lagrangian: method(&[&[equations.lagrangian]]),
            energy: method(&[&[equations.energy]]),
            momenta: method(&[&equations.momenta]),
            mass_matrix: method(&[&full]),
            forcing: method(&[&equations.forcing]),
            generalized_forces: method(&[&equations.generalized_forces]),
            solves,
            solved: solution.as_ref().map(|solution| solution.pivots.len()),
            accelerations: match &solution {
                Some(solution) => method(&[&[&*solution.pivots, &solution.accelerations].concat()]),
                None => method(&[&system]).with_solution(n, 1),
            },
            relative_pivots: pivots.map(|pivots| method(&[&pivots])),
            inverse_dynamics: method(&[&equations.inverse_dynamics]),
            linearize: method(&[&system, &derivatives]).with_solution(n, 2 * n + 2),
            input_jacobian: method(&[&jacobian]).with_solution(n, model.inputs as usize),
            energies: energies.map(|energies| energies.map(|energy| method(&[&[energy]]))),
            outputs: method(&[&model.outputs]),
        }
    }
}

impl Methods {
    /// A constant that `f64` cannot hold, if there is one: beyond its range, or lost below it.
    pub(crate) fn unrepresentable(&self) -> Option<&Rational> {
        self.every()
            .flat_map(|method| method.program.constants())
            .find(|number| !in_range(number))
    }

    /// Whether every program computes what it was made from.
    pub(crate) fn verified(&self) -> bool {
        self.solves && self.every().all(|method| method.verified)
    }

    fn every(&self) -> impl Iterator<Item = &Method> {
        let energies = self.energies.iter().flatten();
        let counted = self.all().map(|(_, method)| method);
        let others = [&self.input_jacobian, &self.outputs];
        let methods = counted.into_iter().chain(others).chain(energies);
        methods.chain(&self.relative_pivots)
    }
}

/// Whether a number is neither beyond the largest nor lost below the smallest `f64`.
pub(crate) fn in_range(number: &Rational) -> bool {
    let rounded = number.to_f64();
    rounded.is_finite() && (rounded != 0.0 || number.is_zero())
}

impl Method {
    fn schedule(model: &Model, groups: &[&[Expression]]) -> Self {
        let program = Program::schedule(&model.graph, groups);
        let count = program.count();
        let verified = !cfg!(debug_assertions)
            || matches!(
                program.verify(&model.graph, groups),
                Ok(()) | Err(Fault::Undecided)
            );
        Self {
            program,
            count,
            verified,
        }
    }

    /// Counts the factorization of M with `n` rows, and the solution for several right-hand sides.
    fn with_solution(mut self, n: usize, right_hand_sides: usize) -> Self {
        let below = n * n.saturating_sub(1) / 2;
        let eliminations = below + n * n.saturating_sub(1) * n.saturating_sub(2) / 6;
        let substitutions = 2 * below * right_hand_sides;
        self.count.additions += eliminations + substitutions;
        self.count.multiplications += eliminations + below + substitutions + n * right_hand_sides;
        self.count.divisions += n;
        self
    }
}

/// Expressions with the accelerations 0.
fn without_accelerations(model: &mut Model, roots: &[Expression]) -> Vec<Expression> {
    let zero = model.graph.zero();
    let rest = (0..model.coordinates).map(|i| (Symbol::Acceleration(i), zero));
    model.graph.substitute(roots, &rest.collect())
}

/// q, q̇ and t.
fn state_symbols(model: &Model) -> Vec<Symbol> {
    let mut symbols = model.coordinate_symbols();
    symbols.extend(model.velocity_symbols());
    symbols.push(Symbol::Time);
    symbols
}

/// The derivatives ∂(M q̈ − f)/∂x, column by column.
fn columns(model: &mut Model, equations: &Equations, symbols: &[Symbol]) -> Vec<Expression> {
    let rows = equations.residual_derivatives(&mut model.graph, symbols);
    (0..symbols.len())
        .flat_map(|j| rows.iter().map(move |row| row[j]).collect::<Vec<_>>())
        .collect()
}
