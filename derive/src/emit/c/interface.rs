//! The functions that the header declares.

use super::Export;
use crate::plan::EmittedMethod;

/// A function of the header.
pub(super) struct Function {
    name: &'static str,
    ty: &'static str,
    /// What follows the parameters, the time, the state and the inputs.
    arguments: String,
    pub(super) documentation: String,
    /// The statements.
    statements: Vec<String>,
    /// Whether it changes the state.
    moves: bool,
}

impl Function {
    fn new(name: &'static str, arguments: &str, documentation: &str, statements: &[&str]) -> Self {
        Self {
            name,
            ty: "void",
            arguments: arguments.to_owned(),
            documentation: documentation.to_owned(),
            statements: statements.iter().map(|line| (*line).to_owned()).collect(),
            moves: false,
        }
    }

    fn scalar(name: &'static str, documentation: &str) -> Self {
        let statement = format!("return $_{name}_at(&at);");
        let mut function = Self::new(name, "", documentation, &[&statement]);
        function.ty = "double";
        function
    }

    fn moving(mut self) -> Self {
        self.moves = true;
        self
    }
}

impl Export<'_> {
    /// The functions of the header, in order.
    pub(super) fn functions(&self) -> Vec<Function> {
        let mut functions = vec![self.accelerations_of_header()];
        functions.push(Function::new(
            "inverse_dynamics",
            "const double *accelerations, double *forces",
            "Computes the generalized forces that must be added to the declared ones, at the inputs, for these accelerations: \
             M a - f.",
            &["$_inverse_dynamics_at(&at, accelerations, forces);"],
        ));
        functions.push(self.linearization_of_header());
        functions.extend(self.sensitivities_of_header());
        if self.is_constrained() {
            functions.push(Function::new(
                "constraint_residuals",
                "double *positions, double *velocities",
                "Computes the residuals of the constraints: of holonomic ones g(q, t), which is 0 for the others, and of all the \
                 velocities w = G v + a.",
                &[
                    "$_constraint_positions_at(&at, positions);",
                    "$_constraint_velocities_at(&at, velocities);",
                ],
            ));
        }
        functions.extend(self.observations_of_header());
        if self.is_constrained() {
            functions.push(
                Function::new(
                    "project",
                    "",
                    "Projects coordinates and velocities onto the constraints in the metric of M, in place. It does not check that the \
                     iteration has converged.",
                    &["$_project_at(&at, q, v);"],
                )
                .moving(),
            );
        }
        functions.push(self.step_of_header().moving());
        functions
    }

    /// The functions for outputs, events and energies.
    fn observations_of_header(&self) -> Vec<Function> {
        let mut functions = Vec::new();
        if !self.outputs.is_empty() {
            functions.push(Function::new(
                "compute_outputs",
                "$_outputs *outputs",
                "Computes the declared outputs.",
                &["$_outputs_at(&at, outputs);"],
            ));
        }
        if self.has(EmittedMethod::EventFunctions) {
            functions.push(Function::new(
                "event_functions",
                "double *values",
                "Computes the event functions, in the order of their declaration.",
                &["$_event_functions_at(&at, values);"],
            ));
        }
        functions.push(Function::scalar(
            "energy",
            "Returns the energy function h = sum of p v, less L; T + V if T is quadratic in the velocities and V free of them.",
        ));
        if self.has(EmittedMethod::KineticEnergy) {
            functions.push(Function::scalar(
                "kinetic_energy",
                "Returns the kinetic energy T.",
            ));
            functions.push(Function::scalar(
                "potential_energy",
                "Returns the potential energy V.",
            ));
        }
        functions
    }

    fn accelerations_of_header(&self) -> Function {
        let (n, k) = (self.emitter.coordinates(), self.emitter.unknowns());
        if !self.is_constrained() {
            return Function::new(
                "accelerations",
                "double *accelerations",
                "Computes the accelerations.",
                &["$_accelerations_at(&at, accelerations);"],
            );
        }
        Function::new(
            "accelerations",
            "double *accelerations, double *multipliers",
            "Computes the accelerations and the multipliers of the constraints, unless these are NULL.",
            &[
                &format!("double x[{k}];"),
                "int i;",
                "$_accelerations_at(&at, x);",
                &format!("for (i = 0; i < {n}; ++i) {{"),
                "    accelerations[i] = x[i];",
                "}",
                &format!("for (i = {n}; multipliers && i < {k}; ++i) {{"),
                &format!("    multipliers[i - {n}] = x[i];"),
                "}",
            ],
        )
    }

    /// The function for linear models.
    fn linearization_of_header(&self) -> Function {
        let (n, m) = (
            self.emitter.coordinates(),
            self.emitter.model.inputs as usize,
        );
        let d = 2 * n;
        let (mut argument, mut inputs) = ("", String::new());
        let mut lines = vec!["$_state_matrix_at(&at, state_matrix, time_derivative);"];
        if m > 0 {
            lines.push("$_input_matrix_at(&at, input_matrix);");
            argument = "double *input_matrix, ";
            inputs = format!(
                " the input matrix B = d(v, a)/du, with {d} rows and {m} columns, row by row: element (i, j) is input_matrix[i * {m} + \
                 j];"
            );
        }
        let constraints = if self.is_constrained() {
            " The accelerations are those under the constraints, as functions of all coordinates and velocities; along directions that \
             the constraints do not allow, derivatives describe no motions."
        } else {
            ""
        };
        Function::new(
            "linearize",
            &format!("double *state_matrix, {argument}double *time_derivative"),
            &format!(
                "Computes the linear model of the first-order system x = (q, v), dx/dt = (v, a): the state matrix A = d(v, a)/dx, with \
                 {d} rows and columns, row by row: element (i, j) is state_matrix[i * {d} + j];{inputs} and the derivatives of the \
                 accelerations by the time. What is NULL is not computed.{constraints}"
            ),
            &lines,
        )
    }

    /// The function for the derivatives by parameters, with the clause `sensitivities`.
    fn sensitivities_of_header(&self) -> Option<Function> {
        let count = self.sensitive_parameters().len();
        (count > 0).then(|| {
            Function::new(
                "sensitivities",
                "double *sensitivities",
                &format!(
                    "Computes the derivatives of the accelerations by {count} parameters, row by row: element (i, j) is \
                     sensitivities[i * {count} + j].",
                ),
                &["$_sensitivities_at(&at, sensitivities);"],
            )
        })
    }

    /// One step of the classical method of Runge and Kutta.
    fn step_of_header(&self) -> Function {
        let n = self.emitter.coordinates();
        let of_constraints = if self.is_constrained() {
            " Behind the step the state is projected onto the constraints, as by `$_project`."
        } else {
            ""
        };
        let end: &[&str] = if self.is_constrained() {
            &["$_end_step(&at, h, q, v, of_q, of_v);"]
        } else {
            &[
                &format!("for (i = 0; i < {n}; ++i) {{"),
                "    q[i] += of_q[i];",
                "    v[i] += of_v[i];",
                "}",
            ]
        };
        let counter: &[&str] = if self.is_constrained() {
            &[]
        } else {
            &["int i;"]
        };
        let increments = [
            &format!("double of_q[{n}], of_v[{n}];"),
            "$_increments(&at, h, of_q, of_v);",
        ];
        Function::new(
            "step",
            "double h",
            &format!(
                "Takes one step of length h by the classical method of Runge and Kutta of order 4, in place, at constant inputs. There \
                 is no error control, and angles are not reduced.{of_constraints}"
            ),
            &[counter, &increments, end].concat(),
        )
    }

    /// The arguments that all functions take, after which others may follow.
    fn arguments(&self, moves: bool) -> String {
        let parameters = self.with_parameters("const $_parameters *p, ");
        let inputs = if self.emitter.has_inputs() {
            ", const double *u"
        } else {
            ""
        };
        let state = if moves { "double" } else { "const double" };
        format!("{parameters}double t, {state} *q, {state} *v{inputs}")
    }

    /// The prototype of a function, without semicolon.
    pub(super) fn prototype(&self, function: &Function) -> String {
        let arguments = self.arguments(function.moves);
        let separator = if function.arguments.is_empty() {
            ""
        } else {
            ", "
        };
        let name = self.filled(&format!("{} $_{}", function.ty, function.name));
        let arguments = self.filled(&format!("{arguments}{separator}{}", function.arguments));
        broken(&format!("{name}({arguments})"))
    }

    /// The definition of a function.
    pub(super) fn definition(&self, function: &Function) -> String {
        let mut lines = vec![
            format!("double z[{}];", self.invariants().max(1)),
            "$_point at;".to_owned(),
        ];
        let (declarations, rest): (Vec<_>, Vec<_>) = function
            .statements
            .iter()
            .filter(|line| !line.is_empty())
            .partition(|line| is_declaration(line));
        lines.extend(declarations.into_iter().cloned());
        let parameters = self.with_parameters("p, ");
        let inputs = if self.emitter.has_inputs() {
            "u"
        } else {
            "NULL"
        };
        lines.push(format!("$_begin(&at, z, {parameters}t, q, v, {inputs});"));
        lines.extend(rest.into_iter().cloned());
        let body = lines.join("\n    ");
        format!("{}\n{{\n    {body}\n}}\n", self.prototype(function))
    }

    /// The function that notes the point at which others are evaluated.
    pub(super) fn begin(&self) -> String {
        let parts = ["const $_parameters *p, ", "    at->p = p;\n", "p, "];
        let [parameter, noted, argument] = parts.map(|part| self.with_parameters(part));
        format!(
            "static void $_begin($_point *at, double *z, {parameter}double t, const double *q, const double *v, const double *u)\n\
             {{\n{noted}    at->z = z;\n    at->t = t;\n    at->q = q;\n    at->v = v;\n    at->u = u;\n    $_prepare({argument}z);\n}}\n"
        )
    }
}

/// Whether a statement outside of blocks declares variables.
fn is_declaration(line: &str) -> bool {
    ["double ", "int ", "static "]
        .iter()
        .any(|ty| line.starts_with(ty))
}

/// A prototype that is broken between arguments where it is too long for a line.
fn broken(prototype: &str) -> String {
    let mut lines = vec![String::new()];
    for argument in prototype.split_inclusive(", ") {
        let length = lines.last().map_or(0, String::len);
        if length > 0 && length + argument.len() > super::WIDTH {
            lines.push("    ".to_owned());
        }
        if let Some(line) = lines.last_mut() {
            line.push_str(argument);
        }
    }
    let lines: Vec<&str> = lines.iter().map(|line| line.trim_end()).collect();
    lines.join("\n")
}
