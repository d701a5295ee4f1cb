//! `coface persistence --rips`: points and distances.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input::{self, Source};
use crate::progress::Progress;
use crate::remarks;
use clap::Args;
use coface::answers::answer::Remark;
use coface::answers::{FoundRips, RipsRequest, TableForm};
use coface::io::{NumberTable, vertices_of_path};
use coface::topology::{Coefficients, Distances};
use std::path::Path;

/// What is asked of points and distances.
#[derive(Args)]
pub(super) struct PointArguments {
    /// Of points, the Vietoris-Rips filtration: each set of points enters at the largest distance of two of them. The input
    /// is a table with a row for each point (.csv, .txt, .npy, any number of coordinates), or the vertices of a model.
    /// --threshold T ends it at diameter T instead of the enclosing radius, behind which nothing changes
    #[arg(long, conflicts_with_all = ["function", "values", "upper_star"], help_heading = "Points")]
    pub(super) rips: bool,
    /// The highest degree of classes [default: 1]
    #[arg(long, value_name = "K", requires = "rips", help_heading = "Points",
          value_parser = clap::value_parser!(u8).range(..=15))]
    dimension: Option<u8>,
    /// The table has distances: lower or upper (those of a triangle, one row after the other), square, or sparse (rows
    /// i j distance, points from 0 on; all others are infinitely far apart); or points, which is meant without this option
    /// unless the table is symmetric with zeros on its diagonal
    #[arg(long, value_name = "FORM", requires = "rips", help_heading = "Points", value_parser = form)]
    distances: Option<TableForm>,
    /// The table is a time series, a row for each time: a point is the rows at times t, t + D, t + 2D, .. one after the other
    /// (embedding by delays)
    #[arg(long, value_name = "D", requires = "rips", conflicts_with = "distances", help_heading = "Points",
          value_parser = clap::value_parser!(u32).range(1..))]
    delay: Option<u32>,
    /// How many times a point of a time series has [default: 2]
    #[arg(long, value_name = "N", requires = "delay", help_heading = "Points",
          value_parser = clap::value_parser!(u32).range(1..=1000))]
    embedding: Option<u32>,
}

fn form(name: &str) -> Result<TableForm, String> {
    TableForm::from_name(name).map_err(|error| error.to_string())
}

impl PointArguments {
    /// Finds the diagram.
    pub(super) fn found(
        &self,
        path: &Path,
        common: &Common,
        coefficients: Coefficients,
        min_persistence: f64,
        progress: &Progress,
    ) -> Result<FoundRips, Failure> {
        let name = input::name(path);
        let (distances, said) = self.read(path, common, progress)?;
        remarks::take(&name, said.as_slice());
        let request = RipsRequest::new()
            .coefficients(coefficients)
            .dimension(self.dimension.unwrap_or(1).into())
            .threshold(common.voxels.threshold())
            .min_persistence(min_persistence);
        Ok(request.found(&name, &distances)?)
    }

    fn read(
        &self,
        path: &Path,
        common: &Common,
        progress: &Progress,
    ) -> Result<(Distances, Option<Remark>), Failure> {
        let name = input::name(path);
        progress.stage(format!("reading {name}"));
        let in_file = |error: coface::Error| Failure::from(error.in_file(name.clone()));
        let form = self.distances.or_else(|| form_of_extension(path));
        if matches!(form, None | Some(TableForm::Points))
            && self.delay.is_none()
            && let Some((vertices, said)) = vertices_of_path(path, &common.reading())?
        {
            remarks::take(&name, &said);
            return Ok((TableForm::Points.distances(&vertices).map_err(in_file)?, None));
        }
        let table = match Source::of(path)? {
            Source::File(path) => NumberTable::read_path(path)?,
            Source::Bytes(bytes) => NumberTable::read(&bytes[..]).map_err(in_file)?,
        };
        let (table, (form, said)) = match (self.delay, form) {
            (Some(delay), _) => {
                let embedding = self.embedding.unwrap_or(2) as usize;
                (table.delayed(delay as usize, embedding).map_err(in_file)?, (TableForm::Points, None))
            }
            (None, Some(form)) => (table, (form, None)),
            (None, None) => {
                let found = TableForm::of(&table);
                (table, found)
            }
        };
        Ok((form.distances(&table).map_err(in_file)?, said))
    }
}

/// Files of Ripser are named by what they hold.
fn form_of_extension(path: &Path) -> Option<TableForm> {
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("lower_distance_matrix") => Some(TableForm::Lower),
        Some("upper_distance_matrix") => Some(TableForm::Upper),
        Some("distance_matrix") => Some(TableForm::Square),
        _ => None,
    }
}
