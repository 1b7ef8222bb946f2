//! A pole on a cart, and its external functions for `CasADi`.

use lagrangian::prelude::*;

use crate::c_source::agreement::Agreement;
use crate::c_source::checks::{check, free, input_matrix, state_matrix};
use crate::c_source::program::{Case, Check};

/// A pole on a cart, with outputs of all shapes, one of which reads accelerations, and an event that does.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, theta),
    define(tip = [x + l * sin(theta), l * cos(theta)]),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * pole * dot(tip).norm_squared(),
    potential = pole * g * tip.y + 0.1 * cart * sin(3.0 * t) * x,
    dissipation = 0.5 * friction * dot(theta).powi(2),
    force(x = push, theta = twist),
    output(
        acceleration = dot(dot(tip)),
        turn = [[cos(theta), sin(theta), 1.0 / 3.0], [-sin(theta), cos(theta), 0.0]],
        distance = tip.norm(),
    ),
    event(stop = x, fall = [theta, dot(x) - 1.0]),
    c,
)]
pub(in super::super) struct CartPole {
    /// The mass of the cart in kg, with a `*/` in its documentation.
    cart: f64,
    pole: f32,
    l: f64,
    g: f64,
    friction: f64,
    #[lagrangian(input)]
    push: f64,
    #[lagrangian(input)]
    twist: f64,
}

/// With this mass of the pole. If it is negative, accelerations are solved for numerically.
pub(in super::super) fn cart_pole(pole: f32) -> Case {
    let model = move |u: &[f64]| CartPole {
        cart: 1.3,
        pole,
        l: 0.7,
        g: 9.81,
        friction: 0.02,
        push: u[0],
        twist: u[1],
    };
    let mut checks = free!(2, model);
    checks.push(state_matrix!(2, model, "b, "));
    let call = "double a2[16]; $_linearize(POINT, a2, y, NULL);";
    checks.push(input_matrix!(2, 2, model, call));
    let call = "$_outputs o; $_compute_outputs(POINT, &o); memcpy(y, &o, sizeof o);";
    checks.push(check("outputs", 9, call, move |point| {
        let found = model(&point.u).outputs(&point.state::<2>());
        let turn = found.turn.transpose();
        Some(
            [
                found.acceleration.as_slice(),
                turn.as_slice(),
                &[found.distance],
            ]
            .concat(),
        )
    }));
    checks.extend(casadi_checks(model));
    checks.push(check(
        "events",
        3,
        "$_event_functions(POINT, y);",
        move |point| {
            Some(
                model(&point.u)
                    .event_functions(&point.state::<2>())
                    .to_vec(),
            )
        },
    ));
    checks.push(check(
        "energies",
        2,
        "y[0] = $_kinetic_energy(POINT); y[1] = $_potential_energy(POINT);",
        move |point| {
            let (model, state) = (model(&point.u), point.state::<2>());
            Some(vec![
                model.kinetic_energy(&state),
                model.potential_energy(&state),
            ])
        },
    ));
    Case {
        prefix: "cart_pole",
        source: CartPole::C_SOURCE,
        header: CartPole::C_HEADER,
        casadi: CartPole::C_CASADI,
        parameters: vec![1.3, f64::from(pole), 0.7, 9.81, 0.02],
        coordinates: 2,
        inputs: 2,
        checks,
        agreement: Agreement::Bits,
    }
}

/// The external functions of `CasADi` for a cart with a pole.
fn casadi_checks(model: impl Fn(&[f64]) -> CartPole + Copy + 'static) -> [Check; 2] {
    let call = |function: &str, results: &str| {
        format!(
            "extern int $_{function}(const double **, double **, long long int *, double *, int); double x[4]; \
             memcpy(x, q, sizeof q); memcpy(x + 2, v, sizeof v); \
             const double *arg[4] = {{&t, x, u, (const double *)&p}}; double *res[2] = {{{results}}}; \
             $_{function}(arg, res, NULL, NULL, 0);"
        )
    };
    [
        check("dynamics", 4, &call("dynamics", "y, NULL"), move |point| {
            let accelerations = model(&point.u).accelerations(&point.state::<2>());
            Some([&point.v, accelerations.as_slice()].concat())
        }),
        check(
            "linear model",
            24,
            &call("linear_model", "y, y + 16"),
            move |point| {
                let (model, state) = (model(&point.u), point.state::<2>());
                let found = lagrangian::analysis::StateSpace::<f64, 4, 2, 4>::of(&model, &state);
                Some([found.a.as_slice(), found.b.as_slice()].concat())
            },
        ),
    ]
}
