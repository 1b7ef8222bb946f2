//! An arm in space, declared as a textbook does, beside the recursions of textbooks in C: accelerations and inverse dynamics.
//!
//! The C is straight-line ([`algorithms`]), with base inertial parameters as constants, and once more with the sines and
//! cosines of all joints in one loop of vectors (gcc's libmvec). Our parameters are fields; what depends on them
//! alone has been prepared. `CasADi` writes C of the same recursions and, for few links, of a declared Lagrangian. All are measured in turn in one process, for this processor, and compared at 256 states first.
//! Operations are additions, multiplications and divisions. The command ends with an error where a limit is missed.

mod straight_line;
mod arm;
mod algorithms;
mod casadi;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use lagrangian_bench::{Library, Operations, Report, Request};

use crate::arguments::{Arguments, PeerName};
use crate::cargo::{Built, build_dependencies_with, build_source, copied};
use crate::command::output;
use crate::compiler;
use crate::flags::Flags;
use crate::folders::{Folders, write};
use crate::peers::skipped;
use crate::verdict::{Verdict, judge};
use algorithms::Algorithm;
use arm::{CENTER, GRAVITY, INERTIA, LINK, axis, mass, states};
use casadi::Casadi;

/// Our operations over those of the best algorithm by hand.
const OPERATIONS_LIMIT: f64 = 1.1;
/// Our time over that of the best C.
const TIME_LIMIT: f64 = 1.0;
/// The operations of the links 21 to 30 over those of 11 to 20.
const GROWTH_LIMIT: f64 = 1.05;

/// So many processes measure, each with files of its own: where a file comes to lie in memory can cost it two thirds of its speed.
const PROCESSES: usize = 3;

/// Ours and the peers', of one quantity.
struct Row {
    links: usize,
    operations: usize,
    by_hand: usize,
    nanoseconds: f64,
    peers: Vec<(String, f64)>,
}

impl Row {
    /// Takes what is faster than what was measured before.
    fn fastest(&mut self, report: Report) -> Result<(), String> {
        self.operations = arithmetic(&report.operations);
        let measurements = report.measurements.into_iter();
        let mut times =
            measurements.map(|found| (found.name, found.throughput.unwrap_or(f64::NAN)));
        let (_, ours) = times.next().ok_or("nothing was measured")?;
        self.nanoseconds = self.nanoseconds.min(ours);
        let times = times.enumerate().map(|(i, (name, time))| {
            let before = self.peers.get(i).map_or(f64::INFINITY, |(_, time)| *time);
            (name, time.min(before))
        });
        self.peers = times.collect();
        Ok(())
    }

    fn best_peer(&self) -> f64 {
        let times = self.peers.iter().map(|(_, time)| *time);
        times.fold(f64::INFINITY, f64::min)
    }
}

/// Prints the tables, and is an error where a limit is missed.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    compiler::check()?;
    let folders = Folders::new()?;
    eprintln!("building what the models depend on");
    build_dependencies_with(&folders, &[Flags::Native])?;
    let casadi = if arguments.wants(PeerName::Casadi) {
        Casadi::new(&folders)
            .map_err(|error| skipped("CasADi", &error))
            .ok()
    } else {
        None
    };
    let mut tables = [Vec::new(), Vec::new()];
    for &links in &arguments.links {
        eprintln!("{links} links: deriving, compiling, measuring");
        let built = build_source(
            &folders,
            &format!("arm-{links}"),
            &declaration(links),
            Flags::Native,
        )?;
        eprintln!("  built in {:.1} s", built.seconds);
        for (table, quantity) in tables.iter_mut().zip(QUANTITIES) {
            table.push(quantity.measure(
                &folders,
                &built,
                casadi.as_ref(),
                links,
                arguments.rounds(),
            )?);
        }
    }
    let mut verdicts = Vec::new();
    for (table, quantity) in tables.iter().zip(QUANTITIES) {
        print(quantity.name, table);
        verdicts.extend(quantity.verdicts(table));
    }
    judge(&verdicts)
}

/// What is measured.
struct Quantity {
    name: &'static str,
    algorithms: &'static [(&'static str, Algorithm)],
    /// By their names in the script.
    of_casadi: &'static [&'static str],
    /// Whether the states have accelerations.
    is_inverse: bool,
}

const QUANTITIES: [Quantity; 2] = [
    Quantity {
        name: "accelerations",
        algorithms: &[
            ("composite", Algorithm::CompositeBodies),
            ("articulated", Algorithm::ArticulatedBodies),
        ],
        of_casadi: &["composite_bodies", "articulated_bodies", "lagrangian"],
        is_inverse: false,
    },
    Quantity {
        name: "inverse dynamics",
        algorithms: &[("Newton-Euler", Algorithm::NewtonEuler)],
        of_casadi: &["inverse_dynamics", "lagrangian_inverse"],
        is_inverse: true,
    },
];

impl Quantity {
    fn measure(
        &self,
        folders: &Folders,
        built: &Built,
        casadi: Option<&Casadi>,
        links: usize,
        rounds: usize,
    ) -> Result<Row, String> {
        let mut by_hand = usize::MAX;
        let mut libraries = Vec::new();
        for (name, algorithm) in self.algorithms {
            let (text, operations) = algorithms::write(*algorithm, links);
            by_hand = by_hand.min(operations);
            for is_batched in [false, true] {
                let name = if is_batched {
                    format!("{name}, batched sines")
                } else {
                    (*name).to_owned()
                };
                let path = written(folders, &name, links, &text, is_batched)?;
                libraries.push(library(folders, name, &path, is_batched)?);
            }
        }
        for algorithm in self.of_casadi {
            let source = casadi.map(|casadi| casadi.source(folders, algorithm, links));
            if let Some(source) = source.transpose()?.flatten() {
                eprintln!("  {}: {} operations", source.name, source.operations);
                libraries.push(library(folders, source.name, &source.path, false)?);
            }
        }
        let mut states = states(links);
        if !self.is_inverse {
            for row in &mut states {
                row.truncate(2 * links);
            }
        }
        let mut request = Request {
            model: format!("{} of {links} links", self.name),
            states,
            libraries,
            answers: Vec::new(),
            rounds,
        };
        let mut row = Row {
            links,
            operations: 0,
            by_hand,
            nanoseconds: f64::INFINITY,
            peers: Vec::new(),
        };
        for process in 0..PROCESSES {
            for library in &mut request.libraries {
                library.path = copied(Path::new(&library.path), process)?;
            }
            let program = built.copied(process)?;
            row.fastest(program.run(folders, &request)?)?;
        }
        Ok(row)
    }

    #[allow(clippy::cast_precision_loss)] // Counts of some thousands.
    fn verdicts(&self, rows: &[Row]) -> Vec<Verdict> {
        let mut verdicts = Vec::new();
        let mut limit = |what: String, figure: f64, limit: f64| {
            verdicts.push(Verdict {
                what: format!("{}, {what}", self.name),
                figure,
                target: limit,
                limit,
            });
        };
        for row in rows.iter().filter(|row| row.links >= 3) {
            let operations = row.operations as f64 / row.by_hand as f64;
            let links = row.links;
            limit(
                format!("{links} links, operations"),
                operations,
                OPERATIONS_LIMIT,
            );
            let time = row.nanoseconds / row.best_peer();
            limit(format!("{links} links, time"), time, TIME_LIMIT);
        }
        let count = |links| {
            let row = rows.iter().find(|row| row.links == links);
            row.map(|row| row.operations as f64)
        };
        if let [Some(ten), Some(twenty), Some(thirty)] = [10, 20, 30].map(count) {
            limit(
                "growth".to_owned(),
                (thirty - twenty) / (twenty - ten),
                GROWTH_LIMIT,
            );
        }
        verdicts
    }
}

const fn arithmetic(operations: &Operations) -> usize {
    operations.additions + operations.multiplications + operations.divisions
}

fn print(name: &str, rows: &[Row]) {
    println!("\n{name}\nlinks  operations  by hand        ns   C, ns");
    for row in rows {
        let peers = row
            .peers
            .iter()
            .map(|(name, time)| format!("{name} {time:.1}"));
        let peers: Vec<_> = peers.collect();
        println!(
            "{:>5}  {:>10}  {:>7}  {:>8.1}   {}",
            row.links,
            row.operations,
            row.by_hand,
            row.nanoseconds,
            peers.join("; ")
        );
    }
}

/// What gcc's vector functions are declared by, in `math.h`, where errors do not matter.
const VECTOR_FUNCTIONS: &str = "__attribute__((simd(\"notinbranch\"))) double sin(double);\n\
                                __attribute__((simd(\"notinbranch\"))) double cos(double);\n";

/// The sines and cosines of all angles but the first; in batches, whole vectors of eight, each function in a loop of its own,
/// since gcc joins both to a scalar `sincos` in one.
fn sines_and_cosines(links: usize, is_batched: bool) -> String {
    if !is_batched {
        return format!(
            "  double c[{links}], s[{links}];\n  \
             for (int i = 1; i < {links}; i++) {{ c[i] = cos(x[i]); s[i] = sin(x[i]); }}\n"
        );
    }
    let padded = links.next_multiple_of(8);
    format!(
        "  double a[{padded}] = {{0}}, c[{padded}], s[{padded}];\n  \
         for (int i = 1; i < {links}; i++) a[i] = x[i];\n  \
         _Pragma(\"omp simd\")\n  for (int i = 0; i < {padded}; i++) c[i] = cos(a[i]);\n  \
         _Pragma(\"omp simd\")\n  for (int i = 0; i < {padded}; i++) s[i] = sin(a[i]);\n"
    )
}

/// The C with `void accelerations(const double *x, double *y)`.
fn written(
    folders: &Folders,
    name: &str,
    links: usize,
    statements: &str,
    is_batched: bool,
) -> Result<PathBuf, String> {
    let file = name.replace(|letter: char| !letter.is_alphanumeric(), "_");
    let path = folders.output.join(format!("arm_{links}_{file}.c"));
    let text = format!(
        "/* Written by lagrangian-bench. */\n{}\
         void accelerations(const double *restrict x, double *restrict y) {{\n{}{statements}}}\n",
        if is_batched {
            VECTOR_FUNCTIONS
        } else {
            "double sin(double);\ndouble cos(double);\n"
        },
        sines_and_cosines(links, is_batched),
    );
    write(&path, &text)?;
    Ok(path)
}

/// The shared object beside the C.
fn library(
    folders: &Folders,
    name: String,
    source: &Path,
    is_batched: bool,
) -> Result<Library, String> {
    let path = source.with_extension("so");
    let mut command = Command::new("gcc");
    command.current_dir(&folders.output);
    command.args(Flags::Native.c()).args(["-shared", "-fPIC"]);
    if is_batched {
        command.args(["-fopenmp-simd", "-fno-math-errno"]);
    }
    command.arg(source).arg("-o").arg(&path);
    if is_batched {
        command.arg("-lmvec");
    }
    output(command.arg("-lm"))?;
    let path = path.to_string_lossy().into_owned();
    Ok(Library { name, path })
}

/// The crate of the arm that is measured.
fn declaration(links: usize) -> String {
    let vector = |x: [f64; 3]| format!("Vector3::new({:?}, {:?}, {:?})", x[0], x[1], x[2]);
    let [link, center] = [LINK, CENTER].map(vector);
    let inertia = INERTIA.concat();
    let masses: Vec<_> = (0..links).map(mass).collect();
    let model = model(links, "");
    format!(
        "{model}\n\
         fn main() -> std::process::ExitCode {{\n    let inertia = Matrix3::from_row_slice(&{inertia:?});\n    \
         let model = Model {{ m: {masses:?}, link: [{link}; {links}], center: [{center}; {links}], \
         inertia: [inertia; {links}], g: {GRAVITY:?} }};\n    \
         let operations = [Model::OPERATIONS.accelerations, Model::OPERATIONS.inverse_dynamics];\n    \
         lagrangian_bench::measure_dynamics::<{links}, Model>(&model, operations)\n}}\n"
    )
}

/// The arm as a user declares it, with these clauses besides.
pub(crate) fn model(links: usize, clauses: &str) -> String {
    let letters = ["x", "y", "z"];
    let mut definitions = "r[0] = rotation_z(q[0]),\n        p[0] = [0.0, 0.0, 0.0],\n".to_owned();
    for i in 1..links {
        let (before, letter) = (i - 1, letters[axis(i)]);
        let _ = write!(
            definitions,
            "        r[{i}] = r[{before}] * rotation_{letter}(q[{i}]),\n        \
             p[{i}] = p[{before}] + r[{before}] * link[{before}],\n"
        );
    }
    format!(
        "//! Written by lagrangian-bench.\n\
         use lagrangian::nalgebra::{{Matrix3, Vector3}};\nuse lagrangian::prelude::*;\n\n\
         /// An arm.\n#[derive(Lagrangian, Clone, Debug)]\n#[lagrangian(\n    {clauses}\
         coordinates(q[{links}]),\n    define(\n        {definitions}        \
         c[i] = p[i] + r[i] * center[i] for i in 0..{links},\n        \
         w[i] = angular_velocity(r[i]) for i in 0..{links},\n    ),\n    \
         kinetic = (0..{links}).map(|i| 0.5 * m[i] * dot(c[i]).norm_squared() + 0.5 * w[i].dot(inertia[i] * w[i])).sum(),\n    \
         potential = (0..{links}).map(|i| m[i] * g * c[i].z).sum(),\n)]\n\
         struct Model {{ m: [f64; {links}], link: [Vector3<f64>; {links}], center: [Vector3<f64>; {links}], \
         inertia: [Matrix3<f64>; {links}], g: f64 }}\n"
    )
}
