//! A pole on a cart, caught by a linear-quadratic regulator with a saturated force.

use std::error::Error;

use lagrangian::analysis::StateSpace;
use lagrangian::nalgebra::{Matrix1, Matrix4, Vector4};
use lagrangian::prelude::*;

use crate::models::{CART_POLE, CartPole};

pub(crate) fn program() -> Result<f64, Box<dyn Error>> {
    let upright = State::new(0.0, [0.0, 0.0], [0.0, 0.0]);
    let plant = StateSpace::<f64, 4, 1, 4>::of(&CART_POLE, &upright);
    let gain = plant
        .regulator(&Matrix4::identity(), &Matrix1::new(0.1))?
        .gain;
    let caught = CART_POLE.controlled_by(|x| {
        let x = Vector4::new(x.q[0], x.q[1], x.v[0], x.v[1]);
        (-gain * x)[0].clamp(-20.0, 20.0)
    });
    let start = State::new(0.0, [0.0, 0.5], [0.0, 0.0]);
    Ok(Dop853::new().integrate_to(&caught, start, 20.0)?.x.q[CartPole::THETA])
}
