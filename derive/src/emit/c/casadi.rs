//! The model as external functions of `CasADi`.
//!
//! J. A. E. Andersson, J. Gillis, G. Horn, J. B. Rawlings & M. Diehl, *`CasADi`: a software framework for nonlinear optimization and
//! optimal control*, Math. Prog. Comp. **11** (2019) 1–36.

use lagrangian_symbolic::Symbol;

use super::{Export, WIDTH};

const DYNAMICS: &str = include_str!("library/casadi.c");
const LINEAR_MODEL: &str = include_str!("library/casadi_linear_model.c");
const BY_PARAMETERS: [&str; 4] = [
    include_str!("library/casadi_by_parameters.c"),
    include_str!("library/casadi_sensitivities.c"),
    include_str!("library/casadi_differences.c"),
    "}\n",
];
const JACOBIAN: &str = include_str!("library/casadi_jacobian.c");

impl Export<'_> {
    /// The source of the external functions.
    pub(super) fn casadi(&self) -> String {
        let parameters = if self.parameters.is_empty() {
            ""
        } else {
            "(const $_parameters *)at.p, "
        };
        let has_inputs = self.emitter.has_inputs();
        let inputs = if has_inputs { ", at.u" } else { "" };
        let multipliers = if self.is_constrained() { ", NULL" } else { "" };
        let [known, differenced] = self.parameters_by_derivatives();
        let [beginning, sensitivities, differences, end] = BY_PARAMETERS;
        let mut by_parameters = beginning.to_owned();
        if !known.is_empty() {
            by_parameters += &sensitivities.replace("@PLACES", &places(&known));
        }
        if !differenced.is_empty() {
            let differences = differences.replace("@PLACES", &places(&differenced));
            by_parameters += &differences.replace("@ARRAYS", &arrays(&differenced));
        }
        by_parameters += end;
        let text = format!("{DYNAMICS}{LINEAR_MODEL}{by_parameters}{JACOBIAN}")
            .replace(
                "@POINT",
                &format!("{parameters}at.t, at.x, at.x + @N{inputs}"),
            )
            .replace("@MULTIPLIERS", multipliers)
            .replace("@INPUTS", if has_inputs { "b, " } else { "" })
            .replace("@Q", &self.parameters.numbers().to_string())
            .replace("@S", &known.len().to_string())
            .replace("@D", &differenced.len().to_string());
        self.filled(&text)
    }

    /// The members of the struct of parameters by which `_sensitivities` differentiates, in its order, and the others.
    fn parameters_by_derivatives(&self) -> [Vec<&str>; 2] {
        let reads = self.parameters.reads.iter();
        let members = reads.map(|read| read.strip_prefix("p->").unwrap_or(read));
        let members: Vec<&str> = members.collect();
        let known = self.sensitive_parameters().iter();
        let known = known.filter_map(|symbol| match symbol {
            Symbol::Parameter(i) => members.get(*i as usize).copied(),
            _ => None,
        });
        let known: Vec<&str> = known.collect();
        let others = members.iter().filter(|member| !known.contains(member));
        let others = others.copied().collect();
        [known, others]
    }
}

/// The places of members in the struct of parameters.
fn places(members: &[&str]) -> String {
    let places = members.iter();
    in_lines(places.map(|member| format!("offsetof($_parameters, {member}) / sizeof(double),")))
}

/// A number for each member, which elements of one array have in common.
fn arrays(members: &[&str]) -> String {
    let array = |member: &&str| member.split('[').next().map(str::to_owned);
    let runs = members.chunk_by(|x, y| array(x) == array(y)).enumerate();
    in_lines(runs.flat_map(|(number, run)| run.iter().map(move |_| format!("{number},"))))
}

fn in_lines(elements: impl Iterator<Item = String>) -> String {
    let mut text = String::new();
    let mut length = 0;
    for place in elements {
        if length + place.len() > WIDTH - 20 {
            text.push_str("\n        ");
            length = 0;
        } else if length > 0 {
            text.push(' ');
        }
        length += place.len() + 1;
        text.push_str(&place);
    }
    text.trim_end_matches(',').to_owned()
}
