//! Prints how many instructions the functions of a control loop take on an emulated Cortex-M.
#![no_std]
#![no_main]

mod counter;
mod functions;

use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};
use counter::Counter;
use functions::{double, single};
use panic_semihosting as _;

#[entry]
fn main() -> ! {
    if let Some(counter) = Counter::start() {
        // A loop of 1001 subtractions and branches, 2002 instructions, checks the count.
        let known = counter.count(1000, || cortex_m::asm::delay(1000));
        hprintln!("known_loop {} {}", known, known);
        let (single, double) = (single::counts(&counter), double::counts(&counter));
        for ((name, single), (_, double)) in single.iter().zip(&double) {
            hprintln!("{} {} {}", name, single, double);
        }
    }
    debug::exit(debug::EXIT_SUCCESS);
    loop {
        cortex_m::asm::wfi();
    }
}
