//! A control loop that predicts the next state by a step of Runge and Kutta, for its size, on `f32`.
#![no_std]
#![no_main]

use core::hint::black_box;

use cart_pole_model::{CartPole, law};
use cortex_m_rt::entry;
use lagrangian::nalgebra::RowVector4;
use lagrangian::prelude::*;

#[panic_handler]
fn stop(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        cortex_m::asm::wfi();
    }
}

// ANCHOR: entry
#[entry]
fn main() -> ! {
    let model = CartPole::<f32>::new();
    let gain = RowVector4::new(-2.6758, -35.4849, -4.0647, -7.5324);
    let equations = model.dynamics();
    let measured: State<f32, 2> = black_box(State::new(0.0, [0.1, 0.2], [0.3, 0.4]));
    if let Ok(mut stepper) = RungeKutta::classical(1e-3).start(&equations, 0.0, measured.x) {
        loop {
            let next = stepper.time() + 1e-3;
            if stepper.step(&equations, next).is_err() {
                break;
            }
            let predicted = State {
                t: 0.0,
                x: *stepper.state(),
            };
            black_box(law(&gain, &predicted));
        }
    }
    loop {
        cortex_m::asm::wfi();
    }
}
// ANCHOR_END: entry
