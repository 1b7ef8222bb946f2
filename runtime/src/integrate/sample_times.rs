//! The sample times in a part of an integration.

#[cfg(feature = "alloc")]
use alloc::vec::Vec;

#[cfg(feature = "alloc")]
use super::error::IntegrationError;
#[cfg(feature = "alloc")]
use super::part::Part;

/// A sequence of sample times.
pub trait SampleTimes {
    /// Returns the next time.
    fn next(&self) -> Option<f64>;

    /// Proceeds to the time after the next one.
    fn advance(&mut self);
}

/// No samples.
impl SampleTimes for () {
    #[inline]
    fn next(&self) -> Option<f64> {
        None
    }

    #[inline]
    fn advance(&mut self) {}
}

/// A list of times, with the number of those that were taken.
#[cfg(feature = "alloc")]
#[derive(Debug)]
pub struct ListedTimes {
    times: Vec<f64>,
    taken: usize,
}

#[cfg(feature = "alloc")]
impl SampleTimes for ListedTimes {
    #[inline]
    fn next(&self) -> Option<f64> {
        self.times.get(self.taken).copied()
    }

    #[inline]
    fn advance(&mut self) {
        self.taken += 1;
    }
}

#[cfg(feature = "alloc")]
impl ListedTimes {
    /// Selects the times in a list that belong to a part which begins at `start`.
    ///
    /// # Errors
    ///
    /// If a time is outside of the integration, not finite, or before its predecessor.
    pub(crate) fn of(
        mut times: Vec<f64>,
        start: f64,
        part: Part,
    ) -> (Self, Result<(), IntegrationError>) {
        let end = part.end;
        let mut span = start.min(end)..=start.max(end);
        if part.is_one_of_several {
            // The other times belong to other parts. Numbers that are not finite and times before the start are kept,
            // so that they are refused.
            let is_before = |t: &f64| (t - part.origin) * (end - part.origin) < 0.0;
            let before = times.iter().any(|t| is_before(t) && t.is_finite());
            let is_left = |t: f64| {
                let kept = part.kept.sample;
                kept.is_none_or(|last| (t - last) * (end - last) > 0.0)
            };
            times.retain(|t| !t.is_finite() || is_before(t) || span.contains(t) && is_left(*t));
            if before {
                span = part.origin.min(end)..=part.origin.max(end);
            }
        }
        let outside = times.iter().find(|time| !span.contains(*time));
        let checked = match outside {
            Some(&time) if time.is_finite() && end.is_finite() => {
                Err(IntegrationError::OutsideSpan {
                    time,
                    start: part.origin,
                    end,
                })
            }
            _ => check_order(&times, start, end),
        };
        (Self { times, taken: 0 }, checked)
    }
}

/// Returns an error unless the times are finite and advance in the direction from `start` to the end.
#[cfg(feature = "alloc")]
fn check_order(times: &[f64], start: f64, end: f64) -> Result<(), IntegrationError> {
    let times = times.iter().chain([&end]);
    if let Some(&time) = times.clone().find(|time| !time.is_finite()) {
        return Err(IntegrationError::NonFiniteTime { time });
    }
    let backwards = end < start;
    let mut previous = start;
    for (index, &time) in times.enumerate() {
        if (time < previous && !backwards) || (time > previous && backwards) {
            return Err(IntegrationError::UnorderedTimes {
                index,
                time,
                previous,
            });
        }
        previous = time;
    }
    Ok(())
}

/// The multiples of an interval in a part, counted from the initial time of the problem. A multiple that differs only
/// by rounding from the start, the end or the last sample of the previous part is taken to be equal to it.
#[cfg(feature = "alloc")]
#[derive(Debug)]
pub struct TimeGrid {
    origin: f64,
    interval: f64,
    /// The start and the end of the part; `multiples` has both in units of the interval.
    span: [f64; 2],
    multiples: [f64; 2],
    rounding: f64,
    /// The next multiple.
    next: f64,
}

#[cfg(feature = "alloc")]
impl TimeGrid {
    /// Returns the times in a part that begins at `start`; there are none if the interval or the end is invalid.
    pub(crate) fn of(interval: f64, start: f64, part: Part) -> Self {
        let Part { origin, end, .. } = part;
        let interval = interval.copysign(end - start);
        let multiples = [start, end].map(|t| (t - origin) / interval);
        let [first, last] = multiples;
        let rounding =
            4.0 * f64::EPSILON * (first.abs().max(last.abs()) + (origin / interval).abs());
        let kept = part.kept.sample.map(|t| (t - origin) / interval + rounding);
        let next = libm::ceil(first - rounding);
        Self {
            origin,
            interval,
            span: [start, end],
            multiples,
            rounding,
            next: kept.map_or(next, |kept| next.max(libm::floor(kept) + 1.0)),
        }
    }
}

#[cfg(feature = "alloc")]
impl SampleTimes for TimeGrid {
    #[inline]
    fn next(&self) -> Option<f64> {
        let ([start, end], [first, last]) = (self.span, self.multiples);
        // This is NaN if the end is.
        (last.is_finite() && self.next <= last + self.rounding).then(|| {
            if (self.next - last).abs() <= self.rounding {
                end
            } else if (self.next - first).abs() <= self.rounding {
                start
            } else {
                self.origin + self.next * self.interval
            }
        })
    }

    #[inline]
    fn advance(&mut self) {
        self.next += 1.0;
    }
}
