//! Writes the models of a file of data as Rust, each in a file of its own, so that what the compiler says of one
//! can be told from what it says of another. The environment variable `ADVERSARIAL_MODELS` names another file.

use std::{
    collections::BTreeSet,
    env,
    fmt::Write as _,
    fs,
    path::{Path, PathBuf},
};

use serde_json::Value;

fn main() {
    println!("cargo::rerun-if-env-changed=ADVERSARIAL_MODELS");
    let root = env::var("CARGO_MANIFEST_DIR").expect("cargo sets CARGO_MANIFEST_DIR");
    let files = env::var_os("ADVERSARIAL_MODELS").map_or_else(
        || {
            ["passing", "motions", "constrained"]
                .map(|name| format!("models/{name}.json").into())
                .into()
        },
        |file| vec![PathBuf::from(file)],
    );
    let files: Vec<PathBuf> = files
        .iter()
        .map(|file| Path::new(&root).join(file))
        .collect();
    let joined = env::join_paths(&files).expect("paths without the separator of paths");
    println!("cargo::rustc-env=MODELS={}", joined.display());
    let documents: Vec<Value> = files.iter().map(|file| read_document(file)).collect();

    let folder = PathBuf::from(env::var("OUT_DIR").expect("cargo sets OUT_DIR"));
    let (mut modules, mut rows) = (String::new(), String::new());
    let models = documents
        .iter()
        .flat_map(|document| list(&document["models"]));
    for model in models {
        let id = text_of(&model["id"]);
        let path = folder.join(format!("{id}.rs"));
        write_file(&path, &source(model));
        let path = path.display().to_string();
        writeln!(modules, "mod {id} {{ include!({path:?}); }}").expect("strings accept everything");
        writeln!(rows, "    ({id:?}, {id}::evaluate),").expect("strings accept everything");
    }
    let table = format!(
        "{modules}\n/// The models, by identifier.\npub const MODELS: &[(&str, Evaluate)] = &[\n{rows}];\n"
    );
    write_file(&folder.join("models.rs"), &table);
}

fn read_document(file: &Path) -> Value {
    println!("cargo::rerun-if-changed={}", file.display());
    let text = fs::read_to_string(file).expect("the file of models can be read");
    serde_json::from_str(&text).expect("the file of models is JSON")
}

/// A model: its declaration, its constructor, and the function that evaluates all of it.
fn source(model: &Value) -> String {
    let fields = list(&model["fields"]);
    let inits: Vec<String> = fields
        .iter()
        .map(|f| format!("{}: {}", text_of(&f["name"]), read(f)))
        .collect();
    let inits = inits.join(", ");
    let inputs: Vec<&str> = fields
        .iter()
        .filter(|f| f["input"] == true)
        .map(|f| text_of(&f["name"]))
        .collect();
    let calls = calls(model, &inputs);
    let outputs = model["outputs"].as_object().expect("outputs by name");
    let outputs = if outputs.is_empty() {
        String::new()
    } else {
        let n = &model["n"];
        format!("let outputs = Lagrangian::<{n}>::outputs(&model, &at.state());\n    ")
    };
    format!(
        "use lagrangian::prelude::*;
use lagrangian::rigid_body::InertiaTensor;
use crate::{{At, Found, Values, external}};

{}
impl Model {{
    fn new(values: &mut Values) -> Self {{
        Self {{ {inits} }}
    }}
}}

pub(crate) fn evaluate(at: &At) -> Vec<Found> {{
    let model = Model::new(&mut Values::of(at));
    {outputs}{calls}
        .collect()
}}
",
        text_of(&model["declaration"])
    )
}

/// The calls that integrate motions of the model: those alone that a state asks for.
fn motions(model: &Value) -> String {
    let n = model["n"].as_u64().expect("a number of coordinates");
    let states = list(&model["states"]);
    let asked_for = |name: &&str| {
        states
            .iter()
            .any(|state| state["values"].get(*name).is_some())
    };
    let methods = ["taylor", "dop853"].into_iter().filter(asked_for);
    let calls: Vec<String> = match text_of(&model["motion"]["compared"]) {
        "ends" if model["motion"]["reduced"] == true => {
            let places = list(&model["ignorable"]);
            let (k, rest) = (
                places.len(),
                usize::try_from(n).expect("few coordinates") - places.len(),
            );
            let places: Vec<String> = places.iter().map(ToString::to_string).collect();
            let places = places.join(", ");
            let call = |method| {
                format!("reduced_ends::{method}::<Model, {n}, {rest}, {k}>(&model, [{places}], at)")
            };
            methods.map(call).collect()
        }
        "ends" => methods
            .map(|method| format!("ends::{method}::<Model, {n}>(&model, at)"))
            .collect(),
        "splits" => {
            let name = |state: &Value| {
                let run = &state["run"];
                let watched = if run["declared"] == true {
                    "declared"
                } else {
                    "sampled"
                };
                format!("{}_{watched}", text_of(&run["method"]))
            };
            let names: BTreeSet<String> = states.iter().map(name).collect();
            let call = |name: &String| format!("splits::{name}::<Model, {n}>(&model, at)");
            names.iter().map(call).collect()
        }
        what => vec![format!("{what}::<Model, {n}>(&model, at)")],
    };
    let calls: Vec<String> = calls.iter().map(|call| format!("crate::{call}")).collect();
    format!(
        "[{}]\n        .concat()\n        .into_iter()",
        calls.join(", ")
    )
}

/// The call that evaluates the motion, and those chained to it for what else the model has.
fn calls(model: &Value, inputs: &[&str]) -> String {
    if model["motion"].is_object() {
        return motions(model);
    }
    // A model with inputs as arguments is of another type.
    let function = |of: &str| match model["constraints"].as_u64() {
        None => format!("crate::motion::<{of}, {}>", model["n"]),
        Some(constraints) => format!("crate::constrained::<{of}, {}, {constraints}>", model["n"]),
    };
    let mut calls = format!("{}(&model, at)\n        .into_iter()", function("Model"));
    if model["energy_balance"] == true {
        write!(calls, "\n        .chain(crate::energy_rate(&model, at))")
            .expect("strings accept everything");
    }
    if model["energies"] == true {
        write!(calls, "\n        .chain(crate::energies(&model, at))")
            .expect("strings accept everything");
    }
    if !inputs.is_empty() {
        let unset: Vec<String> = inputs
            .iter()
            .map(|name| format!("{name}: nowhere.{name}"))
            .collect();
        let unset = unset.join(", ");
        write!(
            calls,
            "\n        .chain(crate::driven(&model, at))
        .chain({{
            let nowhere = Model::new(&mut Values::unknown());
            let unset = Model {{ {unset}, ..model.clone() }};
            {}(&unset.with_inputs(model.inputs()), at)
        }})",
            function("_")
        )
        .expect("strings accept everything");
    }
    let outputs = model["outputs"].as_object().expect("outputs by name");
    if let Some(ignorable) = model["ignorable"].as_array() {
        write_reduced(&mut calls, model, ignorable);
    }
    for (name, shape) in outputs {
        let value = match list(shape).len() {
            0 => format!("vec![outputs.{name}]"),
            _ => format!("crate::rows(&outputs.{name})"),
        };
        write!(
            calls,
            "\n        .chain([(\"output {name}\", Ok({value}))])"
        )
        .expect("strings accept everything");
    }
    calls
}

/// The calls for the reduced model and its outputs.
fn write_reduced(calls: &mut String, model: &Value, ignorable: &[Value]) {
    let all = model["n"].as_u64().expect("a number of coordinates");
    let (n, k) = (all, ignorable.len());
    let places: Vec<String> = ignorable.iter().map(ToString::to_string).collect();
    let places = places.join(", ");
    let rest = usize::try_from(n).expect("few coordinates") - k;
    write!(
        calls,
        "\n        .chain(crate::reduced::<Model, {n}, {rest}, {k}>(&model, [{places}], at))"
    )
    .expect("strings accept everything");
    let outputs = model["outputs"].as_object().expect("outputs by name");
    if outputs.is_empty() {
        return;
    }
    let rows = outputs.iter().map(|(name, shape)| {
        let value = match list(shape).len() {
            0 => format!("vec![outputs.{name}]"),
            _ => format!("crate::rows(&outputs.{name})"),
        };
        format!("(\"reduced output {name}\", Ok({value}))")
    });
    let rows: Vec<String> = rows.collect();
    write!(
        calls,
        "\n        .chain({{
            let (reduced, state) = model.reduce(&at.state::<{n}>());
            let outputs = Lagrangian::<{rest}>::outputs(&reduced, &state);
            [{}]
        }})",
        rows.join(", ")
    )
    .expect("strings accept everything");
}

/// How a field is read from the values in order.
fn read(field: &Value) -> String {
    let one = if let Some(body) = field["body"].as_str() {
        let arguments = match body {
            "RigidBody" => "1.0, Vector3::zeros(), InertiaTensor::principal([1.0; 3])",
            "PrincipalBody" => "1.0, [1.0; 3]",
            _ => "1.0, 0.0, 1.0, 1.0",
        };
        // No real body has any numbers, and a formula does not care.
        format!("{body}::new({arguments}).expect(\"a body\").map(|_| values.number())")
    } else if list(&field["shape"]).is_empty() {
        "values.number()".to_owned()
    } else {
        "values.matrix()".to_owned()
    };
    match field["family"].as_u64() {
        None => one,
        Some(_) => format!("std::array::from_fn(|_| {one})"),
    }
}

fn write_file(path: &Path, text: &str) {
    // What has not changed keeps its time, and is not compiled again.
    if fs::read_to_string(path).is_ok_and(|before| before == text) {
        return;
    }
    fs::write(path, text).expect("OUT_DIR can be written to");
}

fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

fn text_of(value: &Value) -> &str {
    value.as_str().expect("a string")
}
