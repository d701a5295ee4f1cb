//! Distances of persistence diagrams.

use super::GivenDiagram;
use crate::answer::{DegreeDistance, DiagramDistanceAnswer};
use coface_algebra::Error;
use coface_topology::{Barcode, BarcodeMatching};

/// A distance of persistence diagrams.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum DiagramMetric {
    /// The length of the longest pair of a matching in which it is shortest.
    Bottleneck,
    /// The root of the sum of powers of the lengths of pairs.
    Wasserstein {
        /// The power.
        order: f64,
        /// The exponent of the norm that measures a pair.
        internal_p: f64,
    },
}

/// Asks how far two diagrams are from each other. Classes are matched with classes of their degree.
///
/// # Examples
/// ```
/// use coface_answers::{DiagramDistanceRequest, DiagramMetric, GivenDiagram};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let a = GivenDiagram::read("a.csv", b"0 6\n5 6\n")?;
/// let b = GivenDiagram::read("b.csv", b"3 10\n")?;
/// let bottleneck = DiagramDistanceRequest::new().answer(&a, &b)?;
/// assert_eq!(bottleneck.distance, Some(3.5));
/// let metric = DiagramMetric::Wasserstein { order: 1.0, internal_p: f64::INFINITY };
/// assert_eq!(DiagramDistanceRequest::new().metric(metric).answer(&a, &b)?.distance, Some(4.5));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct DiagramDistanceRequest {
    metric: DiagramMetric,
    degree: Option<usize>,
    matching: bool,
}

impl Default for DiagramDistanceRequest {
    fn default() -> Self {
        Self { metric: DiagramMetric::Bottleneck, degree: None, matching: false }
    }
}

impl DiagramDistanceRequest {
    /// Asks for the bottleneck distance of all degrees.
    ///
    /// # Examples
    /// See [`DiagramDistanceRequest`].
    pub fn new() -> Self {
        Self::default()
    }

    /// Which distance.
    ///
    /// # Examples
    /// See [`DiagramDistanceRequest`].
    pub fn metric(mut self, metric: DiagramMetric) -> Self {
        self.metric = metric;
        self
    }

    /// The classes of this degree alone; `None` takes all.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DiagramDistanceRequest, GivenDiagram};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let a = GivenDiagram::read("a.pers", b"0 0 1\n1 2 6\n")?;
    /// let none = GivenDiagram::new("none", Vec::new());
    /// assert_eq!(DiagramDistanceRequest::new().degree(Some(0)).answer(&a, &none)?.distance, Some(0.5));
    /// assert_eq!(DiagramDistanceRequest::new().answer(&a, &none)?.distance, Some(2.0));
    /// # Ok(()) }
    /// ```
    pub fn degree(mut self, degree: Option<usize>) -> Self {
        self.degree = degree;
        self
    }

    /// Whether the answer has the matching.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DiagramDistanceRequest, GivenDiagram};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (a, b) = (GivenDiagram::read("a", b"0 5\n0 inf\n")?, GivenDiagram::read("b", b"0 inf\n")?);
    /// let answer = DiagramDistanceRequest::new().matching(true).answer(&a, &b)?;
    /// assert_eq!(answer.degrees[0].matching, Some(vec![[Some(0), None], [Some(1), Some(0)]]));
    /// # Ok(()) }
    /// ```
    pub fn matching(mut self, matching: bool) -> Self {
        self.matching = matching;
        self
    }

    /// Measures two diagrams.
    ///
    /// # Errors
    /// Those of [`Barcode::wasserstein_matching`].
    ///
    /// # Complexity
    /// See [`Barcode::bottleneck_matching`] and [`Barcode::wasserstein_matching`].
    ///
    /// # Examples
    /// See [`DiagramDistanceRequest`].
    pub fn answer(
        &self,
        first: &GivenDiagram,
        second: &GivenDiagram,
    ) -> Result<DiagramDistanceAnswer, Error> {
        let degrees = match self.degree {
            Some(degree) => degree..degree + 1,
            None => 0..first.degree_count().max(second.degree_count()),
        };
        let of_degree = |degree: usize| {
            let matching = self.matched(&first.barcode(degree), &second.barcode(degree))?;
            let place = |diagram: &GivenDiagram, class: Option<usize>| {
                class.map(|class| diagram.place(degree, class))
            };
            let pair = |&(a, b): &(Option<usize>, Option<usize>)| [place(first, a), place(second, b)];
            let finite = |number: f64| number.is_finite().then_some(number);
            Ok(DegreeDistance {
                degree,
                distance: finite(matching.distance()),
                lower_bound: finite(matching.lower_bound()),
                essential: [first, second].map(|diagram| diagram.barcode(degree).essential_count()),
                matching: self.matching.then(|| matching.pairs().iter().map(pair).collect()),
            })
        };
        let degrees = degrees.map(of_degree).collect::<Result<Vec<_>, Error>>()?;
        let (metric, order, internal_p) = match self.metric {
            DiagramMetric::Bottleneck => ("bottleneck", None, None),
            DiagramMetric::Wasserstein { order, internal_p } => {
                ("wasserstein", Some(order), Some(internal_p))
            }
        };
        Ok(DiagramDistanceAnswer {
            files: [first, second].map(|diagram| diagram.name().to_owned()),
            metric: metric.to_owned(),
            order,
            internal_p: internal_p.filter(|p| p.is_finite()),
            distance: self.together(degrees.iter().map(|degree| degree.distance)),
            degrees,
            remarks: [first, second].iter().flat_map(|diagram| diagram.remarks()).cloned().collect(),
        })
    }

    fn matched(&self, first: &Barcode, second: &Barcode) -> Result<BarcodeMatching, Error> {
        match self.metric {
            DiagramMetric::Bottleneck => Ok(first.bottleneck_matching(second)),
            DiagramMetric::Wasserstein { order, internal_p } => {
                first.wasserstein_matching(second, order, internal_p)
            }
        }
    }

    /// The distance of all degrees together.
    fn together(&self, distances: impl Iterator<Item = Option<f64>>) -> Option<f64> {
        let distances = distances.collect::<Option<Vec<f64>>>()?;
        let greatest = distances.iter().copied().fold(0.0, f64::max);
        match self.metric {
            // The root of one power is the number itself but for rounding.
            DiagramMetric::Wasserstein { order, .. } if greatest > 0.0 && distances.len() > 1 => {
                let sum: f64 = distances.iter().map(|distance| (distance / greatest).powf(order)).sum();
                Some(greatest * sum.powf(1.0 / order))
            }
            _ => Some(greatest),
        }
    }
}
