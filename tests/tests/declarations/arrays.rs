//! Vectors and matrices in declarations, against nalgebra.

use lagrangian::nalgebra::{
    Matrix2, Matrix2x3, Matrix3, Matrix4, RowVector3, SMatrix, SVector, Vector2, Vector3,
};
use lagrangian::prelude::*;
use lagrangian_tests::assert_close;

type Place = Vector3<f64>;

/// A particle that carries quantities of every shape along.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, z),
    define(
        r = [x, y, z],
        v = dot(r),
        turned = m3 * r + 2.0 * b - a / s,
        twice = [[x, y], [z, s]],
    ),
    kinetic = 0.5 * s * v.norm_squared(),
    potential = s * a.dot(r),
    output(
        sum = a + b - r,
        scaled = -s * (a + b) / 2,
        dotted = a.dot(b),
        crossed = a.cross(b),
        volume = triple(r, a, b),
        outer = a.outer(b),
        norm = r.norm(),
        norm_squared = (a - b).norm_squared(),
        unit = a.normalize(),
        product = m3 * n3,
        applied = wide * r,
        from_left = a.transpose() * m3,
        bilinear = a.transpose() * m3 * b,
        transposed = wide.transpose(),
        trace = (m3 * n3).trace(),
        determinant_2 = m2.determinant(),
        determinant_3 = m3.determinant(),
        determinant_4 = m4.determinant(),
        inverse_2 = m2.inverse(),
        inverse_3 = m3.inverse(),
        inverse_4 = inverse(m4),
        of_state = twice.inverse(),
        hat = a.cross_matrix(),
        components = a.component_mul(b),
        onto_diagonal = diagonal(a) * b,
        off_diagonal = m3.diagonal(),
        first_row = m3.row(0),
        last_column = m3.column(2),
        entries = [m3[(0, 1)], a[1], list[4], table[1][2], wide[(1, 0)], a.z, m3[2][1], lying[2]],
        rows = [a, b],
        mixed = [[1, s], [x, 1/3]],
        repeated = [s; 3] + [0.5; 3],
        total = list.sum() + a.sum(),
        factorial = list.product(),
        sizes = [list.len(), m3.len()],
        identity = identity(3) - m3,
        squares = list.map(|entry| entry.powi(2)),
        collected = (0..4).map(|i| i * list[i + 1]).collect(),
        by_rows = (0..2).map(|i| [table[i][0], table[i][2]]).collect(),
        member = table[1] + frames[1][0] * ends[1],
        entry = frames[1][1][(0, 2)],
        tabled = vector(table),
        velocity = v,
        rate = dot(turned),
        rate_of_products = dot(r.cross(a).dot(b) * r),
        rate_of_matrix = dot(twice),
        rate_of_inverse = dot(twice.inverse()),
        nothing = 2 * (0..0).map(|i| list[i] * a).sum() + a,
    ),
)]
struct Arrays {
    s: f64,
    #[lagrangian(type = Vector3<f64>)]
    a: Place,
    b: SVector<f64, 3>,
    list: [f64; 5],
    table: [[f64; 3]; 2],
    ends: [Vector3<f64>; 2],
    frames: [[Matrix3<f64>; 2]; 2],
    m2: Matrix2<f64>,
    m3: Matrix3<f64>,
    n3: SMatrix<f64, 3, 3>,
    m4: Matrix4<f64>,
    wide: Matrix2x3<f64>,
    lying: RowVector3<f32>,
}

fn model() -> Arrays {
    Arrays {
        s: 1.75,
        a: Vector3::new(0.5, -1.25, 2.0),
        b: Vector3::new(1.5, 0.25, -0.75),
        list: [1.0, -2.0, 3.0, 0.5, 0.125],
        table: [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]],
        ends: [Vector3::zeros(), Vector3::new(2.0, -1.0, 0.5)],
        frames: [
            [Matrix3::zeros(); 2],
            [
                Matrix3::new(0.0, 1.0, 0.0, -1.0, 0.5, 0.0, 0.0, 2.0, 1.0),
                Matrix3::repeat(7.0),
            ],
        ],
        m2: Matrix2::new(1.0, 2.0, 3.0, 5.5),
        m3: Matrix3::new(2.0, 1.0, 0.5, -1.0, 3.0, 0.25, 0.75, -0.5, 1.5),
        n3: Matrix3::new(1.0, 0.0, 2.0, -1.0, 1.5, 0.5, 3.0, -2.0, 1.0),
        m4: Matrix4::new(
            2.0, 1.0, 0.0, 3.0, -1.0, 1.0, 2.0, 0.5, 0.25, 4.0, 1.0, -2.0, 1.0, 0.0, -3.0, 1.0,
        ),
        wide: Matrix2x3::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0),
        lying: RowVector3::new(0.5, 1.5, 2.5),
    }
}

/// Compares results of any shape.
fn assert_same<const R: usize, const C: usize>(
    what: &str,
    found: &SMatrix<f64, R, C>,
    expected: &SMatrix<f64, R, C>,
) {
    assert_close(what, found.as_slice(), expected.as_slice(), 1e-14);
}

/// A 1×1 matrix of a number.
fn number(value: f64) -> SMatrix<f64, 1, 1> {
    SMatrix::from([[value]])
}

fn state() -> State<f64, 3> {
    State::new(0.0, [0.25, -0.5, 1.25], [1.0, 2.0, -0.5])
}

#[test]
fn functions_of_vectors_are_those_of_nalgebra() {
    let model = model();
    let Arrays {
        s,
        a,
        b,
        m3,
        n3,
        wide,
        ..
    } = model;
    let state = state();
    let r = state.q;
    let found = model.outputs(&state);
    assert_same("sum", &found.sum, &(a + b - r));
    assert_same("scaled", &found.scaled, &(-s * (a + b) / 2.0));
    assert_same("dot", &number(found.dotted), &number(a.dot(&b)));
    assert_same("cross", &found.crossed, &a.cross(&b));
    let volume = Matrix3::from_columns(&[r, a, b]).determinant();
    assert_same("triple", &number(found.volume), &number(volume));
    assert_same("outer", &found.outer, &(a * b.transpose()));
    assert_same("norm", &number(found.norm), &number(r.norm()));
    let squared = number((a - b).norm_squared());
    assert_same("norm_squared", &number(found.norm_squared), &squared);
    assert_same("normalize", &found.unit, &a.normalize());
    assert_same("product", &found.product, &(m3 * n3));
    assert_same("matrix times vector", &found.applied, &(wide * r));
    assert_same("row", &found.from_left, &(a.transpose() * m3));
    let bilinear = a.transpose() * m3 * b;
    assert_same("bilinear form", &number(found.bilinear), &bilinear);
    assert_same("cross_matrix", &found.hat, &a.cross_matrix());
    assert_same("component_mul", &found.components, &a.component_mul(&b));
}

#[test]
fn functions_of_matrices_are_those_of_nalgebra() {
    let model = model();
    let Arrays {
        s,
        a,
        b,
        m2,
        m3,
        n3,
        m4,
        wide,
        ..
    } = model;
    let state = state();
    let r = state.q;
    let found = model.outputs(&state);
    assert_same("transpose", &found.transposed, &wide.transpose());
    assert_same("trace", &number(found.trace), &number((m3 * n3).trace()));
    assert_same(
        "det 2",
        &number(found.determinant_2),
        &number(m2.determinant()),
    );
    assert_same(
        "det 3",
        &number(found.determinant_3),
        &number(m3.determinant()),
    );
    assert_same(
        "det 4",
        &number(found.determinant_4),
        &number(m4.determinant()),
    );
    assert_same("inverse 2", &found.inverse_2, &m2.try_inverse().unwrap());
    assert_same("inverse 3", &found.inverse_3, &m3.try_inverse().unwrap());
    assert_same("inverse 4", &found.inverse_4, &m4.try_inverse().unwrap());
    let twice = Matrix2::new(r.x, r.y, r.z, s);
    assert_same(
        "inverse of state",
        &found.of_state,
        &twice.try_inverse().unwrap(),
    );
    assert_same(
        "diagonal matrix",
        &found.onto_diagonal,
        &a.component_mul(&b),
    );
    assert_same("diagonal", &found.off_diagonal, &m3.diagonal());
    assert_same("row", &found.first_row, &m3.fixed_rows::<1>(0).into_owned());
    assert_same("column", &found.last_column, &m3.column(2).into_owned());
}

#[test]
fn arrays_are_written_and_taken_apart() {
    let model = model();
    let Arrays { s, a, b, m3, .. } = model;
    let state = State::new(0.0, [0.25, -0.5, 1.25], [1.0, 2.0, -0.5]);
    let found = model.outputs(&state);
    let entries = [
        m3[(0, 1)],
        a[1],
        model.list[4],
        6.0,
        4.0,
        a.z,
        m3[(2, 1)],
        2.5,
    ];
    assert_same("entries", &found.entries, &SVector::from(entries));
    let rows = SMatrix::<f64, 2, 3>::from_rows(&[a.transpose(), b.transpose()]);
    assert_same("rows", &found.rows, &rows);
    assert_same(
        "mixed",
        &found.mixed,
        &Matrix2::new(1.0, s, 0.25, 1.0 / 3.0),
    );
    assert_same("repeated", &found.repeated, &Vector3::repeat(s + 0.5));
    let total = model.list.iter().sum::<f64>() + a.sum();
    assert_same("total", &number(found.total), &number(total));
    let factorial = model.list.iter().product();
    assert_same("product", &number(found.factorial), &number(factorial));
    assert_same("sizes", &found.sizes, &Vector2::new(5.0, 9.0));
    assert_same("identity", &found.identity, &(Matrix3::identity() - m3));
    let squares = model.list.map(|entry| entry * entry);
    assert_same("map", &found.squares, &SVector::from(squares));
    assert_same(
        "collect",
        &found.collected,
        &SVector::from([0.0, 3.0, 1.0, 0.375]),
    );
    assert_same(
        "rows collected",
        &found.by_rows,
        &Matrix2::new(1.0, 3.0, 4.0, 6.0),
    );
    let member = Vector3::new(4.0, 5.0, 6.0) + model.frames[1][0] * model.ends[1];
    assert_same("member of an array", &found.member, &member);
    assert_same("entry", &number(found.entry), &number(7.0));
    let table = SMatrix::<f64, 2, 3>::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
    assert_same("an array of vectors as rows", &found.tabled, &table);
    assert_same("a sum without terms", &found.nothing, &a);
}

#[test]
fn the_time_derivative_of_an_array_is_that_of_its_components() {
    let model = model();
    let Arrays { s, a, b, m3, .. } = model;
    let state = State::new(0.0, [0.25, -0.5, 1.25], [1.0, 2.0, -0.5]);
    let (r, v) = (state.q, state.v);
    let found = model.outputs(&state);
    assert_same("velocity", &found.velocity, &v);
    assert_same("linear", &found.rate, &(m3 * v));
    let scalar = r.cross(&a).dot(&b);
    let product = v.cross(&a).dot(&b) * r + scalar * v;
    assert_same("product", &found.rate_of_products, &product);
    let rate = Matrix2::new(v.x, v.y, v.z, 0.0);
    assert_same("matrix", &found.rate_of_matrix, &rate);
    let inverse = Matrix2::new(r.x, r.y, r.z, s).try_inverse().unwrap();
    assert_same(
        "inverse",
        &found.rate_of_inverse,
        &(-inverse * rate * inverse),
    );
    assert_close(
        "accelerations",
        model.accelerations(&state).as_slice(),
        (-a).as_slice(),
        1e-15,
    );
}

/// A mass in a field whose gradient is a matrix.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r[2]),
    kinetic = 0.5 * m[1] * (dot(r[0]).powi(2) + dot(r[1]).powi(2)),
    potential = j[(0, 1)] * r[0] + k[1][0] * r[1],
)]
struct Field {
    m: [f64; 2],
    j: Matrix2x3<f64>,
    k: [[f64; 2]; 2],
}

#[test]
fn components_are_printed_by_name_and_index() {
    let equations = Field::EQUATIONS;
    assert!(equations.starts_with("q = (r₀, r₁)\n"), "{equations}");
    assert!(equations.contains("V = j₀₁ r₀ + k₁₀ r₁\n"), "{equations}");
    assert!(
        equations.contains("\nm₁ r\u{308}₁ + k₁₀ = 0\n"),
        "{equations}"
    );
    let field = Field {
        m: [0.0, 2.0],
        j: Matrix2x3::new(0.0, 3.0, 0.0, 0.0, 0.0, 0.0),
        k: [[0.0, 0.0], [5.0, 0.0]],
    };
    let found = field.accelerations(&State::new(0.0, [0.0; 2], [0.0; 2]));
    assert_close("accelerations", found.as_slice(), &[-1.5, -2.5], 1e-15);
}

/// A spacecraft whose thrust is a vector that a controller sets.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r[3], angle),
    define(position = vector(r)),
    kinetic = 0.5 * m * dot(position).norm_squared() + 0.5 * m * dot(angle).powi(2),
    force(r[i] = thrust[i] - drag[(i, i)] * dot(r[i]) for i in 0..3, angle = spin),
    output(power = thrust.dot(dot(position)), thrust = thrust),
)]
struct Craft {
    m: f64,
    drag: Matrix3<f64>,
    #[lagrangian(input)]
    thrust: Vector3<f64>,
    #[lagrangian(input)]
    spin: f64,
}

#[test]
fn inputs_are_vectors_too() {
    let craft = Craft {
        m: 2.0,
        drag: Matrix3::from_diagonal_element(0.5),
        thrust: Vector3::new(1.0, 2.0, 3.0),
        spin: 4.0,
    };
    assert_eq!(Craft::COORDINATES, ["r[0]", "r[1]", "r[2]", "angle"]);
    assert_eq!((Craft::R, Craft::ANGLE), ([0, 1, 2], 3));
    assert_eq!(
        Craft::INPUTS,
        ["thrust[0]", "thrust[1]", "thrust[2]", "spin"]
    );
    assert_eq!(
        <Craft as lagrangian::quantities::Inputs<4, 4>>::INPUTS,
        Craft::INPUTS
    );
    assert_eq!((Craft::THRUST, Craft::SPIN), ([0, 1, 2], 3));
    let state = State::new(0.0, [0.0; 4], [1.0, 0.0, 0.0, 0.0]);
    assert_eq!(
        craft.accelerations(&state),
        SVector::from([0.25, 1.0, 1.5, 2.0])
    );
    let other = craft.with_inputs([0.5, 0.0, 0.0, 1.0]);
    assert_eq!(
        other.accelerations(&state),
        SVector::from([0.0, 0.0, 0.0, 0.5])
    );
    assert_eq!(other.outputs(&state).thrust, Vector3::new(0.5, 0.0, 0.0));
    assert_close("power", &[craft.outputs(&state).power], &[1.0], 1e-15);
}

/// Masses in a ring, each on springs to both neighbours.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(u[5]),
    kinetic = (0..5).map(|i| 0.5 * m * dot(u[i]).powi(2)).sum(),
    potential = (0..5).map(|i| 0.5 * k[i * 2 % 5] * (u[(i + 1) % 5] - u[i]).powi(2)).sum(),
)]
struct Ring {
    m: f64,
    k: [f64; 5],
}

#[test]
fn indices_go_round_a_ring() {
    let ring = Ring {
        m: 0.7,
        k: [1.0, 2.0, 3.0, 5.0, 7.0],
    };
    let q = [0.3, -0.2, 0.5, 0.9, -0.4];
    let found = ring.accelerations(&State::new(0.0, q, [0.0; 5]));
    for i in 0..5 {
        let (after, before) = ((i + 1) % 5, (i + 4) % 5);
        let ahead = ring.k[i * 2 % 5] * (q[after] - q[i]);
        let behind = ring.k[before * 2 % 5] * (q[i] - q[before]);
        assert!((found[i] - (ahead - behind) / ring.m).abs() < 1e-14);
    }
}
