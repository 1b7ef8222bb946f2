//! The table.

use std::fmt::Write as _;

use crate::comparison::Comparison;
use crate::side::Side;

/// All that was found, and below it our operations by kind.
pub(crate) fn table(comparisons: &[Comparison], empty_seconds: f64) -> String {
    let mut table = String::from(
        "\n                              for this processor, ns    default flags, ns\n\
         model peer                   throughput   latency  throughput   latency  operations  \
         derive, s  compile, s  difference\n",
    );
    for comparison in comparisons {
        for side in &comparison.sides {
            let model = comparison.model.to_string();
            let _ = writeln!(table, "{model:<5} {}", line(side));
        }
    }
    let _ = writeln!(
        table,
        "\nOf our time to compile, a crate without a model takes {empty_seconds:.3} s."
    );
    table.push_str("\nmodel  additions  multiplications  divisions  sines and cosines  together\n");
    for Comparison {
        model, operations, ..
    } in comparisons
    {
        let _ = writeln!(
            table,
            "{:<5} {:>10} {:>16} {:>10} {:>18} {:>9}",
            model.to_string(),
            operations.additions,
            operations.multiplications,
            operations.divisions,
            operations.sines_and_cosines,
            operations.total,
        );
    }
    table
}

fn line(side: &Side) -> String {
    format!(
        "{:<21} {:>12} {:>9} {:>11} {:>9} {:>11} {:>10} {:>11} {:>11}",
        side.name,
        cell(side.native.throughput, nanoseconds),
        cell(side.native.latency, nanoseconds),
        cell(side.default.throughput, nanoseconds),
        cell(side.default.latency, nanoseconds),
        cell(side.operations, |count| count.to_string()),
        cell(side.derive_seconds, seconds),
        cell(side.compile_seconds, seconds),
        cell(side.difference, |difference| format!("{difference:.1e}")),
    )
}

fn cell<T>(value: Option<T>, format: impl Fn(T) -> String) -> String {
    value.map_or_else(|| "-".to_owned(), format)
}

fn nanoseconds(time: f64) -> String {
    format!("{time:.1}")
}

fn seconds(time: f64) -> String {
    format!("{time:.3}")
}
