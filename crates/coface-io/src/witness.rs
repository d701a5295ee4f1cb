//! Points that are read as witnesses of landmarks.

use crate::filtered_model::model_of;
use crate::points_table::points_of_path;
use crate::readers::ReadOptions;
use crate::rips::{DIMENSION, skeleton_remark};
use crate::{Model, NumberTable, Remark, RemarkCode};
use coface_algebra::{Error, VertexId};
use coface_complexes::filtered::{FilteredComplex, WitnessRule, farthest_points};
use coface_geometry::Positions;
use std::path::Path;

/// How points become a witness complex.
///
/// # Examples
/// Four landmarks on a square with points between them.
/// ```
/// use coface_io::{ReadOptions, WitnessReading, read_with};
/// let witness = WitnessReading { bound: Some(0.0), ..WitnessReading::of_count(4) };
/// let points = "0 0\n2 0\n2 2\n0 2\n1 0\n2 1\n1 2\n0 1\n";
/// let model = read_with(points.as_bytes(), &ReadOptions::new().witness(witness))?;
/// assert_eq!((model.vertex_count(), model.lines().len()), (4, 4));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WitnessReading {
    /// How many landmarks are chosen: the first point, then again and again the point that is farthest from those before it.
    pub landmarks: usize,
    /// What witnesses are asked for.
    pub rule: WitnessRule,
    /// The largest value, a squared distance; all without it.
    pub bound: Option<f64>,
    /// The highest dimension of simplices; 2 without it.
    pub dimension: Option<usize>,
}

impl WitnessReading {
    /// The weak witness complex of so many landmarks.
    ///
    /// # Examples
    /// See [`WitnessReading`].
    pub fn of_count(landmarks: usize) -> Self {
        Self { landmarks, rule: WitnessRule::Weak, bound: None, dimension: None }
    }

    /// The witness complex of the points of a file: of the rows of a table, or the vertices of a model.
    ///
    /// # Errors
    /// As of [`Self::points`] and [`crate::read_path_with`].
    ///
    /// # Examples
    /// ```
    /// use coface_io::{ReadOptions, WitnessReading};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = std::env::temp_dir().join("coface-witness.csv");
    /// std::fs::write(&path, "0\n4\n1\n")?;
    /// let found = WitnessReading::of_count(2).points_of_path(&path, &ReadOptions::new())?;
    /// assert_eq!(found.complex().values(1), [0.0]);
    /// # std::fs::remove_file(&path)?;
    /// # Ok(()) }
    /// ```
    pub fn points_of_path(
        &self,
        path: impl AsRef<Path>,
        options: &ReadOptions,
    ) -> Result<WitnessPoints, Error> {
        let path = path.as_ref();
        let (table, remarks) = points_of_path(path, options)?;
        let mut points = self.points(&table).map_err(|error| error.in_file(path.display().to_string()))?;
        points.remarks.splice(..0, remarks);
        Ok(points)
    }

    /// The witness complex of the rows of a table.
    ///
    /// # Errors
    /// Those of [`NumberTable::point_dimension`] and [`FilteredComplex::witness`].
    ///
    /// # Examples
    /// See [`WitnessPoints`].
    pub fn points(&self, table: &NumberTable) -> Result<WitnessPoints, Error> {
        let columns = table.point_dimension("give each point as many numbers")?;
        let points = Positions::from_flat(columns, table.numbers().to_vec())?;
        let chosen = farthest_points(&points, self.landmarks);
        let flat = chosen.iter().flat_map(|&id| points.point(VertexId::new(id)).to_vec()).collect();
        let positions = Positions::from_flat(columns, flat)?;
        let bound = self.bound.unwrap_or(f64::INFINITY);
        let dimension = self.dimension.unwrap_or(DIMENSION);
        let complex = FilteredComplex::witness(&points, &positions, self.rule, bound, dimension)?;
        let mut remarks: Vec<Remark> = skeleton_remark(self.dimension, complex.complex().dimension())
            .into_iter()
            .chain(table.remarks())
            .collect();
        if chosen.len() < self.landmarks {
            let message = format!(
                "{} landmarks were asked for, and there are {} different points",
                self.landmarks,
                chosen.len()
            );
            remarks.push(Remark::new(RemarkCode::InputReading, message));
        }
        Ok(WitnessPoints { landmarks: chosen, positions, complex, remarks })
    }
}

/// Landmarks with their witness complex.
///
/// # Examples
/// ```
/// use coface_io::{NumberTable, WitnessReading};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let found = WitnessReading::of_count(2).points(&NumberTable::from_rows([[0.0], [1.0], [4.0]]))?;
/// assert_eq!((found.landmarks(), found.complex().values(1)), (&[0, 2][..], &[0.0][..]));
/// assert!(found.remarks().is_empty());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct WitnessPoints {
    landmarks: Vec<usize>,
    /// Of the landmarks.
    positions: Positions,
    complex: FilteredComplex,
    remarks: Vec<Remark>,
}

impl WitnessPoints {
    /// Which points are landmarks, in their order: they are the vertices of the complex.
    ///
    /// # Examples
    /// See [`WitnessPoints`].
    pub fn landmarks(&self) -> &[usize] {
        &self.landmarks
    }

    /// The complex, whose values are squared distances.
    ///
    /// # Examples
    /// See [`WitnessPoints`].
    pub fn complex(&self) -> &FilteredComplex {
        &self.complex
    }

    /// What the reader assumed.
    ///
    /// # Examples
    /// See [`WitnessPoints`].
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// The landmarks and the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{NumberTable, WitnessReading};
    /// let found = WitnessReading::of_count(2).points(&NumberTable::from_rows([[0.0], [1.0], [4.0]]));
    /// assert_eq!(found.expect("a complex").into_parts().0.as_flat(), [0.0, 4.0]);
    /// ```
    pub fn into_parts(self) -> (Positions, FilteredComplex) {
        (self.positions, self.complex)
    }

    /// The complex as a model, as [`ReadOptions::witness`] says.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{NumberTable, WitnessReading};
    /// let found = WitnessReading::of_count(2).points(&NumberTable::from_rows([[0.0], [1.0], [4.0]]));
    /// assert_eq!(found.expect("a complex").into_model().lines().len(), 1);
    /// ```
    pub fn into_model(self) -> Model {
        let placed = if self.positions.dimension() <= 3 { self.positions } else { Positions::default() };
        model_of(&placed, &self.complex, self.remarks)
    }
}
