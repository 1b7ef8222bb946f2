use lagrangian_models::SlungLoad;

use super::prelude::*;

/// The length of the quadrotor's arms in m.
const REACH: f64 = 0.2;

/// The largest distance from the goal that the regulator sees, in m: it is designed for small motions.
const FARTHEST: f64 = 1.2;

impl Shown<8> for SlungLoad {
    const ABOUT: About = About {
        slug: "slung-load",
        title: "Quadrotor with a slung load",
        sentence: "A quadrotor flies a load on a cable to a goal, and its regulator damps the swing.",
        source: include_str!("../../../../models/src/slung_load.rs"),
        quantities: &[
            parameter("quadrotor", "kg", 0.8, [0.2, 3.0]),
            parameter("load", "kg", 0.3, [0.02, 2.0]),
            parameter("cable", "m", 0.9, [0.2, 2.0]),
            parameter("gravity", "m/s²", 9.81, [0.5, 25.0]),
            start("swing", "°", 20.0, [-80.0, 80.0]),
            start("swing sideways", "°", -15.0, [-80.0, 80.0]),
            control("goal along x", "m", 1.0, [-2.0, 2.0]),
            control("goal along y", "m", 0.6, [-2.0, 2.0]),
            control("goal upwards", "m", 0.3, [-1.0, 1.0]),
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
            Curve {
                name: "a",
                unit: "°",
            },
            Curve {
                name: "b",
                unit: "°",
            },
        ],
        seconds: 8.0,
        pace: 1.0,
        view: [0.5, 0.3],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;
    const PERIOD: f64 = 0.01;
    const IS_DRIVEN: bool = true;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        let m = values.get("quadrotor");
        let moments = [0.15, 0.15, 0.28].map(|share| share * m * REACH * REACH);
        Ok(Self {
            body: PrincipalBody::new(m, moments)?,
            load: mass(values, "load")?,
            l: values.get("cable"),
            g: values.get("gravity"),
            thrust: (m + values.get("load")) * values.get("gravity"),
            torque: Vector3::zeros(),
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 8>, Refusal> {
        let mut state = State::new(0.0, [0.0; 8], [0.0; 8]);
        state.q[Self::A] = values.get("swing");
        state.q[Self::B] = values.get("swing sideways");
        Ok(state)
    }

    fn law(&self, _: &Values) -> Result<Law<Self, 8>, Refusal> {
        let plant = StateSpace::<f64, 16, 4, 16>::of(self, &State::new(0.0, [0.0; 8], [0.0; 8]));
        let of_coordinates = [4.0, 4.0, 8.0, 1.0, 1.0, 1.0, 2.0, 2.0];
        let of_velocities = [1.0, 1.0, 2.0, 0.2, 0.2, 0.2, 1.0, 1.0];
        let weights = SVector::<f64, 16>::from_fn(|i, _| {
            if i < 8 {
                of_coordinates[i]
            } else {
                of_velocities[i - 8]
            }
        });
        let costs = SMatrix::from_diagonal(&SVector::from([0.2, 20.0, 20.0, 20.0]));
        let regulator = plant.regulator(&SMatrix::from_diagonal(&weights), &costs)?;
        Ok(Box::new(move |model, values, state| {
            let mut error = *state;
            for (i, name) in
                Self::P
                    .into_iter()
                    .zip(["goal along x", "goal along y", "goal upwards"])
            {
                error.q[i] = (error.q[i] - values.get(name)).clamp(-FARTHEST, FARTHEST);
            }
            let inputs = regulator.input(&error);
            model.thrust = inputs[0];
            model.torque = inputs.fixed_rows::<3>(1).into_owned();
        }))
    }

    fn scene(&self, state: &State<f64, 8>) -> Scene {
        let q = &state.q;
        let axes = about_z(q[Self::YAW]) * about_y(q[Self::PITCH]) * about_x(q[Self::ROLL]);
        let p = Vector3::from(Self::P.map(|i| q[i]));
        let end = self.outputs(state).load;
        let mut body = Body::rigid(self.body, axes, p)
            .with(Shape::new(Form::Cuboid([0.07, 0.05, 0.03]), Tone::First));
        for k in 0..4 {
            let (s, c) = (std::f64::consts::FRAC_PI_4 * f64::from(2 * k + 1)).sin_cos();
            let tip = Vector3::new(REACH * c, REACH * s, 0.0);
            let rotor = if k == 0 || k == 3 {
                Tone::Third
            } else {
                Tone::Frame
            };
            body = body
                .with(Shape::new(
                    Form::Bar([0.0; 3], tip.into(), 0.025),
                    Tone::Frame,
                ))
                .with(Shape::new(Form::Ring(0.1, 0.014), rotor).at(tip + Vector3::z() * 0.03));
        }
        let r = 0.55 + 0.45 * self.l.abs();
        Scene::seen(p - plane(0.0, 0.4 * self.l), r)
            .on_ground(-1.1 - self.l.abs())
            .line(p, end, 0.014, Tone::Frame)
            .body(body)
            .body(Body::particle(self.load, end, 0.075, Tone::Second))
            .trace(end)
    }

    fn curves(&self, state: &State<f64, 8>) -> Vec<f64> {
        vec![state.q[0], state.q[1], state.q[Self::A], state.q[Self::B]]
    }
}
