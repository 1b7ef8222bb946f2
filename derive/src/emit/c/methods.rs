//! The functions that evaluate the programs of a model at a point, `static` and written like its methods in Rust.

use super::Export;
use super::body::{Body, Unneeded};
use super::structs::{Field, place};
use crate::plan::{
    AccelerationOutputs, Columns, EmittedMethod, LowerTriangle, Method, MethodOutputs, OutputSlice,
    ParameterSource,
};
use crate::syntax::shape::Shape;

impl Export<'_> {
    /// The methods whose functions compute what is factored and what is solved for, each behind those that it calls.
    pub(super) const OF_FACTORS: [EmittedMethod; 8] = [
        EmittedMethod::Momenta,
        EmittedMethod::MassMatrix,
        EmittedMethod::Forcing,
        EmittedMethod::ConstraintJacobian,
        EmittedMethod::ConstraintRates,
        EmittedMethod::ConstraintPositions,
        EmittedMethod::ConstraintVelocities,
        EmittedMethod::Compliances,
    ];

    /// The methods whose functions may call the one that factors, each behind those that it calls.
    pub(super) const BEHIND_FACTORS: [EmittedMethod; 10] = [
        EmittedMethod::Accelerations,
        EmittedMethod::InverseDynamics,
        EmittedMethod::Linearize,
        EmittedMethod::InputJacobian,
        EmittedMethod::Sensitivities,
        EmittedMethod::Energy,
        EmittedMethod::KineticEnergy,
        EmittedMethod::PotentialEnergy,
        EmittedMethod::Outputs,
        EmittedMethod::EventFunctions,
    ];

    /// The function that computes what depends on parameters alone.
    pub(super) fn prepare(&self) -> String {
        let method = &self.emitter.methods.prepare;
        let MethodOutputs::Invariants(invariants) = &method.outputs else {
            return String::new();
        };
        let mut body = self.body(method, &[]);
        let values = body.compute(invariants);
        body.assign("x", values.into_iter().enumerate());
        let parameters = self.with_parameters("const $_parameters *p, ");
        body.into_function(&format!("static void $_prepare({parameters}double *x)"))
    }

    /// The function of a method, if the model has it.
    pub(super) fn method(&self, emitted: EmittedMethod) -> Option<String> {
        if let Some(function) = self.along_variation(emitted) {
            return Some(function);
        }
        let method = self.emitter.methods.get(emitted)?;
        let name = emitted.row().name;
        let function = match &method.outputs {
            MethodOutputs::Scalar(value) => {
                let mut body = self.body(method, &[]);
                self.find_accelerations(&mut body);
                let value = body.compute(value).concat();
                body.line(&format!("return {value};"));
                body.into_function(&format!("static double $_{name}_at(const $_point *at)"))
            }
            MethodOutputs::Vector(slice) | MethodOutputs::Events(slice) => {
                self.array(emitted, method, (slice, 1))
            }
            MethodOutputs::SquareMatrix(slice) | MethodOutputs::ConstraintJacobian(slice) => {
                self.array(emitted, method, (slice, self.emitter.coordinates()))
            }
            MethodOutputs::Accelerations(outputs) => self.accelerations(method, outputs),
            MethodOutputs::Declared(outputs) => self.declared(method, outputs),
            MethodOutputs::Linearization(outputs) => self.linearization(method, outputs),
            MethodOutputs::InputJacobian(outputs) => {
                let inputs = self.emitter.model.inputs as usize;
                self.derivatives_by(name, method, outputs, inputs)
            }
            MethodOutputs::Sensitivities(outputs) => {
                let parameters = self.sensitive_parameters().len();
                self.derivatives_by(name, method, outputs, parameters)
            }
            MethodOutputs::ByColumns(Columns::MassMatrix) => self.mass_matrix_by_columns(),
            _ => return None,
        };
        Some(function)
    }

    /// The function of a program, of which some outputs may not be needed.
    pub(super) fn body<'b>(&'b self, method: &'b Method, unneeded: &[Unneeded<'_>]) -> Body<'b> {
        let passes = self.emitter.model.graph.passes;
        let (locals, reads) = (self.emitter.locals(), &self.parameters.reads);
        Body::new(&method.program, (passes, &locals), reads, unneeded)
    }

    /// The function of a method that returns a vector, or a matrix with so many columns from its elements column by column.
    fn array(
        &self,
        emitted: EmittedMethod,
        method: &Method,
        (slice, columns): (&OutputSlice, usize),
    ) -> String {
        let mut body = self.body(method, &[]);
        let takes_accelerations = emitted == EmittedMethod::InverseDynamics;
        if !takes_accelerations {
            self.find_accelerations(&mut body);
        }
        let values = body.compute(slice);
        let rows = (values.len() / columns.max(1)).max(1);
        let values = values.into_iter().enumerate();
        let by_rows = values.map(|(i, value)| ((i % rows) * columns + i / rows, value));
        body.assign("x", by_rows);
        let accelerations = if takes_accelerations {
            "const double *a, "
        } else {
            ""
        };
        let name = emitted.row().name;
        body.into_function(&format!(
            "static void $_{name}_at(const $_point *at, {accelerations}double *x)"
        ))
    }

    /// Computes the accelerations and multipliers that the program of a body reads.
    fn find_accelerations(&self, body: &mut Body<'_>) {
        if body.reads_accelerations() {
            body.line(&format!("double a[{}];", self.emitter.unknowns()));
            body.line("$_accelerations_at(at, a);");
        }
    }

    fn accelerations(&self, method: &Method, outputs: &AccelerationOutputs) -> String {
        let mut body = self.body(method, &[]);
        match outputs {
            AccelerationOutputs::Symbolic {
                pivots,
                accelerations,
            } => {
                let pivots = body.compute(pivots);
                let accelerations = body.compute(accelerations);
                self.if_positive(
                    &mut body,
                    "x",
                    (&pivots, accelerations),
                    ParameterSource::Prepared,
                );
            }
            AccelerationOutputs::Numerical { mass, forcing } => {
                self.factors(&mut body, mass, ParameterSource::Prepared);
                let forcing = body.compute(forcing);
                body.assign("x", forcing.into_iter().enumerate());
                body.line("$_solve(&factors, x);");
            }
        }
        body.into_function("static void $_accelerations_at(const $_point *at, double *x)")
    }

    /// Writes to an array accelerations, with multipliers behind, where all pivots are positive; elsewhere they are solved for numerically.
    pub(super) fn if_positive(
        &self,
        body: &mut Body<'_>,
        array: &str,
        (pivots, accelerations): (&[String], Vec<String>),
        source: ParameterSource,
    ) {
        if pivots.is_empty() {
            body.assign(array, accelerations.into_iter().enumerate());
            return;
        }
        body.line(&format!("if ({}) {{", are_positive(pivots)));
        body.assign(array, accelerations.into_iter().enumerate());
        body.line("} else {");
        self.factors_by_methods(body, source);
        body.line(&format!("$_forcing_at(at, {array});"));
        if self.emitter.is_constrained() {
            let n = self.emitter.coordinates();
            body.line(&format!("$_constraint_rates_at(at, {array} + {n});"));
        }
        body.line(&format!("$_solve(&factors, {array});"));
        body.line("}");
    }

    /// The factors of M, or of the saddle point problem, by other methods.
    pub(super) fn factors_by_methods(&self, body: &mut Body<'_>, source: ParameterSource) {
        body.line("$_factors factors;");
        let compliances = self.compliances(body, source);
        body.line(&format!("$_factor_at(at{compliances}, &factors);"));
    }

    /// The factors of a matrix, of which a program computes the lower triangle.
    pub(super) fn factors(
        &self,
        body: &mut Body<'_>,
        mass: &LowerTriangle,
        source: ParameterSource,
    ) {
        let k = self.emitter.unknowns();
        let lower = body.compute(&mass.0);
        body.line("$_factors factors;");
        body.line(&format!("double m[{}] = {{0.0}};", k * k));
        let entries = (0..k).flat_map(|row| (0..=row).map(move |column| (row, column)));
        let entries = entries.filter_map(|(row, column)| {
            let entry = lower.get(LowerTriangle::position(row, column))?;
            Some((row * k + column, entry.clone()))
        });
        body.assign("m", entries.collect::<Vec<_>>());
        let compliances = self.compliances(body, source);
        body.line(&format!("$_factor(m{compliances}, &factors);"));
    }

    /// The argument for the compliances of constraints; none without constraints.
    fn compliances(&self, body: &mut Body<'_>, source: ParameterSource) -> &'static str {
        let is_declared = self.has(EmittedMethod::Compliances);
        match source {
            _ if !self.is_constrained() => "",
            ParameterSource::Prepared if is_declared => {
                body.line(&format!(
                    "double compliances[{}];",
                    self.emitter.constraint_count()
                ));
                body.line("$_compliances_at(at, compliances);");
                ", compliances"
            }
            _ => ", NULL",
        }
    }

    /// The function that factors M, or the matrix of the saddle point problem, which other functions compute.
    pub(super) fn factor_at(&self) -> String {
        let (n, c, k) = (
            self.emitter.coordinates(),
            self.emitter.constraint_count(),
            self.emitter.unknowns(),
        );
        if c == 0 {
            return format!(
                "/* Factors the mass matrix at a point. */\n\
                 static void $_factor_at(const $_point *at, $_factors *factors)\n\
                 {{\n    double m[{}];\n    $_mass_matrix_at(at, m);\n    $_factor(m, factors);\n}}\n",
                n * n
            );
        }
        format!(
            "/* Factors the matrix of the saddle point problem at a point. */\n\
             static void $_factor_at(const $_point *at, const double *compliances, $_factors *factors)\n\
             {{\n\
             \x20   double mass[{nn}], jacobian[{cn}], m[{kk}] = {{0.0}};\n\
             \x20   int i, j;\n\
             \x20   $_mass_matrix_at(at, mass);\n\
             \x20   $_constraint_jacobian_at(at, jacobian);\n\
             \x20   for (i = 0; i < {n}; ++i) {{\n\
             \x20       for (j = 0; j < {n}; ++j) {{\n\
             \x20           m[i * {k} + j] = mass[i * {n} + j];\n\
             \x20       }}\n\
             \x20   }}\n\
             \x20   for (i = 0; i < {c}; ++i) {{\n\
             \x20       for (j = 0; j < {n}; ++j) {{\n\
             \x20           m[({n} + i) * {k} + j] = -jacobian[i * {n} + j];\n\
             \x20       }}\n\
             \x20   }}\n\
             \x20   $_factor(m, compliances, factors);\n\
             }}\n",
            nn = n * n,
            cn = c * n,
            kk = k * k
        )
    }

    /// The columns of M are the momenta at unit velocities less those at rest.
    fn mass_matrix_by_columns(&self) -> String {
        let n = self.emitter.coordinates();
        format!(
            "static void $_mass_matrix_at(const $_point *at, double *x)\n\
             {{\n\
             \x20   $_point moving = *at;\n\
             \x20   double v[{n}] = {{0.0}}, at_rest[{n}], column[{n}];\n\
             \x20   int i, j;\n\
             \x20   moving.v = v;\n\
             \x20   $_momenta_at(&moving, at_rest);\n\
             \x20   for (j = 0; j < {n}; ++j) {{\n\
             \x20       v[j] = 1.0;\n\
             \x20       $_momenta_at(&moving, column);\n\
             \x20       v[j] = 0.0;\n\
             \x20       for (i = j; i < {n}; ++i) {{\n\
             \x20           x[i * {n} + j] = column[i] - at_rest[i];\n\
             \x20           x[j * {n} + i] = x[i * {n} + j];\n\
             \x20       }}\n\
             \x20   }}\n\
             }}\n"
        )
    }

    fn declared(&self, method: &Method, outputs: &[(Shape, OutputSlice)]) -> String {
        if outputs.is_empty() {
            return String::new();
        }
        let mut body = self.body(method, &[]);
        self.find_accelerations(&mut body);
        let fields = Field::of_outputs(self.emitter);
        for (field, (shape, slice)) in fields.iter().zip(outputs) {
            let values = body.compute(slice);
            for (i, value) in values.into_iter().enumerate() {
                body.line(&format!("x->{}{} = {value};", field.name, place(*shape, i)));
            }
        }
        body.into_function("static void $_outputs_at(const $_point *at, $_outputs *x)")
    }
}

/// The condition that all pivots are positive.
pub(super) fn are_positive(pivots: &[String]) -> String {
    let conditions: Vec<String> = pivots
        .iter()
        .map(|pivot| format!("{pivot} > 0.0"))
        .collect();
    conditions.join(" && ")
}
