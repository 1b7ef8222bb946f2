//! The equations of constraints, and what is wrong with them, against closed forms and known examples.

use lagrangian_symbolic::{
    Constraint, ConstraintDefect, ConstraintEquations, Equations, Kinetics, Model,
};
use lagrangian_symbolic_testing::{Draft, Quantity, assert_close, value};

fn holonomic(g: Quantity<'_>) -> Constraint {
    Constraint::Holonomic(g.expression())
}

fn nonholonomic(w: Quantity<'_>) -> Constraint {
    Constraint::Nonholonomic(w.expression())
}

/// A model with unit masses and these constraints, the expressions of which are made of a draft.
fn model(coordinates: u32, constraints: impl FnOnce(&Draft) -> Vec<Constraint>) -> Model {
    with_masses(coordinates, coordinates, constraints)
}

/// A model of which the first coordinates have unit masses and the others none.
fn with_masses(
    masses: u32,
    coordinates: u32,
    constraints: impl FnOnce(&Draft) -> Vec<Constraint>,
) -> Model {
    let draft = Draft::new(coordinates);
    let constraints = constraints(&draft);
    let squares = (0..masses).map(|i| draft.v(i).squared() / 2);
    let kinetic = draft.sum(squares);
    let mut model = draft.natural(kinetic, draft.zero());
    model.constraints = constraints;
    model
}

fn defect(
    coordinates: u32,
    constraints: impl FnOnce(&Draft) -> Vec<Constraint>,
) -> ConstraintDefect {
    let mut model = model(coordinates, constraints);
    ConstraintEquations::derive(&mut model).unwrap_err()
}

fn integrable(coordinates: u32, constraints: impl FnOnce(&Draft) -> Vec<Constraint>) -> Vec<usize> {
    let mut model = model(coordinates, constraints);
    let equations = ConstraintEquations::derive(&mut model).unwrap();
    equations.integrable.into_iter().map(|(i, _)| i).collect()
}

#[test]
fn a_rod_of_changing_length_has_all_terms() {
    // ½ (x² + y² − (l + a t²)²), the rod is drawn in; the nonholonomic one is declared first.
    let mut model = model(3, |d| {
        let ([x, y, z], [.., w]) = (d.qs(), d.vs::<3>());
        let length = d.p(0) + d.p(1) * d.time().squared();
        vec![
            nonholonomic(w * x - d.v(1) * z + d.time()),
            holonomic((x.squared() + y.squared() - length.squared()) / 2),
        ]
    });
    let equations = ConstraintEquations::derive(&mut model).unwrap();
    assert_eq!(equations.declared, [1, 0]);
    let roots = [
        equations.velocities.clone(),
        equations.jacobian.concat(),
        equations.rates.clone(),
    ];
    let found = model.graph.evaluate(&roots.concat(), value);
    let ([x, y, z], [u, v, w]) = ([0.7, 1.1, 1.5], [1.1, 0.5, -0.1]);
    let (l, a, t) = (1.3, 1.8, 0.3_f64);
    let (length, rate) = (l + a * t * t, 2.0 * a * t);
    let expected = [
        x * u + y * v - length * rate,
        w * x - v * z + t,
        x,
        y,
        0.0,
        0.0,
        -z,
        x,
        u * u + v * v - rate * rate - length * 2.0 * a,
        w * u - v * w + 1.0,
    ];
    for (found, expected) in found.into_iter().zip(expected) {
        assert_close(found, expected);
    }
}

#[test]
fn what_is_no_constraint_is_named() {
    let velocity = defect(2, |d| vec![holonomic(d.q(0) - d.v(1))]);
    assert_eq!(velocity, ConstraintDefect::Velocity(0));
    let input = defect(2, |d| vec![nonholonomic(d.v(0) - d.input())]);
    assert_eq!(input, ConstraintDefect::Input(0));
    let square = defect(2, |d| {
        vec![holonomic(d.q(0)), nonholonomic(d.v(1).squared() - d.v(0))]
    });
    assert_eq!(square, ConstraintDefect::Nonlinear(1));
    let time = defect(2, |d| vec![holonomic(d.time() - d.p(0))]);
    assert_eq!(
        time,
        ConstraintDefect::NoVelocity {
            constraint: 0,
            holds: false
        }
    );
    let cancelling = defect(2, |d| {
        let x = d.q(0);
        vec![holonomic((x + 1).squared() - x.squared() - x - x)]
    });
    assert_eq!(
        cancelling,
        ConstraintDefect::NoVelocity {
            constraint: 0,
            holds: false
        }
    );
    // Squares that cancel are linear.
    let difference = model(2, |d| {
        let [v, w] = d.vs();
        vec![nonholonomic((v + 1).squared() - v.squared() - w)]
    });
    ConstraintEquations::derive(&mut difference.clone()).unwrap();
}

#[test]
fn a_relation_that_follows_from_others_names_them() {
    let closed = |d: &Draft, offset: Quantity<'_>| {
        let [x, y, z, _] = d.qs();
        vec![
            holonomic(d.q(3)),
            holonomic(x - y),
            holonomic(d.p(0) * (y - z)),
            holonomic(x.sin() - z.sin() - x.sin() + x + offset - z + z.sin()),
        ]
    };
    let dependent = |contradicts| ConstraintDefect::Dependent {
        constraint: 3,
        others: vec![1, 2],
        contradicts,
    };
    assert_eq!(defect(4, |d| closed(d, d.zero())), dependent(false));
    assert_eq!(defect(4, |d| closed(d, d.time())), dependent(true));
    // What depends on others for some positions alone is no defect: a platform on three parallel bars has one freedom, and
    // three independent rows elsewhere.
    let bars = model(3, |d| {
        let [x, y, angle] = d.qs();
        let bar = |a: i64, b: i64| {
            let (s, c) = (angle.sin(), angle.cos());
            let (h, k) = (
                x + c * d.number(a) - s * d.number(b) - d.number(a),
                y + s * d.number(a) + c * d.number(b) - d.number(b),
            );
            holonomic(h.squared() + k.squared() - d.p(0).squared())
        };
        vec![bar(0, 0), bar(1, 0), bar(2, 1)]
    });
    ConstraintEquations::derive(&mut bars.clone()).unwrap();
}

fn surplus(coordinates: u32, constraints: impl FnOnce(&Draft) -> Vec<Constraint>) -> Vec<usize> {
    let mut model = model(coordinates, constraints);
    ConstraintEquations::derive(&mut model).unwrap().surplus
}

#[test]
fn what_geometry_relates_is_no_defect() {
    // A point on a circle is held, and so is a further one: cos q − p₀ and sin q − p₁, and the same with other parameters.
    let point = |d: &Draft, angle: Quantity<'_>, k: u32| {
        vec![
            holonomic(angle.cos() - d.p(k)),
            holonomic(angle.sin() - d.p(k + 1)),
        ]
    };
    assert_eq!(surplus(1, |d| point(d, d.q(0), 0)), [1]);
    assert_eq!(surplus(2, |d| point(d, d.q(0) + d.q(1), 0)), [1]);
    // Three functions of x and y.
    let products = |d: &Draft| {
        let [x, y, ..] = d.qs::<3>();
        vec![holonomic(x), holonomic(y), holonomic(x * y - d.p(0))]
    };
    assert_eq!(surplus(3, products), [2]);
    // Three points x + a cos q of a body with parameters a: each is a combination of two of them.
    let points = |d: &Draft, places: [u32; 3]| {
        let [x, angle] = d.qs();
        let pairs = (0..3).zip(places);
        let points = pairs.map(|(k, place)| x + d.p(k) * angle.cos() - d.p(place));
        points.map(holonomic).collect::<Vec<_>>()
    };
    assert_eq!(surplus(2, |d| points(d, [3, 4, 5])), [2]);
}

#[test]
fn what_parameters_do_not_change_is_a_defect() {
    let dependent = |others: &[usize], contradicts| ConstraintDefect::Dependent {
        constraint: others.len(),
        others: others.to_vec(),
        contradicts,
    };
    // Three points on a line, of a body and in space.
    let on_a_line = |d: &Draft, motion: Quantity<'_>| {
        let [x, angle] = d.qs();
        let points = (0..3).map(|k| x + d.p(k) * angle.cos() - d.p(k));
        let mut points: Vec<_> = points.collect();
        points[2] = points[2] + motion;
        points.into_iter().map(holonomic).collect::<Vec<_>>()
    };
    assert_eq!(
        defect(2, |d| on_a_line(d, d.zero())),
        dependent(&[0, 1], false)
    );
    assert_eq!(
        defect(2, |d| on_a_line(d, d.time())),
        dependent(&[0, 1], true)
    );
    // A distance and its square.
    let rod = |d: &Draft| {
        let square = d.q(0).squared() + d.q(1).squared();
        vec![
            holonomic(square.sqrt() - d.p(0)),
            holonomic(square - d.p(1)),
        ]
    };
    assert_eq!(defect(2, rod), dependent(&[0], false));
    // A number of which no parameter is a function.
    let apart = |d: &Draft| {
        let [x, y] = d.qs();
        vec![holonomic(x - y), holonomic(x + x - y - y - d.p(0))]
    };
    assert_eq!(defect(2, apart), dependent(&[0], false));
    // Relations of velocities alone, at whatever configuration.
    let velocities = |d: &Draft| {
        let ([v, w], [x, y]) = (d.vs(), d.qs());
        vec![
            nonholonomic(v + x * w),
            nonholonomic(w * y + v),
            nonholonomic(v * x.sin() - w),
        ]
    };
    assert_eq!(defect(2, velocities), dependent(&[0, 1], false));
}

#[test]
fn what_follows_from_a_surplus_constraint_is_a_defect() {
    let expected = ConstraintDefect::Dependent {
        constraint: 3,
        others: vec![2],
        contradicts: false,
    };
    // A square of a function that is itself surplus.
    let product_and_square = |d: &Draft| {
        let [x, y] = d.qs();
        let product = x * y;
        let rest = [product - d.p(0), product.squared() - d.p(1)];
        [x, y].into_iter().chain(rest).map(holonomic).collect()
    };
    assert_eq!(defect(2, product_and_square), expected);
    // Twice a constraint that is itself surplus.
    let twice = |d: &Draft| {
        let [x, angle] = d.qs();
        let points = (0..3).map(|k| x + d.p(k) * angle.cos() - d.p(3 + k));
        let mut points: Vec<_> = points.collect();
        points.push(points[2] + points[2]);
        points.into_iter().map(holonomic).collect()
    };
    assert_eq!(defect(2, twice), expected);
}

#[test]
fn relations_of_velocities_that_can_be_integrated_are_known() {
    // A disc that rolls on a straight line; x, φ.
    let line = integrable(2, |d| vec![nonholonomic(d.v(0) - d.p(0) * d.v(1))]);
    assert_eq!(line, [0]);
    // A knife edge, and a vertical disc: x, y, θ, φ.
    let edge = integrable(3, |d| {
        let [v, w, _] = d.vs();
        vec![nonholonomic(v * d.q(2).sin() - w * d.q(2).cos())]
    });
    assert_eq!(edge, [0; 0]);
    let rolling = |d: &Draft| {
        let ([v, w, _, spin], angle) = (d.vs(), d.q(2));
        vec![
            nonholonomic(v - d.p(0) * spin * angle.cos()),
            nonholonomic(w - d.p(0) * spin * angle.sin()),
        ]
    };
    assert_eq!(integrable(4, rolling), [0; 0]);
    // One that does not turn rolls on a line, whether the constraint of its angle is given for positions or velocities.
    let ahead = integrable(4, |d| {
        let mut all = rolling(d);
        all.push(nonholonomic(d.v(2)));
        all
    });
    assert_eq!(ahead, [0, 1, 2]);
    let held = integrable(4, |d| {
        let mut all = rolling(d);
        all.push(holonomic(d.q(2) - d.p(1)));
        all
    });
    assert_eq!(held, [0, 1]);
    // An integrating factor does not hide it; a part of a set may be integrable.
    let factor = integrable(5, |d| {
        let ([v, w, .., z], [x, y, angle, ..]) = (d.vs::<5>(), d.qs::<5>());
        vec![
            nonholonomic(y.exp() * (x * w + v * y + z)),
            nonholonomic(d.v(3) * angle.sin() - z * angle.cos()),
        ]
    });
    assert_eq!(factor, [0]);
    // In time: ẋ = t is integrable, ẋ = y is not.
    let in_time = integrable(2, |d| vec![nonholonomic(d.v(0) - d.time())]);
    assert_eq!(in_time, [0]);
    let along = integrable(2, |d| vec![nonholonomic(d.v(0) - d.q(1))]);
    assert_eq!(along, [0; 0]);
}

/// Three constraints of two coordinates with constant gradients, of which the third is the sum of the others, and of two angles without
/// mass. The third has no pivot before an angle is eliminated: the entry vanishes identically, which no normal form shows.
#[test]
fn constraints_that_depend_on_each_other_in_some_coordinates_are_solved_for() {
    let mut model = with_masses(2, 4, |d| {
        let [x, y, a, b] = d.qs();
        vec![
            holonomic(d.p(0) * x + y - a.sin()),
            holonomic(d.p(1) * x - y - b.sin()),
            holonomic((d.p(0) + d.p(1)) * x + a.cos() + d.p(2) * b.cos()),
        ]
    });
    let equations = Equations::derive(&mut model).unwrap();
    let kinetics = Kinetics::cheapest(&mut model, &equations);
    let solution = kinetics.solution.expect("few unknowns");
    let graph = &model.graph;
    for pivot in graph.evaluate(&solution.pivots, value) {
        assert!(pivot.abs() > 1e-3, "{pivot}");
    }
    let found = graph.evaluate(&solution.accelerations, value);
    let forcing = graph.evaluate(&kinetics.system.forcing, value);
    for (row, right) in kinetics.system.mass.iter().zip(forcing) {
        let row = graph.evaluate(row, value);
        let left: f64 = row.iter().zip(&found).map(|(entry, x)| entry * x).sum();
        assert_close(left, right);
    }
}
