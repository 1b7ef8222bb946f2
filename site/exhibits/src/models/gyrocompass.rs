use lagrangian_models::Gyrocompass;

use super::prelude::*;

impl Shown<2> for Gyrocompass {
    const ABOUT: About = About {
        slug: "gyrocompass",
        title: "Gyrocompass",
        sentence: "The axis of a rotor that a frame keeps level swings about north, here on a globe that turns fast.",
        source: include_str!("../../../../models/src/gyrocompass.rs"),
        quantities: &[
            parameter("inertia across the axis", "kg m²", 0.04, [0.01, 0.2]),
            parameter("inertia about the axis", "kg m²", 0.06, [0.01, 0.2]),
            parameter("rate of the globe", "°/s", 1.0, [0.0, 10.0]),
            parameter("latitude", "°", 50.0, [-89.0, 89.0]),
            start("azimuth", "°", 50.0, [-180.0, 180.0]),
            start("spin", "°/s", 12_000.0, [-30_000.0, 30_000.0]),
        ],
        curves: &[Curve {
            name: "α",
            unit: "°",
        }],
        seconds: 12.0,
        pace: 1.0,
        view: [0.45, 0.75],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        let [a, c] =
            ["inertia across the axis", "inertia about the axis"].map(|name| values.get(name));
        // Only to check that the moments are those of a body.
        let rotor = SymmetricBody::new(1.0, 0.0, a, c)?;
        Ok(Self {
            a: rotor.transverse_moment(),
            c: rotor.axial_moment(),
            rate: values.get("rate of the globe"),
            latitude: values.get("latitude"),
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 2>, Refusal> {
        Ok(State::new(
            0.0,
            [values.get("azimuth"), 0.0],
            [0.0, values.get("spin")],
        ))
    }

    /// East is x, north y.
    fn scene(&self, state: &State<f64, 2>) -> Scene {
        let (s, c) = state.q[0].sin_cos();
        let frame = Matrix3::from_columns(&[
            Vector3::new(-c, -s, 0.0),
            Vector3::z(),
            Vector3::new(-s, c, 0.0),
        ]);
        let level = Shape::new(Form::Ring(1.15, 0.05), Tone::Frame);
        let rotor = Body::central(
            1.0,
            [self.a, self.a, self.c],
            frame * about_z(state.q[1]),
            Vector3::zeros(),
        )
        .with(Shape::new(
            Form::Bar([0.0, 0.0, -1.15], [0.0, 0.0, 1.6], 0.05),
            Tone::Frame,
        ))
        .with(Shape::new(Form::Cylinder(0.8, 0.12), Tone::First));
        let axis = frame * Vector3::z();
        let needle = Shape::new(Form::Ball(0.1), Tone::Second).at(1.6 * axis);
        let north = |x: f64| Form::Bar([x, 1.75, -1.0], [0.0, 2.3, -1.0], 0.06);
        let mut scene = Scene::seen(Vector3::new(0.0, 0.45, -0.3), 2.0)
            .on_ground(-1.0)
            .fixture(level)
            .fixture(needle)
            .fixture(Shape::new(
                Form::Bar([0.0, 1.2, -1.0], [0.0, 2.3, -1.0], 0.06),
                Tone::Third,
            ))
            .fixture(Shape::new(north(0.3), Tone::Third))
            .fixture(Shape::new(north(-0.3), Tone::Third))
            .body(rotor)
            .trace(1.6 * axis);
        scene.turning = self.rate * Vector3::new(0.0, self.latitude.cos(), self.latitude.sin());
        scene
    }

    fn curves(&self, state: &State<f64, 2>) -> Vec<f64> {
        vec![state.q[0]]
    }
}
