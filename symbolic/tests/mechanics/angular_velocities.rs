//! Angular velocities, against numerical differences of rotation matrices.

use lagrangian_symbolic::{
    Axis, Expression, Geometry, Matrix, NoRotation, OperationCount, Program, Rational, Symbol,
};
use lagrangian_symbolic_testing::frames::{
    Rows, SEQUENCES, angular_velocity, assert_near, by_coordinates, elementary, moving, rotation,
    rows, times, transposed, written_out,
};
use lagrangian_symbolic_testing::systems::{cardan_rates, euler_rates};
use lagrangian_symbolic_testing::{Draft, Quantity, value, vector};

/// What a difference may be wrong by: roundings of 1e-16 over a step of 1e-4, and room for some of them.
const DIFFERENCE: f64 = 1e-10;

fn apply(matrix: &Rows, vector: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|i| (0..3).map(|j| matrix[i][j] * vector[j]).sum())
}

/// Compares both angular velocities of a matrix with those of the same matrix of numbers.
#[track_caller]
fn assert_velocities(geometry: &mut Geometry, matrix: &Matrix, at: impl Fn(f64) -> Rows) {
    let now = at(value(Symbol::Time));
    assert_near(&rows(geometry, matrix).concat(), &now.concat(), 1e-14);
    let expected = angular_velocity(at);
    let body = geometry.angular_velocity(matrix, 6).unwrap();
    assert_eq!(body.shape(), (3, 1));
    assert_near(
        &geometry.graph.evaluate(body.elements(), value),
        &expected,
        DIFFERENCE,
    );
    let inertial = geometry.angular_velocity_inertial(matrix, 6).unwrap();
    let expected = apply(&now, expected);
    assert_near(
        &geometry.graph.evaluate(inertial.elements(), value),
        &expected,
        DIFFERENCE,
    );
}

fn angles(time: f64) -> [f64; 3] {
    [0, 1, 2].map(|i| moving(i, time))
}

fn count(geometry: &Geometry, roots: &[Expression]) -> OperationCount {
    Program::schedule(&geometry.graph, &[roots]).count()
}

#[test]
fn of_all_sequences() {
    for sequence in SEQUENCES {
        let mut geometry = Geometry::new();
        let matrix = by_coordinates(&mut geometry, sequence, 0);
        assert_velocities(&mut geometry, &matrix, |t| rotation(sequence, &angles(t)));
        let back = matrix.transpose();
        assert_velocities(&mut geometry, &back, |t| {
            transposed(&rotation(sequence, &angles(t)))
        });
        let mut geometry = Geometry::new();
        let by_hand = written_out(&mut geometry, |geometry| {
            by_coordinates(geometry, sequence, 0)
        });
        assert_velocities(&mut geometry, &by_hand, |t| rotation(sequence, &angles(t)));
    }
}

#[test]
fn in_the_angles_of_the_book() {
    // (4.4), and the same for Cardan's angles, expression by expression.
    let draft = Draft::new(3);
    for (sequence, rates) in [("zxz", euler_rates(&draft)), ("xyz", cardan_rates(&draft))] {
        let expected = vector(rates);
        let geometry = &mut draft.geometry();
        // If the matrix is written element by element, and as a product.
        let by_hand = written_out(geometry, |geometry| by_coordinates(geometry, sequence, 0));
        let velocity = geometry.angular_velocity(&by_hand, 3).unwrap();
        assert_eq!(velocity, expected, "{sequence} by hand");
        let matrix = by_coordinates(geometry, sequence, 0);
        let velocity = geometry.angular_velocity(&matrix, 3).unwrap();
        assert_eq!(velocity, expected, "{sequence}");
    }
}

#[test]
fn cost_what_the_closed_form_costs() {
    // Of (4.4) six multiplications, three additions, and two angles.
    let draft = Draft::new(3);
    let book = euler_rates(&draft).map(Quantity::expression);
    let book = count(&draft.geometry(), &book);
    for sequence in SEQUENCES {
        for is_written_out in [true, false] {
            let mut geometry = Geometry::new();
            let matrix = if is_written_out {
                written_out(&mut geometry, |geometry| {
                    by_coordinates(geometry, sequence, 0)
                })
            } else {
                by_coordinates(&mut geometry, sequence, 0)
            };
            let body = geometry.angular_velocity(&matrix, 3).unwrap();
            assert_eq!(count(&geometry, body.elements()), book, "{sequence}");
            let inertial = geometry.angular_velocity_inertial(&matrix, 3).unwrap();
            assert_eq!(count(&geometry, inertial.elements()), book, "{sequence}");
        }
    }
    // Each rotation more turns the vector in a plane and adds a rate.
    let mut geometry = Geometry::new();
    let matrix = by_coordinates(&mut geometry, "zxzxy", 0);
    let found = geometry.angular_velocity(&matrix, 5).unwrap();
    let found = count(&geometry, found.elements());
    assert_eq!(found.additions, book.additions + 2 * 3);
    assert_eq!(found.multiplications, book.multiplications + 2 * 4);
}

#[test]
fn angles_are_any_expressions() {
    // The second angle is q₁ + w t², the third q₀ q₁, the first goes by a parameter's share.
    let draft = Draft::new(3);
    let ([a, b], [share, w, fixed], t) = (draft.qs(), draft.ps(), draft.time());
    let turns = [
        (Axis::Z, share * a),
        (Axis::X, b + w * t.squared()),
        (Axis::Y, a * b),
    ];
    let matrix = draft.rotation(turns);
    let fixed = draft.rotation([(Axis::Y, fixed)]);
    let geometry = &mut draft.geometry();
    let [share, w] = [0, 1].map(|i| value(Symbol::Parameter(i)));
    let at = |t: f64| {
        let [a, b, _] = angles(t);
        rotation("zxy", &[share * a, b + w * t * t, a * b])
    };
    assert_velocities(geometry, &matrix, at);
    let mut plain = Geometry::new();
    let elements = plain.graph.imported(&geometry.graph, matrix.elements());
    let by_hand = Matrix::new(3, 3, elements).unwrap();
    assert_velocities(&mut plain, &by_hand, at);
    // Where they are constant, nothing turns.
    let zero = Matrix::vector(vec![geometry.graph.zero(); 3]);
    assert_eq!(geometry.angular_velocity(&fixed, 3), Ok(zero));
}

#[test]
fn factors_are_of_any_kind() {
    // A joint, a mounting that is written in its parameters, a joint that is written by hand, and back.
    let mut geometry = Geometry::new();
    let first = by_coordinates(&mut geometry, "zx", 0);
    let mounting = written_out(&mut geometry, |geometry| {
        let [tilt, lean] = [0, 1].map(|i| geometry.graph.symbol(Symbol::Parameter(i)));
        geometry.rotation(&[(Axis::X, tilt), (Axis::Z, lean)])
    });
    let third = written_out(&mut geometry, |geometry| by_coordinates(geometry, "y", 2));
    let wheel = geometry.matrix_product(&first, &mounting).unwrap();
    let wheel = geometry.matrix_product(&wheel, &third).unwrap();
    let both = geometry.matrix_product(&wheel, &first.transpose()).unwrap();
    let [tilt, lean] = [0, 1].map(|i| value(Symbol::Parameter(i)));
    let at = |t: f64| {
        let [a, b, c] = angles(t);
        let first = rotation("zx", &[a, b]);
        let wheel = times(&rotation("xz", &[tilt, lean]), &elementary('y', c));
        times(&times(&first, &wheel), &transposed(&first))
    };
    assert_velocities(&mut geometry, &both, at);
    assert_velocities(&mut geometry, &both.transpose(), |t| transposed(&at(t)));
}

#[test]
fn a_rotation_by_hand_is_as_good_as_one_by_name() {
    let draft = Draft::new(1);
    let (q, zero, one) = (draft.q(0), draft.zero(), draft.one());
    let columns = [
        [q.cos(), q.sin(), zero],
        [-q.sin(), q.cos(), zero],
        [zero, zero, one],
    ];
    let elements = columns.as_flattened().iter().map(|x| x.expression());
    let matrix = Matrix::new(3, 3, elements.collect()).unwrap();
    let expected = Ok(vector([zero, zero, q.dot()]));
    let geometry = &mut draft.geometry();
    assert_eq!(geometry.angular_velocity(&matrix, 1), expected);
    assert_eq!(geometry.angular_velocity_inertial(&matrix, 1), expected);
}

/// The rotation matrix of Euler's parameters w, x, y, z.
fn of_euler_parameters(geometry: &mut Geometry, [w, x, y, z]: [Expression; 4]) -> Matrix {
    let vector = Matrix::vector(vec![x, y, z]);
    let cross = geometry.graph.cross_matrix(&vector).unwrap();
    let twice = geometry.matrix_product(&cross, &cross).unwrap();
    let along = geometry.matrix_scaled(&cross, w);
    let two = Rational::integer(2);
    let one = geometry.graph.identity_matrix(3);
    let terms = [(&one, Rational::ONE), (&along, two.clone()), (&twice, two)];
    geometry.matrix_sum(&terms).unwrap()
}

#[test]
fn of_a_matrix_of_half_angles() {
    // Euler's parameters of the rotation zxz, in sines and cosines of half angles.
    let draft = Draft::new(3);
    let [phi, theta, psi] = draft.qs();
    let (tilt, sum, difference) = (theta / 2, (phi + psi) / 2, (phi - psi) / 2);
    let parameters = [
        tilt.cos() * sum.cos(),
        tilt.sin() * difference.cos(),
        tilt.sin() * difference.sin(),
        tilt.cos() * sum.sin(),
    ];
    let geometry = &mut draft.geometry();
    let matrix = of_euler_parameters(geometry, parameters.map(Quantity::expression));
    assert_velocities(geometry, &matrix, |t| rotation("zxz", &angles(t)));
    // What the rules of sums alone make of it has 18 additions and 39 multiplications.
    let velocity = geometry.angular_velocity(&matrix, 3).unwrap();
    let found = count(geometry, velocity.elements());
    assert!(
        found.additions <= 8 && found.multiplications <= 18,
        "{found:?}"
    );
}

/// The diagonal matrix of three numbers.
fn diagonal(geometry: &mut Geometry, numbers: [i64; 3]) -> Matrix {
    let numbers = numbers.map(|number| geometry.graph.integer(number));
    let vector = Matrix::vector(numbers.to_vec());
    geometry.graph.diagonal_matrix(&vector).unwrap()
}

#[test]
fn what_is_no_rotation_has_none() {
    let mut geometry = Geometry::new();
    let turn = by_coordinates(&mut geometry, "zxz", 0);
    let [q, r] = [3, 0].map(|i| geometry.graph.symbol(Symbol::Coordinate(i)));
    let two = geometry.graph.integer(2);
    let doubled = geometry.matrix_scaled(&turn, two);
    let stretched = geometry.matrix_scaled(&turn, q);
    let stretch = diagonal(&mut geometry, [2, 2, 2]);
    let with_stretch = geometry.matrix_product(&turn, &stretch).unwrap();
    let crossing = Matrix::vector(vec![q, r, two]);
    let crossing = geometry.graph.cross_matrix(&crossing).unwrap();
    // One sign of one element is wrong.
    let mut elements = turn.elements().to_vec();
    elements[4] = geometry.graph.negate(elements[4]);
    let mistaken = Matrix::new(3, 3, elements).unwrap();
    for matrix in [doubled, stretched, with_stretch, crossing, mistaken] {
        let found = geometry.angular_velocity(&matrix, 4);
        assert_eq!(found, Err(NoRotation::Deformation));
        let found = geometry.angular_velocity_inertial(&matrix, 4);
        assert_eq!(found, Err(NoRotation::Deformation));
    }
    let vector = turn.block((0, 0), (3, 1)).unwrap();
    let found = geometry.angular_velocity(&vector, 4);
    assert_eq!(found, Err(NoRotation::Shape));
}

#[test]
fn constant_matrices_are_refused_only_if_they_are_numbers() {
    let mut geometry = Geometry::new();
    let turn = by_coordinates(&mut geometry, "z", 0);
    let (zero, one) = (geometry.graph.zero(), geometry.graph.one());
    let shear = Matrix::new(3, 3, vec![one, zero, zero, one, one, zero, zero, zero, one]).unwrap();
    let sheared = geometry.matrix_product(&turn, &shear).unwrap();
    for matrix in [&shear, &sheared] {
        let found = geometry.angular_velocity(matrix, 1);
        assert_eq!(found, Err(NoRotation::Deformation));
    }
    // Parameters may be such that they make a rotation.
    let elements = (0..9)
        .map(|i| geometry.graph.symbol(Symbol::Parameter(i)))
        .collect();
    let mounting = Matrix::new(3, 3, elements).unwrap();
    let mounted = geometry.matrix_product(&turn, &mounting).unwrap();
    let v = geometry.graph.symbol(Symbol::Velocity(0));
    let axis = mounting.block((2, 0), (1, 3)).unwrap().transpose();
    let expected = geometry.matrix_scaled(&axis, v);
    assert_eq!(geometry.angular_velocity(&mounted, 1), Ok(expected));
}

#[test]
fn reflections_are_refused_unless_they_are_two() {
    let mut geometry = Geometry::new();
    let mirrored_turn = |geometry: &mut Geometry| {
        let turn = by_coordinates(geometry, "zxz", 0);
        let mirror = diagonal(geometry, [1, 1, -1]);
        geometry.matrix_product(&turn, &mirror).unwrap()
    };
    let by_hand = written_out(&mut geometry, mirrored_turn);
    let found = geometry.angular_velocity(&by_hand, 3);
    assert_eq!(found, Err(NoRotation::Reflection));
    let mirrored = mirrored_turn(&mut geometry);
    let mirror = diagonal(&mut geometry, [1, 1, -1]);
    let found = geometry.angular_velocity(&mirrored, 3);
    assert_eq!(found, Err(NoRotation::Reflection));
    // Both of its factors are reflections, and it is a rotation.
    let back = geometry.matrix_product(&mirrored, &mirror).unwrap();
    assert_velocities(&mut geometry, &back, |t| rotation("zxz", &angles(t)));
}

#[test]
fn numbers_may_be_rounded() {
    let mut geometry = Geometry::new();
    let turn = by_coordinates(&mut geometry, "z", 0);
    let [s, c] = ["0.6427876097", "0.7660444431"].map(|x| Rational::from_decimal(x).unwrap());
    let [minus, s, c] = [-&s, s, c].map(|x| geometry.graph.constant(&x));
    let (zero, one) = (geometry.graph.zero(), geometry.graph.one());
    let elements = vec![one, zero, zero, zero, c, s, zero, minus, c];
    let mounting = Matrix::new(3, 3, elements).unwrap();
    let both = geometry.matrix_product(&turn, &mounting).unwrap();
    let found = geometry.angular_velocity(&both, 1).unwrap();
    let v = geometry.graph.symbol(Symbol::Velocity(0));
    let expected = vec![
        zero,
        geometry.graph.multiply(s, v),
        geometry.graph.multiply(c, v),
    ];
    assert_eq!(found, Matrix::vector(expected));
}
