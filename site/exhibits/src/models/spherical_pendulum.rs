use lagrangian_models::SphericalPendulum;

use super::prelude::*;

impl Shown<2> for SphericalPendulum {
    const ABOUT: About = About {
        slug: "spherical-pendulum",
        title: "Spherical pendulum",
        sentence: "A particle swings on a sphere; the momentum of its azimuth is constant, and its path is a rosette.",
        source: include_str!("../../../../models/src/spherical_pendulum.rs"),
        quantities: &[
            parameter("mass", "kg", 0.3, [0.05, 2.0]),
            parameter("length", "m", 0.8, [0.2, 2.0]),
            parameter("gravity", "m/s²", 9.81, [0.0, 25.0]),
            start("tilt", "°", 75.0, [1.0, 179.0]),
            start("azimuth rate", "°/s", 70.0, [-900.0, 900.0]),
        ],
        curves: &[
            Curve {
                name: "θ",
                unit: "°",
            },
            Curve {
                name: "φ̇",
                unit: "°/s",
            },
        ],
        seconds: 12.0,
        pace: 1.0,
        view: [0.5, 0.45],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        Ok(Self {
            m: mass(values, "mass")?,
            l: values.get("length"),
            g: values.get("gravity"),
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 2>, Refusal> {
        Ok(State::new(
            0.0,
            [values.get("tilt"), 0.0],
            [0.0, values.get("azimuth rate")],
        ))
    }

    fn scene(&self, state: &State<f64, 2>) -> Scene {
        let (end, r) = (self.outputs(state).position, self.l.abs());
        Scene::seen(plane(0.0, -0.45 * r), 1.1 * r)
            .on_ground(-1.15 * r)
            .fixture(support(Vector3::zeros(), r))
            .line(Vector3::zeros(), end, 0.022 * r, Tone::Frame)
            .body(Body::particle(self.m, end, 0.08 * r, Tone::First))
            .trace(end)
    }

    fn curves(&self, state: &State<f64, 2>) -> Vec<f64> {
        vec![state.q[0], state.v[1]]
    }
}
