//! The worst errors of many comparisons.

use std::fmt::{self, Display, Formatter};

/// How many errors are listed one by one.
const SHOWN_FAILURES: usize = 20;

/// A table of the worst error that was seen in each quantity, and where: of the errors, the one that
/// came nearest to its tolerance.
///
/// [`finish`](Self::finish) prints it and panics if a tolerance was exceeded anywhere.
#[derive(Debug, Default)]
#[must_use = "errors are only reported by `finish`"]
pub struct Figures {
    rows: Vec<Row>,
    failures: Vec<String>,
}

#[derive(Debug)]
struct Row {
    quantity: &'static str,
    comparisons: usize,
    worst: f64,
    tolerance: f64,
    at: String,
}

impl Figures {
    /// No errors yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes note of an error in a quantity, seen at the place that `at` names.
    pub fn record(&mut self, quantity: &'static str, at: &str, error: f64, tolerance: f64) {
        // What is no number is no error that could be within a tolerance.
        let within = error <= tolerance;
        if !within {
            self.failures.push(format!(
                "{quantity} at {at}: error {error:.2e}, tolerance {tolerance:.1e}"
            ));
        }
        let row = self.row(quantity);
        row.comparisons += 1;
        let is_worse = error.is_nan() || error / tolerance > row.worst / row.tolerance;
        if row.comparisons == 1 || is_worse {
            row.worst = error;
            row.tolerance = tolerance;
            at.clone_into(&mut row.at);
        }
    }

    fn row(&mut self, quantity: &'static str) -> &mut Row {
        let index = self.rows.iter().position(|row| row.quantity == quantity);
        let index = index.unwrap_or_else(|| {
            self.rows.push(Row {
                quantity,
                comparisons: 0,
                worst: 0.0,
                tolerance: 0.0,
                at: String::new(),
            });
            self.rows.len() - 1
        });
        &mut self.rows[index]
    }

    /// Prints the table.
    ///
    /// # Panics
    ///
    /// If an error exceeded its tolerance, or if nothing was compared.
    pub fn finish(self) {
        println!("{self}");
        assert!(!self.rows.is_empty(), "nothing was compared");
        let shown = &self.failures[..self.failures.len().min(SHOWN_FAILURES)];
        assert!(
            shown.is_empty(),
            "{} errors:\n{}",
            self.failures.len(),
            shown.join("\n")
        );
    }
}

impl Display for Figures {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let titles = ["quantity", "comparisons", "worst", "tolerance"];
        let [quantity, comparisons, worst, tolerance] = titles;
        writeln!(
            f,
            "{quantity:<26}{comparisons:>12}{worst:>10}{tolerance:>11}  at"
        )?;
        for row in &self.rows {
            let (quantity, comparisons) = (row.quantity, row.comparisons);
            let (worst, tolerance, at) = (row.worst, row.tolerance, &row.at);
            writeln!(
                f,
                "{quantity:<26}{comparisons:>12}{worst:>10.1e}{tolerance:>11.1e}  {at}"
            )?;
        }
        Ok(())
    }
}
