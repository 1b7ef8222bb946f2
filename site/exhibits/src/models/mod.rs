//! One file for each model: what is said about it, its sliders, its law and its drawing.

mod acrobot;
mod arm;
mod bicycle;
mod cart_pole;
mod cart_with_two_poles;
mod double_pendulum;
mod foucault_pendulum;
mod free_body;
mod furuta_pendulum;
mod gantry_crane;
mod general_top;
mod gyrocompass;
mod gyroscope;
mod kapitza_pendulum;
mod prelude;
mod rattleback;
mod simple_pendulum;
mod slung_load;
mod spherical_pendulum;
mod stewart_platform;
mod symmetric_top;

use lagrangian_models as models;

use crate::exhibit::{Exhibit, Of};

/// All exhibits, in the order in which they are shown.
///
/// It is not inlined: all models would be compiled again in each crate that calls it.
#[must_use]
#[inline(never)]
pub fn exhibits() -> [&'static dyn Exhibit; 20] {
    [
        &Of::<models::SimplePendulum, 1>::NEW,
        &Of::<models::DoublePendulum, 2>::NEW,
        &Of::<models::SphericalPendulum, 2>::NEW,
        &Of::<models::FoucaultPendulum, 2>::NEW,
        &Of::<models::KapitzaPendulum, 1>::NEW,
        &Of::<models::CartPole, 2>::NEW,
        &Of::<models::CartWithTwoPoles, 3>::NEW,
        &Of::<models::Acrobot, 2>::NEW,
        &Of::<models::FurutaPendulum, 2>::NEW,
        &Of::<models::GantryCrane, 3>::NEW,
        &Of::<models::Arm, 3>::NEW,
        &Of::<models::SlungLoad, 8>::NEW,
        &Of::<models::SymmetricTop, 3>::NEW,
        &Of::<models::GeneralTop, 3>::NEW,
        &Of::<models::FreeBody, 6>::NEW,
        &Of::<models::Gyroscope, 3>::NEW,
        &Of::<models::Gyrocompass, 2>::NEW,
        &Of::<models::Rattleback, 5>::NEW,
        &Of::<models::Bicycle, 8>::NEW,
        &Of::<models::StewartPlatform, 24>::NEW,
    ]
}
