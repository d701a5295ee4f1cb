//! `coface persistence` of points, distances and graphs: with `--rips` and `--flag` their complexes are not stored but for cycles, with `--alpha`, `--cech`,
//! `--landmarks` and `--flag --directed` they are.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input::{self, Source};
use crate::progress::Progress;
use crate::remarks;
use coface::answers::answer::Remark;
use coface::answers::{FoundRips, PointFiltration, RipsRequest};
use coface::complexes::filtered::DirectedFlagComplex;
use coface::geometry::Positions;
use coface::io::{CechReading, FileGraph, FlagReading, NumberTable, RipsReading, WitnessReading};
use coface::topology::Coefficients;
use std::path::Path;

/// What is asked of points and graphs.
pub(super) struct PointQuestion {
    pub(super) coefficients: Coefficients,
    pub(super) min_persistence: f64,
    pub(super) collapse: bool,
}

impl PointQuestion {
    /// The diagram of points, distances or a graph, if the options say that the input is one, with the positions of points that have some.
    pub(super) fn found(
        &self,
        path: &Path,
        common: &Common,
        progress: &Progress,
    ) -> Result<Option<(FoundRips, Positions)>, Failure> {
        let threshold = common.voxels.threshold();
        if let Some(rips) = common.points.rips(threshold) {
            return self.of_points(path, common, rips, progress).map(Some);
        }
        match common.points.flag(threshold).filter(|flag| !flag.directed) {
            Some(flag) => {
                let found = self.of_graph(path, common, flag, progress)?;
                Ok(Some((found, Positions::default())))
            }
            None => Ok(None),
        }
    }

    fn request(&self, common: &Common) -> RipsRequest {
        RipsRequest::new()
            .coefficients(self.coefficients)
            .dimension(common.points.dimension().unwrap_or(1))
            .threshold(common.voxels.threshold())
            .min_persistence(self.min_persistence)
            .collapse(self.collapse)
    }

    fn of_points(
        &self,
        path: &Path,
        common: &Common,
        reading: RipsReading,
        progress: &Progress,
    ) -> Result<(FoundRips, Positions), Failure> {
        let name = input::name(path);
        progress.stage(format!("reading {name}"));
        let points = match Source::of(path)? {
            Source::File(path) => reading.distances_of_path(path, &common.reading())?,
            Source::Bytes(bytes) => NumberTable::read_distances(bytes)
                .and_then(|table| reading.distances(&table))
                .map_err(|error| error.in_file(name.clone()))?,
        };
        accept(common, points.remarks(), &name)?;
        let found = self.request(common).found(&name, points.distances())?;
        Ok((found, points.positions().clone()))
    }

    fn of_graph(
        &self,
        path: &Path,
        common: &Common,
        reading: FlagReading,
        progress: &Progress,
    ) -> Result<FoundRips, Failure> {
        let name = input::name(path);
        progress.stage(format!("reading {name}"));
        let graph = match Source::of(path)? {
            Source::File(path) => reading.graph_of_path(path)?,
            Source::Bytes(bytes) => reading.graph(bytes).map_err(|error| error.in_file(name.clone()))?,
        };
        accept(common, graph.remarks(), &name)?;
        Ok(self.request(common).found_of_graph(&name, &graph)?)
    }
}

fn graph_of(source: &Source<'_>, reading: FlagReading, name: &str) -> Result<FileGraph, coface::Error> {
    match source {
        Source::File(path) => reading.graph_of_path(path),
        Source::Bytes(bytes) => reading.graph(*bytes).map_err(|error| error.in_file(name)),
    }
}

/// Points or a graph with the complex that is stored of them, and the highest degree that it tells, if it lacks cells above.
pub(super) fn stored(
    source: &Source<'_>,
    common: &Common,
    name: &str,
    progress: &Progress,
) -> Result<Option<(PointFiltration, Option<usize>)>, Failure> {
    let threshold = common.voxels.threshold();
    let degree = common.points.dimension().unwrap_or(1);
    let options = common.reading();
    let in_file = |error: coface::Error| error.in_file(name);
    let table = |bytes: &[u8]| NumberTable::read(bytes);
    if let Some(alpha) = common.points.alpha() {
        progress.stage(format!("reading {name}"));
        let points = match source {
            Source::File(path) => alpha.points_of_path(path, &options)?,
            Source::Bytes(bytes) => table(bytes).and_then(|table| alpha.points(&table)).map_err(in_file)?,
        };
        return Ok(Some((PointFiltration::of_alpha(points, alpha.radii), None)));
    }
    if let Some(cech) = common.points.cech(threshold) {
        progress.stage(format!("reading {name}"));
        let cech = CechReading { dimension: Some(degree + 1), ..cech };
        let points = match source {
            Source::File(path) => cech.points_of_path(path, &options)?,
            Source::Bytes(bytes) => table(bytes).and_then(|table| cech.points(&table)).map_err(in_file)?,
        };
        return Ok(Some((PointFiltration::of_cech(points), Some(degree))));
    }
    if let Some(mapper) = common.points.mapper(threshold) {
        progress.stage(format!("reading {name}"));
        let points = match source {
            Source::File(path) => mapper.points_of_path(path, &options)?,
            Source::Bytes(bytes) => table(bytes).and_then(|table| mapper.points(&table)).map_err(in_file)?,
        };
        return Ok(Some((PointFiltration::of_mapper(points), None)));
    }
    if let Some(witness) = common.points.witness(threshold) {
        progress.stage(format!("reading {name}"));
        let witness = WitnessReading { dimension: Some(degree + 1), ..witness };
        let points = match source {
            Source::File(path) => witness.points_of_path(path, &options)?,
            Source::Bytes(bytes) => table(bytes).and_then(|table| witness.points(&table)).map_err(in_file)?,
        };
        return Ok(Some((PointFiltration::of_witness(points), Some(degree))));
    }
    if let Some(flag) = common.points.flag(threshold).filter(|flag| flag.directed) {
        progress.stage(format!("reading {name}"));
        let graph = graph_of(source, flag, name)?;
        let threshold = threshold.unwrap_or(f64::INFINITY);
        let complex = DirectedFlagComplex::new(&graph.digraph(), threshold, degree + 1).map_err(in_file)?;
        return Ok(Some((PointFiltration::of_directed(&graph, complex), Some(degree))));
    }
    Ok(None)
}

/// Says what a reader assumed, or refuses it.
fn accept(common: &Common, said: &[Remark], name: &str) -> Result<(), Failure> {
    common.reading().accept(said).map_err(|error| error.in_file(name))?;
    remarks::take(name, said);
    Ok(())
}
