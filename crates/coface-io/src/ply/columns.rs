//! Properties that are kept as data.
//!
//! A property of a vertex, face or edge that is a number and has no meaning of its own is a column. Columns `name_0`, `name_1`, ..
//! that follow each other are the components of one array.

use super::header::{Element, Scalar};
use crate::numbers::Numbers;
use crate::{CellData, GroupKind, Model};
use coface_algebra::{Error, ErrorKind};

/// The columns of an element.
pub(super) struct Columns {
    /// For each property the number of its column.
    of_property: Vec<Option<usize>>,
    names: Vec<String>,
    numbers: Vec<Numbers>,
}

impl Columns {
    /// Columns for the properties that are numbers, but for those at these positions.
    pub(super) fn new(element: &Element, used: &[usize]) -> Self {
        let mut columns = Self { of_property: Vec::new(), names: Vec::new(), numbers: Vec::new() };
        for (i, property) in element.properties.iter().enumerate() {
            let is_column = property.count.is_none() && !used.contains(&i);
            columns.of_property.push(is_column.then_some(columns.names.len()));
            if is_column {
                columns.names.push(property.name.clone());
                columns.numbers.push(empty(property.value));
            }
        }
        columns
    }

    /// The numbers of the column that a property is.
    pub(super) fn of_property(&mut self, property: usize) -> Option<&mut Numbers> {
        self.of_property[property].map(|column| &mut self.numbers[column])
    }

    /// Drops rows behind so many.
    pub(super) fn truncate(&mut self, rows: usize) {
        self.numbers.iter_mut().for_each(|numbers| numbers.truncate(rows));
    }

    /// Zeros in front, for things of the same kind that came before.
    pub(super) fn prepend_zeros(&mut self, rows: usize) {
        self.numbers.iter_mut().for_each(|numbers| numbers.prepend_zeros(rows));
    }

    /// The arrays on things of this kind; those that came after the last row have zeros.
    pub(super) fn into_data(mut self, kind: GroupKind, count: usize) -> Vec<CellData> {
        for numbers in &mut self.numbers {
            numbers.extend_zeros(count.saturating_sub(numbers.len()));
        }
        let mut data = Vec::new();
        let mut at = 0;
        while at < self.names.len() {
            let (name, components) = self.array_at(at);
            let numbers = if components == 1 {
                std::mem::replace(&mut self.numbers[at], Numbers::UInt8(Vec::new()))
            } else {
                interleaved(&self.numbers[at..at + components], count)
            };
            data.push(CellData::of_file(name, kind, components, numbers));
            at += components;
        }
        data
    }

    /// The name of the array whose first column this is, and the number of its columns.
    fn array_at(&self, at: usize) -> (String, usize) {
        if let Some(name) = self.names[at].strip_suffix("_0").filter(|name| !name.is_empty()) {
            let follows =
                |i: &usize| self.names.get(at + i).is_some_and(|other| *other == component(name, *i));
            let components = 1 + (1..self.names.len()).take_while(follows).count();
            if components > 1 && self.names.iter().all(|other| other != name) {
                return (name.to_owned(), components);
            }
        }
        (self.names[at].clone(), 1)
    }
}

/// The name of one component of an array of several.
pub(super) fn component(name: &str, i: usize) -> String {
    format!("{name}_{i}")
}

fn empty(scalar: Scalar) -> Numbers {
    match scalar {
        Scalar::U8 => Numbers::UInt8(Vec::new()),
        Scalar::I8 | Scalar::I16 | Scalar::U16 | Scalar::I32 => Numbers::Int32(Vec::new()),
        Scalar::U32 => Numbers::Int64(Vec::new()),
        Scalar::F32 => Numbers::Float32(Vec::new()),
        Scalar::F64 => Numbers::Float64(Vec::new()),
    }
}

/// Columns as rows.
fn interleaved(columns: &[Numbers], rows: usize) -> Numbers {
    let mut numbers =
        columns.iter().fold(columns[0].of_same_type(), |common, column| common.common_type(column));
    for row in 0..rows {
        for column in columns {
            numbers.extend(column, row..row + 1);
        }
    }
    numbers
}

/// A column as it is written: a component of an array.
pub(super) struct WrittenColumn<'a> {
    /// The name, one word.
    pub(super) name: String,
    pub(super) type_name: &'static str,
    data: &'a CellData,
    component: usize,
}

impl WrittenColumn<'_> {
    /// Appends the number of one row as a word.
    pub(super) fn write_word(&self, row: usize, text: &mut Vec<u8>) {
        self.data.numbers().write_word(self.place(row), text);
    }

    /// Appends the number of one row as bytes.
    pub(super) fn write_bytes(&self, row: usize, big: bool, bytes: &mut Vec<u8>) {
        let (numbers, place) = (self.data.numbers(), self.place(row));
        match numbers {
            Numbers::Int64(values) => {
                // In four bytes, `int` and `uint` are alike.
                let value = values[place] as u32;
                bytes.extend_from_slice(&if big { value.to_be_bytes() } else { value.to_le_bytes() });
            }
            numbers => numbers.write_bytes(place, big, bytes),
        }
    }

    fn place(&self, row: usize) -> usize {
        row * self.data.components() + self.component
    }

    /// The number of bytes, all zero where there are no data.
    pub(super) fn size(&self) -> usize {
        match self.type_name {
            "uchar" => 1,
            "double" => 8,
            _ => 4,
        }
    }
}

/// The columns of the data on things of one kind, whose properties with a meaning have these names.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] for integers that 32 bits do not hold; [`ErrorKind::InvalidInput`] if two columns
/// would have one name.
pub(super) fn written_columns<'a>(
    model: &'a Model,
    kind: GroupKind,
    taken: &[&str],
) -> Result<Vec<WrittenColumn<'a>>, Error> {
    let mut columns: Vec<WrittenColumn<'_>> = Vec::new();
    for data in model.data().iter().filter(|data| data.kind() == kind) {
        let type_name = type_name(data)?;
        let name = one_word(data.name());
        for i in 0..data.components() {
            let mut name = if data.components() == 1 { name.clone() } else { component(&name, i) };
            if taken.contains(&name.as_str()) {
                name.push('_');
            }
            if columns.iter().any(|column| column.name == name) {
                let message = format!("two properties of {kind} would have the name \"{name}\" in PLY");
                return Err(Error::invalid(message).with_cure("rename the data"));
            }
            columns.push(WrittenColumn { name, type_name, data, component: i });
        }
    }
    Ok(columns)
}

fn type_name(data: &CellData) -> Result<&'static str, Error> {
    Ok(match data.numbers() {
        Numbers::UInt8(_) => "uchar",
        Numbers::Int32(_) => "int",
        Numbers::Int64(values) if values.iter().all(|&value| i32::try_from(value).is_ok()) => "int",
        Numbers::Int64(values) if values.iter().all(|&value| u32::try_from(value).is_ok()) => "uint",
        Numbers::Int64(_) => {
            let message = format!(
                "PLY holds integers of 32 bits, and the data \"{}\" on {} have larger ones",
                data.name(),
                data.kind()
            );
            return Err(Error::new(ErrorKind::UnsupportedFormat, message).with_cure("write VTK"));
        }
        Numbers::Float32(_) => "float",
        Numbers::Float64(_) => "double",
    })
}

/// The name with `_` for each blank or control character.
fn one_word(name: &str) -> String {
    name.chars().map(|c| if c.is_whitespace() || c.is_control() { '_' } else { c }).collect()
}
