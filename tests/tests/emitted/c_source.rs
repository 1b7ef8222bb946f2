//! Models in C against the same models in Rust: their source is compiled by the system's `cc`, without warnings, and evaluated at
//! random points.

mod agreement;
mod checks;
mod jacobians;
mod models;
mod point;
mod program;
mod ready_models;

use lagrangian_tests::Random;
use point::Point;
use program::Case;

/// How many points are compared, and how many of all models.
const POINTS: usize = 40;
const MANY_POINTS: usize = 1000;

#[test]
fn a_driven_cart_has_the_bits_of_rust() {
    models::cart_pole(0.25).agrees_at_random_points(POINTS);
}

#[test]
fn what_cannot_be_solved_symbolically_has_the_bits_of_rust() {
    models::cart_pole(-0.75).agrees_at_random_points(POINTS);
    models::chain(-4.0).agrees_at_random_points(POINTS);
}

#[test]
fn a_chain_and_a_reduced_model_have_the_bits_of_rust() {
    models::chain(0.5).agrees_at_random_points(POINTS);
    models::radial().agrees_at_random_points(POINTS);
}

#[test]
fn derivatives_column_by_column_agree() {
    models::long_chain().agrees_at_random_points(4);
}

#[test]
fn bodies_families_and_vectors_have_the_bits_of_rust() {
    models::arm().agrees_at_random_points(POINTS);
}

#[test]
fn motions_under_constraints_have_the_bits_of_rust() {
    models::four_bar().agrees(&models::points_of_four_bar(POINTS));
    models::rolling_disc().agrees(&models::points_of_disc(POINTS));
}

#[test]
fn redundant_constraints_have_the_bits_of_rust() {
    models::guided().agrees_at_random_points(POINTS);
}

#[test]
fn an_indefinite_mass_matrix_has_the_bits_of_rust() {
    models::indefinite().agrees_at_random_points(POINTS);
}

#[test]
fn keywords_and_greek_letters_are_written_otherwise() {
    models::names().agrees_at_random_points(POINTS);
}

#[test]
fn a_model_without_parameters_has_no_struct_of_them() {
    models::oscillator().agrees_at_random_points(POINTS);
}

#[test]
fn elementary_functions_agree_to_two_units() {
    models::elementary_functions().agrees_at_random_points(POINTS);
}

#[test]
fn special_numbers_are_those_of_rust() {
    for case in [models::cart_pole(0.25), models::elementary_functions()] {
        let numbers = [
            0.0,
            -0.0,
            1e-310,
            -1e-200,
            1e-150,
            1e200,
            1.5e5,
            -1e22,
            f64::INFINITY,
            f64::NAN,
        ];
        let point = |x: &f64| Point {
            t: 0.0,
            q: vec![*x, *x],
            v: vec![*x, -*x],
            u: vec![*x; case.inputs],
            a: vec![*x, 1.0],
            h: 1.0 / 128.0,
        };
        let points: Vec<Point> = numbers.iter().map(point).collect();
        // Steps are refused in Rust where numbers are not finite.
        let checks = case.checks.into_iter().filter(|check| check.name != "step");
        let case = Case {
            checks: checks.collect(),
            ..case
        };
        case.agrees(&points);
    }
}

#[test]
fn a_ready_model_with_constraints_has_the_bits_of_rust() {
    ready_models::bicycle().agrees(&ready_models::points_of_bicycle(POINTS));
}

#[test]
fn jacobians_in_casadi_are_those_of_differences() {
    let mut random = Random::default();
    let free = [models::cart_pole(0.25), models::arm(), models::oscillator()];
    for case in free {
        let point = Point::random(&mut random, case.coordinates, case.inputs);
        case.has_jacobians_in_casadi(&point);
    }
    models::four_bar().has_jacobians_in_casadi(&models::points_of_four_bar(1)[0]);
    models::rolling_disc().has_jacobians_in_casadi(&models::points_of_disc(1)[0]);
}

#[test]
#[ignore = "a thousand states of sixteen models; run with `--include-ignored`"]
fn a_thousand_states_of_all_models_agree() {
    let cases = [
        models::cart_pole(0.25),
        models::arm(),
        models::chain(0.5),
        models::chain(-4.0),
        models::radial(),
        models::guided(),
        models::indefinite(),
        models::names(),
        models::oscillator(),
        models::elementary_functions(),
        ready_models::general_top(),
        ready_models::furuta_pendulum(),
    ];
    for case in cases {
        case.agrees_at_random_points(MANY_POINTS);
    }
    models::four_bar().agrees(&models::points_of_four_bar(MANY_POINTS));
    models::rolling_disc().agrees(&models::points_of_disc(MANY_POINTS));
    ready_models::bicycle().agrees(&ready_models::points_of_bicycle(MANY_POINTS));
    ready_models::stewart_platform().agrees(&ready_models::points_of_platform(MANY_POINTS));
}
