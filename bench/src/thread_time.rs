//! CPU time: the clock on the wall says little where other programs run.

use cpu_time::ThreadTime;

/// What a computation returns, and the fewest seconds of CPU time of this thread that it took, when it is
/// repeated until it has taken so many seconds together.
///
/// # Errors
///
/// The first error of the computation.
pub fn fewest_seconds<T>(
    at_least: f64,
    mut computation: impl FnMut() -> Result<T, String>,
) -> Result<(T, f64), String> {
    let (mut fewest, mut together) = (f64::INFINITY, 0.0);
    loop {
        let start = ThreadTime::now();
        let result = computation()?;
        let seconds = start.elapsed().as_secs_f64();
        fewest = fewest.min(seconds);
        together += seconds;
        if together >= at_least {
            return Ok((result, fewest));
        }
    }
}
