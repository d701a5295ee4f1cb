//! Interfaces in unique form, fitted, with other kinks, and cut at the lines of a grid.

use super::cells::listed;
use super::{CutCellsRequest, KinkRequest, PlanarInterface};
use crate::answer::{
    InterfaceKink, PhaseCell, PhaseCells, YinInterfaceCutCellsAnswer, YinInterfaceKinksAnswer,
    YinInterfaceNormalizeAnswer,
};
use coface_algebra::{EdgeId, Error, Sign, VertexId};
use coface_arrange::boolean::InsideRule;
use coface_geometry::Sum;
use coface_yin::{CartesianGrid, Coverage, CutCells, InterfaceGraph, KnotIndex, Order};
use std::collections::BTreeMap;

/// Kinks of an interface that come and go: names and places are those of before.
///
/// # Examples
/// ```
/// let request = coface_answers::InterfaceKinksRequest::default();
/// assert!(request.reset.is_none() && request.inserted.is_empty());
/// ```
#[derive(Clone, Debug, Default)]
pub struct InterfaceKinksRequest {
    /// The only kinks, before others come and go.
    pub reset: Option<KinkRequest>,
    /// Knots that become kinks, with the number of an edge for the curve.
    pub inserted: Vec<KnotIndex>,
    /// Points near which a knot becomes a kink.
    pub inserted_near: Vec<[f64; 2]>,
    /// Vertices that are no kinks any more.
    pub erased: Vec<u32>,
    /// Points near which a kink goes.
    pub erased_near: Vec<[f64; 2]>,
}

impl PlanarInterface {
    /// The interface with another graph, of the same phases.
    fn with_graph(&self, graph: InterfaceGraph) -> Self {
        Self { graph, names: self.names.clone(), plane: self.plane, remarks: self.remarks.clone() }
    }

    /// The interface in its unique form: see [`InterfaceGraph::normalized`].
    ///
    /// # Errors
    /// Those of [`InterfaceGraph::normalized`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{LabelImage, PlanarInterface};
    /// use coface_arrange::boolean::InsideRule;
    /// use coface_yin::{InterfaceOptions, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(2, vec![1, 2, 3, 3])?.sets()?;
    /// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
    /// let interface = PlanarInterface::of(sets, &options, Overlaps::Refused)?;
    /// let (unique, answer) = interface.normalized(&["labels".into()], InsideRule::Nonzero)?;
    /// assert_eq!((answer.repaired, answer.interface.junctions.len()), (None, 4));
    /// assert_eq!(unique.graph().phases_of(coface_algebra::EdgeId::new(0))[0], Some(0));
    /// # Ok(()) }
    /// ```
    pub fn normalized(
        &self,
        files: &[String],
        rule: InsideRule,
    ) -> Result<(Self, YinInterfaceNormalizeAnswer), Error> {
        let found = self.graph.normalized(rule)?;
        let (joined, straightened) = (found.joined_count(), found.straightened_count());
        let repaired = found.fault().map(|fault| self.fault_words(fault));
        let unique = self.with_graph(found.into_graph());
        let interface = unique.answer(files, false)?;
        Ok((unique, YinInterfaceNormalizeAnswer { repaired, joined, straightened, interface }))
    }

    /// Splines through the knots of the edges, smooth but for junctions and kinks: the kinks that are asked for, or those that there are. Without an
    /// order it is that of the edges, and 4 at least.
    ///
    /// # Errors
    /// Those of [`InterfaceGraph::fitted`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{KinkRequest, LabelImage, PlanarInterface};
    /// use coface_yin::{InterfaceOptions, Order, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(2, vec![1, 2])?.sets()?;
    /// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
    /// let interface = PlanarInterface::of(sets, &options, Overlaps::Refused)?;
    /// let [round, straight] = [KinkRequest::None, KinkRequest::All].map(|kinks| interface.fitted(None, Some(&kinks)));
    /// let (round, straight) = (round?, straight?);
    /// assert_eq!((round.graph().order(), straight.graph().phase_area(1)?), (Order::CUBIC, 1.0));
    /// assert!(round.graph().phase_area(1)? > 1.1);
    /// # Ok(()) }
    /// ```
    pub fn fitted(&self, order: Option<Order>, kinks: Option<&KinkRequest>) -> Result<Self, Error> {
        let order = order.unwrap_or_else(|| self.graph.order().max(Order::CUBIC));
        let knots = kinks.map(|request| self.knots_of(request)).transpose()?;
        Ok(self.with_graph(self.graph.fitted(order, knots.as_deref())?))
    }

    /// The interface with kinks reset, erased and inserted; the splines beside them are fitted again.
    ///
    /// # Errors
    /// Those of [`InterfaceGraph::with_kinks_changed`], and for points near which there is none; the interface stays as it was.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{InterfaceKinksRequest, LabelImage, PlanarInterface};
    /// use coface_yin::{InterfaceOptions, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(2, vec![1, 2])?.sets()?;
    /// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
    /// let interface = PlanarInterface::of(sets, &options, Overlaps::Refused)?;
    /// let request = InterfaceKinksRequest { inserted_near: vec![[0.0, 0.0]], ..InterfaceKinksRequest::default() };
    /// let kinks = interface.with_kinks(&request)?.kinks_answer(&[])?.kink_points;
    /// assert_eq!((kinks.len(), kinks[0].point, kinks[0].phases), (1, [0.0, 0.0], [Some(0), None]));
    /// # Ok(()) }
    /// ```
    pub fn with_kinks(&self, request: &InterfaceKinksRequest) -> Result<Self, Error> {
        let mut graph = match &request.reset {
            Some(kinks) => self.graph.with_kinks(&self.knots_of(kinks)?)?,
            None => self.graph.clone(),
        };
        let mut inserted = request.inserted.clone();
        for &point in &request.inserted_near {
            let found = graph.nearest_knot(point)?;
            inserted.push(found.ok_or_else(|| {
                Error::invalid("the interface has no knots but junctions")
                    .with_cure("insert kinks at knots of edges")
            })?);
        }
        let mut erased: Vec<VertexId> =
            request.erased.iter().map(|&vertex| VertexId::from_u32(vertex)).collect();
        for &point in &request.erased_near {
            let found = graph.nearest_kink(point)?;
            erased.push(found.ok_or_else(|| {
                Error::invalid("the interface has no kinks").with_cure("erase kinks that are there")
            })?);
        }
        if !(inserted.is_empty() && erased.is_empty()) {
            graph = graph.with_kinks_changed(&erased, &inserted)?;
        }
        Ok(self.with_graph(graph))
    }

    /// The kinks, and the interface as an answer.
    ///
    /// # Errors
    /// Those of [`Self::answer`].
    ///
    /// # Examples
    /// See [`Self::with_kinks`].
    pub fn kinks_answer(&self, files: &[String]) -> Result<YinInterfaceKinksAnswer, Error> {
        Ok(YinInterfaceKinksAnswer { kink_points: self.kink_points(), interface: self.answer(files, false)? })
    }

    /// The kinks with their places.
    ///
    /// # Examples
    /// See [`Self::with_kinks`].
    pub fn kink_points(&self) -> Vec<InterfaceKink> {
        let kink = |vertex: VertexId| {
            let leaving = self.graph.edges_at(vertex)[0];
            let count = self.graph.curve(leaving.edge).piece_count() as u32;
            InterfaceKink {
                vertex: vertex.to_u32(),
                edge: leaving.edge.to_u32(),
                knot: if leaving.sign == Sign::Plus { 0 } else { count },
                point: self.graph.vertices()[vertex.index()],
                phases: self.graph.phases_of(leaving.edge),
            }
        };
        self.graph.kinks().into_iter().map(kink).collect()
    }

    /// The knots that a request names, with edges for curves; vertices with two edges are named once.
    fn knots_of(&self, request: &KinkRequest) -> Result<Vec<KnotIndex>, Error> {
        match request {
            KinkRequest::None => Ok(Vec::new()),
            KinkRequest::Detected(angle) => self.graph.detected_kinks(*angle),
            KinkRequest::Listed(knots) => Ok(knots.clone()),
            KinkRequest::All => {
                let graph = &self.graph;
                let mut all = Vec::new();
                for edge in 0..graph.edge_count() {
                    let count = graph.curve(EdgeId::new(edge)).piece_count() as u32;
                    all.extend((1..count).map(|knot| KnotIndex { curve: edge as u32, knot }));
                }
                for vertex in (0..graph.vertices().len()).map(VertexId::new) {
                    if let [leaving, _] = graph.edges_at(vertex) {
                        let count = graph.curve(leaving.edge).piece_count() as u32;
                        let knot = if leaving.sign == Sign::Plus { 0 } else { count };
                        all.push(KnotIndex { curve: leaving.edge.to_u32(), knot });
                    }
                }
                Ok(all)
            }
        }
    }

    /// Cuts the phases at the lines of one grid, by default over the box around all edges. Phases have the same curves where they meet, so what they have
    /// of a cell adds up.
    ///
    /// # Errors
    /// Those of [`Self::phases`], [`CartesianGrid::new`] and [`CutCells::new`].
    ///
    /// # Complexity
    /// That of [`CutCells::new`] for each phase.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{CutCellsRequest, LabelImage, PlanarInterface};
    /// use coface_yin::{InterfaceOptions, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(3, vec![1, 2, 2])?.sets()?;
    /// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
    /// let interface = PlanarInterface::of(sets, &options, Overlaps::Refused)?;
    /// let answer = interface.cut_cells("labels", &CutCellsRequest::new([2, 1]))?;
    /// assert_eq!((answer.area, answer.phases[0].area, answer.phases[1].full), (3.0, 1.0, 1));
    /// # Ok(()) }
    /// ```
    pub fn cut_cells(
        &self,
        file: &str,
        request: &CutCellsRequest,
    ) -> Result<YinInterfaceCutCellsAnswer, Error> {
        let grid = request.over(self.bounding_box());
        let cartesian = || CartesianGrid::new(grid.origin, grid.spacing, grid.counts);
        let (mut phases, mut all) = (Vec::new(), Vec::new());
        let mut area = Sum::default();
        // Of each edge what is in the grid, as the phases on its sides have it: along lines of the grid only one of them does.
        let mut lengths = vec![0.0f64; self.graph.edge_count()];
        for (number, (name, set)) in (0u32..).zip(self.names.iter().zip(self.phases()?)) {
            let cells = CutCells::new(set.set(), cartesian()?).map_err(|error| error.in_file(file))?;
            area.add(cells.total_area());
            for (edge, length) in self.edge_lengths(number, &cells) {
                lengths[edge] = lengths[edge].max(length);
            }
            all.extend(listed(&cells, grid.counts).into_iter().map(|cell| PhaseCell {
                column: cell.column,
                row: cell.row,
                phase: number,
                coverage: cell.coverage,
                area: cell.area,
                length: cell.length,
            }));
            phases.push(PhaseCells {
                name: name.clone(),
                full: cells.count(Coverage::Full),
                cut: cells.count(Coverage::Cut),
                empty: cells.count(Coverage::Empty),
                area: cells.total_area(),
                length: cells.total_length(),
                area_of_phase: set.set().area(),
            });
        }
        let mut length = Sum::default();
        lengths.iter().for_each(|own| length.add(*own));
        all.sort_by_key(|cell| (cell.row, cell.column, cell.phase));
        Ok(YinInterfaceCutCellsAnswer {
            file: file.to_owned(),
            grid,
            area: area.value(),
            length: length.value(),
            phases,
            cells: Some(all),
            remarks: self.remarks.clone(),
        })
    }

    /// What of the edges around a phase is in the grid of its cells.
    fn edge_lengths(&self, phase: u32, cells: &CutCells<'_>) -> Vec<(usize, f64)> {
        // For each curve the edges that it runs along, and the first piece behind each.
        let walks: Vec<Vec<(usize, EdgeId)>> = (self.graph.phase_walks(phase).into_iter())
            .map(|walk| {
                let mut behind = 0;
                let edges = walk.into_iter().map(|own| {
                    behind += self.graph.curve(own.edge).piece_count();
                    (behind, own.edge)
                });
                edges.collect()
            })
            .collect();
        let mut sums: BTreeMap<usize, Sum> = BTreeMap::new();
        for (curve, piece, length) in cells.arc_lengths() {
            let walk = &walks[curve];
            let (_, edge) = walk[walk.partition_point(|&(behind, _)| behind <= piece)];
            sums.entry(edge.index()).or_default().add(length);
        }
        sums.into_iter().map(|(edge, sum)| (edge, sum.value())).collect()
    }

    /// The box around all edges; none without edges.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{LabelImage, PlanarInterface};
    /// use coface_yin::{InterfaceOptions, Order, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(3, vec![1, 2, 3])?.sets()?;
    /// let row = PlanarInterface::of(sets, &InterfaceOptions::new(Order::LINEAR), Overlaps::Refused)?;
    /// assert_eq!(row.bounding_box(), Some([[0.0, 0.0], [3.0, 1.0]]));
    /// # Ok(()) }
    /// ```
    pub fn bounding_box(&self) -> Option<[[f64; 2]; 2]> {
        let boxes =
            (0..self.graph.edge_count()).map(|edge| self.graph.curve(EdgeId::new(edge)).bounding_box());
        boxes.reduce(|[low, high], [least, most]| {
            [[0, 1].map(|axis| low[axis].min(least[axis])), [0, 1].map(|axis| high[axis].max(most[axis]))]
        })
    }
}
