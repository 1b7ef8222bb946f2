//! The site of the ready models: a gallery in HTML, and a page that integrates them in the browser.
//!
//! `cargo run --release -p lagrangian-site` writes it into `target/site`, and with `-- --serve` it also serves it. Both parts share
//! the descriptions in `exhibits`. Nothing is fetched from another site.

mod browser_package;
mod equations;
mod figure;
mod markup;
mod model_page;
mod pages;
mod plot;
mod recording;
mod server;
mod source;

pub use browser_package::browser_package;
pub use equations::{EquationError, mathml};
pub use pages::{Files, pages};
pub use recording::{Recording, recordings};
pub use server::serve;
pub use source::{Source, read};
