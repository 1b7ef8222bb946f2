//! The model as external functions of `CasADi`.
//!
//! J. A. E. Andersson, J. Gillis, G. Horn, J. B. Rawlings & M. Diehl, *`CasADi`: a software framework for nonlinear optimization and
//! optimal control*, Math. Prog. Comp. **11** (2019) 1–36.

use super::Export;
use crate::plan::EmittedMethod;

const DYNAMICS: &str = include_str!("library/casadi.c");
const LINEAR_MODEL: &str = include_str!("library/casadi_linear_model.c");

impl Export<'_> {
    /// The source of the external functions.
    pub(super) fn casadi(&self) -> String {
        let has_linear_model = self.has(EmittedMethod::Linearize);
        let linear_model = if has_linear_model { LINEAR_MODEL } else { "" };
        let parameters = if self.parameters.is_empty() {
            ""
        } else {
            "(const $_parameters *)at.p, "
        };
        let has_inputs = self.emitter.has_inputs();
        let inputs = if has_inputs { ", at.u" } else { "" };
        let multipliers = if self.is_constrained() { ", NULL" } else { "" };
        let text = format!("{DYNAMICS}{linear_model}")
            .replace(
                "@POINT",
                &format!("{parameters}at.t, at.x, at.x + @N{inputs}"),
            )
            .replace("@MULTIPLIERS", multipliers)
            .replace("@INPUTS", if has_inputs { "b, " } else { "" })
            .replace("@Q", &self.parameters.numbers().to_string());
        self.filled(&text)
    }
}
