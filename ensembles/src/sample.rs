//! Samples of uncertain parameters.

mod design;

use std::sync::OnceLock;

use lagrangian::nalgebra::{Cholesky, DMatrix, SMatrix, SVector};

use crate::column::Column;
use crate::error::Error;
use crate::normal;
use crate::parameter::Parameter;
use crate::points::Points;
use design::{Design, Prepared};

/// A sample of uncertain parameters.
///
/// By default the values are independent pseudo-random numbers. [`latin_hypercube`](Self::latin_hypercube),
/// [`sobol`](Self::sobol) and [`halton`](Self::halton) spread them more evenly. Each member depends on the seed and its
/// index alone, in a Latin hypercube also on their number.
///
/// ```
/// use lagrangian_ensembles::{Parameter, Points, Sample};
///
/// let sample = Sample::new(1024, [Parameter::uniform("m", 1.0, 2.0), Parameter::normal("l", 0.4, 0.01)]).sobol();
/// let masses = (0..sample.count()).map(|index| sample.point(index)[0]);
/// assert!((masses.sum::<f64>() / 1024.0 - 1.5).abs() < 1e-3);
/// ```
#[derive(Clone, Debug)]
pub struct Sample<const D: usize> {
    count: usize,
    parameters: [Parameter; D],
    design: Design,
    seed: u64,
    correlation: Option<Correlation>,
    prepared: OnceLock<Prepared>,
}

/// A correlation matrix.
#[derive(Clone, Debug)]
struct Correlation {
    matrix: DMatrix<f64>,
    /// L of the matrix L Lᵀ; `None` if it is not positive definite.
    factor: Option<DMatrix<f64>>,
}

impl<const D: usize> Sample<D> {
    /// Creates a sample of independent pseudo-random values (`ChaCha8`, one stream a member) with seed 0.
    #[must_use]
    pub fn new(count: usize, parameters: [Parameter; D]) -> Self {
        Self {
            count,
            parameters,
            design: Design::Random,
            seed: 0,
            correlation: None,
            prepared: OnceLock::new(),
        }
    }

    /// Creates a sample of a multivariate normal distribution.
    ///
    /// ```
    /// use lagrangian::nalgebra::{Matrix2, Vector2};
    /// use lagrangian_ensembles::{Column, Sample};
    ///
    /// let covariance = Matrix2::new(4.0, 1.0, 1.0, 9.0);
    /// let columns = [Column::new("x").unit("m"), Column::new("y").unit("m")];
    /// let starts = Sample::multivariate_normal(1000, columns, Vector2::new(1.0, 2.0), covariance);
    /// ```
    #[must_use]
    pub fn multivariate_normal(
        count: usize,
        columns: [Column; D],
        mean: SVector<f64, D>,
        covariance: SMatrix<f64, D, D>,
    ) -> Self {
        let deviations = covariance.diagonal().map(f64::sqrt);
        let mut index = 0;
        let parameters = columns.map(|column| {
            let parameter = Parameter::normal(column.name, mean[index], deviations[index]);
            index += 1;
            parameter.unit(column.unit)
        });
        let correlation = SMatrix::from_fn(|i, j| {
            let scale = deviations[i] * deviations[j];
            if i == j {
                1.0
            } else if covariance[(i, j)] == 0.0 {
                0.0
            } else {
                covariance[(i, j)] / scale
            }
        });
        Self::new(count, parameters).correlated(correlation)
    }

    /// Spreads the values over a Latin hypercube: each of `count` parts of equal probability of each parameter contains
    /// one value (`McKay`, Beckman, Conover, "A comparison of three methods for selecting values of input variables",
    /// 1979). Needs 4 bytes for each value.
    #[must_use]
    pub fn latin_hypercube(self) -> Self {
        self.with_design(Design::LatinHypercube)
    }

    /// Takes the values from Sobol's sequence, with the direction numbers of Joe and Kuo ("Constructing Sobol sequences
    /// with better two-dimensional projections", 2008), with a random digital shift, an exclusive or, drawn from the seed. It has at most 1000
    /// parameters, and is best with 2ⁿ members.
    #[must_use]
    pub fn sobol(self) -> Self {
        self.with_design(Design::Sobol)
    }

    /// Takes the values from Halton's sequence (Halton 1960), shifted by the seed modulo 1 (Cranley, Patterson 1976). It
    /// has at most 54 parameters.
    #[must_use]
    pub fn halton(self) -> Self {
        self.with_design(Design::Halton)
    }

    fn with_design(self, design: Design) -> Self {
        Self {
            design,
            prepared: OnceLock::new(),
            ..self
        }
    }

    /// Sets the seed.
    #[must_use]
    pub fn seed(self, seed: u64) -> Self {
        Self {
            seed,
            prepared: OnceLock::new(),
            ..self
        }
    }

    /// Correlates the parameters: the correlation matrix is that of their normal scores, and thus their own if their
    /// distributions are normal (Gaussian copula; Nelsen, "An Introduction to Copulas", 2006).
    #[must_use]
    pub fn correlated(self, correlation: SMatrix<f64, D, D>) -> Self {
        let matrix = DMatrix::from_column_slice(D, D, correlation.as_slice());
        let factor = Cholesky::new(matrix.clone()).map(|factors| factors.l());
        Self {
            correlation: Some(Correlation { matrix, factor }),
            ..self
        }
    }
}

impl<const D: usize> Points for Sample<D> {
    type Point = [f64; D];

    fn count(&self) -> usize {
        self.count
    }

    /// Returns the values of a member; NaN if the sample is invalid ([`check`](Points::check)).
    fn point(&self, index: usize) -> [f64; D] {
        let prepared = self
            .prepared
            .get_or_init(|| self.design.prepare(self.count, D, self.seed));
        let mut probabilities = [f64::NAN; D];
        prepared.probabilities(index, &mut probabilities);
        let parameters = self.parameters.iter();
        let Some(Correlation { factor, .. }) = &self.correlation else {
            for (value, parameter) in probabilities.iter_mut().zip(parameters) {
                *value = parameter.quantile(*value);
            }
            return probabilities;
        };
        let scores = probabilities.map(normal::quantile);
        for ((row, value), parameter) in probabilities.iter_mut().enumerate().zip(parameters) {
            let products = scores.iter().enumerate().take(row + 1);
            let score = factor.as_ref().map_or(f64::NAN, |factor| {
                products
                    .map(|(column, score)| factor[(row, column)] * score)
                    .sum()
            });
            *value = parameter.at_score(score);
        }
        probabilities
    }

    fn columns(&self) -> Vec<Column> {
        let parameters = self.parameters.iter();
        parameters
            .map(|parameter| parameter.column.clone())
            .collect()
    }

    fn values(&self, point: &[f64; D]) -> Vec<f64> {
        point.to_vec()
    }

    fn description(&self) -> String {
        let parameters: Vec<String> = self.parameters.iter().map(Parameter::to_string).collect();
        let correlation = match &self.correlation {
            Some(correlation) => format!(", correlated {:?}", correlation.matrix.as_slice()),
            None => String::new(),
        };
        format!(
            "{} of {}, seed {}: {}{correlation}",
            self.design,
            self.count,
            self.seed,
            parameters.join(", ")
        )
    }

    fn check(&self) -> Result<(), Error> {
        self.parameters.iter().try_for_each(Parameter::check)?;
        self.design.check(self.count, D)?;
        let Some(Correlation { matrix, factor }) = &self.correlation else {
            return Ok(());
        };
        let has_unit_diagonal = matrix
            .diagonal()
            .iter()
            .all(|one| (one - 1.0).abs() < 1e-12);
        let is_symmetric = (matrix - matrix.transpose()).amax() < 1e-12;
        if factor.is_some() && has_unit_diagonal && is_symmetric {
            return Ok(());
        }
        Err(Error::Points(
            "a correlation matrix has to be symmetric and positive definite with ones on its diagonal, a covariance matrix symmetric and \
             positive definite"
                .to_owned(),
        ))
    }
}
