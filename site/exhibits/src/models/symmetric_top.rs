use lagrangian::rigid_body::Solid;
use lagrangian_models::SymmetricTop;

use super::prelude::*;

impl Shown<3> for SymmetricTop {
    const ABOUT: About = About {
        slug: "symmetric-top",
        title: "Symmetric top",
        sentence: "A disc on a light stem spins about its axis, precesses about the vertical, and nods.",
        source: include_str!("../../../../models/src/symmetric_top.rs"),
        quantities: &[
            parameter("mass", "kg", 0.5, [0.05, 2.0]),
            parameter("radius", "m", 0.06, [0.02, 0.12]),
            parameter("height", "m", 0.08, [-0.12, 0.12]),
            parameter("gravity", "m/s²", 9.81, [0.0, 25.0]),
            start("tilt", "°", 35.0, [0.0, 180.0]),
            start("precession", "°/s", 0.0, [-900.0, 900.0]),
            start("spin", "°/s", 7000.0, [-15_000.0, 15_000.0]),
        ],
        curves: &[
            Curve {
                name: "θ",
                unit: "°",
            },
            Curve {
                name: "φ",
                unit: "°",
            },
        ],
        seconds: 3.0,
        pace: 0.4,
        view: [0.4, 0.35],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        let disc = Solid::cylinder(values.get("radius"), 0.3 * values.get("radius"))?
            .with_mass(values.get("mass"))?;
        let body = SymmetricBody::of(&disc.moved(Vector3::z() * values.get("height")))?;
        Ok(Self {
            body,
            g: values.get("gravity"),
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 3>, Refusal> {
        let v = [values.get("precession"), 0.0, values.get("spin")];
        Ok(State::new(0.0, [0.0, values.get("tilt"), 0.0], v))
    }

    fn scene(&self, state: &State<f64, 3>) -> Scene {
        let axes = zxz(state.q[0], state.q[1], state.q[2]);
        // The radius of a cylinder with these moments: C = ½ m r².
        let radius = (2.0 * self.body.axial_moment() / self.body.mass()).sqrt();
        let height = self.body.height();
        let r = 1.35 * height.abs() + 0.7 * radius;
        let tip = Vector3::z() * (1.7 * height);
        let body = Body::rigid(self.body, axes, Vector3::zeros())
            .with(Shape::new(
                Form::Bar([0.0; 3], tip.into(), 0.08 * radius),
                Tone::Frame,
            ))
            .with(
                Shape::new(Form::Cylinder(radius, 0.15 * radius), Tone::First)
                    .at(Vector3::z() * height),
            );
        Scene::seen(plane(0.0, 0.3 * r), r)
            .on_ground(-0.14 * r)
            .fixture(
                Shape::new(Form::Cylinder(0.06 * r, 0.06 * r), Tone::Fixed)
                    .at(plane(0.0, -0.06 * r)),
            )
            .body(body)
            .trace(axes * tip)
    }

    fn curves(&self, state: &State<f64, 3>) -> Vec<f64> {
        vec![state.q[1], state.q[0]]
    }
}
