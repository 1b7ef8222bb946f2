//! The facets of an STL file, text or binary.
//!
//! Format: M. Burns, *Automated Fabrication*, 1993, section 6.5. Files in use differ from it: keywords may be in any
//! case, several solids may follow one another, names may contain blanks or be missing, the last `endsolid` may be
//! missing, and the header of a binary file may begin with `solid`. A file is binary if its length matches its number
//! of facets; in a text, the bytes in place of this number do not match its length.

use std::format;
use std::io::{Error, ErrorKind};
use std::str::FromStr;
use std::string::String;
use std::vec::Vec;

/// The corners of a facet.
pub(super) type Facet = [[f32; 3]; 3];

/// The number of bytes before the number of facets; a facet consists of a normal, three corners, and two more bytes.
const HEADER: usize = 80;
const FACET: usize = 50;

fn invalid(message: String) -> Error {
    Error::new(ErrorKind::InvalidData, message)
}

/// Returns the facets of all solids of a file.
pub(super) fn facets(bytes: &[u8]) -> Result<Vec<Facet>, Error> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let counted = bytes
        .get(HEADER..)
        .and_then(|rest| rest.split_first_chunk());
    let counted = counted.map(|(count, rest)| (u32::from_le_bytes(*count), rest));
    let expected = |count: u32| usize::try_from(count).ok()?.checked_mul(FACET);
    match counted {
        Some((count, rest)) if expected(count) == Some(rest.len()) => Ok(binary(rest)),
        _ if is_text(bytes) => text(bytes),
        Some((count, rest)) => Err(invalid(format!(
            "a binary file of {count} facets has {FACET} bytes for each after the first {}, not {}; a text begins with `solid`",
            HEADER + 4,
            rest.len()
        ))),
        None => Err(invalid(format!(
            "{} bytes are no binary file, which has at least {}, and a text begins with `solid`",
            bytes.len(),
            HEADER + 4
        ))),
    }
}

fn is_text(bytes: &[u8]) -> bool {
    let word = bytes.trim_ascii_start();
    let is_solid = word
        .get(..5)
        .is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    is_solid && word.get(5).is_none_or(u8::is_ascii_whitespace)
}

fn binary(facets: &[u8]) -> Vec<Facet> {
    let (facets, _) = facets.as_chunks::<FACET>();
    let corners = |facet: &[u8; FACET]| {
        let (numbers, _) = facet.as_chunks::<4>();
        core::array::from_fn(|i| {
            core::array::from_fn(|k| f32::from_le_bytes(numbers[3 + 3 * i + k]))
        })
    };
    facets.iter().map(corners).collect()
}

/// A word of a text, with its line number.
struct Word<'a> {
    line: usize,
    text: &'a [u8],
}

impl Word<'_> {
    fn is(&self, keyword: &str) -> bool {
        self.text.eq_ignore_ascii_case(keyword.as_bytes())
    }

    fn error(&self, expected: &str) -> Error {
        let Self { line, text } = self;
        let found = String::from_utf8_lossy(text);
        invalid(format!(
            "in line {line} there is `{found}` in place of {expected}"
        ))
    }
}

/// Returns the words of a text, without the names of solids.
fn words(bytes: &[u8]) -> impl Iterator<Item = Word<'_>> {
    let lines = bytes.split(|byte| matches!(byte, b'\n' | b'\r'));
    lines.zip(1..).flat_map(|(text, line)| {
        let words = text.split(u8::is_ascii_whitespace);
        let words = words.filter(|word| !word.is_empty());
        let mut is_named = false;
        words
            .map(move |text| Word { line, text })
            .take_while(move |word| {
                let is_name = is_named;
                is_named = word.is("solid") || word.is("endsolid");
                !is_name
            })
    })
}

/// Returns the facets of a text.
fn text(bytes: &[u8]) -> Result<Vec<Facet>, Error> {
    let mut words = words(bytes);
    let mut facets = Vec::new();
    let mut is_within = false;
    while let Some(word) = words.next() {
        if word.is("solid") {
            is_within = true;
        } else if word.is("endsolid") && is_within {
            is_within = false;
        } else if word.is("facet") && is_within {
            facets.push(facet(&mut words)?);
        } else if is_within {
            return Err(word.error("`facet` or `endsolid`"));
        } else {
            return Err(word.error("`solid`"));
        }
    }
    if facets.is_empty() {
        return Err(invalid(String::from(
            "the text has no facet: the first one begins in the line after that of `solid`",
        )));
    }
    Ok(facets)
}

/// Parses the facet that follows the word `facet`.
fn facet<'a>(words: &mut impl Iterator<Item = Word<'a>>) -> Result<Facet, Error> {
    keyword(words, "normal")?;
    // Normals follow from the corners.
    let _: [f64; 3] = numbers(words)?;
    keyword(words, "outer")?;
    keyword(words, "loop")?;
    let mut corners = [[0.0; 3]; 3];
    for corner in &mut corners {
        keyword(words, "vertex")?;
        *corner = numbers(words)?;
    }
    keyword(words, "endloop")?;
    keyword(words, "endfacet")?;
    Ok(corners)
}

fn next<'a>(words: &mut impl Iterator<Item = Word<'a>>, expected: &str) -> Result<Word<'a>, Error> {
    let ends = || invalid(format!("the file ends in place of {expected}"));
    words.next().ok_or_else(ends)
}

fn keyword<'a>(words: &mut impl Iterator<Item = Word<'a>>, keyword: &str) -> Result<(), Error> {
    let expected = format!("`{keyword}`");
    let word = next(words, &expected)?;
    if word.is(keyword) {
        Ok(())
    } else {
        Err(word.error(&expected))
    }
}

fn numbers<'a, T: FromStr + Copy + Default>(
    words: &mut impl Iterator<Item = Word<'a>>,
) -> Result<[T; 3], Error> {
    let mut found = [T::default(); 3];
    for number in &mut found {
        let word = next(words, "a number")?;
        let parsed = str::from_utf8(word.text).ok().and_then(|x| x.parse().ok());
        *number = parsed.ok_or_else(|| word.error("a number"))?;
    }
    Ok(found)
}
