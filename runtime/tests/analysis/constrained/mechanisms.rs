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
    pub(super) fn at(&self, angles: [f64; 3], rates: [f64; 3]) -> State<f64, 6> {
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

/// A crank, a rod and a slider in relative coordinates.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(alpha, beta, x),
    define(middle = [a * cos(alpha) + 0.5 * b * cos(beta), a * sin(alpha) + 0.5 * b * sin(beta)]),
    kinetic = m * a.powi(2) / 6.0 * dot(alpha).powi(2) + 0.5 * m * dot(x).powi(2),
    kinetic = 0.5 * m * (dot(middle).norm_squared() + b.powi(2) / 12.0 * dot(beta).powi(2)),
    potential = m * g * (0.5 * a * sin(alpha) + middle.y) + 0.5 * k * x.powi(2),
    constraint(pin = [a * cos(alpha) + b * cos(beta) - x, a * sin(alpha) + b * sin(beta)]),
)]
pub(super) struct Crank {
    pub(super) m: f64,
    pub(super) a: f64,
    pub(super) b: f64,
    pub(super) g: f64,
    pub(super) k: f64,
}

/// The angle of the rod and its rate, and place and velocity of the slider.
fn slider([a, b]: [f64; 2], alpha: f64, speed: f64) -> [f64; 4] {
    let (sine, cosine) = alpha.sin_cos();
    let beta = (-a * sine / b).asin();
    let turning = -a * cosine * speed / (b * beta.cos());
    let x = a * cosine + b * beta.cos();
    [
        beta,
        turning,
        x,
        -a * sine * speed - b * beta.sin() * turning,
    ]
}

impl Crank {
    pub(super) const EXAMPLE: Self = Self {
        m: 0.8,
        a: 0.4,
        b: 1.1,
        g: 9.81,
        k: 20.0,
    };

    pub(super) fn turned(&self, alpha: f64, speed: f64) -> State<f64, 3> {
        let [beta, turning, x, v] = slider([self.a, self.b], alpha, speed);
        State::new(0.0, [alpha, beta, x], [speed, turning, v])
    }
}

/// The mechanism of [`Crank`] by the places and angles of its bodies.
#[derive(Lagrangian)]
#[lagrangian(
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
)]
pub(super) struct CrankOfBodies {
    m: f64,
    a: f64,
    b: f64,
    g: f64,
    k: f64,
}

impl CrankOfBodies {
    pub(super) const EXAMPLE: Self = Self {
        m: 0.8,
        a: 0.4,
        b: 1.1,
        g: 9.81,
        k: 20.0,
    };

    pub(super) fn turned(&self, alpha: f64, speed: f64) -> State<f64, 7> {
        let [beta, turning, x, v] = slider([self.a, self.b], alpha, speed);
        let (sine, cosine) = alpha.sin_cos();
        let [px, py] = [0.5 * self.a * cosine, 0.5 * self.a * sine];
        let arm = [0.5 * self.b * beta.cos(), 0.5 * self.b * beta.sin()];
        let q = [px, py, alpha, x - arm[0], -arm[1], beta, x];
        let rates = [-py * speed, px * speed, speed];
        let of_rod = [v + arm[1] * turning, -arm[0] * turning, turning, v];
        State::new(
            0.0,
            q,
            core::array::from_fn(|i| if i < 3 { rates[i] } else { of_rod[i - 3] }),
        )
    }
}

/// The mechanism of [`Crank`] by its one freedom.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(alpha),
    define(
        beta = asin(-a * sin(alpha) / b),
        x = a * cos(alpha) + b * cos(beta),
        middle = [a * cos(alpha) + 0.5 * b * cos(beta), a * sin(alpha) + 0.5 * b * sin(beta)],
    ),
    kinetic = m * a.powi(2) / 6.0 * dot(alpha).powi(2) + 0.5 * m * dot(x).powi(2),
    kinetic = 0.5 * m * (dot(middle).norm_squared() + b.powi(2) / 12.0 * dot(beta).powi(2)),
    potential = m * g * (0.5 * a * sin(alpha) + middle.y) + 0.5 * k * x.powi(2),
)]
pub(super) struct CrankAlone {
    m: f64,
    a: f64,
    b: f64,
    g: f64,
    k: f64,
}

impl CrankAlone {
    pub(super) const EXAMPLE: Self = Self {
        m: 0.8,
        a: 0.4,
        b: 1.1,
        g: 9.81,
        k: 20.0,
    };
}

/// A four-bar linkage of rods in one plane, with a spring at the crank.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(crank, coupler, rocker),
    define(
        pin = [a * cos(crank), a * sin(crank)],
        arm = [b * cos(coupler), b * sin(coupler)],
        end = [d + c * cos(rocker), c * sin(rocker)],
        middle = pin + 0.5 * arm,
    ),
    kinetic = m * (a.powi(2) * dot(crank).powi(2) + c.powi(2) * dot(rocker).powi(2)) / 6.0,
    kinetic = 0.5 * m * (dot(middle).norm_squared() + b.powi(2) / 12.0 * dot(coupler).powi(2)),
    potential = 0.5 * k * crank.powi(2) + m * g * middle.y,
    dissipation = 0.05 * dot(rocker).powi(2),
    constraint(joint = pin + arm - end),
)]
pub(super) struct FourBar {
    a: f64,
    b: f64,
    c: f64,
    d: f64,
    m: f64,
    g: f64,
    k: f64,
}

impl FourBar {
    pub(super) const EXAMPLE: Self = Self {
        a: 1.0,
        b: 2.5,
        c: 2.0,
        d: 3.0,
        m: 0.4,
        g: 9.81,
        k: 3.0,
    };

    /// Of equal bars, which can lie in one line.
    pub(super) const RHOMBUS: Self = Self {
        a: 1.0,
        b: 1.0,
        c: 1.0,
        d: 1.0,
        ..Self::EXAMPLE
    };
}

/// A linkage whose crank is held.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(crank, coupler, rocker),
    define(
        pin = [a * cos(crank), a * sin(crank)],
        arm = [b * cos(coupler), b * sin(coupler)],
        end = [d + c * cos(rocker), c * sin(rocker)],
    ),
    kinetic = 0.5 * (dot(crank).powi(2) + dot(coupler).powi(2) + dot(rocker).powi(2)),
    constraint(joint = pin + arm - end, motor = crank - speed * t - 1.0),
)]
pub(super) struct DrivenFourBar {
    a: f64,
    b: f64,
    c: f64,
    d: f64,
    speed: f64,
}

impl DrivenFourBar {
    pub(super) const EXAMPLE: Self = Self {
        a: 1.0,
        b: 2.5,
        c: 2.0,
        d: 3.0,
        speed: 1.5,
    };
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
