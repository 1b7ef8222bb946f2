//! Taylor series of elementary functions, from the differential equations that they satisfy (Knuth, The Art of
//! Computer Programming, volume 2, 3rd edition 1997, section 4.7; Griewank and Walther, Evaluating Derivatives, 2nd
//! edition 2008, table 13.2).
//!
//! With D = t d/dt, whose coefficients are k xₖ, an equation such as Dw = g Dx gives
//! k wₖ = g₀ k xₖ + Σ₀﹤ᵢ﹤ₖ gₖ₋ᵢ i xᵢ: the g that it needs are of orders below k.

use super::builder::Builder;
use super::series::{Factor, Pair, Series, ZERO};
use crate::program::straight_line::{Operand, Operation};
use crate::{Binary, Rational, Unary};

impl Builder<'_> {
    /// The coefficients of sin x and cos x.
    pub(super) fn sine_and_cosine(&mut self, x: &Series, results: &[Operand]) -> Vec<Operand> {
        let [sine, cosine] = [&results[0], &results[1]];
        let pair = self.pair(Pair::SineCosine, x, [sine.clone(), cosine.clone()]);
        pair.map(|series| series.coefficient).to_vec()
    }

    /// The coefficient of a function of one argument, whose value is `result`.
    pub(super) fn unary(&mut self, function: Unary, x: &Series, result: &Operand) -> Operand {
        let (pair, partner, index) = match function {
            Unary::Sin => (Pair::SineCosine, Unary::Cos, 0),
            Unary::Cos => (Pair::SineCosine, Unary::Sin, 1),
            Unary::Sinh => (Pair::HyperbolicSineCosine, Unary::Cosh, 0),
            Unary::Cosh => (Pair::HyperbolicSineCosine, Unary::Sinh, 1),
            _ => return self.unpaired(function, x, result),
        };
        let partner = self.initial_value(partner, &x.constant);
        let constants = if index == 0 {
            [result.clone(), partner]
        } else {
            [partner, result.clone()]
        };
        let series = self.pair(pair, x, constants);
        series[index].coefficient.clone()
    }

    fn unpaired(&mut self, function: Unary, x: &Series, result: &Operand) -> Operand {
        match function {
            Unary::Tan => self.tangent(x, result, false),
            Unary::Tanh => match self.known_secant(x) {
                Some([_, tangent]) => tangent.coefficient,
                None => self.tangent(x, result, true),
            },
            Unary::Sech => self.secant(x, result)[0].coefficient.clone(),
            Unary::Exp => self.exponential(x, result),
            Unary::Ln => self.logarithm(x),
            Unary::Logistic => self.logistic(x, result).coefficient,
            Unary::Softplus => self.softplus(x),
            Unary::LogCosh => self.log_cosh(x),
            Unary::Atan => self.inverse_tangent(x, false),
            Unary::Atanh => self.inverse_tangent(x, true),
            Unary::Asin => self.inverse_sine(x, result, Unary::Cos),
            Unary::Acos => self.inverse_sine(x, result, Unary::Sin),
            Unary::Asinh => self.inverse_sine(x, result, Unary::Cosh),
            Unary::Acosh => self.inverse_sine(x, result, Unary::Sinh),
            Unary::Abs => {
                let sign = self.initial_value(Unary::Signum, &x.constant);
                let sign = self.invariant(&sign);
                self.multiply(&sign, &x.coefficient)
            }
            // The paired ones have been answered; a sign is constant.
            Unary::Signum | Unary::Sin | Unary::Cos | Unary::Sinh | Unary::Cosh => ZERO,
        }
    }

    /// The coefficient of a function of two arguments, whose value is `result`.
    pub(super) fn binary(
        &mut self,
        function: Binary,
        x: &Series,
        y: &Series,
        result: &Operand,
    ) -> Operand {
        match function {
            Binary::Atan2 => self.angle(x, y),
            Binary::Power if y.varies() => self.general_power(x, y, result),
            Binary::Power => self.power(x, y, result),
            Binary::Min => self.extremum(x, y, false),
            Binary::Max => self.extremum(x, y, true),
            // A constant, as long as the series holds.
            Binary::Scale => ZERO,
        }
    }

    /// Ds = c Dx and Dc = ∓s Dx, with the sign − for circular and + for hyperbolic functions.
    fn pair(&mut self, pair: Pair, x: &Series, constants: [Operand; 2]) -> [Series; 2] {
        let known = self.pairs.iter();
        let mut known = known.filter(|(of, argument, _)| (*of, argument) == (pair, &x.constant));
        if let Some((.., series)) = known.next() {
            return series.clone();
        }
        let change = self.times_order(&x.coefficient);
        let of_change = self.factor(&change);
        let factors = [self.unknown_factor(), self.unknown_factor()];
        let mut coefficients = [1, 0].map(|other: usize| {
            let sum = self.convolve(of_change, factors[other]);
            let initial = self.invariant(&constants[other]);
            let last = self.multiply(&change, &initial);
            let sum = self.add(&sum, &last);
            self.over_order(&sum)
        });
        if pair == Pair::SineCosine {
            coefficients[1] = self.negate(&coefficients[1].clone());
        }
        for (factor, coefficient) in factors.iter().zip(&coefficients) {
            self.define(*factor, coefficient);
        }
        let [sine, cosine] = coefficients;
        let [first, second] = constants;
        let series = [
            Series {
                constant: first,
                coefficient: sine,
            },
            Series {
                constant: second,
                coefficient: cosine,
            },
        ];
        self.pairs.push((pair, x.constant.clone(), series.clone()));
        series
    }

    /// Σ₀﹤ᵢ≤ₖ gₖ₋ᵢ i xᵢ, the coefficient of g Dx.
    pub(super) fn times_change(
        &mut self,
        factor: Factor,
        constant: &Operand,
        x: &Operand,
    ) -> Operand {
        let change = self.times_order(x);
        let of_change = self.factor(&change);
        let sum = self.convolve(factor, of_change);
        let initial = self.invariant(constant);
        let last = self.multiply(&initial, &change);
        self.add(&sum, &last)
    }

    /// Dw = g Dx with g = 1 ± w², where g = 1/cosh² x for tanh is free of cancellation.
    fn tangent(&mut self, x: &Series, result: &Operand, hyperbolic: bool) -> Operand {
        let function = if hyperbolic { Unary::Cosh } else { Unary::Cos };
        let cosine = self.initial_value(function, &x.constant);
        let square = self.initial_product(&cosine, &cosine);
        let one = Operand::Constant(Rational::ONE);
        let constant = self.initial.emit(Operation::Divide(one, square));
        let g = self.unknown_factor();
        let sum = self.times_change(g, &constant, &x.coefficient);
        let coefficient = self.over_order(&sum);
        let w = Series {
            constant: result.clone(),
            coefficient: coefficient.clone(),
        };
        let mut square = self.product(&w, &w);
        if hyperbolic {
            square = self.negate(&square);
        }
        self.define(g, &square);
        coefficient
    }

    /// Dw = w Dx.
    fn exponential(&mut self, x: &Series, result: &Operand) -> Operand {
        let w = self.unknown_factor();
        let sum = self.times_change(w, result, &x.coefficient);
        let coefficient = self.over_order(&sum);
        self.define(w, &coefficient);
        coefficient
    }

    /// The coefficient of Dw from g Dw = Dx, which needs g up to order k − 1, and the factor that it is.
    fn inverse(&mut self, g: Factor, constant: &Operand, change: &Operand) -> (Operand, Factor) {
        let reciprocal = self.reciprocal(constant);
        self.inverse_by(g, &reciprocal, change)
    }

    /// The same, where 1/g₀ is given.
    fn inverse_by(
        &mut self,
        g: Factor,
        reciprocal: &Operand,
        change: &Operand,
    ) -> (Operand, Factor) {
        let of_result = self.unknown_factor();
        let sum = self.convolve(of_result, g);
        let rest = self.subtract(change, &sum);
        let derivative = self.multiply(&rest, reciprocal);
        self.define(of_result, &derivative);
        (derivative, of_result)
    }

    /// x Dw = Dx.
    fn logarithm(&mut self, x: &Series) -> Operand {
        let change = self.times_order(&x.coefficient);
        let of_x = self.factor(&x.coefficient);
        let (derivative, _) = self.inverse(of_x, &x.constant, &change);
        self.over_order(&derivative)
    }

    /// (1 ± x²) Dw = Dx, where 1 − x² = (1 − x)(1 + x).
    fn inverse_tangent(&mut self, x: &Series, hyperbolic: bool) -> Operand {
        let one = Operand::Constant(Rational::ONE);
        let constant = if hyperbolic {
            let difference = self.complement(&x.constant);
            let sum = self.initial.emit(Operation::Add(one, x.constant.clone()));
            self.initial_product(&difference, &sum)
        } else {
            let square = self.initial_product(&x.constant, &x.constant);
            self.initial.emit(Operation::Add(one, square))
        };
        let mut square = self.product(x, x);
        if hyperbolic {
            square = self.negate(&square);
        }
        let g = self.factor(&square);
        let change = self.times_order(&x.coefficient);
        let (derivative, _) = self.inverse(g, &constant, &change);
        self.over_order(&derivative)
    }

    /// x = sin w, cos w, sinh w or cosh w: Dx = ±c Dw, where c, the other function of w, has Dc = ±x Dw.
    fn inverse_sine(&mut self, x: &Series, result: &Operand, derivative: Unary) -> Operand {
        // The derivative of the cosine is −sin w, whose derivative is −x; for a cosine take w to be −w.
        let constant = self.initial_value(derivative, result);
        let change = self.times_order(&x.coefficient);
        let change = if derivative == Unary::Sin {
            self.negate(&change)
        } else {
            change
        };
        let c = self.unknown_factor();
        let (derivative_of_result, of_result) = self.inverse(c, &constant, &change);
        let of_x = self.factor(&x.coefficient);
        let sum = self.convolve(of_x, of_result);
        let initial = self.invariant(&x.constant);
        let last = self.multiply(&initial, &derivative_of_result);
        let sum = self.add(&sum, &last);
        let mut of_c = self.over_order(&sum);
        if derivative == Unary::Cos {
            of_c = self.negate(&of_c);
        }
        self.define(c, &of_c);
        self.over_order(&derivative_of_result)
    }

    /// x Dw = c w Dx for w = xᶜ. Where x is 0, this equation says nothing: the terms are those of 1, x, x² and x³ for
    /// these exponents, and higher ones count as 0 for others, as for a square root.
    fn power(&mut self, x: &Series, exponent: &Series, result: &Operand) -> Operand {
        let w = self.unknown_factor();
        let product = self.times_change(w, result, &x.coefficient);
        let of_exponent = self.invariant(&exponent.constant);
        let change = self.multiply(&of_exponent, &product);
        let of_x = self.factor(&x.coefficient);
        let reciprocal = self.reciprocal_or_zero(&x.constant);
        let (derivative, _) = self.inverse_by(of_x, &reciprocal, &change);
        let mut coefficient = self.over_order(&derivative);
        if !matches!(exponent.constant, Operand::Constant(_) | Operand::Pi) {
            let at_zero = self.power_at_zero(x, exponent);
            coefficient = self.add(&coefficient, &at_zero);
        }
        self.define(w, &coefficient);
        coefficient
    }

    /// The coefficient of x, x² or x³ where x is 0 and the exponent 1, 2 or 3; 0 elsewhere.
    fn power_at_zero(&mut self, x: &Series, exponent: &Series) -> Operand {
        let vanishes = self.is_zero(&x.constant);
        let vanishes = self.invariant(&vanishes);
        // It has no term of order 0; powers of a large x would overflow.
        let y = self.multiply(&vanishes, &x.coefficient);
        let of_y = self.factor(&y);
        let square = self.convolve(of_y, of_y);
        let of_square = self.factor(&square);
        let cube = self.convolve(of_square, of_y);
        let mut sum = ZERO;
        for (n, power) in (1..).zip([y, square, cube]) {
            let whole = Operand::Constant(Rational::integer(n));
            let difference = Operation::Subtract(exponent.constant.clone(), whole);
            let difference = self.initial.emit(difference);
            let weight = self.is_zero(&difference);
            let weight = self.invariant(&weight);
            let term = self.multiply(&weight, &power);
            sum = self.add(&sum, &term);
        }
        sum
    }

    /// 1 where a term of order 0 is 0, and 0 elsewhere.
    fn is_zero(&mut self, constant: &Operand) -> Operand {
        let sign = self.initial_value(Unary::Signum, constant);
        let square = self.initial_product(&sign, &sign);
        self.complement(&square)
    }

    /// w = exp(y ln x).
    fn general_power(&mut self, x: &Series, y: &Series, result: &Operand) -> Operand {
        let constant = self.initial_value(Unary::Ln, &x.constant);
        let coefficient = if x.varies() { self.logarithm(x) } else { ZERO };
        let logarithm = Series {
            constant,
            coefficient,
        };
        let coefficient = self.product(y, &logarithm);
        let constant = self.initial_product(&y.constant, &logarithm.constant);
        let exponent = Series {
            constant,
            coefficient,
        };
        self.exponential(&exponent, result)
    }

    /// (x² + y²) Dw = x Dy − y Dx for the angle w of the point (x, y), both times a power of two, by which the squares are
    /// neither too small nor too large.
    fn angle(&mut self, y: &Series, x: &Series) -> Operand {
        let [y, x] = &self.scaled_together([y, x]);
        let constants = [&y.constant, &x.constant];
        let squares = constants.map(|constant| self.initial_product(constant, constant));
        let constant = self.symmetric(Operation::Add, squares);
        let squares = [y, x].map(|series| self.product(series, series));
        let square = self.add(&squares[0], &squares[1]);
        let changes = [(x, y), (y, x)].map(|(factor, of)| {
            if !of.varies() {
                return ZERO;
            }
            if factor.varies() {
                let of_factor = self.factor(&factor.coefficient);
                return self.times_change(of_factor, &factor.constant, &of.coefficient);
            }
            let change = self.times_order(&of.coefficient);
            let initial = self.invariant(&factor.constant);
            self.multiply(&initial, &change)
        });
        let change = self.subtract(&changes[0], &changes[1]);
        let g = self.factor(&square);
        let (derivative, _) = self.inverse(g, &constant, &change);
        self.over_order(&derivative)
    }

    /// Two series times the scale of their terms of order 0.
    fn scaled_together(&mut self, series: [&Series; 2]) -> [Series; 2] {
        let constants = series.map(|series| series.constant.clone());
        let scale = |x, y| Operation::Binary(Binary::Scale, x, y);
        let scale = self.symmetric(scale, constants);
        let of_recurrence = self.invariant(&scale);
        series.map(|series| Series {
            constant: self.initial_product(&series.constant, &scale),
            coefficient: self.multiply(&of_recurrence, &series.coefficient),
        })
    }

    /// a xₖ + b yₖ with the weights 1 and 0 of what is greater or lesser, ½ and ½ where both are equal.
    fn extremum(&mut self, x: &Series, y: &Series, greater: bool) -> Operand {
        let difference = Operation::Subtract(x.constant.clone(), y.constant.clone());
        let difference = self.initial.emit(difference);
        let sign = self.initial_value(Unary::Signum, &difference);
        let half = || Operand::Constant(Rational::HALF.clone());
        let part = self.initial_product(&half(), &sign);
        let more = self.initial.emit(Operation::Add(half(), part.clone()));
        let less = self.initial.emit(Operation::Subtract(half(), part));
        let weights = if greater { [more, less] } else { [less, more] };
        let [first, second] = weights.map(|weight| self.invariant(&weight));
        let terms = [
            self.multiply(&first, &x.coefficient),
            self.multiply(&second, &y.coefficient),
        ];
        self.add(&terms[0], &terms[1])
    }
}
