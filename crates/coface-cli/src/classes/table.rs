//! Classes as a table of Arrow.

use arrow_array::{ArrayRef, Int8Array, RecordBatch, UInt8Array, UInt32Array};
use arrow_ipc::writer::FileWriter;
use arrow_schema::{ArrowError, DataType, Field, Schema};
use coface::arrange::congruence::CellClasses;
use coface::{CellId, Error, ErrorKind};
use std::io::Write;
use std::sync::Arc;

/// How many cells are put into one batch at least: what is in memory at once.
const BATCH: usize = 1 << 18;

/// Writes the table as a file of Arrow's IPC format.
pub(super) fn write(classes: &[CellClasses], out: &mut dyn Write) -> Result<(), Error> {
    write_table(classes, out).map_err(|error| {
        Error::new(ErrorKind::Io, format!("the table of classes cannot be written: {error}"))
    })
}

/// Writes a table with a row for each cell and class of it; a cell without class has one row with nulls.
fn write_table(classes: &[CellClasses], out: &mut dyn Write) -> Result<(), ArrowError> {
    let schema = Arc::new(Schema::new(vec![
        Field::new("degree", DataType::UInt8, false),
        Field::new("cell", DataType::UInt32, false),
        Field::new("class", DataType::UInt32, true),
        Field::new("sign", DataType::Int8, true),
    ]));
    let mut writer = FileWriter::try_new(out, &schema)?;
    for (degree, classes) in classes.iter().enumerate() {
        let degree = u8::try_from(degree)
            .map_err(|_| ArrowError::InvalidArgumentError("degrees go up to 255".to_owned()))?;
        let count = classes.cell_count();
        for start in (0..count).step_by(BATCH) {
            let (mut cells, mut own, mut signs) = (Vec::new(), Vec::new(), Vec::new());
            for cell in start..(start + BATCH).min(count) {
                let id = CellId::new(cell);
                let mut image = classes.image(id).map(Some).peekable();
                let none = image.peek().is_none().then_some(None);
                for class in image.chain(none) {
                    cells.push(id.to_u32());
                    own.push(class.map(|(class, _)| class as u32));
                    signs.push(class.map(|(_, sign)| sign.to_i32() as i8));
                }
            }
            let columns: Vec<ArrayRef> = vec![
                Arc::new(UInt8Array::from_value(degree, cells.len())),
                Arc::new(UInt32Array::from(cells)),
                Arc::new(UInt32Array::from(own)),
                Arc::new(Int8Array::from(signs)),
            ];
            writer.write(&RecordBatch::try_new(Arc::clone(&schema), columns)?)?;
        }
    }
    writer.finish()
}
