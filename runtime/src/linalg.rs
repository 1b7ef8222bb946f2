//! Vectors and matrices of scalars: the solution of M q̈ = f, also lane by lane.

mod factorization;
mod saddle_point;
mod independent_rows;
mod independent_columns;
mod dependent_columns;
mod into_vector;
pub(crate) mod lane_select;
pub(crate) mod pivoting;
mod error_tolerance;
mod vector_space;
pub(crate) mod horner;
mod lane_states;
mod entries;

pub(crate) use dependent_columns::{DependentColumns, Undetermined};
pub(crate) use entries::{first_largest, kept, largest, largest_or_nan};
pub use error_tolerance::ErrorTolerance;
pub use factorization::Factorization;
pub(crate) use independent_columns::ColumnChoice;
pub(crate) use independent_rows::{RowSpace, column_widths, smallest_sine};
pub use into_vector::IntoVector;
pub use lane_states::LaneStates;
pub(crate) use lane_states::lanes_by_fields;
pub use saddle_point::SaddlePoint;
pub use vector_space::VectorSpace;
pub(crate) use vector_space::operations_by_fields;
