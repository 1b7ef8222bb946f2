//! The package `site/browser`, compiled to WebAssembly.

use std::error::Error;
use std::path::Path;
use std::process::Command;

use wasm_bindgen_cli_support::Bindgen;

use crate::pages::Files;

const TARGET: &str = "wasm32-unknown-unknown";

/// Compiles the exhibits to WebAssembly by cargo, and writes the functions through which JavaScript calls them.
///
/// # Errors
///
/// Cargo fails, or the target is not installed: the error says what to type.
pub fn browser_package(workspace: &Path, target: &Path) -> Result<Files, Box<dyn Error>> {
    check_target(workspace)?;
    println!("Compiling the models to WebAssembly");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo)
        .args([
            "build",
            "--release",
            "--package",
            "lagrangian-browser",
            "--target",
            TARGET,
            "--target-dir",
        ])
        .arg(target)
        .current_dir(workspace)
        .status()?;
    if !status.success() {
        return Err(
            "cargo could not compile the package `lagrangian-browser`; its messages are above"
                .into(),
        );
    }
    let module = target.join(TARGET).join("release/lagrangian_browser.wasm");
    let folder = target.join("browser-package");
    Bindgen::new()
        .input_path(module)
        .out_name("browser")
        .web(true)?
        .typescript(false)
        .remove_name_section(true)
        .generate(&folder)?;
    ["browser.js", "browser_bg.wasm"]
        .into_iter()
        .map(|name| Ok((name.to_string(), std::fs::read(folder.join(name))?)))
        .collect()
}

/// Returns an error that says what to type, unless the standard library of the target is installed.
fn check_target(workspace: &Path) -> Result<(), Box<dyn Error>> {
    let compiler = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let printed = Command::new(compiler)
        .args(["--print", "target-libdir", "--target", TARGET])
        .current_dir(workspace)
        .output()?;
    let folder = String::from_utf8(printed.stdout)?;
    if printed.status.success() && Path::new(folder.trim()).exists() {
        return Ok(());
    }
    Err(format!(
        "the page in the browser needs the target {TARGET}, which is not installed: type\n\n    rustup target add {TARGET}\n\nor \
         leave the page out by `--without-browser`"
    )
    .into())
}
