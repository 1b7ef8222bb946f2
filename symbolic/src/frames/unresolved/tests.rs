//! Vectors that are resolved last have the components that they have when resolved at once.

use crate::frames::axis::Axis;
use crate::frames::factor::{ElementaryRotation, MatrixFactor};
use crate::frames::matrix::Matrix;
use crate::frames::rotation::NoRotation;
use crate::frames::vector_in_frames::Term;
use crate::{Expression, Geometry, Rational, Symbol, Unary};

const COORDINATES: u32 = 4;

/// A number for each symbol.
fn value(symbol: Symbol) -> f64 {
    let (kind, index) = symbol.code();
    let [kind, index] = [kind, u64::from(index)].map(|x| u32::try_from(x).map_or(0.0, f64::from));
    0.3 + (1.7 * kind + 0.9 * index).sin()
}

/// The values of what is made in a graph whose vectors are resolved at once, and last.
fn both(make: impl Fn(&mut Geometry) -> Vec<Expression>) -> [Vec<f64>; 2] {
    let graphs = [
        Geometry::new(),
        Geometry::new().with_unresolved_vectors(COORDINATES),
    ];
    graphs.map(|mut geometry| {
        let roots = make(&mut geometry);
        let roots = geometry.resolved(&roots);
        geometry.graph.evaluate(&roots, value)
    })
}

#[track_caller]
fn assert_equal(make: impl Fn(&mut Geometry) -> Vec<Expression>) {
    let [at_once, last] = both(make);
    assert_eq!(at_once.len(), last.len());
    for (x, y) in at_once.iter().zip(&last) {
        assert!((x - y).abs() < 1e-12, "{y} is not {x}");
    }
}

/// The rotation by coordinates about these axes, the first by the coordinate of this number.
fn rotation(geometry: &mut Geometry, axes: &[Axis], first: u32) -> Matrix {
    let angles = (first..).map(Symbol::Coordinate);
    let turns: Vec<_> = axes
        .iter()
        .zip(angles)
        .map(|(axis, angle)| (*axis, geometry.graph.symbol(angle)))
        .collect();
    geometry.rotation(&turns)
}

/// The parameters from this number on.
fn vector(geometry: &mut Geometry, first: u32) -> Matrix {
    let symbols = (first..first + 3).map(Symbol::Parameter);
    Matrix::vector(
        symbols
            .map(|symbol| geometry.graph.symbol(symbol))
            .collect(),
    )
}

/// The point R a + R S b of a chain of two links, with R and R S.
fn chain(geometry: &mut Geometry) -> Option<(Matrix, [Matrix; 2])> {
    let first = rotation(geometry, &[Axis::Z, Axis::Y], 0);
    let second = rotation(geometry, &[Axis::X], 2);
    let second = geometry.matrix_product(&first, &second)?;
    let (a, b) = (vector(geometry, 0), vector(geometry, 3));
    let a = geometry.matrix_product(&first, &a)?;
    let b = geometry.matrix_product(&second, &b)?;
    let sum = geometry.matrix_sum(&[(&a, Rational::ONE), (&b, Rational::ONE)])?;
    Some((sum, [first, second]))
}

#[test]
fn positions_and_velocities_of_a_chain() {
    assert_equal(|geometry| {
        let (point, [first, _]) = chain(geometry).unwrap();
        let velocity = geometry.matrix_time_derivative(&point, COORDINATES);
        let half = geometry.graph.constant(&Rational::HALF);
        let scaled = geometry.matrix_scaled(&velocity, half);
        // Along the axes of the first link, as a row.
        let along = geometry
            .matrix_product(&first.transpose(), &scaled)
            .unwrap();
        let row = geometry
            .matrix_product(&scaled.transpose(), &first)
            .unwrap();
        let difference = [
            (&along, Rational::ONE),
            (&row.transpose(), Rational::integer(3)),
        ];
        let difference = geometry.matrix_sum(&difference).unwrap();
        let square = geometry.norm_squared(&velocity);
        let product = geometry.dot_product(&velocity, &point).unwrap();
        let moment = geometry.cross_product(&point, &velocity).unwrap();
        let mut roots = [point, along, row, difference, moment].map(|x| x.elements().to_vec());
        roots[0].extend([square, product]);
        roots.concat()
    });
}

#[test]
fn angular_velocities_and_what_is_made_of_them() {
    assert_equal(|geometry| {
        let (_, [_, second]) = chain(geometry).unwrap();
        let body = geometry.angular_velocity(&second, COORDINATES).unwrap();
        let space = geometry
            .angular_velocity_inertial(&second, COORDINATES)
            .unwrap();
        let tensor: Vec<_> = (10..19)
            .map(|i| geometry.graph.symbol(Symbol::Parameter(i)))
            .collect();
        let tensor = Matrix::new(3, 3, tensor).unwrap();
        let momentum = geometry.matrix_product(&tensor, &body).unwrap();
        let energy = geometry.dot_product(&body, &momentum).unwrap();
        let back = second.transpose();
        let turned = geometry.matrix_product(&tensor, &back).unwrap();
        let turned = geometry.matrix_product(&second, &turned).unwrap();
        let turned = geometry.matrix_product(&turned, &space).unwrap();
        let same = geometry.dot_product(&space, &turned).unwrap();
        let mut roots = [body, space, turned]
            .map(|x| x.elements().to_vec())
            .concat();
        roots.extend([energy, same]);
        roots
    });
}

#[test]
fn what_does_not_fit_is_computed_with_the_components() {
    assert_equal(|geometry| {
        let (point, [first, _]) = chain(geometry).unwrap();
        let [x, y, _] = point.components().unwrap();
        // An angle between components, a rotation by it, and their derivatives.
        let angle = geometry.graph.divide(y, x);
        let angle = geometry.graph.unary(Unary::Atan, angle);
        let rate = geometry.time_derivatives(&[angle], COORDINATES)[0];
        let turn = geometry.rotation(&[(Axis::Z, angle)]);
        let turned = geometry.matrix_product(&turn, &point).unwrap();
        let velocity = geometry.matrix_time_derivative(&turned, COORDINATES);
        let spin = geometry.angular_velocity(&turn, COORDINATES).unwrap();
        // The derivative of components along axes that turn.
        let along = geometry
            .matrix_product(&first.transpose(), &velocity)
            .unwrap();
        let second = geometry.matrix_time_derivative(&along, COORDINATES);
        let mut roots = [velocity, spin, second]
            .map(|x| x.elements().to_vec())
            .concat();
        roots.push(rate);
        roots
    });
}

#[test]
fn a_projection_has_no_angular_velocity() {
    let mut geometry = Geometry::new().with_unresolved_vectors(COORDINATES);
    let turn = rotation(&mut geometry, &[Axis::Z], 0);
    let (zero, one) = (geometry.graph.zero(), geometry.graph.one());
    let flat = vec![one, zero, zero, zero, one, zero, zero, zero, zero];
    let flat = Matrix::new(3, 3, flat).unwrap();
    let product = geometry.matrix_product(&turn, &flat).unwrap();
    let velocity = geometry.angular_velocity(&product, COORDINATES);
    assert_eq!(velocity, Err(NoRotation::Deformation));
}

/// The rotation of Denavit and Hartenberg is one about z and a constant one about x.
#[test]
fn rotations_that_are_written_out_are_recognized() {
    let mut geometry = Geometry::new().with_unresolved_vectors(COORDINATES);
    let q = geometry.graph.symbol(Symbol::Coordinate(1));
    let twist = geometry.graph.symbol(Symbol::Parameter(0));
    let product = geometry.rotation(&[(Axis::Z, q), (Axis::X, twist)]);
    let elements: [Expression; 9] = product.elements().try_into().unwrap();
    let [about_z, about_x] = [(Axis::Z, q), (Axis::X, twist)].map(|(axis, angle)| {
        MatrixFactor::Elementary(ElementaryRotation {
            axis,
            angle,
            reversed: false,
        })
    });
    assert_eq!(
        geometry.graph.recognized_factors(elements),
        [about_z, about_x]
    );
    // In the other order, and the transpose of one turn.
    let other = geometry.rotation(&[(Axis::X, twist), (Axis::Z, q)]);
    let elements = other.elements().try_into().unwrap();
    assert_eq!(
        geometry.graph.recognized_factors(elements),
        [about_x, about_z]
    );
    let back = about_z.transpose().elements(&mut geometry.graph);
    assert_eq!(
        geometry.graph.recognized_factors(back),
        [about_z.transpose()]
    );
    // One that depends on two coordinates stays one matrix.
    let both = rotation(&mut geometry, &[Axis::X, Axis::Y], 0);
    let elements = both.elements().try_into().unwrap();
    assert_eq!(
        geometry.graph.recognized_factors(elements),
        [MatrixFactor::Rotation(elements)]
    );
}

/// The rate of a coordinate along an axis, times a number.
fn rate(geometry: &mut Geometry, axis: Axis, coordinate: u32, number: i64) -> Matrix {
    let velocity = geometry.graph.symbol(Symbol::Velocity(coordinate));
    let velocity = geometry.graph.scale(velocity, &Rational::integer(number));
    let mut components = vec![geometry.graph.zero(); 3];
    components[axis.cycle()[0]] = velocity;
    Matrix::vector(components)
}

/// Angular velocities and velocities of the joints of three links, with the first turned by `base` times its coordinate,
/// and turned back to the axes of each link, or forth by mistake.
fn recursion(geometry: &mut Geometry, base: i64, is_back: bool) -> Option<[Matrix; 4]> {
    let mut w = rate(geometry, Axis::Z, 0, base);
    let mut v = Matrix::vector(vec![geometry.graph.zero(); 3]);
    let mut all = Vec::new();
    for (joint, axis) in [(1, Axis::Y), (2, Axis::Z)] {
        let turn = rotation(geometry, &[axis], joint);
        let turn = if is_back { turn.transpose() } else { turn };
        let link = vector(geometry, 3 * joint);
        let swing = geometry.cross_product(&w, &link)?;
        let moved = [(&v, Rational::ONE), (&swing, Rational::ONE)];
        let moved = geometry.matrix_sum(&moved)?;
        v = geometry.matrix_product(&turn, &moved)?;
        let turned = geometry.matrix_product(&turn, &w)?;
        let own = rate(geometry, axis, joint, 1);
        w = geometry.matrix_sum(&[(&turned, Rational::ONE), (&own, Rational::ONE)])?;
        all.extend([w.clone(), v.clone()]);
    }
    all.try_into().ok()
}

#[test]
fn velocities_that_are_computed_along_a_chain() {
    for (base, is_back) in [(1, true), (-1, true), (2, true), (0, true), (1, false)] {
        assert_equal(|geometry| {
            let all = recursion(geometry, base, is_back).unwrap();
            let [_, _, w, v] = &all;
            let mut roots = all
                .iter()
                .flat_map(|x| x.elements().to_vec())
                .collect::<Vec<_>>();
            let swing = geometry.cross_product(v, w).unwrap();
            roots.extend([
                geometry.dot_product(w, v).unwrap(),
                geometry.norm_squared(&swing),
            ]);
            roots
        });
    }
    let mut geometry = Geometry::new().with_unresolved_vectors(COORDINATES);
    let [.., w, v] = recursion(&mut geometry, 1, true).unwrap();
    let [w, v] = [w, v].map(|x| geometry.unresolved_of(&x).unwrap());
    assert_eq!(w.axes, v.axes);
    assert_eq!(
        w.terms,
        [Term::AngularVelocity(w.axes, geometry.graph.one())]
    );
    assert!(v.terms.iter().all(|term| matches!(term, Term::Rate(..))));
    assert_eq!(v.terms.len(), 2);
    // Turned forth, these are no velocities of frames.
    let [.., w, _] = recursion(&mut geometry, 1, false).unwrap();
    let w = geometry.unresolved_of(&w);
    assert!(w.is_none_or(|w| !matches!(*w.terms, [Term::AngularVelocity(..)])));
}

/// Along inertial axes, with the first link behind a constant turn, and one link that slides.
#[test]
fn velocities_that_are_computed_along_inertial_axes() {
    let velocities = |geometry: &mut Geometry| {
        let mount = geometry.graph.constant(&Rational::new(3, 10).unwrap());
        let mount = geometry.rotation(&[(Axis::X, mount)]);
        let turn = rotation(geometry, &[Axis::Z], 0);
        let first = geometry.matrix_product(&mount, &turn).unwrap();
        let turn = rotation(geometry, &[Axis::Y], 1);
        let second = geometry.matrix_product(&first, &turn).unwrap();
        let own = rate(geometry, Axis::Z, 0, 1);
        let w = geometry.matrix_product(&first, &own).unwrap();
        let own = rate(geometry, Axis::Y, 1, 1);
        let own = geometry.matrix_product(&first, &own).unwrap();
        let both = [(&w, Rational::ONE), (&own, Rational::ONE)];
        let both = geometry.matrix_sum(&both).unwrap();
        // A place that slides along the second link.
        let place = geometry.graph.symbol(Symbol::Coordinate(2));
        let place = Matrix::vector(vec![place, geometry.graph.one(), geometry.graph.zero()]);
        let place = geometry.matrix_product(&second, &place).unwrap();
        let slide = rate(geometry, Axis::X, 2, 1);
        let slide = geometry.matrix_product(&second, &slide).unwrap();
        let swing = geometry.cross_product(&both, &place).unwrap();
        let v = [(&swing, Rational::ONE), (&slide, Rational::ONE)];
        let v = geometry.matrix_sum(&v).unwrap();
        let along = geometry.matrix_product(&second.transpose(), &both).unwrap();
        [both, v, along, swing]
    };
    assert_equal(|geometry| {
        let all = velocities(geometry);
        all.iter().flat_map(|x| x.elements().to_vec()).collect()
    });
    let mut geometry = Geometry::new().with_unresolved_vectors(COORDINATES);
    let [_, v, along, _] = velocities(&mut geometry);
    let [v, along] = [v, along].map(|x| geometry.unresolved_of(&x).unwrap());
    assert!(matches!(*v.terms, [Term::Rate(frame, _)] if frame == along.axes));
    assert!(matches!(*along.terms, [Term::AngularVelocity(frame, _)] if frame == along.axes));
}

/// Two homogeneous matrices, their product, and a point that it takes.
fn homogeneous_matrices(geometry: &mut Geometry) -> [Matrix; 4] {
    let turn = rotation(geometry, &[Axis::Z, Axis::Y], 0);
    let place = vector(geometry, 0);
    let first = geometry.graph.homogeneous(&turn, &place).unwrap();
    let turn = rotation(geometry, &[Axis::X], 2);
    let place = vector(geometry, 3);
    let second = geometry.graph.homogeneous(&turn, &place).unwrap();
    let product = geometry.matrix_product(&first, &second).unwrap();
    let mut point = vector(geometry, 6).elements().to_vec();
    point.push(geometry.graph.one());
    let point = geometry
        .matrix_product(&product, &Matrix::vector(point))
        .unwrap();
    [first, second, product, point]
}

#[test]
fn homogeneous_matrices_are_multiplied_by_blocks() {
    assert_equal(|geometry| {
        let [first, _, product, point] = homogeneous_matrices(geometry);
        let velocity = geometry.matrix_time_derivative(&point, COORDINATES);
        let turn = product.block((0, 0), (3, 3)).unwrap();
        let w = geometry.angular_velocity(&turn, COORDINATES).unwrap();
        let back = geometry.inverse(&first).unwrap();
        let back = geometry.matrix_product(&back, &product).unwrap();
        let determinant = geometry.determinant(&product).unwrap();
        let half = geometry.graph.constant(&Rational::HALF);
        let sum = [(&point, Rational::HALF), (&velocity, Rational::ONE)];
        let sum = geometry.matrix_sum(&sum).unwrap();
        let scaled = geometry.matrix_scaled(&sum, half);
        let square = geometry.norm_squared(&scaled);
        let product = geometry.dot_product(&point, &velocity).unwrap();
        let mut roots = [point, velocity, w, back, scaled]
            .map(|x| x.elements().to_vec())
            .concat();
        roots.extend([determinant, square, product]);
        roots
    });
}

/// By elements, and an inverse that is one.
#[test]
fn homogeneous_matrices_are_those_of_their_elements() {
    for mut geometry in [
        Geometry::new(),
        Geometry::new().with_unresolved_vectors(COORDINATES),
    ] {
        let [first, second, product, point] = homogeneous_matrices(&mut geometry);
        let inverse = geometry.inverse(&product).unwrap();
        let one = geometry.matrix_product(&product, &inverse).unwrap();
        let identity = geometry.graph.identity_matrix(4);
        let mut residuals = Vec::new();
        for i in 0..4 {
            for j in 0..4 {
                residuals.push(geometry.graph.subtract(one.at(i, j), identity.at(i, j)));
                let pairs = (0..4).map(|k| (first.at(i, k), second.at(k, j)));
                let element = geometry.graph.sum_of_products(pairs);
                residuals.push(geometry.graph.subtract(product.at(i, j), element));
            }
        }
        let mut coordinates = vector(&mut geometry, 6).elements().to_vec();
        coordinates.push(geometry.graph.one());
        for i in 0..4 {
            let pairs = (0..4).map(|k| (product.at(i, k), coordinates[k]));
            let element = geometry.graph.sum_of_products(pairs);
            residuals.push(geometry.graph.subtract(point.at(i, 0), element));
        }
        let residuals = geometry.resolved(&residuals);
        for x in geometry.graph.evaluate(&residuals, value) {
            assert!(x.abs() < 1e-12, "{x}");
        }
        // A block is one of the elements.
        assert!(product.block((1, 2), (3, 2)).is_some());
        assert!(product.block((1, 2), (4, 2)).is_none());
        assert!(product.block((1, 2), (0, 2)).is_none());
    }
}
