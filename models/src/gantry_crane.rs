//! A load on a rope below a trolley.

use lagrangian::prelude::*;

/// A gantry crane: a trolley at x on a straight track, and a load that swings by θ on a rope of length l, which a winch winds.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian_models::GantryCrane;
///
/// let (trolley, load, g) = (500.0, 200.0, 9.81);
/// let crane = GantryCrane { trolley, load, g, drive: 300.0, winch: -1900.0 };
/// let state = State::new(0.0, [2.0, 8.0, 0.2], [0.6, -0.3, 0.1]);
/// let [x, l, theta] = crane.accelerations(&state).into();
/// let (s, c) = 0.2_f64.sin_cos();
/// // The load along the rope and across it, and both bodies along the track.
/// assert!((load * (l + x * s - 8.0 * 0.01 - g * c) + 1900.0).abs() < 1e-11);
/// assert!((8.0 * theta + 2.0 * -0.3 * 0.1 + x * c + g * s).abs() < 1e-13);
/// let along = l * s + 2.0 * -0.3 * 0.1 * c + 8.0 * (theta * c - 0.01 * s);
/// assert!(((trolley + load) * x + load * along - 300.0).abs() < 1e-11);
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(x, l, theta),
    define(position = [x + l * sin(theta), -l * cos(theta)]),
    kinetic = 0.5 * trolley * dot(x).powi(2) + 0.5 * load * dot(position).norm_squared(),
    potential = load * g * position.y,
    force(x = drive, l = winch),
    output(position = position),
)]
pub struct GantryCrane {
    /// The mass of the trolley in kg.
    pub trolley: f64,
    /// The mass of the load in kg.
    pub load: f64,
    /// The acceleration of gravity in m/s².
    pub g: f64,
    /// The force of the drive on the trolley in N, which a controller sets.
    #[lagrangian(input)]
    pub drive: f64,
    /// The force of the winch along the rope in N, outwards, which a controller sets: negative where it pulls.
    #[lagrangian(input)]
    pub winch: f64,
}
