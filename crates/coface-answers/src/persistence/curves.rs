//! Persistence diagrams as curves and images.

use super::GivenDiagram;
use crate::answer::{DiagramCurve, DiagramCurvesAnswer, DiagramImageAnswer, Remark, RemarkCode};
use crate::text;
use coface_algebra::{Error, ErrorKind};
use coface_io::NumberTable;
use coface_topology::{Barcode, PersistenceSurface, euler_characteristic_curve};

/// A function of the value that a diagram gives.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum DiagramCurveKind {
    /// The numbers of classes that live, a curve for each degree.
    Betti,
    /// The alternating sum of these numbers.
    Euler,
    /// The first so many landscapes of each degree.
    Landscape(usize),
    /// The mean of tents, weighted by this power of the persistence, a curve for each degree.
    Silhouette(f64),
}

impl DiagramCurveKind {
    /// The word for it: `betti`, `euler`, `landscape` or `silhouette`.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::DiagramCurveKind::Landscape(5).name(), "landscape");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Self::Betti => "betti",
            Self::Euler => "euler",
            Self::Landscape(_) => "landscape",
            Self::Silhouette(_) => "silhouette",
        }
    }
}

/// At which values curves are given.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CurveValues {
    /// At all births and deaths: where Betti curves change.
    Ends,
    /// At so many values evenly from the first one to the last one; without a range from the least to the greatest of all births and deaths.
    Even {
        /// How many.
        count: usize,
        /// The first and the last.
        range: Option<[f64; 2]>,
    },
    /// At these.
    Given(Vec<f64>),
}

/// More values than this are an oversight.
const MOST_VALUES: usize = 1 << 24;

/// Asks for curves of a diagram.
///
/// # Examples
/// ```
/// use coface_answers::{CurveValues, DiagramCurveKind, DiagramCurvesRequest, GivenDiagram};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let diagram = GivenDiagram::read("a.csv", b"birth,death\n0,inf\n1,3\n")?;
/// let answer = DiagramCurvesRequest::new(DiagramCurveKind::Betti).answer(&diagram)?;
/// assert_eq!(answer.values, [0.0, 1.0, 3.0]);
/// assert_eq!(answer.curves[0].numbers, [1.0, 2.0, 1.0]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct DiagramCurvesRequest {
    kind: DiagramCurveKind,
    degree: Option<usize>,
    values: CurveValues,
    end: Option<f64>,
}

impl DiagramCurvesRequest {
    /// Asks for curves of all degrees: those that are steps at all births and deaths, others at 100 values.
    ///
    /// # Examples
    /// See [`DiagramCurvesRequest`].
    pub fn new(kind: DiagramCurveKind) -> Self {
        let values = match kind {
            DiagramCurveKind::Betti | DiagramCurveKind::Euler => CurveValues::Ends,
            _ => CurveValues::Even { count: 100, range: None },
        };
        Self { kind, degree: None, values, end: None }
    }

    /// One degree alone; an Euler characteristic has all.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DiagramCurveKind, DiagramCurvesRequest, GivenDiagram};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let diagram = GivenDiagram::read("a.pers", b"0 0 5\n1 1 3\n")?;
    /// let answer = DiagramCurvesRequest::new(DiagramCurveKind::Betti).degree(Some(1)).answer(&diagram)?;
    /// assert_eq!((&answer.curves[0].name[..], &answer.values[..]), ("degree 1", &[1.0, 3.0][..]));
    /// # Ok(()) }
    /// ```
    pub fn degree(mut self, degree: Option<usize>) -> Self {
        self.degree = degree;
        self
    }

    /// At which values.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{CurveValues, DiagramCurveKind, DiagramCurvesRequest, GivenDiagram};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let diagram = GivenDiagram::read("a.csv", b"0 4\n")?;
    /// let values = CurveValues::Even { count: 5, range: None };
    /// let answer = DiagramCurvesRequest::new(DiagramCurveKind::Landscape(1)).values(values).answer(&diagram)?;
    /// assert_eq!(answer.curves[0].numbers, [0.0, 1.0, 2.0, 1.0, 0.0]);
    /// # Ok(()) }
    /// ```
    pub fn values(mut self, values: CurveValues) -> Self {
        self.values = values;
        self
    }

    /// Lets classes that never die, die at this value.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DiagramCurveKind, DiagramCurvesRequest, GivenDiagram};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let diagram = GivenDiagram::read("a.csv", b"0 inf\n")?;
    /// let answer = DiagramCurvesRequest::new(DiagramCurveKind::Betti).end(Some(2.0)).answer(&diagram)?;
    /// assert_eq!(answer.curves[0].numbers, [1.0, 0.0]);
    /// # Ok(()) }
    /// ```
    pub fn end(mut self, end: Option<f64>) -> Self {
        self.end = end;
        self
    }

    /// Computes the curves.
    ///
    /// # Errors
    /// Those of [`Barcode::ended_at`]; [`ErrorKind::InvalidInput`] for numbers of classes of extended persistence, where no range is given and the diagram has none, for one that is not finite, and
    /// for values that are NaN; [`ErrorKind::TooLarge`] for more than 16,777,216 values.
    ///
    /// # Examples
    /// See [`DiagramCurvesRequest`].
    pub fn answer(&self, diagram: &GivenDiagram) -> Result<DiagramCurvesAnswer, Error> {
        let mut remarks = diagram.remarks().to_vec();
        let all = ended(diagram.barcodes(), self.end)?;
        // Where classes are counted, it matters which of their ends belong to their lives.
        let counted = match self.kind {
            DiagramCurveKind::Betti | DiagramCurveKind::Euler => {
                ended(&diagram.half_open_barcodes()?, self.end)?
            }
            _ => Vec::new(),
        };
        let chosen: Vec<usize> = match (self.kind, self.degree) {
            (DiagramCurveKind::Euler, _) | (_, None) => (0..all.len()).collect(),
            (_, Some(degree)) => vec![degree],
        };
        let none = Barcode::default();
        let barcode = |degree: usize| all.get(degree).unwrap_or(&none);
        let mut values = self.at(chosen.iter().map(|&degree| barcode(degree)))?;
        if self.values == CurveValues::Ends && !counted.is_empty() && diagram.has_open_or_closed_ends() {
            // Between two ends there may be more classes, or fewer, than at both.
            let middles = values.windows(2).map(|two| two[0].midpoint(two[1])).collect::<Vec<f64>>();
            values.extend(middles);
            values.sort_by(f64::total_cmp);
            values.dedup();
        }
        let mut curves = Vec::new();
        let mut push = |name: String, numbers: Vec<f64>| curves.push(DiagramCurve { name, numbers });
        match self.kind {
            DiagramCurveKind::Euler => {
                if diagram.is_of_points() {
                    remarks.push(Remark::new(RemarkCode::InputReading, OF_POINTS));
                }
                let numbers = euler_characteristic_curve(&counted, &values).into_iter().map(|x| x as f64);
                push("euler characteristic".to_owned(), numbers.collect());
            }
            DiagramCurveKind::Betti => {
                for &degree in &chosen {
                    let barcode = counted.get(degree).unwrap_or(&none);
                    let numbers = barcode.betti_curve(&values).into_iter().map(|x| x as f64);
                    push(format!("degree {degree}"), numbers.collect());
                }
            }
            DiagramCurveKind::Landscape(count) => {
                require_values(count.saturating_mul(values.len()))?;
                for &degree in &chosen {
                    for (place, numbers) in barcode(degree).landscapes(count, &values).into_iter().enumerate()
                    {
                        push(format!("landscape {} of degree {degree}", place + 1), numbers);
                    }
                }
            }
            DiagramCurveKind::Silhouette(power) => {
                let essential = chosen.iter().map(|&degree| barcode(degree).essential_count()).sum();
                remarks.extend(left_out(essential));
                for &degree in &chosen {
                    push(format!("degree {degree}"), barcode(degree).silhouette(power, &values));
                }
            }
        }
        Ok(DiagramCurvesAnswer {
            file: diagram.name().to_owned(),
            kind: self.kind.name().to_owned(),
            values,
            curves,
            remarks,
        })
    }

    /// The values at which curves are given.
    fn at<'a>(&self, barcodes: impl Iterator<Item = &'a Barcode> + Clone) -> Result<Vec<f64>, Error> {
        match &self.values {
            CurveValues::Ends => {
                let ends = barcodes.flat_map(Barcode::intervals).flatten();
                let mut values: Vec<f64> = ends.copied().filter(|end| end.is_finite()).collect();
                values.sort_by(f64::total_cmp);
                values.dedup();
                Ok(values)
            }
            CurveValues::Given(values) => match values.iter().find(|value| !value.is_finite()) {
                Some(value) => Err(Error::invalid(format!("a curve has no number at {value}"))
                    .with_cure("give finite values")),
                None => Ok(values.clone()),
            },
            &CurveValues::Even { count, range } => {
                let ranges = barcodes.filter_map(Barcode::finite_range);
                let whole = ranges.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
                let Some([low, high]) = range.or(whole) else {
                    return Err(
                        Error::invalid("the diagram has no finite birth or death").with_cure(GIVE_RANGE)
                    );
                };
                even_values(count, [low, high])
            }
        }
    }
}

const GIVE_RANGE: &str = "give the range of values (--range A B)";
const OF_POINTS: &str = "the diagram is of points and has only the degrees that were asked for: the curve is not the Euler characteristic of all simplices";

/// So many values evenly from the first one to the last one.
pub(super) fn even_values(count: usize, [low, high]: [f64; 2]) -> Result<Vec<f64>, Error> {
    require_values(count)?;
    if !(low <= high && (high - low).is_finite()) {
        return Err(Error::invalid(format!("{low} to {high} is no range of values"))
            .with_cure("give two finite numbers, the lesser one first"));
    }
    let last = count.saturating_sub(1).max(1) as f64;
    let value = |place: usize| {
        if place as f64 == last { high } else { low + (high - low) * (place as f64 / last) }
    };
    Ok((0..count).map(value).collect())
}

pub(super) fn require_values(count: usize) -> Result<(), Error> {
    if count <= MOST_VALUES {
        return Ok(());
    }
    Err(Error::new(
        ErrorKind::TooLarge,
        format!("{} are more than {MOST_VALUES}", text::count(count, "value")),
    )
    .with_cure("give a lower number"))
}

/// The barcodes, whose classes that never die end at this value if there is one.
fn ended(barcodes: &[Barcode], end: Option<f64>) -> Result<Vec<Barcode>, Error> {
    let one = |barcode: &Barcode| end.map_or_else(|| Ok(barcode.clone()), |end| barcode.ended_at(end));
    barcodes.iter().map(one).collect()
}

/// That classes which never die are left out.
fn left_out(essential: usize) -> Option<Remark> {
    let which = match essential {
        1 => "1 class that never dies".to_owned(),
        _ => format!("{} that never die", text::count(essential, "class")),
    };
    let message = format!("{which} left out; --end T takes T for the death");
    (essential > 0).then(|| Remark::new(RemarkCode::InputReading, message).at(essential, []))
}

/// Asks for the persistence image of a degree.
///
/// # Examples
/// ```
/// use coface_answers::{DiagramImageRequest, GivenDiagram};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let diagram = GivenDiagram::read("a.csv", b"1 3\n0 1\n")?;
/// let answer = DiagramImageRequest::new(0).resolution([4, 3]).answer(&diagram)?;
/// assert_eq!((answer.rows.len(), answer.rows[0].len()), (3, 4));
/// assert_eq!((answer.births, answer.persistences), ([0.0, 1.0], [0.0, 2.0]));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct DiagramImageRequest {
    degree: usize,
    resolution: [usize; 2],
    births: Option<[f64; 2]>,
    persistences: Option<[f64; 2]>,
    bandwidth: Option<f64>,
    power: f64,
    end: Option<f64>,
}

impl DiagramImageRequest {
    /// Asks for an image of 20 times 20 pixels that has all classes of a degree, weighted by their persistence.
    ///
    /// # Examples
    /// See [`DiagramImageRequest`].
    pub fn new(degree: usize) -> Self {
        Self {
            degree,
            resolution: [20, 20],
            births: None,
            persistences: None,
            bandwidth: None,
            power: 1.0,
            end: None,
        }
    }

    /// The numbers of pixels in the direction of births and of persistences.
    ///
    /// # Examples
    /// See [`DiagramImageRequest`].
    pub fn resolution(mut self, resolution: [usize; 2]) -> Self {
        self.resolution = resolution;
        self
    }

    /// The first and the last birth; `None` takes those of the classes.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DiagramImageRequest, GivenDiagram};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let diagram = GivenDiagram::read("a.csv", b"1 3\n0 1\n")?;
    /// let request = DiagramImageRequest::new(0).births(Some([-1.0, 1.0])).persistences(Some([0.0, 3.0]));
    /// assert_eq!(request.answer(&diagram)?.persistences, [0.0, 3.0]);
    /// # Ok(()) }
    /// ```
    pub fn births(mut self, births: Option<[f64; 2]>) -> Self {
        self.births = births;
        self
    }

    /// The first and the last persistence; `None` goes from 0 to the greatest of the classes.
    ///
    /// # Examples
    /// See [`Self::births`].
    pub fn persistences(mut self, persistences: Option<[f64; 2]>) -> Self {
        self.persistences = persistences;
        self
    }

    /// The standard deviation of the normal distribution around a class; `None` is the longer side of a pixel.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DiagramImageRequest, GivenDiagram};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let diagram = GivenDiagram::read("a.csv", b"1 3\n0 1\n")?;
    /// assert_eq!(DiagramImageRequest::new(0).answer(&diagram)?.bandwidth, 0.1);
    /// assert_eq!(DiagramImageRequest::new(0).bandwidth(Some(0.5)).answer(&diagram)?.bandwidth, 0.5);
    /// # Ok(()) }
    /// ```
    pub fn bandwidth(mut self, bandwidth: Option<f64>) -> Self {
        self.bandwidth = bandwidth;
        self
    }

    /// The power of the persistence that is the weight of a class.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DiagramImageRequest, GivenDiagram};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let diagram = GivenDiagram::read("a.csv", b"1 3\n0 1\n")?;
    /// assert_eq!(DiagramImageRequest::new(0).power(2.0).answer(&diagram)?.power, 2.0);
    /// # Ok(()) }
    /// ```
    pub fn power(mut self, power: f64) -> Self {
        self.power = power;
        self
    }

    /// Lets classes that never die, die at this value.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DiagramImageRequest, GivenDiagram};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let diagram = GivenDiagram::read("a.csv", b"1 inf\n0 1\n")?;
    /// assert_eq!(DiagramImageRequest::new(0).end(Some(5.0)).answer(&diagram)?.persistences, [0.0, 4.0]);
    /// # Ok(()) }
    /// ```
    pub fn end(mut self, end: Option<f64>) -> Self {
        self.end = end;
        self
    }

    /// Computes the image.
    ///
    /// # Errors
    /// Those of [`Barcode::ended_at`] and [`PersistenceSurface::new`]; [`ErrorKind::InvalidInput`] where a range is not given and the diagram has none.
    ///
    /// # Examples
    /// See [`DiagramImageRequest`].
    pub fn answer(&self, diagram: &GivenDiagram) -> Result<DiagramImageAnswer, Error> {
        let barcode = ended(diagram.barcodes(), self.end)?.into_iter().nth(self.degree).unwrap_or_default();
        let finite = || barcode.intervals().iter().filter(|ends| ends.iter().all(|end| end.is_finite()));
        let longest = finite().map(|[birth, death]| (death - birth).abs()).fold(0.0, f64::max);
        let persistences = self.persistences.or((longest > 0.0).then_some([0.0, longest]));
        let persistences = persistences.ok_or_else(|| {
            Error::invalid(format!(
                "the diagram has no class of degree {} that is born and dies",
                self.degree
            ))
            .with_cure("give the ranges of births and of persistences (--births A B --persistences A B)")
        })?;
        let [least, greatest] = self.births.unwrap_or_else(|| {
            let births = finite().map(|interval| interval[0]);
            births.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], birth| [a.min(birth), b.max(birth)])
        });
        // All classes may be born at once, as the components of points are.
        let half = if least == greatest { (persistences[1] - persistences[0]) / 2.0 } else { 0.0 };
        let births = [least - half, greatest + half];
        let side = |[low, high]: [f64; 2], count: usize| (high - low) / count.max(1) as f64;
        let sides = [side(births, self.resolution[0]), side(persistences, self.resolution[1])];
        let bandwidth = self.bandwidth.unwrap_or(sides[0].max(sides[1]));
        let surface = PersistenceSurface::new(births, persistences, self.resolution, bandwidth)?;
        let pixels = surface.power(self.power).image(&barcode);
        let mut remarks = diagram.remarks().to_vec();
        remarks.extend(left_out(barcode.essential_count()));
        Ok(DiagramImageAnswer {
            file: diagram.name().to_owned(),
            degree: self.degree,
            births,
            persistences,
            bandwidth,
            power: self.power,
            rows: pixels.chunks(self.resolution[0]).map(<[f64]>::to_vec).collect(),
            remarks,
        })
    }
}

impl DiagramCurvesAnswer {
    /// The values and the curves as a table: a row for the values, then one for each curve.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DiagramCurveKind, DiagramCurvesRequest, GivenDiagram};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let diagram = GivenDiagram::read("a.csv", b"0 2\n")?;
    /// let table = DiagramCurvesRequest::new(DiagramCurveKind::Betti).answer(&diagram)?.table();
    /// assert_eq!((table.row(0), table.row(1)), (&[0.0, 2.0][..], &[1.0, 0.0][..]));
    /// # Ok(()) }
    /// ```
    pub fn table(&self) -> NumberTable {
        let curves = self.curves.iter().map(|curve| &curve.numbers);
        NumberTable::from_rows(std::iter::once(&self.values).chain(curves))
    }

    /// The same as text: a line for each value, with the numbers of the curves; the first line names them.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DiagramCurveKind, DiagramCurvesRequest, GivenDiagram};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let diagram = GivenDiagram::read("a.csv", b"0 2\n")?;
    /// let answer = DiagramCurvesRequest::new(DiagramCurveKind::Betti).answer(&diagram)?;
    /// assert_eq!(answer.csv(), "value,degree 0\n0,1\n2,0\n");
    /// # Ok(()) }
    /// ```
    pub fn csv(&self) -> String {
        let mut text = "value".to_owned();
        for curve in &self.curves {
            text.extend([",", &curve.name]);
        }
        text.push('\n');
        for (place, value) in self.values.iter().enumerate() {
            text.push_str(&value.to_string());
            for curve in &self.curves {
                text.push(',');
                text.push_str(&curve.numbers[place].to_string());
            }
            text.push('\n');
        }
        text
    }
}
