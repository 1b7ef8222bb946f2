//! The source of a model's crate: the declaration as a user writes it, and a `main` that measures it.

use std::fmt::Write as _;

use crate::model::Model;

/// What the struct and its attribute are written from.
struct Declaration {
    title: &'static str,
    /// The clauses of the attribute.
    clauses: String,
    parameters: &'static [(&'static str, f64)],
}

/// What of the library of this package a model's crate calls.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Calls {
    Measure,
    MeasureWithRounding,
    /// Of a model with the clause `taylor`.
    Integrate,
    /// Of such a model that takes long to compile.
    IntegrateAlone,
    /// Of such a model for its references.
    IntegratePrecisely,
    /// Of such a model that is reduced by its ignorable coordinates to one angle.
    CompareReduced,
    /// Nothing: one integration, as a user writes it, of a model with the clause `taylor`.
    Taylor,
    /// The same without the clause.
    Dop853,
    /// Ensembles of such a model, with two events.
    Ensembles,
}

impl Calls {
    /// What the declaration says besides what every model has.
    fn clause(self, model: Model) -> String {
        let clause = match self {
            Self::Measure | Self::MeasureWithRounding | Self::Dop853 => "",
            Self::Integrate | Self::IntegrateAlone | Self::IntegratePrecisely | Self::Taylor => {
                "    taylor,\n"
            }
            Self::CompareReduced => "    taylor,\n    routhian(Reduced),\n",
            Self::Ensembles => return format!("    taylor,\n    {},\n", events(model)),
        };
        clause.to_owned()
    }

    /// What `main` does with the model, and what it returns.
    fn body(self, degrees: usize) -> (String, &'static str) {
        let function = match self {
            Self::Measure => "measure",
            Self::MeasureWithRounding => "measure_with_rounding",
            Self::Integrate => "integrate",
            Self::IntegrateAlone => "integrate_alone",
            Self::IntegratePrecisely => "integrate_precisely",
            Self::CompareReduced => return compare_reduced(degrees),
            Self::Taylor => return once("Taylor", degrees),
            Self::Dop853 => return once("Dop853", degrees),
            Self::Ensembles => {
                let body = "    contest(&model)\n".to_owned();
                return (body, "std::process::ExitCode");
            }
        };
        let call = format!(
            "    let operations = Model::OPERATIONS.accelerations;\n    \
             lagrangian_bench::{function}::<{degrees}, Model>(&model, operations)\n"
        );
        (call, "std::process::ExitCode")
    }
}

/// Steps of the full model and of the reduced one, from where the trajectories of the symmetric top begin.
fn compare_reduced(degrees: usize) -> (String, &'static str) {
    let call = format!(
        "    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 20.0]);\n    \
         lagrangian_bench::compare_steps::<{degrees}, 1, Model>(&model, start)\n"
    );
    (call, "std::process::ExitCode")
}

/// A motion of ten seconds.
fn once(method: &str, degrees: usize) -> (String, &'static str) {
    let body = format!(
        "    let start = State::new(0.0, [0.3; {degrees}], [0.1; {degrees}]);\n    \
         let end = Problem::new(&model, start).solve(10.0, {method}::new())?;\n    \
         println!(\"{{:e}}\", model.energy(&end) / model.energy(&start) - 1.0);\n    Ok(())\n"
    );
    (body, "Result<(), IntegrationError>")
}

/// What integrates ensembles.
const ENSEMBLES: &str = include_str!("../models/ensembles.rs");

/// An event that occurs again and again, and one that never does.
fn events(model: Model) -> &'static str {
    match model {
        Model::Pendulum(_) => "event(often = dot(q2) - dot(q1), never = q1 - 2.0)",
        _ => "event(often = dot(theta), never = theta - 2.5)",
    }
}

fn declaration(model: Model) -> Declaration {
    match model {
        Model::SymmetricTop => symmetric_top(),
        Model::GeneralTop => general_top(),
        Model::Pendulum(links) => pendulum(links),
        Model::GeneralTopMultipliedOut => general_top_multiplied_out(),
        Model::DoublePendulumMultipliedOut => double_pendulum_multiplied_out(),
        Model::Arm => arm(),
        Model::ThreeBodies => three_bodies(),
    }
}

/// The `main.rs` of a model's crate.
pub(crate) fn source(model: Model, calls: Calls) -> String {
    let declaration = declaration(model);
    let Declaration { title, clauses, .. } = &declaration;
    let clause = calls.clause(model);
    let (mut fields, mut values) = (String::new(), String::new());
    for (name, value) in declaration.parameters {
        let _ = write!(fields, "{name}: f64, ");
        let _ = write!(values, "{name}: {value:?}, ");
    }
    let degrees = model.degrees();
    let (body, result) = calls.body(degrees);
    let functions = match calls {
        Calls::Ensembles => format!("\nconst DEGREES: usize = {degrees};\n{ENSEMBLES}"),
        _ => String::new(),
    };
    format!(
        "//! Written by lagrangian-bench.\n\
         use lagrangian::prelude::*;\n\n\
         /// {title}\n\
         #[derive(Lagrangian, Clone, Debug)]\n\
         #[lagrangian(\n{clause}{clauses})]\n\
         struct Model {{ {fields}}}\n\n\
         fn main() -> {result} {{\n\
         \x20   let model = Model {{ {values}}};\n{body}}}\n{functions}"
    )
}

fn symmetric_top() -> Declaration {
    Declaration {
        title: "The symmetric heavy top (4.7).",
        clauses: "    \
    coordinates(phi, theta, psi),
    kinetic = 0.5 * (i * (dot(phi).powi(2) * sin(theta).powi(2) + dot(theta).powi(2))
        + i_s * (dot(phi) * cos(theta) + dot(psi)).powi(2)),
    potential = m * g * l * cos(theta),
"
        .to_owned(),
        parameters: &[
            ("i", 1.2),
            ("i_s", 0.5),
            ("m", 1.3),
            ("g", 9.81),
            ("l", 0.4),
        ],
    }
}

fn general_top() -> Declaration {
    Declaration {
        title: "The general heavy top (4.5).",
        clauses: "    \
    coordinates(phi, theta, psi),
    define(
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (i1 * w1.powi(2) + i2 * w2.powi(2) + i3 * w3.powi(2)),
    potential = m * g
        * (x * sin(theta) * sin(psi) + y * sin(theta) * cos(psi) + z * cos(theta)),
"
        .to_owned(),
        parameters: &[
            ("i1", 1.2),
            ("i2", 1.5),
            ("i3", 0.7),
            ("m", 1.3),
            ("g", 9.81),
            ("x", 0.05),
            ("y", 0.03),
            ("z", 0.4),
        ],
    }
}

/// The same system as the general top, entry by entry of its mass matrix.
fn general_top_multiplied_out() -> Declaration {
    Declaration {
        title: "The general heavy top (4.5), its kinetic energy expanded.",
        clauses: "    \
    coordinates(phi, theta, psi),
    kinetic = 0.5 * i1 * sin(theta).powi(2) * sin(psi).powi(2) * dot(phi).powi(2)
        + 0.5 * i2 * sin(theta).powi(2) * cos(psi).powi(2) * dot(phi).powi(2)
        + 0.5 * i3 * cos(theta).powi(2) * dot(phi).powi(2)
        + i1 * sin(theta) * sin(psi) * cos(psi) * dot(phi) * dot(theta)
        - i2 * sin(theta) * sin(psi) * cos(psi) * dot(phi) * dot(theta)
        + 0.5 * i1 * cos(psi).powi(2) * dot(theta).powi(2)
        + 0.5 * i2 * sin(psi).powi(2) * dot(theta).powi(2)
        + i3 * cos(theta) * dot(phi) * dot(psi)
        + 0.5 * i3 * dot(psi).powi(2),
    potential = m * g
        * (x * sin(theta) * sin(psi) + y * sin(theta) * cos(psi) + z * cos(theta)),
"
        .to_owned(),
        ..general_top()
    }
}

/// The same system as two links, with the angle between them.
fn double_pendulum_multiplied_out() -> Declaration {
    Declaration {
        title: "Two point masses on massless rods, the kinetic energy expanded.",
        clauses: "    \
    coordinates(q1, q2),
    kinetic = m * l.powi(2)
        * (dot(q1).powi(2) + 0.5 * dot(q2).powi(2) + dot(q1) * dot(q2) * cos(q1 - q2)),
    potential = -m * g * l * (2.0 * cos(q1) + cos(q2)),
"
        .to_owned(),
        ..pendulum(2)
    }
}

/// Each mass stands where the one above it does, and a rod further.
fn pendulum(links: usize) -> Declaration {
    let mut positions = String::new();
    for link in 1..=links {
        let (x, y) = match link - 1 {
            0 => (String::new(), String::new()),
            above => (format!("x{above} + "), format!("y{above} ")),
        };
        let _ = writeln!(positions, "        x{link} = {x}l * sin(q{link}),");
        let _ = writeln!(positions, "        y{link} = {y}-l * cos(q{link}),");
    }
    let coordinates = join(links, ", ", |link| format!("q{link}"));
    let kinetic = join(links, "\n        + ", |link| {
        format!("0.5 * m * (dot(x{link}).powi(2) + dot(y{link}).powi(2))")
    });
    let potential = join(links, " + ", |link| format!("m * g * y{link}"));
    Declaration {
        title: "A chain of point masses on massless rods, at absolute angles.",
        clauses: format!(
            "    coordinates({coordinates}),\n    define(\n{positions}    ),\n    \
             kinetic = {kinetic},\n    potential = {potential},\n"
        ),
        parameters: &[("m", 1.1), ("l", 0.7), ("g", 9.81)],
    }
}

/// Yaw, shoulder and elbow, of two links with motors and friction.
fn arm() -> Declaration {
    Declaration {
        title: "An arm of three joints that follow torques in time.",
        clauses: "    \
    coordinates(q1, q2, q3),
    define(
        turn = rotation_z(q1),
        upper = turn * [cos(q2), 0.0, sin(q2)],
        lower = turn * [cos(q2 + q3), 0.0, sin(q2 + q3)],
        c2 = a2 * upper,
        c3 = l2 * upper + a3 * lower,
    ),
    kinetic = 0.5 * j1 * dot(q1).powi(2),
    kinetic = 0.5 * (m2 * dot(c2).norm_squared() + i2 * dot(upper).norm_squared()),
    kinetic = 0.5 * (m3 * dot(c3).norm_squared() + i3 * dot(lower).norm_squared()),
    potential = g * (m2 * c2.z + m3 * c3.z),
    dissipation = 0.5 * (b1 * dot(q1).powi(2) + b2 * dot(q2).powi(2) + b3 * dot(q3).powi(2)),
    force(q1 = k1 * sin(w * t), q2 = k2 * cos(w * t), q3 = k3),
"
        .to_owned(),
        parameters: &[
            ("j1", 0.5),
            ("m2", 3.0),
            ("m3", 2.0),
            ("l2", 0.5),
            ("a2", 0.25),
            ("a3", 0.2),
            ("i2", 0.06),
            ("i3", 0.03),
            ("g", 9.81),
            ("b1", 0.1),
            ("b2", 0.1),
            ("b3", 0.05),
            ("k1", 2.0),
            ("k2", 10.0),
            ("k3", 3.0),
            ("w", 2.0),
        ],
    }
}

fn three_bodies() -> Declaration {
    Declaration {
        title: "Three equal masses in a plane that attract each other.",
        clauses: "    \
    coordinates(r[3]: Vector2),
    kinetic = (0..3).map(|i| 0.5 * m * dot(r[i]).norm_squared()).sum(),
    potential = -(0..3).map(|i| (0..i).map(|j| g * m * m / (r[i] - r[j]).norm()).sum()).sum(),
"
        .to_owned(),
        parameters: &[("m", 1.0), ("g", 1.0)],
    }
}

fn join(links: usize, separator: &str, part: impl Fn(usize) -> String) -> String {
    (1..=links).map(part).collect::<Vec<_>>().join(separator)
}
