//! The metadata of tables and files.

use crate::error::Error;

/// The keys that the library uses itself.
const RESERVED: [&str; 5] = ["lagrangian", "members", "points", "units", "ARROW:schema"];

/// Returns the metadata of a study: its version of the library, its number of members, the description of its points, and
/// what was given.
pub(crate) fn all(
    members: usize,
    points: String,
    given: &[(String, String)],
) -> Vec<(String, String)> {
    let known = [
        ("lagrangian", env!("CARGO_PKG_VERSION").to_owned()),
        ("members", members.to_string()),
        ("points", points),
    ];
    let known = known
        .into_iter()
        .map(|(key, value)| (key.to_owned(), value));
    known.chain(given.iter().cloned()).collect()
}

/// Returns an error if a key is given twice or is one of the library's.
pub(crate) fn check(given: &[(String, String)]) -> Result<(), Error> {
    for (place, (key, _)) in given.iter().enumerate() {
        if RESERVED.contains(&key.as_str()) {
            let text =
                format!("the metadata cannot have the key `{key}`, which every file has already");
            return Err(Error::Metadata(text));
        }
        if given[..place].iter().any(|(other, _)| other == key) {
            return Err(Error::Metadata(format!(
                "the metadata have the key `{key}` twice"
            )));
        }
    }
    Ok(())
}
