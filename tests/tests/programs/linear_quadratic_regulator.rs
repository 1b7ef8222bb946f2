//! A pole on a cart, caught by a linear-quadratic regulator with a saturated force.

use std::error::Error;

use lagrangian::analysis::StateSpace;
use lagrangian::nalgebra::{Matrix1, Matrix4};
use lagrangian::prelude::*;

use crate::models::{CART_POLE, CartPole};

pub(crate) fn program() -> Result<f64, Box<dyn Error>> {
    let plant = StateSpace::of(&CART_POLE, &State::new(0.0, [0.0; 2], [0.0; 2]));
    let regulator = plant.regulator(&Matrix4::identity(), &Matrix1::new(0.1))?;
    let caught = Problem::new(&CART_POLE, State::new(0.0, [0.0, 0.5], [0.0, 0.0]))
        .feedback(|x| regulator.input(x)[0].clamp(-20.0, 20.0));
    Ok(caught.solve(20.0, Dop853::new())?.q[CartPole::THETA])
}
