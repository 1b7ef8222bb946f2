use lagrangian::rigid_body::Solid;
use lagrangian_models::Arm;

use super::prelude::*;

impl Shown<3> for Arm {
    const ABOUT: About = About {
        slug: "arm",
        title: "Arm of three joints",
        sentence: "Motors carry the weight of an arm and bring its joints to the angles of three sliders.",
        source: include_str!("../../../../models/src/arm.rs"),
        quantities: &[
            parameter("column", "kg", 20.0, [1.0, 50.0]),
            parameter("upper link", "kg", 3.0, [0.5, 10.0]),
            parameter("lower link", "kg", 2.0, [0.5, 10.0]),
            parameter("load", "kg", 1.0, [0.01, 10.0]),
            parameter("length", "m", 0.6, [0.2, 1.0]),
            parameter("gravity", "m/s²", 9.81, [0.0, 25.0]),
            control("motors", SWITCH, 1.0, [0.0, 1.0]),
            control("turn", "°", 100.0, [-180.0, 180.0]),
            control("shoulder", "°", -50.0, [-90.0, 90.0]),
            control("elbow", "°", 70.0, [-150.0, 150.0]),
        ],
        curves: &[
            Curve {
                name: "q₀",
                unit: "°",
            },
            Curve {
                name: "q₁",
                unit: "°",
            },
            Curve {
                name: "q₂",
                unit: "°",
            },
        ],
        seconds: 5.0,
        pace: 1.0,
        view: [0.7, 0.35],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;
    const PERIOD: f64 = 0.01;
    const IS_DRIVEN: bool = true;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        let length = values.get("length");
        let along_x =
            nalgebra::Rotation3::from_matrix_unchecked(about_y(std::f64::consts::FRAC_PI_2));
        let link = |name: &str| -> Result<RigidBody, Refusal> {
            let tube =
                Solid::tube(0.04 * length, 0.06 * length, length)?.with_mass(values.get(name))?;
            Ok(tube.turned(&along_x).moved(Vector3::x() * (0.5 * length)))
        };
        let load = RigidBody::particle(values.get("load"), Vector3::x() * length)?;
        let column =
            Solid::cylinder(0.12 * length, 0.8 * length)?.with_mass(values.get("column"))?;
        Ok(Self {
            column: SymmetricBody::of(&column.moved(Vector3::z() * (0.4 * length)))?,
            upper: link("upper link")?,
            lower: link("lower link")?.plus(&load),
            height: 0.8 * length,
            length,
            g: values.get("gravity"),
            torque: Vector3::zeros(),
        })
    }

    fn start(&self, _: &Values) -> Result<State<f64, 3>, Refusal> {
        Ok(State::new(0.0, [0.0, 0.3, 0.3], [0.0; 3]))
    }

    /// Computed torque: what the model needs for the acceleration of a damped oscillator about the goal.
    fn law(&self, _: &Values) -> Result<Law<Self, 3>, Refusal> {
        Ok(Box::new(|model, values, state| {
            model.torque = Vector3::zeros();
            if values.is_on("motors") {
                let goal =
                    Vector3::from(["turn", "shoulder", "elbow"].map(|name| values.get(name)));
                let wanted = 9.0 * (goal - state.q) - 6.0 * state.v;
                model.torque = model.inverse_dynamics(state, &wanted);
            }
        }))
    }

    fn scene(&self, state: &State<f64, 3>) -> Scene {
        let turned = about_z(state.q[0]);
        let raised = turned * about_y(state.q[1]);
        let bent = raised * about_y(state.q[2]);
        let (shoulder, l) = (Vector3::z() * self.height, self.length);
        let elbow = self.outputs(state).elbow;
        let link = |tone| Shape::new(Form::Bar([0.0; 3], [l, 0.0, 0.0], 0.12 * l), tone);
        let joint = |r: f64| {
            Shape::new(Form::Cylinder(r, r), Tone::Third)
                .turned(about_x(std::f64::consts::FRAC_PI_2))
        };
        let column = Shape::new(Form::Cylinder(0.12 * l, 0.37 * l), Tone::Fixed)
            .at(Vector3::z() * (0.37 * l));
        let hand = elbow + bent * Vector3::x() * l;
        let lower = Body::rigid(self.lower, bent, elbow)
            .with(link(Tone::Second))
            .with(joint(0.09 * l))
            .with(Shape::new(Form::Ball(0.1 * l), Tone::Trail).at(Vector3::x() * l));
        Scene::seen(shoulder + plane(0.0, 0.1 * l), 1.9 * l)
            .on_ground(0.0)
            .body(Body::rigid(self.column, turned, Vector3::zeros()).with(column))
            .body(
                Body::rigid(self.upper, raised, shoulder)
                    .with(link(Tone::First))
                    .with(joint(0.12 * l)),
            )
            .body(lower)
            .trace(hand)
    }

    fn curves(&self, state: &State<f64, 3>) -> Vec<f64> {
        state.q.iter().copied().collect()
    }
}
