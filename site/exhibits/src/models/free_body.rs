use lagrangian::rigid_body::Solid;
use lagrangian_models::FreeBody;

use super::prelude::*;

impl Shown<6> for FreeBody {
    const ABOUT: About = About {
        slug: "free-body",
        title: "Free body",
        sentence: "A brick without weight that turns about its middle axis flips over again and again.",
        source: include_str!("../../../../models/src/free_body.rs"),
        quantities: &[
            parameter("mass", "kg", 2.0, [0.1, 10.0]),
            parameter("depth", "m", 0.15, [0.02, 0.4]),
            parameter("width", "m", 0.3, [0.02, 0.4]),
            parameter("height", "m", 0.05, [0.02, 0.4]),
            parameter("gravity", "m/s²", 0.0, [0.0, 25.0]),
            start("upward speed", "m/s", 0.0, [0.0, 10.0]),
            start("rate", "°/s", 360.0, [-1500.0, 1500.0]),
            start("disturbance", "°", 1.0, [-20.0, 20.0]),
        ],
        curves: &[
            Curve {
                name: "ψ",
                unit: "°",
            },
            Curve {
                name: "θ",
                unit: "°",
            },
        ],
        seconds: 12.0,
        pace: 1.0,
        view: [0.5, 0.3],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        let sides = ["depth", "width", "height"].map(|name| values.get(name));
        let brick = Solid::cuboid(sides[0], sides[1], sides[2])?.with_mass(values.get("mass"))?;
        Ok(Self {
            body: PrincipalBody::of(&brick),
            gravity: Vector3::new(0.0, 0.0, -values.get("gravity")),
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 6>, Refusal> {
        let psi = core::f64::consts::FRAC_PI_2 + values.get("disturbance");
        let q = [0.0, 0.0, 0.0, 0.0, core::f64::consts::FRAC_PI_2, psi];
        Ok(State::new(
            0.0,
            q,
            [
                0.0,
                0.0,
                values.get("upward speed"),
                values.get("rate"),
                0.0,
                0.0,
            ],
        ))
    }

    fn scene(&self, state: &State<f64, 6>) -> Scene {
        let axes = zxz(state.q[3], state.q[4], state.q[5]);
        let origin = Vector3::new(state.q[0], state.q[1], state.q[2]);
        // The half edges of a cuboid with these moments.
        let [a, b, c] = self.body.moments();
        let half = [b + c - a, c + a - b, a + b - c]
            .map(|sum| (1.5 * sum / self.body.mass()).max(0.0).sqrt());
        let r = Vector3::from(half).norm();
        let body = Body::rigid(self.body, axes, origin)
            .with(Shape::new(Form::Cuboid(half), Tone::First))
            .with(Shape::new(
                Form::Bar([half[0], 0.0, 0.0], [1.7 * half[0], 0.0, 0.0], 0.05 * r),
                Tone::Second,
            ));
        Scene::seen(origin, 1.75 * r)
            .body(body)
            .trace(origin + axes * Vector3::x() * (1.7 * half[0]))
    }

    fn curves(&self, state: &State<f64, 6>) -> Vec<f64> {
        vec![state.q[5], state.q[4]]
    }
}
