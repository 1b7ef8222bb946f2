use lagrangian_models::Acrobot;

use super::prelude::*;

/// Where the motor moves the second link while it swings up: α of Spong (1995), in rad.
const LEAN: f64 = 1.0;

impl Shown<2> for Acrobot {
    const ABOUT: About = About {
        slug: "acrobot",
        title: "Acrobot",
        sentence: "A gymnast with one motor at the waist swings up, the second link following the rate of the first.",
        source: include_str!("../../../../models/src/acrobot.rs"),
        quantities: &[
            parameter("first mass", "kg", 1.0, [0.1, 5.0]),
            parameter("second mass", "kg", 1.0, [0.1, 5.0]),
            parameter("first length", "m", 0.5, [0.1, 1.0]),
            parameter("second length", "m", 0.6, [0.1, 1.0]),
            parameter("gravity", "m/s²", 9.81, [0.0, 25.0]),
            start("first angle", "°", 70.0, [-180.0, 180.0]),
            start("second angle", "°", 0.0, [-180.0, 180.0]),
            control("swing up", SWITCH, 1.0, [0.0, 1.0]),
            control("largest torque", "N m", 6.0, [0.0, 20.0]),
        ],
        curves: &[
            Curve {
                name: "θ₁",
                unit: "°",
            },
            Curve {
                name: "θ₂",
                unit: "°",
            },
            Curve {
                name: "torque",
                unit: "N m",
            },
        ],
        seconds: 10.0,
        pace: 1.0,
        view: [0.25, 0.15],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;
    const PERIOD: f64 = 0.01;
    const IS_DRIVEN: bool = true;

    /// Both links are uniform rods.
    fn with_values(values: &Values) -> Result<Self, Refusal> {
        let [m1, m2] = [mass(values, "first mass")?, mass(values, "second mass")?];
        let [l1, l2] = ["first length", "second length"].map(|name| values.get(name));
        Ok(Self {
            m1,
            m2,
            l1,
            c1: 0.5 * l1,
            c2: 0.5 * l2,
            i1: m1 * l1 * l1 / 12.0,
            i2: m2 * l2 * l2 / 12.0,
            g: values.get("gravity"),
            torque: 0.0,
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 2>, Refusal> {
        Ok(State::new(
            0.0,
            [values.get("first angle"), values.get("second angle")],
            [0.0; 2],
        ))
    }

    /// The second link is moved to an angle that follows the rate of the first one (Spong 1995, equations 22 to 26).
    fn law(&self, _: &Values) -> Result<Law<Self, 2>, Refusal> {
        Ok(Box::new(|model, values, state| {
            model.torque = 0.0;
            if values.is_on("swing up") {
                let goal = LEAN * std::f64::consts::FRAC_2_PI * state.v[0].atan();
                let wanted = 100.0 * (goal - state.q[1]) - 20.0 * state.v[1];
                // The acceleration of the first link, on which no motor acts.
                let free = model.inverse_dynamics(state, &Vector2::new(0.0, wanted))[0];
                let first = -free / model.mass_matrix(state)[(0, 0)];
                let torque = model.inverse_dynamics(state, &Vector2::new(first, wanted))[1];
                let largest = values.get("largest torque").abs();
                model.torque = if torque.abs() <= largest {
                    torque
                } else {
                    torque.signum() * largest
                };
            }
        }))
    }

    fn scene(&self, state: &State<f64, 2>) -> Scene {
        let elbow = self.outputs(state).elbow;
        let (elbow, r) = (plane(elbow.x, elbow.y), self.l1.abs() + 2.0 * self.c2.abs());
        let link = |length: f64, tone| {
            Shape::new(Form::Bar([0.0; 3], [0.0, 0.0, -length], 0.06 * r), tone)
        };
        let body = |mass: f64, center: f64, inertia: f64, angle: f64, origin: Vector3<f64>| Body {
            center: Vector3::new(0.0, 0.0, -center),
            ..Body::central(mass, [0.0, inertia, 0.0], about_y(-angle), origin)
        };
        let motor = Shape::new(Form::Cylinder(0.05 * r, 0.04 * r), Tone::Third)
            .turned(about_x(std::f64::consts::FRAC_PI_2));
        let second = body(self.m2, self.c2, self.i2, state.q[0] + state.q[1], elbow)
            .with(link(2.0 * self.c2, Tone::Second));
        let end = second.origin + second.axes * Vector3::new(0.0, 0.0, -2.0 * self.c2);
        Scene::seen(plane(0.0, 0.0), 1.02 * r)
            .fixture(Shape::new(
                Form::Bar([0.0, -0.3 * r, 0.0], [0.0, 0.3 * r, 0.0], 0.03 * r),
                Tone::Fixed,
            ))
            .body(
                body(self.m1, self.c1, self.i1, state.q[0], Vector3::zeros())
                    .with(link(self.l1, Tone::First)),
            )
            .body(second.with(motor))
            .trace(end)
    }

    fn curves(&self, state: &State<f64, 2>) -> Vec<f64> {
        vec![state.q[0], state.q[1], self.torque]
    }
}
