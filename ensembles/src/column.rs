//! Columns of tables.

/// A column of a table: its name, its unit, and the histogram that a [`Summary`](crate::Summary) is to contain.
///
/// Wherever a column is asked for, a name alone suffices: `["flips", "energy"]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    pub(crate) name: String,
    pub(crate) unit: String,
    pub(crate) bins: Option<Bins>,
}

/// The bins of a histogram, all of one width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bins {
    pub(crate) low: f64,
    pub(crate) high: f64,
    pub(crate) count: usize,
}

impl Column {
    /// Creates a column of pure numbers.
    pub fn new(name: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            unit: String::new(),
            bins: None,
        }
    }

    /// Sets the unit, as text.
    #[must_use]
    pub fn unit(mut self, unit: impl Into<String>) -> Self {
        self.unit = unit.into();
        self
    }

    /// Counts the values in bins of one width between `low` and `high` ([`Histogram`](crate::Histogram)).
    #[must_use]
    pub fn histogram(mut self, low: f64, high: f64, count: usize) -> Self {
        self.bins = Some(Bins { low, high, count });
        self
    }
}

impl From<&str> for Column {
    fn from(name: &str) -> Self {
        Self::new(name)
    }
}
