//! The spherical pendulum from its position, against the references and against its solution in elliptic
//! functions.

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, assert_close, list, motions, number, references, text};

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, phi),
    define(r = l * [sin(theta) * cos(phi), sin(theta) * sin(phi), -cos(theta)]),
    kinetic = 0.5 * m * dot(r).norm_squared(),
    potential = m * g * r.z,
    output(angular_momentum = m * r.cross(dot(r)), pull = m * (dot(dot(r)) + [0, 0, g])),
)]
pub(super) struct SphericalPendulum {
    m: f64,
    l: f64,
    g: f64,
}

#[test]
fn it_moves_as_the_references() {
    let mut figures = Figures::new();
    for motion in motions("spherical_pendulum") {
        let [m, l, g] = motion.parameters(["m", "l", "g"]);
        let model = SphericalPendulum { m, l, g };
        motion.compare("spherical pendulum", &model.dynamics(), 1e-10, &mut figures);
    }
    figures.finish();
}

/// After a period of θ it is turned by Δφ, its angular momentum about the vertical is what it was, and all
/// the while the rod pulls along itself.
#[test]
fn it_returns_after_the_period_of_the_closed_form() -> Result<(), IntegrationError> {
    let document = references();
    let forms = list(&document["closed_forms"]).iter();
    for form in forms.filter(|form| text(&form["kind"]) == "spherical_pendulum") {
        let value = |name: &str| number(&form[name]);
        let mass = form.get("m").filter(|mass| !mass.is_null());
        let model = SphericalPendulum {
            m: mass.map_or(1.0, number),
            l: value("l"),
            g: value("g"),
        };
        let [theta, theta_dot] = [value("theta0"), value("theta_dot0")];
        let start = State::new(0.0, [theta, 0.0], [theta_dot, value("phi_dot0")]);
        let method = Dop853::new()
            .relative_tolerance(1e-13)
            .absolute_tolerance(1e-13);
        let end = Problem::new(&model, start).solve(value("period_theta"), method)?;
        assert_close(
            "angles",
            end.q.as_slice(),
            &[theta, value("delta_phi")],
            1e-10,
        );
        assert_close("velocities", end.v.as_slice(), start.v.as_slice(), 1e-10);
        let [at_first, at_last] = [start, end.last].map(|state| model.outputs(&state));
        let vertical = [at_first.angular_momentum.z];
        assert_close("momentum", &[at_last.angular_momentum.z], &vertical, 1e-12);
        let rod = SVector::from([
            end.q[0].sin() * end.q[1].cos(),
            end.q[0].sin() * end.q[1].sin(),
            -end.q[0].cos(),
        ]);
        let across = at_last.pull.cross(&rod);
        assert_close("pull across the rod", across.as_slice(), &[0.0; 3], 1e-12);
    }
    Ok(())
}
