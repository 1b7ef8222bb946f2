//! Mechanisms with constraints, and the same in minimal coordinates.

use lagrangian::prelude::*;

/// A bob on a rod.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    constraint(rod = x.powi(2) + y.powi(2) - l.powi(2)),
)]
pub(super) struct Bob {
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) l: f64,
}

impl Bob {
    pub(super) const EXAMPLE: Self = Self {
        m: 0.3,
        g: 9.81,
        l: 0.7,
    };

    pub(super) fn at(&self, angle: f64, rate: f64) -> State<f64, 2> {
        let (sine, cosine) = angle.sin_cos();
        let (q, v) = ([self.l * sine, -self.l * cosine], [cosine, sine]);
        State::new(0.0, q, v.map(|v| v * self.l * rate))
    }
}

/// A pendulum by its angle.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi),
    kinetic = 0.5 * (l * dot(phi)).powi(2),
    potential = -g * l * cos(phi),
)]
pub(super) struct Angle {
    pub(super) g: f64,
    pub(super) l: f64,
}

/// Three bobs of different masses on rods of length 1, one below the other.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x[3], y[3]),
    define(
        dx[0] = x[0],
        dy[0] = y[0],
        dx[i] = x[i] - x[i - 1] for i in 1..3,
        dy[i] = y[i] - y[i - 1] for i in 1..3,
    ),
    kinetic = (0..3).map(|i| 0.5 * (i + 1.0) * (dot(x[i]).powi(2) + dot(y[i]).powi(2))).sum(),
    potential = (0..3).map(|i| (i + 1.0) * g * y[i]).sum(),
    constraint(rod[i] = 0.5 * (dx[i].powi(2) + dy[i].powi(2) - 1.0) for i in 0..3),
)]
pub(super) struct Bobs {
    pub(super) g: f64,
}

impl Bobs {
    pub(super) fn at(angles: [f64; 3], rates: [f64; 3]) -> State<f64, 6> {
        let (mut q, mut v) = ([0.0; 6], [0.0; 6]);
        let mut end = [0.0; 4];
        for i in 0..3 {
            let (sine, cosine) = angles[i].sin_cos();
            let changes = [sine, -cosine, cosine * rates[i], sine * rates[i]];
            end.iter_mut()
                .zip(changes)
                .for_each(|(x, change)| *x += change);
            [q[i], q[3 + i], v[i], v[3 + i]] = end;
        }
        State::new(0.0, q, v)
    }
}

/// The pendulums of [`Bobs`] by their angles from the vertical.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b, c),
    define(
        p = [sin(a), -cos(a)],
        q = p + [sin(b), -cos(b)],
        r = q + [sin(c), -cos(c)],
    ),
    kinetic = 0.5 * dot(p).norm_squared() + dot(q).norm_squared() + 1.5 * dot(r).norm_squared(),
    potential = g * (p.y + 2.0 * q.y + 3.0 * r.y),
)]
pub(super) struct Angles {
    pub(super) g: f64,
}

/// A bead on a parabola, with friction.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    dissipation = 0.1 * (dot(x).powi(2) + dot(y).powi(2)),
    constraint(wire = y - c * x.powi(2)),
)]
pub(super) struct Wire {
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) c: f64,
}

/// The bead of [`Wire`] by its abscissa.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    define(y = c * x.powi(2)),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    dissipation = 0.1 * (dot(x).powi(2) + dot(y).powi(2)),
)]
pub(super) struct WireAlone {
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) c: f64,
}

/// A bob that swings in space.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, z),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2) + dot(z).powi(2)),
    potential = m * g * z,
    constraint(rod = x.powi(2) + y.powi(2) + z.powi(2) - l.powi(2)),
)]
pub(super) struct Spherical {
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) l: f64,
}

/// A platform on three parallel bars of equal length, of which one is redundant.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, phi),
    define(
        p = [x, y],
        bar[i] = p + (i - 1.0) * [cos(phi) - 1.0, sin(phi)] for i in 0..3,
    ),
    kinetic = 0.5 * m * (dot(p).norm_squared() + 0.3 * dot(phi).powi(2)),
    potential = m * g * y,
    constraint(bars[i] = bar[i].norm_squared() - l.powi(2) for i in 0..3),
)]
pub(super) struct Platform {
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) l: f64,
}

impl Platform {
    pub(super) fn at(&self, angle: f64, rate: f64) -> State<f64, 3> {
        let (sine, cosine) = angle.sin_cos();
        let [x, y] = [self.l * sine, self.l * cosine];
        State::new(0.0, [x, -y, 0.0], [y * rate, x * rate, 0.0])
    }
}

/// A pendulum whose support moves at a constant velocity.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(s, phi),
    define(x = s + l * sin(phi), y = -l * cos(phi)),
    kinetic = 0.5 * mass * dot(s).powi(2) + 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    constraint(drive = s - speed * t),
)]
pub(super) struct Carried {
    pub(super) m: f64,
    pub(super) mass: f64,
    pub(super) g: f64,
    pub(super) l: f64,
    pub(super) speed: f64,
}

/// A bead on a hoop, which a motor turns.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta),
    kinetic = 0.5 * (j + m * (r * sin(theta)).powi(2)) * dot(phi).powi(2) + 0.5 * m * (r * dot(theta)).powi(2),
    potential = -m * g * r * cos(theta),
    constraint(motor = phi - rate * t),
)]
pub(super) struct Hoop {
    j: f64,
    m: f64,
    r: f64,
    g: f64,
    rate: f64,
}

impl Hoop {
    pub(super) const EXAMPLE: Self = Self {
        j: 0.2,
        m: 0.1,
        r: 0.5,
        g: 9.81,
        rate: 6.0,
    };
}

/// The bead of [`Hoop`] by its angle.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * m * r.powi(2) * (dot(theta).powi(2) + (rate * sin(theta)).powi(2)),
    potential = -m * g * r * cos(theta),
)]
pub(super) struct HoopAlone {
    m: f64,
    r: f64,
    g: f64,
    rate: f64,
}

impl HoopAlone {
    pub(super) const EXAMPLE: Self = Self {
        m: 0.1,
        r: 0.5,
        g: 9.81,
        rate: 6.0,
    };
}

/// Two masses on a rope over a pulley, one on a spring and a damper.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, phi),
    kinetic = 0.5 * (m * dot(x).powi(2) + 2.0 * m * dot(y).powi(2) + j * dot(phi).powi(2)),
    potential = 0.5 * k * x.powi(2),
    dissipation = 0.5 * c * dot(x).powi(2),
    constraint(rope = x + y, pulley = x - r * phi),
)]
pub(super) struct Rope {
    m: f64,
    j: f64,
    r: f64,
    k: f64,
    c: f64,
}

impl Rope {
    pub(super) const EXAMPLE: Self = Self {
        m: 0.5,
        j: 0.02,
        r: 0.2,
        k: 30.0,
        c: 0.7,
    };
}

/// The masses of [`Rope`] by one coordinate.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * (3.0 * m + j / r.powi(2)) * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
    dissipation = 0.5 * c * dot(x).powi(2),
)]
pub(super) struct RopeAlone {
    m: f64,
    j: f64,
    r: f64,
    k: f64,
    c: f64,
}

impl RopeAlone {
    pub(super) const EXAMPLE: Self = Self {
        m: 0.5,
        j: 0.02,
        r: 0.2,
        k: 30.0,
        c: 0.7,
    };
}

/// A bob at the end of a rod without mass.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, phi),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    constraint(end = [x - l * sin(phi), y + l * cos(phi)]),
)]
pub(super) struct MasslessRod {
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) l: f64,
}

/// Chaplygin's sleigh: its knife, and its centre of mass before it.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, theta),
    define(center = [x + a * cos(theta), y + a * sin(theta)]),
    kinetic = 0.5 * m * dot(center).norm_squared() + 0.5 * inertia * dot(theta).powi(2),
    nonholonomic(knife = -sin(theta) * dot(x) + cos(theta) * dot(y)),
)]
pub(super) struct Sleigh {
    pub(super) m: f64,
    pub(super) inertia: f64,
    pub(super) a: f64,
}

/// A thin disc that rolls without slipping.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, z, phi, theta, psi),
    define(
        p = [x, y, z],
        w = angular_velocity_zxz(phi, theta, psi),
        arm = -r * (rotation_z(phi) * [0.0, cos(theta), sin(theta)]),
        slip = dot(p) + angular_velocity_zxz_inertial(phi, theta, psi).cross(arm),
    ),
    kinetic = 0.5 * m * dot(p).norm_squared() + 0.125 * m * r.powi(2) * w.dot(diagonal([1.0, 1.0, 2.0]) * w),
    potential = m * g * z,
    constraint(ground = z - r * sin(theta)),
    nonholonomic(rolling = [slip.x, slip.y]),
)]
pub(super) struct Disc {
    pub(super) m: f64,
    pub(super) r: f64,
    pub(super) g: f64,
}

impl Disc {
    /// Rolling straight on along x.
    pub(super) fn upright(&self, omega: f64) -> State<f64, 6> {
        let q = [0.0, 0.0, self.r, 0.0, core::f64::consts::FRAC_PI_2, 0.0];
        State::new(0.0, q, [-self.r * omega, 0.0, 0.0, 0.0, 0.0, omega])
    }

    /// Rolling in a circle about the origin: (C + m r²) ω₃ Ω sin θ − A Ω² sin θ cos θ + m g r cos θ = 0.
    pub(super) fn circle(&self, theta: f64, rate: f64) -> State<f64, 6> {
        let (sin, cos) = theta.sin_cos();
        let axial =
            cos * (0.25 * self.r * rate * rate * sin - self.g) / (1.5 * self.r * rate * sin);
        let speed = -self.r * axial;
        let q = [0.0, -speed / rate, self.r * sin, 0.0, theta, 0.0];
        State::new(0.0, q, [speed, 0.0, 0.0, rate, 0.0, axial - rate * cos])
    }
}
