//! Twenty pendulums of several lengths in lanes: samples, and how often each passes the bottom.

use lagrangian::prelude::*;

use crate::models::Swing;

pub(crate) fn program() -> Result<Vec<(f64, usize)>, IntegrationError> {
    let times: Vec<f64> = (0..=100).map(|k| 0.1 * f64::from(k)).collect();
    let member = |i: i32| {
        let swing = Swing {
            l: 0.5 + 0.05 * f64::from(i),
            g: 9.81,
        };
        let driver = Taylor::new()
            .driver()
            .declared_events([(Swing::<f64>::BOTTOM, Event::either())]);
        let motion = driver.sample(&swing.dynamics(), State::new(0.0, [1.0], [0.0]), &times)?;
        Ok((motion.last().x.q[0], motion.events().len()))
    };
    (0..20).map(member).collect()
}
