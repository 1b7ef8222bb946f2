//! Elementary functions and their first two derivatives over the full range of binary64.
//!
//! What a derivative becomes as a program is run in binary64 and in binary32, and compared with values of
//! four hundred digits (`tests/data/elementary_functions.py`): finite wherever those are, right to rounding, and 0
//! only where those are below the square root of the smallest number.

use lagrangian_symbolic::{Binary, Expression, Graph, Program, Rational, Symbol, Unary};
use lagrangian_symbolic_testing::Number;
use lagrangian_symbolic_testing::machine::run;

const X: Symbol = Symbol::Coordinate(0);
const Y: Symbol = Symbol::Coordinate(1);

const DATA: &str = include_str!("../../../tests/data/elementary_functions.txt");

/// Plain numbers, as a scalar computes on them.
macro_rules! plain_number {
    ($name:ident $float:ident) => {
        #[derive(Clone, Copy)]
        struct $name($float);

        #[allow(clippy::cast_possible_truncation)] // Rounding is what is asked for.
        impl Number for $name {
            fn rational(value: &Rational) -> Self {
                Self(value.to_f64() as $float)
            }

            fn pi() -> Self {
                Self(core::$float::consts::PI)
            }

            fn add(self, other: Self) -> Self {
                Self(self.0 + other.0)
            }

            fn multiply(self, other: Self) -> Self {
                Self(self.0 * other.0)
            }

            fn power(self, exponent: &Rational) -> Self {
                if *exponent == Rational::HALF {
                    Self(self.0.sqrt())
                } else {
                    assert_eq!(*exponent, Rational::MINUS_ONE);
                    Self(1.0 / self.0)
                }
            }

            fn unary(self, function: Unary) -> Self {
                Self(function.value(self.0.into()) as $float)
            }

            fn binary(self, function: Binary, other: Self) -> Self {
                Self(function.value(self.0.into(), other.0.into()) as $float)
            }
        }
    };
}

plain_number! { Double f64 }
plain_number! { Single f32 }

/// One function, and its derivatives by x up to the second, as a program.
fn program(build: impl Fn(&mut Graph, Expression) -> Expression) -> Program {
    let mut graph = Graph::new();
    let x = graph.symbol(X);
    let root = build(&mut graph, x);
    let first = graph.derivative(root, X);
    let second = graph.derivative(first, X);
    let roots = [root, first, second];
    let program = Program::schedule_for_staging(&graph, &[&roots]);
    assert_eq!(program.verify(&graph, &[&roots]), Ok(()));
    program
}

fn function(name: &str) -> Program {
    if name == "sqrt" {
        return program(Graph::square_root);
    }
    let function = Unary::ALL.into_iter().find(|f| f.name() == name).unwrap();
    program(|graph, x| graph.unary(function, x))
}

/// What is expected of a format: its rounding, its largest number, and below which size a value may be 0.
struct Format {
    epsilon: f64,
    largest: f64,
    negligible: f64,
}

const DOUBLE: Format = Format {
    epsilon: f64::EPSILON,
    largest: f64::MAX,
    negligible: 1e-153,
};

const SINGLE: Format = Format {
    epsilon: f32::EPSILON as f64,
    largest: f32::MAX as f64,
    negligible: 1e-18,
};

impl Format {
    #[allow(clippy::float_cmp)] // Infinities are equal.
    fn accepts(&self, found: f64, expected: f64) -> bool {
        if expected.is_infinite() {
            return found == expected;
        }
        // Powers of what is rounded once are wrong by some units in the last place.
        let error = (found - expected).abs();
        error <= 8.0 * self.epsilon * expected.abs() + self.negligible
            || (found == expected.signum() * f64::INFINITY
                && expected.abs() > (1.0 - self.epsilon) * self.largest)
    }
}

#[test]
fn values_and_derivatives_are_finite_and_right_wherever_the_truth_is() {
    let mut name_of_program = "";
    let mut current = Program::default();
    let mut wrong = Vec::new();
    let mut count = 0;
    for line in DATA.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let (format, name) = (words[0], words[1]);
        if name != name_of_program {
            (current, name_of_program) = (function(name), name);
        }
        let x = f64::from_bits(u64::from_str_radix(words[2], 16).unwrap());
        #[allow(clippy::cast_possible_truncation)] // The number is one of binary32.
        let (found, limits): (Vec<f64>, _) = if format == "64" {
            let outputs = run(&current, |_| Double(x)).concat();
            (outputs.iter().map(|x| x.0).collect(), DOUBLE)
        } else {
            let outputs = run(&current, |_| Single(x as f32)).concat();
            (outputs.iter().map(|x| x.0.into()).collect(), SINGLE)
        };
        for (order, (found, expected)) in found.into_iter().zip(&words[3..]).enumerate() {
            count += 1;
            let expected: f64 = expected.parse().unwrap();
            if !limits.accepts(found, expected) {
                wrong.push(format!(
                    "{name} {format}, derivative {order} at {x:e}: {found:e} for {expected:e}"
                ));
            }
        }
    }
    assert!(count > 5000, "{count}");
    assert!(
        wrong.is_empty(),
        "{} of {count}:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}

#[test]
fn closeness_can_fail() {
    for (found, expected) in [
        (f64::NAN, 0.0),
        (f64::INFINITY, 1.0),
        (0.0, 1e-100),
        (1.0 + 1e-14, 1.0),
        (1e300, f64::INFINITY),
        (f64::NEG_INFINITY, f64::INFINITY),
    ] {
        assert!(!DOUBLE.accepts(found, expected), "{found} {expected}");
    }
}

/// f(x, y), and its derivatives by x, y, x and x, x and y, y and y, as a program.
fn program_of_two(function: Binary) -> Program {
    let mut graph = Graph::new();
    let [x, y] = [X, Y].map(|symbol| graph.symbol(symbol));
    let root = graph.binary(function, x, y);
    let [over_x, over_y] = [X, Y].map(|symbol| graph.derivative(root, symbol));
    let second = [(over_x, X), (over_x, Y), (over_y, Y)];
    let second = second.map(|(first, symbol)| graph.derivative(first, symbol));
    let roots = [&[root, over_x, over_y][..], &second].concat();
    let program = Program::schedule_for_staging(&graph, &[&roots]);
    assert_eq!(program.verify(&graph, &[&roots]), Ok(()));
    program
}

/// All outputs at a point, in both formats as far as they have the numbers.
fn assert_both(program: &Program, [x, y]: [f64; 2], single: bool, expected: [f64; 6]) {
    let pick = |symbol| if symbol == X { x } else { y };
    let double = run(program, |symbol| Double(pick(symbol))).concat();
    let mut found: Vec<(f64, &Format)> = double.iter().map(|x| (x.0, &DOUBLE)).collect();
    if single {
        #[allow(clippy::cast_possible_truncation)] // Rounding is what is asked for.
        let single = run(program, |symbol| Single(pick(symbol) as f32)).concat();
        found.extend(single.iter().map(|x| (x.0.into(), &SINGLE)));
    }
    for ((found, format), expected) in found.into_iter().zip(expected.into_iter().cycle()) {
        // The point itself is rounded.
        let rounded = Format {
            epsilon: 4.0 * format.epsilon,
            ..*format
        };
        assert!(
            rounded.accepts(found, expected),
            "{found:e} for {expected:e} at {x:e}, {y:e}"
        );
    }
}

/// Nearer to the origin than the root of the smallest number, x² + y² is 0 and the derivatives are lost.
#[test]
fn the_angle_of_a_point_at_any_distance() {
    let program = program_of_two(Binary::Atan2);
    for exponent in -154_i32..=300 {
        let s = 10.0_f64.powi(exponent);
        let directions = [
            (3.0, 4.0),
            (-4.0, 3.0),
            (0.0, 1.0),
            (1.0, 0.0),
            (-3.0, -4.0),
            (0.0, -1.0),
        ];
        for (i, j) in directions {
            let (y, x): (f64, f64) = (i * s, j * s);
            let square: f64 = i * i + j * j;
            let first = [j / square, -i / square].map(|slope| slope / s);
            let mixed = (i * i - j * j) / square / square / s / s;
            let other = 2.0 * i * j / square / square / s / s;
            let expected = [i.atan2(j), first[0], first[1], -other, mixed, other];
            assert_both(&program, [y, x], (-18..=37).contains(&exponent), expected);
        }
    }
}

#[test]
fn real_powers_of_numbers_from_zero_on() {
    let program = program_of_two(Binary::Power);
    // At 0 what grows with ln x is 0, as long as the power is.
    assert_both(&program, [0.0, 2.5], true, [0.0; 6]);
    assert_both(
        &program,
        [0.0, 1.5],
        false,
        [0.0, 0.0, 0.0, f64::INFINITY, 0.0, 0.0],
    );
    for exponent in (-300_i32..=300).step_by(7) {
        let x = 10.0_f64.powi(exponent);
        let ln = f64::from(exponent) * core::f64::consts::LN_10;
        for (y, root) in [(0.5, x.sqrt()), (1.0, x), (-0.5, 1.0 / x.sqrt())] {
            let first = [y * root / x, root * ln];
            let second = [
                y * (y - 1.0) * root / x / x,
                root / x * (1.0 + y * ln),
                root * ln * ln,
            ];
            let expected = [root, first[0], first[1], second[0], second[1], second[2]];
            let single = (-18..=18).contains(&exponent);
            assert_both(&program, [x, y], single, expected);
        }
    }
}
