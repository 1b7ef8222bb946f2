//! Ready models of rigid bodies, each declared as a user would: its file is its declaration.
//!
//! Equation numbers are those of the text on rigid bodies to which `lagrangian` refers. Units are the user's, one system
//! throughout; those of SI are named. All have the clause `taylor`, so that [`Taylor`](lagrangian::Taylor) steps them.

mod arm;
mod bicycle;
mod cart_pole;
mod double_pendulum;
mod free_body;
mod furuta_pendulum;
mod general_top;
mod gyroscope;
mod simple_pendulum;
mod spherical_pendulum;
mod stewart_platform;
mod symmetric_top;

pub use arm::Arm;
pub use bicycle::Bicycle;
pub use cart_pole::CartPole;
pub use double_pendulum::DoublePendulum;
pub use free_body::FreeBody;
pub use furuta_pendulum::FurutaPendulum;
pub use general_top::GeneralTop;
pub use gyroscope::Gyroscope;
pub use simple_pendulum::SimplePendulum;
pub use spherical_pendulum::SphericalPendulum;
pub use stewart_platform::StewartPlatform;
pub use symmetric_top::SymmetricTop;
