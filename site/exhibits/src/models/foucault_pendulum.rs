use lagrangian_models::FoucaultPendulum;

use super::prelude::*;

impl Shown<2> for FoucaultPendulum {
    const ABOUT: About = About {
        slug: "foucault-pendulum",
        title: "Foucault's pendulum",
        sentence: "On a globe that turns six hundred times faster than the Earth, the plane of a pendulum turns as one watches.",
        source: include_str!("../../../../models/src/foucault_pendulum.rs"),
        quantities: &[
            parameter("mass", "kg", 28.0, [1.0, 50.0]),
            parameter("length", "m", 10.0, [2.0, 70.0]),
            parameter("gravity", "m/s²", 9.81, [0.5, 25.0]),
            parameter("rate of the globe", "°/s", 2.5, [0.0, 10.0]),
            parameter("latitude", "°", 48.85, [-90.0, 90.0]),
            start("east", "m", 1.8, [-6.0, 6.0]),
            start("north", "m", 0.0, [-6.0, 6.0]),
        ],
        curves: &[
            Curve {
                name: "x",
                unit: "m",
            },
            Curve {
                name: "y",
                unit: "m",
            },
        ],
        seconds: 90.0,
        pace: 4.0,
        view: [0.4, 0.6],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        Ok(Self {
            m: mass(values, "mass")?,
            l: values.get("length"),
            g: values.get("gravity"),
            rate: values.get("rate of the globe"),
            latitude: values.get("latitude"),
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 2>, Refusal> {
        Ok(State::new(
            0.0,
            [values.get("east"), values.get("north")],
            [0.0; 2],
        ))
    }

    fn scene(&self, state: &State<f64, 2>) -> Scene {
        let end = Vector3::new(state.q[0], state.q[1], self.outputs(state).height);
        let r = 0.32 * self.l.abs();
        Scene::seen(plane(0.0, -0.86 * self.l), r)
            .on_ground(-1.06 * self.l)
            .line(Vector3::zeros(), end, 0.012 * r, Tone::Frame)
            .body(Body::particle(self.m, end, 0.1 * r, Tone::First))
            .trace(end)
    }

    fn curves(&self, state: &State<f64, 2>) -> Vec<f64> {
        vec![state.q[0], state.q[1]]
    }
}
