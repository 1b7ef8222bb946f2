//! The two files that are written.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::record::Record;
use crate::table;

/// The files, created before the integration: that it cannot be kept is better known before it is run.
#[derive(Debug)]
pub(crate) struct Files {
    table: (PathBuf, File),
    figure: (PathBuf, File),
}

impl Files {
    /// Creates both files, empty, and the folder if there is none.
    pub(crate) fn create(folder: &Path) -> Result<Self, String> {
        fs::create_dir_all(folder).map_err(|error| {
            format!(
                "the output folder {} cannot be created: {error}",
                folder.display()
            )
        })?;
        let create = |name: &str| {
            let path = folder.join(name);
            match File::create(&path) {
                Ok(file) => Ok((path, file)),
                Err(error) => Err(refused(&path, &error)),
            }
        };
        Ok(Self {
            table: create("heavy_top.csv")?,
            figure: create("heavy_top.svg")?,
        })
    }

    /// Writes both files, and says so in a sentence.
    pub(crate) fn write(self, records: &[Record], figure: &str) -> Result<String, String> {
        let (table_path, file) = self.table;
        table::write(BufWriter::new(file), records)
            .map_err(|error| refused(&table_path, &error))?;
        let (figure_path, mut file) = self.figure;
        file.write_all(figure.as_bytes())
            .map_err(|error| refused(&figure_path, &error))?;
        Ok(format!(
            "Wrote {} ({} samples) and {}.\n",
            table_path.display(),
            records.len(),
            figure_path.display()
        ))
    }
}

/// Why there is no file.
fn refused(path: &Path, error: &io::Error) -> String {
    format!("{} cannot be written: {error}", path.display())
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::Files;

    #[test]
    fn a_folder_that_cannot_be_is_refused() {
        // The source file of this test is no folder.
        let folder = Path::new(file!());
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("heavy_top")
            .join(folder.file_name().expect("a name"))
            .join("results");
        let sentence = Files::create(&folder).expect_err("no folder within a file");
        assert!(sentence.starts_with("the output folder "), "{sentence}");
    }
}
