//! Rotation matrices of numbers, by plain loops that know nothing of the library's.

use lagrangian_symbolic::{Axis, Expression, Geometry, Matrix, Symbol};

use crate::value;

/// The rows of a matrix of numbers.
pub type Rows = [[f64; 3]; 3];

/// The twelve sequences of three axes of which neighbours differ.
pub const SEQUENCES: [&str; 12] = [
    "zxz", "xyx", "yzy", "zyz", "xzx", "yxy", "xyz", "yzx", "zxy", "xzy", "zyx", "yxz",
];

pub fn axis(letter: char) -> Axis {
    match letter {
        'x' => Axis::X,
        'y' => Axis::Y,
        _ => Axis::Z,
    }
}

/// The rotation about an axis by an angle.
pub fn elementary(letter: char, angle: f64) -> Rows {
    let (s, c) = angle.sin_cos();
    match letter {
        'x' => [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]],
        'y' => [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]],
        _ => [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]],
    }
}

pub fn times(a: &Rows, b: &Rows) -> Rows {
    let mut product = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            for k in 0..3 {
                product[i][j] += a[i][k] * b[k][j];
            }
        }
    }
    product
}

pub fn transposed(a: &Rows) -> Rows {
    let mut transpose = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            transpose[i][j] = a[j][i];
        }
    }
    transpose
}

/// The product of elementary rotations.
pub fn rotation(sequence: &str, angles: &[f64]) -> Rows {
    let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let factors = sequence.chars().zip(angles);
    factors.fold(identity, |product, (letter, angle)| {
        times(&product, &elementary(letter, *angle))
    })
}

/// The angular velocity along the body's axes of a rotation that is given at all times, where the
/// values of `draft` have time 0.3: from central differences.
pub fn angular_velocity(at: impl Fn(f64) -> Rows) -> [f64; 3] {
    let (now, step) = (value(Symbol::Time), 1e-4);
    // Two differences, of which the error of fourth order is left.
    let difference = |step: f64, i: usize, j: usize| {
        (at(now + step)[i][j] - at(now - step)[i][j]) / (2.0 * step)
    };
    let mut rate = [[0.0; 3]; 3];
    for (i, row) in rate.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry = (4.0 * difference(step, i, j) - difference(2.0 * step, i, j)) / 3.0;
        }
    }
    let spin = times(&transposed(&at(now)), &rate);
    [spin[2][1], spin[0][2], spin[1][0]]
}

/// The coordinates at a time: those of [`value`] at its time, and its velocities at all times.
pub fn moving(coordinate: u32, time: f64) -> f64 {
    value(Symbol::Coordinate(coordinate))
        + value(Symbol::Velocity(coordinate)) * (time - value(Symbol::Time))
}

/// The rows of a matrix of three columns, with the values of [`value`].
pub fn rows(geometry: &Geometry, matrix: &Matrix) -> Vec<[f64; 3]> {
    let values = geometry.graph.evaluate(matrix.elements(), value);
    let height = matrix.rows();
    let row = |i: usize| core::array::from_fn(|j| values[j * height + i]);
    (0..height).map(row).collect()
}

/// The rotation by a sequence of axes through the coordinates from the first on.
pub fn by_coordinates(geometry: &mut Geometry, sequence: &str, first: u32) -> Matrix {
    let turns: Vec<(Axis, Expression)> = sequence
        .chars()
        .zip(first..)
        .map(|(letter, i)| (axis(letter), geometry.graph.symbol(Symbol::Coordinate(i))))
        .collect();
    geometry.rotation(&turns)
}

#[track_caller]
pub fn assert_near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (x, y) in found.iter().zip(expected) {
        assert!((x - y).abs() < tolerance, "{found:?} is not {expected:?}");
    }
}

/// The elements of a matrix that another graph computed: of its factors this one knows nothing.
pub fn written_out(
    geometry: &mut Geometry,
    compute: impl FnOnce(&mut Geometry) -> Matrix,
) -> Matrix {
    let mut other = Geometry::new();
    let matrix = compute(&mut other);
    let elements = geometry.graph.imported(&other.graph, matrix.elements());
    Matrix::new(matrix.rows(), matrix.columns(), elements).expect("as many elements")
}
