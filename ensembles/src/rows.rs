//! The rows that a motion has in a table.

/// The rows that a motion has in a table: one, `[x, y]`, or a `Vec` of them, such as one for each sample or event.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a row of {N} numbers",
    note = "return `[x, y]` with as many numbers as there are columns, or a `Vec` of such rows"
)]
pub trait Rows<const N: usize> {
    /// Returns the rows.
    fn rows(&self) -> &[[f64; N]];
}

impl<const N: usize> Rows<N> for [f64; N] {
    fn rows(&self) -> &[[f64; N]] {
        std::slice::from_ref(self)
    }
}

impl<const N: usize> Rows<N> for Vec<[f64; N]> {
    fn rows(&self) -> &[[f64; N]] {
        self
    }
}
