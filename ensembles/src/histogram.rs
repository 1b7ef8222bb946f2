//! Histograms.

use crate::column::Bins;

/// The numbers of values in bins of one width.
///
/// A [`Summary`](crate::Summary) contains one for each column for which [`Column::histogram`](crate::Column::histogram)
/// was called.
#[derive(Clone, Debug, PartialEq)]
pub struct Histogram {
    bins: Bins,
    counts: Vec<u64>,
    below: u64,
    above: u64,
}

impl Histogram {
    pub(crate) fn new(bins: Bins) -> Self {
        Self {
            bins,
            counts: vec![0; bins.count],
            below: 0,
            above: 0,
        }
    }

    /// Adds a value. A bin contains its lower edge; the last one contains its upper edge, too.
    #[allow(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss
    )] // The place is in range.
    pub(crate) fn add(&mut self, value: f64) {
        let Bins { low, high, count } = self.bins;
        if value < low {
            self.below += 1;
        } else if value > high {
            self.above += 1;
        } else {
            let place = (value - low) / (high - low) * count as f64;
            if let Some(bin) = self.counts.get_mut((place as usize).min(count.max(1) - 1)) {
                *bin += 1;
            }
        }
    }

    pub(crate) fn merge(&mut self, other: &Self) {
        for (count, other) in self.counts.iter_mut().zip(&other.counts) {
            *count += other;
        }
        self.below += other.below;
        self.above += other.above;
    }

    /// Returns the number of values in each bin.
    #[must_use]
    pub fn counts(&self) -> &[u64] {
        &self.counts
    }

    /// Returns the edges of the bins, one more than there are bins.
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // Nobody has 2⁵³ bins.
    pub fn edges(&self) -> Vec<f64> {
        let Bins { low, high, count } = self.bins;
        let part = |edge: usize| edge as f64 / count as f64;
        (0..=count)
            .map(|edge| low * (1.0 - part(edge)) + high * part(edge))
            .collect()
    }

    /// Returns the number of values below the first bin.
    #[must_use]
    pub fn below(&self) -> u64 {
        self.below
    }

    /// Returns the number of values above the last bin.
    #[must_use]
    pub fn above(&self) -> u64 {
        self.above
    }
}
