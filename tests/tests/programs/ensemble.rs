//! Twenty pendulums of several lengths, in lanes: their angles until each first passes the bottom.

use lagrangian::prelude::*;

use crate::models::Swing;

pub(crate) fn program() -> Result<Vec<Vec<f64>>, IntegrationError> {
    let swing = |l| Problem::new(Swing { l, g: 9.81 }, State::new(0.0, [1.0], [0.0]));
    let until_bottom = |l| swing(l).on(Swing::BOTTOM).stop().save(Every(0.1));
    let swings = (0..20).map(|i| until_bottom(0.5 + 0.05 * f64::from(i)));
    let found = Ensemble::new(swings).solve(10.0, Taylor::new()).into_iter();
    let angles = found.map(|motion| Ok(motion?.into_iter().map(|x| x.q[0]).collect()));
    angles.collect()
}
