//! A server of the files of the site, for this machine.

use std::error::Error;

use tiny_http::{Header, Response, Server};

use crate::pages::Files;

/// Serves files on `127.0.0.1` until the program is stopped.
///
/// # Errors
///
/// The port is in use.
pub fn serve(files: &Files, port: u16) -> Result<(), Box<dyn Error>> {
    let server = Server::http(("127.0.0.1", port)).map_err(|error| {
        format!("cannot serve on port {port}: {error}; choose another one by `--port`")
    })?;
    println!("Serving http://127.0.0.1:{port}/ until Ctrl-C");
    for request in server.incoming_requests() {
        let path = request.url().split(['?', '#']).next().unwrap_or_default();
        let name = match path.trim_start_matches('/') {
            "" => "index.html".to_string(),
            name => name.to_string(),
        };
        // A browser that has gone away is no error of the server.
        let _ = match files.get(&name) {
            Some(content) => {
                request.respond(Response::from_data(content.clone()).with_header(kind(&name)?))
            }
            None => request
                .respond(Response::from_string("There is no such page.").with_status_code(404)),
        };
    }
    Ok(())
}

/// The kind of a file by its ending.
fn kind(name: &str) -> Result<Header, Box<dyn Error>> {
    let kind = match name.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("wasm") => "application/wasm",
        _ => "application/octet-stream",
    };
    Header::from_bytes("Content-Type", kind).map_err(|()| "a header is not text".into())
}
