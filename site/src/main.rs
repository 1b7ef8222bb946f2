//! Writes the site of the ready models into `target/site`, and serves it with `--serve`.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use lagrangian_site::{browser_package, pages, recordings, serve};

const HELP: &str = "\
Writes a gallery of the ready models, and a page that integrates them in the browser, into target/site.

    cargo run --release -p lagrangian-site -- [--serve] [--port PORT] [--without-browser]

    --serve            serves the site on this machine, until Ctrl-C
    --port PORT        serves it on this port; 8080 by default
    --without-browser  leaves out the page in the browser, which takes the target wasm32-unknown-unknown";

const PORT: u16 = 8080;

/// What the command line says.
struct Options {
    is_served: bool,
    port: u16,
    has_browser: bool,
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let Some(options) = options()? else {
        println!("{HELP}");
        return Ok(());
    };
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .unwrap_or(Path::new("."))
        .to_path_buf();
    let target = std::env::var_os("CARGO_TARGET_DIR")
        .map_or_else(|| workspace.join("target"), PathBuf::from);
    let folder = target.join("site");
    let mut files = pages(&recordings()?)?;
    if options.has_browser {
        files.extend(browser_package(&workspace, &target)?);
    }
    if folder.exists() {
        std::fs::remove_dir_all(&folder)?;
    }
    for (name, content) in &files {
        let path = folder.join(name);
        if let Some(parent) = path.parent() {
            std::fs::create_dir_all(parent)?;
        }
        std::fs::write(path, content)?;
    }
    println!("{} files in {}", files.len(), folder.display());
    if options.is_served {
        serve(&files, options.port)
    } else {
        Ok(())
    }
}

/// Reads the command line; `None` asks for help.
fn options() -> Result<Option<Options>, String> {
    let mut options = Options {
        is_served: false,
        port: PORT,
        has_browser: true,
    };
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--help" | "-h" => return Ok(None),
            "--serve" => options.is_served = true,
            "--without-browser" => options.has_browser = false,
            "--port" => {
                let port = arguments.next().and_then(|port| port.parse().ok());
                options.port = port.ok_or("write a number between 1 and 65535 behind `--port`")?;
            }
            other => return Err(format!("`{other}` is no option\n\n{HELP}")),
        }
    }
    Ok(Some(options))
}
