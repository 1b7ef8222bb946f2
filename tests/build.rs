//! Writes the models of the reference data into the folder of the build.

use std::{env, fs, path::Path};

use serde_json::Value;

fn main() {
    println!("cargo::rerun-if-changed=data");
    // An odd number: the two spellings of functions take turns.
    let stride = if cfg!(feature = "all-cases") { 1 } else { 9 };
    write(
        "public_case.rs",
        &lagrangian_reference_models::random_lagrangians(
            &document("data/public_cases.json"),
            stride,
        ),
    );
    write(
        "trajectory.rs",
        &lagrangian_reference_models::trajectories(&document("data/references_public.json")),
    );
}

fn document(path: &str) -> Value {
    let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("{path}: {error}"));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn write(name: &str, source: &str) {
    let directory = env::var("OUT_DIR").expect("cargo sets OUT_DIR for build scripts");
    fs::write(Path::new(&directory).join(name), source).expect("OUT_DIR can be written to");
}
