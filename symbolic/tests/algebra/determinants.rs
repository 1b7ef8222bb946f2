//! Traces, determinants and inverses, against numerical elimination.

use lagrangian_symbolic::{Geometry, Matrix, NoInverse, Rational};
use lagrangian_symbolic_testing::rows::{
    POINTS, Rows, assert_close, assert_value, evaluate, numbers, parameters, product,
};
use lagrangian_symbolic_testing::{Draft, Quantity};

/// By elimination with exchange of rows.
fn determinant(mut rows: Rows) -> f64 {
    let mut determinant = 1.0;
    for k in 0..rows.len() {
        let larger = |i: &usize, j: &usize| rows[*i][k].abs().total_cmp(&rows[*j][k].abs());
        let pivot = (k..rows.len()).max_by(larger).unwrap();
        if pivot != k {
            rows.swap(pivot, k);
            determinant = -determinant;
        }
        determinant *= rows[k][k];
        let (upper, lower) = rows.split_at_mut(k + 1);
        for row in lower {
            let factor = row[k] / upper[k][k];
            for (entry, above) in row.iter_mut().zip(&upper[k]) {
                *entry -= factor * above;
            }
        }
    }
    determinant
}

#[test]
fn determinants_and_inverses_up_to_four_rows() {
    for n in 1..=4 {
        let mut geometry = Geometry::new();
        let a = parameters(&mut geometry.graph, n, n, 0);
        let at = |point| numbers(n, n, 0, point);
        let found = geometry.determinant(&a).unwrap();
        assert_value(&geometry.graph, found, |point| determinant(at(point)));
        let inverse = geometry.inverse(&a).unwrap();
        let identity = geometry.graph.identity_matrix(n);
        for point in 0..POINTS {
            let inverse = evaluate(&geometry.graph, &inverse, point);
            let one = evaluate(&geometry.graph, &identity, point);
            assert_close(&product(&inverse, &at(point)), &one);
            assert_close(&product(&at(point), &inverse), &one);
        }
        let trace = geometry.graph.trace(&a).unwrap();
        assert_value(&geometry.graph, trace, |point| {
            (0..n).map(|i| at(point)[i][i]).sum()
        });
    }
}

#[test]
fn other_shapes_have_neither() {
    let mut geometry = Geometry::new();
    let wide = parameters(&mut geometry.graph, 2, 3, 0);
    assert_eq!(geometry.determinant(&wide), None);
    assert_eq!(geometry.graph.trace(&wide), None);
    assert_eq!(geometry.inverse(&wide), Err(NoInverse::Shape));
    let large = parameters(&mut geometry.graph, 5, 5, 0);
    assert_eq!(geometry.determinant(&large), None);
    assert_eq!(geometry.inverse(&large), Err(NoInverse::Shape));
    assert!(geometry.graph.trace(&large).is_some());
}

#[test]
fn a_determinant_that_vanishes_is_found_however_it_is_written() {
    let mut geometry = Geometry::new();
    let v = parameters(&mut geometry.graph, 3, 1, 0);
    // [v]× v = 0, and v vᵀ has one dimension only.
    let cross = geometry.graph.cross_matrix(&v).unwrap();
    assert_eq!(geometry.inverse(&cross), Err(NoInverse::Singular));
    let outer = geometry.graph.outer_product(&v, &v).unwrap();
    assert_eq!(geometry.inverse(&outer), Err(NoInverse::Singular));
    // sin 2x = 2 sin x cos x is no rule of the graph.
    let draft = Draft::new(1);
    let x = draft.q(0);
    let elements = [2 * x.sin(), (2 * x).sin(), draft.one(), x.cos()];
    let matrix = Matrix::new(2, 2, elements.map(Quantity::expression).into()).unwrap();
    assert_eq!(draft.geometry().inverse(&matrix), Err(NoInverse::Singular));
}

#[test]
fn an_inverse_divides_no_more_than_it_must() {
    let mut geometry = Geometry::new();
    let v = parameters(&mut geometry.graph, 3, 1, 0);
    let diagonal = geometry.graph.diagonal_matrix(&v).unwrap();
    let inverse = geometry.inverse(&diagonal).unwrap();
    let reciprocals = v.elements().iter();
    let reciprocals = reciprocals
        .map(|x| geometry.graph.power(*x, &Rational::MINUS_ONE))
        .collect();
    let expected = geometry.graph.diagonal_matrix(&Matrix::vector(reciprocals));
    assert_eq!(Some(inverse), expected);
}
