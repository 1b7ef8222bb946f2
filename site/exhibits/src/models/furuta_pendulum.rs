use lagrangian::rigid_body::Solid;
use lagrangian_models::FurutaPendulum;

use super::prelude::*;

impl Shown<2> for FurutaPendulum {
    const ABOUT: About = About {
        slug: "furuta-pendulum",
        title: "Furuta's pendulum",
        sentence: "A motor turns an arm about the vertical so that the rod at its end stands upright.",
        source: include_str!("../../../../models/src/furuta_pendulum.rs"),
        quantities: &[
            parameter("arm", "kg", 0.4, [0.05, 2.0]),
            parameter("rod", "kg", 0.2, [0.02, 1.0]),
            parameter("arm's length", "m", 0.25, [0.05, 0.5]),
            parameter("rod's length", "m", 0.5, [0.1, 1.0]),
            parameter("gravity", "m/s²", 9.81, [0.0, 25.0]),
            start("angle", "°", 160.0, [0.0, 360.0]),
            start("rate", "°/s", 0.0, [-500.0, 500.0]),
            control("regulator", SWITCH, 1.0, [0.0, 1.0]),
            control("goal", "°", 0.0, [-180.0, 180.0]),
        ],
        curves: &[
            Curve {
                name: "α",
                unit: "°",
            },
            Curve {
                name: "θ",
                unit: "°",
            },
            Curve {
                name: "torque",
                unit: "N m",
            },
        ],
        seconds: 5.0,
        pace: 1.0,
        view: [0.5, 0.3],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;
    const PERIOD: f64 = 0.01;
    const IS_DRIVEN: bool = true;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        let ([arm, rod], turn) = (
            ["arm's length", "rod's length"].map(|name| values.get(name)),
            nalgebra::Rotation3::from_matrix_unchecked(about_y(std::f64::consts::FRAC_PI_2)),
        );
        // The arm reaches as far to the other side, so that its centre of gravity is on the axis.
        let beam = Solid::cylinder(0.05 * arm, 2.0 * arm)?
            .with_mass(values.get("arm"))?
            .turned(&turn);
        let stick = Solid::cylinder(0.02 * rod, rod)?.with_mass(values.get("rod"))?;
        Ok(Self {
            arm: PrincipalBody::of(&beam),
            rod: stick.moved(Vector3::z() * (-0.5 * rod)),
            length: arm,
            g: values.get("gravity"),
            torque: 0.0,
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 2>, Refusal> {
        Ok(State::new(
            0.0,
            [0.0, values.get("angle")],
            [0.0, values.get("rate")],
        ))
    }

    fn law(&self, _: &Values) -> Result<Law<Self, 2>, Refusal> {
        let upright = State::new(0.0, [0.0, std::f64::consts::PI], [0.0; 2]);
        let plant = StateSpace::<f64, 4, 1, 4>::of(self, &upright);
        let weights = SMatrix::from_diagonal(&SVector::from([2.0, 4.0, 0.2, 0.4]));
        let regulator = plant.regulator(&weights, &SMatrix::from([[2.0]]))?;
        Ok(Box::new(move |model, values, state| {
            let mut error = *state;
            error.q[0] -= values.get("goal");
            model.torque = if values.is_on("regulator") {
                regulator.input(&error)[0]
            } else {
                0.0
            };
        }))
    }

    fn scene(&self, state: &State<f64, 2>) -> Scene {
        let turned = about_z(state.q[0]);
        let joint = turned * Vector3::x() * self.length;
        let rod = 2.0 * self.rod.center().z;
        let r = self.length.abs() + 0.75 * rod.abs();
        let beam = [[-self.length, 0.0, 0.0], [self.length, 0.0, 0.0]];
        let arm = Body::rigid(self.arm, turned, Vector3::zeros()).with(Shape::new(
            Form::Bar(beam[0], beam[1], 0.07 * r),
            Tone::First,
        ));
        let axes = turned * about_x(state.q[1]);
        let stick = Body::rigid(self.rod, axes, joint).with(Shape::new(
            Form::Bar([0.0; 3], [0.0, 0.0, rod], 0.045 * r),
            Tone::Second,
        ));
        Scene::seen(Vector3::zeros(), r)
            .on_ground(-r)
            .fixture(
                Shape::new(Form::Cylinder(0.09 * r, 0.2 * r), Tone::Fixed)
                    .at(plane(0.0, -0.25 * r)),
            )
            .fixture(Shape::new(
                Form::Bar([0.0, 0.0, -r], [0.0, 0.0, -0.45 * r], 0.06 * r),
                Tone::Fixed,
            ))
            .body(arm)
            .body(stick)
            .trace(joint + axes * Vector3::z() * rod)
    }

    fn curves(&self, state: &State<f64, 2>) -> Vec<f64> {
        vec![state.q[0], state.q[1], self.torque]
    }
}
