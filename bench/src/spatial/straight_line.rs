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

/// A variable.
struct Statement {
    value: String,
    operands: Vec<Value>,
    /// Additions, multiplications and divisions.
    operations: usize,
}

/// A program that is being written.
#[derive(Default)]
pub(super) struct Code {
    statements: Vec<Statement>,
    outputs: Vec<(usize, Value)>,
}

impl Code {
    /// The text, without what no output needs, and its additions, multiplications and divisions.
    pub(super) fn finish(&self) -> (String, usize) {
        let mut is_needed = vec![false; self.statements.len()];
        let need = |value: &Value, is_needed: &mut Vec<bool>| match value {
            Value::Variable(i) | Value::Opposite(i) => is_needed[*i] = true,
            Value::Constant(_) => {}
        };
        for (_, value) in &self.outputs {
            need(value, &mut is_needed);
        }
        for (i, statement) in self.statements.iter().enumerate().rev() {
            if is_needed[i] {
                for operand in &statement.operands {
                    need(operand, &mut is_needed);
                }
            }
        }
        let (mut text, mut operations) = (String::new(), 0);
        for (i, statement) in self.statements.iter().enumerate() {
            if is_needed[i] {
                let _ = writeln!(text, "  const double v{i} = {};", statement.value);
                operations += statement.operations;
            }
        }
        for (index, value) in &self.outputs {
            let _ = writeln!(text, "  y[{index}] = {};", value.text());
        }
        (text, operations)
    }

    fn variable(&mut self, value: String, operands: Vec<Value>, operations: usize) -> Value {
        self.statements.push(Statement {
            value,
            operands,
            operations,
        });
        Value::Variable(self.statements.len() - 1)
    }

    /// An input.
    pub(super) fn define(&mut self, value: &str) -> Value {
        self.variable(value.to_owned(), Vec::new(), 0)
    }

    /// 1/x.
    pub(super) fn reciprocal(&mut self, x: Value) -> Value {
        self.variable(format!("1.0/{}", x.text()), vec![x], 1)
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
        let text = terms.iter().map(|(x, y)| match y {
            &ONE => x.text(),
            y => format!("{}*{}", x.text(), y.text()),
        });
        let text: Vec<_> = text.collect();
        let operations = multiplications + terms.len() - 1;
        let operands = terms.iter().flat_map(|(x, y)| [*x, *y]).collect();
        self.variable(text.join(" + "), operands, operations)
    }

    /// Writes an output.
    pub(super) fn output(&mut self, index: usize, value: Value) {
        self.outputs.push((index, value));
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
