//! Ready models of rigid bodies, each declared as a user would: its file is its declaration.
//!
//! Equation numbers are those of the text on rigid bodies to which `lagrangian` refers. Units are the user's, one system
//! throughout; those of SI are named. All have the clause `taylor`, so that [`Taylor`](lagrangian::Taylor) steps them.

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
mod rattleback;
mod simple_pendulum;
mod slung_load;
mod spherical_pendulum;
mod stewart_platform;
mod symmetric_top;

pub use acrobot::Acrobot;
pub use arm::Arm;
pub use bicycle::Bicycle;
pub use cart_pole::CartPole;
pub use cart_with_two_poles::CartWithTwoPoles;
pub use double_pendulum::DoublePendulum;
pub use foucault_pendulum::FoucaultPendulum;
pub use free_body::FreeBody;
pub use furuta_pendulum::FurutaPendulum;
pub use gantry_crane::GantryCrane;
pub use general_top::GeneralTop;
pub use gyrocompass::Gyrocompass;
pub use gyroscope::Gyroscope;
pub use kapitza_pendulum::KapitzaPendulum;
pub use rattleback::Rattleback;
pub use simple_pendulum::SimplePendulum;
pub use slung_load::SlungLoad;
pub use spherical_pendulum::SphericalPendulum;
pub use stewart_platform::StewartPlatform;
pub use symmetric_top::SymmetricTop;
