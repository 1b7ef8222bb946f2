//! Programs in C that evaluate a model at points from their input, beside the model in Rust.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};

use lagrangian::State;
use lagrangian_tests::Random;

/// What a model is evaluated at.
#[derive(Clone, Debug)]
pub(super) struct Point {
    pub(super) t: f64,
    pub(super) q: Vec<f64>,
    pub(super) v: Vec<f64>,
    pub(super) u: Vec<f64>,
    /// Accelerations.
    pub(super) a: Vec<f64>,
    /// The length of a step.
    pub(super) h: f64,
}

impl Point {
    /// A random point for so many coordinates and inputs.
    pub(super) fn random(random: &mut Random, n: usize, inputs: usize) -> Self {
        let mut numbers = |count: usize, most: f64| -> Vec<f64> {
            (0..count).map(|_| random.between(-most, most)).collect()
        };
        let (q, v, u, a) = (
            numbers(n, 3.0),
            numbers(n, 2.0),
            numbers(inputs, 5.0),
            numbers(n, 10.0),
        );
        // Sums of the time and parts of these steps are exact.
        let eighths = (random.between(0.0, 8.0)).floor();
        Self {
            t: eighths / 8.0,
            q,
            v,
            u,
            a,
            h: 1.0 / 128.0,
        }
    }

    /// The state.
    pub(super) fn state<const N: usize>(&self) -> State<f64, N> {
        let of = |numbers: &[f64]| -> [f64; N] { std::array::from_fn(|i| numbers[i]) };
        State::new(self.t, of(&self.q), of(&self.v))
    }
}

/// What Rust returns at a point, unless it refuses.
pub(super) type Expected = Box<dyn Fn(&Point) -> Option<Vec<f64>>>;

/// A function of the model, in C and in Rust.
pub(super) struct Check {
    pub(super) name: &'static str,
    /// Statements that write the results to `y`, where `$` is the name of the model, `POINT` stands for the arguments that all functions
    /// take, and `MOVED` for these with `q1` and `v1` as the state.
    pub(super) statements: String,
    /// How many results there are.
    pub(super) count: usize,
    pub(super) expected: Expected,
}

/// How nearly results are the same.
#[derive(Clone, Copy, Debug)]
pub(super) enum Agreement {
    /// To the bit.
    Bits,
    /// So many units in the last place of the largest result of a function.
    Units(f64),
}

/// A model in both languages.
pub(super) struct Case {
    /// The name of the model in C.
    pub(super) prefix: &'static str,
    pub(super) source: &'static str,
    pub(super) header: &'static str,
    pub(super) casadi: &'static str,
    /// The numbers in the struct of parameters, in order.
    pub(super) parameters: Vec<f64>,
    pub(super) coordinates: usize,
    pub(super) inputs: usize,
    pub(super) checks: Vec<Check>,
    pub(super) agreement: Agreement,
}

impl Case {
    /// Compares both at random points; says so where there is no compiler.
    pub(super) fn agrees_at_random_points(&self, count: usize) {
        let mut random = Random::default();
        let points = (0..count).map(|_| Point::random(&mut random, self.coordinates, self.inputs));
        self.agrees(&points.collect::<Vec<_>>());
    }

    /// Compares both at some points.
    pub(super) fn agrees(&self, points: &[Point]) {
        if Command::new("cc").arg("--version").output().is_err() {
            println!("skipped: there is no compiler `cc`");
            return;
        }
        let results = self.run(&self.compile(), points);
        let mut compared = vec![0; self.checks.len()];
        for (point, line) in points.iter().zip(results.lines()) {
            let mut numbers = line.split_whitespace().map(|word| {
                let bits = u64::from_str_radix(word, 16).expect("a number");
                f64::from_bits(bits)
            });
            for (check, compared) in self.checks.iter().zip(&mut compared) {
                let found: Vec<f64> = numbers.by_ref().take(check.count).collect();
                let Some(expected) = (check.expected)(point) else {
                    continue;
                };
                assert_eq!(found.len(), expected.len(), "{}", check.name);
                *compared += 1;
                let agree = self.agreement.holds(&found, &expected);
                let name = check.name;
                assert!(
                    agree,
                    "{}: {name}\nC:    {found:?}\nRust: {expected:?}\n{point:?}",
                    self.prefix
                );
            }
        }
        for (check, compared) in self.checks.iter().zip(compared) {
            let name = check.name;
            assert!(
                2 * compared > points.len(),
                "{}: {name}: {compared}",
                self.prefix
            );
        }
    }

    /// The path of the compiled program.
    fn compile(&self) -> PathBuf {
        // Tests compile the same models at the same time.
        static PROGRAMS: AtomicUsize = AtomicUsize::new(0);
        let number = PROGRAMS.fetch_add(1, Ordering::Relaxed);
        let name = format!("{}{number}", self.prefix);
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
            .join("c_source")
            .join(name);
        std::fs::create_dir_all(&folder).expect("a folder");
        let named = |ending: &str| folder.join(format!("{}{ending}", self.prefix));
        let (model, header, casadi) = (named(".c"), named(".h"), named("_casadi.c"));
        let main = folder.join("main.c");
        for (path, text) in [
            (&model, self.source),
            (&header, self.header),
            (&casadi, self.casadi),
            (&main, &self.main()),
        ] {
            std::fs::write(path, text).expect("a file");
        }
        let fused = cfg!(target_feature = "fma").then_some("-mfma");
        let cc = |arguments: &[&str], files: &[&Path]| {
            let mut command = Command::new("cc");
            command
                .args(["-std=c99", "-O1", "-ffp-contract=off"])
                .args(fused);
            let output = command
                .args(files)
                .args(arguments)
                .output()
                .expect("a compiler");
            let errors = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{}: {errors}", self.prefix);
        };
        let objects = [&model, &casadi].map(|source| {
            let object = source.with_extension("o");
            let name = object.to_str().expect("a path of letters");
            let strict = ["-Wall", "-Wextra", "-Werror", "-pedantic", "-c", "-o", name];
            cc(&strict, &[source]);
            object
        });
        let program = folder.join("program");
        let program_name = program.to_str().expect("a path of letters");
        let [object, casadi] = &objects;
        cc(&["-o", program_name, "-lm"], &[&main, object, casadi]);
        program
    }

    /// The program that reads points and writes results, bit by bit.
    fn main(&self) -> String {
        let n = self.coordinates;
        let (parameters, declared) = if self.parameters.is_empty() {
            ("", String::new())
        } else {
            let declared = format!(
                "    {0}_parameters p;\n    if (sizeof p != {1} * sizeof(double) || !get((double *)&p, {1})) return 1;\n",
                self.prefix,
                self.parameters.len()
            );
            ("&p, ", declared)
        };
        let inputs = if self.inputs > 0 { ", u" } else { "" };
        let mut text = format!(
            "#include \"{0}.h\"\n#include <inttypes.h>\n#include <stdio.h>\n#include <string.h>\n\
             static int get(double *x, int n) {{\n    for (int i = 0; i < n; ++i) {{\n        uint64_t bits;\n        \
             if (scanf(\"%\" SCNx64, &bits) != 1) return 0;\n        memcpy(x + i, &bits, sizeof bits);\n    }}\n    return 1;\n}}\n\
             static void put(const double *x, int n) {{\n    for (int i = 0; i < n; ++i) {{\n        uint64_t bits;\n        \
             memcpy(&bits, x + i, sizeof bits);\n        printf(\"%\" PRIx64 \" \", bits);\n    }}\n}}\n\
             int main(void) {{\n{declared}    \
             double t, h, q[{n}], v[{n}], q1[{n}], v1[{n}], u[{1}], a[{n}];\n    \
             while (get(&t, 1) && get(q, {n}) && get(v, {n}) && get(u, {2}) && get(a, {n}) && get(&h, 1)) {{\n",
            self.prefix,
            self.inputs.max(1),
            self.inputs,
        );
        for check in &self.checks {
            let statements = check.statements.replace('$', self.prefix);
            let statements = statements
                .replace("POINT", &format!("{parameters}t, q, v{inputs}"))
                .replace("MOVED", &format!("{parameters}t, q1, v1{inputs}"));
            let count = check.count;
            let _ = writeln!(
                text,
                "        {{\n            double y[{count}];\n            memcpy(q1, q, sizeof q);\n            \
                 memcpy(v1, v, sizeof v);\n            {statements}\n            put(y, {count});\n        }}"
            );
        }
        text + "        printf(\"\\n\");\n    }\n    return 0;\n}\n"
    }

    /// What the program writes for some points.
    fn run(&self, program: &Path, points: &[Point]) -> String {
        let mut input = String::new();
        let mut line = |numbers: &[f64]| {
            for number in numbers {
                let _ = write!(input, "{:x} ", number.to_bits());
            }
        };
        line(&self.parameters);
        for point in points {
            let Point { t, q, v, u, a, h } = point;
            for numbers in [&[*t][..], q, v, u, a, &[*h]] {
                line(numbers);
            }
        }
        let mut child = Command::new(program)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program runs");
        let mut stdin = child.stdin.take().expect("an input");
        let writer = std::thread::spawn(move || stdin.write_all(input.as_bytes()));
        let output = child.wait_with_output().expect("the program ends");
        writer.join().expect("a thread").expect("the input is read");
        assert!(output.status.success(), "{}", self.prefix);
        let written = String::from_utf8(output.stdout).expect("text");
        assert_eq!(written.lines().count(), points.len(), "{}", self.prefix);
        written
    }
}

impl Agreement {
    fn holds(self, found: &[f64], expected: &[f64]) -> bool {
        let mut pairs = found.iter().zip(expected);
        match self {
            Self::Bits => {
                pairs.all(|(x, y)| x.to_bits() == y.to_bits() || (x.is_nan() && y.is_nan()))
            }
            Self::Units(units) => {
                let finite = expected.iter().filter(|x| x.is_finite());
                let largest = finite.fold(0.0, |most, x| f64::max(most, x.abs()));
                pairs.all(|(x, y)| {
                    (x - y).abs() <= units * f64::EPSILON * largest
                        || (x.is_nan() && y.is_nan())
                        || x.to_bits() == y.to_bits()
                })
            }
        }
    }
}

/// The functions that all models have; `$model` is the model with given inputs.
macro_rules! functions {
    ($n:literal, $c:literal, $model:expr) => {{
        use lagrangian::prelude::*;
        const N: usize = $n;
        const C: usize = $c;
        let model = $model;
        let _ = C;
        vec![
            $crate::c_source::program::check(
                "inverse dynamics",
                N,
                "$_inverse_dynamics(POINT, a, y);",
                move |point| {
                    let a = SVector::<f64, N>::from_column_slice(&point.a);
                    Some(
                        model(&point.u)
                            .inverse_dynamics(&point.state::<N>(), &a)
                            .as_slice()
                            .to_vec(),
                    )
                },
            ),
            $crate::c_source::program::check(
                "energy",
                1,
                "y[0] = $_energy(POINT);",
                move |point| Some(vec![model(&point.u).energy(&point.state::<N>())]),
            ),
        ]
    }};
}

/// The functions of models without constraints.
macro_rules! free {
    ($n:literal, $model:expr) => {{
        use lagrangian::prelude::*;
        const N: usize = $n;
        let model = $model;
        let mut checks = $crate::c_source::program::functions!($n, 0, $model);
        checks.push($crate::c_source::program::check(
            "accelerations",
            N,
            "$_accelerations(POINT, y);",
            move |point| {
                Some(
                    model(&point.u)
                        .accelerations(&point.state::<N>())
                        .as_slice()
                        .to_vec(),
                )
            },
        ));
        checks.push($crate::c_source::program::check(
            "step",
            2 * N,
            &format!("$_step(MOVED, h); memcpy(y, q1, sizeof q1); memcpy(y + {N}, v1, sizeof v1);"),
            move |point| {
                let method = RungeKutta::classical(point.h);
                let model = model(&point.u);
                let end = Problem::new(&model, point.state::<N>())
                    .solve(point.t + point.h, method)
                    .ok()?;
                Some([end.q.as_slice(), end.v.as_slice()].concat())
            },
        ));
        checks
    }};
}

/// The state matrix, and behind it the derivatives by the time.
macro_rules! state_matrix {
    ($n:literal, $model:expr, $of_inputs:literal) => {{
        use lagrangian::prelude::*;
        const N: usize = $n;
        const D: usize = 2 * $n;
        let model = $model;
        $crate::c_source::program::check(
            "state matrix",
            D * D + N,
            &format!(
                concat!(
                    "double b[{D} * 64]; (void)b; $_linearize(POINT, y, ",
                    $of_inputs,
                    "y + {D} * {D});"
                ),
                D = D
            ),
            move |point| {
                let found = model(&point.u).linearize(&point.state::<N>());
                let by_rows = found.state_matrix::<D>().transpose();
                Some([by_rows.as_slice(), found.time.as_slice()].concat())
            },
        )
    }};
}

/// The input matrix of a model with `$m` inputs.
macro_rules! input_matrix {
    ($n:literal, $m:literal, $model:expr, $call:expr) => {{
        use lagrangian::prelude::*;
        const N: usize = $n;
        const M: usize = $m;
        let model = $model;
        $crate::c_source::program::check("input matrix", 2 * N * M, &$call, move |point| {
            let found = model(&point.u)
                .input_jacobian::<M>(&point.state::<N>())
                .transpose();
            Some([&[0.0; N * M][..], found.as_slice()].concat())
        })
    }};
}

/// Projects the state until it meets constraints.
pub(super) const PROJECTIONS: &str = "for (int k = 0; k < 8; ++k) $_project(MOVED);";

/// The state that `PROJECTIONS` gives.
macro_rules! on_constraints {
    ($model:expr, $point:expr, $n:expr) => {{
        let mut state = $point.state::<{ $n }>();
        for _ in 0..8 {
            let on = $model.dynamics().project(state.t, &state.x)?.into_state();
            state = State::new(state.t, on.q, on.v);
        }
        state
    }};
}

/// The functions of models with constraints.
macro_rules! constrained {
    ($n:literal, $c:literal, $model:expr) => {{
        use lagrangian::prelude::*;
        use $crate::c_source::program::PROJECTIONS;
        const N: usize = $n;
        const C: usize = $c;
        let model = $model;
        let mut checks = $crate::c_source::program::functions!($n, $c, $model);
        checks.push($crate::c_source::program::check(
            "accelerations and multipliers",
            N + C,
            &format!("$_accelerations(POINT, y, y + {N});"),
            move |point| {
                let (model, state) = (model(&point.u), point.state::<N>());
                let (a, lambda) = (model.accelerations(&state), model.multipliers::<C>(&state));
                Some([a.as_slice(), lambda.as_slice()].concat())
            },
        ));
        checks.push($crate::c_source::program::check(
            "projection",
            2 * N,
            &format!("$_project(MOVED); memcpy(y, q1, sizeof q1); memcpy(y + {N}, v1, sizeof v1);"),
            move |point| {
                let model = model(&point.u);
                let found = model.dynamics().project(point.t, &point.state::<N>().x)?.into_state();
                Some([found.q.as_slice(), found.v.as_slice()].concat())
            },
        ));
        checks.push($crate::c_source::program::check(
            "step",
            2 * N,
            &format!("{PROJECTIONS} $_step(MOVED, h); memcpy(y, q1, sizeof q1); memcpy(y + {N}, v1, sizeof v1);"),
            move |point| {
                let (model, method) = (model(&point.u), RungeKutta::classical(point.h));
                let start = $crate::c_source::program::on_constraints!(model, point, N);
                let end = Problem::new(&model, start).solve(point.t + point.h, method).ok()?;
                Some([end.q.as_slice(), end.v.as_slice()].concat())
            },
        ));
        checks
    }};
}

/// The numbers of a body, in the order of its struct in C.
macro_rules! body {
    ($body:expr) => {{
        let inertia = $body.inertia().matrix();
        let center = $body.center();
        [&[$body.mass()][..], center.as_slice(), inertia.as_slice()].concat()
    }};
}

pub(super) use {body, constrained, free, functions, input_matrix, on_constraints, state_matrix};

/// A function in C and in Rust.
pub(super) fn check(
    name: &'static str,
    count: usize,
    statements: &str,
    expected: impl Fn(&Point) -> Option<Vec<f64>> + 'static,
) -> Check {
    Check {
        name,
        statements: statements.to_owned(),
        count,
        expected: Box::new(expected),
    }
}
