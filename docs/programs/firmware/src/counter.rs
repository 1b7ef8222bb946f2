//! Instructions, counted by the SysTick timer of an emulated processor.
//!
//! With `-icount shift=0`, the time of QEMU advances by 1 ns with each instruction. SysTick counts it in periods of the processor's
//! clock, 25 MHz on the boards MPS2: a tick is 40 instructions.

use cortex_m::peripheral::syst::SystClkSource;
use cortex_m::peripheral::{Peripherals, SYST};

/// Instructions in a tick.
const INSTRUCTIONS: u32 = 40;

/// The largest count of SysTick.
const TICKS: u32 = 0x00ff_ffff;

/// The running timer.
pub(crate) struct Counter(());

impl Counter {
    /// Starts SysTick.
    pub(crate) fn start() -> Option<Self> {
        let mut timer = Peripherals::take()?.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(TICKS);
        timer.clear_current();
        timer.enable_counter();
        Some(Self(()))
    }

    /// Returns the instructions of a call, as the mean of `calls`, less the instructions of the loop.
    pub(crate) fn count(&self, calls: u32, mut function: impl FnMut()) -> u32 {
        let mut run = |calls: u32| {
            let start = SYST::get_current();
            for _ in 0..calls {
                function();
            }
            start.wrapping_sub(SYST::get_current()) & TICKS
        };
        // The first call may prepare something.
        run(1);
        run(calls) * INSTRUCTIONS / calls
    }
}
