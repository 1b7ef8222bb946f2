use lagrangian_models::SimplePendulum;

use super::prelude::*;

impl Shown<1> for SimplePendulum {
    const ABOUT: About = About {
        slug: "simple-pendulum",
        title: "Simple pendulum",
        sentence: "A particle on a rod without mass swings in a plane; close to the upper equilibrium it lingers.",
        source: include_str!("../../../../models/src/simple_pendulum.rs"),
        quantities: &[
            parameter("mass", "kg", 0.3, [0.05, 2.0]),
            parameter("length", "m", 0.8, [0.2, 2.0]),
            parameter("gravity", "m/s²", 9.81, [0.0, 25.0]),
            start("angle", "°", 150.0, [-180.0, 180.0]),
            start("rate", "°/s", 0.0, [-900.0, 900.0]),
        ],
        curves: &[
            Curve {
                name: "θ",
                unit: "°",
            },
            Curve {
                name: "θ̇",
                unit: "°/s",
            },
        ],
        seconds: 8.0,
        pace: 1.0,
        view: [0.25, 0.15],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        Ok(Self {
            m: mass(values, "mass")?,
            l: values.get("length"),
            g: values.get("gravity"),
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 1>, Refusal> {
        Ok(State::new(0.0, [values.get("angle")], [values.get("rate")]))
    }

    fn scene(&self, state: &State<f64, 1>) -> Scene {
        let (s, c) = state.q[0].sin_cos();
        let (end, r) = (plane(self.l * s, -self.l * c), self.l.abs());
        Scene::seen(plane(0.0, 0.0), 1.2 * r)
            .fixture(support(Vector3::zeros(), r))
            .line(Vector3::zeros(), end, 0.025 * r, Tone::Frame)
            .body(Body::particle(self.m, end, 0.09 * r, Tone::First))
            .trace(end)
    }

    fn curves(&self, state: &State<f64, 1>) -> Vec<f64> {
        vec![state.q[0], state.v[0]]
    }
}
