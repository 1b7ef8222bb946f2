//! Motions whose solutions are known functions: a third computation, after the derived code and the
//! integrations with 30 digits.

use std::f64::consts::TAU;

use lagrangian::prelude::*;
use lagrangian_tests::{
    Figures, Observed as _, Parametrized, list, number, numbers, references, relative_error, text,
    trajectory,
};
use serde_json::Value;

/// Of motions, relative to the greatest entry or to 1.
const TOLERANCE: f64 = 1e-9;
/// Of what is evaluated at one state.
const POINTWISE_TOLERANCE: f64 = 1e-12;

#[test]
fn closed_forms_are_met() {
    let mut check = Check::default();
    for (index, form) in list(&references()["closed_forms"]).iter().enumerate() {
        let kind = text(&form["kind"]);
        check.at = format!("closed form {index}, {kind}");
        match kind {
            "pendulum" => pendulum(form, &mut check),
            "n_four_bar" => four_bar(form, &mut check),
            "atwood_heavy_string" => atwood(form, &mut check),
            "kepler_polar" => kepler(form, &mut check),
            "spherical_pendulum" => spherical_pendulum(form, &mut check),
            "bead_on_hoop" => bead_on_hoop(form, &mut check),
            "lagrange_top" => lagrange_top(form, &mut check),
            "steady_precession" => steady_precession(form, &mut check),
            "free_symmetric_top" => free_symmetric_top(form, &mut check),
            "free_body_omega" => free_body(form, &mut check),
            // Nonholonomic.
            "chaplygin_sleigh" => {}
            _ => panic!("{kind} is not checked"),
        }
    }
    check.figures.finish();
}

/// The comparisons, and where the present one is made.
#[derive(Default)]
struct Check {
    figures: Figures,
    at: String,
}

impl Check {
    fn motion(&mut self, what: &'static str, found: &[f64], expected: &[f64]) {
        self.figures.record(
            what,
            &self.at,
            relative_error(found, expected, 1.0),
            TOLERANCE,
        );
    }

    fn point(&mut self, what: &'static str, found: &[f64], expected: &[f64]) {
        self.figures.record(
            what,
            &self.at,
            relative_error(found, expected, 1.0),
            POINTWISE_TOLERANCE,
        );
    }
}

/// The model whose parameters have these values.
fn model<M: Parametrized>(values: &[(&str, f64)]) -> M {
    let value = |name: &str| {
        values
            .iter()
            .find(|(known, _)| *known == name)
            .map(|(_, value)| *value)
    };
    M::with(&|name| value(name).unwrap_or_else(|| panic!("`{name}` has no value")))
}

/// The model whose parameters have the names that they have in the data.
fn model_of<M: Parametrized>(form: &Value) -> M {
    M::with(&|name| {
        if name == "m" && form[name].is_null() {
            1.0
        } else {
            number(&form[name])
        }
    })
}

/// The state at a time after the initial one.
fn state_at<const N: usize>(
    model: &impl Lagrangian<N>,
    initial: State<f64, N>,
    t: f64,
) -> State<f64, N> {
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    match Problem::new(model, initial).solve(t, method) {
        Ok(solution) => solution.last,
        Err(error) => panic!("{error}"),
    }
}

/// The samples of a closed form, with the states that the model has at their times.
fn samples<'a, const N: usize>(
    form: &'a Value,
    model: &'a impl Lagrangian<N>,
    initial: State<f64, N>,
) -> impl Iterator<Item = (&'a Value, State<f64, N>)> {
    list(&form["samples"])
        .iter()
        .map(move |sample| (sample, state_at(model, initial, number(&sample["t"]))))
}

fn pendulum(form: &Value, check: &mut Check) {
    let model: trajectory::SimplePendulum = model_of(form);
    let initial = State::new(
        0.0,
        [number(&form["theta0"])],
        [number(&form["theta_dot0"])],
    );
    for (sample, state) in samples(form, &model, initial) {
        check.motion("angle", &[state.q[0]], &numbers(&sample["theta"]));
    }
    let later = state_at(&model, initial, number(&form["period"]));
    check.motion(
        "after a period",
        &[later.q[0], later.v[0]],
        &[initial.q[0], initial.v[0]],
    );
}

fn four_bar(form: &Value, check: &mut Check) {
    let value = |name: &str| number(&form[name]);
    let bars = form["N"].as_f64().expect("a number of bars");
    let model: trajectory::IftommA02NfourbarN2 = model(&[
        ("m", value("m")),
        ("l", value("l")),
        ("g", value("g")),
        ("n", bars),
    ]);
    let initial = State::new(0.0, [0.0], [value("B0x_dot0") / model.l]);
    for (sample, state) in samples(form, &model, initial) {
        check.motion("angle", &[state.q[0]], &numbers(&sample["theta"]));
    }
    let later = state_at(&model, initial, value("revolution_period"));
    check.motion(
        "after a period",
        &[later.q[0], later.v[0]],
        &[TAU, initial.v[0]],
    );
}

fn atwood(form: &Value, check: &mut Check) {
    let model: trajectory::AtwoodHeavyString = model_of(form);
    let initial = State::new(0.0, [number(&form["x0"])], [number(&form["v0"])]);
    for (sample, state) in samples(form, &model, initial) {
        check.motion("length", &[state.q[0]], &numbers(&sample["x"]));
    }
}

fn kepler(form: &Value, check: &mut Check) {
    let value = |name: &str| number(&form[name]);
    let model: trajectory::KeplerPolar = model_of(form);
    let initial = State::new(
        0.0,
        [value("r0"), value("phi0")],
        [value("r_dot0"), value("phi_dot0")],
    );
    for (sample, state) in samples(form, &model, initial) {
        let found = [state.q[0], state.q[1].rem_euclid(TAU)];
        check.motion(
            "polar coordinates",
            &found,
            &[number(&sample["r"]), number(&sample["phi_mod_2pi"])],
        );
    }
    let later = state_at(&model, initial, value("period"));
    let expected = [initial.q[0], initial.q[1] + TAU, initial.v[0], initial.v[1]];
    check.motion(
        "after a period",
        &[later.q[0], later.q[1], later.v[0], later.v[1]],
        &expected,
    );
}

fn spherical_pendulum(form: &Value, check: &mut Check) {
    let value = |name: &str| number(&form[name]);
    let model: trajectory::SphericalPendulum = model_of(form);
    let initial = State::new(
        0.0,
        [value("theta0"), 0.0],
        [value("theta_dot0"), value("phi_dot0")],
    );
    for (sample, state) in samples(form, &model, initial) {
        let expected = [number(&sample["theta"]), number(&sample["phi"])];
        check.motion("spherical angles", state.q.as_slice(), &expected);
    }
    let later = state_at(&model, initial, value("period_theta"));
    check.motion(
        "after a period",
        later.q.as_slice(),
        &[initial.q[0], value("delta_phi")],
    );
}

/// Equilibrium and small oscillations in a hoop that turns uniformly.
fn bead_on_hoop(form: &Value, check: &mut Check) {
    let value = |name: &str| number(&form[name]);
    let model: trajectory::BeadRotatingHoop = model(&[
        ("m", 1.0),
        ("r", value("r")),
        ("g", value("g")),
        ("w", value("w")),
        ("e", 0.0),
        ("nu", 1.0),
        ("c", 0.0),
    ]);
    let equilibrium = State::new(0.0, [value("theta_eq")], [0.0]);
    check.point(
        "equilibrium",
        model.accelerations(&equilibrium).as_slice(),
        &[0.0],
    );
    let stiffness = -model.linearize(&equilibrium).position[(0, 0)];
    check.point(
        "small oscillations",
        &[stiffness.sqrt()],
        &[value("small_osc_freq")],
    );
}

/// Without a mass and a length of its own: m g l is 1 · mgl · 1.
fn top(form: &Value) -> trajectory::LagrangeTopZxz {
    let value = |name: &str| number(&form[name]);
    model(&[
        ("i_t", value("I")),
        ("i_s", value("I_s")),
        ("m", 1.0),
        ("g", value("mgl")),
        ("l", 1.0),
    ])
}

fn lagrange_top(form: &Value, check: &mut Check) {
    let value = |name: &str| number(&form[name]);
    let model = top(form);
    let (theta, precession) = (value("theta0"), value("phi_dot0"));
    let spin = value("omega3") - precession * theta.cos();
    let initial = State::new(
        0.0,
        [0.0, theta, 0.0],
        [precession, value("theta_dot0"), spin],
    );
    let momenta = model.momenta(&initial);
    check.point(
        "constants",
        &[momenta[0], momenta[2]],
        &[value("C_phi"), value("C_psi")],
    );
    check.point("constants", &[model.energy(&initial)], &[value("E")]);
    for (sample, state) in samples(form, &model, initial) {
        let expected = ["phi", "theta", "psi"].map(|angle| number(&sample[angle]));
        check.motion("Euler angles", state.q.as_slice(), &expected);
    }
    let later = state_at(&model, initial, value("nutation_period"));
    let expected = [value("delta_phi_per_nutation"), theta, initial.v[1]];
    check.motion(
        "after a period",
        &[later.q[0], later.q[1], later.v[1]],
        &expected,
    );
}

/// Slow and fast precession: no acceleration, and the frequency of the nutation about it.
fn steady_precession(form: &Value, check: &mut Check) {
    let value = |name: &str| number(&form[name]);
    let model = top(form);
    for precession in ["slow", "fast"] {
        let rate = value(precession);
        // With a horizontal axis there is no fast one; what is listed comes from the rounding of θ.
        if rate > 1e15 {
            continue;
        }
        let spin = value(&format!("{precession}_psi_dot"));
        let state = State::new(0.0, [0.0, value("theta"), 0.0], [rate, 0.0, spin]);
        check.point(
            "steady precession",
            model.accelerations(&state).as_slice(),
            &[0.0; 3],
        );
        // φ̇ and ψ̇ follow θ, since their accelerations are proportional to θ̇.
        let linearization = model.linearize(&state);
        let (a, b) = (linearization.position, linearization.velocity);
        let stiffness = -(a[(1, 1)] + b[(1, 0)] * b[(0, 1)] + b[(1, 2)] * b[(2, 1)]);
        let expected = value(&format!("{precession}_nutation_freq"));
        check.point("nutation", &[stiffness.sqrt()], &[expected]);
    }
}

/// The angular momentum is vertical, the body precesses steadily about it.
fn free_symmetric_top(form: &Value, check: &mut Check) {
    let value = |name: &str| number(&form[name]);
    let model: trajectory::FreeSymmetricBodyZxz =
        model(&[("i_t", value("I")), ("i_s", value("I_s"))]);
    let (theta, precession, spin) = (value("theta"), value("phi_dot"), value("psi_dot"));
    let state = State::new(0.0, [0.0, theta, 0.0], [precession, 0.0, spin]);
    check.point(
        "steady precession",
        model.accelerations(&state).as_slice(),
        &[0.0; 3],
    );
    check.point(
        "axial rate",
        &[spin + precession * theta.cos()],
        &[value("omega3")],
    );
    let horizontal: Vec<f64> = ["L_X", "L_Y"]
        .iter()
        .flat_map(|axis| {
            model
                .observed(&state)
                .into_iter()
                .filter(move |(name, _)| name == axis)
        })
        .map(|(_, value)| value)
        .collect();
    check.point("angular momentum", &horizontal, &[0.0; 2]);
}

/// Euler's equations in Jacobi functions: the angular velocity, and the angles if the vertical is
/// along L.
fn free_body(form: &Value, check: &mut Check) {
    let [i1, i2, i3] = lagrangian_tests::array(&form["I"]);
    let model: trajectory::FreeAsymmetricBodyZxz = model(&[("i1", i1), ("i2", i2), ("i3", i3)]);
    let initial = with_vertical_momentum([i1, i2, i3], lagrangian_tests::array(&form["omega0"]));
    check.point("energy", &[model.energy(&initial)], &numbers(&form["E"]));
    for (sample, state) in samples(form, &model, initial) {
        check.motion(
            "angular velocity",
            &angular_velocity(&state),
            &numbers(&sample["omega"]),
        );
    }
    let angles = |at: &Value| ["phi", "theta", "psi"].map(|angle| number(&at[angle]));
    if let Some(euler) = form.get("euler_zxz_L_along_Z") {
        check.point(
            "Euler angles at first",
            initial.q.as_slice(),
            &angles(&euler["t0"]),
        );
        let later = state_at(&model, initial, number(&euler["t1"]["t"]));
        check.motion("Euler angles", later.q.as_slice(), &angles(&euler["t1"]));
    }
}

/// The state in which a body turns with ω (in its own axes) and its angular momentum points
/// upwards.
fn with_vertical_momentum(inertia: [f64; 3], w: [f64; 3]) -> State<f64, 3> {
    let momentum: [f64; 3] = std::array::from_fn(|i| inertia[i] * w[i]);
    let theta = momentum[0].hypot(momentum[1]).atan2(momentum[2]);
    let psi = momentum[0].atan2(momentum[1]);
    let precession = (w[0] * psi.sin() + w[1] * psi.cos()) / theta.sin();
    let nutation = w[0] * psi.cos() - w[1] * psi.sin();
    State::new(
        0.0,
        [0.0, theta, psi],
        [precession, nutation, w[2] - precession * theta.cos()],
    )
}

/// Equation (4.4): the angular velocity in body axes.
fn angular_velocity(state: &State<f64, 3>) -> [f64; 3] {
    let (theta, psi) = (state.q[1], state.q[2]);
    let (precession, nutation, spin) = (state.v[0], state.v[1], state.v[2]);
    [
        precession * theta.sin() * psi.sin() + nutation * psi.cos(),
        precession * theta.sin() * psi.cos() - nutation * psi.sin(),
        precession * theta.cos() + spin,
    ]
}
