//! `coface yin cut-cells`: a set on a Cartesian grid.

use super::{SetOptions, Shown, pair};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{is_json, print_json, print_text, write_file, write_json};
use crate::progress::Progress;
use clap::Args;
use coface::answers::answer::{CutCellAnswer, YinCutCellsAnswer, YinInterfaceCutCellsAnswer};
use coface::answers::text;
use coface::answers::{CutCellsRequest, PlanarInterface};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Cut a set at the lines of a Cartesian grid: which cells are full, empty or cut, and area and boundary in each.
///
/// The areas of all cells add up to the area of the set in the grid. With -o the cells that have some of the set or of its boundary are
/// written, to .csv (column, row, coverage, area, length) or .json.
///
/// Phases of an interface are cut at one grid: .csv files have a line for what a phase has of a cell (column, row, the number of the phase from 0 and its name, coverage, area, length), and the
/// areas of all phases in a cell add up.
///
/// With --json: "grid" ("origin", "spacing", "counts"), "full", "cut" and "empty" (numbers of cells), "area" and "length" (of the set and
/// its boundary in the grid), "area_of_set" (null if unbounded), "perimeter_of_set"; of an interface "grid", "area", "length" (of all edges in the grid, each
/// once) and "phases", each with "name", "full", "cut", "empty", "area", "length" and "area_of_phase".
#[derive(Args)]
pub(super) struct Cells {
    /// The set, or an interface; - is standard input
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
        if let Some(found) = self.options.given_interface(&self.input, &[], common, &progress)? {
            return self.run_interface(&found, common, progress);
        }
        let planar = self.options.read(&self.input, common, false, &progress)?;
        progress.stage("cutting");
        let name = input::name(&self.input);
        let request = CutCellsRequest::new(self.grid).origin(self.origin).spacing(self.spacing);
        let mut answer = planar.cut_cells(&name, &request)?;
        if let Some(path) = &common.output {
            progress.stage("writing");
            match is_json(path) {
                true => write_json(path, &answer)?,
                false => write_file(path, table(answer.cells.as_deref().unwrap_or_default()).as_bytes())?,
            }
        }
        drop(progress);
        // Cells are listed in files only.
        answer.cells = None;
        match (common.json, &common.output) {
            (true, _) => print_json(&answer),
            (false, Some(_)) => Ok(()),
            (false, None) => print_text(&page(&answer)),
        }
    }
}

impl Cells {
    /// The phases of an interface on one grid.
    fn run_interface(
        &self,
        found: &PlanarInterface,
        common: &Common,
        progress: Progress,
    ) -> Result<(), Failure> {
        progress.stage("cutting");
        let name = input::name(&self.input);
        let request = CutCellsRequest::new(self.grid).origin(self.origin).spacing(self.spacing);
        let mut answer = found.cut_cells(&name, &request)?;
        if let Some(path) = &common.output {
            progress.stage("writing");
            match is_json(path) {
                true => write_json(path, &answer)?,
                false => {
                    write_file(path, phase_table(&answer).as_bytes())?;
                }
            }
        }
        drop(progress);
        answer.cells = None;
        match (common.json, &common.output) {
            (true, _) => print_json(&answer),
            (false, Some(_)) => Ok(()),
            (false, None) => print_text(&phase_page(&answer)),
        }
    }
}

/// What phases have of cells as lines of comma-separated values.
fn phase_table(answer: &YinInterfaceCutCellsAnswer) -> String {
    let mut table = "column,row,phase,name,coverage,area,length\n".to_owned();
    let name_of = |phase: u32| {
        let name = answer.phases.get(phase as usize).map_or("", |phase| phase.name.as_str());
        coface::scale::csv_field(name)
    };
    for cell in answer.cells.iter().flatten() {
        // Writing to a string does not fail.
        let _ = writeln!(
            table,
            "{},{},{},{},{},{:?},{:?}",
            cell.column,
            cell.row,
            cell.phase,
            name_of(cell.phase),
            cell.coverage.word(),
            cell.area,
            cell.length
        );
    }
    table
}

fn phase_page(answer: &YinInterfaceCutCellsAnswer) -> String {
    /// So many phases are shown.
    const LISTED: usize = 20;
    let mut facts = vec![
        ("area".to_owned(), text::number(answer.area), "of all phases in the grid".to_owned()),
        ("length".to_owned(), text::number(answer.length), "of the edges in the grid, each once".to_owned()),
    ];
    for phase in answer.phases.iter().take(LISTED) {
        let counts = format!(
            "{} full, {} cut, {} empty cells",
            text::grouped(phase.full),
            text::grouped(phase.cut),
            text::grouped(phase.empty)
        );
        facts.push((phase.name.clone(), format!("area {}", text::number(phase.area)), counts));
    }
    if answer.phases.len() > LISTED {
        facts.push((
            "..".to_owned(),
            String::new(),
            format!("{} in all", text::count(answer.phases.len(), "phase")),
        ));
    }
    text::facts("Cut cells", &facts)
}

/// Cells as lines of comma-separated values.
fn table(cells: &[CutCellAnswer]) -> String {
    let mut table = "column,row,coverage,area,length\n".to_owned();
    for cell in cells {
        // Writing to a string does not fail.
        let _ = writeln!(
            table,
            "{},{},{},{:?},{:?}",
            cell.column,
            cell.row,
            cell.coverage.word(),
            cell.area,
            cell.length
        );
    }
    table
}

fn page(answer: &YinCutCellsAnswer) -> String {
    let real = |number: Option<f64>| number.map_or("infinite".to_owned(), text::number);
    let facts = [
        ("full cells", text::grouped(answer.full), String::new()),
        ("cut cells", text::grouped(answer.cut), String::new()),
        ("empty cells", text::grouped(answer.empty), String::new()),
        (
            "area",
            text::number(answer.area),
            format!("of the set in the grid; of all {}", real(answer.area_of_set)),
        ),
        (
            "length",
            text::number(answer.length),
            format!("of the boundary; of all {}", real(answer.perimeter_of_set)),
        ),
    ];
    let facts: Vec<(String, String, String)> =
        facts.into_iter().map(|(label, value, gloss)| (label.to_owned(), value, gloss)).collect();
    text::facts("Cut cells", &facts)
}
