//! Vectors that are known in frames: what is computed before they are rotated, where that would
//! be wrong, and all values against plain loops over numbers.

use lagrangian_symbolic::{Axis, Expression, Graph, Matrix, Program, Rational, Symbol};
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
fn vector(graph: &mut Graph, first: u32) -> Matrix {
    let symbols = (first..first + 3).map(Symbol::Parameter);
    Matrix::vector(symbols.map(|symbol| graph.symbol(symbol)).collect())
}

/// The same numerically.
fn numbers(first: u32) -> Numbers {
    [0, 1, 2].map(|i| value(Symbol::Parameter(first + i)))
}

/// x · y by the components.
fn by_elements(graph: &mut Graph, x: &Matrix, y: &Matrix) -> Expression {
    let pairs = x.elements().iter().zip(y.elements());
    let products: Vec<_> = pairs
        .map(|(x, y)| (graph.multiply(*x, *y), Rational::ONE))
        .collect();
    graph.sum(products)
}

fn product(graph: &mut Graph, factors: &[&Matrix]) -> Matrix {
    let (last, others) = factors.split_last().unwrap();
    let mut product = (*last).clone();
    for factor in others.iter().rev() {
        product = graph.matrix_product(factor, &product).unwrap();
    }
    product
}

fn sum(graph: &mut Graph, terms: &[&Matrix]) -> Matrix {
    let terms: Vec<_> = terms.iter().map(|x| (*x, Rational::ONE)).collect();
    graph.matrix_sum(&terms).unwrap()
}

fn cost(graph: &Graph, roots: &[Expression]) -> usize {
    Program::schedule(graph, &[roots]).count().cost()
}

fn contains(graph: &Graph, root: Expression, symbol: Symbol) -> bool {
    graph.symbols(&[root]).contains(&symbol)
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
fn assert_is(graph: &Graph, found: Expression, expected: f64) {
    assert_near(&graph.evaluate(&[found], value), &[expected], ROUNDING);
}

#[track_caller]
fn assert_vector(graph: &Graph, found: &Matrix, expected: Numbers, tolerance: f64) {
    let found = graph.evaluate(found.elements(), value);
    assert_near(&found, &expected, tolerance);
}

#[test]
fn factors_cancel_from_the_left() {
    let mut graph = Graph::new();
    let [r, s] = [("zxz", 0), ("yx", 3)].map(|(axes, i)| by_coordinates(&mut graph, axes, i));
    let v = vector(&mut graph, 0);
    // Rᵀ (R v) and R (Rᵀ v).
    let back = r.transpose();
    assert_eq!(product(&mut graph, &[&back, &r, &v]), v);
    assert_eq!(product(&mut graph, &[&r, &back, &v]), v);
    // (R S)ᵀ (R v) = Sᵀ v, and R (Rᵀ S v) = S v.
    let both = product(&mut graph, &[&r, &s]).transpose();
    let expected = product(&mut graph, &[&s.transpose(), &v]);
    assert_eq!(product(&mut graph, &[&both, &r, &v]), expected);
    let there = product(&mut graph, &[&back, &s]);
    let expected = product(&mut graph, &[&s, &v]);
    assert_eq!(product(&mut graph, &[&r, &there, &v]), expected);
    // The same for rows.
    let row = product(&mut graph, &[&v.transpose(), &r]);
    assert_eq!(graph.matrix_product(&row, &back), Some(v.transpose()));
    // One rotation about the same axis does not cancel another.
    let [a, b] = [0, 1].map(|i| by_coordinates(&mut graph, "z", i));
    let found = product(&mut graph, &[&a.transpose(), &b, &v]);
    let expected = apply(&times(&transposed(&now("z", 0)), &now("z", 1)), numbers(0));
    assert_vector(&graph, &found, expected, ROUNDING);
}

#[test]
fn lengths_and_angles_are_those_before_the_turn() {
    let mut graph = Graph::new();
    let [r, s] = [("zyx", 0), ("yx", 3)].map(|(axes, i)| by_coordinates(&mut graph, axes, i));
    let [a, b] = [0, 3].map(|i| vector(&mut graph, i));
    let [x, y] = [&a, &b].map(|v| product(&mut graph, &[&r, v]));
    assert_eq!(graph.norm_squared(&x), graph.norm_squared(&a));
    assert_eq!(graph.norm(&x), graph.norm(&a));
    assert_eq!(graph.dot_product(&x, &y), graph.dot_product(&a, &b));
    let (x_row, y_row) = (x.transpose(), y.transpose());
    assert_eq!(graph.dot_product(&x_row, &y_row), graph.dot_product(&a, &b));
    let by_product = graph.matrix_product(&x_row, &y).unwrap();
    assert_eq!(by_product.get(0, 0), graph.dot_product(&a, &b));
    // R S a · R b = S a · b.
    let rotated = product(&mut graph, &[&r, &s, &a]);
    let found = graph.dot_product(&rotated, &y).unwrap();
    let before = product(&mut graph, &[&s, &a]);
    let expected = graph.dot_product(&before, &b).unwrap();
    assert_eq!(cost(&graph, &[found]), cost(&graph, &[expected]));
    let values = dot(apply(&now("yx", 3), numbers(0)), numbers(3));
    assert_is(&graph, found, values);
    assert!((0..3).all(|i| !contains(&graph, found, Symbol::Coordinate(i))));
}

#[test]
fn sums_and_multiples_are_rotated_as_one() {
    let mut graph = Graph::new();
    let [r, s] = [("zyx", 0), ("y", 3)].map(|(axes, i)| by_coordinates(&mut graph, axes, i));
    let [a, b] = [0, 3].map(|i| vector(&mut graph, i));
    let [x, y] = [&a, &b].map(|v| product(&mut graph, &[&r, v]));
    // R a + R b and c R a.
    let (both, before) = (sum(&mut graph, &[&x, &y]), sum(&mut graph, &[&a, &b]));
    assert_eq!(graph.norm_squared(&both), graph.norm_squared(&before));
    let c = graph.symbol(Symbol::Parameter(7));
    let (scaled, before) = (graph.matrix_scaled(&x, c), graph.matrix_scaled(&a, c));
    assert_eq!(graph.norm_squared(&scaled), graph.norm_squared(&before));
    // What cancels is gone.
    let terms = [(&x, Rational::ONE), (&x, Rational::MINUS_ONE)];
    let nothing = graph.matrix_sum(&terms).unwrap();
    assert_eq!(graph.norm_squared(&nothing), graph.zero());
    // R S a + R b = R (S a + b).
    let rotated = product(&mut graph, &[&r, &s, &a]);
    let found = sum(&mut graph, &[&rotated, &y]);
    let found = graph.norm_squared(&found);
    let expected = add(apply(&now("y", 3), numbers(0)), numbers(3));
    assert_is(&graph, found, dot(expected, expected));
    assert!((0..3).all(|i| !contains(&graph, found, Symbol::Coordinate(i))));
}

#[test]
fn vector_products_are_rotated() {
    let mut graph = Graph::new();
    let [r, s] = [("zyx", 0), ("yx", 3)].map(|(axes, i)| by_coordinates(&mut graph, axes, i));
    let [a, b] = [0, 3].map(|i| vector(&mut graph, i));
    let [x, y] = [&a, &b].map(|v| product(&mut graph, &[&r, v]));
    let found = graph.cross_product(&x, &y).unwrap();
    let before = graph.cross_product(&a, &b).unwrap();
    let expected = apply(&now("zyx", 0), cross(numbers(0), numbers(3)));
    assert_vector(&graph, &found, expected, ROUNDING);
    assert_eq!(product(&mut graph, &[&r.transpose(), &found]), before);
    // Only R is common to R S a and R b.
    let rotated = product(&mut graph, &[&r, &s, &a]);
    let found = graph.cross_product(&rotated, &y).unwrap();
    let found = product(&mut graph, &[&r.transpose(), &found]);
    let expected = cross(apply(&now("yx", 3), numbers(0)), numbers(3));
    assert_vector(&graph, &found, expected, ROUNDING);
    assert!((0..3).all(|i| !contains(&graph, found.elements()[0], Symbol::Coordinate(i))));
}

#[test]
fn velocities_are_rotated_with_the_body() {
    // d/dt R v = R (ω × v + v̇), of a point that moves in the body.
    let mut graph = Graph::new();
    let r = by_coordinates(&mut graph, "zxz", 0);
    let mut center = vector(&mut graph, 0).elements().to_vec();
    center[2] = graph.symbol(Symbol::Coordinate(3));
    let point = product(&mut graph, &[&r, &Matrix::vector(center)]);
    let velocity = graph.matrix_time_derivative(&point, 4);
    let square = graph.norm_squared(&velocity);

    let spin = angular_velocity(|t| at("zxz", 0, t));
    let position = [
        value(Symbol::Parameter(0)),
        value(Symbol::Parameter(1)),
        value(Symbol::Coordinate(3)),
    ];
    let rate = [0.0, 0.0, value(Symbol::Velocity(3))];
    let expected = add(cross(spin, position), rate);
    let found = graph.evaluate(&[square], value);
    assert_near(&found, &[dot(expected, expected)], DIFFERENCE);
    // Nothing changes with the angle about the inertial axis.
    assert!(!contains(&graph, square, Symbol::Coordinate(0)));
    let plain = by_elements(&mut graph, &velocity, &velocity);
    assert!(cost(&graph, &[square]) < cost(&graph, &[plain]));
    // Also where the rotation is constant: its parts are their rates.
    let angle = graph.symbol(Symbol::Parameter(8));
    let tilt = graph.rotation(&[(Axis::X, angle)]);
    let q = Matrix::vector(
        (0..3)
            .map(|i| graph.symbol(Symbol::Coordinate(i)))
            .collect(),
    );
    let v = Matrix::vector((0..3).map(|i| graph.symbol(Symbol::Velocity(i))).collect());
    let tilted = product(&mut graph, &[&tilt, &q]);
    let velocity = graph.matrix_time_derivative(&tilted, 3);
    assert_eq!(graph.norm_squared(&velocity), graph.norm_squared(&v));
}

#[test]
fn a_tensor_in_space_is_one_in_the_body() {
    // ω · (R I Rᵀ ω) along inertial axes, in several orders.
    let mut graph = Graph::new();
    let r = by_coordinates(&mut graph, "zxz", 0);
    let inertia = lagrangian_symbolic_testing::rows::parameters(&mut graph, 3, 3, 0);
    let body = graph.angular_velocity(&r, 3).unwrap();
    let space = graph.angular_velocity_inertial(&r, 3).unwrap();
    let momentum = product(&mut graph, &[&inertia, &body]);
    let expected = graph.dot_product(&body, &momentum);

    let back = r.transpose();
    let rotated = product(&mut graph, &[&r, &inertia, &back]);
    let momentum = graph.matrix_product(&rotated, &space).unwrap();
    assert_eq!(graph.dot_product(&space, &momentum), expected);
    let half = graph.matrix_product(&inertia, &back).unwrap();
    let momentum = product(&mut graph, &[&r, &half, &space]);
    assert_eq!(graph.dot_product(&space, &momentum), expected);
    let row = graph.matrix_product(&space.transpose(), &rotated).unwrap();
    let both = graph.matrix_product(&row, &space).unwrap();
    let tensor = |i: u32, j: u32| value(Symbol::Parameter(3 * j + i));
    let spin = angular_velocity(|t| at("zxz", 0, t));
    let numbers: Rows = [0, 1, 2].map(|i: u32| [0, 1, 2].map(|j: u32| tensor(i, j)));
    let found = graph.evaluate(both.elements(), value);
    assert_near(
        &found,
        &[dot(spin, apply(&numbers, spin))],
        10.0 * DIFFERENCE,
    );
    assert_eq!(
        cost(&graph, both.elements()),
        cost(&graph, &[expected.unwrap()])
    );
    // Back in the body it is what it was there.
    assert_eq!(product(&mut graph, &[&back, &space]), body);
}

#[test]
fn rotations_by_hand_count_if_they_are_rotations() {
    let mut graph = Graph::new();
    let v = vector(&mut graph, 0);
    let r = written_out(&mut graph, |graph| by_coordinates(graph, "zyx", 0));
    let tilt = written_out(&mut graph, |graph| {
        let angle = graph.symbol(Symbol::Coordinate(0));
        let constant = graph.symbol(Symbol::Parameter(9));
        graph.rotation(&[(Axis::Y, constant), (Axis::X, angle)])
    });
    for rotation in [r, tilt] {
        let rotated = product(&mut graph, &[&rotation, &v]);
        assert_eq!(graph.norm_squared(&rotated), graph.norm_squared(&v));
        assert_eq!(product(&mut graph, &[&rotation.transpose(), &rotated]), v);
    }
    // Three fifths and four fifths are a rotation exactly, rounded numbers are none.
    for (digits, is_exact) in [([3, 4, 5], true), ([600_001, 800_000, 1_000_000], false)] {
        let [x, y, length] = digits.map(|digit| graph.integer(digit));
        let [cosine, sine] = [x, y].map(|x| graph.divide(x, length));
        let (zero, one, minus) = (graph.zero(), graph.one(), graph.negate(sine));
        let elements = vec![cosine, sine, zero, minus, cosine, zero, zero, zero, one];
        let rotation = Matrix::new(3, 3, elements).unwrap();
        let rotated = product(&mut graph, &[&rotation, &v]);
        let is_equal = graph.norm_squared(&rotated) == graph.norm_squared(&v);
        assert_eq!(is_equal, is_exact);
    }
}

#[test]
fn what_may_be_no_rotation_changes_lengths() {
    let mut graph = Graph::new();
    let v = vector(&mut graph, 0);
    let r = by_coordinates(&mut graph, "zyx", 0);
    // A matrix of parameters has an angular velocity on trust, and is multiplied as it is.
    let trusted = lagrangian_symbolic_testing::rows::parameters(&mut graph, 3, 3, 10);
    let plain: Rows =
        [0, 1, 2].map(|i: u32| [0, 1, 2].map(|j: u32| value(Symbol::Parameter(10 + 3 * j + i))));
    let rotated = product(&mut graph, &[&trusted, &v]);
    let expected = apply(&plain, numbers(0));
    let square = graph.norm_squared(&rotated);
    assert_relative(&graph, square, dot(expected, expected));
    let back = product(&mut graph, &[&trusted.transpose(), &rotated]);
    assert_ne!(back, v);
    // Before a rotation it is part of the rotated vector, behind one it ends what cancels.
    let both = product(&mut graph, &[&r, &trusted, &v]);
    let square = graph.norm_squared(&both);
    assert_relative(&graph, square, dot(expected, expected));
    assert!((0..3).all(|i| !contains(&graph, square, Symbol::Coordinate(i))));
    let both = product(&mut graph, &[&trusted, &r, &v]);
    let square = graph.norm_squared(&both);
    let expected = apply(&times(&plain, &now("zyx", 0)), numbers(0));
    assert_relative(&graph, square, dot(expected, expected));
    // Its velocity in the inertial frame is not rotated back by it.
    let mounted = product(&mut graph, &[&trusted, &r]);
    let velocity = graph.angular_velocity_inertial(&mounted, 3).unwrap();
    let square = graph.norm_squared(&velocity);
    let found = graph.evaluate(&[square], value);
    let elements = graph.evaluate(velocity.elements(), value);
    let expected: f64 = elements.iter().map(|x| x * x).sum();
    assert!((found[0] - expected).abs() < ROUNDING * expected);
}

#[test]
fn a_projection_and_a_reflection_are_no_rotations() {
    let mut graph = Graph::new();
    for is_flat in [true, false] {
        let mirrored = written_out(&mut graph, |graph| {
            let r = by_coordinates(graph, "zyx", 0);
            let (zero, one) = (graph.zero(), graph.one());
            let last = if is_flat { zero } else { graph.negate(one) };
            let elements = vec![one, zero, zero, zero, one, zero, zero, zero, last];
            let deformed = Matrix::new(3, 3, elements).unwrap();
            product(graph, &[&r, &deformed])
        });
        let [a, b] = [0, 3].map(|i| vector(&mut graph, i));
        let [x, y] = [&a, &b].map(|v| product(&mut graph, &[&mirrored, v]));
        let numbers_of = |first: u32| {
            let [x, y, z] = numbers(first);
            let z = if is_flat { 0.0 } else { -z };
            apply(&now("zyx", 0), [x, y, z])
        };
        let (p, q) = (numbers_of(0), numbers_of(3));
        let found = graph.dot_product(&x, &y).unwrap();
        assert_is(&graph, found, dot(p, q));
        let area = graph.cross_product(&x, &y).unwrap();
        let square = graph.norm_squared(&area);
        assert_relative(&graph, square, dot(cross(p, q), cross(p, q)));
        let volume = graph.dot_product(&area, &x).unwrap();
        assert_is(&graph, volume, 0.0);
        let back = product(&mut graph, &[&mirrored.transpose(), &area]);
        let mirror = [
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, if is_flat { 0.0 } else { -1.0 }],
        ];
        let expected = apply(&transposed(&times(&now("zyx", 0), &mirror)), cross(p, q));
        assert_vector(&graph, &back, expected, ROUNDING);
    }
}

#[test]
fn vectors_in_independent_frames_are_added_by_elements() {
    let mut graph = Graph::new();
    let [r, s] = [("zx", 0), ("zx", 2)].map(|(axes, i)| by_coordinates(&mut graph, axes, i));
    let [a, b] = [0, 3].map(|i| vector(&mut graph, i));
    let (x, y) = (
        product(&mut graph, &[&r, &a]),
        product(&mut graph, &[&s, &b]),
    );
    let (p, q) = (
        apply(&now("zx", 0), numbers(0)),
        apply(&now("zx", 2), numbers(3)),
    );
    let found = graph.dot_product(&x, &y).unwrap();
    assert_is(&graph, found, dot(p, q));
    assert_eq!(found, by_elements(&mut graph, &x, &y));
    let both = sum(&mut graph, &[&x, &y]);
    let square = graph.norm_squared(&both);
    assert_eq!(square, by_elements(&mut graph, &both, &both));
    assert_relative(&graph, square, dot(add(p, q), add(p, q)));
    // Turned together by a third they are added before it.
    let t = by_coordinates(&mut graph, "y", 4);
    let rotated = product(&mut graph, &[&t, &both]);
    let back = product(&mut graph, &[&t.transpose(), &rotated]);
    assert_vector(&graph, &back, add(p, q), ROUNDING);
}

#[track_caller]
fn assert_relative(graph: &Graph, found: Expression, expected: f64) {
    let found = graph.evaluate(&[found], value)[0];
    assert!(
        (found - expected).abs() < ROUNDING * expected.abs().max(1.0),
        "{found} is not {expected}"
    );
}
