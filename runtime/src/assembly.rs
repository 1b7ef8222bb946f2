//! Consistent states of models with constraints, [`Lagrangian::assemble`](trait@crate::Lagrangian#method.assemble), and
//! their [degrees of freedom](trait@crate::Lagrangian#method.degrees_of_freedom).

pub use crate::model::{Assembled, Assembly, AssemblyError, DegreesOfFreedom, OpenConstraints};
