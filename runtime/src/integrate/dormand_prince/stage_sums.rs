//! The sums of stages, column by column. As soon as a stage is known, its multiples are added to the sums for all later
//! stages, for the step and for the error, so that each stage is loaded once.

use super::STAGES;
use super::coefficients::{FIFTH_ORDER_ERROR, MATRIX, THIRD_ORDER, WEIGHTS};
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The sums for the stages after the first, the slope of the step, and two estimates of its error.
const SUMS: usize = STAGES + 2;

/// For each stage, the sums that it is part of, with its coefficients.
const COLUMNS: [Column; STAGES] = columns();

/// The terms that a stage contributes.
#[derive(Clone, Copy)]
struct Column {
    terms: [(usize, f64); SUMS],
    length: usize,
}

const fn columns() -> [Column; STAGES] {
    let empty = Column {
        terms: [(0, 0.0); SUMS],
        length: 0,
    };
    let mut columns = [empty; STAGES];
    let mut stage = 0;
    while stage < STAGES {
        let mut sum = stage;
        while sum < SUMS {
            let coefficient = coefficient(sum, stage);
            if coefficient != 0.0 {
                let column = &mut columns[stage];
                column.terms[column.length] = (sum, coefficient);
                column.length += 1;
            }
            sum += 1;
        }
        stage += 1;
    }
    columns
}

/// Returns the coefficient of a stage in a sum that it may be part of.
const fn coefficient(sum: usize, stage: usize) -> f64 {
    if sum + 1 < STAGES {
        MATRIX[sum + 1][stage]
    } else if sum + 1 == STAGES {
        WEIGHTS[stage]
    } else if sum == STAGES {
        FIFTH_ORDER_ERROR[stage]
    } else {
        WEIGHTS[stage] - THIRD_ORDER[stage]
    }
}

/// The sums over the stages that are known.
pub(super) struct StageSums<X>([X; SUMS]);

impl<X> StageSums<X> {
    /// Returns the multiples of the first stage.
    #[inline]
    pub(super) fn new<S: Scalar>(first: &X) -> Self
    where
        X: VectorSpace<S>,
    {
        // The first stage is part of all sums. They are written out, because a map over such a long array is not
        // inlined.
        let sum = |index: usize| {
            let coefficient = S::from_f64(COLUMNS[0].terms[index].1);
            first.map(|component| component * coefficient)
        };
        Self([
            sum(0),
            sum(1),
            sum(2),
            sum(3),
            sum(4),
            sum(5),
            sum(6),
            sum(7),
            sum(8),
            sum(9),
            sum(10),
            sum(11),
            sum(12),
            sum(13),
        ])
    }

    /// Adds the multiples of another stage.
    #[inline]
    pub(super) fn add<S: Scalar>(&mut self, stage: usize, derivative: &X)
    where
        X: VectorSpace<S>,
    {
        let column = COLUMNS.get(stage);
        if let Some(terms) = column.and_then(|column| column.terms.get(..column.length)) {
            derivative.add_multiples(terms, &mut self.0);
        }
    }

    /// Returns Σⱼ aᵢⱼ kⱼ for a stage after the first; for the index `STAGES`, the slope Σ bⱼ kⱼ of the step.
    #[inline]
    pub(super) fn slope(&self, stage: usize) -> &X {
        &self.0[stage - 1]
    }

    /// Returns the error estimates of orders 5 and 3, divided by the step size.
    #[inline]
    pub(super) fn errors(&self) -> [&X; 2] {
        [&self.0[STAGES], &self.0[STAGES + 1]]
    }
}

const _: () = assert!(COLUMNS[0].length == SUMS);

#[cfg(test)]
mod tests {
    use super::super::coefficients::{FIFTH_ORDER_ERROR, MATRIX, THIRD_ORDER, WEIGHTS};
    use super::{STAGES, StageSums};
    use crate::integrate::runge_kutta::combination;
    use crate::model::Phase;

    fn stage(index: usize) -> Phase<f64, 3> {
        let component = |shift: u32| {
            let argument = f64::from(u32::try_from(index).unwrap_or(0) * 7 + shift);
            libm::sin(argument * argument)
        };
        Phase::new([1, 2, 3].map(component), [4, 5, 6].map(component))
    }

    #[test]
    fn columns_add_up_to_rows() {
        let stages: [_; STAGES] = core::array::from_fn(stage);
        let zero = Phase::new([0.0; 3], [0.0; 3]);
        let mut sums = StageSums::new(&stages[0]);
        for (i, derivative) in stages.iter().enumerate().skip(1) {
            assert_eq!(sums.slope(i), &combination(MATRIX[i], &stages, &zero));
            sums.add(i, derivative);
        }
        assert_eq!(sums.slope(STAGES), &combination(&WEIGHTS, &stages, &zero));
        let [fifth, third] = sums.errors();
        assert_eq!(fifth, &combination(&FIFTH_ORDER_ERROR, &stages, &zero));
        let [weights, embedded] =
            [WEIGHTS, THIRD_ORDER].map(|row| combination(&row, &stages, &zero));
        let differences = weights.q - embedded.q - third.q;
        let rates = weights.v - embedded.v - third.v;
        assert!(differences.amax().max(rates.amax()) < 1e-14);
    }
}
