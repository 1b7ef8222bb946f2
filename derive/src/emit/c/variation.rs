//! The functions that differentiate the accelerations one direction after the other, where the methods in Rust do so on dual
//! numbers: δx = −A⁻¹ δ(A x − b), where A x = b are the equations of motion.

use super::Export;
use super::body::Body;
use super::derivatives::place_of_state;
use crate::plan::{EmittedMethod, Method, MethodOutputs};

impl Export<'_> {
    /// The function of a method that differentiates so, if it does.
    pub(super) fn along_variation(&self, emitted: EmittedMethod) -> Option<String> {
        let methods = self.emitter.methods.variation.as_ref()?;
        let (n, inputs) = (
            self.emitter.coordinates(),
            self.emitter.model.inputs as usize,
        );
        match emitted {
            EmittedMethod::Linearize => Some(self.solved_along(
                &methods.state,
                (2 * n + 1, &place_of_state(n)),
                "static void $_linearize_at(const $_point *at, double *position, double *velocity, double *time)",
            )),
            EmittedMethod::InputJacobian => methods.inputs.as_ref().map(|method| {
                self.solved_along(
                    method,
                    (inputs, &format!("x[i * {inputs} + j]")),
                    "static void $_input_jacobian_at(const $_point *at, double *x)",
                )
            }),
            _ => None,
        }
    }

    /// The function that writes so many columns, where the element in row i of column j has this place.
    fn solved_along(
        &self,
        method: &Method,
        (count, place): (usize, &str),
        signature: &str,
    ) -> String {
        let mut body = self.body(method, &[]);
        let MethodOutputs::Vector(residuals) = &method.outputs else {
            return String::new();
        };
        let k = self.emitter.unknowns();
        body.line("$_factors factors;");
        body.line(&format!("double column[{k}];"));
        body.line("int i, j;");
        self.unknowns_along(&mut body);
        body.compute_without_variation();
        body.line(&format!("for (j = 0; j < {count}; ++j) {{"));
        body.line(&format!("double delta[{count}] = {{0.0}};"));
        body.line("delta[j] = 1.0;");
        let column = body.compute(residuals);
        if !body.reads_variation() {
            body.line("(void)delta;");
        }
        self.solved_column(&mut body, &column, place);
        body.line("}");
        body.into_function(signature)
    }

    /// Computes the factors, and the accelerations and multipliers. The multipliers of dependent constraints are zero, as on dual
    /// numbers in Rust.
    fn unknowns_along(&self, body: &mut Body<'_>) {
        let (n, k) = (self.emitter.coordinates(), self.emitter.unknowns());
        let reads = body.reads_accelerations();
        if reads {
            body.line(&format!("double a[{k}];"));
        }
        if !self.is_constrained() {
            body.line("$_factor_at(at, &factors);");
            if reads {
                body.line("$_accelerations_at(at, a);");
            }
            return;
        }
        body.line("$_factor_at(at, NULL, &factors);");
        if reads {
            body.line("$_forcing_at(at, a);");
            body.line(&format!("$_constraint_rates_at(at, a + {n});"));
            body.line("$_solve_independent(&factors, a);");
        }
    }
}
