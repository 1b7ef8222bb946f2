use lagrangian_models::Bicycle;

use super::prelude::*;

impl Shown<8> for Bicycle {
    const ABOUT: About = About {
        slug: "bicycle",
        title: "Bicycle",
        sentence: "Between 4.3 and 6.0 m/s Whipple's bicycle stays upright after a push, without a rider's control.",
        source: include_str!("../../../../models/src/bicycle.rs"),
        quantities: &[
            parameter("rear wheel", "kg", 2.0, [0.5, 10.0]),
            parameter("front wheel", "kg", 3.0, [0.5, 10.0]),
            parameter("trail", "m", 0.08, [-0.05, 0.2]),
            parameter("gravity", "m/s²", 9.81, [1.0, 25.0]),
            start("speed", "m/s", 4.6, [0.5, 10.0]),
            start("lean rate", "°/s", 30.0, [-60.0, 60.0]),
            control("torque at the handlebar", "N m", 0.0, [-3.0, 3.0]),
        ],
        curves: &[
            Curve {
                name: "lean",
                unit: "°",
            },
            Curve {
                name: "steer",
                unit: "°",
            },
        ],
        seconds: 5.0,
        pace: 1.0,
        view: [0.6, 0.2],
    };
    const EQUATIONS_IN_LATEX: &'static str = Self::LATEX;
    const PERIOD: f64 = 0.05;
    const IS_DRIVEN: bool = true;

    fn with_values(values: &Values) -> Result<Self, Refusal> {
        let model = Self::benchmark()?;
        Ok(Self {
            rear_mass: mass(values, "rear wheel")?,
            front_mass: mass(values, "front wheel")?,
            trail: values.get("trail"),
            g: values.get("gravity"),
            ..model
        })
    }

    fn start(&self, values: &Values) -> Result<State<f64, 8>, Refusal> {
        let mut state = self.straight(values.get("speed"));
        state.v[Self::LEAN] = values.get("lean rate");
        Ok(self
            .assemble(state)
            .hold_velocities([Self::LEAN, Self::REAR])
            .solve()?
            .state)
    }

    fn law(&self, _: &Values) -> Result<Law<Self, 8>, Refusal> {
        Ok(Box::new(|model, values, _| {
            model.steer_torque = values.get("torque at the handlebar");
        }))
    }

    /// In axes that are turned by half a turn about x: z of the model points down.
    fn scene(&self, state: &State<f64, 8>) -> Scene {
        let q = &state.q;
        let up = about_x(std::f64::consts::PI);
        let upright = about_z(q[Self::YAW]) * about_x(q[Self::LEAN]);
        let rear = upright * about_y(q[Self::PITCH]);
        let front = rear * about_y(self.tilt) * about_z(q[Self::STEER]) * about_y(-self.tilt);
        let hub =
            Vector3::new(q[Self::X], q[Self::Y], 0.0) - upright * Vector3::z() * self.rear_radius;
        let crossing =
            hub + rear * Vector3::new(self.wheelbase + self.trail, 0.0, self.rear_radius);
        let front_hub = crossing + front * Vector3::new(-self.trail, 0.0, -self.front_radius);
        let wheel = |mass: f64,
                     [across, axial]: [f64; 2],
                     axes: Matrix3<f64>,
                     hub: Vector3<f64>,
                     radius: f64| {
            let lying = about_x(std::f64::consts::FRAC_PI_2);
            let mut body = Body::central(mass, [across, axial, across], up * axes, up * hub)
                .with(Shape::new(Form::Ring(radius - 0.02, 0.04), Tone::Frame).turned(lying));
            for spoke in 0..8 {
                let (s, c) = (std::f64::consts::FRAC_PI_4 * f64::from(spoke)).sin_cos();
                let end = [(radius - 0.02) * c, 0.0, (radius - 0.02) * s];
                let tone = if spoke == 0 {
                    Tone::Second
                } else {
                    Tone::Fixed
                };
                body = body.with(Shape::new(Form::Bar([0.0; 3], end, 0.012), tone));
            }
            body
        };
        let bar = |a: [f64; 3], b: [f64; 3], tone| Shape::new(Form::Bar(a, b, 0.045), tone);
        // The head of the steering, in the axes of the rear frame about the hub and in those of the front frame about the crossing.
        let (s, c) = self.tilt.sin_cos();
        let along = |length: f64| [-length * s, 0.0, -length * c];
        let head = along(0.85);
        let of_rear = [
            self.wheelbase + self.trail + head[0],
            0.0,
            self.rear_radius + head[2],
        ];
        let crank = [0.42, 0.0, 0.05];
        let saddle = [0.22, 0.0, -0.6];
        let rear_frame = Body::rigid(self.rear_frame, up * rear, up * hub)
            .with(bar([0.0; 3], crank, Tone::First))
            .with(bar(crank, of_rear, Tone::First))
            .with(bar(crank, saddle, Tone::First))
            .with(bar([0.0; 3], saddle, Tone::First))
            .with(bar([0.27, 0.0, -0.42], of_rear, Tone::First))
            .with(
                Shape::new(Form::Cuboid([0.13, 0.06, 0.025]), Tone::Third)
                    .at(Vector3::from(saddle)),
            );
        let fork = [-self.trail, 0.0, -self.front_radius];
        let top = along(1.05);
        let front_frame = Body::rigid(self.front_frame, up * front, up * crossing)
            .with(bar(fork, along(0.62), Tone::Second))
            .with(bar(along(0.62), top, Tone::Second))
            .with(bar(
                [top[0], -0.27, top[2]],
                [top[0], 0.27, top[2]],
                Tone::Second,
            ));
        let middle = 0.5 * (hub + front_hub);
        let rear_wheel = wheel(
            self.rear_mass,
            [self.rear_across, self.rear_axial],
            rear * about_y(q[Self::REAR]),
            hub,
            self.rear_radius,
        );
        let front_wheel = wheel(
            self.front_mass,
            [self.front_across, self.front_axial],
            front * about_y(q[Self::FRONT]),
            front_hub,
            self.front_radius,
        );
        Scene::seen(up * Vector3::new(middle.x, middle.y, -0.5), 1.05)
            .on_ground(0.0)
            .body(rear_wheel)
            .body(front_wheel)
            .body(rear_frame)
            .body(front_frame)
            .trace(up * Vector3::new(q[Self::X], q[Self::Y], 0.0))
    }

    fn curves(&self, state: &State<f64, 8>) -> Vec<f64> {
        vec![state.q[Self::LEAN], state.q[Self::STEER]]
    }
}
