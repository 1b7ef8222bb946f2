//! What is emitted gets along with whatever names the user's crate has.
#![deny(warnings, clippy::pedantic, missing_docs, unsafe_code)]

mod collisions;
mod external_functions;
mod macros;
mod no_prelude;

#[test]
fn a_model_may_stand_in_a_function() {
    use lagrangian::prelude::*;

    #[derive(Lagrangian)]
    #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), potential = m * x, output(x = x))]
    struct Local {
        m: f64,
    }

    let state = State::new(0.0, [0.5], [0.0]);
    assert!((Local { m: 2.0 }.accelerations(&state)[Local::X] + 1.0).abs() < 1e-15);
}

#[test]
fn names_may_be_raw_or_greek_or_upper_case() {
    use lagrangian::prelude::*;

    #[derive(Lagrangian)]
    #[lagrangian(
        coordinates(θ, r#type),
        define(ω = dot(θ), r#loop = dot(r#type)),
        kinetic = 0.5 * J * ω.powi(2) + 0.5 * r#move * r#loop.powi(2),
        potential = r#move * r#type,
        force(θ = -r#in * ω, r#type = r#let),
        output(r#fn = r#type, ψ = dot(ω)),
    )]
    #[allow(non_snake_case)]
    struct Names {
        J: f64,
        r#move: f64,
        r#in: f64,
        r#let: f64,
    }

    let model = Names {
        J: 2.0,
        r#move: 4.0,
        r#in: 1.0,
        r#let: 1.0,
    };
    let state = State::new(0.0, [0.5, 0.25], [1.0, 0.0]);
    assert!((model.accelerations(&state)[Names::θ] + 0.5).abs() < 1e-15);
    assert!((model.accelerations(&state)[Names::TYPE] + 0.75).abs() < 1e-15);
    assert!((model.outputs(&state).ψ + 0.5).abs() < 1e-15);
    assert!((model.outputs(&state).r#fn - 0.25).abs() < 1e-15);
    assert_eq!(Names::COORDINATES, ["θ", "type"]);
}

#[test]
fn a_skipped_field_may_have_a_reserved_name() {
    use lagrangian::prelude::*;

    #[derive(Lagrangian)]
    #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), potential = m * t * x)]
    struct Skipping {
        m: f64,
        #[lagrangian(skip)]
        t: &'static str,
    }

    let model = Skipping {
        m: 2.0,
        t: "a name",
    };
    let state = State::new(3.0, [0.5], [0.0]);
    assert!(
        (model.accelerations(&state)[0] + 3.0).abs() < 1e-15,
        "{}",
        model.t
    );
}
