//! The function that differentiates the accelerations by the state.

use lagrangian_symbolic::{Operand, Rational};

use super::Export;
use super::body::{Body, Unneeded};
use super::methods::are_positive;
use crate::plan::{
    DerivativeOutputs, LowerTriangle, Method, OutputSlice, ParameterSource, Residuals,
    StateJacobian,
};

/// The matrices of the derivatives by q and by q̇, and the vector of those by t.
const PARTS: [&str; 3] = ["position", "velocity", "time"];

impl Export<'_> {
    /// The function for the derivatives by q, q̇ and t, whether columns were differentiated together or one by one.
    pub(super) fn linearization(
        &self,
        method: &Method,
        outputs: &DerivativeOutputs<StateJacobian>,
    ) -> String {
        let reads = self.body(method, &[]).reads_accelerations();
        let body = match outputs {
            DerivativeOutputs::Symbolic {
                pivots,
                accelerations,
                derivatives,
                residuals,
            } => {
                let accelerations = accelerations.as_ref();
                let mut body = self.body(method, unless(reads, accelerations).as_slice());
                let pivots = self.pivots(&mut body, pivots, accelerations);
                let residuals = residuals.as_ref().filter(|_| !pivots.is_empty());
                self.derivatives(&mut body, method, &pivots, (derivatives, residuals));
                body
            }
            DerivativeOutputs::Numerical {
                mass,
                forcing,
                residuals,
            } => {
                let forcing = forcing.as_ref();
                let mut body = self.body(method, unless(reads, forcing).as_slice());
                self.system(&mut body, mass, forcing);
                self.solved(&mut body, method, residuals);
                body
            }
        };
        body.into_function(
            "static void $_linearize_at(const $_point *at, double *position, double *velocity, double *time)",
        )
    }

    /// Computes pivots, and the accelerations if derivatives read them.
    pub(super) fn pivots(
        &self,
        body: &mut Body<'_>,
        pivots: &OutputSlice,
        accelerations: Option<&OutputSlice>,
    ) -> Vec<String> {
        let pivots = body.compute(pivots);
        if let Some(accelerations) = accelerations.filter(|_| body.reads_accelerations()) {
            let accelerations = body.compute(accelerations);
            body.line(&format!("double a[{}];", self.emitter.unknowns()));
            let found = (&pivots[..], accelerations);
            self.if_positive(body, "a", found, ParameterSource::Fields);
        }
        pivots
    }

    /// Computes factors, and the accelerations if derivatives read them.
    pub(super) fn system(
        &self,
        body: &mut Body<'_>,
        mass: &LowerTriangle,
        forcing: Option<&OutputSlice>,
    ) {
        self.factors(body, mass, ParameterSource::Fields);
        if let Some(forcing) = forcing.filter(|_| body.reads_accelerations()) {
            let forcing = body.compute(forcing);
            body.line(&format!("double a[{}];", self.emitter.unknowns()));
            body.assign("a", forcing.into_iter().enumerate());
            body.line("$_solve(&factors, a);");
        }
    }

    /// Writes the derivatives where all pivots are positive, and elsewhere what is solved for numerically.
    fn derivatives(
        &self,
        body: &mut Body<'_>,
        method: &Method,
        pivots: &[String],
        (derivatives, residuals): (&StateJacobian, Option<&Residuals<StateJacobian>>),
    ) {
        // What both ways read is computed before them.
        let columns = [
            &derivatives.position,
            &derivatives.velocity,
            &derivatives.time,
        ];
        let columns = columns.map(|slice| body.compute(slice));
        let Some(residuals) = residuals else {
            return self.columns(body, columns);
        };
        body.line(&format!("if ({}) {{", are_positive(pivots)));
        self.columns(body, columns);
        body.line("} else {");
        self.factors_by_methods(body, ParameterSource::Fields);
        self.solved_beside(body, method, residuals);
        body.line("}");
    }

    /// Writes the derivatives themselves.
    fn columns(&self, body: &mut Body<'_>, columns: [Vec<String>; 3]) {
        let n = self.emitter.coordinates();
        for (part, elements) in PARTS.into_iter().zip(columns) {
            let width = (elements.len() / n.max(1)).max(1);
            let elements = elements.into_iter().enumerate();
            body.assign(
                part,
                elements.map(|(i, value)| ((i % n) * width + i / n, value)),
            );
        }
    }

    /// Writes −M⁻¹ times the derivatives of M q̈ − f.
    fn solved(&self, body: &mut Body<'_>, method: &Method, residuals: &StateJacobian) {
        let n = self.emitter.coordinates();
        body.line(&format!("double column[{n}];"));
        body.line("int i;");
        let parts = [&residuals.position, &residuals.velocity];
        for (part, slice) in PARTS.into_iter().zip(parts) {
            let elements = body.compute(slice);
            for (j, column) in elements.chunks(n).enumerate() {
                self.solved_column(body, column, &format!("{part}[i * {n} + {j}]"));
            }
        }
        let zero = Operand::Constant(Rational::ZERO);
        let mut of_time = residuals.time.operands(&method.program).iter();
        if of_time.any(|output| *output != zero) {
            let time = body.compute(&residuals.time);
            self.solved_column(body, &time, "time[i]");
        } else {
            self.each_row(body, "time[i] = 0.0;");
        }
    }

    pub(super) fn solved_column(&self, body: &mut Body<'_>, column: &[String], place: &str) {
        body.assign("column", column.iter().cloned().enumerate());
        body.line("$_solve(&factors, column);");
        self.each_row(body, &format!("{place} = -column[i];"));
    }

    fn each_row(&self, body: &mut Body<'_>, statement: &str) {
        body.line(&format!(
            "for (i = 0; i < {}; ++i) {{",
            self.emitter.coordinates()
        ));
        body.line(statement);
        body.line("}");
    }

    /// Writes −M⁻¹ times the derivatives of M q̈ − f, where a method returns these and the derivatives of q̈.
    fn solved_beside(
        &self,
        body: &mut Body<'_>,
        method: &Method,
        residuals: &Residuals<StateJacobian>,
    ) {
        let variation = match residuals {
            Residuals::Columns(columns) => return self.solved(body, method, columns),
            Residuals::AlongVariation(variation) => variation,
        };
        let n = self.emitter.coordinates();
        body.line("int i, j;");
        body.line(&format!("for (j = 0; j < {}; ++j) {{", 2 * n + 1));
        body.line(&format!(
            "double delta[{}] = {{0.0}}, column[{n}];",
            2 * n + 1
        ));
        body.line("delta[j] = 1.0;");
        let column = body.compute(variation);
        self.solved_column(body, &column, &place_of_state(n));
        body.line("}");
    }
}

/// The element in row i of the column with the number j: of q, of the velocities, or of the time.
pub(super) fn place_of_state(n: usize) -> String {
    let of_time = 2 * n;
    format!(
        "*(j < {n} ? &position[i * {n} + j] : j < {of_time} ? &velocity[i * {n} + j - {n}] : &time[i])"
    )
}

/// Outputs that are not needed, unless accelerations are read.
pub(super) fn unless(reads: bool, slice: Option<&OutputSlice>) -> Option<Unneeded<'_>> {
    let slice = slice.filter(|_| !reads)?;
    Some((slice, &|_| true))
}
