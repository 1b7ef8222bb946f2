use lagrangian::rigid_body::Solid;
use lagrangian_models::GeneralTop;

use super::prelude::*;

impl Shown<3> for GeneralTop {
    const ABOUT: About = About {
        slug: "general-top",
        title: "General top",
        sentence: "A brick turns about one of its corners under its weight: no symmetry makes its motion regular.",
        source: include_str!("../../../../models/src/general_top.rs"),
        quantities: &[
            parameter("mass", "kg", 2.0, [0.1, 10.0]),
            parameter("depth", "m", 0.1, [0.02, 0.4]),
            parameter("width", "m", 0.2, [0.02, 0.4]),
            parameter("height", "m", 0.3, [0.02, 0.4]),
            parameter("gravity", "m/s²", 9.81, [0.0, 25.0]),
            start("tilt", "°", 80.0, [0.0, 180.0]),
            start("precession", "°/s", 30.0, [-900.0, 900.0]),
            start("spin", "°/s", 500.0, [-2000.0, 2000.0]),
        ],
        curves: &[
            Curve {
                name: "θ",
                unit: "°",
            },
            Curve {
                name: "ψ̇",
                unit: "°/s",
            },
        ],
        seconds: 6.0,
        pace: 0.7,
        view: [0.5, 0.3],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        let sides = ["depth", "width", "height"].map(|name| values.get(name));
        let brick = Solid::cuboid(sides[0], sides[1], sides[2])?.with_mass(values.get("mass"))?;
        Ok(Self {
            body: brick.moved(0.5 * Vector3::from(sides)),
            g: values.get("gravity"),
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 3>, Refusal> {
        let v = [values.get("precession"), 0.0, values.get("spin")];
        Ok(State::new(0.0, [0.0, values.get("tilt"), 0.3], v))
    }

    fn scene(&self, state: &State<f64, 3>) -> Scene {
        let axes = zxz(state.q[0], state.q[1], state.q[2]);
        let center = self.body.center();
        let r = 2.0 * center.norm();
        let shape = Shape::new(Form::Cuboid(center.into()), Tone::First).at(center);
        let marks = [0, 1, 2].map(|axis| {
            let mut end = [0.0; 3];
            end[axis] = 2.0 * center[axis];
            Shape::new(Form::Bar([0.0; 3], end, 0.012 * r), Tone::Second)
        });
        let body = Body::rigid(self.body, axes, Vector3::zeros()).with(shape);
        Scene::seen(plane(0.0, -0.1 * r), 1.1 * r)
            .fixture(support(Vector3::zeros(), 0.6 * r))
            .body(marks.into_iter().fold(body, Body::with))
            .trace(axes * (2.0 * center))
    }

    fn curves(&self, state: &State<f64, 3>) -> Vec<f64> {
        vec![state.q[1], state.v[2]]
    }
}
