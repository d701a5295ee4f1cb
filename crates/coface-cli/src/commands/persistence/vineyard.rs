//! `coface persistence --vineyard`: the points of a diagram while the function moves.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::{is_json, print_json, print_text, write_file, write_json};
use crate::progress::Progress;
use coface::algebra::escaped;
use coface::answers::answer::{VineAnswer, VineyardAnswer};
use coface::answers::text;
use coface::answers::write_vines;
use std::fmt::Write;
use std::path::Path;

/// How many vines of a degree the page for people lists.
const LISTED: usize = 8;

/// Whether vines can be written to a file of this name.
pub(super) fn check_name(path: &Path) -> Result<(), Failure> {
    if is_json(path) || is_csv(path) {
        return Ok(());
    }
    Err(Failure::new(format!("{}: vines are written as .json or .csv; name the file so", path.display())))
}

fn is_csv(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("csv"))
}

/// Writes and prints vines.
pub(super) fn give(common: &Common, answer: &VineyardAnswer, progress: Progress) -> Result<(), Failure> {
    progress.stage("writing");
    match common.output.as_deref() {
        Some(path) if is_csv(path) => {
            let mut bytes = Vec::new();
            write_vines(answer, &mut bytes)?;
            write_file(path, &bytes)?;
        }
        Some(path) => write_json(path, answer)?,
        None => {}
    }
    drop(progress);
    if common.json {
        return print_json(answer);
    }
    if common.output.is_some() {
        return Ok(());
    }
    print_text(&page(answer))
}

/// The vines for people: of each degree those that last longest.
fn page(answer: &VineyardAnswer) -> String {
    let mut page = format!("  vineyard of {} over Z/{}\n", escaped(&answer.file), answer.field);
    let names: Vec<_> = answer.functions.iter().map(|name| escaped(name)).collect();
    // Writing to a string does not fail.
    let _ = writeln!(page, "    functions: {}", names.join(", "));
    let top = answer.vines.iter().map(|vine| vine.degree + 1).max().unwrap_or(0);
    for degree in 0..top {
        let mut vines: Vec<&VineAnswer> = answer.vines.iter().filter(|vine| vine.degree == degree).collect();
        let _ = writeln!(page, "\n    degree {degree}: {}", text::count(vines.len(), "vine"));
        vines.sort_by(|a, b| persistence(b).total_cmp(&persistence(a)));
        for vine in vines.iter().take(LISTED) {
            let point = |&(parameter, birth, death): &(f64, f64, Option<f64>)| {
                let death = death.map_or("never".to_owned(), |death| death.to_string());
                format!("[{birth}, {death}) at {parameter}")
            };
            let ends = vine.points.first().zip(vine.points.last());
            let (first, last) = ends.map_or_else(Default::default, |(a, b)| (point(a), point(b)));
            let _ = writeln!(page, "      {first} to {last}, {}", text::count(vine.points.len(), "point"));
        }
        if let Some(more) = vines.len().checked_sub(LISTED).filter(|&more| more > 0) {
            let _ = writeln!(page, "      and {more} more; all with -o or --json");
        }
    }
    page
}

/// The longest life along a vine.
fn persistence(vine: &VineAnswer) -> f64 {
    let lives =
        vine.points.iter().map(|&(_, birth, death)| death.map_or(f64::INFINITY, |death| death - birth));
    lives.fold(0.0, f64::max)
}
