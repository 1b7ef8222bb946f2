//! Whether what was measured is what was wanted.

/// A figure that should not be greater than a target, and must not be greater than a limit.
#[derive(Clone, Debug)]
pub(crate) struct Verdict {
    pub(crate) what: String,
    pub(crate) figure: f64,
    pub(crate) target: f64,
    pub(crate) limit: f64,
}

impl Verdict {
    /// A figure that is not a number misses everything.
    fn misses(&self, bound: f64) -> bool {
        self.figure.is_nan() || self.figure > bound
    }

    /// One line, with what is missed.
    pub(crate) fn line(&self) -> String {
        let Self {
            what,
            figure,
            target,
            limit,
        } = self;
        let missed = if self.misses(*limit) {
            "  LIMIT MISSED"
        } else if self.misses(*target) {
            "  target missed"
        } else {
            ""
        };
        format!("{what}: {figure:.2} (target {target}, limit {limit}){missed}")
    }
}

/// Prints all, and is an error where a limit is missed.
pub(crate) fn judge(verdicts: &[Verdict]) -> Result<(), String> {
    println!("\nRatios:");
    for verdict in verdicts {
        println!("  {}", verdict.line());
    }
    let missed = verdicts
        .iter()
        .filter(|verdict| verdict.misses(verdict.limit));
    match missed.count() {
        0 => Ok(()),
        count => Err(format!("{count} limits are missed")),
    }
}
