//! Equations of motion on a terminal.

/// The length of a line of text.
const LINE: usize = 96;

/// Equations as `EQUATIONS` of a model has them, indented, and broken before a sign where a line would be too long.
#[must_use]
pub fn wrapped(equations: &str) -> String {
    equations.lines().map(wrapped_line).collect()
}

fn wrapped_line(equation: &str) -> String {
    // The dots over a letter take no place of their own.
    let is_wide = |c: &char| !matches!(c, '\u{307}' | '\u{308}');
    let (mut text, mut length) = (String::from(" "), 1);
    for term in terms(equation).split('\n') {
        let width = term.chars().filter(is_wide).count();
        if length > 1 && length + 1 + width > LINE {
            text.push_str("\n        ");
            length = 8;
        }
        length += 1 + width;
        text.push(' ');
        text.push_str(term);
    }
    text + "\n"
}

/// The terms of an equation with their signs, each on a line. Signs within brackets part nothing.
fn terms(equation: &str) -> String {
    let (mut terms, mut depth) = (String::new(), 0_usize);
    for word in equation.split(' ') {
        let is_sign = depth == 0 && matches!(word, "+" | "−");
        terms.push(if is_sign { '\n' } else { ' ' });
        terms.push_str(word);
        depth += word.matches(['(', '[']).count();
        depth = depth.saturating_sub(word.matches([')', ']']).count());
    }
    terms.split_off(1)
}

#[cfg(test)]
mod tests {
    use super::{terms, wrapped};

    #[test]
    fn terms_part_at_signs_outside_of_brackets() {
        assert_eq!(
            terms("f[φ] = a − b (c + d) e + f"),
            "f[φ] = a\n− b (c + d) e\n+ f"
        );
    }

    #[test]
    fn long_equations_are_broken_before_a_sign() {
        assert_eq!(wrapped("a = b + c"), "  a = b + c\n");
        let sentence = "word ".repeat(25) + "end";
        assert_eq!(wrapped(&sentence), format!("  {sentence}\n"));
        let term = "θ̇".repeat(60);
        assert_eq!(
            wrapped(&format!("f = {term} − {term}\n\na = b")),
            format!("  f = {term}\n         − {term}\n  \n  a = b\n")
        );
    }
}
