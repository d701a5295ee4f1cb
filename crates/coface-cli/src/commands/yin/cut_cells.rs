//! `coface yin cut-cells`: a set on a Cartesian grid.

use super::{SetOptions, Shown, pair};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{is_json, print_json, print_text, write_file, write_json};
use crate::progress::Progress;
use clap::Args;
use coface::answers::PlanarSet;
use coface::answers::text;
use coface::yin::{CartesianGrid, Coverage, CutCells};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Cut a set at the lines of a Cartesian grid: which cells are full, empty or cut, and area and boundary in each.
///
/// The areas of all cells add up to the area of the set in the grid. With -o the cells that have some of the set or of its boundary are
/// written, to .csv (column, row, coverage, area, length) or .json.
///
/// With --json: "grid" ("origin", "spacing", "counts"), "full", "cut" and "empty" (numbers of cells), "area" and "length" (of the set and
/// its boundary in the grid), "area_of_set" (null if unbounded), "perimeter_of_set".
#[derive(Args)]
pub(super) struct Cells {
    /// The set; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    #[command(flatten)]
    options: SetOptions,
    /// The number of columns and rows: N or NxM
    #[arg(long, value_name = "COUNTS", default_value = "64", value_parser = counts)]
    grid: [usize; 2],
    /// The lower left corner of the grid: X,Y [default: that of the box around the set]
    #[arg(long, value_name = "POINT", value_parser = pair, allow_hyphen_values = true)]
    origin: Option<[f64; 2]>,
    /// The size of the cells: H, or X,Y [default: so that the grid covers the box around the set]
    #[arg(long, value_name = "SIZE", value_parser = size, allow_hyphen_values = true)]
    spacing: Option<[f64; 2]>,
}

fn counts(text: &str) -> Result<[usize; 2], String> {
    let (columns, rows) = text.split_once('x').unwrap_or((text, text));
    match (columns.trim().parse(), rows.trim().parse()) {
        (Ok(columns), Ok(rows)) if columns > 0 && rows > 0 => Ok([columns, rows]),
        _ => Err(format!("\"{text}\" are no counts: write N, or COLUMNSxROWS")),
    }
}

fn size(text: &str) -> Result<[f64; 2], String> {
    match text.contains(',') {
        true => pair(text),
        false => pair(&format!("{text},{text}")),
    }
}

impl Cells {
    pub(super) fn run(&self, common: &Common) -> Result<(), Failure> {
        if self.options.picture != Shown::Set {
            return Err(Failure::new(
                "--picture draws a set, not its cells: ask for it with `coface yin info`",
            ));
        }
        let is_table =
            |path: &Path| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("csv"));
        if let Some(path) = common.output.as_deref().filter(|path| !is_table(path) && !is_json(path)) {
            return Err(Failure::new(format!(
                "{}: cells are written as .csv or .json; name the file so",
                path.display()
            )));
        }
        let progress = Progress::start(common.quiet);
        let planar = self.options.read(&self.input, common, false, &progress)?;
        progress.stage("cutting");
        let name = input::name(&self.input);
        let (origin, spacing) = self.place(&planar);
        let set = planar.set();
        let grid = CartesianGrid::new(origin, spacing, self.grid)?;
        let cells = CutCells::new(set, grid).map_err(|error| error.in_file(name.clone()))?;
        progress.stage("measuring");
        let report = planar.to_json()?;
        let object = json!({
            "file": name,
            "grid": {"origin": origin, "spacing": spacing, "counts": self.grid},
            "full": cells.count(Coverage::Full),
            "cut": cells.count(Coverage::Cut),
            "empty": cells.count(Coverage::Empty),
            "area": cells.total_area(),
            "length": cells.total_length(),
            "area_of_set": report["area"],
            "perimeter_of_set": report["perimeter"],
        });
        if let Some(path) = &common.output {
            progress.stage("writing");
            match is_json(path) {
                true => {
                    let mut whole = object.clone();
                    whole["cells"] = rows(&cells, self.grid)
                        .map(|(column, row, coverage, area, length)| {
                            json!({"column": column, "row": row, "coverage": coverage, "area": area, "length": length})
                        })
                        .collect();
                    write_json(path, &whole)?;
                }
                false => {
                    let mut table = "column,row,coverage,area,length\n".to_owned();
                    for (column, row, coverage, area, length) in rows(&cells, self.grid) {
                        let _ = writeln!(table, "{column},{row},{coverage},{area:?},{length:?}");
                    }
                    write_file(path, table.as_bytes())?;
                }
            }
        }
        drop(progress);
        match (common.json, &common.output) {
            (true, _) => print_json(&object),
            (false, Some(_)) => Ok(()),
            (false, None) => print_text(&page(&object)),
        }
    }

    /// The corner of the grid and the size of its cells.
    fn place(&self, planar: &PlanarSet) -> ([f64; 2], [f64; 2]) {
        let [low, high] = planar.bounding_box().unwrap_or([[0.0; 2], [1.0; 2]]);
        let origin = self.origin.unwrap_or(low);
        let spacing = self.spacing.unwrap_or_else(|| {
            [0, 1].map(|axis| {
                let extent = high[axis] - origin[axis];
                if extent > 0.0 { extent / self.grid[axis] as f64 } else { 1.0 }
            })
        });
        (origin, spacing)
    }
}

/// Column, row, coverage, area and length of all cells that have something.
fn rows<'a>(
    cells: &'a CutCells<'_>,
    [columns, row_count]: [usize; 2],
) -> impl Iterator<Item = (usize, usize, &'static str, f64, f64)> + 'a {
    (0..row_count).flat_map(move |row| (0..columns).map(move |column| (column, row))).filter_map(
        |(column, row)| {
            let cell = cells.cell(column, row);
            let length = cell.map_or(0.0, |cell| cell.length());
            let coverage = match cells.coverage(column, row) {
                Coverage::Full => "full",
                Coverage::Cut => "cut",
                Coverage::Empty if cell.is_none() => return None,
                Coverage::Empty => "empty",
            };
            Some((column, row, coverage, cells.area(column, row), length))
        },
    )
}

fn page(object: &Value) -> String {
    let whole = |key: &str| text::grouped(object[key].as_u64().unwrap_or(0) as usize);
    let real = |value: &Value| value.as_f64().map_or("infinite".to_owned(), text::number);
    let facts = [
        ("full cells", whole("full"), String::new()),
        ("cut cells", whole("cut"), String::new()),
        ("empty cells", whole("empty"), String::new()),
        (
            "area",
            real(&object["area"]),
            format!("of the set in the grid; of all {}", real(&object["area_of_set"])),
        ),
        (
            "length",
            real(&object["length"]),
            format!("of the boundary; of all {}", real(&object["perimeter_of_set"])),
        ),
    ];
    let facts: Vec<(String, String, String)> =
        facts.into_iter().map(|(label, value, gloss)| (label.to_owned(), value, gloss)).collect();
    text::facts("Cut cells", &facts)
}
