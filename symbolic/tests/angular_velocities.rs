//! Angular velocities, against differences of rotation matrices in numbers.

mod support;

use lagrangian_symbolic::{Expression, Graph, Matrix, OperationCount, Program, Symbol};
use support::draft::{Draft, value};
use support::frames::{
    Rows, SEQUENCES, angular_velocity, assert_near, by_coordinates, moving, rotation, rows,
    transposed,
};
use support::systems::{cardan_rates, euler_rates};

/// What a difference may be wrong by: rounding of 1e-16 over a step of 1e-4.
const DIFFERENCE: f64 = 1e-10;

fn apply(matrix: &Rows, vector: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|i| (0..3).map(|j| matrix[i][j] * vector[j]).sum())
}

/// Compares both angular velocities of a matrix with those of the same in numbers.
#[track_caller]
fn assert_velocities(graph: &mut Graph, matrix: &Matrix, at: impl Fn(f64) -> Rows) {
    let now = at(value(Symbol::Time));
    assert_near(&rows(graph, matrix).concat(), &now.concat(), 1e-14);
    let expected = angular_velocity(at);
    let body = graph.angular_velocity(matrix, 6).unwrap();
    assert_eq!(body.shape(), (3, 1));
    assert_near(
        &graph.evaluate(body.elements(), value),
        &expected,
        DIFFERENCE,
    );
    let inertial = graph.angular_velocity_inertial(matrix, 6).unwrap();
    let expected = apply(&now, expected);
    assert_near(
        &graph.evaluate(inertial.elements(), value),
        &expected,
        DIFFERENCE,
    );
}

fn angles(time: f64) -> [f64; 3] {
    [0, 1, 2].map(|i| moving(i, time))
}

/// A matrix of the elements of another one, which remembers nothing.
fn written(matrix: &Matrix) -> Matrix {
    Matrix::new(matrix.rows(), matrix.columns(), matrix.elements().to_vec()).unwrap()
}

fn count(graph: &Graph, roots: &[Expression]) -> OperationCount {
    Program::schedule(graph, &[roots]).count()
}

#[test]
fn of_all_sequences() {
    for sequence in SEQUENCES {
        let mut graph = Graph::new();
        let matrix = by_coordinates(&mut graph, sequence, 0);
        assert_velocities(&mut graph, &matrix, |t| rotation(sequence, &angles(t)));
        let back = matrix.transpose();
        assert_velocities(&mut graph, &back, |t| {
            transposed(&rotation(sequence, &angles(t)))
        });
        let by_hand = written(&matrix);
        assert_velocities(&mut graph, &by_hand, |t| rotation(sequence, &angles(t)));
    }
}

#[test]
fn in_the_angles_of_the_book() {
    // (4.4), and the same for Cardan's angles, expression by expression.
    let mut draft = Draft::new(3);
    for (sequence, rates) in [
        ("zxz", euler_rates(&mut draft)),
        ("xyz", cardan_rates(&mut draft)),
    ] {
        let matrix = by_coordinates(&mut draft.graph, sequence, 0);
        let velocity = draft.graph.angular_velocity(&matrix, 3).unwrap();
        assert_eq!(velocity, Matrix::vector(rates.to_vec()), "{sequence}");
        // Also if the matrix is written element by element.
        let velocity = draft.graph.angular_velocity(&written(&matrix), 3).unwrap();
        assert_eq!(
            velocity,
            Matrix::vector(rates.to_vec()),
            "{sequence} by hand"
        );
    }
}

#[test]
fn cost_what_the_closed_form_costs() {
    // Two sums of two terms and one with a rate: 2 · (3 products, 1 sum) less what is shared.
    let mut draft = Draft::new(3);
    let book = euler_rates(&mut draft);
    let book = count(&draft.graph, &book);
    for sequence in SEQUENCES {
        let mut graph = Graph::new();
        let matrix = by_coordinates(&mut graph, sequence, 0);
        for matrix in [matrix.clone(), written(&matrix)] {
            let body = graph.angular_velocity(&matrix, 3).unwrap();
            let inertial = graph.angular_velocity_inertial(&matrix, 3).unwrap();
            assert_eq!(count(&graph, body.elements()), book, "{sequence}");
            assert_eq!(count(&graph, inertial.elements()), book, "{sequence}");
        }
    }
}
