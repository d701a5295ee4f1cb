//! Points that are read as their Mapper complex.

use crate::filtered_model::model_of;
use crate::points_table::points_of_path;
use crate::readers::ReadOptions;
use crate::rips::RipsReading;
use crate::{CellData, GroupKind, Model, NumberTable, Remark, RemarkCode, TableForm};
use coface_algebra::Error;
use coface_complexes::filtered::{Distances, FilteredComplex, IntervalCover, MapperComplex};
use coface_geometry::Positions;
use std::path::Path;

/// The function on points whose range is covered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lens {
    /// A coordinate, counted from 0.
    Coordinate(usize),
    /// The number behind the coordinates in each row of a table.
    Last,
    /// The largest distance to another point.
    Eccentricity,
}

/// How points become a Mapper complex.
///
/// # Examples
/// Eight points of a circle, and their heights over three intervals: a circle of four clusters.
/// ```
/// use coface_io::{Lens, MapperReading, ReadOptions, read_with};
/// let mapper = MapperReading { lens: Lens::Coordinate(1), ..MapperReading::of_count(3)? };
/// let circle = "0 -5\n3 -2\n4 0\n3 2\n0 5\n-3 2\n-4 0\n-3 -2\n";
/// let model = read_with(circle.as_bytes(), &ReadOptions::new().mapper(mapper))?;
/// assert_eq!((model.vertex_count(), model.lines().len()), (4, 4));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapperReading {
    /// The intervals that cover the range of the function.
    pub cover: IntervalCover,
    /// The function.
    pub lens: Lens,
    /// Points within this distance are neighbors; without it within the least distance at which all points are connected, of which a remark tells.
    pub threshold: Option<f64>,
}

/// How much of an interval is in the next one if nothing else is said, as in GUDHI.
const OVERLAP: f64 = 0.3;

impl MapperReading {
    /// The Mapper complex of the first coordinate over so many intervals, each of which overlaps the next by three tenths.
    ///
    /// # Errors
    /// Those of [`IntervalCover::new`].
    ///
    /// # Examples
    /// See [`MapperReading`].
    pub fn of_count(intervals: usize) -> Result<Self, Error> {
        let cover = IntervalCover::new(intervals, OVERLAP)?;
        Ok(Self { cover, lens: Lens::Coordinate(0), threshold: None })
    }

    /// The Mapper complex of the points of a file: of the rows of a table, or the vertices of a model.
    ///
    /// # Errors
    /// As of [`Self::points`] and [`crate::read_path_with`].
    ///
    /// # Examples
    /// ```
    /// use coface_io::{MapperReading, ReadOptions};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = std::env::temp_dir().join("coface-mapper.csv");
    /// std::fs::write(&path, "0\n1\n2\n")?;
    /// let found = MapperReading::of_count(2)?.points_of_path(&path, &ReadOptions::new())?;
    /// assert_eq!(found.complex().complex().f_vector(), [2, 1]);
    /// # std::fs::remove_file(&path)?;
    /// # Ok(()) }
    /// ```
    pub fn points_of_path(
        &self,
        path: impl AsRef<Path>,
        options: &ReadOptions,
    ) -> Result<MapperPoints, Error> {
        let path = path.as_ref();
        let (table, remarks) = points_of_path(path, options)?;
        let mut points = self.points(&table).map_err(|error| error.in_file(path.display().to_string()))?;
        points.remarks.splice(..0, remarks);
        Ok(points)
    }

    /// The Mapper complex of the rows of a table.
    ///
    /// # Errors
    /// Those of [`NumberTable::point_dimension`] and [`MapperComplex::new`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a coordinate that points do not have,
    /// rows without a number behind the coordinates where one is asked for, and a threshold that is negative or no number.
    ///
    /// # Examples
    /// See [`MapperPoints`].
    pub fn points(&self, table: &NumberTable) -> Result<MapperPoints, Error> {
        let columns = table.point_dimension("give each point as many numbers")?;
        let coordinates = columns - usize::from(self.lens == Lens::Last && columns > 0);
        let rows = || (0..table.row_count()).map(|row| table.row(row));
        if table.row_count() > 0 {
            match self.lens {
                Lens::Coordinate(axis) if axis >= columns => {
                    return Err(Error::invalid(format!(
                        "points of {columns} coordinates have no coordinate {axis}"
                    ))
                    .with_cure("coordinates are counted from 0: give a smaller number"));
                }
                Lens::Last if columns < 2 => {
                    return Err(Error::invalid(
                        "rows of one number have no room for a value behind the coordinates",
                    )
                    .with_cure("write coordinates, and the value behind them"));
                }
                _ => {}
            }
        }
        let values: Option<Vec<f64>> = match self.lens {
            Lens::Coordinate(axis) => Some(rows().map(|row| row[axis]).collect()),
            Lens::Last => Some(rows().map(|row| row[coordinates]).collect()),
            Lens::Eccentricity => None,
        };
        let own = NumberTable::from_rows(rows().map(|row| &row[..coordinates]));
        let mut found = self.placed(&own, values.as_deref())?;
        found.remarks.splice(..0, table.remarks());
        Ok(found)
    }

    /// The Mapper complex of the rows of a table and the values of any function on them, instead of that of the reading.
    ///
    /// # Errors
    /// As of [`Self::points`].
    ///
    /// # Examples
    /// ```
    /// use coface_io::{MapperReading, NumberTable};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let line = NumberTable::from_rows([[0.0], [1.0], [3.0]]);
    /// let found = MapperReading::of_count(2)?.points_of_values(&line, &[0.0, 5.0, 10.0])?;
    /// assert_eq!(found.complex().complex().f_vector(), [2, 1]);
    /// assert!(found.remarks()[0].message.contains("within 2.0"));
    /// # Ok(()) }
    /// ```
    pub fn points_of_values(&self, table: &NumberTable, values: &[f64]) -> Result<MapperPoints, Error> {
        table.point_dimension("give each point as many numbers")?;
        self.placed(table, Some(values))
    }

    /// The complex of points, and of their eccentricities if there are no values.
    fn placed(&self, table: &NumberTable, values: Option<&[f64]>) -> Result<MapperPoints, Error> {
        let reading = RipsReading { form: Some(TableForm::Points), ..RipsReading::default() };
        let points = reading.distances(table)?;
        let distances = points.distances();
        let (threshold, remark) = match self.threshold {
            Some(threshold) if threshold.is_nan() || threshold < 0.0 => {
                let message = format!("the threshold is {threshold}, and distances are not negative");
                return Err(Error::invalid(message).with_cure("give a threshold of 0 or more"));
            }
            Some(threshold) => (threshold, None),
            None => {
                // Edges that are as long but for rounding are edges too.
                let least = distances.connecting_distance().unwrap_or(0.0) * (1.0 + 1e-9);
                let message = format!(
                    "points within {least} are neighbors: the least distance at which all are connected"
                );
                (least, Some(Remark::new(RemarkCode::InputReading, message)))
            }
        };
        let own = if values.is_none() { eccentricities(distances) } else { Vec::new() };
        let complex =
            MapperComplex::new(&distances.graph_within(threshold), values.unwrap_or(&own), &self.cover)?;
        let dimension = if table.row_count() == 0 { 0 } else { table.row(0).len() };
        let positions = Positions::from_flat(dimension, centers(table, dimension, complex.clusters()))?;
        Ok(MapperPoints { complex, positions, remarks: remark.into_iter().collect() })
    }
}

/// For each point its largest distance to another.
fn eccentricities(distances: &Distances) -> Vec<f64> {
    let mut most = vec![0.0f64; distances.point_count()];
    distances.each(|i, j, distance| {
        most[i] = most[i].max(distance);
        most[j] = most[j].max(distance);
    });
    most
}

/// The means of the points of each cluster.
fn centers(table: &NumberTable, coordinates: usize, clusters: &coface_algebra::RaggedArray) -> Vec<f64> {
    let mut flat = Vec::with_capacity(clusters.len() * coordinates);
    for cluster in clusters.iter() {
        let share = 1.0 / cluster.len() as f64;
        for axis in 0..coordinates {
            flat.push(cluster.iter().map(|&point| table.row(point as usize)[axis] * share).sum());
        }
    }
    flat
}

/// Points with their Mapper complex.
///
/// # Examples
/// ```
/// use coface_io::{MapperReading, NumberTable};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let line = NumberTable::from_rows([[0.0], [1.0], [2.0]]);
/// let found = MapperReading::of_count(2)?.points(&line)?;
/// assert_eq!(found.clusters().iter().collect::<Vec<_>>(), [[0, 1], [1, 2]]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct MapperPoints {
    complex: MapperComplex,
    /// The means of the clusters.
    positions: Positions,
    remarks: Vec<Remark>,
}

impl MapperPoints {
    /// The points of each cluster: the clusters are the vertices of the complex.
    ///
    /// # Examples
    /// See [`MapperPoints`].
    pub fn clusters(&self) -> &coface_algebra::RaggedArray {
        self.complex.clusters()
    }

    /// The complex, whose values are those of the function, of a cluster its mean.
    ///
    /// # Examples
    /// See [`MapperReading::points_of_path`].
    pub fn complex(&self) -> &FilteredComplex {
        self.complex.complex()
    }

    /// What the reader assumed.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{MapperReading, NumberTable};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let near = MapperReading { threshold: Some(1.0), ..MapperReading::of_count(2)? };
    /// assert!(near.points(&NumberTable::from_rows([[0.0], [1.0]]))?.remarks().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// The means of the clusters, and the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{MapperReading, NumberTable};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let found = MapperReading::of_count(1)?.points(&NumberTable::from_rows([[0.0], [1.0]]))?;
    /// assert_eq!(found.into_parts().0.as_flat(), [0.5]);
    /// # Ok(()) }
    /// ```
    pub fn into_parts(self) -> (Positions, FilteredComplex) {
        (self.positions, self.complex.into_complex())
    }

    /// The complex as a model, as [`ReadOptions::mapper`] says; where clusters have positions with data: `points`, how many points they have, and `value`, the mean of the function.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{GroupKind, MapperReading, NumberTable};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let found = MapperReading::of_count(1)?.points(&NumberTable::from_rows([[0.0], [1.0]]))?;
    /// let model = found.into_model();
    /// let sizes = model.data_named("points", GroupKind::Vertices).expect("sizes of clusters");
    /// assert_eq!(sizes.integer_row(0), Some(vec![2]));
    /// # Ok(()) }
    /// ```
    pub fn into_model(self) -> Model {
        let placed = if self.positions.dimension() <= 3 { self.positions } else { Positions::default() };
        let model = model_of(&placed, self.complex.complex(), self.remarks);
        // A nerve of dimension 4 or more is an abstract complex, which has no data.
        if placed.is_empty() || model.vertex_count() != self.complex.clusters().len() {
            return model;
        }
        let sizes = self.complex.clusters().iter().map(|cluster| cluster.len() as i64).collect();
        let values = self.complex.complex().values(0).to_vec();
        let data = [
            CellData::integers("points", GroupKind::Vertices, 1, sizes),
            CellData::reals("value", GroupKind::Vertices, 1, values),
        ];
        data.into_iter().fold(model, |model, data| {
            data.and_then(|data| model.with_data(data)).expect("one number for each cluster")
        })
    }
}
