//! The accuracy to which a motion satisfies its energy balance.
//!
//! Integrals are computed step by step by Gauss's formula with ten points (Abramowitz and Stegun, Handbook of
//! Mathematical Functions, 1964, table 25.4).

#[cfg(feature = "alloc")]
use super::{energy_balance::EnergyBalance, lagrangian::Lagrangian, phase::Phase};
#[cfg(feature = "alloc")]
use crate::integrate::{DenseSolution, IntegrationError, Interpolant, Solution};

/// The residual of the energy balance along a motion, h(t) − h(0) − ∫ (Q·q̇ − ∂L/∂t) dt, which vanishes except for the
/// errors of the method.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct EnergyResidual {
    /// The residual of the largest magnitude at the end of a step.
    pub largest: f64,
    /// The time at which it was reached.
    pub time: f64,
    /// The residual at the end.
    pub last: f64,
    /// ∫ |Q·q̇ − ∂L/∂t| dt, with which the residual may be compared.
    pub exchanged: f64,
}

/// The nodes and weights on one side of the midpoint.
const GAUSS: [(f64, f64); 5] = [
    (0.148_874_338_981_631_21, 0.295_524_224_714_752_87),
    (0.433_395_394_129_247_2, 0.269_266_719_309_996_35),
    (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
    (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
];

impl EnergyResidual {
    /// Adds a step from `start` to `end`, over which the energy changes by `change`; `rate` is the expected rate of
    /// change as a function of time.
    ///
    /// # Errors
    ///
    /// The errors of `rate`.
    pub fn add_step<E>(
        &mut self,
        (start, end): (f64, f64),
        change: f64,
        rate: impl Fn(f64) -> Result<f64, E>,
    ) -> Result<(), E> {
        let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
        let (mut total, mut exchanged) = (0.0, 0.0);
        for (node, weight) in GAUSS {
            for side in [-1.0, 1.0] {
                let rate = rate(middle + side * node * half)?;
                total += weight * rate;
                exchanged += weight * rate.abs();
            }
        }
        self.last += change - half * total;
        self.exchanged += half.abs() * exchanged;
        // NaN counts as larger than any number.
        if self.last.is_nan() || self.last.abs() > self.largest.abs() {
            (self.largest, self.time) = (self.last, end);
        }
        Ok(())
    }

    /// Computes the residual along a solution by any method. If a reaction to an event changes the state, the jump of
    /// the energy is not part of the residual.
    ///
    /// # Errors
    ///
    /// There are none for the times of the solution itself.
    #[cfg(feature = "alloc")]
    pub fn along<M, P, const N: usize>(
        model: &M,
        solution: &Solution<f64, Phase<f64, N>, DenseSolution<Phase<f64, N>, P>>,
    ) -> Result<Self, IntegrationError>
    where
        M: Lagrangian<N, Model: EnergyBalance<N>>,
        P: Interpolant<f64, Phase<f64, N>>,
    {
        let mut residual = Self::default();
        let mut start = None;
        for end in solution.times() {
            if let Some(start) = start {
                let (before, after) = (solution.before(end)?, solution.at(start)?);
                let change = model.energy(&before) - model.energy(&after);
                residual.add_step((start, end), change, |t| {
                    Ok::<_, IntegrationError>(model.energy_rate(&solution.at(t)?))
                })?;
            }
            start = Some(end);
        }
        Ok(residual)
    }
}
