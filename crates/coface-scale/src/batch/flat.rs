//! Rows as tables have them: one value a column.

use super::examination::Fault;
use crate::tables::Cell;
use coface_algebra::Error;
use coface_answers::answer::{GeometryAnswer, GeometryFaultAnswer, HomologyGroup, RowAnswer};
use serde::Deserialize;
use std::fmt::Display;

/// A row with its answer in its type.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct TableRow {
    head: Head,
    /// What is said about the file; nothing where there is an error instead.
    report: Option<RowAnswer>,
}

/// What every row has.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default)]
struct Head {
    path: Option<String>,
    bytes: Option<u64>,
    seconds: Option<f64>,
    error: Option<Fault>,
}

impl TableRow {
    /// The row in a line of JSON lines.
    ///
    /// # Errors
    /// A sentence that says why it is none: it is no object, or a key that rows have is missing or has another type.
    pub(crate) fn of_line(line: &str) -> Result<Self, String> {
        let head: Head = serde_json::from_str(line).map_err(|error| error.to_string())?;
        let report = match head.error {
            Some(_) => None,
            None => Some(serde_json::from_str(line).map_err(|error| error.to_string())?),
        };
        Ok(Self { head, report })
    }
}

/// A matrix whose entries may be beyond the range of floating point.
type Matrix = [[Option<f64>; 3]; 3];

/// How a row becomes the values of one or more columns.
#[derive(Clone, Copy)]
enum Form {
    /// One column, of every row.
    Head(fn(&Head) -> Cell),
    /// One column.
    Plain(fn(&RowAnswer) -> Cell),
    /// One column a degree of cells: how many there are.
    Cells(fn(&RowAnswer) -> &[usize]),
    /// One column a degree of homology.
    Degrees(fn(&HomologyGroup) -> Cell),
    /// One column an axis.
    Axes(fn(&RowAnswer) -> Option<[Option<f64>; 3]>),
    /// Six columns: the upper triangle of a symmetric matrix.
    Symmetric(fn(&RowAnswer) -> Option<Matrix>),
}

/// The columns: what they are called, and what of a row they hold.
const COLUMNS: [(&str, Form); 46] = [
    ("path", Form::Head(|head| head.path.as_deref().into())),
    ("bytes", Form::Head(|head| head.bytes.into())),
    (SECONDS, Form::Head(|head| head.seconds.into())),
    ("error_kind", Form::Head(|head| head.error.as_ref().map(|error| error.kind.as_str()).into())),
    ("error_message", Form::Head(|head| head.error.as_ref().map(|error| error.message.as_str()).into())),
    ("error_cure", Form::Head(|head| head.error.as_ref().and_then(|error| error.cure.as_deref()).into())),
    ("format", Form::Plain(|row| row.format.as_str().into())),
    ("kind", Form::Plain(|row| row.kind.as_str().into())),
    ("dimension", Form::Plain(|row| row.dimension.into())),
    ("f", Form::Cells(|row| &row.f_vector)),
    ("top_cells", Form::Plain(|row| counts(row.top_cells.iter().map(|cells| (&cells.shape, cells.count))))),
    ("pure", Form::Plain(|row| row.pure.into())),
    ("components", Form::Plain(|row| row.components.into())),
    ("euler_characteristic", Form::Plain(|row| row.euler_characteristic.into())),
    ("manifold", Form::Plain(|row| row.manifold.verdict.as_str().into())),
    ("closed", Form::Plain(|row| row.manifold.closed.into())),
    (
        "witness_kind",
        Form::Plain(|row| row.manifold.witness.as_ref().map(|witness| witness.kind.as_str()).into()),
    ),
    (
        "witness",
        Form::Plain(|row| row.manifold.witness.as_ref().map(|witness| witness.message.as_str()).into()),
    ),
    ("boundary_loops", Form::Plain(|row| row.boundary_loops.into())),
    ("boundary_faces", Form::Plain(|row| row.boundary_surface.as_ref().map(|surface| surface.faces).into())),
    (
        "boundary_components",
        Form::Plain(|row| row.boundary_surface.as_ref().map(|surface| surface.components).into()),
    ),
    (
        "boundary_euler_characteristic",
        Form::Plain(|row| row.boundary_surface.as_ref().map(|surface| surface.euler_characteristic).into()),
    ),
    (
        "boundary_manifold",
        Form::Plain(|row| row.boundary_surface.as_ref().map(|surface| surface.manifold).into()),
    ),
    (
        "boundary_name",
        Form::Plain(|row| row.boundary_surface.as_ref().and_then(|surface| surface.name.as_deref()).into()),
    ),
    ("orientable", Form::Plain(|row| row.orientable.into())),
    ("coherently_oriented", Form::Plain(|row| row.coherently_oriented.into())),
    ("genus", Form::Plain(|row| row.genus.into())),
    ("name", Form::Plain(|row| row.name.as_deref().into())),
    ("betti", Form::Degrees(|group| group.betti.into())),
    ("torsion", Form::Degrees(|group| listed(&group.torsion, " "))),
    ("area", Form::Plain(|row| row.area.into())),
    ("signed_volume", Form::Plain(|row| row.signed_volume.into())),
    ("surface_centroid", Form::Axes(|row| row.surface_centroid.map(|center| center.map(Some)))),
    ("volume", Form::Plain(|row| row.mass.as_ref().and_then(|mass| mass.volume).into())),
    ("centroid", Form::Axes(|row| row.mass.as_ref().map(|mass| mass.centroid))),
    ("inertia", Form::Symmetric(|row| row.mass.as_ref().map(|mass| mass.inertia))),
    ("sound_surface", Form::Plain(|row| row.geometry.as_ref().and_then(|own| own.sound_surface).into())),
    ("valid_solid", Form::Plain(|row| row.geometry.as_ref().and_then(|own| own.valid_solid).into())),
    (
        "geometry_faults",
        Form::Plain(|row| row.geometry.as_ref().filter(|own| own.checked).map(fault_codes).into()),
    ),
    ("polygon_count", Form::Plain(|row| row.polygons.as_ref().map(|own| own.count).into())),
    ("polygons_valid", Form::Plain(|row| row.polygons.as_ref().map(|own| own.valid).into())),
    (
        "polygon_faults",
        Form::Plain(|row| match &row.polygons {
            Some(own) => counts(own.faults.iter().map(|fault| (&fault.name, fault.count))),
            None => Cell::Nothing,
        }),
    ),
    ("reversed_rings", Form::Plain(|row| row.polygons.as_ref().map(|own| own.reversed_rings).into())),
    ("data", Form::Plain(|row| counts(row.data.iter().map(|data| (&data.name, data.components))))),
    (
        "problems",
        Form::Plain(|row| counts(row.problems.iter().map(|problem| (&problem.kind, problem.count)))),
    ),
    ("warnings", Form::Plain(|row| listed(&row.warnings, "; "))),
];

/// The one column that is there only with timings.
const SECONDS: &str = "seconds";

/// The entries of a symmetric matrix that columns hold.
const UPPER_TRIANGLE: [(&str, usize, usize); 6] =
    [("xx", 0, 0), ("yy", 1, 1), ("zz", 2, 2), ("xy", 0, 1), ("xz", 0, 2), ("yz", 1, 2)];

/// Items as one text. No items are an empty text, which is something else than nothing.
fn listed<T: Display>(items: &[T], separator: &str) -> Cell {
    items.iter().map(ToString::to_string).collect::<Vec<_>>().join(separator).into()
}

/// `name=count` with semicolons between them.
fn counts<'a>(items: impl Iterator<Item = (&'a String, usize)>) -> Cell {
    items.map(|(name, count)| format!("{name}={count}")).collect::<Vec<_>>().join("; ").into()
}

/// `code name=count` with semicolons between them.
fn fault_codes(geometry: &GeometryAnswer) -> String {
    let one = |fault: &GeometryFaultAnswer| format!("{} {}={}", fault.code, fault.name, fault.count);
    geometry.faults.iter().map(one).collect::<Vec<_>>().join("; ")
}

/// How many columns the numbered ones of a table have: as many as the rows that were seen need, and no fewer than those of an empty complex.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Columns {
    cells: usize,
    degrees: usize,
}

impl Columns {
    /// Makes room for a row.
    pub(crate) fn see(&mut self, row: &TableRow) {
        if let Some(report) = &row.report {
            self.cells = self.cells.max(report.f_vector.len());
            self.degrees = self.degrees.max(report.homology.len());
        }
    }

    /// The names of the columns, `seconds` only with timings.
    pub(crate) fn names(&self, timings: bool) -> Vec<String> {
        let mut names = Vec::new();
        for (name, form) in columns(timings) {
            let numbered = |count: usize| (0..count).map(|i| format!("{name}_{i}")).collect();
            names.extend(match form {
                Form::Head(_) | Form::Plain(_) => vec![name.to_owned()],
                Form::Cells(_) => numbered(self.cells),
                Form::Degrees(_) => numbered(self.degrees),
                Form::Axes(_) => ["x", "y", "z"].map(|axis| format!("{name}_{axis}")).to_vec(),
                Form::Symmetric(_) => UPPER_TRIANGLE.map(|(axes, ..)| format!("{name}_{axes}")).to_vec(),
            });
        }
        names
    }

    /// The values of a row, one a column.
    pub(crate) fn values(&self, row: &TableRow, timings: bool) -> Vec<Cell> {
        let mut values = Vec::new();
        let report = row.report.as_ref();
        for (_, form) in columns(timings) {
            match form {
                Form::Head(value) => values.push(value(&row.head)),
                Form::Plain(value) => values.push(report.map(value).into()),
                Form::Cells(counts) => {
                    let counts = report.map_or(&[][..], counts);
                    values.extend((0..self.cells).map(|degree| counts.get(degree).copied().into()));
                }
                Form::Degrees(value) => {
                    let groups = report.map_or(&[][..], |report| &report.homology);
                    values.extend((0..self.degrees).map(|degree| groups.get(degree).map(value).into()));
                }
                Form::Axes(point) => {
                    let point = report.and_then(point).unwrap_or_default();
                    values.extend(point.map(Cell::from));
                }
                Form::Symmetric(matrix) => {
                    let matrix = report.and_then(matrix).unwrap_or_default();
                    values.extend(UPPER_TRIANGLE.map(|(_, i, j)| Cell::from(matrix[i][j])));
                }
            }
        }
        values
    }
}

fn columns(timings: bool) -> impl Iterator<Item = (&'static str, Form)> {
    COLUMNS.into_iter().filter(move |(name, _)| timings || *name != SECONDS)
}

/// The table of one row: the line of a row in JSON lines as a line `[[name, value], ..]` with one value a column.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) if the line is no row: no object in JSON, or one without the keys of rows.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_scale::batch::{Examiner, ReportRequest, flat_line};
/// let request = ReportRequest::new("memory://segment.lines").to_line();
/// let row = Examiner::default().examine_with(&request, |_| Some(Ok(b"0,0,1,1".to_vec())));
/// let flat = flat_line(&row, false)?;
/// assert!(flat.starts_with(r#"[["path",null],["bytes",null],"#));
/// assert!(flat.contains(r#"["f_0",2],["f_1",1],["top_cells","edge=1"]"#), "{flat}");
/// assert!(flat_line("{}", false).is_err());
/// # Ok(()) }
/// ```
pub fn flat_line(row: &str, timings: bool) -> Result<String, Error> {
    let row = TableRow::of_line(row).map_err(|fault| Error::parse(format!("no row: {fault}")))?;
    let mut columns = Columns::default();
    columns.see(&row);
    let values: Vec<(String, Cell)> =
        columns.names(timings).into_iter().zip(columns.values(&row, timings)).collect();
    serde_json::to_string(&values).map_err(|error| Error::invalid(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    /// A row in which every key has a value.
    fn full() -> Value {
        let mut row = json!({
            "path": "a.off", "bytes": 7, "seconds": 0.5, "error": null, "file": "a.off", "format": "off",
            "kind": "surface", "dimension": 2, "f_vector": [4, 5, 2], "top_cells": [{"shape": "triangle", "count": 2}],
            "pure": true, "components": 1, "euler_characteristic": 1,
            "manifold": {"verdict": "no", "closed": false,
                         "witness": {"kind": "edge", "cells": [[0, 1]], "message": "one edge"}},
            "boundary_loops": 1,
            "boundary_surface": {"faces": 3, "components": 4, "euler_characteristic": 5, "manifold": true, "name": "x"},
            "orientable": true, "coherently_oriented": true, "genus": 3, "name": "disk",
            "surfaces": [], "homology": [{"degree": 0, "betti": 1, "torsion": [2, "99999999999999999999"]}],
            "area": 2.0, "signed_volume": -1.5, "surface_centroid": [0.25, 0.5, 1e-7],
            "mass": {"volume": 1.5, "centroid": [1.0, 2.0, 3.0],
                     "inertia": [[1.0, 4.0, 5.0], [4.0, 2.0, 6.0], [5.0, 6.0, null]]},
            "moments": [], "data": [{"name": "t", "on": "vertices", "components": 3, "type": "real", "range": null}],
            "groups": [],
            "problems": [{"kind": "loose_cell", "count": 9, "message": "m", "cells": [], "top_cells": []}],
            "warnings": ["one", "two"],
        });
        row["polygons"] = json!({
            "count": 2, "valid": false, "reason": "Self-intersection[1 1]", "reversed_rings": 1,
            "faults": [{"name": "ring_crosses_itself", "reason": "Self-intersection", "count": 3, "message": "m", "places": []}],
        });
        row["geometry"] = json!({
            "checked": true, "reason": null, "sound_surface": false, "valid_solid": false, "faces_left_out": 0,
            "shells_left_out": 0,
            "faults": [{"code": 306, "name": "faces_cross", "of": "surface", "count": 2, "complete": true,
                        "message": "m", "places": []}],
        });
        row
    }

    fn table(row: &Value) -> Vec<(String, String)> {
        let row = TableRow::of_line(&row.to_string()).unwrap();
        let mut columns = Columns::default();
        columns.see(&row);
        let names = columns.names(true).into_iter();
        let written = |cell: Cell| serde_json::to_string(&cell).unwrap();
        names.zip(columns.values(&row, true).into_iter().map(written)).collect()
    }

    #[test]
    fn each_value_is_in_its_column() {
        let expected = [
            ("path", "\"a.off\""),
            ("bytes", "7"),
            ("seconds", "0.5"),
            ("error_kind", "null"),
            ("error_message", "null"),
            ("error_cure", "null"),
            ("format", "\"off\""),
            ("kind", "\"surface\""),
            ("dimension", "2"),
            ("f_0", "4"),
            ("f_1", "5"),
            ("f_2", "2"),
            ("top_cells", "\"triangle=2\""),
            ("pure", "true"),
            ("components", "1"),
            ("euler_characteristic", "1"),
            ("manifold", "\"no\""),
            ("closed", "false"),
            ("witness_kind", "\"edge\""),
            ("witness", "\"one edge\""),
            ("boundary_loops", "1"),
            ("boundary_faces", "3"),
            ("boundary_components", "4"),
            ("boundary_euler_characteristic", "5"),
            ("boundary_manifold", "true"),
            ("boundary_name", "\"x\""),
            ("orientable", "true"),
            ("coherently_oriented", "true"),
            ("genus", "3"),
            ("name", "\"disk\""),
            ("betti_0", "1"),
            ("torsion_0", "\"2 99999999999999999999\""),
            ("area", "2.0"),
            ("signed_volume", "-1.5"),
            ("surface_centroid_x", "0.25"),
            ("surface_centroid_y", "0.5"),
            ("surface_centroid_z", "1e-7"),
            ("volume", "1.5"),
            ("centroid_x", "1.0"),
            ("centroid_y", "2.0"),
            ("centroid_z", "3.0"),
            ("inertia_xx", "1.0"),
            ("inertia_yy", "2.0"),
            ("inertia_zz", "null"),
            ("inertia_xy", "4.0"),
            ("inertia_xz", "5.0"),
            ("inertia_yz", "6.0"),
            ("sound_surface", "false"),
            ("valid_solid", "false"),
            ("geometry_faults", "\"306 faces_cross=2\""),
            ("polygon_count", "2"),
            ("polygons_valid", "false"),
            ("polygon_faults", "\"ring_crosses_itself=3\""),
            ("reversed_rings", "1"),
            ("data", "\"t=3\""),
            ("problems", "\"loose_cell=9\""),
            ("warnings", "\"one; two\""),
        ];
        let found = table(&full());
        let found: Vec<(&str, &str)> =
            found.iter().map(|(name, value)| (name.as_str(), value.as_str())).collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn errors_have_no_report_and_lists_may_be_empty() {
        let error =
            json!({"path": "a.off", "bytes": null, "error": {"kind": "io", "message": "gone", "cure": null}});
        let row = TableRow::of_line(&error.to_string()).unwrap();
        let columns = Columns { cells: 1, degrees: 1 };
        let values = columns.values(&row, true);
        assert_eq!(columns.names(true).len(), values.len());
        assert_eq!((&values[0], &values[3]), (&"a.off".into(), &"io".into()));
        assert!(values[5..].iter().all(|value| *value == Cell::Nothing));
        let mut row = full();
        (row["warnings"], row["f_vector"]) = (json!([]), json!([4]));
        let row = TableRow::of_line(&row.to_string()).unwrap();
        let columns = Columns { cells: 2, degrees: 2 };
        let values = columns.values(&row, true);
        assert_eq!(values.last(), Some(&"".into()));
        assert_eq!(values[9..11], [4_u64.into(), Cell::Nothing]);
    }

    #[test]
    fn rows_with_misspelled_keys_are_no_rows() {
        for key in ["f_vector", "top_cells", "manifold", "homology", "warnings"] {
            let mut row = full();
            row.as_object_mut().unwrap().remove(key);
            let fault = TableRow::of_line(&row.to_string()).unwrap_err();
            assert!(fault.contains(key), "{fault}");
        }
        assert!(TableRow::of_line("[]").is_err());
    }

    /// What can be changed in a value without changing its type, each change with the path to it.
    fn changes(value: &Value, path: &str) -> Vec<(String, Value)> {
        let other = match value {
            Value::Object(fields) => {
                let inside = |(key, field): (&String, &Value)| {
                    let changes = changes(field, &format!("{path}/{key}")).into_iter();
                    let key = key.clone();
                    changes.map(move |(path, changed)| {
                        let mut whole = value.clone();
                        whole[&key] = changed;
                        (path, whole)
                    })
                };
                return fields.iter().flat_map(inside).collect();
            }
            Value::Array(items) if items.is_empty() => return Vec::new(),
            Value::Array(items) if items.iter().all(Value::is_number) => {
                let scaled = |item: &Value| match item.as_u64() {
                    Some(count) => json!(count + 1),
                    None => json!(item.as_f64().unwrap() + 1.0),
                };
                items.iter().map(scaled).collect()
            }
            Value::Array(items) if items[0].is_array() => {
                Value::from(vec![json!([7.0, 8.0, 9.0]); items.len()])
            }
            Value::Array(_) => json!([]),
            Value::Null => return Vec::new(),
            Value::Bool(flag) => json!(!flag),
            Value::Number(number) if number.is_f64() => json!(number.as_f64().unwrap() + 1.0),
            Value::Number(number) => json!(number.as_i64().unwrap() + 1),
            Value::String(text) => json!(format!("{text}?")),
        };
        vec![(path.to_owned(), other)]
    }

    #[test]
    fn every_key_of_a_report_is_in_a_column_or_left_out_on_purpose() {
        // The name is the path; cells of witnesses, surfaces and groups may be many; moments are not asked for.
        // What was not looked at in geometry is in the report of a file alone.
        // The first fault of polygons is one of the list.
        let left_out = [
            "/file",
            "/manifold/witness/cells",
            "/geometry/faces_left_out",
            "/geometry/shells_left_out",
            "/polygons/reason",
        ];
        let unchanged = table(&full());
        let changes = changes(&full(), "");
        assert_eq!(changes.len(), 48);
        for (path, row) in changes {
            let row = match path.as_str() {
                "/manifold/witness/cells" => {
                    let mut row = row;
                    row["manifold"]["witness"]["cells"] = json!([[7, 8]]);
                    row
                }
                _ => row,
            };
            assert_eq!(table(&row) == unchanged, left_out.contains(&path.as_str()), "{path}");
        }
        let model = coface_io::read(&b"[[0,1,2]]"[..], coface_io::Format::Json).unwrap();
        let row = super::super::examination::report_on(model, "a.json", Default::default()).unwrap();
        for key in serde_json::to_value(&row).unwrap().as_object().unwrap().keys() {
            assert!(full().as_object().unwrap().contains_key(key), "{key}");
        }
    }
}
