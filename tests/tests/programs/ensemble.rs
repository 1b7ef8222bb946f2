//! Twenty pendulums of several lengths, in lanes: when each first passes the bottom, and its angles until then.

use lagrangian::prelude::*;

use crate::models::Swing;

pub(crate) fn program() -> Result<Vec<(f64, Vec<f64>)>, IntegrationError> {
    let start = State::new(0.0, [1.0], [0.0]);
    let swings = (0..20).map(|i| {
        Problem::new(
            Swing {
                l: 0.5 + 0.05 * f64::from(i),
                g: 9.81,
            },
            start,
        )
    });
    let swings = swings.map(|swing| swing.on(Swing::BOTTOM).stop().save(Every(0.1)));
    let found: Result<Vec<_>, _> = Ensemble::new(swings)
        .solve(10.0, Taylor::new())
        .into_iter()
        .collect();
    Ok(found?
        .into_iter()
        .map(|motion| (motion.t, motion.into_iter().map(|x| x.q[0]).collect()))
        .collect())
}
