//! Matrices and vectors of expressions, against plain loops over numbers.

use lagrangian_symbolic::{Geometry, Matrix, Rational};
use lagrangian_symbolic_testing::rows::{
    Rows, assert_value, assert_values, numbers, parameters, product,
};
use lagrangian_symbolic_testing::{Draft, Quantity};

#[test]
fn elements_are_counted_column_by_column() {
    let mut geometry = Geometry::new();
    let matrix = parameters(&mut geometry.graph, 2, 3, 0);
    let [a, b, c, d, e, f] = *matrix.elements() else {
        panic!("there are six elements");
    };
    assert_eq!((matrix.rows(), matrix.columns()), (2, 3));
    assert_eq!(matrix.get(0, 2), Some(e));
    assert_eq!(matrix.get(1, 0), Some(b));
    assert_eq!((matrix.get(2, 0), matrix.get(0, 3)), (None, None));
    assert_eq!(
        matrix.block((1, 0), (1, 3)),
        Matrix::new(1, 3, vec![b, d, f])
    );
    assert_eq!(
        matrix.block((0, 1), (2, 1)),
        Some(Matrix::vector(vec![c, d]))
    );
    assert_eq!(
        (matrix.block((2, 0), (1, 3)), matrix.block((0, 3), (2, 1))),
        (None, None)
    );
    let transpose = Matrix::new(3, 2, vec![a, c, e, b, d, f]).unwrap();
    assert_eq!(matrix.transpose(), transpose);
    assert_eq!(matrix.diagonal(), None);
    let square = Matrix::new(2, 2, vec![a, b, c, d]).unwrap();
    assert_eq!(square.diagonal(), Some(Matrix::vector(vec![a, d])));
}

#[test]
fn shapes_must_fit_their_elements() {
    let geometry = Geometry::new();
    let one = geometry.graph.one();
    assert_eq!(Matrix::new(2, 2, vec![one; 3]), None);
    assert_eq!(Matrix::new(2, 2, vec![one; 5]), None);
    assert_eq!(Matrix::new(0, 3, Vec::new()), None);
    assert_eq!(Matrix::new(usize::MAX, 2, vec![one; 2]), None);
    let row = Matrix::new(1, 2, vec![one; 2]).unwrap();
    assert_ne!(row, Matrix::vector(vec![one; 2]));
}

#[test]
fn sums_and_multiples_are_by_element() {
    let mut geometry = Geometry::new();
    let [a, b] = [0, 6].map(|first| parameters(&mut geometry.graph, 2, 3, first));
    let by_element = |point: u64, combine: fn(f64, f64) -> f64| {
        let (a, b) = (numbers(2, 3, 0, point), numbers(2, 3, 6, point));
        let rows = a.into_iter().zip(b);
        let row = |(a, b): (Vec<f64>, Vec<f64>)| a.into_iter().zip(b).map(|(x, y)| combine(x, y));
        rows.map(|pair| row(pair).collect()).collect()
    };
    let terms = [(&a, Rational::integer(2)), (&b, -&Rational::HALF)];
    let sum = geometry.matrix_sum(&terms).unwrap();
    assert_values(&geometry.graph, &sum, |point| {
        by_element(point, |x, y| 2.0 * x - 0.5 * y)
    });
    let halved = geometry.matrix_sum(&[(&a, Rational::HALF)]).unwrap();
    assert_values(&geometry.graph, &halved, |point| {
        by_element(point, |x, _| 0.5 * x)
    });
    let both = geometry.graph.component_product(&a, &b).unwrap();
    assert_values(&geometry.graph, &both, |point| {
        by_element(point, |x, y| x * y)
    });
    let three = geometry.graph.integer(3);
    let scaled = geometry.matrix_scaled(&a, three);
    assert_values(&geometry.graph, &scaled, |point| {
        by_element(point, |x, _| 3.0 * x)
    });
    // Other shapes do not fit, and no terms have none.
    let other = a.transpose();
    let terms = [(&a, Rational::ONE), (&other, Rational::ONE)];
    assert_eq!(geometry.matrix_sum(&terms), None);
    assert_eq!(geometry.matrix_sum(&[]), None);
    assert_eq!(geometry.graph.component_product(&a, &other), None);
}

#[test]
fn what_is_added_to_its_opposite_is_zero() {
    let mut geometry = Geometry::new();
    let a = parameters(&mut geometry.graph, 2, 2, 0);
    let terms = [(&a, Rational::ONE), (&a, Rational::MINUS_ONE)];
    let zero = vec![geometry.graph.zero(); 4];
    assert_eq!(geometry.matrix_sum(&terms), Matrix::new(2, 2, zero));
}

#[test]
fn products_of_all_shapes() {
    for (n, m, l) in (0..64).map(|k| (k / 16 + 1, k / 4 % 4 + 1, k % 4 + 1)) {
        let mut geometry = Geometry::new();
        let a = parameters(&mut geometry.graph, n, m, 0);
        let b = parameters(&mut geometry.graph, m, l, 16);
        let found = geometry.matrix_product(&a, &b).unwrap();
        assert_values(&geometry.graph, &found, |point| {
            product(&numbers(n, m, 0, point), &numbers(m, l, 16, point))
        });
        if m != l {
            assert_eq!(geometry.matrix_product(&a, &b.transpose()), None);
        }
    }
}

#[test]
fn products_of_several_matrices_of_three_rows() {
    // They remember their factors, which must not show, from either side.
    let mut geometry = Geometry::new();
    let [a, b, c] = [0, 9, 18].map(|first| parameters(&mut geometry.graph, 3, 3, first));
    let v = parameters(&mut geometry.graph, 3, 1, 27);
    let both = geometry.matrix_product(&a, &b).unwrap();
    let all = geometry.matrix_product(&both, &c.transpose()).unwrap();
    let expected = |point: u64| {
        let [a, b] = [0, 9].map(|first| numbers(3, 3, first, point));
        let c = numbers(3, 3, 18, point);
        let c: Rows = (0..3).map(|i| (0..3).map(|j| c[j][i]).collect()).collect();
        product(&product(&a, &b), &c)
    };
    let vector = |point| numbers(3, 1, 27, point);
    assert_values(&geometry.graph, &all, expected);
    let column = geometry.matrix_product(&all, &v).unwrap();
    assert_values(&geometry.graph, &column, |point| {
        product(&expected(point), &vector(point))
    });
    let row = geometry.matrix_product(&v.transpose(), &all).unwrap();
    assert_values(&geometry.graph, &row, |point| {
        let row = vec![vector(point).concat()];
        product(&row, &expected(point))
    });
}

#[test]
fn one_is_neutral() {
    let mut geometry = Geometry::new();
    let a = parameters(&mut geometry.graph, 3, 3, 0);
    let one = geometry.graph.identity_matrix(3);
    assert_eq!(geometry.matrix_product(&a, &one), Some(a.clone()));
    assert_eq!(geometry.matrix_product(&one, &a), Some(a));
    let ones = Matrix::vector(vec![geometry.graph.one(); 3]);
    assert_eq!(geometry.graph.diagonal_matrix(&ones), Some(one.clone()));
    assert_eq!(
        geometry.graph.diagonal_matrix(&ones.transpose()),
        Some(one.clone())
    );
    assert_eq!(geometry.graph.diagonal_matrix(&one), None);
}

#[test]
fn products_of_vectors() {
    let mut geometry = Geometry::new();
    let [u, v] = [0, 3].map(|first| parameters(&mut geometry.graph, 3, 1, first));
    let (row_u, row_v) = (u.transpose(), v.transpose());
    let at = |point| [0, 3].map(|first| numbers(3, 1, first, point).concat());
    let dot = |point| {
        let [u, v] = at(point);
        u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
    };
    let cross = |point| {
        let [u, v] = at(point);
        let component = |j: usize, k: usize| u[j] * v[k] - u[k] * v[j];
        vec![component(1, 2), component(2, 0), component(0, 1)]
    };
    for (u, v) in [(&u, &v), (&row_u, &row_v)] {
        let found = geometry.dot_product(u, v).unwrap();
        assert_value(&geometry.graph, found, dot);
        let found = geometry.cross_product(u, v).unwrap();
        assert_eq!(found.shape(), u.shape());
        let components = Matrix::vector(found.elements().to_vec());
        assert_values(&geometry.graph, &components, |point| {
            cross(point).into_iter().map(|x| vec![x]).collect()
        });
        let outer = geometry.graph.outer_product(u, v).unwrap();
        assert_values(&geometry.graph, &outer, |point| {
            let [u, v] = at(point);
            let row = |x: &f64| v.iter().map(|y| x * y).collect();
            u.iter().map(row).collect()
        });
    }
    let crossing = geometry.graph.cross_matrix(&u).unwrap();
    let crossed = geometry.matrix_product(&crossing, &v);
    assert_eq!(crossed, geometry.cross_product(&u, &v));
    let norm = geometry.norm(&u);
    assert_value(&geometry.graph, norm, |point| {
        at(point)[0].iter().map(|x| x * x).sum::<f64>().sqrt()
    });
    let square = geometry.norm_squared(&u);
    assert_eq!(Some(square), geometry.dot_product(&u, &u));
}

#[test]
fn what_is_no_vector_has_no_such_products() {
    let mut geometry = Geometry::new();
    let three = parameters(&mut geometry.graph, 3, 1, 0);
    let four = parameters(&mut geometry.graph, 4, 1, 0);
    let square = parameters(&mut geometry.graph, 3, 3, 0);
    for (x, y) in [
        (&three, &four),
        (&three, &three.transpose()),
        (&square, &square),
    ] {
        assert_eq!(geometry.dot_product(x, y), None);
        assert_eq!(geometry.cross_product(x, y), None);
    }
    assert_eq!(geometry.cross_product(&four, &four), None);
    assert_eq!(geometry.graph.outer_product(&three, &square), None);
    assert_eq!(geometry.graph.cross_matrix(&square), None);
    assert_eq!(geometry.graph.cross_matrix(&four), None);
}

#[test]
fn time_goes_on_in_each_element() {
    let draft = Draft::new(1);
    let (q, v, a, t) = (draft.q(0), draft.v(0), draft.p(0), draft.time());
    let matrix = |elements: [Quantity<'_>; 4]| {
        Matrix::new(2, 2, elements.map(Quantity::expression).into()).unwrap()
    };
    let moving = matrix([q.sin(), a, a * t, q.squared()]);
    let expected = matrix([q.cos() * v, draft.zero(), a, 2 * (q * v)]);
    let rate = draft.geometry().matrix_time_derivative(&moving, 1);
    assert_eq!(rate, expected);
}
