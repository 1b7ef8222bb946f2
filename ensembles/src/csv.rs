//! Tables as text.

use std::path::Path;

use crate::error::Error;
use crate::table::{ERROR, MEMBER, Table};

impl Table {
    /// Writes the table as comma-separated values: a line with the names of the columns and their units in brackets, and
    /// a line for each row. Missing values are empty; a number is the shortest one that is read back as it was.
    ///
    /// # Errors
    ///
    /// [`Error::File`].
    pub fn write_csv(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        let path = path.as_ref();
        self.write_lines(path).map_err(Error::file(path, "written"))
    }

    fn write_lines(&self, path: &Path) -> Result<(), csv::Error> {
        let mut lines = csv::Writer::from_path(path)?;
        let names = self.columns().iter().map(|column| match &*column.unit {
            "" => column.name.clone(),
            unit => format!("{} [{unit}]", column.name),
        });
        let names = [MEMBER.to_owned()].into_iter().chain(names);
        lines.write_record(names.chain([ERROR.to_owned()]))?;
        for (row, (member, message)) in self.members().iter().zip(self.messages()).enumerate() {
            lines.write_field(member.to_string())?;
            for values in self.values() {
                let value = values[row];
                let text = if value.is_nan() {
                    String::new()
                } else {
                    format!("{value:?}")
                };
                lines.write_field(text)?;
            }
            lines.write_field(message.unwrap_or_default())?;
            lines.write_record(None::<&[u8]>)?;
        }
        lines.flush()?;
        Ok(())
    }
}
