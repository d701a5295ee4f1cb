//! Interfaces from what `coface yin interface -o` writes.

use super::{NamedSet, PlanarInterface};
use crate::answer::YinInterfaceAnswer;
use coface_algebra::{EdgeId, Error, ErrorKind};
use coface_yin::{Curve, DirectedEdge, InterfaceGraph, Order};

impl YinInterfaceAnswer {
    /// The interface in the text of a file, if it is one; what is wrong with it where it cannot be read.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::YinInterfaceAnswer;
    /// assert!(YinInterfaceAnswer::of_json(b"{\"curves\": []}").is_none());
    /// assert!(YinInterfaceAnswer::of_json(b"{\"phases\": [], \"junctions\": []}").is_some_and(|found| found.is_err()));
    /// ```
    pub fn of_json(text: &[u8]) -> Option<Result<Self, Error>> {
        // Few files have these words, and those are read as a whole.
        let has = |word: &[u8]| text.windows(word.len()).any(|part| part == word);
        let is_one = has(b"\"phases\"") && has(b"\"junctions\"");
        is_one.then(|| {
            serde_json::from_slice(text).map_err(|error| {
                Error::new(ErrorKind::Parse, format!("the interface cannot be read: {error}"))
                    .with_cure("give the file that coface yin interface -o FILE.json writes")
            })
        })
    }
}

impl PlanarInterface {
    /// The interface that an answer with the control points of its edges tells.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for edges without control points, those of
    /// [`InterfaceGraph::from_curves`], and edges that meet otherwise than at their ends.
    ///
    /// # Complexity
    /// That of an overlay of all edges.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{LabelImage, PlanarInterface};
    /// use coface_yin::{InterfaceOptions, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(2, vec![1, 2, 3, 3])?.sets()?;
    /// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
    /// let interface = PlanarInterface::of(sets, &options, Overlaps::Refused)?;
    /// let again = PlanarInterface::of_answer(&interface.answer(&[], true)?)?;
    /// assert_eq!(again.graph().phase_area(2)?, 2.0);
    /// # Ok(()) }
    /// ```
    pub fn of_answer(answer: &YinInterfaceAnswer) -> Result<Self, Error> {
        let found = Self::unchecked(answer)?;
        if let Some(fault) = found.graph.fault()? {
            return Err(Error::invalid(format!("the interface is none: {}", found.fault_words(&fault)))
                .with_cure(
                    "repair it with coface yin normalize, or give edges that meet at their ends only",
                ));
        }
        Ok(found)
    }

    /// The same for edges that may meet elsewhere than at their ends, to be repaired by [`Self::normalized`].
    ///
    /// # Errors
    /// Those of [`Self::of_answer`], but for edges that meet.
    ///
    /// # Examples
    /// See [`Self::of_answer`].
    pub fn unchecked(answer: &YinInterfaceAnswer) -> Result<Self, Error> {
        let graph = Self::graph_of(answer)?;
        let names: Vec<String> = answer.phases.iter().map(|phase| phase.name.clone()).collect();
        let is_plane =
            |phase: usize| answer.phases[phase].area.is_none() && answer.phases[phase].components > 0;
        let plane = match graph.edge_count() {
            0 => (0..names.len()).find(|&phase| is_plane(phase)).map(|phase| phase as u32),
            _ => None,
        };
        Ok(Self { graph, names, plane, remarks: Vec::new() })
    }

    /// The graph that an answer tells, whether its edges meet elsewhere or not.
    pub(super) fn graph_of(answer: &YinInterfaceAnswer) -> Result<InterfaceGraph, Error> {
        let order = Order::new(answer.order as usize)?;
        let none = || {
            Error::invalid("the edges have no control points".to_owned())
                .with_cure("give the file that coface yin interface -o FILE.json writes")
        };
        let (mut ends, mut phases, mut curves) = (Vec::new(), Vec::new(), Vec::new());
        for (number, edge) in answer.edges.iter().enumerate() {
            let controls = edge.controls.clone().ok_or_else(none)?;
            let knots = edge.knots.clone().ok_or_else(none)?;
            let curve = Curve::from_controls(order, controls, knots);
            curves.push(
                curve.map_err(|error| {
                    Error::new(error.kind(), format!("edge {number}: {}", error.message()))
                })?,
            );
            ends.push(edge.ends);
            phases.push([edge.left, edge.right]);
            if let Some(phase) = [edge.left, edge.right]
                .into_iter()
                .flatten()
                .find(|&phase| phase as usize >= answer.phases.len())
            {
                return Err(Error::invalid(format!(
                    "edge {number} bounds phase {phase}, which there is not"
                ))
                .with_cure(format!("give phases below {}", answer.phases.len())));
            }
        }
        let directed = |(edge, sign): (u32, i8)| match sign {
            1 => Ok(DirectedEdge::along(EdgeId::new(edge as usize))),
            -1 => Ok(DirectedEdge::against(EdgeId::new(edge as usize))),
            _ => Err(Error::invalid(format!("the direction of edge {edge} in a smooth pair is {sign}"))
                .with_cure("give 1 or -1")),
        };
        let pairs = answer.smooth_pairs.as_deref().unwrap_or_default().iter();
        let pairs = pairs
            .map(|&[from, to]| Ok([directed(from)?, directed(to)?]))
            .collect::<Result<Vec<_>, Error>>()?;
        InterfaceGraph::from_curves(&answer.vertices, &ends, &phases, curves, &pairs, order)
    }

    /// The phases as sets with their names, in their order.
    ///
    /// # Errors
    /// Those of [`Self::phases`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{LabelImage, PlanarInterface};
    /// use coface_yin::{InterfaceOptions, Overlaps};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sets = LabelImage::new(2, vec![1, 2])?.sets()?;
    /// let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
    /// let interface = PlanarInterface::of(sets, &options, Overlaps::Refused)?;
    /// assert_eq!(interface.named_phases()?[1].name, "2");
    /// # Ok(()) }
    /// ```
    pub fn named_phases(&self) -> Result<Vec<NamedSet>, Error> {
        let sets = self.phases()?;
        Ok(self.names.iter().zip(sets).map(|(name, set)| NamedSet::new(name.clone(), set)).collect())
    }
}
