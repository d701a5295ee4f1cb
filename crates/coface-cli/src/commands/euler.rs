//! `coface euler`: Euler characteristics of what has entered, and along directions.

use super::diagram::{LISTED, Values, give_table, table_output};
use super::persistence::image::{ImageArguments, refuse_upper_star, stream};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::filtration::{read_function, read_values};
use crate::input::{self, Source};
use crate::output::is_json;
use crate::progress::Progress;
use crate::remarks;
use clap::Args;
use coface::algebra::escaped;
use coface::answers::answer::{EulerAnswer, Remark, RemarkCode};
use coface::answers::{Directions, EulerRequest, Growth, text};
use coface::io::NumberTable;
use coface::topology::Coefficients;
use serde::Deserialize;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// The Euler characteristic of what has entered as a model grows, counted without homology; along directions, the Euler characteristic transform.
///
/// A model grows by sublevel sets of a function on vertices (the height by default), or by values given for cells; a volume by its grey values, unless its
/// voxels are chosen (--threshold, --below, --between, --value) or there are directions: then it is the model of its set voxels. Along a direction each cell
/// enters with its highest vertex. The characteristic is the alternating sum of the numbers of cells, vertices first, and of the Betti numbers.
///
/// With -o numbers are written as .csv, .npy or .json. Of one function .csv has a line for each value, and .npy a row of values and one of numbers; of
/// directions both have a row for each, in .csv behind the direction itself.
#[derive(Args)]
pub(crate) struct Euler {
    /// The model or volume; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// The function on vertices: a coordinate, or a file with one number a line, or an array of NumPy (.npy), for each vertex
    #[arg(long, value_name = "x|y|z|FILE", conflicts_with_all = ["values_of_cells", "directions"])]
    function: Option<String>,
    /// Values of cells as JSON, as for coface persistence
    #[arg(long = "values", id = "values_of_cells", value_name = "FILE", conflicts_with_all = ["upper_star", "directions"])]
    values_of_cells: Option<PathBuf>,
    /// Grow by superlevel sets, from high values to low ones: each cell enters with its lowest vertex
    #[arg(long, conflicts_with = "directions")]
    upper_star: bool,
    /// A curve for each of N directions, spread evenly on the circle or the sphere, or of the directions in a file: a table with a row for each, or JSON, such as what this verb writes
    #[arg(long, value_name = "N|FILE", value_parser = directions)]
    directions: Option<DirectionsGiven>,
    /// Along directions, measure heights from the middle of the box of the vertices, in units of the greatest distance from there, so that all lie from -1 to 1
    #[arg(long, requires = "directions")]
    normalize: bool,
    /// Give smooth curves: the integral of what the characteristic is above its mean over the range of the values
    #[arg(long)]
    smooth: bool,
    #[command(flatten)]
    values: Values,
    #[command(flatten)]
    image: ImageArguments,
}

/// Directions as the command line has them.
#[derive(Clone, Debug)]
enum DirectionsGiven {
    Even(usize),
    File(PathBuf),
}

fn directions(text: &str) -> Result<DirectionsGiven, String> {
    if text.is_empty() || !text.bytes().all(|byte| byte.is_ascii_digit()) {
        return Ok(DirectionsGiven::File(text.into()));
    }
    match text.parse() {
        Ok(count) if count > 0 => Ok(DirectionsGiven::Even(count)),
        _ => Err("give a number of directions from 1 on, or a file with a row for each".to_owned()),
    }
}

/// What a JSON file of directions has: the answer of this verb, or a bare list.
#[derive(Deserialize)]
#[serde(untagged)]
enum Rows {
    Answer { directions: Vec<Vec<f64>> },
    Bare(Vec<Vec<f64>>),
}

/// The directions in a table of numbers, or in JSON.
fn read_directions(path: &Path) -> Result<Directions, Failure> {
    let place = input::name(path);
    let bytes = std::fs::read(path).map_err(|error| coface::Error::from(error).in_file(place.clone()))?;
    if is_json(path) {
        let rows = serde_json::from_slice(&bytes).map_err(|_| {
            let fault = coface::Error::invalid("there are no directions here");
            fault.with_cure("write [[x,y,z],..], a list of numbers for each direction").in_file(place.clone())
        })?;
        let (Rows::Answer { directions: rows } | Rows::Bare(rows)) = rows;
        return Ok(Directions::Given { place, rows });
    }
    let table = NumberTable::read(&bytes[..]).map_err(|error| error.in_file(place.clone()))?;
    let rows = (0..table.row_count()).map(|row| table.row(row).to_vec()).collect();
    Ok(Directions::Given { place, rows })
}

impl Euler {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        common.points.refuse("euler")?;
        let output = table_output(common)?;
        let mut request = EulerRequest::new().smooth(self.smooth).normalized(self.normalize);
        if let Some(values) = self.values.asked() {
            request = request.values(values);
        }
        let directions = match &self.directions {
            Some(DirectionsGiven::Even(count)) => Some(Directions::Even(*count)),
            Some(DirectionsGiven::File(path)) => Some(read_directions(path)?),
            None => None,
        };
        let progress = Progress::start(common.quiet);
        let source = Source::of(&self.input)?;
        let has_function = self.function.is_some() || self.values_of_cells.is_some();
        let is_of_values = !has_function && common.voxels.rule_given().is_none();
        let is_of_model = directions.is_some() || !is_of_values;
        if self.upper_star && is_of_values {
            refuse_upper_star(&source, common)?;
        }
        if directions.is_some() && is_of_values {
            say_what_is_set(&source, common)?;
        }
        request = request.directions(directions);
        let field = Coefficients::Modulo(2);
        let image = match is_of_model {
            true => None,
            false => self.image.question(&source, common, field, 0.0, &progress)?,
        };
        let answer = match image {
            Some((name, image, of_image)) => request.answer_of_image(&name, &of_image, image)?,
            None => {
                self.image.refuse(&self.input)?;
                let (name, producer) =
                    input::identify(source.model(common.reading(), &progress)?, &progress)?;
                request.growth(self.growth()?).answer(&name, &producer)?
            }
        };
        drop(progress);
        give_table(common, output, &answer, || answer.csv(), || answer.table(), || page(&answer))
    }

    fn growth(&self) -> Result<Growth, Failure> {
        if let Some(path) = &self.values_of_cells {
            return read_values(path);
        }
        let function = self.function.as_deref().map(read_function).transpose()?;
        Ok(if self.upper_star { Growth::Upper(function) } else { Growth::Lower(function) })
    }
}

/// Says which voxels of an image are the model along directions, unless it has but one value that is not 0.
fn say_what_is_set(source: &Source<'_>, common: &Common) -> Result<(), Failure> {
    let Some((name, volume)) = stream(source, common)? else { return Ok(()) };
    let (numbers, _) = volume.numbers().map_err(|error| error.in_file(name.clone()))?;
    let mut set = numbers.into_iter().filter(|&number| number != 0.0);
    let first = set.next();
    if set.all(|number| Some(number) == first) {
        return Ok(());
    }
    let message = "along directions the voxels that are not 0 are a model; choose others with --threshold T";
    let said = [Remark::new(RemarkCode::InputReading, message)];
    common.reading().accept(&said).map_err(|error| error.in_file(name.clone()))?;
    remarks::take(&name, &said);
    Ok(())
}

fn page(answer: &EulerAnswer) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    let sets = if answer.star == "upper" { "superlevel sets" } else { "sublevel sets" };
    fact("function", format!("{}, {sets}", escaped(&answer.function)), "");
    fact("Euler char.", answer.characteristic.to_string(), "of the whole");
    if let (Some(center), Some(radius)) = (&answer.center, answer.radius) {
        let center: Vec<String> = center.iter().map(f64::to_string).collect();
        fact("center", center.join(" "), "from where heights are measured");
        fact("radius", radius.to_string(), "the unit of heights");
    }
    let range = |values: &[f64]| match (values.first(), values.last()) {
        (Some(first), Some(last)) => format!("{} from {first} to {last}", text::count(values.len(), "value")),
        _ => "no values".to_owned(),
    };
    let of_what = if answer.smooth { "smooth Euler characteristics" } else { "Euler characteristics" };
    if let Some(directions) = &answer.directions {
        fact("directions", directions.len().to_string(), "a curve for each");
        fact("heights", range(&answer.values), "all with -o or --json");
    }
    let mut page = text::facts(&format!("{of_what} of {}", escaped(&answer.file)), &facts);
    if answer.directions.is_none() {
        page.push('\n');
        let step = answer.values.len().div_ceil(LISTED).max(1);
        for (value, number) in answer.values.iter().zip(&answer.curves[0]).step_by(step) {
            // Writing to a string does not fail.
            let _ = writeln!(page, "    at {value}: {number}");
        }
        if step > 1 {
            let _ = writeln!(page, "    {}; all with -o or --json", range(&answer.values));
        }
    }
    page
}
