//! Sets as phases of one interface.

use super::{PlanarSet, SetRequest};
use crate::answer::{
    JunctionKind, Remark, RemarkCode, YinEdgeAnswer, YinInterfaceAnswer, YinJunctionAnswer,
    YinNeighborAnswer, YinPhaseAnswer,
};
use coface_algebra::{EdgeId, Error, Sign, VertexId};
use coface_geometry::Sum;
use coface_io::yin::{BoundaryCurve, BoundaryDrawing, Filling};
use coface_yin::{DirectedEdge, InterfaceGraph, InterfaceOptions, Order, Overlaps, YinSet};
use std::collections::BTreeMap;

/// The part of the largest extent that lengths are known to.
const PRECISION: f64 = 1e-13;

/// A set with the name of the phase that it becomes.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct NamedSet {
    /// The name.
    pub name: String,
    /// The set.
    pub set: PlanarSet,
}

impl NamedSet {
    /// A set with a name.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{NamedSet, PlanarSet};
    /// use coface_yin::{Order, YinSet};
    /// let nothing = PlanarSet::from_set(YinSet::empty(Order::LINEAR));
    /// assert_eq!(NamedSet::new("nothing", nothing).name, "nothing");
    /// ```
    pub fn new(name: impl Into<String>, set: PlanarSet) -> Self {
        Self { name: name.into(), set }
    }

    /// The features of a drawing, each a set: polygons with one name are one set, and those without a name are each one, named by
    /// the file and their number. `None` for curves with the set on their left, which are the boundary of one set.
    ///
    /// # Errors
    /// Those of [`PlanarSet::of`], with the name of the feature.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{NamedSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = b"MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)), ((2 0, 4 0, 4 2, 2 0)))";
    /// let drawing = read_boundary(&text[..], Format::Wkt, &ReadOptions::default())?;
    /// let sets = NamedSet::of_features("two.wkt", &drawing, &SetRequest::default())?.expect("polygons are features");
    /// assert_eq!(sets.iter().map(|one| one.set.set().area()).collect::<Vec<_>>(), [Some(0.5), Some(2.0)]);
    /// # Ok(()) }
    /// ```
    pub fn of_features(
        file: &str,
        drawing: &BoundaryDrawing,
        request: &SetRequest,
    ) -> Result<Option<Vec<Self>>, Error> {
        let groups = drawing.groups();
        if groups.is_empty() || groups.iter().any(|(filling, _)| *filling == Filling::Left) {
            return Ok(None);
        }
        let mut parts: Vec<(String, BoundaryDrawing)> = Vec::new();
        let mut of_name: BTreeMap<String, usize> = BTreeMap::new();
        for (number, (filling, range)) in groups.iter().enumerate() {
            let curves = &drawing.curves()[range.clone()];
            let named = curves.first().and_then(BoundaryCurve::name).filter(|name| !name.is_empty());
            let name = named.map_or_else(|| format!("{file}#{number}"), str::to_owned);
            let at = *of_name.entry(name.clone()).or_insert(parts.len());
            if at == parts.len() {
                parts.push((name, BoundaryDrawing::new(drawing.order())));
            }
            parts[at].1.push(*filling, curves.to_vec());
        }
        let set = |(name, own): (String, BoundaryDrawing)| match PlanarSet::of(&own, request) {
            Ok(set) => Ok(Self { name, set }),
            Err(error) => {
                let said = Error::new(error.kind(), format!("in \"{name}\": {}", error.message()));
                Err(match error.cure() {
                    Some(cure) => said.with_cure(cure),
                    None => said,
                })
            }
        };
        let mut sets = parts.into_iter().map(set).collect::<Result<Vec<_>, _>>()?;
        // What is said of the whole file is said once.
        if let Some(first) = sets.first_mut() {
            first.set.remarks.splice(0..0, drawing.remarks().iter().cloned());
        }
        Ok(Some(sets))
    }
}

/// Sets of the plane as phases that share the arcs between them.
///
/// # Examples
/// Two unit squares side by side.
/// ```
/// use coface_answers::{NamedSet, PlanarInterface, SetRequest};
/// use coface_io::{Format, ReadOptions, read_boundary};
/// use coface_yin::{InterfaceOptions, Order, Overlaps};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = b"MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((1 0, 2 0, 2 1, 1 1, 1 0)))";
/// let drawing = read_boundary(&text[..], Format::Wkt, &ReadOptions::default())?;
/// let sets = NamedSet::of_features("two.wkt", &drawing, &SetRequest::default())?.expect("polygons are features");
/// let found = PlanarInterface::of(sets, &InterfaceOptions::new(Order::LINEAR), Overlaps::Refused)?;
/// let found = found.answer(&["two.wkt".into()], false)?;
/// assert_eq!((found.junctions.len(), found.length), (2, Some(7.0)));
/// assert_eq!((found.phases[0].neighbors[1].phase, found.phases[0].neighbors[1].length), (Some(1), Some(1.0)));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct PlanarInterface {
    pub(super) graph: InterfaceGraph,
    pub(super) names: Vec<String>,
    /// The set that covers the plane alone, where one does.
    pub(super) plane: Option<u32>,
    pub(super) remarks: Vec<Remark>,
}

impl PlanarInterface {
    /// The interface of sets, set i as phase i.
    ///
    /// # Errors
    /// Those of [`InterfaceGraph::of_sets_with`]: sets that overlap, unless the options say which of them their common points go to.
    ///
    /// # Complexity
    /// That of an overlay of all boundaries.
    ///
    /// # Examples
    /// See [`PlanarInterface`].
    pub fn of(sets: Vec<NamedSet>, options: &InterfaceOptions, overlaps: Overlaps) -> Result<Self, Error> {
        let (mut names, mut own, mut remarks) = (Vec::new(), Vec::new(), Vec::new());
        for one in sets {
            names.push(one.name);
            for remark in &one.set.remarks {
                if !remarks.contains(remark) {
                    remarks.push(remark.clone());
                }
            }
            own.push(one.set.set);
        }
        let graph = InterfaceGraph::of_sets_with(&own, &options.overlaps(overlaps))?;
        let is_plane = |(_, set): &(usize, &YinSet)| set.is_plane();
        let plane = match (graph.edge_count(), overlaps) {
            (0, Overlaps::ToTheLast) => own.iter().enumerate().rfind(is_plane),
            (0, _) => own.iter().enumerate().find(is_plane),
            _ => None,
        };
        let plane = plane.map(|(number, _)| number as u32);
        let found = Self { graph, names, plane, remarks };
        let lost: Vec<usize> = (0..own.len())
            .filter(|&phase| {
                let was_empty = own[phase].curve_count() == 0 && !own[phase].is_plane();
                !was_empty && !found.has(phase as u32)
            })
            .collect();
        let mut found = found;
        if let Some(&first) = lost.first() {
            let message = format!(
                "{} in others, and no phase is left of {}; the first is \"{}\"",
                if lost.len() == 1 { "1 set lies".to_owned() } else { format!("{} sets lie", lost.len()) },
                if lost.len() == 1 { "it" } else { "them" },
                found.names[first]
            );
            found.remarks.push(Remark::new(RemarkCode::EmptyInput, message).at(lost.len(), []));
        }
        Ok(found)
    }

    /// Whether anything is left of a phase.
    fn has(&self, phase: u32) -> bool {
        self.plane == Some(phase) || self.graph.phases().binary_search(&phase).is_ok()
    }

    /// The arcs between the phases.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::PlanarInterface;
    /// use coface_yin::{InterfaceOptions, Order, Overlaps};
    /// let nothing = PlanarInterface::of(Vec::new(), &InterfaceOptions::new(Order::LINEAR), Overlaps::Refused)?;
    /// assert_eq!(nothing.graph().edge_count(), 0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn graph(&self) -> &InterfaceGraph {
        &self.graph
    }

    /// What was assumed or left out.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::PlanarInterface;
    /// use coface_yin::{InterfaceOptions, Order, Overlaps};
    /// let nothing = PlanarInterface::of(Vec::new(), &InterfaceOptions::new(Order::LINEAR), Overlaps::Refused)?;
    /// assert!(nothing.remarks().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// The phases as sets, in their order; empty where nothing is left of one. The boundaries of neighbors have the same pieces.
    ///
    /// # Errors
    /// Those of [`InterfaceGraph::phase_set`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{NamedSet, PlanarInterface, PlanarSet};
    /// use coface_yin::{InterfaceOptions, Order, Overlaps, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = NamedSet::new("all", PlanarSet::from_set(YinSet::plane(Order::LINEAR)));
    /// let found = PlanarInterface::of(vec![plane], &InterfaceOptions::new(Order::LINEAR), Overlaps::Refused)?;
    /// assert!(found.phases()?[0].set().is_plane());
    /// # Ok(()) }
    /// ```
    pub fn phases(&self) -> Result<Vec<PlanarSet>, Error> {
        (0..self.names.len() as u32).map(|phase| self.phase_set(phase)).collect()
    }

    /// A phase as a set.
    pub(super) fn phase_set(&self, phase: u32) -> Result<PlanarSet, Error> {
        let order = self.graph.order();
        let set = match self.has(phase) {
            true if self.plane == Some(phase) => YinSet::plane(order),
            true => self.graph.phase_set(phase)?,
            false => YinSet::empty(order),
        };
        Ok(PlanarSet::from_set(set))
    }

    /// The interface as an answer; `files` are the names of the inputs. With `has_curves` edges have their knots and control points.
    ///
    /// # Errors
    /// Those of [`Self::phases`].
    ///
    /// # Examples
    /// See [`PlanarInterface`].
    pub fn answer(&self, files: &[String], has_curves: bool) -> Result<YinInterfaceAnswer, Error> {
        let graph = &self.graph;
        let tolerance = self.tolerance();
        let ids = || (0..graph.edge_count()).map(EdgeId::new);
        let lengths: Vec<f64> = ids().map(|edge| graph.curve(edge).length(tolerance)).collect();
        let edges: Vec<YinEdgeAnswer> = ids()
            .map(|edge| {
                let curve = graph.curve(edge);
                let [left, right] = graph.phases_of(edge);
                YinEdgeAnswer {
                    ends: graph.ends(edge).map(VertexId::to_u32),
                    left,
                    right,
                    length: finite(lengths[edge.index()]),
                    pieces: curve.piece_count(),
                    knots: has_curves.then(|| curve.knots().to_vec()),
                    controls: has_curves.then(|| curve.controls().to_vec()),
                }
            })
            .collect();
        let phases = (0u32..).zip(self.phases()?).map(|(phase, set)| {
            let set = set.set;
            let [components, holes] = set.betti_open()?;
            // For each other phase the number of common edges, and their length.
            let mut others: BTreeMap<Option<u32>, (usize, Sum)> = BTreeMap::new();
            let mut perimeter = Sum::default();
            for (edge, length) in edges.iter().zip(&lengths) {
                let other = match [edge.left, edge.right] {
                    [Some(left), right] if left == phase => right,
                    [left, Some(right)] if right == phase => left,
                    _ => continue,
                };
                let own = others.entry(other).or_default();
                own.0 += 1;
                own.1.add(*length);
                perimeter.add(*length);
            }
            let neighbor = |(phase, (edges, length)): (Option<u32>, (usize, Sum))| YinNeighborAnswer {
                phase,
                edges,
                length: finite(length.value()),
            };
            Ok(YinPhaseAnswer {
                name: self.names[phase as usize].clone(),
                area: set.area(),
                perimeter: finite(perimeter.value()),
                components,
                holes,
                neighbors: others.into_iter().map(neighbor).collect(),
            })
        });
        let mut all = Sum::default();
        lengths.iter().for_each(|length| all.add(*length));
        Ok(YinInterfaceAnswer {
            files: files.to_vec(),
            order: graph.order().value() as u32,
            phases: phases.collect::<Result<_, Error>>()?,
            vertices: graph.vertices().to_vec(),
            edges,
            junctions: self.junctions(),
            smooth_pairs: has_curves.then(|| {
                let signed =
                    |own: DirectedEdge| (own.edge.to_u32(), if own.sign == Sign::Plus { 1 } else { -1 });
                graph.smooth_pairs().iter().map(|pair| pair.map(signed)).collect()
            }),
            length: finite(all.value()),
            remarks: self.remarks.clone(),
        })
    }

    fn junctions(&self) -> Vec<YinJunctionAnswer> {
        let graph = &self.graph;
        let mut smooth = vec![0usize; graph.vertices().len()];
        for [from, _] in graph.smooth_pairs() {
            let [start, end] = graph.ends(from.edge);
            smooth[if from.sign == Sign::Plus { end } else { start }.index()] += 1;
        }
        let junction = |vertex: VertexId| {
            let leaving = graph.edges_at(vertex);
            let left = |edge: &DirectedEdge| {
                let [left, right] = graph.phases_of(edge.edge);
                if edge.sign == Sign::Plus { left } else { right }
            };
            let smooth_pairs = smooth[vertex.index()];
            YinJunctionAnswer {
                vertex: vertex.to_u32(),
                point: graph.vertices()[vertex.index()],
                degree: leaving.len(),
                smooth_pairs,
                kind: JunctionKind::new(leaving.len(), smooth_pairs),
                edges: leaving.iter().map(|edge| edge.edge.to_u32()).collect(),
                phases: leaving.iter().map(left).collect(),
            }
        };
        graph.junctions().map(junction).collect()
    }

    fn tolerance(&self) -> f64 {
        let boxes =
            (0..self.graph.edge_count()).map(|edge| self.graph.curve(EdgeId::new(edge)).bounding_box());
        let extent = boxes.map(|[low, high]| (high[0] - low[0]).max(high[1] - low[1])).fold(0.0, f64::max);
        (PRECISION * extent).max(f64::MIN_POSITIVE)
    }

    /// The order of edges that sets of these orders share: the highest of them.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::PlanarInterface;
    /// assert_eq!(PlanarInterface::order_for(&[]), coface_yin::Order::LINEAR);
    /// ```
    pub fn order_for(sets: &[NamedSet]) -> Order {
        sets.iter().map(|one| one.set.set.order()).max().unwrap_or(Order::LINEAR)
    }
}

/// A number, if it is one.
fn finite(number: f64) -> Option<f64> {
    Some(number).filter(|number| number.is_finite())
}
