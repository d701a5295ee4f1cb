//! Places on and around the edges of an interface, its phases as sets, its images, and how far two are apart.

use super::places::{bend_place, in_degrees};
use super::{PlanarInterface, PlanarSet};
use crate::answer::{
    EdgeBendAnswer, EdgeSample, InterfacePoint, PhaseComparison, PhasePoints, YinFaultAnswer, YinFaultKind,
    YinInterfaceAnswer, YinInterfaceComparisonAnswer, YinInterfaceCurvatureAnswer, YinInterfaceLocateAnswer,
    YinInterfaceSampleAnswer, YinLocation, YinValidationAnswer,
};
use coface_algebra::{EdgeId, Error, Sign};
use coface_geometry::{AffineMap, Sum};
use coface_yin::{EdgeBend, InterfaceGraph, NearestPoint, Sample, Sampling, SetLocation, YinSet};
use std::collections::BTreeSet;

/// A phase as a set that knows which edges its curves are made of.
struct PhaseBoundary {
    phase: u32,
    set: YinSet,
    /// For each curve the edges that it runs along, with their directions, and the number of its piece at which each begins.
    walks: Vec<Vec<(usize, EdgeId, Sign)>>,
}

impl PhaseBoundary {
    fn of(graph: &InterfaceGraph, phase: u32, set: YinSet) -> Self {
        let walks = graph.phase_walks(phase).into_iter().map(|walk| {
            let mut first = 0;
            let edges = walk.into_iter().map(|own| {
                let found = (first, own.edge, own.sign);
                first += graph.curve(own.edge).piece_count();
                found
            });
            edges.collect()
        });
        Self { phase, walks: walks.collect(), set }
    }

    /// The phases that are asked about points: those whose boxes have them, for each.
    fn indices_near(&self, points: &[[f64; 2]]) -> Vec<usize> {
        let Some([low, high]) = self.set.bounding_box().filter(|_| self.set.is_bounded()) else {
            return if self.set.is_bounded() { Vec::new() } else { (0..points.len()).collect() };
        };
        let is_near =
            |point: &[f64; 2]| (0..2).all(|axis| low[axis] <= point[axis] && point[axis] <= high[axis]);
        (0..points.len()).filter(|&at| is_near(&points[at])).collect()
    }

    /// The edge of a nearest point, its piece and the parameter there.
    fn edge_place(&self, graph: &InterfaceGraph, found: &NearestPoint) -> (u32, usize, f64) {
        let walk = &self.walks[found.curve];
        let at = walk.partition_point(|&(first, ..)| first <= found.piece) - 1;
        let (first, edge, sign) = walk[at];
        let piece = found.piece - first;
        match sign {
            Sign::Plus => (edge.to_u32(), piece, found.parameter),
            Sign::Minus => {
                (edge.to_u32(), graph.curve(edge).piece_count() - 1 - piece, 1.0 - found.parameter)
            }
        }
    }
}

impl PlanarInterface {
    /// Where points lie of the interface: in which phase, on an edge, or in no phase, with the nearest point of the edges.
    ///
    /// # Errors
    /// Those of [`Self::phases`], and of [`YinSet::locate_all`].
    ///
    /// # Complexity
    /// That of [`YinSet::locate_all`] for each phase and the points in its box, and of [`YinSet::nearest_all`] for each phase and the points in
    /// no phase.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{LabelImage, PlanarInterface, answer::YinLocation};
    /// use coface_yin::{InterfaceOptions, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(2, vec![1, 2, 3, 3])?.sets()?;
    /// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
    /// let interface = PlanarInterface::of(sets, &options, Overlaps::Refused)?;
    /// let found = interface.located("labels", &[[0.25, 1.5], [1.0, 1.5], [0.5, -3.0]])?;
    /// assert_eq!((found.points[0].phases.clone(), found.points[0].distance), (vec![0], Some(0.25)));
    /// assert_eq!((found.points[1].phases.clone(), found.points[1].location), (vec![0, 1], YinLocation::Boundary));
    /// assert_eq!((found.points[2].location, found.points[2].nearest), (YinLocation::Outside, Some([0.5, 0.0])));
    /// # Ok(()) }
    /// ```
    pub fn located(&self, file: &str, points: &[[f64; 2]]) -> Result<YinInterfaceLocateAnswer, Error> {
        // Points that are none are refused, whatever phases there are.
        YinSet::empty(self.graph.order()).locate_all(points)?;
        let mut found: Vec<InterfacePoint> = points.iter().map(|&point| place_of(point)).collect();
        let sets = (0u32..).zip(self.phases()?);
        let phases: Vec<PhaseBoundary> =
            sets.map(|(phase, set)| PhaseBoundary::of(&self.graph, phase, set.set)).collect();
        for phase in &phases {
            let near = phase.indices_near(points);
            let own: Vec<[f64; 2]> = near.iter().map(|&at| points[at]).collect();
            for (&at, location) in near.iter().zip(phase.set.locate_all(&own)?) {
                match location {
                    SetLocation::Inside => found[at].location = YinLocation::Inside,
                    SetLocation::Boundary { .. } => found[at].location = YinLocation::Boundary,
                    SetLocation::Outside => continue,
                }
                found[at].phases.push(phase.phase);
            }
        }
        for phase in &phases {
            // The way from a point of a phase to the nearest edge does not leave the phase.
            let is_asked = |point: &InterfacePoint| point.phases.is_empty() || point.phases[0] == phase.phase;
            let asked: Vec<usize> = (0..found.len()).filter(|&at| is_asked(&found[at])).collect();
            let own: Vec<[f64; 2]> = asked.iter().map(|&at| points[at]).collect();
            for (&at, nearest) in asked.iter().zip(phase.set.nearest_all(&own)?) {
                let Some(nearest) = nearest else { continue };
                if found[at].distance.is_none_or(|known| nearest.distance < known) {
                    let (edge, piece, parameter) = phase.edge_place(&self.graph, &nearest);
                    let is_on = found[at].location == YinLocation::Boundary;
                    let place = &mut found[at];
                    place.distance = Some(if is_on { 0.0 } else { nearest.distance });
                    place.nearest = Some(nearest.point);
                    (place.edge, place.piece, place.parameter) = (Some(edge), Some(piece), Some(parameter));
                }
            }
        }
        let count = |location| found.iter().filter(|point| point.location == location).count();
        let mut inside = vec![0usize; self.names.len()];
        for point in found.iter().filter(|point| point.location == YinLocation::Inside) {
            inside[point.phases[0] as usize] += 1;
        }
        Ok(YinInterfaceLocateAnswer {
            file: file.to_owned(),
            phases: self
                .names
                .iter()
                .cloned()
                .zip(inside)
                .map(|(name, own)| PhasePoints::new(name, own))
                .collect(),
            boundary: count(YinLocation::Boundary),
            outside: count(YinLocation::Outside),
            points: found,
            remarks: self.remarks.clone(),
        })
    }

    /// Points along the edges, with lengths, directions and curvatures.
    ///
    /// # Errors
    /// Those of [`InterfaceGraph::samples`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{LabelImage, PlanarInterface};
    /// use coface_yin::{InterfaceOptions, Overlaps, Sampling};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(2, vec![1, 2])?.sets()?;
    /// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
    /// let interface = PlanarInterface::of(sets, &options, Overlaps::Refused)?;
    /// let found = interface.sampled("labels", Sampling::PerCurve(3))?;
    /// assert_eq!(found.samples.len(), 3 * 4, "three edges, each with the point at its end");
    /// # Ok(()) }
    /// ```
    pub fn sampled(&self, file: &str, sampling: Sampling) -> Result<YinInterfaceSampleAnswer, Error> {
        let answer = |sample: Sample| {
            let [left, right] = self.graph.phases_of(EdgeId::new(sample.curve));
            EdgeSample {
                edge: sample.curve as u32,
                left,
                right,
                piece: sample.piece,
                parameter: sample.parameter,
                length: sample.length,
                point: sample.point,
                tangent: sample.tangent,
                curvature: sample.curvature,
            }
        };
        let samples = self.graph.samples(sampling)?.into_iter().map(answer).collect();
        Ok(YinInterfaceSampleAnswer { file: file.to_owned(), samples, remarks: self.remarks.clone() })
    }

    /// How each edge bends: its least and greatest curvature, and where it turns most at a knot between its ends.
    ///
    /// # Errors
    /// Those of [`InterfaceGraph::bends`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{LabelImage, PlanarInterface};
    /// use coface_yin::{InterfaceOptions, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(2, vec![1, 2])?.sets()?;
    /// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
    /// let interface = PlanarInterface::of(sets, &options, Overlaps::Refused)?;
    /// let found = interface.curvature("labels")?;
    /// let turns = found.edges.iter().filter_map(|edge| edge.sharpest.as_ref()).map(|place| place.value.abs());
    /// assert!(turns.eq([90.0, 90.0]));
    /// # Ok(()) }
    /// ```
    pub fn curvature(&self, file: &str) -> Result<YinInterfaceCurvatureAnswer, Error> {
        let bent = |(edge, bend): (usize, EdgeBend)| {
            let [left, right] = self.graph.phases_of(EdgeId::new(edge));
            EdgeBendAnswer {
                edge: edge as u32,
                left,
                right,
                least: bend_place(bend.least),
                greatest: bend_place(bend.greatest),
                sharpest: bend.sharpest.map(in_degrees),
            }
        };
        let edges = self.graph.bends()?.into_iter().enumerate().map(bent).collect();
        Ok(YinInterfaceCurvatureAnswer { file: file.to_owned(), edges, remarks: self.remarks.clone() })
    }

    /// The image of the interface under an affine map of the plane.
    ///
    /// # Errors
    /// Those of [`InterfaceGraph::transformed`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{LabelImage, PlanarInterface};
    /// use coface_geometry::AffineMap;
    /// use coface_yin::{InterfaceOptions, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(2, vec![1, 2])?.sets()?;
    /// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
    /// let interface = PlanarInterface::of(sets, &options, Overlaps::Refused)?;
    /// let image = interface.transformed(&AffineMap::scaling(&[3.0, -1.0])?)?;
    /// assert_eq!(image.graph().phase_area(1)?, 3.0);
    /// # Ok(()) }
    /// ```
    pub fn transformed(&self, map: &AffineMap) -> Result<Self, Error> {
        Ok(Self { graph: self.graph.transformed(map)?, ..self.clone() })
    }

    /// The phase with this name as a set, or the one with this number if none has the name.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if there is no such phase; those of [`Self::phases`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{LabelImage, PlanarInterface};
    /// use coface_yin::{InterfaceOptions, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(2, vec![1, 2])?.sets()?;
    /// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
    /// let interface = PlanarInterface::of(sets, &options, Overlaps::Refused)?;
    /// assert_eq!(interface.phase("2")?.bounding_box(), Some([[1.0, 0.0], [2.0, 1.0]]));
    /// assert_eq!(interface.phase("0")?.bounding_box(), Some([[0.0, 0.0], [1.0, 1.0]]));
    /// # Ok(()) }
    /// ```
    pub fn phase(&self, name: &str) -> Result<PlanarSet, Error> {
        let by_name = self.names.iter().position(|own| own == name);
        let by_number = || name.parse().ok().filter(|&number: &usize| number < self.names.len());
        match by_name.or_else(by_number) {
            Some(phase) => self.phase_set(phase as u32),
            None => {
                let names: Vec<String> =
                    self.names.iter().take(8).map(|name| format!("\"{name}\"")).collect();
                let more = if self.names.len() > 8 { ", .." } else { "" };
                let cure = match self.names.len() {
                    0 => "give an interface that has phases".to_owned(),
                    count => format!("give one of {}{more}, or a number below {count}", names.join(", ")),
                };
                Err(Error::invalid(format!("there is no phase \"{name}\"")).with_cure(cure))
            }
        }
    }

    /// How far the phases are from those of another interface: phases of one name go together, or those of one number if the names are not the
    /// same.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if the names differ and the numbers of phases too; those of
    /// [`PlanarSet::compared_with`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{LabelImage, PlanarInterface};
    /// use coface_yin::{InterfaceOptions, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let interface = |labels| {
    ///     let sets = LabelImage::new(3, labels)?.sets()?;
    ///     PlanarInterface::of(sets.clone(), &InterfaceOptions::new(PlanarInterface::order_for(&sets)), Overlaps::Refused)
    /// };
    /// let found = interface(vec![1, 1, 2])?.compared_with("a", &interface(vec![1, 2, 2])?, "b")?;
    /// assert!(found.area_xor.is_some_and(|area| (area - 2.0).abs() <= found.area_xor_error + 1e-13));
    /// # Ok(()) }
    /// ```
    pub fn compared_with(
        &self,
        file: &str,
        other: &Self,
        other_file: &str,
    ) -> Result<YinInterfaceComparisonAnswer, Error> {
        let numbers = self.namesakes(other)?;
        let [own, others] = [self.phases()?, other.phases()?];
        let (mut area, mut error, mut phases) = (Sum::default(), Sum::default(), Vec::new());
        for [first, second] in numbers {
            let [set, with] = [&own[first as usize], &others[second as usize]];
            let names = [&self.names[first as usize], &other.names[second as usize]];
            let sets = set.compared_with(names[0], with, names[1])?;
            area.add(sets.area_xor.unwrap_or(f64::INFINITY));
            error.add(sets.area_xor_error);
            phases.push(PhaseComparison { numbers: [first, second], sets });
        }
        Ok(YinInterfaceComparisonAnswer {
            files: vec![file.to_owned(), other_file.to_owned()],
            area_xor: Some(area.value()).filter(|area| area.is_finite()),
            area_xor_error: error.value(),
            junctions: [self, other].map(|one| one.graph.junctions().count()),
            phases,
            remarks: self.remarks.iter().chain(&other.remarks).cloned().collect(),
        })
    }

    /// The numbers of phases that go together, in the order of those of this interface.
    fn namesakes(&self, other: &Self) -> Result<Vec<[u32; 2]>, Error> {
        let [own, others] = [self, other].map(|one| one.names.iter().collect::<BTreeSet<_>>());
        let count = self.names.len();
        if own == others && own.len() == count && other.names.len() == count {
            let place = |name| other.names.iter().position(|known| known == name);
            let places = self.names.iter().map(|name| place(name).expect("the names are the same"));
            return Ok((0u32..).zip(places).map(|(first, second)| [first, second as u32]).collect());
        }
        if count != other.names.len() {
            return Err(Error::invalid(format!(
                "the interfaces have {count} and {} phases, with other names",
                other.names.len()
            ))
            .with_cure("give interfaces with the same phases, or compare two phases as sets"));
        }
        Ok((0..count as u32).map(|phase| [phase; 2]).collect())
    }

    /// Whether what a file tells is an interface: what is wrong with it, if it is none.
    ///
    /// # Errors
    /// Those of [`InterfaceGraph::fault`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{LabelImage, PlanarInterface};
    /// use coface_yin::{InterfaceOptions, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(2, vec![1, 2])?.sets()?;
    /// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
    /// let mut answer = PlanarInterface::of(sets, &options, Overlaps::Refused)?.answer(&[], true)?;
    /// assert!(PlanarInterface::validation("labels", &answer)?.valid);
    /// answer.edges[0].ends = [7, 7];
    /// assert!(!PlanarInterface::validation("labels", &answer)?.valid);
    /// # Ok(()) }
    /// ```
    pub fn validation(file: &str, answer: &YinInterfaceAnswer) -> Result<YinValidationAnswer, Error> {
        let fault = match Self::graph_of(answer) {
            Err(error) => Some(YinFaultAnswer {
                kind: YinFaultKind::Other,
                curves: Vec::new(),
                point: None,
                message: error.message().to_owned(),
            }),
            Ok(graph) => graph.fault()?.map(|fault| YinFaultAnswer {
                kind: YinFaultKind::Crossing,
                curves: Vec::new(),
                point: fault.point(),
                message: fault.to_string(),
            }),
        };
        Ok(YinValidationAnswer {
            file: file.to_owned(),
            valid: fault.is_none(),
            faults: fault.into_iter().collect(),
            curves: answer.edges.len(),
            roughest: None,
            remarks: answer.remarks.clone(),
        })
    }
}

/// A point of which nothing is known yet.
fn place_of(point: [f64; 2]) -> InterfacePoint {
    InterfacePoint {
        point,
        location: YinLocation::Outside,
        phases: Vec::new(),
        distance: None,
        nearest: None,
        edge: None,
        piece: None,
        parameter: None,
    }
}
