use lagrangian_models::GantryCrane;

use super::prelude::*;

impl Shown<3> for GantryCrane {
    const ABOUT: About = About {
        slug: "gantry-crane",
        title: "Gantry crane",
        sentence: "A regulator brings a load on a rope to its goal and lets it come to rest there.",
        source: include_str!("../../../../models/src/gantry_crane.rs"),
        quantities: &[
            parameter("trolley", "kg", 500.0, [50.0, 2000.0]),
            parameter("load", "kg", 200.0, [20.0, 2000.0]),
            parameter("gravity", "m/s²", 9.81, [0.5, 25.0]),
            start("position", "m", -4.0, [-6.0, 6.0]),
            start("rope", "m", 7.0, [1.0, 9.0]),
            start("swing", "°", 0.0, [-60.0, 60.0]),
            control("goal", "m", 4.0, [-6.0, 6.0]),
            control("rope's goal", "m", 5.0, [1.0, 9.0]),
        ],
        curves: &[
            Curve {
                name: "x",
                unit: "m",
            },
            Curve {
                name: "l",
                unit: "m",
            },
            Curve {
                name: "θ",
                unit: "°",
            },
        ],
        seconds: 15.0,
        pace: 2.0,
        view: [0.3, 0.2],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;
    const PERIOD: f64 = 0.02;
    const IS_DRIVEN: bool = true;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        let (load, g) = (mass(values, "load")?, values.get("gravity"));
        Ok(Self {
            trolley: mass(values, "trolley")?,
            load,
            g,
            drive: 0.0,
            winch: -load * g,
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 3>, Refusal> {
        Ok(State::new(
            0.0,
            [
                values.get("position"),
                values.get("rope"),
                values.get("swing"),
            ],
            [0.0; 3],
        ))
    }

    fn law(&self, values: &Values) -> Result<Law<Self, 3>, Refusal> {
        let rest = State::new(0.0, [0.0, values.get("rope's goal"), 0.0], [0.0; 3]);
        let plant = StateSpace::<f64, 6, 2, 6>::of(self, &rest);
        let weights = SMatrix::from_diagonal(&SVector::from([1.0, 1.0, 20.0, 1.0, 1.0, 20.0]));
        let force = 1.0 / (self.trolley * self.trolley);
        let regulator = plant.regulator(
            &weights,
            &SMatrix::from_diagonal(&SVector::from([8.0 * force, 8.0 * force])),
        )?;
        let rope = rest.q[1];
        Ok(Box::new(move |model, values, state| {
            let mut error = *state;
            error.q[0] -= values.get("goal");
            error.q[1] -= values.get("rope's goal") - rope;
            let inputs = regulator.input(&error);
            (model.drive, model.winch) = (inputs[0], inputs[1]);
        }))
    }

    fn scene(&self, state: &State<f64, 3>) -> Scene {
        let p = self.outputs(state).position;
        let (trolley, load) = (plane(state.q[0], 0.0), plane(p.x, p.y));
        let beam = |a: [f64; 3], b: [f64; 3]| Shape::new(Form::Bar(a, b, 0.16), Tone::Fixed);
        let top = 0.35;
        let mut scene = Scene::seen(plane(0.0, -4.2), 7.6).on_ground(-10.0);
        for x in [-7.5, 7.5] {
            scene = scene.fixture(beam([x, 0.0, -10.0], [x, 0.0, top]));
        }
        scene
            .fixture(beam([-7.5, 0.0, top], [7.5, 0.0, top]))
            .body(
                Body::central(self.trolley, [0.0; 3], Matrix3::identity(), trolley)
                    .with(Shape::new(Form::Cuboid([0.6, 0.4, 0.22]), Tone::First)),
            )
            .line(trolley, load, 0.06, Tone::Frame)
            .body(
                Body::central(self.load, [0.0; 3], Matrix3::identity(), load)
                    .with(Shape::new(Form::Cuboid([0.5, 0.5, 0.4]), Tone::Second)),
            )
            .trace(load)
    }

    fn curves(&self, state: &State<f64, 3>) -> Vec<f64> {
        vec![state.q[0], state.q[1], state.q[2]]
    }
}
