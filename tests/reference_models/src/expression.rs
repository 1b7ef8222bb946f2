//! Rewriting of expressions as strings, from the spellings of the data to the declaration language.

/// How elementary functions are spelled: `x.sin()` or `sin(x)`.
#[derive(Clone, Copy)]
pub(crate) enum Spelling {
    Methods,
    Functions,
}

impl Spelling {
    /// The expression that the data gives in three spellings, in this one.
    pub(crate) fn of(self, spellings: &serde_json::Value) -> String {
        let text = |key: &str| {
            spellings[key]
                .as_str()
                .expect("an expression in three spellings")
        };
        match self {
            Self::Methods => text("rust_method").to_owned(),
            Self::Functions => powers_as_methods(text("rust_fn")),
        }
    }
}

/// The expression with every name (not of a function, not of a method) replaced by what `rename`
/// says.
pub(crate) fn renamed(expression: &str, rename: impl Fn(&str) -> String) -> String {
    let in_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut written = String::new();
    let mut rest = expression;
    while let Some(start) = rest.find(in_word) {
        let (before, tail) = rest.split_at(start);
        let (word, after) = tail.split_at(tail.find(|c| !in_word(c)).unwrap_or(tail.len()));
        let is_number = word.starts_with(|c: char| c.is_ascii_digit());
        written.push_str(before);
        if is_number || after.starts_with('(') {
            written.push_str(word);
        } else {
            written.push_str(&rename(word));
        }
        rest = after;
    }
    written + rest
}

/// `powi(x, n)` and `powf(x, y)` as `(x).powi(n)` and `(x).powf(y)`: powers exist as methods only.
fn powers_as_methods(expression: &str) -> String {
    let Some(start) = ["powi(", "powf("]
        .iter()
        .filter_map(|power| expression.find(power))
        .min()
    else {
        return expression.to_owned();
    };
    let name = &expression[start..start + 4];
    let arguments = inside_parentheses(&expression[start + 4..]);
    let after = &expression[start + 4 + arguments.len() + 2..];
    let (base, exponent) = arguments
        .rsplit_once(", ")
        .expect("a power of two arguments");
    format!(
        "{}({}).{name}({exponent}){}",
        &expression[..start],
        powers_as_methods(base),
        powers_as_methods(after),
    )
}

/// What stands between the parenthesis that `text` begins with and the one that closes it.
fn inside_parentheses(text: &str) -> &str {
    let mut depth = 0_usize;
    for (index, character) in text.char_indices() {
        match character {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return &text[1..index];
        }
    }
    panic!("a parenthesis is not closed: {text}");
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn powers_become_methods_and_functions_stay() {
        let spellings = json!({ "rust_fn": "-powi(sin(x + powf(a, 0.5)), 2)*powi(y, 3) + 1.0" });
        let written = Spelling::Functions.of(&spellings);
        assert_eq!(
            written,
            "-(sin(x + (a).powf(0.5))).powi(2)*(y).powi(3) + 1.0"
        );
    }

    #[test]
    fn names_are_replaced_and_nothing_else_is() {
        let written = renamed("0.5*t.sin() + sin(t)*tt - t1*t", |name| format!("<{name}>"));
        assert_eq!(written, "0.5*<t>.sin() + sin(<t>)*<tt> - <t1>*<t>");
    }
}
