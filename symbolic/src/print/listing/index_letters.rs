//! The letters of indices on a page: i, j, k and l, unless the model has names of these letters.

use std::collections::BTreeSet;

/// What each of the usual letters is written as.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct IndexLetters([char; 4]);

/// The usual letters.
const USUAL: [char; 4] = ['i', 'j', 'k', 'l'];
/// Letters that take their places; all of them can stand below the line.
const OTHERS: [char; 4] = ['n', 'r', 's', 'a'];

impl IndexLetters {
    /// The usual letters, as far as none of the names is printed as one of them or as one with something below it.
    pub(crate) fn free(stems: &BTreeSet<String>) -> Self {
        let is_free = |letter: char| !stems.contains(&letter.to_string());
        let mut others = OTHERS.into_iter().filter(|letter| is_free(*letter));
        Self(USUAL.map(|letter| {
            if is_free(letter) {
                letter
            } else {
                others.next().unwrap_or(letter)
            }
        }))
    }

    /// What a usual letter is written as.
    pub(crate) fn written(self, letter: char) -> char {
        let mut all = USUAL.into_iter().zip(self.0);
        all.find(|(usual, _)| *usual == letter)
            .map_or(letter, |(_, written)| written)
    }

    /// The same of a letter as a text.
    pub(crate) fn text(self, letter: char) -> String {
        self.written(letter).to_string()
    }
}

impl Default for IndexLetters {
    fn default() -> Self {
        Self(USUAL)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_of_the_model_are_not_indices() {
        let stems = ["k", "i", "x"].map(String::from).into();
        let letters = IndexLetters::free(&stems);
        assert_eq!(
            USUAL.map(|letter| letters.written(letter)),
            ['n', 'j', 'r', 'l']
        );
    }
}
