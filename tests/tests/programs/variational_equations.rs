//! How the end of a swing depends on its start and on the length of the pendulum.

use lagrangian::prelude::*;
use lagrangian::{Dual, StateTransition};

use crate::models::Swing;

pub(crate) fn program() -> Result<[f64; 3], IntegrationError> {
    let l = Dual::<f64, 3>::variable(1.0, 2);
    let swing = Swing { l, g: 9.81 }.into_dynamics();
    let end = StateTransition::over(&Taylor::new(), &swing, &State::new(0.0, 1.0, 0.0), 10.0)?;
    Ok([end.q[0], end.q[1], end.q[2]])
}
