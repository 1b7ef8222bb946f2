//! Matrices of numbers, by plain loops that know nothing of the library's.

use lagrangian_symbolic::{Expression, Graph, Matrix, Symbol};

/// The rows of a matrix of numbers.
pub type Rows = Vec<Vec<f64>>;

/// How many points each identity is looked at.
pub const POINTS: u64 = 5;

/// The value of a symbol at one of several points: anything between −1 and 1, the same on every run.
pub fn value(point: u64, symbol: Symbol) -> f64 {
    let (kind, index) = match symbol {
        Symbol::Coordinate(i) => (1, i),
        Symbol::Velocity(i) => (2, i),
        Symbol::Parameter(i) => (3, i),
        _ => (4, 0),
    };
    let mut state = point << 32 | u64::from(kind << 16 | index);
    for _ in 0..4 {
        state = (state ^ state >> 29).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }
    f64::from(u32::try_from(state >> 32).unwrap()) / f64::from(1 << 31) - 1.0
}

/// A matrix of as many parameters, from the one of this number on.
pub fn parameters(graph: &mut Graph, rows: usize, columns: usize, first: u32) -> Matrix {
    let symbols = (first..).map(Symbol::Parameter).take(rows * columns);
    let elements = symbols.map(|symbol| graph.symbol(symbol)).collect();
    Matrix::new(rows, columns, elements).unwrap()
}

/// The values of a matrix of the parameters from this number on.
pub fn numbers(rows: usize, columns: usize, first: u32, point: u64) -> Rows {
    let position = |i: usize, j: usize| first + u32::try_from(j * rows + i).unwrap();
    let entry = |i, j| value(point, Symbol::Parameter(position(i, j)));
    let row = |i| (0..columns).map(|j| entry(i, j)).collect();
    (0..rows).map(row).collect()
}

pub fn evaluate(graph: &Graph, matrix: &Matrix, point: u64) -> Rows {
    let values = graph.evaluate(matrix.elements(), |symbol| value(point, symbol));
    let row = |i| {
        let entries = (0..matrix.columns()).map(|j| values[j * matrix.rows() + i]);
        entries.collect()
    };
    (0..matrix.rows()).map(row).collect()
}

#[track_caller]
pub fn assert_close(found: &Rows, expected: &Rows) {
    let lengths = |rows: &Rows| rows.iter().map(Vec::len).collect::<Vec<_>>();
    assert_eq!(lengths(found), lengths(expected));
    for (x, y) in found.concat().into_iter().zip(expected.concat()) {
        let error = (x - y).abs() / y.abs().max(1.0);
        assert!(error < 1e-9, "{found:?} is not {expected:?}");
    }
}

/// Compares a matrix with rows of numbers at several points.
#[track_caller]
pub fn assert_values(graph: &Graph, matrix: &Matrix, expected: impl Fn(u64) -> Rows) {
    for point in 0..POINTS {
        assert_close(&evaluate(graph, matrix, point), &expected(point));
    }
}

/// Compares an expression with a number at several points.
#[track_caller]
pub fn assert_value(graph: &Graph, found: Expression, expected: impl Fn(u64) -> f64) {
    let matrix = Matrix::vector(vec![found]);
    assert_values(graph, &matrix, |point| vec![vec![expected(point)]]);
}

pub fn product(a: &Rows, b: &Rows) -> Rows {
    let mut product = vec![vec![0.0; b[0].len()]; a.len()];
    for (i, row) in a.iter().enumerate() {
        for (j, x) in row.iter().enumerate() {
            for (k, y) in b[j].iter().enumerate() {
                product[i][k] += x * y;
            }
        }
    }
    product
}
