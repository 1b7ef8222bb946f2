use lagrangian_models::CartWithTwoPoles;

use super::prelude::*;

impl Shown<3> for CartWithTwoPoles {
    const ABOUT: About = About {
        slug: "cart-with-two-poles",
        title: "Cart with two poles",
        sentence: "One force balances two poles beside each other, as long as they differ in length.",
        source: include_str!("../../../../models/src/cart_with_two_poles.rs"),
        quantities: &[
            parameter("cart", "kg", 1.0, [0.1, 5.0]),
            parameter("first pole", "kg", 0.1, [0.01, 1.0]),
            parameter("second pole", "kg", 0.05, [0.01, 1.0]),
            parameter("first length", "m", 1.0, [0.2, 1.5]),
            parameter("second length", "m", 0.4, [0.1, 1.5]),
            parameter("gravity", "m/s²", 9.81, [0.0, 25.0]),
            start("first angle", "°", 5.0, [-20.0, 20.0]),
            start("second angle", "°", 0.0, [-20.0, 20.0]),
            control("regulator", SWITCH, 1.0, [0.0, 1.0]),
            control("goal", "m", 0.0, [-1.5, 1.5]),
        ],
        curves: &[
            Curve {
                name: "x",
                unit: "m",
            },
            Curve {
                name: "θ₁",
                unit: "°",
            },
            Curve {
                name: "θ₂",
                unit: "°",
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
        Ok(Self {
            cart: mass(values, "cart")?,
            m1: mass(values, "first pole")?,
            m2: mass(values, "second pole")?,
            l1: values.get("first length"),
            l2: values.get("second length"),
            g: values.get("gravity"),
            push: 0.0,
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 3>, Refusal> {
        Ok(State::new(
            0.0,
            [0.0, values.get("first angle"), values.get("second angle")],
            [0.0; 3],
        ))
    }

    fn law(&self, _: &Values) -> Result<Law<Self, 3>, Refusal> {
        let plant = StateSpace::<f64, 6, 1, 6>::of(self, &State::new(0.0, [0.0; 3], [0.0; 3]));
        let weights = SMatrix::from_diagonal(&SVector::from([1.0, 4.0, 4.0, 1.0, 1.0, 1.0]));
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

    fn scene(&self, state: &State<f64, 3>) -> Scene {
        let size = self.l1.abs().max(self.l2.abs());
        let pole = |mass: f64, length: f64, angle: f64, y: f64, tone: Tone| {
            let across = mass * length * length / 12.0;
            let axes = about_y(angle);
            let origin = plane(state.q[0], 0.0) + axes * Vector3::z() * (0.5 * length);
            // Beside the plane of the motion, so that one pole passes the other.
            let ends = [-0.5, 0.5].map(|share| [0.0, y, share * length]);
            let shape = Shape::new(Form::Bar(ends[0], ends[1], 0.04 * size), tone);
            Body::central(mass, [across, across, 0.0], axes, origin).with(shape)
        };
        let (far, near) = (0.07 * size, -0.07 * size);
        track(self.cart, state.q[0], size)
            .body(pole(self.m1, self.l1, state.q[1], far, Tone::Second))
            .body(pole(self.m2, self.l2, state.q[2], near, Tone::Third))
    }

    fn curves(&self, state: &State<f64, 3>) -> Vec<f64> {
        vec![state.q[0], state.q[1], state.q[2]]
    }
}
