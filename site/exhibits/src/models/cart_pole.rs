use lagrangian::rigid_body::Solid;
use lagrangian_models::CartPole;

use super::prelude::*;

impl Shown<2> for CartPole {
    const ABOUT: About = About {
        slug: "cart-pole",
        title: "Cart with a pole",
        sentence: "A linear-quadratic regulator moves a cart so that the pole on it stands upright.",
        source: include_str!("../../../../models/src/cart_pole.rs"),
        quantities: &[
            parameter("cart", "kg", 1.0, [0.1, 5.0]),
            parameter("pole", "kg", 0.2, [0.02, 2.0]),
            parameter("length", "m", 1.0, [0.2, 2.0]),
            parameter("gravity", "m/s²", 9.81, [0.0, 25.0]),
            start("position", "m", -1.0, [-1.5, 1.5]),
            start("angle", "°", 25.0, [-180.0, 180.0]),
            control("regulator", SWITCH, 1.0, [0.0, 1.0]),
            control("goal", "m", 0.5, [-1.5, 1.5]),
        ],
        curves: &[
            Curve {
                name: "x",
                unit: "m",
            },
            Curve {
                name: "θ",
                unit: "°",
            },
            Curve {
                name: "force",
                unit: "N",
            },
        ],
        seconds: 6.0,
        pace: 1.0,
        view: [0.3, 0.2],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;
    const PERIOD: f64 = 0.01;
    const IS_DRIVEN: bool = true;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        let length = values.get("length");
        let pole = Solid::cylinder(0.02 * length, length)?.with_mass(values.get("pole"))?;
        Ok(Self {
            cart: mass(values, "cart")?,
            pole: pole.moved(Vector3::z() * (0.5 * length)),
            g: values.get("gravity"),
            push: 0.0,
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 2>, Refusal> {
        Ok(State::new(
            0.0,
            [values.get("position"), values.get("angle")],
            [0.0; 2],
        ))
    }

    fn law(&self, _: &Values) -> Result<Law<Self, 2>, Refusal> {
        let plant = StateSpace::<f64, 4, 1, 4>::of(self, &State::new(0.0, [0.0; 2], [0.0; 2]));
        let weights = SMatrix::from_diagonal(&SVector::from([4.0, 4.0, 1.0, 1.0]));
        let regulator = plant.regulator(&weights, &SMatrix::from([[0.1]]))?;
        Ok(Box::new(move |model, values, state| {
            let mut error = *state;
            error.q[0] -= values.get("goal");
            model.push = if values.is_on("regulator") {
                regulator.input(&error)[0]
            } else {
                0.0
            };
        }))
    }

    fn scene(&self, state: &State<f64, 2>) -> Scene {
        let length = 2.0 * self.pole.center().z;
        let (origin, axes) = (plane(state.q[0], 0.0), about_y(state.q[1]));
        let pole = Shape::new(
            Form::Bar([0.0; 3], [0.0, 0.0, length], 0.04 * length),
            Tone::Second,
        );
        track(self.cart, state.q[0], length)
            .body(Body::rigid(self.pole, axes, origin).with(pole))
            .trace(origin + axes * Vector3::z() * length)
    }

    fn curves(&self, state: &State<f64, 2>) -> Vec<f64> {
        vec![state.q[0], state.q[1], self.push]
    }
}
