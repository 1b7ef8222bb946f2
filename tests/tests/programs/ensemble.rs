//! Twenty pendulums of several lengths: where they end, and how often each passes the bottom.

use lagrangian::prelude::*;

use crate::models::Swing;

pub(crate) fn program() -> Result<Vec<(f64, usize)>, IntegrationError> {
    let member = |l: f64| {
        let swing = Problem::new(Swing { l, g: 9.81 }, State::new(0.0, [1.0], [0.0]));
        let swing = swing.on(Swing::BOTTOM).record().save(Every(0.1));
        let motion = swing.solve(10.0, Taylor::new())?;
        Ok((motion.q[0], motion.events().len()))
    };
    (0..20).map(|i| member(0.5 + 0.05 * f64::from(i))).collect()
}
