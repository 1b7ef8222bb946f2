//! Which programs a model's methods are.

use std::collections::BTreeMap;

use lagrangian_symbolic::{
    Energies, Equations, Expression, Function, Graph, Kinetics, LinearSystem, Model,
    OperationCount, Prepared, Program, Rational, Symbol,
};

/// A method whose body is one program.
pub(crate) struct Method {
    pub(crate) program: Program,
    pub(crate) count: OperationCount,
}

/// The programs of everything that is emitted for a model.
pub(crate) struct Methods {
    pub(crate) lagrangian: Method,
    pub(crate) energy: Method,
    pub(crate) momenta: Method,
    pub(crate) mass_matrix: Method,
    pub(crate) forcing: Method,
    pub(crate) generalized_forces: Method,
    /// What depends on the parameters alone in `accelerations`.
    pub(crate) prepare: Method,
    /// Either q̈ after the pivots on which it depends, or the lower triangle of M and then f.
    pub(crate) accelerations: Method,
    /// The number of pivots before q̈, where q̈ is solved for before any number is known.
    pub(crate) solved: Option<usize>,
    /// The pivots, their magnitudes and the diagonal of M, where M is eliminated before any number is known.
    pub(crate) relative_pivots: Option<Method>,
    pub(crate) inverse_dynamics: Method,
    /// Whether derivatives are solved for before any number is known: then `linearize` computes the pivots
    /// and q̈, the columns of ∂q̈/∂q, ∂q̈/∂q̇ and ∂q̈/∂t, and those of ∂(M q̈ − f) if there are pivots.
    /// Else it computes the lower triangle of M and f, and the columns of ∂(M q̈ − f).
    pub(crate) directly: bool,
    pub(crate) linearize: Method,
    /// The same for ∂q̈/∂u, without f or q̈.
    pub(crate) input_jacobian: Method,
    /// T and V, where they were declared.
    pub(crate) energies: Option<[Method; 2]>,
    pub(crate) outputs: Method,
    /// The declared derivatives of functions from outside.
    pub(crate) functions: Vec<FunctionDerivative>,
}

/// A declared derivative of a function from outside.
pub(crate) struct FunctionDerivative {
    /// The position of the function.
    pub(crate) function: usize,
    /// The position of the argument.
    pub(crate) argument: usize,
    pub(crate) method: Method,
}

/// For more coordinates the relative pivots are those of a factorization in numbers.
const MOST_PIVOTS: usize = 4;

impl Methods {
    /// The methods that are counted, with their names.
    pub(crate) const fn all(&self) -> [(&'static str, &Method); 10] {
        [
            ("lagrangian", &self.lagrangian),
            ("energy", &self.energy),
            ("momenta", &self.momenta),
            ("mass_matrix", &self.mass_matrix),
            ("forcing", &self.forcing),
            ("generalized_forces", &self.generalized_forces),
            ("prepare", &self.prepare),
            ("accelerations", &self.accelerations),
            ("inverse_dynamics", &self.inverse_dynamics),
            ("linearize", &self.linearize),
        ]
    }

    /// Differentiates what is still to be differentiated, and schedules each method.
    pub(crate) fn schedule(model: &mut Model, equations: &Equations) -> Self {
        let kinetics = Kinetics::cheapest(model, equations);
        let solution = kinetics.solution.as_ref();
        let linearize = Derivatives::of_state(model, &kinetics);
        let input_jacobian = Derivatives::of_inputs(model, &kinetics);
        let few = equations.mass.len() <= MOST_PIVOTS;
        let elimination = kinetics.elimination.as_ref().filter(|_| few);
        let angles = &equations.structure.angles;
        let magnitudes = elimination.map(|found| found.magnitudes(&mut model.graph, angles));
        let diagonal: Vec<_> = (0..equations.mass.len())
            .map(|i| equations.mass[i][i])
            .collect();
        let pivots = elimination.zip(magnitudes);
        let pivots = pivots.map(|(found, sizes)| [&*found.pivots, &sizes, &diagonal].concat());
        let energies = match model.energies {
            Energies::Natural { kinetic, potential } => Some([kinetic, potential]),
            Energies::General(_) => None,
        };
        let method = |groups: &[&[Expression]]| Method::schedule(model, groups);
        let n = equations.mass.len();
        let [prepare, accelerations] = if let Some(solution) = solution {
            let outputs = [&*solution.pivots, &solution.accelerations].concat();
            Method::prepared(model, &outputs)
        } else {
            let [prepare, accelerations] = Method::prepared(model, &system(&kinetics.system));
            [prepare, accelerations.with_solution(n, 1)]
        };
        Self {
            lagrangian: method(&[&[equations.lagrangian]]),
            energy: method(&[&[equations.energy]]),
            momenta: method(&[&equations.momenta]),
            mass_matrix: method(&[&equations.mass.concat()]),
            forcing: method(&[&kinetics.forcing]),
            generalized_forces: method(&[&equations.generalized_forces]),
            solved: solution.map(|solution| solution.pivots.len()),
            prepare,
            accelerations,
            relative_pivots: pivots.map(|pivots| method(&[&pivots])),
            inverse_dynamics: method(&[&kinetics.inverse_dynamics]),
            linearize: linearize.schedule(model),
            input_jacobian: input_jacobian.schedule(model),
            directly: linearize.directly,
            energies: energies.map(|energies| energies.map(|energy| method(&[&[energy]]))),
            outputs: method(&[&model.outputs]),
            functions: function_derivatives(model),
        }
    }
}

/// The declared derivatives of all functions from outside.
fn function_derivatives(model: &Model) -> Vec<FunctionDerivative> {
    let mut derivatives = Vec::new();
    for function in model.graph.functions() {
        for argument in 0..model.graph.function_arguments(function).len() {
            if let Some(derivative) = model.graph.declared_derivative(function, argument) {
                derivatives.push(FunctionDerivative {
                    function: function.index(),
                    argument,
                    method: Method::schedule(model, &[&[derivative]]),
                });
            }
        }
    }
    derivatives
}

/// The lower triangle of M, then f.
fn system(system: &LinearSystem) -> Vec<Expression> {
    mass_lower(system)
        .chain(system.forcing.iter().copied())
        .collect()
}

/// The lower triangle of M, row by row.
fn mass_lower(system: &LinearSystem) -> impl Iterator<Item = Expression> + '_ {
    let rows = system.mass.iter().enumerate();
    rows.flat_map(|(i, row)| row[..=i].iter().copied())
}

/// Derivatives of the accelerations, and what has to be computed before.
struct Derivatives {
    /// Whether the columns are solved for before any number is known.
    directly: bool,
    groups: Vec<Vec<Expression>>,
    right_hand_sides: usize,
}

impl Derivatives {
    /// By q, q̇ and t.
    fn of_state(model: &mut Model, kinetics: &Kinetics) -> Self {
        let symbols = state_symbols(model);
        let solved = solved(model, kinetics, &symbols);
        let residuals = columns(model, residuals(kinetics, solved.is_some()), &symbols);
        let before = match (&solved, &kinetics.solution) {
            (Some(_), Some(solution)) => [&*solution.pivots, &solution.accelerations].concat(),
            _ => system(&kinetics.system),
        };
        Self::new(before, solved, residuals, symbols.len() + 1)
    }

    /// By the inputs: the momenta are free of them, so that no input acts on M q̈, however it is spelt.
    fn of_inputs(model: &mut Model, kinetics: &Kinetics) -> Self {
        let symbols = model.input_symbols();
        let solved = solved(model, kinetics, &symbols);
        let solved = solved.map(|columns| without_accelerations(model, &columns));
        let residuals = columns(model, residuals(kinetics, solved.is_some()), &symbols);
        let residuals = without_accelerations(model, &residuals);
        let before = match (&solved, &kinetics.solution) {
            (Some(_), Some(solution)) => solution.pivots.clone(),
            _ => mass_lower(&kinetics.system).collect(),
        };
        Self::new(before, solved, residuals, symbols.len())
    }

    fn new(
        before: Vec<Expression>,
        solved: Option<Vec<Expression>>,
        residuals: Vec<Expression>,
        right_hand_sides: usize,
    ) -> Self {
        let directly = solved.is_some();
        let mut groups = vec![before];
        groups.extend(solved);
        groups.push(residuals);
        Self {
            directly,
            groups,
            right_hand_sides,
        }
    }

    fn schedule(&self, model: &Model) -> Method {
        let groups: Vec<&[Expression]> = self.groups.iter().map(Vec::as_slice).collect();
        let method = Method::schedule(model, &groups);
        if self.directly {
            return method;
        }
        method.with_solution(model.coordinates as usize, self.right_hand_sides)
    }
}

/// What is differentiated to be solved for in numbers: in place of columns that are known, for M as it
/// stands where a pivot is not positive; nothing where no pivot can fail.
fn residuals(kinetics: &Kinetics, solved: bool) -> &[Expression] {
    match &kinetics.solution {
        Some(solution) if solved && solution.pivots.is_empty() => &[],
        _ if solved => &kinetics.inverse_dynamics,
        _ => &kinetics.system.residuals,
    }
}

/// The columns of ∂q̈/∂x, where they are solved for before any number is known.
fn solved(model: &mut Model, kinetics: &Kinetics, symbols: &[Symbol]) -> Option<Vec<Expression>> {
    let solution = kinetics.solution.as_ref()?;
    solution.derivatives(&mut model.graph, &kinetics.inverse_dynamics, symbols)
}

impl Methods {
    /// The number of pivots on which derivatives depend that are solved for before any number is known.
    pub(crate) fn pivots_of_derivatives(&self) -> Option<usize> {
        self.solved.filter(|_| self.directly)
    }

    /// A constant that `f64` cannot hold, if there is one: beyond its range, or lost below it.
    pub(crate) fn unrepresentable(&self) -> Option<&Rational> {
        self.every()
            .flat_map(|method| method.program.constants())
            .find(|number| !in_range(number))
    }

    /// Derivatives of functions from outside that are needed and not declared, by the positions of function
    /// and argument, and what needs them.
    pub(crate) fn undeclared(&self, graph: &Graph) -> BTreeMap<(usize, usize), &'static str> {
        let mut undeclared = BTreeMap::new();
        let counted = self.all().map(|(name, method)| match name {
            "linearize" => (method, "the derivatives of the accelerations need"),
            _ => (method, "the equations of motion need"),
        });
        let needs = counted.into_iter().chain([
            (
                &self.input_jacobian,
                "the derivatives of the accelerations need",
            ),
            (&self.outputs, "an output needs"),
        ]);
        for (method, needs) in needs {
            for function in method.program.functions() {
                if let Some(missing) = first_undeclared(graph, function) {
                    undeclared.entry(missing).or_insert(needs);
                }
            }
        }
        undeclared
    }

    fn every(&self) -> impl Iterator<Item = &Method> {
        let energies = self.energies.iter().flatten();
        let counted = self.all().map(|(_, method)| method);
        let others = [&self.input_jacobian, &self.outputs];
        let derivatives = self.functions.iter().map(|derivative| &derivative.method);
        let methods = counted.into_iter().chain(others).chain(energies);
        methods.chain(&self.relative_pivots).chain(derivatives)
    }
}

/// The declared function, and its argument, whose derivative `function` is or is made of, if that was not
/// declared.
fn first_undeclared(graph: &Graph, mut function: Function) -> Option<(usize, usize)> {
    let mut found = None;
    while let Some((of, argument)) = graph.undeclared(function) {
        found = Some((of.index(), argument));
        function = of;
    }
    found
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
        Self { program, count }
    }

    /// What depends on the parameters alone, and the rest.
    fn prepared(model: &Model, outputs: &[Expression]) -> [Self; 2] {
        let whole = Program::schedule_for_preparation(&model.graph, &[outputs]);
        let Prepared { before, after } = whole.parted(model.graph.passes);
        [before, after].map(|program| Self {
            count: program.count(),
            program,
        })
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
fn columns(model: &mut Model, residuals: &[Expression], symbols: &[Symbol]) -> Vec<Expression> {
    model.graph.jacobian(residuals, symbols).concat()
}
