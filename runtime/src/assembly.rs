//! Consistent states of models with constraints: [`Lagrangian::assemble`](trait@crate::Lagrangian#method.assemble).

pub use crate::model::{Assembled, Assembly, AssemblyError, OpenConstraints};
