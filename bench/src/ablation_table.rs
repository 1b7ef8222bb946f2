//! The tables of the ablation, as they stand in the documentation.

use std::fmt::Write as _;

use lagrangian_bench::Operations;
use lagrangian_symbolic::OperationCount;

use crate::ablation::{Ablation, Figures};
use crate::passes::Off;

/// What `accelerations` cost without each pass, and how they round.
pub(crate) fn tables(ablations: &[Ablation]) -> String {
    let costs = table(ablations, |figures| {
        let total = figures.operations.total;
        let cost = cost(figures.operations);
        format!("{total} / {cost} / {:.1}", figures.nanoseconds)
    });
    let rounding = table(ablations, |figures| format!("{:.2}", figures.rounding));
    format!(
        "Operations / their cost / nanoseconds of `accelerations`:\n\n{costs}\n\
         Rounding error of `accelerations`, in units of the precision:\n\n{rounding}"
    )
}

/// A line for each variant and a column for each model; `=` where the program is that of all passes.
fn table(ablations: &[Ablation], cell: impl Fn(&Figures) -> String) -> String {
    let mut table = String::from("| without |");
    for ablation in ablations {
        let _ = write!(table, " {} |", ablation.model);
    }
    table += "\n|---|";
    table += &"---|".repeat(ablations.len());
    table.push('\n');
    for (line, off) in Off::all().enumerate() {
        let _ = write!(table, "| {} |", off.label());
        for ablation in ablations {
            let figures = ablation.figures[line].as_ref();
            let cell = figures.map_or_else(|| "=".to_owned(), &cell);
            let _ = write!(table, " {cell} |");
        }
        table.push('\n');
    }
    table
}

/// What operations cost by the derivation's own model.
fn cost(operations: Operations) -> usize {
    let count = OperationCount {
        additions: operations.additions,
        multiplications: operations.multiplications,
        divisions: operations.divisions,
        square_roots: operations.square_roots,
        sines_and_cosines: operations.sines_and_cosines,
        functions: operations.functions,
    };
    count.cost()
}
