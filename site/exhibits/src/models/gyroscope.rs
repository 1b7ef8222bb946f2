use lagrangian::rigid_body::Solid;
use lagrangian_models::Gyroscope;

use super::prelude::*;

/// The radii of the rings and of the rotor in m, and the thickness of the rings.
const RINGS: [f64; 2] = [0.085, 0.07];
const THICKNESS: f64 = 0.004;
const ROTOR: [f64; 2] = [0.05, 0.012];
/// Where the weight is on the axis, in m.
const WEIGHT: f64 = 0.07;

impl Shown<3> for Gyroscope {
    const ABOUT: About = About {
        slug: "gyroscope",
        title: "Gyroscope in gimbals",
        sentence: "A rotor spins in two gimbals; a weight on the inner one makes it precess instead of fall.",
        source: include_str!("../../../../models/src/gyroscope.rs"),
        quantities: &[
            parameter("rotor", "kg", 0.6, [0.05, 2.0]),
            parameter("ring", "kg", 0.06, [0.01, 0.3]),
            parameter("weight", "kg", 0.05, [0.001, 0.3]),
            parameter("gravity", "m/s²", 9.81, [0.0, 25.0]),
            start("tilt", "°", 70.0, [0.0, 180.0]),
            start("spin", "°/s", 7000.0, [-15_000.0, 15_000.0]),
        ],
        curves: &[
            Curve {
                name: "θ",
                unit: "°",
            },
            Curve {
                name: "φ",
                unit: "°",
            },
        ],
        seconds: 5.0,
        pace: 0.7,
        view: [0.6, 0.3],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        // Both rings stand in the plane of x and z.
        let upright =
            nalgebra::Rotation3::from_matrix_unchecked(about_x(core::f64::consts::FRAC_PI_2));
        let ring = |radius: f64| -> Result<RigidBody, Refusal> {
            let ring = Solid::torus(radius, 0.5 * THICKNESS)?.with_mass(values.get("ring"))?;
            Ok(ring.turned(&upright))
        };
        let weight = RigidBody::particle(values.get("weight"), Vector3::z() * WEIGHT)?;
        let rotor = Solid::cylinder(ROTOR[0], ROTOR[1])?.with_mass(values.get("rotor"))?;
        Ok(Self {
            outer: ring(RINGS[0])?,
            inner: ring(RINGS[1])?.plus(&weight),
            rotor: SymmetricBody::of(&rotor)?,
            g: values.get("gravity"),
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 3>, Refusal> {
        Ok(State::new(
            0.0,
            [0.0, values.get("tilt"), 0.0],
            [0.0, 0.0, values.get("spin")],
        ))
    }

    fn scene(&self, state: &State<f64, 3>) -> Scene {
        let outer = about_z(state.q[0]);
        let inner = outer * about_x(state.q[1]);
        let rotor = inner * about_z(state.q[2]);
        let ring = |radius, tone| {
            Shape::new(Form::Ring(radius, THICKNESS), tone)
                .turned(about_x(core::f64::consts::FRAC_PI_2))
        };
        let bearing =
            |a: [f64; 3], b: [f64; 3]| Shape::new(Form::Bar(a, b, 0.5 * THICKNESS), Tone::Frame);
        let [large, small] = RINGS;
        let outer = Body::rigid(self.outer, outer, Vector3::zeros())
            .with(ring(large, Tone::Frame))
            .with(bearing([-large, 0.0, 0.0], [-small, 0.0, 0.0]))
            .with(bearing([small, 0.0, 0.0], [large, 0.0, 0.0]));
        let trace = inner * Vector3::z() * WEIGHT;
        let inner = Body::rigid(self.inner, inner, Vector3::zeros())
            .with(ring(small, Tone::Third))
            .with(Shape::new(Form::Ball(0.009), Tone::Second).at(Vector3::z() * WEIGHT));
        let rotor = Body::rigid(self.rotor, rotor, Vector3::zeros())
            .with(bearing([0.0, 0.0, -small], [0.0, 0.0, small]))
            .with(Shape::new(
                Form::Cylinder(ROTOR[0], 0.5 * ROTOR[1]),
                Tone::First,
            ));
        let post = |a: f64, b: f64| {
            Shape::new(Form::Bar([0.0, 0.0, a], [0.0, 0.0, b], 0.006), Tone::Fixed)
        };
        Scene::seen(plane(0.0, -0.005), 0.105)
            .on_ground(-0.11)
            .fixture(post(-0.11, -large))
            .fixture(post(large, 0.1))
            .body(outer)
            .body(inner)
            .body(rotor)
            .trace(trace)
    }

    fn curves(&self, state: &State<f64, 3>) -> Vec<f64> {
        vec![state.q[1], state.q[0]]
    }
}
