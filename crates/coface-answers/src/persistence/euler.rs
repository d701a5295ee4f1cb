//! Euler characteristic curves and transforms of models and images.

use super::curves::{CurveValues, even_values, require_values};
use super::{GreyImage, Growth, ImageRequest, PersistenceRequest};
use crate::Producer;
use crate::answer::EulerAnswer;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, VertexId};
use coface_io::NumberTable;
use coface_topology::{EulerCurve, EulerTransform, Filtration, even_directions};

/// Directions along which heights are measured.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Directions {
    /// So many that are spread evenly, as [`even_directions`] gives them.
    Even(usize),
    /// These, which need not be as long as a unit.
    Given {
        /// Where they come from.
        place: String,
        /// A row of coordinates for each.
        rows: Vec<Vec<f64>>,
    },
}

/// Asks for the Euler characteristic of what has entered at each value, or along each of some directions: its Euler characteristic transform.
///
/// # Examples
/// A path that goes up to 2 and down to 1: a second piece at 1, which is joined to the first one at 2.
/// ```
/// use coface_answers::{EulerRequest, Growth, Producer, VertexFunction};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = Producer::of(coface_io::read(&b"[[0,1],[1,2]]"[..], coface_io::Format::Json)?)?;
/// let heights = VertexFunction::Values { place: "heights".to_owned(), values: vec![0.0, 2.0, 1.0] };
/// let answer = EulerRequest::new().growth(Growth::Lower(Some(heights))).answer("path", &path)?;
/// assert_eq!((&answer.values[..], &answer.curves[0][..]), (&[0.0, 1.0, 2.0][..], &[1.0, 2.0, 1.0][..]));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct EulerRequest {
    growth: Growth,
    directions: Option<Directions>,
    values: CurveValues,
    is_smooth: bool,
    is_normalized: bool,
}

impl Default for EulerRequest {
    fn default() -> Self {
        Self {
            growth: Growth::Lower(None),
            directions: None,
            values: CurveValues::Ends,
            is_smooth: false,
            is_normalized: false,
        }
    }
}

/// How many values a curve has where nothing says it and all steps cannot be given.
const SAMPLES: usize = 100;

impl EulerRequest {
    /// Asks for the curve of the height, at each value at which it changes.
    ///
    /// # Examples
    /// See [`EulerRequest`].
    pub fn new() -> Self {
        Self::default()
    }

    /// How the model grows, where there are no directions.
    ///
    /// # Examples
    /// See [`EulerRequest`].
    pub fn growth(mut self, growth: Growth) -> Self {
        self.growth = growth;
        self
    }

    /// Asks for a curve for each direction.
    ///
    /// # Examples
    /// A square, whose corners lie at heights from -1 to 1 along all directions when it is normalized.
    /// ```
    /// use coface_answers::{CurveValues, Directions, EulerRequest, Producer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = &b"OFF\n4 1 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n4 0 1 2 3\n"[..];
    /// let square = Producer::of(coface_io::read(square, coface_io::Format::Off)?)?;
    /// let request = EulerRequest::new().directions(Some(Directions::Even(6))).normalized(true);
    /// let answer = request.values(CurveValues::Even { count: 3, range: None }).answer("square", &square)?;
    /// assert_eq!((&answer.values[..], answer.curves.len()), (&[-1.0, 0.0, 1.0][..], 6));
    /// assert_eq!((answer.curves[0][2], answer.radius), (1.0, Some(2.0_f64.sqrt())));
    /// # Ok(()) }
    /// ```
    pub fn directions(mut self, directions: Option<Directions>) -> Self {
        self.directions = directions;
        self
    }

    /// At which values curves are given. [`CurveValues::Ends`] are the steps of one curve; curves of directions are given at 100 values then. A range is by
    /// default that of all values at which something enters, or of directions that of all heights that there can be.
    ///
    /// # Examples
    /// See [`Self::directions`].
    pub fn values(mut self, values: CurveValues) -> Self {
        self.values = values;
        self
    }

    /// Asks for smooth curves, as [`EulerCurve::smooth`] defines them, over the range from the least to the greatest value.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{CurveValues, EulerRequest, Producer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = Producer::of(coface_io::read(&b"[[0],[1]]"[..], coface_io::Format::Json)?)?;
    /// let request = EulerRequest::new().smooth(true).values(CurveValues::Given(vec![0.0, 1.0, 2.0]));
    /// assert_eq!(request.answer("points", &points)?.curves, [[0.0, -0.5, 0.0]]);
    /// # Ok(()) }
    /// ```
    pub fn smooth(mut self, is_smooth: bool) -> Self {
        self.is_smooth = is_smooth;
        self
    }

    /// Whether heights are measured from the middle of the box of the vertices, in units of the greatest distance from there: curves of models of other sizes
    /// and places can be compared then.
    ///
    /// # Examples
    /// See [`Self::directions`].
    pub fn normalized(mut self, is_normalized: bool) -> Self {
        self.is_normalized = is_normalized;
        self
    }

    /// Computes the curves of a model with this name.
    ///
    /// # Errors
    /// Those of [`PersistenceRequest::found`] where there are no directions, and of [`EulerTransform`] where there are;
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a model without positions, and for ranges and values that are none;
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) for more than 16,777,216 numbers.
    ///
    /// # Complexity
    /// That of sorting the vertices and of passing through the boundary matrices, for each direction; in parallel.
    ///
    /// # Examples
    /// See [`EulerRequest`].
    pub fn answer(&self, name: &str, producer: &Producer) -> Result<EulerAnswer, Error> {
        if self.directions.is_some() {
            return self.transform(name, producer).map_err(|error| error.in_file(name));
        }
        if self.is_normalized {
            return Err(Error::invalid("heights are normalized along directions only")
                .with_cure("ask for directions too, or for heights as they are"));
        }
        let complex = producer.chain_complex()?;
        let request = PersistenceRequest::new().growth(self.growth.clone());
        let (function, _, filtration) = request.filtration(name, producer, &complex)?;
        self.answer_of_filtration(name, &function, &filtration)
    }

    /// Computes the curve of a filtration, of a model and by a function with these names.
    ///
    /// # Errors
    /// Those about values of [`Self::answer`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_answers::EulerRequest;
    /// use coface_topology::Filtration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let filtration = Filtration::lower_star(&ChainComplex::of_points(2), &[3.0, 5.0])?;
    /// let answer = EulerRequest::new().answer_of_filtration("points", "x", &filtration)?;
    /// assert_eq!((&answer.values[..], answer.characteristic), (&[3.0, 5.0][..], 2));
    /// # Ok(()) }
    /// ```
    pub fn answer_of_filtration(
        &self,
        name: &str,
        function: &str,
        filtration: &Filtration,
    ) -> Result<EulerAnswer, Error> {
        let curve = EulerCurve::of_filtration(filtration);
        self.of_one(name, function.to_owned(), &curve).map_err(|error| error.in_file(name))
    }

    /// Computes the curve of an image with this name, counted voxel by voxel.
    ///
    /// # Errors
    /// Those of [`ImageRequest::found`], and those about values of [`Self::answer`]; directions are for models.
    ///
    /// # Complexity
    /// That of [`ImageFiltration::euler_curve`](coface_topology::ImageFiltration::euler_curve).
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{EulerRequest, GreyImage, ImageRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let row = GreyImage::new(&[3], [0.0, 5.0, 1.0])?;
    /// let answer = EulerRequest::new().answer_of_image("row", &ImageRequest::new(), row)?;
    /// assert_eq!((&answer.values[..], &answer.curves[0][..]), (&[0.0, 1.0, 5.0][..], &[1.0, 2.0, 1.0][..]));
    /// # Ok(()) }
    /// ```
    pub fn answer_of_image(
        &self,
        name: &str,
        request: &ImageRequest,
        image: GreyImage,
    ) -> Result<EulerAnswer, Error> {
        let find = || {
            if self.directions.is_some() || self.is_normalized {
                return Err(Error::invalid(
                    "directions are for models, and the grey values of an image have none",
                )
                .with_cure("ask for the model of some voxels, or for the curve of the values"));
            }
            let GreyImage { axes, filtration, .. } = image;
            let (filtration, _) = request.filtration(&axes, filtration)?;
            let curve = filtration.euler_curve()?;
            self.of_one(name, format!("voxels, {}-construction", request.construction), &curve)
        };
        find().map_err(|error| error.in_file(name))
    }

    /// The directions, as long as a unit.
    fn units(&self, transform: &EulerTransform<'_>, dimension: usize) -> Result<Vec<Vec<f64>>, Error> {
        match &self.directions {
            None => Ok(Vec::new()),
            Some(Directions::Even(count)) => {
                require_values(*count)?;
                if dimension > 3 {
                    return Err(Error::invalid(format!(
                        "no directions are spread evenly in dimension {dimension}"
                    ))
                    .with_cure("give a table with a row for each direction: --directions FILE"));
                }
                even_directions(dimension, *count)
            }
            Some(Directions::Given { place, rows }) if rows.is_empty() => {
                Err(Error::invalid("there are no directions here")
                    .with_cure("write a row of numbers for each direction")
                    .in_file(place))
            }
            Some(Directions::Given { place, rows }) => {
                let unit = |(number, row): (usize, &Vec<f64>)| {
                    transform.unit(row).map_err(|error| {
                        let message = format!("row {}: {}", number + 1, error.message());
                        Error::new(error.kind(), message)
                            .with_cure(error.cure().unwrap_or_default())
                            .in_file(place)
                    })
                };
                rows.iter().enumerate().map(unit).collect()
            }
        }
    }

    /// The answer of one curve.
    fn of_one(&self, name: &str, function: String, curve: &EulerCurve) -> Result<EulerAnswer, Error> {
        let values = match &self.values {
            CurveValues::Ends => {
                let mut values: Vec<f64> = curve.steps().iter().map(|step| step.0).collect();
                values.sort_by(f64::total_cmp);
                values
            }
            values => values_of(values, curve.range())?,
        };
        let numbers = self.numbers(curve, &values);
        Ok(EulerAnswer {
            file: name.to_owned(),
            function,
            star: if curve.is_falling() { "upper" } else { "lower" }.to_owned(),
            characteristic: curve.last(),
            directions: None,
            center: None,
            radius: None,
            smooth: self.is_smooth,
            values,
            curves: vec![numbers],
            remarks: Vec::new(),
        })
    }

    /// The numbers of a curve at values.
    fn numbers(&self, curve: &EulerCurve, values: &[f64]) -> Vec<f64> {
        let low = values.iter().copied().reduce(f64::min);
        let high = values.iter().copied().reduce(f64::max);
        match (low, high) {
            (Some(low), Some(high)) if self.is_smooth => curve.smooth([low, high], values),
            _ => values.iter().map(|&value| curve.at(value) as f64).collect(),
        }
    }

    fn transform(&self, name: &str, producer: &Producer) -> Result<EulerAnswer, Error> {
        if !matches!(self.growth, Growth::Lower(None)) {
            return Err(Error::invalid(
                "along directions cells enter by their heights, not by another function",
            )
            .with_cure("ask for directions or for a function, not for both"));
        }
        let positions = producer.positions();
        let dimension = positions.dimension();
        if dimension == 0 {
            return Err(Error::invalid("vertices have no positions, so that they have no heights")
                .with_cure("give a model with positions, or leave --directions out"));
        }
        producer.require_finite()?;
        let complex = producer.chain_complex()?;
        let vertices =
            (0..complex.cell_count(0)).map(|vertex| producer.cell_vertices(0, CellId::new(vertex))[0]);
        let flat = vertices
            .flat_map(|vertex| positions.point(VertexId::new(vertex as usize)).iter().copied())
            .collect();
        self.answer_of_positions(name, &complex, flat, dimension)
    }

    /// Computes the curves along the directions, of a complex with a row of so many coordinates for each cell of degree 0.
    ///
    /// # Errors
    /// Those of [`EulerTransform`], and those about values of [`Self::answer`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_answers::{Directions, EulerRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let twice = Directions::Given { place: "twice".to_owned(), rows: vec![vec![2.0]] };
    /// let request = EulerRequest::new().directions(Some(twice));
    /// let answer = request.answer_of_positions("points", &ChainComplex::of_points(2), vec![1.0, 4.0], 1)?;
    /// assert_eq!((answer.values[0], answer.values[99], answer.curves[0][99]), (-4.0, 4.0, 2.0));
    /// # Ok(()) }
    /// ```
    pub fn answer_of_positions(
        &self,
        name: &str,
        complex: &ChainComplex,
        mut flat: Vec<f64>,
        dimension: usize,
    ) -> Result<EulerAnswer, Error> {
        let normal =
            (self.is_normalized && dimension > 0).then(|| normalize(&mut flat, dimension)).transpose()?;
        let transform = EulerTransform::new(complex, &flat, dimension)?;
        let directions = self.units(&transform, dimension)?;
        let even = CurveValues::Even { count: SAMPLES, range: None };
        let asked = if self.values == CurveValues::Ends { &even } else { &self.values };
        let whole = if self.is_normalized { [-1.0, 1.0] } else { transform.range() };
        let values = values_of(asked, Some(whole))?;
        require_values(values.len().saturating_mul(directions.len()))?;
        let curves = transform.each(&directions, |curve| self.numbers(curve, &values))?;
        let (center, radius) = normal.unzip();
        Ok(EulerAnswer {
            file: name.to_owned(),
            function: "height along directions".to_owned(),
            star: "lower".to_owned(),
            characteristic: complex.euler_characteristic(),
            directions: Some(directions),
            center,
            radius,
            smooth: self.is_smooth,
            values,
            curves,
            remarks: Vec::new(),
        })
    }
}

/// Moves points so that the middle of their box is the origin, and scales them so that the farthest one has the distance 1. Gives the middle and the distance.
fn normalize(flat: &mut [f64], dimension: usize) -> Result<(Vec<f64>, f64), Error> {
    let middle = |axis: usize| {
        let along = flat.iter().skip(axis).step_by(dimension).copied();
        match (along.clone().reduce(f64::min), along.reduce(f64::max)) {
            (Some(low), Some(high)) => low.midpoint(high),
            _ => 0.0,
        }
    };
    let center: Vec<f64> = (0..dimension).map(middle).collect();
    for point in flat.chunks_exact_mut(dimension) {
        point.iter_mut().zip(&center).for_each(|(x, middle)| *x -= middle);
    }
    let distance = |point: &[f64]| point.iter().map(|x| x * x).sum::<f64>().sqrt();
    let radius = flat.chunks_exact(dimension).map(distance).fold(0.0, f64::max);
    if !radius.is_finite() {
        return Err(
            Error::invalid("the distances of the vertices overflow").with_cure("scale the model down")
        );
    }
    if radius > 0.0 {
        flat.iter_mut().for_each(|x| *x /= radius);
    }
    Ok((center, radius))
}

/// The values that are asked for, with this range unless another one is given.
fn values_of(values: &CurveValues, whole: Option<[f64; 2]>) -> Result<Vec<f64>, Error> {
    match values {
        CurveValues::Ends => Ok(Vec::new()),
        CurveValues::Given(values) => {
            match values.iter().find(|value| !value.is_finite()) {
                Some(value) => Err(Error::invalid(format!("a curve has no number at {value}"))
                    .with_cure("give finite values")),
                None => Ok(values.clone()),
            }
        }
        &CurveValues::Even { count, range } => {
            let Some(range) = range.or(whole) else {
                return Err(Error::invalid("nothing enters, so that there is no range of values")
                    .with_cure("give the range of values (--range A B)"));
            };
            even_values(count, range)
        }
    }
}

impl EulerAnswer {
    /// The numbers as a table: a row for each direction, with a column for each value; of one function, a row for the values and one for the curve.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{EulerRequest, Producer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = Producer::of(coface_io::read(&b"[[0],[1]]"[..], coface_io::Format::Json)?)?;
    /// let table = EulerRequest::new().answer("points", &points)?.table();
    /// assert_eq!((table.row(0), table.row(1)), (&[0.0, 1.0][..], &[1.0, 2.0][..]));
    /// # Ok(()) }
    /// ```
    pub fn table(&self) -> NumberTable {
        match self.directions {
            Some(_) => NumberTable::from_rows(&self.curves),
            None => NumberTable::from_rows(std::iter::once(&self.values).chain(&self.curves)),
        }
    }

    /// The numbers as text: of one function a line for each value; else a line for each direction, which comes first, below a line with the values.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{EulerRequest, Producer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = Producer::of(coface_io::read(&b"[[0],[1]]"[..], coface_io::Format::Json)?)?;
    /// let answer = EulerRequest::new().answer("points", &points)?;
    /// assert_eq!(answer.csv(), "value,euler characteristic\n0,1\n1,2\n");
    /// # Ok(()) }
    /// ```
    pub fn csv(&self) -> String {
        let line = |cells: Vec<String>| cells.join(",") + "\n";
        let texts = |numbers: &[f64]| numbers.iter().map(f64::to_string).collect::<Vec<_>>();
        let Some(directions) = &self.directions else {
            let name = if self.smooth { "smooth euler characteristic" } else { "euler characteristic" };
            let rows = self.values.iter().zip(self.curves.iter().flatten());
            let rows = rows.map(|(value, number)| line(vec![value.to_string(), number.to_string()]));
            return std::iter::once(format!("value,{name}\n")).chain(rows).collect();
        };
        let axes = directions.first().map_or(0, Vec::len);
        let named = (0..axes).map(|axis| {
            ["x", "y", "z"]
                .get(axis)
                .filter(|_| axes <= 3)
                .map_or(format!("x{axis}"), |name| (*name).to_owned())
        });
        let head = line(named.chain(texts(&self.values)).collect());
        let rows = directions.iter().zip(&self.curves);
        let rows = rows.map(|(direction, curve)| line([texts(direction), texts(curve)].concat()));
        std::iter::once(head).chain(rows).collect()
    }
}
