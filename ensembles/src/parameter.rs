//! Uncertain parameters.

use std::fmt;
use std::sync::Arc;

use statrs::distribution::ContinuousCDF;

use crate::column::Column;
use crate::error::Error;
use crate::normal;

/// An uncertain parameter of a [`Sample`](crate::Sample): its name, its unit and its distribution.
#[derive(Clone, Debug)]
pub struct Parameter {
    pub(crate) column: Column,
    distribution: Distribution,
}

#[derive(Clone)]
enum Distribution {
    Uniform(f64, f64),
    /// The mean and the standard deviation.
    Normal(f64, f64),
    /// The quantile function and its description.
    Other(Arc<Quantile>, String),
}

type Quantile = dyn Fn(f64) -> f64 + Send + Sync;

impl Parameter {
    /// Creates a parameter that is uniformly distributed between two bounds.
    pub fn uniform(name: impl Into<String>, low: f64, high: f64) -> Self {
        Self::of(name, Distribution::Uniform(low, high))
    }

    /// Creates a normally distributed parameter.
    pub fn normal(name: impl Into<String>, mean: f64, standard_deviation: f64) -> Self {
        Self::of(name, Distribution::Normal(mean, standard_deviation))
    }

    /// Creates a parameter with any continuous distribution of the crate [`statrs`]. Its quantiles may differ in their last
    /// digits from one platform to another; the quantiles of [`uniform`](Self::uniform) and [`normal`](Self::normal) do not.
    ///
    /// ```
    /// use lagrangian_ensembles::{Parameter, statrs::distribution::LogNormal};
    ///
    /// let friction = Parameter::distributed("friction", LogNormal::new(-1.0, 0.3)?);
    /// # Ok::<(), lagrangian_ensembles::statrs::distribution::LogNormalError>(())
    /// ```
    pub fn distributed<D>(name: impl Into<String>, distribution: D) -> Self
    where
        D: ContinuousCDF<f64, f64> + fmt::Debug + Send + Sync + 'static,
    {
        let description = format!("{distribution:?}");
        let quantile = Arc::new(move |probability| distribution.inverse_cdf(probability));
        Self::of(name, Distribution::Other(quantile, description))
    }

    fn of(name: impl Into<String>, distribution: Distribution) -> Self {
        Self {
            column: Column::new(name),
            distribution,
        }
    }

    /// Sets the unit, as text.
    #[must_use]
    pub fn unit(mut self, unit: impl Into<String>) -> Self {
        self.column = self.column.unit(unit);
        self
    }

    /// Returns the value below which a part `probability` of the distribution lies; NaN unless this is between 0 and 1.
    #[must_use]
    pub fn quantile(&self, probability: f64) -> f64 {
        match &self.distribution {
            Distribution::Uniform(low, high) => low * (1.0 - probability) + high * probability,
            Distribution::Normal(..) => self.at_score(normal::quantile(probability)),
            Distribution::Other(..) if !(0.0..=1.0).contains(&probability) => f64::NAN,
            Distribution::Other(quantile, _) => quantile(probability),
        }
    }

    /// Returns the value whose probability the standard normal distribution has at `score`.
    pub(crate) fn at_score(&self, score: f64) -> f64 {
        match self.distribution {
            Distribution::Normal(mean, deviation) => mean + deviation * score,
            _ if score.is_nan() => f64::NAN,
            _ => self.quantile(normal::probability(score)),
        }
    }

    pub(crate) fn check(&self) -> Result<(), Error> {
        let name = &self.column.name;
        let complaint = match self.distribution {
            Distribution::Uniform(low, high) if !(low <= high && (high - low).is_finite()) => {
                format!(
                    "the bounds of `{name}` are {low} and {high}; they have to be finite, the lower one first"
                )
            }
            Distribution::Normal(mean, deviation)
                if !(mean.is_finite() && deviation.is_finite() && deviation >= 0.0) =>
            {
                format!(
                    "the mean of `{name}` is {mean} and its standard deviation {deviation}; both have to be finite, and the deviation not \
                     negative"
                )
            }
            _ => return Ok(()),
        };
        Err(Error::Points(complaint))
    }
}

impl fmt::Debug for Distribution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Uniform(low, high) => write!(f, "uniform({low:?}, {high:?})"),
            Self::Normal(mean, deviation) => write!(f, "normal({mean:?}, {deviation:?})"),
            Self::Other(_, description) => f.write_str(description),
        }
    }
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {:?}", self.column.name, self.distribution)
    }
}
