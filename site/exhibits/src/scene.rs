//! The drawing of a model at a state: bodies where the model says that they are, and what holds them.

use lagrangian::prelude::*;

/// What a colour stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// The main body.
    First,
    /// The second body.
    Second,
    /// A third kind of bodies, and marks on bodies.
    Third,
    /// Rods, ropes and frames.
    Frame,
    /// What does not move.
    Fixed,
    /// The grid on the ground.
    Ground,
    /// The path of a point.
    Trail,
}

/// The form of a shape about its own centre.
#[derive(Clone, Copy, Debug)]
pub enum Form {
    /// A sphere of this radius, drawn as a disc with a highlight.
    Ball(f64),
    /// A cuboid with these half edges.
    Cuboid([f64; 3]),
    /// An ellipsoid with these semi-axes.
    Ellipsoid([f64; 3]),
    /// A cylinder about the z axis: its radius and half its height.
    Cylinder(f64, f64),
    /// A ring about the z axis: its radius and the thickness of its wire.
    Ring(f64, f64),
    /// A bar from a point to another one, and its thickness.
    Bar([f64; 3], [f64; 3], f64),
}

/// A form in the axes of a body.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// Its form.
    pub form: Form,
    /// Its colour.
    pub tone: Tone,
    /// Where its centre is.
    pub center: Vector3<f64>,
    /// How it is turned.
    pub turn: Matrix3<f64>,
}

impl Shape {
    /// A shape about the origin of its body.
    #[must_use]
    pub fn new(form: Form, tone: Tone) -> Self {
        Self {
            form,
            tone,
            center: Vector3::zeros(),
            turn: Matrix3::identity(),
        }
    }

    /// The shape with its centre elsewhere.
    #[must_use]
    pub fn at(self, center: Vector3<f64>) -> Self {
        Self { center, ..self }
    }

    /// The shape turned about its centre.
    #[must_use]
    pub fn turned(self, turn: Matrix3<f64>) -> Self {
        Self { turn, ..self }
    }
}

/// A body with its inertia, as the drawing places it.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its mass.
    pub mass: f64,
    /// Its centre of gravity in its axes.
    pub center: Vector3<f64>,
    /// Its inertia about the centre of gravity along its axes.
    pub inertia: Matrix3<f64>,
    /// The origin of its axes.
    pub origin: Vector3<f64>,
    /// Its axes.
    pub axes: Matrix3<f64>,
    /// What is drawn of it.
    pub shapes: Vec<Shape>,
}

impl Body {
    /// A rigid body at an origin, along these axes.
    pub(crate) fn rigid(
        body: impl Into<RigidBody>,
        axes: Matrix3<f64>,
        origin: Vector3<f64>,
    ) -> Self {
        let body = body.into();
        Self {
            mass: body.mass(),
            center: body.center(),
            inertia: body.inertia().matrix(),
            origin,
            axes,
            shapes: Vec::new(),
        }
    }

    /// A particle, drawn as a ball of this radius.
    pub(crate) fn particle(mass: f64, origin: Vector3<f64>, radius: f64, tone: Tone) -> Self {
        Self {
            mass,
            center: Vector3::zeros(),
            inertia: Matrix3::zeros(),
            origin,
            axes: Matrix3::identity(),
            shapes: vec![Shape::new(Form::Ball(radius), tone)],
        }
    }

    /// A body with its centre of gravity in its origin.
    pub(crate) fn central(
        mass: f64,
        moments: [f64; 3],
        axes: Matrix3<f64>,
        origin: Vector3<f64>,
    ) -> Self {
        Self {
            mass,
            center: Vector3::zeros(),
            inertia: Matrix3::from_diagonal(&moments.into()),
            origin,
            axes,
            shapes: Vec::new(),
        }
    }

    /// The body with another shape.
    pub(crate) fn with(mut self, shape: Shape) -> Self {
        self.shapes.push(shape);
        self
    }

    /// Where the centre of gravity is.
    #[must_use]
    pub fn center_of_gravity(&self) -> Vector3<f64> {
        self.origin + self.axes * self.center
    }
}

/// A straight line in space.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// Its ends.
    pub ends: [Vector3<f64>; 2],
    /// Its thickness as a length.
    pub width: f64,
    /// Its colour.
    pub tone: Tone,
}

/// A drawing in space; z points up.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// The bodies of the model: all masses that move.
    pub bodies: Vec<Body>,
    /// What joins them, without a mass.
    pub lines: Vec<Line>,
    /// What stands still.
    pub fixtures: Vec<Shape>,
    /// The points whose paths are drawn.
    pub traced: Vec<Vector3<f64>>,
    /// The middle of the view.
    pub focus: Vector3<f64>,
    /// The radius around it that is seen.
    pub radius: f64,
    /// The height of the ground, if it is drawn.
    pub ground: Option<f64>,
    /// The angular velocity of the axes in which all this is drawn.
    pub turning: Vector3<f64>,
}

impl Scene {
    /// A scene with this view.
    pub(crate) fn seen(focus: Vector3<f64>, radius: f64) -> Self {
        Self {
            focus,
            radius,
            ..Self::default()
        }
    }

    /// The scene with a ground at this height.
    pub(crate) fn on_ground(self, height: f64) -> Self {
        Self {
            ground: Some(height),
            ..self
        }
    }

    pub(crate) fn body(mut self, body: Body) -> Self {
        self.bodies.push(body);
        self
    }

    /// The scene with another line.
    pub(crate) fn line(mut self, a: Vector3<f64>, b: Vector3<f64>, width: f64, tone: Tone) -> Self {
        self.lines.push(Line {
            ends: [a, b],
            width,
            tone,
        });
        self
    }

    pub(crate) fn fixture(mut self, shape: Shape) -> Self {
        self.fixtures.push(shape);
        self
    }

    pub(crate) fn trace(mut self, point: Vector3<f64>) -> Self {
        self.traced.push(point);
        self
    }
}

/// The rotation by an angle about an axis, from the axes of a body to those of space.
pub(crate) fn about_x(angle: f64) -> Matrix3<f64> {
    let (s, c) = angle.sin_cos();
    Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c)
}

/// See [`about_x`].
pub(crate) fn about_y(angle: f64) -> Matrix3<f64> {
    let (s, c) = angle.sin_cos();
    Matrix3::new(c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c)
}

/// See [`about_x`].
pub(crate) fn about_z(angle: f64) -> Matrix3<f64> {
    let (s, c) = angle.sin_cos();
    Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0)
}

/// A point of the plane in which x points to the right and y upwards.
pub(crate) fn plane(x: f64, y: f64) -> Vector3<f64> {
    Vector3::new(x, 0.0, y)
}
