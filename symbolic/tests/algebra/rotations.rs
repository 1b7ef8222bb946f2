//! Rotation matrices: what they are, what they make of vectors, and what that costs.

use lagrangian_symbolic::{
    Axis, Expression, Geometry, Matrix, OperationCount, Program, Rational, Symbol,
};
use lagrangian_symbolic_testing::frames::{
    SEQUENCES, assert_near, by_coordinates, rotation, rows, written_out,
};
use lagrangian_symbolic_testing::{Draft, value, vector};

const ROUNDING: f64 = 1e-14;

fn coordinates() -> [f64; 3] {
    [0, 1, 2].map(|i| value(Symbol::Coordinate(i)))
}

fn count(geometry: &Geometry, matrix: &Matrix) -> OperationCount {
    Program::schedule(&geometry.graph, &[matrix.elements()]).count()
}

/// Additions and multiplications.
fn arithmetic(geometry: &Geometry, matrix: &Matrix) -> (usize, usize) {
    let count = count(geometry, matrix);
    (count.additions, count.multiplications)
}

fn parameters(geometry: &mut Geometry) -> Matrix {
    Matrix::vector(
        [0, 1, 2]
            .map(|i| geometry.graph.symbol(Symbol::Parameter(i)))
            .into(),
    )
}

#[test]
fn all_sequences_are_products_of_elementary_rotations() {
    for sequence in SEQUENCES {
        let mut geometry = Geometry::new();
        let matrix = by_coordinates(&mut geometry, sequence, 0);
        let expected = rotation(sequence, &coordinates());
        assert_near(
            &rows(&geometry, &matrix).concat(),
            &expected.concat(),
            ROUNDING,
        );
        // RᵀR = 1: by its factors, and by its elements.
        let back = matrix.transpose();
        let one = geometry.graph.identity_matrix(3);
        assert_eq!(geometry.matrix_product(&back, &matrix), Some(one.clone()));
        assert_eq!(geometry.matrix_product(&matrix, &back), Some(one.clone()));
        assert_eq!(geometry.determinant(&matrix), Some(geometry.graph.one()));
        assert_eq!(geometry.inverse(&matrix), Ok(back));
        let mut plain = Geometry::new();
        let by_hand = written_out(&mut plain, |geometry| by_coordinates(geometry, sequence, 0));
        let back = by_hand.transpose();
        let product = plain.matrix_product(&back, &by_hand);
        let product = rows(&plain, &product.unwrap());
        assert_near(&product.concat(), &rows(&geometry, &one).concat(), ROUNDING);
        assert_eq!(plain.determinant(&by_hand), Some(plain.graph.one()));
        // An inverse is found to be the transpose, element by element.
        assert_eq!(plain.inverse(&by_hand), Ok(back));
    }
}

#[test]
fn neighbours_about_one_axis_are_one_rotation() {
    let draft = Draft::new(3);
    let ([a, b, c], zero) = (draft.qs(), draft.zero());
    let about_z = |angle| draft.rotation([(Axis::Z, angle)]);
    let product = |a: &Matrix, b: &Matrix| draft.geometry().matrix_product(a, b).unwrap();
    let merged = draft.rotation([(Axis::Z, a), (Axis::X, zero), (Axis::Z, b), (Axis::X, c)]);
    assert_eq!(merged, draft.rotation([(Axis::Z, a + b), (Axis::X, c)]));
    // Also where the first goes back: Rz(a)ᵀ Rz(b) = Rz(b − a), Rz(a)ᵀ Rz(b)ᵀ = Rz(a + b)ᵀ.
    let (back, there) = (about_z(a).transpose(), about_z(b));
    assert_eq!(product(&back, &there), about_z(b - a));
    let found = product(&back, &there.transpose());
    assert_eq!(found, about_z(a + b).transpose());
    // What meets when a pair is gone merges in turn.
    let there = draft.rotation([(Axis::Z, a), (Axis::X, b), (Axis::Y, c)]);
    let turn = about_z(b);
    let back = product(&turn, &there.transpose());
    assert_eq!(product(&back, &there), turn);
    let identity = draft.graph().identity_matrix(3);
    assert_eq!(draft.rotation([]), identity);
}

#[test]
fn a_vector_along_an_axis_has_no_dead_terms() {
    // The weight of a top at l along its axis: l (sin φ sin θ, −cos φ sin θ, cos θ).
    let draft = Draft::new(3);
    let top = by_coordinates(&mut draft.geometry(), "zxz", 0);
    let (l, zero) = (draft.p(0), draft.zero());
    let along = vector([zero, zero, l]);
    let found = draft.geometry().matrix_product(&top, &along).unwrap();
    let [phi, theta] = draft.qs();
    let expected = vector([
        l * phi.sin() * theta.sin(),
        -(l * phi.cos() * theta.sin()),
        l * theta.cos(),
    ]);
    assert_eq!(found, expected);
    let square = draft.geometry().norm_squared(&found);
    assert_eq!(square, l.squared());
}

#[test]
fn a_general_vector_is_rotated_by_one_factor_after_the_other() {
    let mut geometry = Geometry::new();
    let by_hand = written_out(&mut geometry, |geometry| by_coordinates(geometry, "zyx", 0));
    let v = parameters(&mut geometry);
    let by_elements = geometry.matrix_product(&by_hand, &v).unwrap();
    let back_by_elements = geometry.matrix_product(&by_hand.transpose(), &v).unwrap();
    let turn = by_coordinates(&mut geometry, "zyx", 0);
    let by_factors = geometry.matrix_product(&turn, &v).unwrap();
    let same = |geometry: &Geometry, x: &Matrix, y: &Matrix| {
        let [x, y] = [x, y].map(|matrix| geometry.graph.evaluate(matrix.elements(), value));
        assert_near(&x, &y, ROUNDING);
    };
    same(&geometry, &by_factors, &by_elements);
    // Three rotations in a plane, of four multiplications and two additions each.
    assert_eq!(arithmetic(&geometry, &by_factors), (6, 12));
    // The same for a row, and on the way back.
    let row = geometry.matrix_product(&v.transpose(), &turn).unwrap();
    let back = geometry.matrix_product(&turn.transpose(), &v).unwrap();
    assert_eq!(row, back.transpose());
    assert_eq!(arithmetic(&geometry, &back), (6, 12));
    same(&geometry, &back, &back_by_elements);
}

#[test]
fn elements_are_taken_where_they_are_cheaper() {
    // A rotation that is written out and its transpose are 1 as a product of elements only.
    let mut geometry = Geometry::new();
    let turn = written_out(&mut geometry, |geometry| by_coordinates(geometry, "z", 0));
    let product = geometry.matrix_product(&turn.transpose(), &turn);
    let product = product.unwrap();
    let v = parameters(&mut geometry);
    assert_eq!(geometry.matrix_product(&product, &v), Some(v.clone()));
    let row = v.transpose();
    assert_eq!(geometry.matrix_product(&row, &product), Some(row));
}

/// The operations of the positions of all links of a chain, each rotated relative to the one before it by
/// two angles.
fn chain(links: u32) -> usize {
    let mut geometry = Geometry::new();
    let v = parameters(&mut geometry);
    let mut frame = geometry.graph.identity_matrix(3);
    let mut position = Matrix::vector(vec![geometry.graph.zero(); 3]);
    let mut positions: Vec<Expression> = Vec::new();
    for link in 0..links {
        let joint = by_coordinates(&mut geometry, "xy", 2 * link);
        frame = geometry.matrix_product(&frame, &joint).unwrap();
        let arm = geometry.matrix_product(&frame, &v).unwrap();
        let terms = [(&position, Rational::ONE), (&arm, Rational::ONE)];
        position = geometry.matrix_sum(&terms).unwrap();
        positions.extend(position.elements());
    }
    Program::schedule(&geometry.graph, &[&positions])
        .count()
        .cost()
}

#[test]
fn a_chain_costs_as_much_for_each_link() {
    let [first, second, third] = [10, 20, 30].map(chain);
    assert_eq!(third - second, second - first, "{first} {second} {third}");
}
