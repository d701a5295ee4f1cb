//! Points that are read as their Čech complex.

use crate::filtered_model::model_of;
use crate::points_table::points_of_path;
use crate::readers::ReadOptions;
use crate::rips::{DIMENSION, skeleton_remark};
use crate::{Model, NumberTable, Remark};
use coface_algebra::Error;
use coface_complexes::filtered::{FilteredComplex, enclosing_ball_radius};
use coface_geometry::Positions;
use std::path::Path;

/// How points become a Čech complex.
///
/// # Examples
/// The corners of a square: balls of radius 1 around them meet in a ring.
/// ```
/// use coface_io::{CechReading, ReadOptions, read_with};
/// let cech = CechReading { radius: Some(1.0), ..CechReading::default() };
/// let model = read_with(&b"0 0\n2 0\n2 2\n0 2\n"[..], &ReadOptions::new().cech(cech))?;
/// assert_eq!((model.lines().len(), model.polygons().len()), (4, 0));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CechReading {
    /// The largest radius of balls; without it that of a ball that holds all points.
    pub radius: Option<f64>,
    /// The highest dimension of simplices; 2 without it.
    pub dimension: Option<usize>,
}

impl CechReading {
    /// The Čech complex of the points of a file: of the rows of a table, or the vertices of a model.
    ///
    /// # Errors
    /// As of [`Self::points`] and [`crate::read_path_with`].
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CechReading, ReadOptions};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = std::env::temp_dir().join("coface-cech.csv");
    /// std::fs::write(&path, "0,0\n6,0\n0,8\n")?;
    /// let found = CechReading::default().points_of_path(&path, &ReadOptions::new())?;
    /// assert_eq!(found.complex().values(1), [3.0, 4.0, 5.0]);
    /// # std::fs::remove_file(&path)?;
    /// # Ok(()) }
    /// ```
    pub fn points_of_path(&self, path: impl AsRef<Path>, options: &ReadOptions) -> Result<CechPoints, Error> {
        let path = path.as_ref();
        let (table, remarks) = points_of_path(path, options)?;
        let mut points = self.points(&table).map_err(|error| error.in_file(path.display().to_string()))?;
        points.remarks.splice(..0, remarks);
        Ok(points)
    }

    /// The Čech complex of the rows of a table.
    ///
    /// # Errors
    /// Those of [`NumberTable::point_dimension`] and [`FilteredComplex::cech`].
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CechReading, NumberTable};
    /// let found = CechReading::default().points(&NumberTable::from_rows([[0.0], [6.0]]));
    /// assert_eq!(found.expect("a complex").complex().values(1), [3.0]);
    /// ```
    pub fn points(&self, table: &NumberTable) -> Result<CechPoints, Error> {
        let columns = table.point_dimension("give each point as many numbers")?;
        let positions = Positions::from_flat(columns, table.numbers().to_vec())?;
        let radius = self.radius.unwrap_or_else(|| enclosing_ball_radius(&positions));
        if radius.is_infinite() {
            return Err(Error::invalid("a squared distance is beyond the range of numbers")
                .with_cure("scale the points down"));
        }
        let complex = FilteredComplex::cech(&positions, radius, self.dimension.unwrap_or(DIMENSION))?;
        let remarks = skeleton_remark(self.dimension, complex.complex().dimension());
        let remarks = remarks.into_iter().chain(table.remarks()).collect();
        Ok(CechPoints { positions, complex, radius, remarks })
    }
}

/// Points with their Čech complex up to a radius.
#[derive(Clone, Debug)]
pub struct CechPoints {
    positions: Positions,
    complex: FilteredComplex,
    radius: f64,
    remarks: Vec<Remark>,
}

impl CechPoints {
    /// The complex, whose values are radii.
    ///
    /// # Examples
    /// See [`CechReading::points`].
    pub fn complex(&self) -> &FilteredComplex {
        &self.complex
    }

    /// The radius up to which it was made.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CechReading, NumberTable};
    /// let reading = CechReading { radius: Some(2.0), ..CechReading::default() };
    /// let found = reading.points(&NumberTable::from_rows([[0.0], [6.0]]));
    /// assert_eq!(found.expect("a complex").radius(), 2.0);
    /// ```
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// What the reader assumed.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CechReading, NumberTable};
    /// let found = CechReading::default().points(&NumberTable::from_rows([[0.0], [6.0]]));
    /// assert!(found.expect("a complex").remarks().is_empty());
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// The points and the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CechReading, NumberTable};
    /// let found = CechReading::default().points(&NumberTable::from_rows([[0.0], [6.0]]));
    /// let (positions, complex) = found.expect("a complex").into_parts();
    /// assert_eq!((positions.len(), complex.values(1)), (2, &[3.0][..]));
    /// ```
    pub fn into_parts(self) -> (Positions, FilteredComplex) {
        (self.positions, self.complex)
    }

    /// The complex as a model, as [`ReadOptions::cech`] says.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CechReading, NumberTable};
    /// let found = CechReading::default().points(&NumberTable::from_rows([[0.0, 0.0], [6.0, 0.0], [0.0, 8.0]]));
    /// assert_eq!(found.expect("a complex").into_model().polygons().len(), 1);
    /// ```
    pub fn into_model(self) -> Model {
        let placed = if self.positions.dimension() <= 3 { self.positions } else { Positions::default() };
        model_of(&placed, &self.complex, self.remarks)
    }
}
