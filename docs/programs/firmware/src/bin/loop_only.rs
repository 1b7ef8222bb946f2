//! A control loop without anything else, for its size: computed torque and a regulator on `f32`.
#![no_std]
#![no_main]

use core::hint::black_box;

use cart_pole_model::{CartPole, computed_force, law};
use cortex_m_rt::entry;
use lagrangian::nalgebra::RowVector4;
use lagrangian::prelude::*;

#[panic_handler]
fn stop(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        cortex_m::asm::wfi();
    }
}

#[entry]
fn main() -> ! {
    let model = CartPole::<f32>::new();
    let gain = RowVector4::new(-2.6758, -35.4849, -4.0647, -7.5324);
    loop {
        // Sensors and motors of a board take the place of the black boxes.
        let x: State<f32, 2> = black_box(State::new(0.0, [0.1, 0.2], [0.3, 0.4]));
        let wanted = law(&gain, &x);
        black_box(computed_force(&model, &x, wanted));
    }
}
