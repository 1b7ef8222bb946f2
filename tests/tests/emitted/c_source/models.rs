//! Models that are written in C, each with its comparison.

use lagrangian::prelude::*;
use lagrangian::rigid_body::Solid;

use super::program::{
    Agreement, Case, Check, PROJECTIONS, body, check, constrained, free, input_matrix,
    on_constraints, state_matrix,
};

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
pub(super) struct CartPole {
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
pub(super) fn cart_pole(pole: f32) -> Case {
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

/// An arm of bodies, a family of coordinates and of parameters, a vector and a matrix.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[3]),
    define(
        turned = rotation_z(q[0]),
        raised = turned * rotation_y(q[1]),
        bent = raised * rotation_y(q[2]),
        elbow = shoulder + raised * [length, 0.0, 0.0],
    ),
    body(column = (turned, [0.0, 0.0, 0.0]), upper = (raised, shoulder), lower = (bent, elbow)),
    gravity = [0.0, 0.0, -g],
    force(q[i] = -stiffness[i] * q[i] for i in 0..3),
    force(q[i] = torque[i] for i in 0..3),
    output(hand = elbow + bent * (mount * lower.center)),
    c,
)]
pub(super) struct Arm3R {
    column: SymmetricBody,
    upper: RigidBody,
    lower: RigidBody,
    shoulder: Vector3<f64>,
    mount: Matrix3<f64>,
    stiffness: [f64; 3],
    length: f64,
    g: f64,
    #[lagrangian(input)]
    torque: [f64; 3],
}

pub(super) fn arm() -> Case {
    let solid = |size: f64, mass: f64| {
        let solid = Solid::cylinder(size, 2.0 * size).expect("a cylinder");
        solid.with_mass(mass).expect("a body")
    };
    let column = SymmetricBody::of(&solid(0.3, 20.0)).expect("a symmetric body");
    let turned = nalgebra::Rotation3::from_euler_angles(0.3, -0.5, 1.1);
    let [upper, lower] = [(0.2, 3.0), (0.1, 2.0)].map(|(size, mass)| {
        solid(size, mass)
            .turned(&turned)
            .moved(Vector3::new(0.3, 0.02, -0.01))
    });
    let shoulder = Vector3::new(0.1, 0.05, 0.5);
    let mount = Matrix3::new(1.0, 0.1, 0.0, -0.2, 0.9, 0.3, 0.0, 0.25, 1.1);
    let model = move |u: &[f64]| Arm3R {
        column,
        upper,
        lower,
        shoulder,
        mount,
        stiffness: [0.5, 0.25, 0.125],
        length: 0.6,
        g: 9.81,
        torque: [u[0], u[1], u[2]],
    };
    let parameters = [
        body!(column),
        body!(upper),
        body!(lower),
        shoulder.as_slice().to_vec(),
        mount.transpose().as_slice().to_vec(),
        vec![0.5, 0.25, 0.125, 0.6, 9.81],
    ];
    let mut checks = free!(3, model);
    checks.push(state_matrix!(3, model, "b, "));
    let call = "double a2[36]; $_linearize(POINT, a2, y, NULL);";
    checks.push(input_matrix!(3, 3, model, call));
    let call = "$_outputs o; $_compute_outputs(POINT, &o); memcpy(y, &o, sizeof o);";
    checks.push(check("outputs", 3, call, move |point| {
        Some(
            model(&point.u)
                .outputs(&point.state::<3>())
                .hand
                .as_slice()
                .to_vec(),
        )
    }));
    Case {
        prefix: "arm3_r",
        source: Arm3R::C_SOURCE,
        header: Arm3R::C_HEADER,
        casadi: Arm3R::C_CASADI,
        parameters: parameters.concat(),
        coordinates: 3,
        inputs: 3,
        checks,
        agreement: Agreement::Bits,
    }
}

/// Constraints that depend on each other where they hold, with compliances, beside one that does not.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(p: Vector3, w, s, r),
    kinetic = 0.5 * m * dot(p).norm_squared() + 0.5 * inertia * dot(w).powi(2) + 0.5 * (dot(s) - 0.2 * dot(r)).powi(2) + 0.25 * dot(r).powi(2),
    potential = m * g * p.y,
    force(p = [push, 0.0, wind], w = -w),
    constraint(rod = 0.5 * (p.norm_squared() - l.powi(2)), wall = p.z, frame = p.z * (1.0 + w.powi(2))),
    nonholonomic(roll = dot(s) - p.y * dot(r)),
    compliance(wall = soft, frame = hard),
    output(tension = l * reaction(rod), carried = [reaction(wall), reaction(frame)], turning = dot(dot(w))),
    c,
)]
pub(super) struct Guided {
    m: f64,
    inertia: f64,
    g: f64,
    l: f64,
    soft: f64,
    hard: f64,
    #[lagrangian(input)]
    push: f64,
    #[lagrangian(input)]
    wind: f64,
}

pub(super) fn guided() -> Case {
    let model = |u: &[f64]| Guided {
        m: 0.8,
        inertia: 0.3,
        g: 9.81,
        l: 2.0,
        soft: 0.5,
        hard: 0.125,
        push: u[0],
        wind: u[1],
    };
    let mut checks = constrained!(6, 4, model);
    checks.push(input_matrix!(6, 2, model, "$_input_matrix(POINT, y);"));
    let call = "$_outputs o; $_compute_outputs(POINT, &o); memcpy(y, &o, sizeof o);";
    checks.push(check("outputs", 4, call, move |point| {
        let found = model(&point.u).outputs(&point.state::<6>());
        Some(
            [
                &[found.tension][..],
                found.carried.as_slice(),
                &[found.turning],
            ]
            .concat(),
        )
    }));
    let call = format!("{PROJECTIONS} $_accelerations(MOVED, y, y + 6);");
    checks.push(check(
        "multipliers of least norm",
        10,
        &call,
        move |point| {
            let model = model(&point.u);
            let on = on_constraints!(model, point, 6);
            let (a, lambda) = (model.accelerations(&on), model.multipliers::<4>(&on));
            Some([a.as_slice(), lambda.as_slice()].concat())
        },
    ));
    checks.push(check(
        "residuals",
        8,
        "$_constraint_residuals(POINT, y, y + 4);",
        move |point| {
            let (of_q, of_v) = model(&point.u).constraint_residuals::<4>(&point.state::<6>());
            Some([of_q.as_slice(), of_v.as_slice()].concat())
        },
    ));
    Case {
        prefix: "guided",
        source: Guided::C_SOURCE,
        header: Guided::C_HEADER,
        casadi: Guided::C_CASADI,
        parameters: vec![0.8, 0.3, 9.81, 2.0, 0.5, 0.125],
        coordinates: 6,
        inputs: 2,
        checks,
        agreement: Agreement::Bits,
    }
}

/// A mass matrix that is not positive definite, with rows of different sizes.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b, c, d, e),
    lagrangian = dot(a) * dot(b) + 0.5 * dot(a).powi(2) * cos(b + c) + dot(b) * dot(c) * sin(a + d)
        + 0.5 * dot(c).powi(2) * (2.0 + cos(d + e)) + 250.0 * dot(c) * dot(e) * sin(b)
        + dot(d) * dot(e) * (3.0 + sin(a)) + 0.5 * dot(d).powi(2) * cos(c) + 0.3 * dot(a) * dot(e) * cos(d)
        + 0.2 * dot(b) * dot(d) * sin(c + e) + dot(a) * b - k * (a.powi(2) + b * c + sin(d) * e),
    force(d = -dot(d), e = t * dot(a)),
    c,
)]
pub(super) struct Indefinite {
    k: f64,
}

pub(super) fn indefinite() -> Case {
    let model = |_: &[f64]| Indefinite { k: 0.7 };
    let mut checks = free!(5, model);
    checks.push(state_matrix!(5, model, ""));
    Case {
        prefix: "indefinite",
        source: Indefinite::C_SOURCE,
        header: Indefinite::C_HEADER,
        casadi: Indefinite::C_CASADI,
        parameters: vec![0.7],
        coordinates: 5,
        inputs: 0,
        checks,
        agreement: Agreement::Bits,
    }
}

/// Names that C has for itself, or not at all.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(int, θ),
    kinetic = 0.5 * double * dot(int).powi(2) + 0.5 * λ * dot(θ).powi(2),
    potential = register * cos(int - θ),
    output(double_ = int + double, void = θ),
    c,
)]
#[allow(non_snake_case)]
pub(super) struct Signed {
    double: f64,
    λ: f64,
    register: f64,
}

pub(super) fn names() -> Case {
    let model = |_: &[f64]| Signed {
        double: 1.5,
        λ: 0.75,
        register: 2.25,
    };
    let call = "$_outputs o; $_compute_outputs(POINT, &o); memcpy(y, &o, sizeof o);";
    let mut checks = free!(2, model);
    checks.push(check("outputs", 2, call, move |point| {
        let found = model(&[]).outputs(&point.state::<2>());
        Some(vec![found.double_, found.void])
    }));
    Case {
        prefix: "signed_",
        source: Signed::C_SOURCE,
        header: Signed::C_HEADER,
        casadi: Signed::C_CASADI,
        parameters: vec![1.5, 0.75, 2.25],
        coordinates: 2,
        inputs: 0,
        checks,
        agreement: Agreement::Bits,
    }
}

/// A model without parameters.
#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * dot(x).powi(2), potential = 0.5 * x.powi(2), c)]
pub(super) struct Oscillator {}

pub(super) fn oscillator() -> Case {
    let model = |_: &[f64]| Oscillator {};
    let mut checks = free!(1, model);
    checks.push(state_matrix!(1, model, ""));
    Case {
        prefix: "oscillator",
        source: Oscillator::C_SOURCE,
        header: Oscillator::C_HEADER,
        casadi: Oscillator::C_CASADI,
        parameters: Vec::new(),
        coordinates: 1,
        inputs: 0,
        checks,
        agreement: Agreement::Bits,
    }
}

/// All functions of the language, and those that stand for what is written by exponentials.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    define(s = x / 4.0),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = ln(1.0 + exp(y)) + ln(cosh(x)) + atan2(x, 3.0 + y),
    dissipation = 0.5 * m * (1.0 + tanh(x)) * dot(x).powi(2),
    force(x = -c * abs(dot(x)) * dot(x) - signum(dot(x)), y = max(x, y) * min(x, y) - sqrt(x.powi(2) + y.powi(2))),
    output(
        tangent = tan(x), inverse_sine = asin(s), inverse_cosine = acos(s), inverse_tangent = atan(x),
        hyperbolic = sinh(x), cosine = cosh(x), in_between = tanh(x), inverse = asinh(x), beyond = acosh(2.0 + s), within = atanh(s),
        exponential = exp(x), logarithm = ln(5.0 + x), power = powf(5.0 + x, y), sign = signum(x), size = abs(x), secant = 1.0 / cosh(x),
        logistic = 1.0 / (1.0 + exp(-x)), root = (x + 5.0).powf(1.0 / 3.0), angle = atan2(y, x), least = min(x, y), most = max(x, y),
        slope = x / (x.powi(2) + y.powi(2)), sine = sin(100.0 * x), speed = dot(x).powi(2) / sqrt(dot(x).powi(2) + dot(y).powi(2)),
    ),
    c,
)]
pub(super) struct Functions {
    m: f64,
    c: f64,
}

pub(super) fn elementary_functions() -> Case {
    let model = |_: &[f64]| Functions { m: 1.25, c: 0.3 };
    let mut checks = free!(2, model);
    checks.push(state_matrix!(2, model, ""));
    macro_rules! outputs {
        ($($name:ident),*) => {
            $(checks.push(check(
                stringify!($name),
                1,
                concat!("$_outputs o; $_compute_outputs(POINT, &o); y[0] = o.", stringify!($name), ";"),
                move |point| Some(vec![model(&[]).outputs(&point.state::<2>()).$name]),
            ));)*
        };
    }
    outputs! {
        tangent, inverse_sine, inverse_cosine, inverse_tangent, hyperbolic, cosine, in_between, inverse, beyond, within, exponential,
        logarithm, power, sign, size, secant, logistic, root, angle, least, most, slope, sine, speed
    }
    Case {
        prefix: "functions",
        source: Functions::C_SOURCE,
        header: Functions::C_HEADER,
        casadi: Functions::C_CASADI,
        parameters: vec![1.25, 0.3],
        coordinates: 2,
        inputs: 0,
        checks,
        agreement: Agreement::Units(2.0),
    }
}

/// A chain of joints in a plane, whose accelerations are found along the links.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[5]),
    define(
        angle[0] = q[0],
        angle[i] = angle[i - 1] + q[i] for i in 1..5,
        p[0] = l[0] * [sin(angle[0]), -cos(angle[0])],
        p[i] = p[i - 1] + l[i] * [sin(angle[i]), -cos(angle[i])] for i in 1..5,
    ),
    kinetic = (0..5).map(|i| 0.5 * m[i] * dot(p[i]).norm_squared()).sum(),
    potential = (0..5).map(|i| m[i] * g * p[i].y).sum(),
    force(q[i] = push[i] - 0.1 * dot(q[i]) for i in 0..5),
    c,
)]
pub(super) struct Chain {
    m: [f64; 5],
    l: [f64; 5],
    g: f64,
    #[lagrangian(input)]
    push: [f64; 5],
}

/// With this mass of the fourth link. If it is negative enough, accelerations are solved for numerically.
pub(super) fn chain(mass: f64) -> Case {
    let (m, l) = ([1.0, 0.5, 0.75, mass, 0.25], [0.5, 0.4, 0.3, 0.6, 0.2]);
    let model = move |u: &[f64]| Chain {
        m,
        l,
        g: 9.81,
        push: std::array::from_fn(|i| u[i]),
    };
    let mut checks = free!(5, model);
    checks.push(state_matrix!(5, model, "b, "));
    let call = "double a2[100]; $_linearize(POINT, a2, y, NULL);";
    checks.push(input_matrix!(5, 5, model, call));
    Case {
        prefix: "chain",
        source: Chain::C_SOURCE,
        header: Chain::C_HEADER,
        casadi: Chain::C_CASADI,
        parameters: [&m[..], &l, &[9.81]].concat(),
        coordinates: 5,
        inputs: 5,
        checks,
        agreement: Agreement::Bits,
    }
}

/// A mass that slides on a turning rod, whose angle is ignorable, with parameters of any scalar.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)) + 0.5 * i * dot(phi).powi(2),
    potential = 0.5 * k * r.powi(2),
    output(rate = dot(phi)),
    routhian(Radial),
    c,
)]
pub(super) struct Slider<T: Scalar> {
    m: T,
    i: T,
    k: T,
}

/// The reduced model.
pub(super) fn radial() -> Case {
    let model = |_: &[f64]| {
        let slider = Slider {
            m: 1.5,
            i: 0.25,
            k: 3.0,
        };
        slider.reduce(&State::new(0.0, [1.0, 0.0], [0.0, 1.5])).0
    };
    let mut checks = free!(1, model);
    checks.push(state_matrix!(1, model, ""));
    let call = "$_outputs o; $_compute_outputs(POINT, &o); y[0] = o.rate;";
    checks.push(check("outputs", 1, call, move |point| {
        Some(vec![model(&[]).outputs(&point.state::<1>()).rate])
    }));
    Case {
        prefix: "radial",
        source: Radial::<f64>::C_SOURCE,
        header: Radial::<f64>::C_HEADER,
        casadi: Radial::<f64>::C_CASADI,
        parameters: vec![1.5, 0.25, 3.0, model(&[]).p_phi],
        coordinates: 1,
        inputs: 0,
        checks,
        agreement: Agreement::Bits,
    }
}
