//! Vectors that are known in frames: what is computed before they are rotated, where that would
//! be wrong, and all values against plain loops over numbers.

use lagrangian_symbolic::{Axis, Expression, Geometry, Matrix, Program, Rational, Symbol};
use lagrangian_symbolic_testing::frames::{
    Rows, angular_velocity, assert_near, by_coordinates, moving, rotation, times, transposed,
    written_out,
};
use lagrangian_symbolic_testing::value;

const ROUNDING: f64 = 1e-13;
/// What a difference may be wrong by.
const DIFFERENCE: f64 = 1e-9;

type Numbers = [f64; 3];

/// A vector of the parameters from this number on.
fn vector(geometry: &mut Geometry, first: u32) -> Matrix {
    let symbols = (first..first + 3).map(Symbol::Parameter);
    Matrix::vector(
        symbols
            .map(|symbol| geometry.graph.symbol(symbol))
            .collect(),
    )
}

/// The same numerically.
fn numbers(first: u32) -> Numbers {
    [0, 1, 2].map(|i| value(Symbol::Parameter(first + i)))
}

/// x · y by the components.
fn by_elements(geometry: &mut Geometry, x: &Matrix, y: &Matrix) -> Expression {
    let pairs = x.elements().iter().zip(y.elements());
    let products: Vec<_> = pairs
        .map(|(x, y)| (geometry.graph.multiply(*x, *y), Rational::ONE))
        .collect();
    geometry.graph.sum(products)
}

fn product(geometry: &mut Geometry, factors: &[&Matrix]) -> Matrix {
    let (last, others) = factors.split_last().unwrap();
    let mut product = (*last).clone();
    for factor in others.iter().rev() {
        product = geometry.matrix_product(factor, &product).unwrap();
    }
    product
}

fn sum(geometry: &mut Geometry, terms: &[&Matrix]) -> Matrix {
    let terms: Vec<_> = terms.iter().map(|x| (*x, Rational::ONE)).collect();
    geometry.matrix_sum(&terms).unwrap()
}

fn cost(geometry: &Geometry, roots: &[Expression]) -> usize {
    Program::schedule(&geometry.graph, &[roots]).count().cost()
}

fn contains(geometry: &Geometry, root: Expression, symbol: Symbol) -> bool {
    geometry.graph.symbols(&[root]).contains(&symbol)
}

fn apply(matrix: &Rows, vector: Numbers) -> Numbers {
    core::array::from_fn(|i| (0..3).map(|j| matrix[i][j] * vector[j]).sum())
}

fn dot(a: Numbers, b: Numbers) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

fn cross(a: Numbers, b: Numbers) -> Numbers {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn add(a: Numbers, b: Numbers) -> Numbers {
    core::array::from_fn(|i| a[i] + b[i])
}

/// The rotation of `by_coordinates` numerically, at a time.
fn at(sequence: &str, first: u32, time: f64) -> Rows {
    let angles: Vec<f64> = (first..)
        .take(sequence.len())
        .map(|i| moving(i, time))
        .collect();
    rotation(sequence, &angles)
}

fn now(sequence: &str, first: u32) -> Rows {
    at(sequence, first, value(Symbol::Time))
}

#[track_caller]
fn assert_is(geometry: &Geometry, found: Expression, expected: f64) {
    assert_near(
        &geometry.graph.evaluate(&[found], value),
        &[expected],
        ROUNDING,
    );
}

#[track_caller]
fn assert_vector(geometry: &Geometry, found: &Matrix, expected: Numbers, tolerance: f64) {
    let found = geometry.graph.evaluate(found.elements(), value);
    assert_near(&found, &expected, tolerance);
}

#[test]
fn factors_cancel_from_the_left() {
    let mut geometry = Geometry::new();
    let [r, s] = [("zxz", 0), ("yx", 3)].map(|(axes, i)| by_coordinates(&mut geometry, axes, i));
    let v = vector(&mut geometry, 0);
    // Rᵀ (R v) and R (Rᵀ v).
    let back = r.transpose();
    assert_eq!(product(&mut geometry, &[&back, &r, &v]), v);
    assert_eq!(product(&mut geometry, &[&r, &back, &v]), v);
    // (R S)ᵀ (R v) = Sᵀ v, and R (Rᵀ S v) = S v.
    let both = product(&mut geometry, &[&r, &s]).transpose();
    let expected = product(&mut geometry, &[&s.transpose(), &v]);
    assert_eq!(product(&mut geometry, &[&both, &r, &v]), expected);
    let there = product(&mut geometry, &[&back, &s]);
    let expected = product(&mut geometry, &[&s, &v]);
    assert_eq!(product(&mut geometry, &[&r, &there, &v]), expected);
    // The same for rows.
    let row = product(&mut geometry, &[&v.transpose(), &r]);
    assert_eq!(geometry.matrix_product(&row, &back), Some(v.transpose()));
    // One rotation about the same axis does not cancel another.
    let [a, b] = [0, 1].map(|i| by_coordinates(&mut geometry, "z", i));
    let found = product(&mut geometry, &[&a.transpose(), &b, &v]);
    let expected = apply(&times(&transposed(&now("z", 0)), &now("z", 1)), numbers(0));
    assert_vector(&geometry, &found, expected, ROUNDING);
}

#[test]
fn lengths_and_angles_are_those_before_the_turn() {
    let mut geometry = Geometry::new();
    let [r, s] = [("zyx", 0), ("yx", 3)].map(|(axes, i)| by_coordinates(&mut geometry, axes, i));
    let [a, b] = [0, 3].map(|i| vector(&mut geometry, i));
    let [x, y] = [&a, &b].map(|v| product(&mut geometry, &[&r, v]));
    assert_eq!(geometry.norm_squared(&x), geometry.norm_squared(&a));
    assert_eq!(geometry.norm(&x), geometry.norm(&a));
    assert_eq!(geometry.dot_product(&x, &y), geometry.dot_product(&a, &b));
    let (x_row, y_row) = (x.transpose(), y.transpose());
    assert_eq!(
        geometry.dot_product(&x_row, &y_row),
        geometry.dot_product(&a, &b)
    );
    let by_product = geometry.matrix_product(&x_row, &y).unwrap();
    assert_eq!(by_product.get(0, 0), geometry.dot_product(&a, &b));
    // R S a · R b = S a · b.
    let rotated = product(&mut geometry, &[&r, &s, &a]);
    let found = geometry.dot_product(&rotated, &y).unwrap();
    let before = product(&mut geometry, &[&s, &a]);
    let expected = geometry.dot_product(&before, &b).unwrap();
    assert_eq!(cost(&geometry, &[found]), cost(&geometry, &[expected]));
    let values = dot(apply(&now("yx", 3), numbers(0)), numbers(3));
    assert_is(&geometry, found, values);
    assert!((0..3).all(|i| !contains(&geometry, found, Symbol::Coordinate(i))));
}

#[test]
fn sums_and_multiples_are_rotated_as_one() {
    let mut geometry = Geometry::new();
    let [r, s] = [("zyx", 0), ("y", 3)].map(|(axes, i)| by_coordinates(&mut geometry, axes, i));
    let [a, b] = [0, 3].map(|i| vector(&mut geometry, i));
    let [x, y] = [&a, &b].map(|v| product(&mut geometry, &[&r, v]));
    // R a + R b and c R a.
    let (both, before) = (sum(&mut geometry, &[&x, &y]), sum(&mut geometry, &[&a, &b]));
    assert_eq!(geometry.norm_squared(&both), geometry.norm_squared(&before));
    let c = geometry.graph.symbol(Symbol::Parameter(7));
    let (scaled, before) = (geometry.matrix_scaled(&x, c), geometry.matrix_scaled(&a, c));
    assert_eq!(
        geometry.norm_squared(&scaled),
        geometry.norm_squared(&before)
    );
    // What cancels is gone.
    let terms = [(&x, Rational::ONE), (&x, Rational::MINUS_ONE)];
    let nothing = geometry.matrix_sum(&terms).unwrap();
    assert_eq!(geometry.norm_squared(&nothing), geometry.graph.zero());
    // R S a + R b = R (S a + b).
    let rotated = product(&mut geometry, &[&r, &s, &a]);
    let found = sum(&mut geometry, &[&rotated, &y]);
    let found = geometry.norm_squared(&found);
    let expected = add(apply(&now("y", 3), numbers(0)), numbers(3));
    assert_is(&geometry, found, dot(expected, expected));
    assert!((0..3).all(|i| !contains(&geometry, found, Symbol::Coordinate(i))));
}

#[test]
fn vector_products_are_rotated() {
    let mut geometry = Geometry::new();
    let [r, s] = [("zyx", 0), ("yx", 3)].map(|(axes, i)| by_coordinates(&mut geometry, axes, i));
    let [a, b] = [0, 3].map(|i| vector(&mut geometry, i));
    let [x, y] = [&a, &b].map(|v| product(&mut geometry, &[&r, v]));
    let found = geometry.cross_product(&x, &y).unwrap();
    let before = geometry.cross_product(&a, &b).unwrap();
    let expected = apply(&now("zyx", 0), cross(numbers(0), numbers(3)));
    assert_vector(&geometry, &found, expected, ROUNDING);
    assert_eq!(product(&mut geometry, &[&r.transpose(), &found]), before);
    // Only R is common to R S a and R b.
    let rotated = product(&mut geometry, &[&r, &s, &a]);
    let found = geometry.cross_product(&rotated, &y).unwrap();
    let found = product(&mut geometry, &[&r.transpose(), &found]);
    let expected = cross(apply(&now("yx", 3), numbers(0)), numbers(3));
    assert_vector(&geometry, &found, expected, ROUNDING);
    assert!((0..3).all(|i| !contains(&geometry, found.elements()[0], Symbol::Coordinate(i))));
}

#[test]
fn velocities_are_rotated_with_the_body() {
    // d/dt R v = R (ω × v + v̇), of a point that moves in the body.
    let mut geometry = Geometry::new();
    let r = by_coordinates(&mut geometry, "zxz", 0);
    let mut center = vector(&mut geometry, 0).elements().to_vec();
    center[2] = geometry.graph.symbol(Symbol::Coordinate(3));
    let point = product(&mut geometry, &[&r, &Matrix::vector(center)]);
    let velocity = geometry.matrix_time_derivative(&point, 4);
    let square = geometry.norm_squared(&velocity);

    let spin = angular_velocity(|t| at("zxz", 0, t));
    let position = [
        value(Symbol::Parameter(0)),
        value(Symbol::Parameter(1)),
        value(Symbol::Coordinate(3)),
    ];
    let rate = [0.0, 0.0, value(Symbol::Velocity(3))];
    let expected = add(cross(spin, position), rate);
    let found = geometry.graph.evaluate(&[square], value);
    assert_near(&found, &[dot(expected, expected)], DIFFERENCE);
    // Nothing changes with the angle about the inertial axis.
    assert!(!contains(&geometry, square, Symbol::Coordinate(0)));
    let plain = by_elements(&mut geometry, &velocity, &velocity);
    assert!(cost(&geometry, &[square]) < cost(&geometry, &[plain]));
    // Also where the rotation is constant: its parts are their rates.
    let angle = geometry.graph.symbol(Symbol::Parameter(8));
    let tilt = geometry.rotation(&[(Axis::X, angle)]);
    let q = Matrix::vector(
        (0..3)
            .map(|i| geometry.graph.symbol(Symbol::Coordinate(i)))
            .collect(),
    );
    let v = Matrix::vector(
        (0..3)
            .map(|i| geometry.graph.symbol(Symbol::Velocity(i)))
            .collect(),
    );
    let tilted = product(&mut geometry, &[&tilt, &q]);
    let velocity = geometry.matrix_time_derivative(&tilted, 3);
    assert_eq!(geometry.norm_squared(&velocity), geometry.norm_squared(&v));
}

#[test]
fn a_tensor_in_space_is_one_in_the_body() {
    // ω · (R I Rᵀ ω) along inertial axes, in several orders.
    let mut geometry = Geometry::new();
    let r = by_coordinates(&mut geometry, "zxz", 0);
    let inertia = lagrangian_symbolic_testing::rows::parameters(&mut geometry.graph, 3, 3, 0);
    let body = geometry.angular_velocity(&r, 3).unwrap();
    let space = geometry.angular_velocity_inertial(&r, 3).unwrap();
    let momentum = product(&mut geometry, &[&inertia, &body]);
    let expected = geometry.dot_product(&body, &momentum);

    let back = r.transpose();
    let rotated = product(&mut geometry, &[&r, &inertia, &back]);
    let momentum = geometry.matrix_product(&rotated, &space).unwrap();
    assert_eq!(geometry.dot_product(&space, &momentum), expected);
    let half = geometry.matrix_product(&inertia, &back).unwrap();
    let momentum = product(&mut geometry, &[&r, &half, &space]);
    assert_eq!(geometry.dot_product(&space, &momentum), expected);
    let row = geometry
        .matrix_product(&space.transpose(), &rotated)
        .unwrap();
    let both = geometry.matrix_product(&row, &space).unwrap();
    let tensor = |i: u32, j: u32| value(Symbol::Parameter(3 * j + i));
    let spin = angular_velocity(|t| at("zxz", 0, t));
    let numbers: Rows = [0, 1, 2].map(|i: u32| [0, 1, 2].map(|j: u32| tensor(i, j)));
    let found = geometry.graph.evaluate(both.elements(), value);
    assert_near(
        &found,
        &[dot(spin, apply(&numbers, spin))],
        10.0 * DIFFERENCE,
    );
    assert_eq!(
        cost(&geometry, both.elements()),
        cost(&geometry, &[expected.unwrap()])
    );
    // Back in the body it is what it was there.
    assert_eq!(product(&mut geometry, &[&back, &space]), body);
}

#[test]
fn rotations_by_hand_count_if_they_are_rotations() {
    let mut geometry = Geometry::new();
    let v = vector(&mut geometry, 0);
    let r = written_out(&mut geometry, |geometry| by_coordinates(geometry, "zyx", 0));
    let tilt = written_out(&mut geometry, |geometry| {
        let angle = geometry.graph.symbol(Symbol::Coordinate(0));
        let constant = geometry.graph.symbol(Symbol::Parameter(9));
        geometry.rotation(&[(Axis::Y, constant), (Axis::X, angle)])
    });
    for rotation in [r, tilt] {
        let rotated = product(&mut geometry, &[&rotation, &v]);
        assert_eq!(geometry.norm_squared(&rotated), geometry.norm_squared(&v));
        assert_eq!(
            product(&mut geometry, &[&rotation.transpose(), &rotated]),
            v
        );
    }
    // Three fifths and four fifths are a rotation exactly, rounded numbers are none.
    for (digits, is_exact) in [([3, 4, 5], true), ([600_001, 800_000, 1_000_000], false)] {
        let [x, y, length] = digits.map(|digit| geometry.graph.integer(digit));
        let [cosine, sine] = [x, y].map(|x| geometry.graph.divide(x, length));
        let (zero, one, minus) = (
            geometry.graph.zero(),
            geometry.graph.one(),
            geometry.graph.negate(sine),
        );
        let elements = vec![cosine, sine, zero, minus, cosine, zero, zero, zero, one];
        let rotation = Matrix::new(3, 3, elements).unwrap();
        let rotated = product(&mut geometry, &[&rotation, &v]);
        let is_equal = geometry.norm_squared(&rotated) == geometry.norm_squared(&v);
        assert_eq!(is_equal, is_exact);
    }
}

#[test]
fn what_may_be_no_rotation_changes_lengths() {
    let mut geometry = Geometry::new();
    let v = vector(&mut geometry, 0);
    let r = by_coordinates(&mut geometry, "zyx", 0);
    // A matrix of parameters has an angular velocity on trust, and is multiplied as it is.
    let trusted = lagrangian_symbolic_testing::rows::parameters(&mut geometry.graph, 3, 3, 10);
    let plain: Rows =
        [0, 1, 2].map(|i: u32| [0, 1, 2].map(|j: u32| value(Symbol::Parameter(10 + 3 * j + i))));
    let rotated = product(&mut geometry, &[&trusted, &v]);
    let expected = apply(&plain, numbers(0));
    let square = geometry.norm_squared(&rotated);
    assert_relative(&geometry, square, dot(expected, expected));
    let back = product(&mut geometry, &[&trusted.transpose(), &rotated]);
    assert_ne!(back, v);
    // Before a rotation it is part of the rotated vector, behind one it ends what cancels.
    let both = product(&mut geometry, &[&r, &trusted, &v]);
    let square = geometry.norm_squared(&both);
    assert_relative(&geometry, square, dot(expected, expected));
    assert!((0..3).all(|i| !contains(&geometry, square, Symbol::Coordinate(i))));
    let both = product(&mut geometry, &[&trusted, &r, &v]);
    let square = geometry.norm_squared(&both);
    let expected = apply(&times(&plain, &now("zyx", 0)), numbers(0));
    assert_relative(&geometry, square, dot(expected, expected));
    // Its velocity in the inertial frame is not rotated back by it.
    let mounted = product(&mut geometry, &[&trusted, &r]);
    let velocity = geometry.angular_velocity_inertial(&mounted, 3).unwrap();
    let square = geometry.norm_squared(&velocity);
    let found = geometry.graph.evaluate(&[square], value);
    let elements = geometry.graph.evaluate(velocity.elements(), value);
    let expected: f64 = elements.iter().map(|x| x * x).sum();
    assert!((found[0] - expected).abs() < ROUNDING * expected);
}

#[test]
fn a_projection_and_a_reflection_are_no_rotations() {
    let mut geometry = Geometry::new();
    for is_flat in [true, false] {
        let mirrored = written_out(&mut geometry, |geometry| {
            let r = by_coordinates(geometry, "zyx", 0);
            let (zero, one) = (geometry.graph.zero(), geometry.graph.one());
            let last = if is_flat {
                zero
            } else {
                geometry.graph.negate(one)
            };
            let elements = vec![one, zero, zero, zero, one, zero, zero, zero, last];
            let deformed = Matrix::new(3, 3, elements).unwrap();
            product(geometry, &[&r, &deformed])
        });
        let [a, b] = [0, 3].map(|i| vector(&mut geometry, i));
        let [x, y] = [&a, &b].map(|v| product(&mut geometry, &[&mirrored, v]));
        let numbers_of = |first: u32| {
            let [x, y, z] = numbers(first);
            let z = if is_flat { 0.0 } else { -z };
            apply(&now("zyx", 0), [x, y, z])
        };
        let (p, q) = (numbers_of(0), numbers_of(3));
        let found = geometry.dot_product(&x, &y).unwrap();
        assert_is(&geometry, found, dot(p, q));
        let area = geometry.cross_product(&x, &y).unwrap();
        let square = geometry.norm_squared(&area);
        assert_relative(&geometry, square, dot(cross(p, q), cross(p, q)));
        let volume = geometry.dot_product(&area, &x).unwrap();
        assert_is(&geometry, volume, 0.0);
        let back = product(&mut geometry, &[&mirrored.transpose(), &area]);
        let mirror = [
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, if is_flat { 0.0 } else { -1.0 }],
        ];
        let expected = apply(&transposed(&times(&now("zyx", 0), &mirror)), cross(p, q));
        assert_vector(&geometry, &back, expected, ROUNDING);
    }
}

#[test]
fn vectors_in_independent_frames_are_added_by_elements() {
    let mut geometry = Geometry::new();
    let [r, s] = [("zx", 0), ("zx", 2)].map(|(axes, i)| by_coordinates(&mut geometry, axes, i));
    let [a, b] = [0, 3].map(|i| vector(&mut geometry, i));
    let (x, y) = (
        product(&mut geometry, &[&r, &a]),
        product(&mut geometry, &[&s, &b]),
    );
    let (p, q) = (
        apply(&now("zx", 0), numbers(0)),
        apply(&now("zx", 2), numbers(3)),
    );
    let found = geometry.dot_product(&x, &y).unwrap();
    assert_is(&geometry, found, dot(p, q));
    assert_eq!(found, by_elements(&mut geometry, &x, &y));
    let both = sum(&mut geometry, &[&x, &y]);
    let square = geometry.norm_squared(&both);
    assert_eq!(square, by_elements(&mut geometry, &both, &both));
    assert_relative(&geometry, square, dot(add(p, q), add(p, q)));
    // Turned together by a third they are added before it.
    let t = by_coordinates(&mut geometry, "y", 4);
    let rotated = product(&mut geometry, &[&t, &both]);
    let back = product(&mut geometry, &[&t.transpose(), &rotated]);
    assert_vector(&geometry, &back, add(p, q), ROUNDING);
}

#[track_caller]
fn assert_relative(geometry: &Geometry, found: Expression, expected: f64) {
    let found = geometry.graph.evaluate(&[found], value)[0];
    assert!(
        (found - expected).abs() < ROUNDING * expected.abs().max(1.0),
        "{found} is not {expected}"
    );
}
