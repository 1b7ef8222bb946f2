//! Taylor series of the functions that stand for quotients and logarithms of exponentials. None of them overflows where its
//! value does not: what they are convolved with is bounded.

use super::builder::Builder;
use super::series::{Series, ZERO};
use crate::Unary;
use crate::program::straight_line::{Operand, Operation};

impl Builder<'_> {
    /// The series of sech x and tanh x, if they are known.
    pub(super) fn known_secant(&self, x: &Series) -> Option<[Series; 2]> {
        let mut known = self.secants.iter();
        let found = known.find(|(argument, _)| *argument == x.constant);
        found.map(|(_, series)| series.clone())
    }

    /// Dw = −w u Dx and Du = w² Dx for w = sech x and u = tanh x, of which neither overflows.
    pub(super) fn secant(&mut self, x: &Series, result: &Operand) -> [Series; 2] {
        if let Some(known) = self.known_secant(x) {
            return known;
        }
        let tangent = self.initial_value(Unary::Tanh, &x.constant);
        let slopes = [&tangent, result].map(|other| self.initial_product(result, other));
        let factors = [self.unknown_factor(), self.unknown_factor()];
        let mut series = [result, &tangent].map(|constant| Series {
            constant: constant.clone(),
            coefficient: ZERO,
        });
        for i in 0..2 {
            let sum = self.times_change(factors[i], &slopes[i], &x.coefficient);
            series[i].coefficient = self.over_order(&sum);
        }
        series[0].coefficient = self.negate(&series[0].coefficient.clone());
        let [secant, tangent] = &series;
        let products = [tangent, secant].map(|other| self.product(secant, other));
        for (factor, product) in factors.iter().zip(&products) {
            self.define(*factor, product);
        }
        self.secants.push((x.constant.clone(), series.clone()));
        series
    }

    /// Dw = g Dx for w = σ(x), where g = σ(x) σ(−x) = w − w² is free of cancellation, and of −Dw for σ(−x).
    pub(super) fn logistic(&mut self, x: &Series, result: &Operand) -> Series {
        let known = self.logistics.iter();
        let mut known = known.filter(|(argument, _)| *argument == x.constant);
        if let Some((_, series)) = known.next() {
            return series.clone();
        }
        let opposite = self.logistics.iter();
        let mut opposite =
            opposite.filter(|(argument, _)| self.are_opposite(argument, &x.constant));
        if let Some((_, series)) = opposite.next().cloned() {
            return Series {
                constant: result.clone(),
                coefficient: self.negate(&series.coefficient),
            };
        }
        let opposite = self.initial.emit(Operation::Negate(x.constant.clone()));
        let complement = self.initial_value(Unary::Logistic, &opposite);
        let slope = self.initial_product(result, &complement);
        let g = self.unknown_factor();
        let sum = self.times_change(g, &slope, &x.coefficient);
        let series = Series {
            constant: result.clone(),
            coefficient: self.over_order(&sum),
        };
        let square = self.product(&series, &series);
        let of_slope = self.subtract(&series.coefficient, &square);
        self.define(g, &of_slope);
        self.logistics.push((x.constant.clone(), series.clone()));
        series
    }

    /// Whether one operand of the initial program was computed as the negative of the other.
    fn are_opposite(&self, x: &Operand, y: &Operand) -> bool {
        let is_negative = |x: &Operand, y: &Operand| {
            self.initial.known(&Operation::Negate(x.clone())) == Some(y.clone())
        };
        is_negative(x, y) || is_negative(y, x)
    }

    /// Dw = tanh x Dx.
    pub(super) fn log_cosh(&mut self, x: &Series) -> Operand {
        let secant = self.initial_value(Unary::Sech, &x.constant);
        let [_, tangent] = self.secant(x, &secant);
        let factor = self.factor(&tangent.coefficient);
        let sum = self.times_change(factor, &tangent.constant, &x.coefficient);
        self.over_order(&sum)
    }

    /// Dw = σ(x) Dx.
    pub(super) fn softplus(&mut self, x: &Series) -> Operand {
        let result = self.initial_value(Unary::Logistic, &x.constant);
        let logistic = self.logistic(x, &result);
        let factor = self.factor(&logistic.coefficient);
        let sum = self.times_change(factor, &logistic.constant, &x.coefficient);
        self.over_order(&sum)
    }
}
