//! Tables in Parquet files.

use std::collections::HashMap;
use std::fs::{self, File};
use std::path::Path;
use std::sync::Arc;

use arrow_array::cast::AsArray as _;
use arrow_array::types::{Float64Type, UInt64Type};
use arrow_array::{Array, ArrayRef, Float64Array, RecordBatch, StringArray, UInt64Array};
use arrow_schema::{DataType, Field, Schema};
use parquet::arrow::ArrowWriter;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use parquet::basic::Compression;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use tempfile::NamedTempFile;

use crate::column::Column;
use crate::error::Error;
use crate::table::{ERROR, MEMBER, Table};

impl Table {
    /// Writes the table into a Parquet file, which pandas, polars and others read. A value that is missing is null. The
    /// metadata of the file contain those of the study and, as JSON under `units`, the units of the columns; the unit is
    /// in the metadata of each column, too.
    ///
    /// The file appears as a whole, when it is complete.
    ///
    /// # Errors
    ///
    /// [`Error::File`].
    pub fn write_parquet(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        let mut file = Writer::new(path.as_ref(), self.columns(), self.metadata())?;
        file.add(self)?;
        file.finish()
    }
}

/// Writes a Parquet file, which appears under its name when it is complete.
pub(crate) struct Writer<'a> {
    path: &'a Path,
    file: ArrowWriter<NamedTempFile>,
    schema: Arc<Schema>,
}

impl<'a> Writer<'a> {
    pub(crate) fn new(
        path: &'a Path,
        columns: &[Column],
        metadata: &[(String, String)],
    ) -> Result<Self, Error> {
        let with_units = columns.iter().filter(|column| !column.unit.is_empty());
        let units: serde_json::Map<_, _> = with_units
            .map(|column| (column.name.clone(), column.unit.clone().into()))
            .collect();
        let units = (
            "units".to_owned(),
            serde_json::Value::from(units).to_string(),
        );
        let metadata = metadata.iter().cloned().chain([units]);
        // Some readers look into the metadata of the file, others into those of Arrow's schema.
        let of_schema: HashMap<_, _> = metadata.clone().collect();
        let metadata = metadata
            .map(|(key, value)| KeyValue::new(key, value))
            .collect();
        let schema = Arc::new(schema(columns).with_metadata(of_schema));
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .set_created_by(format!(
                "lagrangian-ensembles {}",
                env!("CARGO_PKG_VERSION")
            ))
            .set_key_value_metadata(Some(metadata))
            .build();
        let file = temporary(path)?;
        let file = ArrowWriter::try_new(file, Arc::clone(&schema), Some(properties))
            .map_err(Error::file(path, "written"))?;
        Ok(Self { path, file, schema })
    }

    /// Adds the rows of a table.
    pub(crate) fn add(&mut self, table: &Table) -> Result<(), Error> {
        let written = batch(&self.schema, table).and_then(|batch| self.file.write(&batch));
        written.map_err(Error::file(self.path, "written"))
    }

    pub(crate) fn finish(self) -> Result<(), Error> {
        let file = self
            .file
            .into_inner()
            .map_err(Error::file(self.path, "written"))?;
        persist(file, self.path)
    }
}

/// Creates a file without a name yet, beside `path`.
pub(crate) fn temporary(path: &Path) -> Result<NamedTempFile, Error> {
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".unfinished-");
    // What others are allowed is what they are allowed for any file.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder
        .tempfile_in(folder)
        .map_err(Error::file(path, "written"))
}

/// Gives a file its name, in place of any other file of this name, when its content is stored.
pub(crate) fn persist(file: NamedTempFile, path: &Path) -> Result<(), Error> {
    file.as_file()
        .sync_all()
        .map_err(Error::file(path, "written"))?;
    match file.persist(path) {
        Ok(_) => Ok(()),
        Err(error) => Err(Error::file(path, "written")(error.error)),
    }
}

fn schema(columns: &[Column]) -> Schema {
    let numbers = columns.iter().map(|column| {
        let unit = (!column.unit.is_empty()).then(|| ("unit".to_owned(), column.unit.clone()));
        let unit: HashMap<_, _> = unit.into_iter().collect();
        Field::new(&column.name, DataType::Float64, true).with_metadata(unit)
    });
    let member = Field::new(MEMBER, DataType::UInt64, false);
    let error = Field::new(ERROR, DataType::Utf8, true);
    let fields: Vec<Field> = [member].into_iter().chain(numbers).chain([error]).collect();
    Schema::new(fields)
}

fn batch(schema: &Arc<Schema>, table: &Table) -> Result<RecordBatch, ParquetError> {
    let members = table.members().iter().map(|member| *member as u64);
    let members: ArrayRef = Arc::new(UInt64Array::from_iter_values(members));
    let numbers = table.values().iter().map(|values| {
        let values = values
            .iter()
            .map(|value| (!value.is_nan()).then_some(*value));
        Arc::new(values.collect::<Float64Array>()) as ArrayRef
    });
    let messages: ArrayRef = Arc::new(table.messages().collect::<StringArray>());
    let arrays = [members].into_iter().chain(numbers).chain([messages]);
    Ok(RecordBatch::try_new(Arc::clone(schema), arrays.collect())?)
}

/// Returns an error if a file is not a complete Parquet file.
pub(crate) fn check(path: &Path) -> Result<(), Error> {
    open(path).map(|_| ())
}

fn open(path: &Path) -> Result<ParquetRecordBatchReaderBuilder<File>, Error> {
    let file = File::open(path).map_err(Error::file(path, "read"))?;
    ParquetRecordBatchReaderBuilder::try_new(file).map_err(|error| {
        let length = fs::metadata(path).map_or(0, |metadata| metadata.len());
        let text = format!(
            "it is truncated or not a Parquet file ({length} bytes: {error}); remove it, and run the study again, which computes this chunk anew"
        );
        Error::file(path, "read")(text)
    })
}

/// Reads a table with these columns.
pub(crate) fn read(path: &Path, columns: &[Column]) -> Result<Table, Error> {
    let other_columns = || Error::file(path, "read")("it has other columns than the study");
    let batches = open(path)?.build().map_err(Error::file(path, "read"))?;
    let mut table = Table::new(columns.to_vec());
    for batch in batches {
        let batch = batch.map_err(Error::file(path, "read"))?;
        let array = |name: &str| batch.column_by_name(name).ok_or_else(other_columns);
        let members = array(MEMBER)?;
        let members = members
            .as_primitive_opt::<UInt64Type>()
            .ok_or_else(other_columns)?;
        let messages = array(ERROR)?
            .as_string_opt::<i32>()
            .ok_or_else(other_columns)?;
        let values = columns.iter().map(|column| {
            let values = array(&column.name)?.as_primitive_opt::<Float64Type>();
            values.ok_or_else(other_columns)
        });
        let values: Vec<_> = values.collect::<Result<_, _>>()?;
        for row in 0..batch.num_rows() {
            let value = |array: &&Float64Array| {
                if array.is_valid(row) {
                    array.value(row)
                } else {
                    f64::NAN
                }
            };
            let member = usize::try_from(members.value(row)).map_err(Error::file(path, "read"))?;
            table.add_row(member, values.iter().map(value));
            if messages.is_valid(row) {
                table.add_failure(member, messages.value(row).to_owned());
            }
        }
    }
    Ok(table)
}
