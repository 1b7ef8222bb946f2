use lagrangian_models::DoublePendulum;

use super::prelude::*;

impl Shown<2> for DoublePendulum {
    const ABOUT: About = About {
        slug: "double-pendulum",
        title: "Double pendulum",
        sentence: "Two particles swing one below the other; released from high up, their motion is chaotic.",
        source: include_str!("../../../../models/src/double_pendulum.rs"),
        quantities: &[
            parameter("first mass", "kg", 0.3, [0.05, 2.0]),
            parameter("second mass", "kg", 0.3, [0.05, 2.0]),
            parameter("first length", "m", 0.5, [0.1, 1.0]),
            parameter("second length", "m", 0.5, [0.1, 1.0]),
            parameter("gravity", "m/s²", 9.81, [0.0, 25.0]),
            start("first angle", "°", 120.0, [-180.0, 180.0]),
            start("second angle", "°", 100.0, [-180.0, 180.0]),
        ],
        curves: &[
            Curve {
                name: "θ₀",
                unit: "°",
            },
            Curve {
                name: "θ₁",
                unit: "°",
            },
        ],
        seconds: 8.0,
        pace: 1.0,
        view: [0.25, 0.15],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        Ok(Self {
            m1: mass(values, "first mass")?,
            m2: mass(values, "second mass")?,
            l1: values.get("first length"),
            l2: values.get("second length"),
            g: values.get("gravity"),
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 2>, Refusal> {
        Ok(State::new(
            0.0,
            [values.get("first angle"), values.get("second angle")],
            [0.0; 2],
        ))
    }

    fn scene(&self, state: &State<f64, 2>) -> Scene {
        let outputs = self.outputs(state);
        let [first, second] = [outputs.first, outputs.second].map(|p| plane(p.x, p.y));
        let r = self.l1.abs() + self.l2.abs();
        Scene::seen(plane(0.0, 0.0), 1.1 * r)
            .fixture(support(Vector3::zeros(), r))
            .line(Vector3::zeros(), first, 0.02 * r, Tone::Frame)
            .line(first, second, 0.02 * r, Tone::Frame)
            .body(Body::particle(self.m1, first, 0.06 * r, Tone::First))
            .body(Body::particle(self.m2, second, 0.06 * r, Tone::Second))
            .trace(second)
    }

    fn curves(&self, state: &State<f64, 2>) -> Vec<f64> {
        vec![state.q[0], state.q[1]]
    }
}
