//! Programs in C that evaluate a model at points from their input, beside the model in Rust.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};

use lagrangian_tests::Random;

use super::agreement::Agreement;
use super::point::Point;

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
    /// How nearly both agree, where that is not what holds for the case.
    pub(super) agreement: Option<Agreement>,
}

impl Check {
    /// The same with results that differ by so many units in the last place of the largest one.
    pub(super) fn within(mut self, units: f64) -> Self {
        self.agreement = Some(Agreement::Units(units));
        self
    }
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
        let mut units = vec![0.0; self.checks.len()];
        for (point, line) in points.iter().zip(results.lines()) {
            let mut numbers = line.split_whitespace().map(|word| {
                let bits = u64::from_str_radix(word, 16).expect("a number");
                f64::from_bits(bits)
            });
            let counts = compared.iter_mut().zip(&mut units);
            for (check, (compared, units)) in self.checks.iter().zip(counts) {
                let found: Vec<f64> = numbers.by_ref().take(check.count).collect();
                let Some(expected) = (check.expected)(point) else {
                    continue;
                };
                assert_eq!(found.len(), expected.len(), "{}", check.name);
                *compared += 1;
                *units = f64::max(*units, Agreement::units(&found, &expected));
                let agreement = check.agreement.unwrap_or(self.agreement);
                let agree = agreement.holds(&found, &expected);
                let name = check.name;
                assert!(
                    agree,
                    "{}: {name}\nC:    {found:?}\nRust: {expected:?}\n{point:?}",
                    self.prefix
                );
            }
        }
        for ((check, compared), units) in self.checks.iter().zip(compared).zip(units) {
            let name = check.name;
            if check.agreement.is_some() {
                println!(
                    "{}: {name}: {units:.1} units in the last place",
                    self.prefix
                );
            }
            assert!(
                2 * compared > points.len(),
                "{}: {name}: {compared}",
                self.prefix
            );
        }
    }

    /// The path of the compiled program.
    pub(super) fn compile(&self) -> PathBuf {
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
