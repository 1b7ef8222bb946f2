use lagrangian::rigid_body::InertiaTensor;
use lagrangian_models::Rattleback;

use super::prelude::*;

impl Shown<5> for Rattleback {
    const ABOUT: About = About {
        slug: "rattleback",
        title: "Rattleback",
        sentence: "Spun the wrong way, this stone begins to rattle, stops, and turns back.",
        source: include_str!("../../../../models/src/rattleback.rs"),
        quantities: &[
            parameter("mass", "kg", 1.0, [0.1, 5.0]),
            parameter("length", "m", 0.2, [0.1, 0.3]),
            parameter("width", "m", 0.03, [0.02, 0.1]),
            parameter("depth", "m", 0.02, [0.01, 0.06]),
            parameter("turn of the inertia", "°", 0.82, [-10.0, 10.0]),
            parameter("gravity", "m/s²", 9.81, [0.5, 25.0]),
            start("spin", "°/s", -290.0, [-600.0, 600.0]),
            start("pitch", "°", 0.5, [-5.0, 5.0]),
            start("roll", "°", 0.5, [-10.0, 10.0]),
        ],
        curves: &[
            Curve {
                name: "spin",
                unit: "°/s",
            },
            Curve {
                name: "pitch",
                unit: "°",
            },
            Curve {
                name: "roll",
                unit: "°",
            },
        ],
        seconds: 12.0,
        pace: 1.0,
        view: [0.5, 0.5],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;

    /// The numbers with which it opens are close to those of Kane & Levinson (1982).
    fn with_values(values: &Values) -> Result<Self, Refusal> {
        let semi = Vector3::from(["length", "width", "depth"].map(|name| values.get(name)));
        let m = values.get("mass");
        let turn =
            nalgebra::Rotation3::from_matrix_unchecked(about_z(values.get("turn of the inertia")));
        let moments = [2e-4, 1.6e-3, 1.7e-3].map(|moment| m * moment);
        let center = Vector3::new(0.0, 0.0, -0.5 * semi.z);
        let stone = RigidBody::new(m, center, InertiaTensor::principal(moments).rotated(&turn))?;
        Ok(Self {
            stone,
            semi,
            g: values.get("gravity"),
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 5>, Refusal> {
        let q = [0.0, 0.0, 0.0, values.get("pitch"), values.get("roll")];
        let guess = State::new(0.0, q, [0.0, 0.0, values.get("spin"), 0.0, 0.0]);
        Ok(self.assemble(guess).hold_velocities(2..5).solve()?.state)
    }

    fn scene(&self, state: &State<f64, 5>) -> Scene {
        let q = &state.q;
        let axes = about_z(q[Self::YAW]) * about_y(q[Self::PITCH]) * about_x(q[Self::ROLL]);
        let normal = axes.transpose() * Vector3::z();
        let origin = Vector3::new(
            q[Self::X],
            q[Self::Y],
            self.semi.component_mul(&normal).norm(),
        );
        let r = self.semi.x.abs().max(self.semi.y.abs());
        let stone = Body::rigid(self.stone, axes, origin)
            .with(Shape::new(Form::Ellipsoid(self.semi.into()), Tone::First));
        let contact = self.outputs(state).contact;
        Scene::seen(Vector3::new(origin.x, origin.y, self.semi.z), 1.25 * r)
            .on_ground(0.0)
            .body(stone)
            .trace(Vector3::new(contact.x, contact.y, 0.0))
    }

    fn curves(&self, state: &State<f64, 5>) -> Vec<f64> {
        vec![
            state.v[Self::YAW],
            state.q[Self::PITCH],
            state.q[Self::ROLL],
        ]
    }
}
