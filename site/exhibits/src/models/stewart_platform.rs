use lagrangian_models::StewartPlatform;

use super::prelude::*;

impl Shown<24> for StewartPlatform {
    const ABOUT: About = About {
        slug: "stewart-platform",
        title: "Stewart platform",
        sentence: "Six legs drive a level platform along a circle: thirteen bodies, and six loops that are closed by constraints.",
        source: include_str!("../../../../models/src/stewart_platform.rs"),
        quantities: &[
            parameter("platform", "kg", 40.0, [5.0, 200.0]),
            parameter("cylinder", "kg", 3.0, [0.5, 10.0]),
            parameter("rod", "kg", 1.5, [0.2, 10.0]),
            parameter("height", "m", 1.0, [0.6, 1.4]),
            parameter("circle", "m", 0.2, [0.0, 0.4]),
            parameter("angular frequency", "rad/s", 3.0, [0.0, 10.0]),
            parameter("gravity", "m/s²", 9.81, [0.0, 25.0]),
        ],
        curves: &[
            Curve {
                name: "force of leg 0",
                unit: "N",
            },
            Curve {
                name: "force of leg 1",
                unit: "N",
            },
        ],
        seconds: 5.0,
        pace: 1.0,
        view: [0.5, 0.35],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;
    const IS_DRIVEN: bool = true;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        let scaled = |name: &str, height: f64, [across, axial]: [f64; 2]| {
            let m = values.get(name);
            SymmetricBody::new(m, height, m * across, m * axial)
        };
        Ok(Self {
            platform: scaled("platform", 0.0, [0.05, 0.1])?,
            cylinder: [scaled("cylinder", 0.3, [0.12, 0.003])?; 6],
            rod: [scaled("rod", -0.3, [0.12, 0.002])?; 6],
            base: Self::hexagon(1.0, 0.2),
            top: Self::hexagon(0.6, std::f64::consts::FRAC_PI_3 - 0.2),
            height: values.get("height"),
            radius: values.get("circle"),
            omega: values.get("angular frequency"),
            g: values.get("gravity"),
        })
    }

    fn start(&self, _: &Values) -> Result<State<f64, 24>, Refusal> {
        Ok(self.assemble(self.guess(0.0)).solve()?.state)
    }

    /// The drives push the rods out of their cylinders.
    fn power(&self, state: &State<f64, 24>) -> f64 {
        let force = self.outputs(state).force;
        Self::S
            .iter()
            .zip(force.iter())
            .map(|(i, force)| force * state.v[*i])
            .sum()
    }

    fn scene(&self, state: &State<f64, 24>) -> Scene {
        let q = &state.q;
        let angle = |i: usize| q[i];
        let turn =
            about_z(angle(Self::YAW)) * about_y(angle(Self::PITCH)) * about_x(angle(Self::ROLL));
        let p = Vector3::from(Self::P.map(|i| q[i]));
        let mut scene = Scene::seen(plane(0.0, 0.5 * self.height), 1.25).on_ground(-0.02);
        let mut platform = Body::rigid(self.platform, turn, p);
        let hexagon = |points: &[Vector3<f64>; 6], tone| {
            let points = *points;
            (0..6).map(move |k| {
                Shape::new(
                    Form::Bar(points[k].into(), points[(k + 1) % 6].into(), 0.05),
                    tone,
                )
            })
        };
        for shape in hexagon(&self.top, Tone::Third) {
            platform = platform.with(shape);
        }
        for k in 0..6 {
            platform = platform.with(Shape::new(
                Form::Bar([0.0; 3], self.top[k].into(), 0.03),
                Tone::Third,
            ));
        }
        for shape in hexagon(&self.base, Tone::Fixed) {
            scene = scene.fixture(shape);
        }
        for k in 0..6 {
            let leg = about_y(q[Self::A[k]]) * about_x(q[Self::B[k]]);
            let end = self.base[k] + leg * Vector3::z() * q[Self::S[k]];
            let cylinder = Body::rigid(self.cylinder[k], leg, self.base[k]).with(Shape::new(
                Form::Bar([0.0; 3], [0.0, 0.0, 0.6], 0.075),
                Tone::First,
            ));
            let rod = Body::rigid(self.rod[k], leg, end).with(Shape::new(
                Form::Bar([0.0, 0.0, -0.6], [0.0; 3], 0.035),
                Tone::Second,
            ));
            scene = scene.body(cylinder).body(rod);
        }
        scene.body(platform).trace(p)
    }

    fn curves(&self, state: &State<f64, 24>) -> Vec<f64> {
        let force = self.outputs(state).force;
        vec![force[0], force[1]]
    }
}
