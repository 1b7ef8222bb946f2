//! Matrices as the data have them.

use lagrangian_tests::{assert_close, rows};
use nalgebra::SMatrix;

#[test]
fn matrices_are_written_row_by_row() {
    let matrix = SMatrix::<f64, 2, 3>::from_row_slice(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    assert_close(
        "a matrix",
        &rows(&matrix),
        &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
        0.0,
    );
}
