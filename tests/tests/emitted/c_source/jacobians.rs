//! The Jacobians of the external functions in `CasADi` against differences, by `jacobians.py`. The variable `PYTHON` names the interpreter
//! of an environment with `casadi` and `numpy`; without these packages nothing is compared.

use std::env;
use std::path::Path;
use std::process::Command;

use super::point::Point;
use super::program::Case;

/// How nearly Jacobians and differences of fourth order agree, over the largest element.
const TOLERANCE: f64 = 1e-8;
/// Where the Jacobian is of differences of second order: by parameters without the clause `sensitivities`.
const OF_DIFFERENCES: f64 = 1e-6;

impl Case {
    /// Compares the Jacobians with differences at a point.
    pub(super) fn has_jacobians_in_casadi(&self, point: &Point) {
        let python = env::var_os("PYTHON").unwrap_or_else(|| "python3".into());
        let packages = Command::new(&python)
            .args(["-c", "import casadi, numpy"])
            .output();
        let has_compiler = Command::new("cc").arg("--version").output().is_ok();
        if !has_compiler || !packages.is_ok_and(|output| output.status.success()) {
            println!("skipped: there is no compiler `cc`, or no Python with `casadi` and `numpy`");
            return;
        }
        let program = self.compile();
        let folder = program.parent().expect("a folder");
        let named = |ending: &str| folder.join(format!("{}{ending}", self.prefix));
        let library = named(".so");
        let compiled = Command::new("cc")
            .args([
                "-std=c99",
                "-O1",
                "-ffp-contract=off",
                "-fPIC",
                "-shared",
                "-o",
            ])
            .args([&library, &named(".c"), &named("_casadi.c")])
            .arg("-lm")
            .status();
        assert!(compiled.expect("a compiler").success());
        let x = [&point.q[..], &point.v].concat();
        let lists = [&[point.t][..], &x, &point.u, &self.parameters].map(|numbers| {
            let numbers: Vec<String> = numbers.iter().map(ToString::to_string).collect();
            numbers.join(",")
        });
        let script =
            Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/emitted/c_source/jacobians.py");
        let output = Command::new(&python)
            .arg(script)
            .arg(&library)
            .arg(self.prefix)
            .args(lists)
            .output()
            .expect("Python");
        let printed = String::from_utf8_lossy(&output.stdout);
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(
            output.status.success(),
            "{}: {printed}{errors}",
            self.prefix
        );
        for line in printed.lines() {
            println!("{}: {line}", self.prefix);
            let difference = line.split(' ').nth(1).expect("a number");
            let difference: f64 = difference.parse().expect("a number");
            let is_exact = !line.starts_with('p') || self.header.contains("_sensitivities(");
            let tolerance = if is_exact { TOLERANCE } else { OF_DIFFERENCES };
            assert!(difference < tolerance, "{}: {line}", self.prefix);
        }
        assert!(printed.lines().count() >= 2);
    }
}
