//! Points that are read as their alpha complex.

use crate::filtered_model::{mesh_of, model_of_facets};
use crate::number_table::NumberTable;
use crate::points_table::{is_model, points_of_path};
use crate::readers::ReadOptions;
use crate::{Format, Model, ModelParts, Remark, RemarkCode, Structure, TableForm};
use coface_algebra::{Error, VertexId, memory};
use coface_complexes::alpha::{AlphaComplex, PeriodicAlphaComplex, PeriodicBox};
use coface_geometry::Positions;
use std::path::Path;

/// How points become an alpha complex.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AlphaReading {
    /// The value up to which simplices are kept; all without it.
    pub bound: Option<f64>,
    /// Whether the last number of each row is the weight of the point, a squared radius.
    pub weighted: bool,
    /// Whether values, and the bound, are radii instead of squared radii.
    pub radii: bool,
    /// The lengths after which points repeat; without them they do not.
    pub periods: Option<PeriodicBox>,
}

impl AlphaReading {
    /// The alpha complex of the points of a file: of the rows of a table, or the vertices of a model.
    ///
    /// # Errors
    /// As of [`Self::points`] and [`read_path_with`](crate::read_path_with); [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a model where
    /// points have weights, which only tables have.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{AlphaReading, ReadOptions};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = std::env::temp_dir().join("coface-alpha.csv");
    /// std::fs::write(&path, "0,0\n6,0\n0,8\n")?;
    /// let found = AlphaReading::default().points_of_path(&path, &ReadOptions::new())?;
    /// assert_eq!(found.complex().values(1), [9.0, 16.0, 25.0]);
    /// # std::fs::remove_file(&path)?;
    /// # Ok(()) }
    /// ```
    pub fn points_of_path(
        &self,
        path: impl AsRef<Path>,
        options: &ReadOptions,
    ) -> Result<AlphaPoints, Error> {
        let path = path.as_ref();
        let named = |error: Error| error.in_file(path.display().to_string());
        if self.weighted && is_model(path, options) {
            return Err(named(
                Error::invalid("a model has no weights of its vertices here")
                    .with_cure("give a table with a row of coordinates and the weight for each point"),
            ));
        }
        let (table, remarks) = points_of_path(path, options)?;
        let mut points = self.points(&table).map_err(named)?;
        points.remarks.splice(..0, remarks);
        Ok(points)
    }

    /// The alpha complex of the rows of a table.
    ///
    /// # Errors
    /// Those of [`NumberTable::point_dimension`], [`AlphaComplex::new`] and [`PeriodicAlphaComplex::new`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a bound that is
    /// no number, where squared radii are beyond the range of numbers, and where
    /// points with weights are to have radii, which may be roots of negative numbers; [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) where the memory
    /// that is free would not do.
    ///
    /// # Examples
    /// Two points of the plane, of which the first one has the weight 9.
    /// ```
    /// use coface_io::{AlphaReading, NumberTable};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let table = NumberTable::from_rows([[0.0, 0.0, 9.0], [6.0, 0.0, 0.0]]);
    /// let reading = AlphaReading { weighted: true, ..AlphaReading::default() };
    /// assert_eq!(reading.points(&table)?.complex().values(0), [-9.0, 0.0]);
    /// # Ok(()) }
    /// ```
    pub fn points(&self, table: &NumberTable) -> Result<AlphaPoints, Error> {
        if self.weighted && self.radii {
            return Err(Error::invalid("with weights squared radii may be negative, and have no roots")
                .with_cure("leave out --radii, or --weighted"));
        }
        if self.bound.is_some_and(f64::is_nan) {
            return Err(
                Error::invalid("the value at which the complex ends is NaN").with_cure("give a number")
            );
        }
        let columns = table.point_dimension("give each point as many numbers")?;
        let weights = usize::from(self.weighted);
        let dimension = columns.saturating_sub(weights);
        if table.row_count() > 0 && dimension == 0 {
            return Err(Error::invalid(
                "rows of one number have no room for a weight behind the coordinates",
            )
            .with_cure("write coordinates, and the weight behind them"));
        }
        if dimension > 3 {
            return Err(Error::invalid(format!(
                "points of {dimension} coordinates have no alpha complex here: it is made in dimension 1, 2 and 3"
            ))
            .with_cure("ask for their Vietoris-Rips filtration: coface persistence POINTS --rips"));
        }
        table.require_points(TableForm::Points)?;
        require_memory(table.row_count(), dimension)?;
        let rows = || (0..table.row_count()).map(|row| table.row(row));
        let flat = rows().flat_map(|row| row[..dimension].iter().copied()).collect();
        let positions = Positions::from_flat(if columns == 0 { 0 } else { dimension }, flat)?;
        let weights: Option<Vec<f64>> = self.weighted.then(|| rows().map(|row| row[dimension]).collect());
        let mut complex = match &self.periods {
            None => AlphaCells::Plain(AlphaComplex::new(&positions, weights.as_deref())?),
            Some(domain) => {
                AlphaCells::Periodic(PeriodicAlphaComplex::new(&positions, domain, weights.as_deref())?)
            }
        };
        if complex.values(complex.dimension().unwrap_or(0)).iter().any(|value| value.is_infinite()) {
            return Err(Error::invalid("a squared radius is beyond the range of numbers")
                .with_cure("scale the points down"));
        }
        if self.radii {
            complex = complex.with_radii();
        }
        if let Some(bound) = self.bound {
            complex = complex.up_to(bound);
        }
        let remarks = hidden_points(complex.hidden()).into_iter().chain(table.remarks()).collect();
        Ok(AlphaPoints { positions, complex, remarks })
    }
}

/// Refuses points whose triangulation, if they are spread evenly, has no room.
fn require_memory(count: usize, dimension: usize) -> Result<(), Error> {
    let each = if dimension > 2 { SPATIAL_BYTES } else { PLANAR_BYTES };
    memory::require((count as u64).saturating_mul(each), || {
        format!("the alpha complex of {count} points of {dimension} coordinates")
    })
    .map_err(|error| error.with_cure("take fewer points, or allow more memory"))
}

/// Bytes for each point of space, and for each of the plane, as measured.
const SPATIAL_BYTES: u64 = 4000;
const PLANAR_BYTES: u64 = 1000;

/// The alpha complex of points, or of points that repeat.
#[derive(Clone, Debug)]
pub enum AlphaCells {
    /// Of points as they are.
    Plain(AlphaComplex),
    /// Of points and all of their copies.
    Periodic(PeriodicAlphaComplex),
}

impl AlphaCells {
    /// The dimension of the complex; `None` if there is no point.
    ///
    /// # Examples
    /// See [`Self::values`].
    pub fn dimension(&self) -> Option<usize> {
        match self {
            Self::Plain(alpha) => alpha.complex().dimension(),
            Self::Periodic(alpha) => alpha.complex().dimension(),
        }
    }

    /// The values of the simplices of a degree: squared radii, or radii. Empty beyond the dimension.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::alpha::PeriodicBox;
    /// use coface_io::{AlphaReading, NumberTable};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let table = NumberTable::from_rows([[1.0], [4.0]]);
    /// let reading = AlphaReading { radii: true, ..AlphaReading::default() };
    /// assert_eq!(reading.points(&table)?.complex().values(1), [1.5]);
    /// let circle = AlphaReading { periods: Some(PeriodicBox::new(&[8.0])?), ..reading };
    /// let points = circle.points(&table)?;
    /// assert_eq!((points.complex().dimension(), points.complex().values(1)), (Some(1), &[2.5, 1.5][..]));
    /// # Ok(()) }
    /// ```
    pub fn values(&self, degree: usize) -> &[f64] {
        match self {
            Self::Plain(alpha) => alpha.values(degree),
            Self::Periodic(alpha) => alpha.values(degree),
        }
    }

    /// The points in no simplex of the triangulation, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{AlphaReading, NumberTable};
    /// let found = AlphaReading::default().points(&NumberTable::from_rows([[0.0], [6.0], [6.0]]));
    /// assert_eq!(found.expect("an alpha complex").complex().hidden()[0].index(), 2);
    /// ```
    pub fn hidden(&self) -> &[VertexId] {
        match self {
            Self::Plain(alpha) => alpha.hidden(),
            Self::Periodic(alpha) => alpha.hidden(),
        }
    }

    fn with_radii(self) -> Self {
        match self {
            Self::Plain(alpha) => Self::Plain(alpha.with_radii()),
            Self::Periodic(alpha) => Self::Periodic(alpha.with_radii()),
        }
    }

    fn up_to(&self, bound: f64) -> Self {
        match self {
            Self::Plain(alpha) => Self::Plain(alpha.up_to(bound)),
            Self::Periodic(alpha) => Self::Periodic(alpha.up_to(bound)),
        }
    }
}

/// Points with their alpha complex, up to a bound if there is one.
#[derive(Clone, Debug)]
pub struct AlphaPoints {
    positions: Positions,
    complex: AlphaCells,
    remarks: Vec<Remark>,
}

impl AlphaPoints {
    /// The points.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{AlphaReading, NumberTable};
    /// let found = AlphaReading::default().points(&NumberTable::from_rows([[0.0], [6.0]]));
    /// assert_eq!(found.expect("an alpha complex").positions().len(), 2);
    /// ```
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// The alpha complex.
    ///
    /// # Examples
    /// See [`AlphaReading::points`].
    pub fn complex(&self) -> &AlphaCells {
        &self.complex
    }

    /// What the reader assumed, and how many points are in no simplex: those that equal others, or that weights hide.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{AlphaReading, NumberTable};
    /// let found = AlphaReading::default().points(&NumberTable::from_rows([[0.0], [6.0], [6.0]]));
    /// assert_eq!(found.expect("an alpha complex").remarks()[0].count, 1);
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// The points and the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{AlphaReading, NumberTable};
    /// let found = AlphaReading::default().points(&NumberTable::from_rows([[0.0], [6.0]]));
    /// let (positions, complex) = found.expect("an alpha complex").into_parts();
    /// assert_eq!((positions.len(), complex.values(1)), (2, &[9.0][..]));
    /// ```
    pub fn into_parts(self) -> (Positions, AlphaCells) {
        (self.positions, self.complex)
    }

    /// The complex as a mesh: tetrahedra, the triangles and edges that are in none, and points. Triangles of the plane run counterclockwise, and
    /// tetrahedra are positive. Where points are in no simplex, the others are numbered anew, and data `point` has their numbers.
    ///
    /// Of points that repeat it is the list of simplices if these are known by their points, else the chain complex; both have no positions, since simplices
    /// reach across the sides of the box.
    ///
    /// # Errors
    /// Those of [`DeltaComplex::chain_complex`](coface_complexes::simplicial::DeltaComplex::chain_complex), of points that repeat.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{AlphaReading, NumberTable};
    /// let found = AlphaReading::default().points(&NumberTable::from_rows([[0.0, 0.0], [6.0, 0.0], [0.0, 8.0]]));
    /// let model = found.and_then(|points| points.into_model()).expect("an alpha complex");
    /// assert_eq!((model.vertex_count(), model.polygons().len()), (3, 1));
    /// ```
    pub fn into_model(self) -> Result<Model, Error> {
        let alpha = match self.complex {
            AlphaCells::Plain(alpha) => {
                return Ok(mesh_of(&self.positions, &alpha.into_filtered(), self.remarks));
            }
            AlphaCells::Periodic(alpha) => alpha,
        };
        if let Some(complex) = alpha.simplicial() {
            return Ok(model_of_facets(complex.facets_up_to(f64::INFINITY), self.remarks));
        }
        let structure = Some(Structure::Chains(alpha.complex().chain_complex()?));
        let parts = ModelParts {
            format: Some(Format::Points),
            structure,
            remarks: self.remarks,
            ..ModelParts::default()
        };
        Ok(parts.into_model())
    }
}

/// A remark on points in no simplex.
fn hidden_points(hidden: &[VertexId]) -> Option<Remark> {
    let (&first, count) = (hidden.first()?, hidden.len());
    let what = if count == 1 { "1 point is".to_owned() } else { format!("{count} points are") };
    let message = format!(
        "{what} in no simplex, because each equals another point or is hidden by weights; the first one is point {}",
        first.index()
    );
    Some(Remark::new(RemarkCode::InputReading, message).at(count, []))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{GroupKind, read_with};

    fn read(text: &str, alpha: AlphaReading) -> Result<Model, Error> {
        read_with(text.as_bytes(), &ReadOptions::new().alpha(alpha))
    }

    #[test]
    fn points_that_are_hidden_leave_no_vertex() {
        let model = read("0 0\n6 0\n6 0\n0 8\n", AlphaReading::default()).unwrap();
        assert_eq!((model.vertex_count(), model.polygons().len(), model.remarks().len()), (3, 1, 1));
        assert_eq!(model.data_named("point", GroupKind::Vertices).unwrap().integer_row(2), Some(vec![3]));
        model.check().unwrap();
        let strict = ReadOptions::new().alpha(AlphaReading::default()).strict(true);
        assert!(read_with(&b"0 0\n0 0\n"[..], &strict).is_err());
    }

    #[test]
    fn bounds_are_values() {
        let count = |bound: f64, radii: bool| {
            let alpha = AlphaReading { bound: Some(bound), radii, ..AlphaReading::default() };
            let model = read("0 0 0\n6 0 0\n0 8 0\n0 0 1\n", alpha).unwrap();
            model.check().unwrap();
            (model.cells().len(), model.polygons().len(), model.lines().len(), model.points().len())
        };
        assert_eq!(count(0.0, false), (0, 0, 0, 4));
        assert_eq!(count(9.0, false).2, count(3.0, true).2);
        assert_eq!(count(1e9, false), (1, 0, 0, 0));
    }

    #[test]
    fn few_points_are_read() {
        assert!(read("", AlphaReading::default()).unwrap_err().to_string().contains("no point"));
        assert_eq!(read("5 5 5\n", AlphaReading::default()).unwrap().vertex_count(), 1);
        assert_eq!(read("5\n7\n", AlphaReading::default()).unwrap().lines().len(), 1);
    }

    #[test]
    fn faults_are_named() {
        let fault = |text: &str, alpha| read(text, alpha).unwrap_err().to_string();
        let weighted = AlphaReading { weighted: true, ..AlphaReading::default() };
        assert!(fault("1 2 3 4\n", AlphaReading::default()).contains("--rips"));
        assert!(fault("1 2\n1 2 3\n", AlphaReading::default()).contains("point 1 has 3 coordinates"));
        assert!(fault("1 2\n1 nan\n", AlphaReading::default()).contains("NaN"));
        assert!(fault("0 0\n1e200 0\n", AlphaReading::default()).contains("scale the points down"));
        let nowhere = AlphaReading { bound: Some(f64::NAN), ..AlphaReading::default() };
        assert!(fault("0 0\n", nowhere).contains("give a number"));
        assert!(fault("1\n", weighted).contains("the weight behind them"));
        assert!(fault("1 2 1\n", AlphaReading { radii: true, ..weighted }).contains("leave out --radii"));
    }
}
