//! Rigid bodies: mass, centre of gravity and inertia, from solids, particles, meshes and reports.
//!
//! As everywhere in this crate, equation numbers refer to a short text on rigid bodies. Any consistent system of units
//! may be used: in SI a mass is in kg, a length in m, a moment of inertia in kg m², a density in kg/m³, kg/m² or kg/m.
//! Checks for physical validity and the search for principal axes need a scalar that is a
//! [`SingleNumber`](crate::SingleNumber): `f64`, `f32`, a double-double or a dual number.
//!
//! ```
//! use lagrangian::rigid_body::{RigidBody, Solid};
//! use lagrangian::nalgebra::Vector3;
//!
//! // A steel plate with a hole near its corner; lengths in m.
//! let plate = Solid::cuboid(0.4, 0.2, 0.01)?.with_density(7850.0)?;
//! let hole = Solid::cylinder(0.03, 0.01)?.with_density(7850.0)?;
//! let body = plate.minus(&hole.moved(Vector3::new(0.15, 0.05, 0.0)))?;
//!
//! assert!((body.mass() - 7850.0 * (0.4 * 0.2 - core::f64::consts::PI * 0.0009) * 0.01).abs() < 1e-12);
//! // The missing mass at x > 0, y > 0 makes ∫ xy dm negative; the entry of the tensor has the opposite sign (2.1).
//! assert!(body.inertia().products().xy < 0.0 && body.inertia().matrix()[(0, 1)] > 0.0);
//! let principal = body.principal_axes();
//! assert!(principal.moments[0] < principal.moments[1] && principal.moments[1] < principal.moments[2]);
//! # Ok::<(), lagrangian::rigid_body::BodyError>(())
//! ```

mod error;
mod order;
mod inertia_tensor;
mod principal_axes;
mod validity;
mod body;
mod principal_body;
mod symmetric_body;
mod solid;
#[cfg(feature = "alloc")]
mod mesh;
mod reports;
mod motion;
mod resultant;
mod momentum;
mod rotation_state;
mod moments;
mod euler_equations;
mod bodies_in_lanes;
mod steady_rotation;
mod steady_precession;
mod free_rotation;
mod nutation;

pub use bodies_in_lanes::MomentInLanes;
pub use body::RigidBody;
pub use error::BodyError;
pub use euler_equations::EulerEquations;
pub use free_rotation::FreeRotation;
pub use inertia_tensor::{InertiaTensor, ProductsOfInertia};
#[cfg(feature = "mesh-files")]
pub use mesh::MeshFileError;
#[cfg(feature = "alloc")]
pub use mesh::{MeshError, TriangleMesh};
pub use moments::{
    ConstantForce, ConstantMoment, Damping, Moment, MomentSeries, NoMoment, ProductSeries,
};
pub use momentum::rate_in_space;
pub use motion::RigidMotion;
pub use nutation::Nutation;
pub use principal_axes::{PrincipalAxes, Symmetry};
pub use principal_body::PrincipalBody;
pub use reports::{CadReport, ProductSign, UrdfInertial};
pub use resultant::Resultant;
pub use rotation_state::RotationState;
pub use solid::Solid;
pub use steady_precession::SteadyPrecession;
pub use steady_rotation::SteadyRotation;
pub use symmetric_body::SymmetricBody;
