//! Slider-cranks and four-bar linkages.

use lagrangian::prelude::*;

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
