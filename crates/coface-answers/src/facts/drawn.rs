//! Whether the polygons of a drawing are valid.

use super::{GeometryCheck, Report};
use crate::answer::{Place, Remark, RemarkCode};
use coface_algebra::{Error, RaggedArray, VertexId};
use coface_arrange::planar::{PolygonFault, PolygonFaultKind, polygon_faults};
use coface_geometry::Positions;
use coface_io::{Features, GroupKind, Model, ReferenceSystem, Shape, shapes};
use rayon::prelude::*;

/// What is wrong with the polygons of a drawing: those of one geometry together.
///
/// # Examples
/// ```
/// use coface_answers::Report;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let bow_tie = coface_io::read(&b"POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
/// let report = Report::of(bow_tie)?;
/// let found = report.drawn_polygons().expect("there is a polygon");
/// assert_eq!((found.faults()[0].kind.name(), found.faults()[0].places[0].point), ("ring_crosses_itself", [1.0, 1.0]));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnPolygons {
    polygon_count: usize,
    faults: Vec<DrawnFault>,
    reversed_rings: usize,
}

impl Report {
    /// The reference system that a map names.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let point = coface_io::read(&b"SRID=25832;POINT (1 2)"[..], coface_io::Format::Wkt)?;
    /// let report = coface_answers::Report::of(point)?;
    /// assert_eq!(report.reference_system().and_then(|system| system.srid()), Some(25832));
    /// # Ok(()) }
    /// ```
    pub fn reference_system(&self) -> Option<&ReferenceSystem> {
        self.reference.as_ref()
    }
}

/// One kind of fault with its places.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DrawnFault {
    /// What is wrong.
    pub kind: PolygonFaultKind,
    /// All places, from the first geometry to the last.
    pub places: Vec<DrawnPlace>,
}

/// Where a polygon of a drawing is not valid.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DrawnPlace {
    /// A point of the place, rounded.
    pub point: [f64; 2],
    /// The rings that have the fault, one or two: the polygon among all of the drawing, and the ring of it, 0 for the outer one.
    pub rings: Vec<(usize, usize)>,
}

impl DrawnFault {
    /// What is wrong, in how many places, and how OGC's Simple feature access calls it.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::Report;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let bow_tie = coface_io::read(&b"POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let report = Report::of(bow_tie)?;
    /// let sentence = report.drawn_polygons().map(|found| found.faults()[0].sentence());
    /// assert_eq!(sentence.as_deref(), Some("polygon 0 crosses itself at (1, 1) (OGC: Self-intersection)"));
    /// # Ok(()) }
    /// ```
    pub fn sentence(&self) -> String {
        use PolygonFaultKind as Kind;
        let Some(first) = self.places.first() else { return String::new() };
        let name = |&(polygon, ring): &(usize, usize)| match ring {
            0 => format!("polygon {polygon}"),
            hole => format!("hole {hole} of polygon {polygon}"),
        };
        let one = first.rings.first().map_or_else(String::new, name);
        let two = first.rings.get(1).map_or_else(String::new, name);
        let subject = match self.kind {
            Kind::TooFewPoints => format!("{one} has fewer than three different points"),
            Kind::RingCrossesItself => format!("{one} crosses itself"),
            Kind::Spike => format!("{one} runs back along itself"),
            Kind::RingTouchesItself => format!("{one} comes to a point twice"),
            Kind::RingsCross | Kind::PolygonsCross => format!("{one} and {two} cross"),
            Kind::RingsOverlap | Kind::PolygonsOverlap => format!("{one} and {two} share a part of a side"),
            Kind::DuplicateRing => format!("{one} and {two} have the same boundary"),
            Kind::HoleOutside => format!("{one} is outside of its outer ring"),
            Kind::HolesNested | Kind::PolygonsNested => format!("{one} is inside of {two}"),
            Kind::InteriorDisconnected => format!("{one} is cut into pieces by rings that touch"),
            _ => format!("{one} is not valid"),
        };
        let [x, y] = first.point;
        let others = match self.places.len() {
            1 => String::new(),
            2 => "; 1 more place".to_owned(),
            count => format!("; {} more places", count - 1),
        };
        format!("{subject} at ({x}, {y}){others} (OGC: {})", self.kind.reason())
    }
}

impl DrawnPolygons {
    /// More corners are checked only where that is asked for.
    const USUAL_CORNERS: usize = 1_000_000;

    /// Those of a model; `None` for one without polygons with rings, that states what is inside of crossed
    /// rings as SVG does, or with more corners than are usually checked.
    pub(crate) fn of(model: &Model, check: GeometryCheck) -> Result<Option<Self>, Error> {
        let corner_count = model.lines().item_count();
        let is_wanted = match check {
            GeometryCheck::Usual => corner_count <= Self::USUAL_CORNERS,
            GeometryCheck::Always => true,
            GeometryCheck::Never => false,
        };
        let dimension = model.positions().dimension();
        // Rings of a drawing that says what is inside of them may cross.
        let has_rule = model.data_named("fill_rule", GroupKind::Lines).is_some();
        if !is_wanted || has_rule || !(2..=3).contains(&dimension) || model.require_finite().is_err() {
            return Ok(None);
        }
        let features = Features::new(model);
        let shapes = shapes(model);
        let polygons: Vec<_> = (shapes.iter())
            .filter_map(|(shape, name)| match shape {
                Shape::Rings(lines) => Some((lines.clone(), features.of(shape), *name)),
                _ => None,
            })
            .collect();
        if polygons.is_empty() {
            return Ok(None);
        }
        // Polygons of one geometry follow each other.
        let mut first = 0;
        let mut geometries = Vec::new();
        for own in polygons.chunk_by(|a, b| a.1.is_some() && a.1 == b.1 && a.2 == b.2) {
            geometries.push((first, own));
            first += own.len();
        }
        let found: Vec<Result<(Vec<DrawnPlaceOf>, usize), Error>> = geometries
            .par_iter()
            .map(|&(first, own)| {
                let lines: Vec<_> = own.iter().map(|(lines, ..)| lines.clone()).collect();
                faults_of(model, first, &lines)
            })
            .collect();
        let (mut places, mut reversed_rings) = (Vec::new(), 0);
        for found in found {
            let (own, reversed) = found?;
            places.extend(own);
            reversed_rings += reversed;
        }
        let fault = |kind: PolygonFaultKind| {
            let own = places.iter().filter(|(other, _)| *other == kind).map(|(_, place)| place.clone());
            DrawnFault { kind, places: own.collect() }
        };
        let faults = PolygonFaultKind::ALL.map(fault).into_iter().filter(|fault| !fault.places.is_empty());
        Ok(Some(Self { polygon_count: polygons.len(), faults: faults.collect(), reversed_rings }))
    }

    /// What is wrong; nothing if all geometries are valid.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::Report;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = coface_io::read(&b"POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"[..], coface_io::Format::Wkt)?;
    /// assert!(Report::of(square)?.drawn_polygons().is_some_and(|found| found.faults().is_empty()));
    /// # Ok(()) }
    /// ```
    pub fn faults(&self) -> &[DrawnFault] {
        &self.faults
    }

    /// The number of polygons.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::Report;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = coface_io::read(&b"POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"[..], coface_io::Format::Wkt)?;
    /// assert_eq!(Report::of(square)?.drawn_polygons().map(|found| found.polygon_count()), Some(1));
    /// # Ok(()) }
    /// ```
    pub fn polygon_count(&self) -> usize {
        self.polygon_count
    }

    /// The outer rings that run clockwise and the holes that run counterclockwise: RFC 7946 has them the other way. That is no fault.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::Report;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = coface_io::read(&b"POLYGON ((0 0, 0 1, 1 1, 1 0, 0 0))"[..], coface_io::Format::Wkt)?;
    /// assert_eq!(Report::of(square)?.drawn_polygons().map(|found| found.reversed_rings()), Some(1));
    /// # Ok(()) }
    /// ```
    pub fn reversed_rings(&self) -> usize {
        self.reversed_rings
    }

    /// A remark for each kind of fault.
    pub(crate) fn remarks(&self) -> impl Iterator<Item = Remark> {
        self.faults.iter().map(|fault| {
            let places = fault.places.iter().map(|place| Place::point(&place.point));
            Remark::new(RemarkCode::InvalidPolygon, fault.sentence()).at(fault.places.len(), places)
        })
    }
}

type DrawnPlaceOf = (PolygonFaultKind, DrawnPlace);

/// The faults of the polygons of one geometry, of which the first has this number, and how many rings run against RFC 7946.
fn faults_of(
    model: &Model,
    first: usize,
    polygons: &[std::ops::Range<usize>],
) -> Result<(Vec<DrawnPlaceOf>, usize), Error> {
    let (mut flat, mut rings, mut lists) = (Vec::new(), RaggedArray::new(), RaggedArray::new());
    let (mut names, mut reversed) = (Vec::new(), 0);
    for (polygon, lines) in polygons.iter().enumerate() {
        for (ring, line) in lines.clone().enumerate() {
            let line = model.lines().list(line);
            let start = flat.len() as u32 / 2;
            let corners = &line[..line.len().saturating_sub(1)];
            for &corner in corners {
                flat.extend_from_slice(&model.positions().point(VertexId::from_u32(corner))[..2]);
            }
            let own = &flat[2 * start as usize..];
            reversed +=
                usize::from(if ring == 0 { doubled_area(own) < 0.0 } else { doubled_area(own) > 0.0 });
            rings.push(&(start..start + corners.len() as u32).collect::<Vec<u32>>());
            names.push((first + polygon, ring));
        }
        let end = rings.len() as u32;
        lists.push(&(end - lines.len() as u32..end).collect::<Vec<u32>>());
    }
    let place = |fault: PolygonFault| {
        let rings = fault.rings.iter().map(|&ring| names[ring as usize]).collect();
        (fault.kind, DrawnPlace { point: fault.point, rings })
    };
    let faults = polygon_faults(&Positions::from_flat(2, flat)?, &rings, &lists)?;
    Ok((faults.into_iter().map(place).collect(), reversed))
}

/// Twice the area that a ring winds around, by its corners from the first.
fn doubled_area(flat: &[f64]) -> f64 {
    let points = flat.as_chunks::<2>().0;
    let Some(&[x, y]) = points.first() else { return 0.0 };
    let sides = points.iter().zip(points.iter().cycle().skip(1));
    sides.map(|(a, b)| (a[0] - x) * (b[1] - y) - (a[1] - y) * (b[0] - x)).sum()
}
