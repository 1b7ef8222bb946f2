//! The sentences of a page: each is of a kind that is known, and what it claims is compared.

use super::formula::Formula;
use super::reader::{Part, Reader, same_if_known};
use super::token::Indices;
use super::value::Reading;

impl Reader<'_> {
    /// Reads a heading or a sentence.
    pub(super) fn words(&mut self, words: &str) -> Reading<()> {
        if self.begin(words)? || self.letter(words) || is_remark(words) {
            return Ok(());
        }
        if let Some(base) = base_acceleration(words) {
            let base = self.notation.formula(base.trim_matches('$'))?;
            self.recursion.begin_with(base);
            return Ok(());
        }
        let constant = words.strip_suffix(" is constant.");
        let constant = constant.or_else(|| words.strip_suffix(" are constant."));
        if let Some(names) = constant {
            let names = names.replace('$', "");
            return names
                .split(", ")
                .flat_map(|names| names.split(" and "))
                .try_for_each(|name| self.constant(name));
        }
        if words.contains("too long to be written out") {
            return self.left_out(words);
        }
        Err("what does this say?".into())
    }

    /// `K is the kinetic energy, since a name of the model is printed as T.`
    fn letter(&mut self, words: &str) -> bool {
        let Some((said, usual)) = words.split_once(", since a name of the model is printed as ")
        else {
            return false;
        };
        let letter = said.split(' ').next().unwrap_or_default();
        let usual = usual.split([' ', '.']).next().unwrap_or_default();
        let mut letters = self.letters.iter_mut();
        if let Some((_, known)) = letters.find(|(quantity, _)| **quantity == usual) {
            let formula = self.notation.formula(letter.trim_matches('$'));
            if let Ok(Formula::Name(name)) = formula {
                *known = name.written(&Indices::new());
            }
        }
        true
    }

    fn constant(&mut self, name: &str) -> Reading<()> {
        let formula = self.notation.formula(name)?;
        let Formula::Name(name) = formula else {
            return Err("no name".into());
        };
        let rate = self.rate(&name.written(&self.free.indices));
        same_if_known(rate, 0.0)
    }

    /// `The equation is`, `One of 3 equations is`, `The 3 equations are` and `2 of 3 equations are too long …`.
    fn left_out(&mut self, words: &str) -> Reading<()> {
        let first: Vec<&str> = words.split(' ').take(3).collect();
        let count = match &*first {
            ["The", "equation", _] | ["One", "of", _] => 1,
            ["The", count, _] | [count, "of", _] => count
                .parse()
                .map_err(|_| format!("how many are {count}?"))?,
            _ => return Err("how many?".into()),
        };
        match self.part {
            Part::Momenta => self.momenta += count,
            Part::Lagrange => self.read += count,
            Part::Constraints => self.constraints += count,
            _ => {}
        }
        Ok(())
    }
}

/// Sentences that claim nothing that has a value.
fn is_remark(words: &str) -> bool {
    let is_found = words.starts_with("They are found ") && words.ends_with('.');
    let beginnings = ["The mass matrix is diagonal: ", "e is a", "$e$ is a"];
    is_found
        || words.contains(" printed as in the declaration, since ")
        || beginnings
            .iter()
            .any(|beginning| words.starts_with(beginning))
}

/// `Before the first link nothing turns, and the acceleration is g e_z. …`
fn base_acceleration(words: &str) -> Option<&str> {
    let beginning = "Before the first link nothing turns, and the acceleration is ";
    Some(words.strip_prefix(beginning)?.split_once(". ")?.0)
}
