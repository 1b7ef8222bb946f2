//! Regressors and base parameters: how many there are, what is regrouped, and that Y π + r is M q̈ − f.

use std::collections::BTreeSet;

use lagrangian_symbolic::{
    Equations, Model, Names, NoRegressor, Node, Regressor, Symbol, UnknownParameters,
};
use lagrangian_symbolic_testing::{Draft, Quantity};

/// The base parameters of a model as they are printed, where its parameters have these names.
fn base_parameters(
    model: &mut Model,
    unknown: UnknownParameters<'_>,
    names: &[&str],
) -> Vec<String> {
    let regressor = Regressor::derive(model, unknown).expect("a regressor");
    check(model, &regressor);
    let names = Names {
        parameters: names.iter().map(ToString::to_string).collect(),
        ..Names::default()
    };
    let values = regressor.base_parameters.iter();
    values
        .map(|value| model.graph.display(*value, &names).to_string())
        .collect()
}

/// Compares Y π + r with M q̈ − f at some points.
fn check(model: &mut Model, regressor: &Regressor) {
    let equations = Equations::derive(model).expect("equations");
    let n = model.coordinates as usize;
    let mut roots = regressor.columns.concat();
    roots.extend(&regressor.known);
    roots.extend(&regressor.base_parameters);
    roots.extend(&equations.inverse_dynamics);
    for point in 1..4_u32 {
        let value = |symbol: Symbol| {
            let (kind, i) = match symbol {
                Symbol::Time => (1, 0),
                Symbol::Coordinate(i) => (2, i),
                Symbol::Velocity(i) => (3, i),
                Symbol::Acceleration(i) => (4, i),
                Symbol::Parameter(i) => (5, i),
                _ => (6, 0),
            };
            0.3 + (f64::from(7 * kind + 3 * i + 11 * point) * 0.618_033_988_7).fract()
        };
        let values = model.graph.evaluate(&roots, value);
        let count = regressor.columns.len();
        let (columns, rest) = values.split_at(count * n);
        let (known, rest) = rest.split_at(n);
        let (base, expected) = rest.split_at(count);
        for i in 0..n {
            let terms = base
                .iter()
                .enumerate()
                .map(|(b, pi)| columns[b * n + i] * pi);
            let found: f64 = known[i] + terms.sum::<f64>();
            assert!(
                (found - expected[i]).abs() < 1e-12,
                "{found} {}",
                expected[i]
            );
        }
    }
}

/// The planar arm of two links (Khalil and Dombre 2002, chapter 9), from the inertial parameters of the links about their
/// joints, ZZ, MX, MY and M, the length of the first link, and g.
fn two_links(gravity: bool) -> Model {
    let draft = Draft::new(2);
    let [zz1, mx1, my1, zz2, mx2, my2, m2, l, g] = draft.ps();
    let [q1, q2] = draft.qs();
    let angle = q1 + q2;
    let joint = [l * q1.cos(), l * q1.sin()];
    let moment = [
        mx2 * angle.cos() - my2 * angle.sin(),
        mx2 * angle.sin() + my2 * angle.cos(),
    ];
    let [x, y] = joint.map(Quantity::dot);
    let coupling = x * moment[0].dot() + y * moment[1].dot();
    let squares =
        zz1 * q1.dot().squared() + m2 * (x.squared() + y.squared()) + zz2 * angle.dot().squared();
    let height = mx1 * q1.sin() + my1 * q1.cos() + m2 * joint[1] + moment[1];
    let potential = if gravity { g * height } else { draft.zero() };
    draft.natural(squares / 2 + coupling, potential)
}

const TWO_LINKS: [&str; 9] = ["zz1", "mx1", "my1", "zz2", "mx2", "my2", "m2", "l", "g"];

fn parameters<const N: usize>(indices: [u32; N]) -> [Symbol; N] {
    indices.map(Symbol::Parameter)
}

#[test]
fn the_base_parameters_of_a_two_link_arm_are_the_published_ones() {
    let inertial = parameters([0, 1, 2, 3, 4, 5, 6]);
    let unknown = UnknownParameters::Named(&inertial);
    // The mass of the second link is regrouped with the first one.
    let found = base_parameters(&mut two_links(true), unknown, &TWO_LINKS);
    assert_eq!(
        found,
        ["zz₁ + m₂ l²", "mx₁ + m₂ l", "my₁", "zz₂", "mx₂", "my₂"]
    );
    let found = base_parameters(&mut two_links(false), unknown, &TWO_LINKS);
    assert_eq!(found, ["zz₁ + m₂ l²", "zz₂", "mx₂", "my₂"]);
    let mut model = two_links(false);
    let regressor = Regressor::derive(&mut model, unknown).unwrap();
    assert_eq!(regressor.without_effect, parameters([1, 2]));
}

#[test]
fn every_parameter_is_unknown_where_none_is_named() {
    let mut model = two_links(true);
    let found = base_parameters(&mut model, UnknownParameters::Every, &TWO_LINKS);
    let expected = [
        "zz₁ + m₂ l²",
        "g (mx₁ + m₂ l)",
        "my₁·g",
        "zz₂",
        "mx₂·l",
        "mx₂·g",
        "my₂·l",
        "my₂·g",
    ];
    assert_eq!(found, expected);
}

/// A pendulum on a support that moves as a sin(ω t), with an angle α of its centre of mass that is known.
fn driven() -> Model {
    let draft = Draft::new(1);
    let [i, s, k, a, w, alpha, l] = draft.ps();
    let (q, t) = (draft.q(0), draft.time());
    let support = a * (w * t).sin();
    let moment = [s * (q + alpha).cos(), s * (q + alpha).sin()];
    let kinetic = i * q.dot().squared() / 2 + support.dot() * moment[0].dot();
    // The stiffness of a spring between two levers, whose lengths are known.
    let spring = k * (l + a).recip() * (q - (w * t).sin()).squared() / 2;
    draft.natural(kinetic, 9 * moment[0] + spring)
}

const DRIVEN: [&str; 7] = ["i", "s", "k", "a", "w", "α", "l"];

#[test]
fn functions_of_known_parameters_remain_in_the_columns() {
    let unknown = parameters([0, 1, 2]);
    let found = base_parameters(&mut driven(), UnknownParameters::Named(&unknown), &DRIVEN);
    assert_eq!(found, ["I", "s", "k"]);
    // What is within functions is known where nothing is named, and so are the known lengths in a divisor.
    let found = base_parameters(&mut driven(), UnknownParameters::Every, &DRIVEN);
    assert_eq!(found, ["I", "s", "k"]);
}

#[test]
fn a_parameter_within_a_function_is_an_error() {
    for index in [3, 4, 5, 6] {
        let unknown = parameters([0, index]);
        let mut model = driven();
        let found = Regressor::derive(&mut model, UnknownParameters::Named(&unknown));
        let NoRegressor::NotPolynomial(within, term) = found.unwrap_err() else {
            panic!("parameter {index} is within a function");
        };
        assert_eq!(within, BTreeSet::from(parameters([index])));
        // The term contains it, and is no sum that could be taken apart.
        assert!(
            model
                .graph
                .contains(&[term], |symbol| within.contains(&symbol))
        );
        assert!(!matches!(model.graph.node(term), Node::Sum(_)));
    }
    let unknown = parameters([20]);
    let found = Regressor::derive(&mut driven(), UnknownParameters::Named(&unknown));
    assert_eq!(found.unwrap_err(), NoRegressor::NothingUnknown);
}

/// Two masses on one coordinate, geared by a ratio that is a function of known parameters.
#[test]
fn what_is_regrouped_may_depend_on_functions_of_known_parameters() {
    let draft = Draft::new(1);
    let [m1, m2, m3, a, b] = draft.ps();
    let q = draft.q(0);
    let speeds = [
        q.dot(),
        q.dot() * a.sin() / (a + b),
        q.dot() * (a + b).squared(),
    ];
    let squares = speeds.map(Quantity::squared);
    let kinetic = (m1 * squares[0] + m2 * squares[1] + m3 * squares[2]) / 2;
    let mut model = draft.natural(kinetic, draft.zero());
    let unknown = parameters([0, 1, 2]);
    let names = ["m1", "m2", "m3", "a", "b"];
    let found = base_parameters(&mut model, UnknownParameters::Named(&unknown), &names);
    assert_eq!(found.len(), 1);
}
