//! The two files that are written: the table of samples, as comma-separated values, and the figure.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::motion::Sample;

/// The names and units of the columns of the table.
const HEADER: &str = "t [s],phi [rad],theta [rad],psi [rad],\
    phi_dot [rad/s],theta_dot [rad/s],psi_dot [rad/s],\
    energy [J],C_phi [kg m2/s],C_psi [kg m2/s],relative energy error";

/// The files, created before the integration: that it cannot be kept is better known before it is run.
#[derive(Debug)]
pub(crate) struct Files {
    table: (PathBuf, File),
    figure: (PathBuf, File),
}

impl Files {
    /// Creates both files, empty, and the folder if there is none.
    pub(crate) fn create(folder: &Path) -> Result<Self, String> {
        let name = folder.display();
        fs::create_dir_all(folder)
            .map_err(|error| format!("the output folder {name} cannot be created: {error}"))?;
        let create = |name: &str| {
            let path = folder.join(name);
            let file = written(&path, File::create(&path))?;
            Ok::<_, String>((path, file))
        };
        Ok(Self {
            table: create("heavy_top.csv")?,
            figure: create("heavy_top.svg")?,
        })
    }

    /// Writes both files, and says so in a sentence.
    pub(crate) fn write(self, samples: &[Sample], figure: &str) -> Result<String, String> {
        let (path, file) = &self.table;
        written(path, write_table(BufWriter::new(file), samples))?;
        let (path, mut file) = self.figure;
        written(&path, file.write_all(figure.as_bytes()))?;
        let (table, figure) = (self.table.0.display(), path.display());
        let count = samples.len();
        Ok(format!("Wrote {table} ({count} samples) and {figure}.\n"))
    }
}

/// Writes the table. Numbers are written with as many digits as give the same number when read.
fn write_table(mut file: impl Write, samples: &[Sample]) -> io::Result<()> {
    writeln!(file, "{HEADER}")?;
    for sample in samples {
        let state = &sample.state;
        write!(file, "{}", state.t)?;
        let values = state.q.iter().chain(&state.v).chain(&sample.constants);
        for value in values.chain(&sample.errors[..1]) {
            // Scientific notation where it is the shorter one.
            write!(file, ",{value:?}")?;
        }
        writeln!(file)?;
    }
    file.flush()
}

/// What came of writing a file, or why there is none.
fn written<T>(path: &Path, result: io::Result<T>) -> Result<T, String> {
    result.map_err(|error| format!("{} cannot be written: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use lagrangian::State;

    use super::{Files, HEADER, write_table};
    use crate::motion::Sample;

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

    #[test]
    fn every_column_reads_back() {
        let sample = Sample {
            state: State::new(0.1 + 0.2, [1.0, -2.5, 1e-300], [3.0, 4.0, 5.0]),
            constants: [6.0, 7.0, 8.0],
            errors: [-1e-16, 0.0, 0.0],
        };
        let mut file = Vec::new();
        write_table(&mut file, &[sample]).expect("a vector takes all");
        let text = String::from_utf8(file).expect("text");
        let (header, row) = text.trim_end().split_once('\n').expect("two lines");
        assert_eq!(header, HEADER);
        let values: Vec<f64> = row
            .split(',')
            .map(|value| value.parse().expect("a number"))
            .collect();
        assert_eq!(
            values,
            [
                0.1 + 0.2,
                1.0,
                -2.5,
                1e-300,
                3.0,
                4.0,
                5.0,
                6.0,
                7.0,
                8.0,
                -1e-16
            ]
        );
        assert_eq!(values.len(), HEADER.split(',').count());
    }
}
