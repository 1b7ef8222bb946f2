//! Straight-line C, a statement for each sum of products. What is zero is never computed, and what is one multiplies nothing:
//! the code is that of someone who leaves out by hand what vanishes.

use std::fmt::Write as _;

/// A number of the program.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Value {
    Constant(f64),
    /// A variable that has been computed before.
    Variable(usize),
    /// The same with the opposite sign.
    Opposite(usize),
}

pub(super) const ZERO: Value = Value::Constant(0.0);
pub(super) const ONE: Value = Value::Constant(1.0);

/// Three components.
pub(super) type Vector = [Value; 3];

impl Value {
    fn text(self) -> String {
        match self {
            Self::Constant(x) => format!("({x:?})"),
            Self::Variable(i) => format!("v{i}"),
            Self::Opposite(i) => format!("(-v{i})"),
        }
    }
}

/// x with the opposite sign.
pub(super) const fn minus(x: Value) -> Value {
    match x {
        Value::Constant(x) => Value::Constant(-x),
        Value::Variable(i) => Value::Opposite(i),
        Value::Opposite(i) => Value::Variable(i),
    }
}

/// A program that is being written.
#[derive(Default)]
pub(super) struct Code {
    pub(super) text: String,
    variables: usize,
    /// Additions, multiplications and divisions.
    pub(super) operations: usize,
}

impl Code {
    /// A variable with this value, which counts as no operation.
    pub(super) fn define(&mut self, value: &str) -> Value {
        let index = self.variables;
        self.variables += 1;
        let _ = writeln!(self.text, "  const double v{index} = {value};");
        Value::Variable(index)
    }

    /// 1/x.
    pub(super) fn reciprocal(&mut self, x: Value) -> Value {
        self.operations += 1;
        self.define(&format!("1.0/{}", x.text()))
    }

    pub(super) fn product(&mut self, x: Value, y: Value) -> Value {
        self.sum(&[(x, y)])
    }

    pub(super) fn add(&mut self, x: Value, y: Value) -> Value {
        self.sum(&[(x, ONE), (y, ONE)])
    }

    pub(super) fn subtract(&mut self, x: Value, y: Value) -> Value {
        self.add(x, minus(y))
    }

    /// Σ x y.
    pub(super) fn sum(&mut self, products: &[(Value, Value)]) -> Value {
        let mut constant = 0.0;
        let mut terms = Vec::new();
        let mut multiplications = 0;
        for &(x, y) in products {
            match (x, y) {
                (Value::Constant(x), Value::Constant(y)) => constant += x * y,
                (ZERO, _) | (_, ZERO) => {}
                (ONE, x) | (x, ONE) => terms.push((x, ONE)),
                (Value::Constant(-1.0), x) | (x, Value::Constant(-1.0)) => {
                    terms.push((minus(x), ONE));
                }
                _ => {
                    multiplications += 1;
                    terms.push((x, y));
                }
            }
        }
        if constant != 0.0 {
            terms.push((Value::Constant(constant), ONE));
        }
        if let [(only, ONE)] = terms[..] {
            return only;
        }
        if terms.is_empty() {
            return ZERO;
        }
        self.operations += multiplications + terms.len() - 1;
        let text = terms.iter().map(|(x, y)| match y {
            &ONE => x.text(),
            y => format!("{}*{}", x.text(), y.text()),
        });
        let text: Vec<_> = text.collect();
        self.define(&text.join(" + "))
    }

    /// Writes an output.
    pub(super) fn output(&mut self, index: usize, value: Value) {
        let _ = writeln!(self.text, "  y[{index}] = {};", value.text());
    }

    /// x + y × z.
    pub(super) fn plus_cross(&mut self, x: Vector, y: Vector, z: Vector) -> Vector {
        [0, 1, 2].map(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            self.sum(&[(x[k], ONE), (y[i], z[j]), (minus(y[j]), z[i])])
        })
    }

    pub(super) fn plus(&mut self, x: Vector, y: Vector) -> Vector {
        [0, 1, 2].map(|i| self.add(x[i], y[i]))
    }
}
