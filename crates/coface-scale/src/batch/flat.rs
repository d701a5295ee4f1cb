//! Rows as tables have them: one value a column.

use coface_algebra::Error;
use serde_json::Value;

/// How the value of a key becomes columns.
#[derive(Clone, Copy, PartialEq)]
enum Form {
    /// As it is.
    Plain,
    /// One column an item, the number behind the name.
    Numbered,
    /// One column an axis.
    Axes,
    /// Six columns: the upper triangle of a symmetric matrix.
    Inertia,
    /// Items with semicolons between them.
    Joined,
    /// `name=count` with semicolons between them, by these two keys of each item.
    Counts(&'static str, &'static str),
    /// Betti numbers or torsion orders, one column a degree.
    Degrees(&'static str),
}

/// The columns: name, where the value is in a row, and how it is written.
const COLUMNS: [(&str, &str, Form); 39] = [
    ("path", "/path", Form::Plain),
    ("bytes", "/bytes", Form::Plain),
    ("seconds", "/seconds", Form::Plain),
    ("error_kind", "/error/kind", Form::Plain),
    ("error_message", "/error/message", Form::Plain),
    ("error_cure", "/error/cure", Form::Plain),
    ("format", "/format", Form::Plain),
    ("kind", "/kind", Form::Plain),
    ("dimension", "/dimension", Form::Plain),
    ("f", "/f_vector", Form::Numbered),
    ("top_cells", "/top_cells", Form::Counts("shape", "count")),
    ("pure", "/pure", Form::Plain),
    ("components", "/components", Form::Plain),
    ("euler_characteristic", "/euler_characteristic", Form::Plain),
    ("manifold", "/manifold/verdict", Form::Plain),
    ("closed", "/manifold/closed", Form::Plain),
    ("witness_kind", "/manifold/witness/kind", Form::Plain),
    ("witness", "/manifold/witness/message", Form::Plain),
    ("boundary_loops", "/boundary_loops", Form::Plain),
    ("boundary_faces", "/boundary_surface/faces", Form::Plain),
    ("boundary_components", "/boundary_surface/components", Form::Plain),
    ("boundary_euler_characteristic", "/boundary_surface/euler_characteristic", Form::Plain),
    ("boundary_manifold", "/boundary_surface/manifold", Form::Plain),
    ("boundary_name", "/boundary_surface/name", Form::Plain),
    ("orientable", "/orientable", Form::Plain),
    ("coherently_oriented", "/coherently_oriented", Form::Plain),
    ("genus", "/genus", Form::Plain),
    ("name", "/name", Form::Plain),
    ("betti", "/homology", Form::Degrees("betti")),
    ("torsion", "/homology", Form::Degrees("torsion")),
    ("area", "/area", Form::Plain),
    ("signed_volume", "/signed_volume", Form::Plain),
    ("surface_centroid", "/surface_centroid", Form::Axes),
    ("volume", "/mass/volume", Form::Plain),
    ("centroid", "/mass/centroid", Form::Axes),
    ("inertia", "/mass/inertia", Form::Inertia),
    ("data", "/data", Form::Counts("name", "components")),
    ("problems", "/problems", Form::Counts("kind", "count")),
    ("warnings", "/warnings", Form::Joined),
];

/// How many columns the numbered ones of a table have: as many as the rows that were seen need, and no fewer than those of an empty complex.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Columns {
    cells: usize,
    degrees: usize,
}

impl Columns {
    /// Makes room for a row.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) if it is no object.
    pub(crate) fn see(&mut self, row: &Value) -> Result<(), Error> {
        if !row.is_object() {
            return Err(Error::parse("a row is no object"));
        }
        let length = |key: &str| row[key].as_array().map_or(0, Vec::len);
        self.cells = self.cells.max(length("f_vector"));
        self.degrees = self.degrees.max(length("homology"));
        Ok(())
    }

    /// The names of the columns, `seconds` only with timings.
    pub(crate) fn names(&self, timings: bool) -> Vec<String> {
        let mut names = Vec::new();
        for (name, _, form) in columns(timings) {
            let numbered = |count: usize| (0..count).map(|i| format!("{name}_{i}")).collect();
            names.extend(match form {
                Form::Plain | Form::Joined | Form::Counts(..) => vec![name.to_owned()],
                Form::Numbered => numbered(self.cells),
                Form::Degrees(_) => numbered(self.degrees),
                Form::Axes => ["x", "y", "z"].map(|axis| format!("{name}_{axis}")).to_vec(),
                Form::Inertia => INERTIA.map(|(axes, ..)| format!("{name}_{axes}")).to_vec(),
            });
        }
        names
    }

    /// The values of a row, one a column; null where there is none.
    pub(crate) fn values(&self, row: &Value, timings: bool) -> Vec<Value> {
        let mut values = Vec::new();
        for (_, pointer, form) in columns(timings) {
            let value = row.pointer(pointer).unwrap_or(&Value::Null);
            match form {
                Form::Plain => values.push(value.clone()),
                Form::Numbered => values.extend((0..self.cells).map(|i| value[i].clone())),
                Form::Axes => values.extend((0..3).map(|i| value[i].clone())),
                Form::Inertia => values.extend(INERTIA.map(|(_, i, j)| value[i][j].clone())),
                Form::Joined => values.push(joined(value, text)),
                Form::Counts(name, count) => {
                    values
                        .push(joined(value, |item| format!("{}={}", text(&item[name]), text(&item[count]))));
                }
                Form::Degrees(key) => {
                    values.extend((0..self.degrees).map(|degree| match &value[degree][key] {
                        Value::Array(orders) => {
                            Value::from(orders.iter().map(text).collect::<Vec<_>>().join(" "))
                        }
                        number => number.clone(),
                    }));
                }
            }
        }
        values
    }
}

/// The entries of a matrix of inertia.
const INERTIA: [(&str, usize, usize); 6] =
    [("xx", 0, 0), ("yy", 1, 1), ("zz", 2, 2), ("xy", 0, 1), ("xz", 0, 2), ("yz", 1, 2)];

fn columns(timings: bool) -> impl Iterator<Item = (&'static str, &'static str, Form)> {
    COLUMNS.into_iter().filter(move |(name, ..)| timings || *name != "seconds")
}

/// Items as text with semicolons between them; null where there is no list, since an empty list says something.
fn joined(value: &Value, item: impl Fn(&Value) -> String) -> Value {
    match value {
        Value::Array(items) => items.iter().map(item).collect::<Vec<_>>().join("; ").into(),
        _ => Value::Null,
    }
}

/// A value as text without quotes.
fn text(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

/// The table of one row: the line of a row in JSON lines as a line `[[name, value], ..]` with one value a column.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) if the line is no object in JSON.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let row = r#"{"path":"a.off","homology":[{"degree":0,"betti":1,"torsion":[2,4]}]}"#;
/// let flat = coface_scale::batch::flat_line(row, true)?;
/// assert!(flat.starts_with(r#"[["path","a.off"],"#));
/// assert!(flat.contains(r#"["betti_0",1],["torsion_0","2 4"]"#));
/// # Ok(()) }
/// ```
pub fn flat_line(row: &str, timings: bool) -> Result<String, Error> {
    let row: Value = serde_json::from_str(row).map_err(|error| Error::parse(format!("no row: {error}")))?;
    let mut columns = Columns::default();
    columns.see(&row)?;
    let values = columns.names(timings).into_iter().zip(columns.values(&row, timings));
    let list: Vec<Value> = values.map(|(name, value)| Value::from(vec![Value::from(name), value])).collect();
    Ok(Value::from(list).to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::batch::examination::{Reading, report_on};

    #[test]
    fn every_name_has_a_value() {
        let model = coface_io::read(&b"[[0,1,2],[1,2,3]]"[..], coface_io::Format::Json).unwrap();
        let row = report_on(model, "a.json", Reading::default()).unwrap();
        let mut columns = Columns::default();
        columns.see(&row).unwrap();
        columns.see(&serde_json::json!({"f_vector": [1, 2, 3, 4], "homology": [1, 2, 3, 4]})).unwrap();
        for timings in [false, true] {
            assert_eq!(columns.names(timings).len(), columns.values(&row, timings).len());
        }
        let value = |name: &str| {
            let place = columns.names(true).iter().position(|other| other == name).unwrap();
            columns.values(&row, true)[place].to_string()
        };
        let expected = [
            ("f_1", "5"),
            ("f_3", "null"),
            ("betti_1", "0"),
            ("manifold", "\"yes\""),
            ("top_cells", "\"triangle=2\""),
        ];
        for (name, expected) in expected {
            assert_eq!(value(name), expected, "{name}");
        }
    }

    #[test]
    fn every_key_of_a_report_is_in_a_column_or_left_out_on_purpose() {
        let model = coface_io::read(&b"[[0,1,2]]"[..], coface_io::Format::Json).unwrap();
        let row = report_on(model, "a.json", Reading::default()).unwrap();
        // The name is the path; moments are not asked for; surfaces are one a component; groups may be thousands.
        let left_out = ["file", "groups", "moments", "surfaces"];
        for key in row.as_object().unwrap().keys() {
            let is_column = COLUMNS.iter().any(|(_, pointer, _)| pointer.split('/').nth(1) == Some(key));
            assert!(is_column != left_out.contains(&key.as_str()), "{key}");
        }
    }
}
