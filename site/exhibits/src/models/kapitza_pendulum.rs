use lagrangian_models::KapitzaPendulum;

use super::prelude::*;

impl Shown<1> for KapitzaPendulum {
    const ABOUT: About = About {
        slug: "kapitza-pendulum",
        title: "Kapitza's pendulum",
        sentence: "A pendulum stands upright as long as its pivot shakes fast enough.",
        source: include_str!("../../../../models/src/kapitza_pendulum.rs"),
        quantities: &[
            parameter("mass", "kg", 0.1, [0.02, 1.0]),
            parameter("length", "m", 0.2, [0.05, 0.5]),
            parameter("gravity", "m/s²", 9.81, [0.0, 25.0]),
            parameter("amplitude", "m", 0.02, [0.0, 0.05]),
            parameter("frequency", "rad/s", 170.0, [0.0, 400.0]),
            start("angle", "°", 30.0, [-180.0, 180.0]),
        ],
        curves: &[Curve {
            name: "θ",
            unit: "°",
        }],
        seconds: 4.0,
        pace: 0.25,
        view: [0.25, 0.15],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;
    const IS_DRIVEN: bool = true;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        Ok(Self {
            m: mass(values, "mass")?,
            l: values.get("length"),
            g: values.get("gravity"),
            a: values.get("amplitude"),
            omega: values.get("frequency"),
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 1>, Refusal> {
        Ok(State::new(0.0, [values.get("angle")], [0.0]))
    }

    fn power(&self, state: &State<f64, 1>) -> f64 {
        self.energy_rate(state)
    }

    fn scene(&self, state: &State<f64, 1>) -> Scene {
        let p = self.outputs(state).position;
        let pivot = plane(0.0, self.a * (self.omega * state.t).cos());
        let (end, r) = (plane(p.x, p.y), self.l.abs());
        let slide = Shape::new(Form::Cuboid([0.09 * r, 0.05 * r, 0.05 * r]), Tone::Third).at(pivot);
        Scene::seen(plane(0.0, 0.1 * r), 1.25 * r)
            .fixture(Shape::new(
                Form::Bar([0.0, 0.0, -0.5 * r], [0.0, 0.0, 0.4 * r], 0.02 * r),
                Tone::Fixed,
            ))
            .fixture(slide)
            .line(pivot, end, 0.03 * r, Tone::Frame)
            .body(Body::particle(self.m, end, 0.1 * r, Tone::First))
            .trace(end)
    }

    fn curves(&self, state: &State<f64, 1>) -> Vec<f64> {
        vec![state.q[0]]
    }
}
