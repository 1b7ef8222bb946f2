//! Mechanisms with constraints of each kind, with parameters and states that differ from member to member of an ensemble.

use lagrangian::prelude::*;

/// From 0 to 1, in no order.
pub(crate) fn number(index: usize) -> f64 {
    f64::from(u32::try_from(index * 7919 % 101).unwrap_or_default()) / 101.0
}

/// A bob on a rod from the origin: x sideways, y upwards.
#[derive(Clone, Debug, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    constraint(rod = 0.5 * (x.powi(2) + y.powi(2) - l.powi(2))),
    event(
        // On both sides, and at a height that follows from x.
        side = x - 0.3 * l,
        level = y + 0.8 * l,
        // Where it turns: ẏ is zero at the lowest point, too.
        turning = dot(y),
        pull = reaction(rod) * l + 1.1 * m * g,
    ),
)]
pub(crate) struct Pendulum {
    pub(crate) m: f64,
    pub(crate) g: f64,
    pub(crate) l: f64,
}

impl Pendulum {
    /// The first three events as functions of the state.
    pub(crate) fn functions(&self) -> impl Fn(&State<f64, 2>) -> [f64; 3] + Copy + use<> {
        let l = self.l;
        move |x| [x.q[0] - 0.3 * l, x.q[1] + 0.8 * l, x.v[1]]
    }

    pub(crate) fn numbered(index: usize) -> (Self, State<f64, 2>) {
        let pendulum = Self {
            m: 0.5 + number(index),
            g: 9.0 + number(index + 1),
            l: 0.5 + number(index + 2),
        };
        let (sine, cosine) = (1.0 + 1.2 * number(index + 3)).sin_cos();
        let speed = 0.5 * number(index + 4);
        let q = [pendulum.l * sine, -pendulum.l * cosine];
        let start = State::new(0.0, q, [speed * cosine, speed * sine]);
        (pendulum, start)
    }
}

/// A slider-crank mechanism by the centres and the angles of its two rods and the place of its slider: six constraints.
#[derive(Clone, Debug, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(p: Vector2, alpha, r: Vector2, beta, x),
    define(
        half = 0.5 * a * [cos(alpha), sin(alpha)],
        arm = 0.5 * b * [cos(beta), sin(beta)],
    ),
    kinetic = 0.5 * m * (dot(p).norm_squared() + a.powi(2) / 12.0 * dot(alpha).powi(2)),
    kinetic = 0.5 * m * (dot(r).norm_squared() + b.powi(2) / 12.0 * dot(beta).powi(2)),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = m * g * (p.y + r.y) + 0.5 * k * x.powi(2),
    constraint(
        bearing = p - half,
        pin = p + half - r + arm,
        slider = r + arm - [x, 0.0],
    ),
    event(
        upright = p.x,
        middle = x - b,
        flat = r.y,
        force = reaction(slider[1]),
    ),
)]
pub(crate) struct SliderCrank {
    pub(crate) m: f64,
    pub(crate) a: f64,
    pub(crate) b: f64,
    pub(crate) g: f64,
    pub(crate) k: f64,
}

impl SliderCrank {
    /// The first three events as functions of the state.
    pub(crate) fn functions(&self) -> impl Fn(&State<f64, 7>) -> [f64; 3] + Copy + use<> {
        let b = self.b;
        move |x| [x.q[0], x.q[6] - b, x.q[4]]
    }

    pub(crate) fn numbered(index: usize) -> (Self, State<f64, 7>) {
        let model = Self {
            m: 0.5 + number(index),
            a: 0.2 + 0.5 * number(index + 1),
            b: 1.0 + 0.3 * number(index + 2),
            g: 9.0 + number(index + 3),
            k: 20.0 * number(index + 4),
        };
        let (angle, speed) = (6.0 * number(index + 5), 5.0 + 8.0 * number(index + 6));
        let start = model.turned(angle, speed);
        (model, start)
    }

    /// The state at an angle and a speed of the crank.
    pub(crate) fn turned(&self, alpha: f64, speed: f64) -> State<f64, 7> {
        let Self { a, b, .. } = *self;
        let (sine, cosine) = alpha.sin_cos();
        let beta = (-a * sine / b).asin();
        let (s, c) = beta.sin_cos();
        let turning = -a * cosine * speed / (b * c);
        let [pin, pin_rate] =
            [[cosine, sine], [-sine * speed, cosine * speed]].map(|x| x.map(|x| a * x));
        let [arm, arm_rate] = [[c, s], [-s * turning, c * turning]].map(|x| x.map(|x| 0.5 * b * x));
        let q = [
            0.5 * pin[0],
            0.5 * pin[1],
            alpha,
            pin[0] + arm[0],
            pin[1] + arm[1],
            beta,
            pin[0] + 2.0 * arm[0],
        ];
        let v = [
            0.5 * pin_rate[0],
            0.5 * pin_rate[1],
            speed,
            pin_rate[0] + arm_rate[0],
            pin_rate[1] + arm_rate[1],
            turning,
            pin_rate[0] + 2.0 * arm_rate[0],
        ];
        State::new(0.0, q, v)
    }
}

/// A disc that rolls on a plane, with its height as a coordinate: a holonomic and two nonholonomic constraints.
#[derive(Clone, Debug, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(c: Vector3, phi, theta, psi),
    define(
        r = rotation_zxz(phi, theta, psi),
        arm = radius * [-sin(phi) * cos(theta), cos(phi) * cos(theta), sin(theta)],
        w = angular_velocity(r),
        contact = dot(c) - angular_velocity_inertial(r).cross(arm),
    ),
    kinetic = 0.5 * m * (dot(c).norm_squared() + 0.25 * radius.powi(2) * (w.x.powi(2) + w.y.powi(2) + 2.0 * w.z.powi(2))),
    potential = m * g * c.z,
    constraint(ground = c.z - arm.z),
    nonholonomic(rolling = contact.rows(0, 2)),
    event(
        height = c.z - 0.97 * radius,
        falling = dot(c.z),
        axis = c.x,
        load = reaction(ground) - m * g,
    ),
)]
pub(crate) struct Disc {
    pub(crate) m: f64,
    pub(crate) radius: f64,
    pub(crate) g: f64,
}

impl Disc {
    /// The first three events as functions of the state.
    pub(crate) fn functions(&self) -> impl Fn(&State<f64, 6>) -> [f64; 3] + Copy + use<> {
        let radius = self.radius;
        move |x| [x.q[2] - 0.97 * radius, x.v[2], x.q[0]]
    }

    pub(crate) fn numbered(index: usize) -> (Self, State<f64, 6>) {
        let disc = Self {
            m: 0.5 + number(index),
            radius: 0.2 + 0.4 * number(index + 1),
            g: 9.0 + number(index + 2),
        };
        let angles = [number(index + 3), 1.2 + 0.3 * number(index + 4), 0.0];
        let rates = [0.5 + number(index + 5), 0.3, 9.0 + 3.0 * number(index + 6)];
        let start = disc.rolling(angles, rates);
        (disc, start)
    }

    /// The state with these angles and rates whose point of contact is at rest, with its centre above the origin.
    pub(crate) fn rolling(&self, angles: [f64; 3], rates: [f64; 3]) -> State<f64, 6> {
        let ([phi, theta, psi], [precession, falling, spin]) = (angles, rates);
        let (sine, cosine) = phi.sin_cos();
        let along = self.radius * (spin + precession * theta.cos());
        let across = self.radius * falling * theta.sin();
        let q = [0.0, 0.0, self.radius * theta.sin(), phi, theta, psi];
        let v = [
            across * sine - along * cosine,
            -across * cosine - along * sine,
            self.radius * falling * theta.cos(),
            precession,
            falling,
            spin,
        ];
        State::new(0.0, q, v)
    }
}

/// A bead on a hoop that is driven about its vertical diameter: a constraint that contains the time.
#[derive(Clone, Debug, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(p: Vector3),
    kinetic = 0.5 * m * dot(p).norm_squared(),
    potential = m * g * p.z,
    constraint(
        circle = 0.5 * (p.norm_squared() - r.powi(2)),
        plane = p.y * cos(w * t) - p.x * sin(w * t),
    ),
    event(
        height = p.z + 0.9 * r,
        behind = p.y,
        turning = dot(p.z),
        push = reaction(plane),
    ),
)]
pub(crate) struct Hoop {
    pub(crate) m: f64,
    pub(crate) r: f64,
    pub(crate) g: f64,
    pub(crate) w: f64,
}

impl Hoop {
    /// The first three events as functions of the state.
    pub(crate) fn functions(&self) -> impl Fn(&State<f64, 3>) -> [f64; 3] + Copy + use<> {
        let r = self.r;
        move |x| [x.q[2] + 0.9 * r, x.q[1], x.v[2]]
    }

    pub(crate) fn numbered(index: usize) -> (Self, State<f64, 3>) {
        let hoop = Self {
            m: 0.5 + number(index),
            r: 0.3 + number(index + 1),
            g: 9.0 + number(index + 2),
            w: 1.0 + 5.0 * number(index + 3),
        };
        let (sine, cosine) = (0.5 + number(index + 4)).sin_cos();
        let rate = 3.0 + number(index + 5);
        let q = [sine, 0.0, -cosine].map(|x| hoop.r * x);
        let v = [rate * cosine, hoop.w * sine, rate * sine].map(|x| hoop.r * x);
        (hoop, State::new(0.0, q, v))
    }
}

/// A platform on three bars: where they are parallel and equal, one of them is redundant and the platform swings; otherwise it
/// is at rest.
#[derive(Clone, Debug, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y, phi),
    define(
        arm = [b * cos(phi), b * sin(phi)],
        left = [x, y] - arm,
        right = [x, y] + arm,
    ),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2) + b.powi(2) / 3.0 * dot(phi).powi(2)),
    potential = m * g * y,
    constraint(
        left_bar = 0.5 * ((left - [-b, 0.0]).norm_squared() - l.powi(2)),
        middle_bar = 0.5 * ([x, y].norm_squared() - l.powi(2)),
        right_bar = 0.5 * ((right - [b + shift, 0.0]).norm_squared() - n.powi(2)),
    ),
    compliance(
        left_bar = 1.0 / stiffness[0],
        middle_bar = 1.0 / stiffness[1],
        right_bar = 1.0 / stiffness[2],
    ),
    output(left_load = reaction(left_bar)),
    event(
        side = x,
        level = y + 0.8 * l,
        turning = dot(y),
        pull = (reaction(left_bar) + reaction(middle_bar) + reaction(right_bar)) * l + 1.1 * m * g,
    ),
)]
pub(crate) struct Platform {
    pub(crate) m: f64,
    pub(crate) g: f64,
    pub(crate) b: f64,
    pub(crate) l: f64,
    /// By how much the anchor of the right bar is moved, and the length of this bar.
    pub(crate) shift: f64,
    pub(crate) n: f64,
    /// The stiffnesses by which parallel bars share a load.
    pub(crate) stiffness: [f64; 3],
}

impl Platform {
    /// On parallel bars.
    pub(crate) const PARALLEL: Self = Self {
        m: 3.0,
        g: 9.81,
        b: 0.5,
        l: 1.25,
        shift: 0.0,
        n: 1.25,
        stiffness: [1.0; 3],
    };

    /// The first three events as functions of the state.
    pub(crate) fn functions(&self) -> impl Fn(&State<f64, 3>) -> [f64; 3] + Copy + use<> {
        let l = self.l;
        move |x| [x.q[0], x.q[1] + 0.8 * l, x.v[1]]
    }

    /// Every third one is held by three bars of which none is redundant.
    pub(crate) fn numbered(index: usize) -> (Self, State<f64, 3>) {
        let l = 0.5 + number(index);
        let (sine, cosine) = (0.3 + number(index + 1)).sin_cos();
        let q = [l * sine, -l * cosine, 0.0];
        let is_held = index % 3 == 2;
        let shift = if is_held { 0.4 } else { 0.0 };
        let platform = Self {
            m: 0.5 + number(index + 2),
            g: 9.0 + number(index + 3),
            b: 0.3 + number(index + 4),
            l,
            shift,
            n: if is_held {
                (q[0] - shift).hypot(q[1])
            } else {
                l
            },
            stiffness: [1.0; 3],
        };
        let speed = if is_held { 0.0 } else { number(index + 5) };
        (
            platform,
            State::new(0.0, q, [speed * cosine, speed * sine, 0.0]),
        )
    }
}

/// A four-bar linkage by the angles of its bars, without gravity.
#[derive(Clone, Debug, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(crank, coupler, rocker),
    define(
        joint = [a * cos(crank), a * sin(crank)] + [b * cos(coupler), b * sin(coupler)],
        end = [d, 0.0] + [c * cos(rocker), c * sin(rocker)],
    ),
    kinetic = 0.5 * m * (a.powi(2) * dot(crank).powi(2) + b.powi(2) * dot(coupler).powi(2) + c.powi(2) * dot(rocker).powi(2)),
    constraint(closure = joint - end),
    event(
        flat = sin(coupler),
        across = joint.y - 0.4,
        turning = dot(rocker),
        push = reaction(closure[0]),
    ),
)]
pub(crate) struct FourBar {
    pub(crate) m: f64,
    pub(crate) a: f64,
    pub(crate) b: f64,
    pub(crate) c: f64,
    pub(crate) d: f64,
}

impl FourBar {
    /// The first three events as functions of the state.
    pub(crate) fn functions(&self) -> impl Fn(&State<f64, 3>) -> [f64; 3] + Copy + use<> {
        let c = self.c;
        move |x| [x.q[1].sin(), c * x.q[2].sin() - 0.4, x.v[2]]
    }

    /// Every fourth one is a parallelogram, which meets configurations in which all of its bars lie in one line; one is open, and one
    /// has no length.
    pub(crate) fn numbered(index: usize) -> (Self, State<f64, 3>) {
        let mut linkage = Self {
            m: 0.5 + number(index),
            a: 1.0,
            b: 2.5 + 0.3 * number(index + 1),
            c: 2.0 + 0.3 * number(index + 2),
            d: 3.0 + 0.2 * number(index + 3),
        };
        if index % 4 == 2 {
            (linkage.b, linkage.c) = (linkage.d, linkage.a);
        }
        let crank = 0.5 + number(index + 4);
        let mut start = linkage.closed(crank, 2.0 + 3.0 * number(index + 5));
        match index {
            5 => start.q[1] += 0.01,
            11 => linkage.c = f64::NAN,
            _ => {}
        }
        (linkage, start)
    }

    /// The state at an angle and a speed of the crank, with the coupler above the base.
    pub(crate) fn closed(&self, crank: f64, speed: f64) -> State<f64, 3> {
        let Self { a, b, c, d, .. } = *self;
        let (sine, cosine) = crank.sin_cos();
        let (x, y) = (d - a * cosine, -a * sine);
        // From the pin of the crank to the other bearing.
        let distance = x.hypot(y);
        let at_pin = (b * b + distance * distance - c * c) / (2.0 * b * distance);
        let coupler = y.atan2(x) + at_pin.acos();
        let joint = [
            a * cosine + b * coupler.cos() - d,
            a * sine + b * coupler.sin(),
        ];
        let rocker = joint[1].atan2(joint[0]);
        // The velocity of the pin along the rocker and along the coupler.
        let turning = -a * speed * (crank - rocker).sin() / (b * (coupler - rocker).sin());
        let swinging = a * speed * (crank - coupler).sin() / (c * (rocker - coupler).sin());
        State::new(0.0, [crank, coupler, rocker], [speed, turning, swinging])
    }
}
