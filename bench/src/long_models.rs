//! How long models take to compile: arms in space and chains of pendulums, in both profiles of cargo.
//!
//! Each crate calls what its row names once, so that it is compiled; dependencies are built before. By the clock.

use crate::cargo::{Profile, build_seconds};
use crate::folders::Folders;
use crate::spatial;
use crate::verdict::Verdict;

/// A crate, and seconds that its build may take.
struct Row {
    name: &'static str,
    links: usize,
    is_plane: bool,
    clauses: &'static str,
    calls: &'static [&'static str],
    profiles: &'static [Profile],
    limit: f64,
}

const BOTH: &[Profile] = &[Profile::Release, Profile::Debug];
const DYNAMICS: &[&str] = &["accelerations(state)", "inverse_dynamics(state, &state.v)"];
const ALL: &[&str] = &[
    "accelerations(state)",
    "inverse_dynamics(state, &state.v)",
    "mass_matrix(state)",
    "linearize(state)",
];

const ROWS: [Row; 5] = [
    Row {
        name: "30 joints",
        links: 30,
        is_plane: false,
        clauses: "",
        calls: DYNAMICS,
        profiles: BOTH,
        limit: 15.0,
    },
    Row {
        name: "30 joints, all",
        links: 30,
        is_plane: false,
        clauses: "",
        calls: ALL,
        profiles: BOTH,
        limit: 15.0,
    },
    Row {
        name: "6 joints, taylor",
        links: 6,
        is_plane: false,
        clauses: "taylor,",
        calls: &["taylor"],
        profiles: &[Profile::Release],
        limit: 15.0,
    },
    Row {
        name: "100 in a plane, all",
        links: 100,
        is_plane: true,
        clauses: "",
        calls: ALL,
        profiles: BOTH,
        limit: 60.0,
    },
    // That it compiles is what is asked.
    Row {
        name: "100 in space",
        links: 100,
        is_plane: false,
        clauses: "",
        calls: DYNAMICS,
        profiles: BOTH,
        limit: f64::INFINITY,
    },
];

/// Builds and prints all; the verdicts on them.
pub(crate) fn verdicts(folders: &Folders) -> Result<Vec<Verdict>, String> {
    let mut verdicts = Vec::new();
    println!("long models, build, s");
    for row in &ROWS {
        let main = row.source();
        for profile in row.profiles {
            let name = row.name.replace([' ', ','], "-");
            let seconds = build_seconds(folders, &format!("long-{name}"), &main, *profile)?;
            let kind = format!("{profile:?}");
            println!("  {:<20} {kind:<8} {seconds:>7.1}", row.name);
            verdicts.push(Verdict {
                what: format!("{}, seconds of a build, {profile:?}", row.name),
                figure: seconds,
                target: row.limit,
                limit: row.limit,
            });
        }
    }
    Ok(verdicts)
}

impl Row {
    fn source(&self) -> String {
        let n = self.links;
        let (model, value) = if self.is_plane {
            (
                chain(n),
                format!("Model {{ m: [1.0; {n}], l: [0.1; {n}], g: 9.81 }}"),
            )
        } else {
            let value = format!(
                "Model {{ m: [1.0; {n}], link: [Vector3::new(0.05, 0.02, 0.5); {n}], \
                 center: [Vector3::new(0.01, 0.02, 0.25); {n}], inertia: [Matrix3::identity(); {n}], g: 9.81 }}"
            );
            (spatial::model(n, self.clauses), value)
        };
        let calls = self.calls.iter().map(|call| match *call {
            "taylor" => {
                "    let end = Problem::new(&model, *state).solve(1.0, Taylor::new());\n    \
                         println!(\"{:?}\", end.map(|end| end.q[0]));\n"
                    .to_owned()
            }
            call => format!("    println!(\"{{:?}}\", model.{call});\n"),
        });
        let calls: String = calls.collect();
        format!(
            "{model}\nfn main() {{\n    let model = {value};\n    \
             let state = &State::new(0.0, [0.1; {n}], [0.2; {n}]);\n{calls}}}\n"
        )
    }
}

/// A chain of pendulums, as a user declares it.
fn chain(links: usize) -> String {
    format!(
        "//! Written by lagrangian-bench.\nuse lagrangian::prelude::*;\n\n/// A chain.\n\
         #[derive(Lagrangian, Clone, Debug)]\n#[lagrangian(\n    coordinates(theta[{links}]),\n    define(\n        \
         p[0] = l[0] * [sin(theta[0]), -cos(theta[0])],\n        \
         p[i] = p[i - 1] + l[i] * [sin(theta[i]), -cos(theta[i])] for i in 1..{links},\n    ),\n    \
         kinetic = (0..{links}).map(|i| 0.5 * m[i] * dot(p[i]).norm_squared()).sum(),\n    \
         potential = (0..{links}).map(|i| m[i] * g * p[i].y).sum(),\n)]\n\
         struct Model {{ m: [f64; {links}], l: [f64; {links}], g: f64 }}\n"
    )
}
