//! What the pages of all models of the workspace say, read by a parser that shares nothing with the printer, and compared with
//! what their methods compute.

mod formula;
mod jet;
mod latex;
mod lines;
mod meanings;
mod notation;
mod random;
mod reader;
mod recursion;
mod subject;
mod suite;
mod surroundings;
mod token;
mod unicode;
mod value;
mod words;

use std::env;

use self::lines::Notation;
use self::random::Random;
use self::reader::{Reader, close};
use self::subject::Subject;
use self::value::Reading;

/// The states at which each page is read.
const STATES: usize = 2;

/// Reads both pages of a model.
fn read(subject: &Subject, random: &mut Random) -> Reading<()> {
    let mut states = 0;
    for _ in 0..8 * STATES {
        let Some(state) = subject.state(random) else {
            return Ok(());
        };
        let found: [Reading<_>; 2] = [Notation::Unicode, Notation::Latex].map(|notation| {
            let page = match notation {
                Notation::Unicode => &subject.listing.unicode,
                Notation::Latex => &subject.listing.latex,
            };
            let Some(mut reader) = Reader::new(subject, notation, &state)? else {
                return Ok(None);
            };
            reader.read(page)?;
            Ok(Some(reader.found))
        });
        let [unicode, latex] = found;
        let (Some(unicode), Some(latex)) = (unicode?, latex?) else {
            continue;
        };
        if unicode.len() != latex.len() {
            return Err("other equations in LaTeX".into());
        }
        for (x, y) in unicode.iter().flatten().zip(latex.iter().flatten()) {
            if !close(*x, *y) {
                return Err(format!("{x} in Unicode, {y} in LaTeX"));
            }
        }
        states += 1;
        if states == STATES {
            break;
        }
    }
    Ok(())
}

/// `PAGES=models/src cargo test -p lagrangian-derive pages_say -- --nocapture` prints the pages of the models in files whose path
/// contains the text, and reads no others.
#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn pages_say_what_the_methods_compute() {
    let count = read_pages(1);
    assert!(
        count >= 400 || env::var("PAGES").is_ok(),
        "only {count} models were found"
    );
}

#[test]
fn some_pages_say_what_the_methods_compute() {
    assert!(read_pages(10) >= 36);
}

/// Reads the pages of one declaration of so many; how many models those have.
fn read_pages(stride: usize) -> u32 {
    let only = env::var("PAGES").ok();
    let mut failures = Vec::new();
    let mut count = 0;
    for found in suite::declarations().into_iter().step_by(stride) {
        if only
            .as_ref()
            .is_some_and(|part| !found.place.contains(part))
        {
            continue;
        }
        for subject in Subject::all(found.declaration) {
            count += 1;
            if only.is_some() {
                println!(
                    "{}: {}\n{}",
                    found.place, subject.name, subject.listing.unicode
                );
            }
            // States of its own, whatever other models there are.
            let seed = subject.name.bytes().map(u64::from).sum();
            if let Err(error) = read(&subject, &mut Random::new(seed)) {
                failures.push(format!("{}: {}\n{error}", found.place, subject.name));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
    count
}

/// Lines that are wrong in a sign, in a number or in a name, and pages from which a line is missing.
#[test]
fn some_of_what_is_wrong_is_found() {
    what_is_wrong_is_found_in(5);
}

#[test]
#[ignore = "all lines"]
fn what_is_wrong_is_found() {
    what_is_wrong_is_found_in(1);
}

/// In one of so many lines.
fn what_is_wrong_is_found_in(stride: usize) {
    let changes = [
        [" + ", " − "],
        [" − ", " + "],
        ["½", "⅓"],
        ["sin", "cos"],
        ["²", "³"],
        ["₁", "₂"],
        ["\u{307}", ""],
        ["max", "min"],
    ];
    let mut count = 0;
    for found in suite::declarations_below("derive/golden/pages") {
        for mut subject in Subject::all(found.declaration) {
            let page = subject.listing.unicode.clone();
            let lines = page.lines().filter(|line| line.contains(" = "));
            for line in lines.step_by(stride) {
                if line.ends_with(':') || line.starts_with("q = ") {
                    continue;
                }
                for [from, to] in changes {
                    let wrong = line.replacen(from, to, 1);
                    if wrong == line {
                        continue;
                    }
                    subject.listing.unicode = page.replacen(line, &wrong, 1);
                    let result = read(&subject, &mut Random::new(count));
                    assert!(result.is_err(), "{}: {line}\n{wrong}", subject.name);
                    count += 1;
                }
            }
        }
    }
    assert!(count > 30, "{count}");
}
